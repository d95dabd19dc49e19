// What die engineers ask of a bead: how deep for its width, how steep, how round, how near to what is around
// it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/bead/face_study.h"
#include "beadmesh/medial/medial_object.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// Limits of a bead; what is not set is not judged. Lengths in mm, angles in radians.
struct DesignLimits {
  std::optional<double> max_depth_to_width, max_wall_angle;
  std::optional<double> min_crown_radius, min_root_radius;
  std::optional<double> min_bead_distance, min_rim_distance, min_hole_distance;
};

/// Sections across the arms of one bead, each along a touching line of its medial axis; ends and junctions
/// are left out.
struct SectionMeasures {
  int sections = 0;           ///< measured; 0: the bead has no place to measure, and all below is empty
  double depth = 0;           ///< greatest height over the line between the roots
  double depth_to_width = 0;  ///< greatest, each by the width of its own section
  double wall_angle = 0;      ///< steepest, between the surface and the line between the roots; radians
  std::optional<double> crown_radius;  ///< smallest where the section is convex; none: it is straight
  std::optional<double> root_radius;   ///< smallest where it is concave; 0: a sharp root
};

SectionMeasures measure_sections(const FaceStudy& study, const MedialObject& medial);

/// From the boundary of a bead, straight through space.
struct BeadDistances {
  std::optional<double> bead;  ///< to the nearest other bead; 0 where they share a boundary
  Index nearest_bead = 0;      ///< its id
  std::optional<double> rim;   ///< to the outline of the panel
  std::optional<double> hole;  ///< to the nearest other free edge
};

/// Of each listed bead, in the order of the table. Of the free edges of a connected piece the longest closed
/// one is the rim, the others are holes.
std::vector<BeadDistances> bead_distances(const Panel& panel, const BeadTable& table);

struct BeadDesign {
  Index id = 0;
  SectionMeasures sections;
  BeadDistances distances;
  std::vector<std::string> exceeded;  ///< names of the measures past their limits, as "wall_angle"
};

/// Fills `exceeded`; a warning design.* for each.
std::vector<Diagnostic> judge_design(std::vector<BeadDesign>& beads, const DesignLimits& limits);

}  // namespace beadmesh
