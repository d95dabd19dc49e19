#include "beadmesh/medial/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beadmesh {

Tolerances tolerances_of(const PlanarRegion& region) {
  const double size = diagonal(region);
  double greatest = 0;
  for (const PlanarLoop& loop : region.loops)
    for (const Vec2 p : loop.points) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y)});
  Tolerances tolerances;
  tolerances.rounding = std::max(1e-12 * size, 16 * std::numeric_limits<double>::epsilon() * greatest);
  tolerances.contact = std::max(1e-9 * size, 16 * tolerances.rounding);
  tolerances.chord = 0.5e-7 * size;
  tolerances.segment = 1e-5 * size;
  tolerances.leg = 1e-10 * size;
  return tolerances;
}

}  // namespace beadmesh
