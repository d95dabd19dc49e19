#include "beadmesh/mesh/shell_mesh.h"

#include <algorithm>
#include <utility>

namespace beadmesh {
namespace {

struct EdgeUse {
  Index low, high;
  bool forward;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

std::string number(size_t value) {
  return std::to_string(value);
}

/// False where a corner is no node, so that nothing else can be asked.
bool check_elements(const ShellMesh& mesh, std::vector<std::string>& violations) {
  std::vector<std::pair<MeshElement, size_t>> sorted;
  for (size_t e = 0; e < mesh.elements.size(); ++e) {
    MeshElement corners = mesh.elements[e].nodes;
    const int count = corner_count(corners);
    for (int i = 0; i < count; ++i)
      if (corners[i] < 0 || corners[i] >= mesh.nodes.size()) {
        violations.push_back("element " + number(e) + " has a corner that is no node");
        return false;
      }
    if (mesh.elements[e].part < 0 || mesh.elements[e].part >= mesh.parts.size())
      violations.push_back("element " + number(e) + " belongs to no part");
    std::sort(corners.begin(), corners.begin() + count);
    if (std::adjacent_find(corners.begin(), corners.begin() + count) != corners.begin() + count)
      violations.push_back("element " + number(e) + " is collapsed");
    sorted.emplace_back(corners, e);
  }
  std::sort(sorted.begin(), sorted.end());
  for (size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      violations.push_back("element " + number(sorted[i].second) + " repeats element " +
                           number(sorted[i - 1].second));
  return true;
}

void add_edge_uses(const MeshElement& nodes, std::vector<EdgeUse>& uses) {
  const int count = corner_count(nodes);
  for (int i = 0; i < count; ++i) {
    const Index a = nodes[i], b = nodes[(i + 1) % count];
    uses.push_back({std::min(a, b), std::max(a, b), a < b});
  }
}

std::vector<EdgeUse> edge_uses(const ShellMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(4 * mesh.elements.size());
  for (const ShellElement& element : mesh.elements) add_edge_uses(element.nodes, uses);
  std::sort(uses.begin(), uses.end());
  return uses;
}

void check_edges(const ShellMesh& mesh, std::vector<std::array<Index, 2>> allowed,
                 std::vector<std::string>& violations) {
  for (std::array<Index, 2>& pair : allowed) std::sort(pair.begin(), pair.end());
  std::sort(allowed.begin(), allowed.end());
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    const std::array<Index, 2> pair = {uses[begin].low, uses[begin].high};
    if (end - begin == 1 || std::binary_search(allowed.begin(), allowed.end(), pair)) continue;
    const std::string name = "edge " + number(pair[0]) + "-" + number(pair[1]);
    if (end - begin > 2)
      violations.push_back(name + " has " + number(end - begin) + " elements");
    else if (uses[begin].forward == uses[begin + 1].forward)
      violations.push_back(name + " is used twice in the same direction");
  }
}

}  // namespace

std::vector<Index> boundary_nodes(const ShellMesh& mesh, const std::vector<Index>& elements) {
  std::vector<EdgeUse> uses;
  for (const Index e : elements) add_edge_uses(mesh.elements[e].nodes, uses);
  std::sort(uses.begin(), uses.end());
  std::vector<Index> nodes;
  for (size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    if (end - begin > 1) continue;
    nodes.push_back(uses[begin].low);
    nodes.push_back(uses[begin].high);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<std::string> verify_shell_mesh(const ShellMesh& mesh,
                                           const std::vector<std::array<Index, 2>>& allowed_non_manifold) {
  std::vector<std::string> violations;
  if (mesh.elements.empty()) violations.push_back("the mesh has no element");
  if (!check_elements(mesh, violations)) return violations;
  check_edges(mesh, allowed_non_manifold, violations);
  std::vector<bool> used(mesh.nodes.size(), false);
  for (const ShellElement& element : mesh.elements)
    for (int i = 0; i < corner_count(element.nodes); ++i) used[element.nodes[i]] = true;
  for (size_t node = 0; node < used.size(); ++node)
    if (!used[node]) violations.push_back("node " + number(node) + " is unused");
  return violations;
}

}  // namespace beadmesh
