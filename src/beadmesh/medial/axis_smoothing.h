// Cubic filter of a polyline (section 3.6).
#pragma once

#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// One pass in place, forward and then backward: every point but the ends is moved onto the cubic through its
/// two neighbours on either side, in coordinates along the line from the first to the last of them. Next to
/// an end the least norm cubic through the three neighbours. A closed polyline wraps around. Points whose
/// neighbours do not advance along that line are left alone.
void smooth_cubic(std::vector<Vec2>& points, bool closed);

}  // namespace beadmesh
