// Ridge curves: the crest lines of a bead, with squared T-junctions (section 4.3 of the paper).
#pragma once

#include <vector>

#include "beadmesh/bead/skeleton.h"
#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/flatten/flat_face.h"

namespace beadmesh {

/// A place on the boundary of a region: arc length along the polyline of a loop.
struct BoundaryPosition {
  Index loop = 0;
  double position = 0;
};

struct RidgeNode {
  Vec2 point;                 ///< where the ridge curves meet or end
  Vec2 medial_point;          ///< the equidistant point before squaring or extension to the tip
  double radius = 0;          ///< of the inscribed circle at medial_point
  bool squared = false;       ///< moved by T-junction squaring: no longer equidistant
  bool tip = false;           ///< an end: `point` lies on the boundary at `boundary`
  BoundaryPosition boundary;  ///< of a tip
  std::vector<Index> arms;    ///< as in SkeletonNode
};

struct RidgeArm {
  Index start = no_index, end = no_index;  ///< nodes; no_index: closed
  std::vector<Vec2> points;                ///< from start to end; closed: first point not repeated
};

/// Same nodes and arms as the skeleton it was made from.
struct RidgeGraph {
  std::vector<RidgeNode> nodes;
  std::vector<RidgeArm> arms;
};

struct RidgeOptions {
  double straight_angle = radians(165);  ///< default 165 degrees: condition 1 of T-junction squaring
};

/// Arms end at the tips on the boundary. Nodes of three arms are squared where both conditions of section 4.3
/// hold; other junctions move to the point where their arms, carried on straight from beyond the fillets,
/// meet best. The reach is the inscribed radius as in the paper, or further, until the thickness has settled.
/// Straight means straight in space, seen along the normal of the sheet around the junction; `map` null: the
/// flat plane is the surface.
RidgeGraph ridge_of(const Skeleton& skeleton, const PlanarRegion& region, const SurfaceMap* map = nullptr,
                    const RidgeOptions& options = {});

}  // namespace beadmesh
