// What a bead is (section 4.1 of the paper) and the table row that users see.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

enum class BeadKind { I, generic, annular };

/// A crest line. `flat` in the flattened face, `points` on the surface, same length.
struct RidgeCurve {
  std::vector<Vec2> flat;
  std::vector<Vec3> points;
  bool closed = false;
};

struct Bead {
  Index id = 0;  ///< 1-based, in the order of the faces; 0 where it is not listed
  BeadKind kind = BeadKind::I;
  std::string shape;         ///< letter or word of the table in docs: I, arc, S, T, comb, ring, ...
  std::vector<Index> faces;  ///< indices in Panel::faces
  Vec3 point;                ///< on the crest
  int loops = 1;
  double length = 0;        ///< total length of the medial edges
  double width = 0;         ///< mean thickness along them, outside the junctions
  double height = 0;        ///< how far the crest rises over the boundary: what a tenth of the length exceeds
  double aspect_ratio = 0;  ///< mean over the medial edges of length / thickness
  int junctions = 0, ends = 0, medial_edges = 0;
  std::vector<RidgeCurve> ridge;
  double confidence = 1;  ///< of the face it was found on (panel/panel.h)
  bool listed = true;     ///< false: more loops than a bead may have; only meshed as one
};

std::string name_of(BeadKind kind);

}  // namespace beadmesh
