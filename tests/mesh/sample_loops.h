// Node loops of simple faces for the tests of the subdivision mesher.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh::test {

/// Adds points as a new loop, and returns it.
inline std::vector<Index> add_loop(NodeLoops& loops, const std::vector<Vec2>& points) {
  std::vector<Index> loop;
  for (const Vec2& point : points) {
    loop.push_back(static_cast<Index>(loops.nodes.size()));
    loops.nodes.push_back(point);
  }
  loops.loops.push_back(loop);
  return loop;
}

/// Points of a closed polygon with `counts[i]` edges on its side i.
inline std::vector<Vec2> polygon(const std::vector<Vec2>& corners, const std::vector<int>& counts) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (int k = 0; k < counts[i]; ++k) {
      points.push_back(
          lerp(corners[i], corners[(i + 1) % corners.size()], static_cast<double>(k) / counts[i]));
    }
  }
  return points;
}

/// Rectangle from the origin with `columns` x `rows` edges.
inline std::vector<Vec2> rectangle(double width, double height, int columns, int rows) {
  return polygon({{0, 0}, {width, 0}, {width, height}, {0, height}}, {columns, rows, columns, rows});
}

/// `count` points on a circle, counter-clockwise, or clockwise as a hole is.
inline std::vector<Vec2> circle(Vec2 centre, double radius, int count, bool clockwise = false) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = (clockwise ? -2 : 2) * pi * i / count;
    points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return points;
}

inline int triangles(const PlanarMesh& mesh) {
  return static_cast<int>(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                        [](const MeshElement& e) { return !is_quad(e); }));
}

inline double signed_area(const PlanarMesh& mesh, const MeshElement& element) {
  double twice = 0;
  const int corners = is_quad(element) ? 4 : 3;
  for (int i = 0; i < corners; ++i)
    twice += cross(mesh.nodes[element[i]], mesh.nodes[element[(i + 1) % corners]]);
  return twice / 2;
}

/// Inner nodes that do not have four quads. `fixed` nodes are not looked at.
inline int irregular_nodes(const PlanarMesh& mesh) {
  std::vector<int> valences(mesh.nodes.size(), 0);
  for (const MeshElement& element : mesh.elements) {
    for (const Index node : element) {
      if (node != no_index) ++valences[node];
    }
  }
  int irregular = 0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    irregular += mesh.freedom[i] != NodeFreedom::fixed && valences[i] != 4;
  }
  return irregular;
}

}  // namespace beadmesh::test
