// Composite faces: a bead that CAD has split into many faces, as one.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/bead/recognition.h"
#include "beadmesh/core/context.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

struct CompositeOptions {
  BeadOptions bead = {};               ///< the rule that decides over a group
  double feature_angle = radians(25);  ///< default 25 degrees: a sharper edge ends smooth material
  double level_height = 0.2;           ///< default 0.2 of the feature's height: lower faces can be sheet
  double level_angle = radians(6);     ///< default 6 degrees: sheet leans no more against the continued sheet
  double min_height = 0.2;             ///< default 0.2 mm: what rises less is no feature
};

/// What became of faces that were looked at as a group.
enum class GroupVerdict {
  bead,      ///< one face, and a bead
  one_face,  ///< no bead, but one face for the mesh (plateau, emboss)
  sheet,     ///< sheet that construction lines have cut, one face again (joined_sheets.h)
  left       ///< they stay faces of their own
};

struct GroupDecision {
  std::vector<Index> faces;  ///< indices in the panel, ascending
  GroupVerdict verdict = GroupVerdict::left;
  std::string reason;  ///< in words, for a person
};

/// Every group that was looked at, as described below, and why it became what it is. In the order of their
/// faces.
std::vector<GroupDecision> group_decisions(const Panel& panel, const CompositeOptions& options = {},
                                           const Context& context = {});

/// Groups of faces (indices, ascending) that are one face to a person: what lies inside an inner loop of a
/// sheet face, joined to it and in itself by smooth edges, without the faces that are level with the sheet
/// continued below (islands in rings, windows of ladders), which are sheet again. From the outside inwards,
/// the largest faces first. Groups that are no beads (plateaus, embosses) are groups as well where they can
/// be laid flat and hold no bead of a single face, so that their inner edges are no constraints either.
std::vector<std::vector<Index>> composite_faces(const Panel& panel, const CompositeOptions& options = {},
                                                const Context& context = {});

}  // namespace beadmesh
