// The medial object of a stadium, written down by hand: one S-S edge between the centres of the caps.
#pragma once

#include <cmath>

#include "beadmesh/medial/face_medial.h"

namespace beadmesh::test {

/// Straight sides of 40 mm, caps of radius 10 mm about (0, 0) and (40, 0); on the surface at z = 7.
inline FaceMedial stadium() {
  FaceMedial face;
  face.face = 3;
  PlanarLoop loop;
  for (int k = 0; k <= 16; ++k)
    loop.points.push_back({40 + 10 * std::sin(k * pi / 16), -10 * std::cos(k * pi / 16)});
  for (int k = 0; k <= 16; ++k)
    loop.points.push_back({-10 * std::sin(k * pi / 16), 10 * std::cos(k * pi / 16)});
  face.region.loops = {loop};
  const auto foot = [](double x, double y) { return Foot{{x, y}, 0, 0}; };
  const auto end = [&](double x, double outer) {
    MedialVertex vertex;
    vertex.type = MedialVertexType::S;
    vertex.point = {x, 0};
    vertex.radius = 10;
    vertex.touching_points = {foot(x, -10), foot(outer, 0), foot(x, 10)};
    vertex.contact_intervals = {{0, 1, 2}};
    vertex.edges = {0};
    return vertex;
  };
  face.object.vertices = {end(0, -10), end(40, 50)};
  MedialEdge edge;
  edge.type = MedialEdgeType::SS;
  edge.start = 0, edge.end = 1, edge.length = 40;
  edge.thickness = {20, 20, 20};
  for (const double x : {0.0, 20.0, 40.0})
    edge.points.push_back({{x, 0}, 10, {foot(x, 10), foot(x, -10)}, pi});
  face.object.edges = {edge};
  face.vertex_points = {{0, 0, 7}, {40, 0, 7}};
  face.edge_points = {{{0, 0, 7}, {20, 0, 7}, {40, 0, 7}}};
  return face;
}

}  // namespace beadmesh::test
