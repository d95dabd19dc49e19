// Where the crest of a bead comes down to the boundary at the end of an arm.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

struct CrestTip {
  size_t kept = 0;          ///< first point of the arm, counted from its end, that the crest still passes
  std::vector<Vec2> crest;  ///< from there outward, between that point and the tip
  Vec2 point;               ///< the tip on the boundary
  Index loop = 0;
  double position = 0;  ///< of the tip: arc length along the loop's polyline
};

/// The unrolled cap of a leaning bead is lopsided, and its medial axis bends. In space the middle of the
/// touching lines runs on straight, and the crest leans off it in proportion to its height: both are taken
/// from behind the cap, where the touching lines run across the arm, and carried on to the boundary. `arm`:
/// from its end inward, points on the crest, feet on the boundary; `radius`: of the inscribed circle at the
/// end. None where the arm is too short to tell.
std::optional<CrestTip> crest_tip(const std::vector<MedialPoint>& arm, double radius,
                                  const PlanarRegion& region, const SurfaceMap& map);

}  // namespace beadmesh
