// A quad mesh of one face while it is being made: nodes in the flattened plane.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/core/vector.h"

namespace beadmesh {

/// How a node may move: anywhere in the face, only along its line (crest or boundary), not at all.
enum class NodeFreedom : unsigned char { free, sliding, fixed };

/// Corners counter-clockwise; a triangle has no_index as its fourth.
using MeshElement = std::array<Index, 4>;

inline bool is_quad(const MeshElement& element) {
  return element[3] != no_index;
}
inline int corner_count(const MeshElement& element) {
  return is_quad(element) ? 4 : 3;
}

struct PlanarMesh {
  std::vector<Vec2> nodes;
  std::vector<NodeFreedom> freedom;  ///< per node
  std::vector<MeshElement> elements;
};

/// What a face mesher is given: nodes on its boundary and on inner lines, fixed, as closed loops. A scar loop
/// (an inner line walked there and back) visits its inner nodes twice.
struct NodeLoops {
  std::vector<Vec2> nodes;
  std::vector<std::vector<Index>>
      loops;  ///< face on the left; the outer one first; scar loops after the holes
};

/// Violations in words: elements counter-clockwise in topology (every inner edge twice, in opposite
/// directions, boundary edges = the loops'), no unused node, no repeated or collapsed element, Euler's
/// formula. Geometry is not judged.
std::vector<std::string> verify_planar_mesh(const PlanarMesh& mesh, const NodeLoops& loops);

}  // namespace beadmesh
