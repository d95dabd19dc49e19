// Everything the stages after flattening need to know of one face, kept together.
#pragma once

#include <memory>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/medial/medial_object.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// A face laid flat. Not movable, since the map refers to its neighbours: held by pointer.
struct FaceStudy {
  std::vector<Index> faces;  ///< indices in Panel::faces; several for a composite face
  Facets facets;
  FlatFace flat;
  std::unique_ptr<SurfaceMap> map;
  PlanarRegion region;  ///< loop l, segment i runs from facets.loops[l][i] to [i + 1]
  std::vector<std::vector<double>>
      joint_angles;  ///< per loop and point: turn of the boundary there, radians; 0 inside edges

  /// Point of the exact surface over a flat point.
  Vec3 lift(Vec2 flat_point) const;
};

/// Joins, flattens and outlines the faces. Loop points where the boundary turns by more than `corner_angle`
/// (radians) are tagged as corners. Fails with flatten.*.
Result<std::unique_ptr<FaceStudy>> study_faces(const Panel& panel, const std::vector<Index>& faces,
                                               double corner_angle = radians(20));

}  // namespace beadmesh
