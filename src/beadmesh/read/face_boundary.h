// Inside the read room: the loops of one face as closed polygons of nodes in its stretched parameters.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/read/cad_facets.h"

namespace beadmesh {

/// Fills points, uv and loops of `nodes` from the sampled edges; `stretch`: of u and v, to about mm; loops
/// are turned so that the face lies on their left. Returns the node polygon of each loop.
std::vector<std::vector<Index>> boundary_nodes(const CadTopology& topology, const CadFace& face, Vec2 stretch,
                                               FaceNodes& nodes);

/// A node beside the first place found where the polygons cross themselves or each other; touching is no
/// crossing.
std::optional<Vec3> find_crossing(const std::vector<std::vector<Index>>& polygons,
                                  const std::vector<Vec2>& stretched, const std::vector<Vec3>& points);

/// The Diagnostic for it; `number` is that of the face.
Diagnostic crossing_defect(Vec3 where, Index number);

/// Answers whether a point is inside closed polygons, in about the time of one short list.
class InsideTest {
 public:
  InsideTest(const std::vector<std::vector<Index>>& polygons, const std::vector<Vec2>& points);
  bool operator()(Vec2 p) const;

 private:
  struct Segment {
    Vec2 a, b;
  };
  double low_ = 0, step_ = 1;
  std::vector<std::vector<Segment>> rows_;
};

}  // namespace beadmesh
