// Private to this room: from where a flat picture of a panel is seen.
#pragma once

#include "beadmesh/core/vector.h"

namespace beadmesh::drawing {

/// Two axes of the picture and the direction to the eye, orthonormal.
struct PictureView {
  Vec3 right, up, eye;
  Vec2 operator()(Vec3 p) const { return {dot(p, right), dot(p, up)}; }
};

/// With the eye in that direction; x to the right where it can be.
PictureView view_along(Vec3 eye);

/// Along the mean normal, from the side of its positive axis, as a drawing shows it. `sum` is the vector area
/// and `area` the area of what is seen; from above where that closes around itself.
PictureView view_of_area(Vec3 sum, double area);

}  // namespace beadmesh::drawing
