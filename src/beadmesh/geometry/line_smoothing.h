// A closed line through points that are not quite where they should be.
#pragma once

#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

struct LineSmoothingOptions {
  double wavelength = 4;  ///< default 4 mm: waves of this length keep half of their height, shorter ones less
  double least_noise = 0.01;  ///< default 0.01 mm: what is nearer to the line is no outlier
  int rounds = 8;             ///< default 8: of weighing anew
};

/// Points about equally far (`step`, mm) from each other along a closed line -> as many points of a smooth
/// line beside them. Least squares with a price on second differences; points that lie off the line weigh
/// less (Geman and McClure 1985, re-weighted), so that a few teeth do not draw it. At `corners` (per point)
/// it may bend as it likes, and goes through the point.
std::vector<Vec3> smoothed_line(const std::vector<Vec3>& points, double step,
                                const std::vector<bool>& corners, const LineSmoothingOptions& options = {});

}  // namespace beadmesh
