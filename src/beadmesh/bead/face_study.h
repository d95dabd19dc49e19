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
  /// Per loop and segment: is it a side of a cut that opens the face. Empty where nothing is cut, and where
  /// study_faces does not look for it.
  std::vector<std::vector<bool>> cut_sides;

  /// Point of the exact surface over a flat point.
  Vec3 lift(Vec2 flat_point) const;
};

/// Joins, flattens and outlines the faces. Loop points where the boundary turns by more than `corner_angle`
/// (radians) are tagged as corners. Fails with flatten.*.
Result<std::unique_ptr<FaceStudy>> study_faces(const Panel& panel, const std::vector<Index>& faces,
                                               double corner_angle = radians(20));

/// One face, opened so that it can be laid flat (flatten/cut_open.h): a seam is closed where that can be
/// done, what closes around itself is cut. Where a cut meets the boundary is a corner. A plane face keeps the
/// exact curves of its edges (plane_curves.h). Fails with flatten.*.
Result<std::unique_ptr<FaceStudy>> study_opened_face(const Panel& panel, Index face,
                                                     double corner_angle = radians(20));

/// Length of the cuts on the surface, mm; each counts once although it has two sides.
double cut_length(const FaceStudy& study);

}  // namespace beadmesh
