#include "beadmesh/mesh/face_shortfalls.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "beadmesh/mesh/element_quality.h"

namespace beadmesh {
namespace {

constexpr double rounding = 1e-6;  // of the minimum

struct ShortEdges {
  int count = 0;
  double shortest = 1e300;

  void add(double length) {
    ++count;
    shortest = std::min(shortest, length);
  }
};

/// What one face is short of.
class FaceReview {
 public:
  FaceReview(const ShellMesh& mesh, const std::vector<Index>& elements, double min_edge)
      : mesh_(mesh), min_edge_(min_edge) {
    for (const Index e : elements) add(mesh.elements[e].nodes);
    for (const auto& [edge, uses] : uses_)
      if (uses == 1) boundary_.push_back(edge[0]), boundary_.push_back(edge[1]);
    std::sort(boundary_.begin(), boundary_.end());
    for (const auto& [edge, uses] : uses_) judge(edge, uses);
  }

  std::vector<Diagnostic> findings(Index face) const {
    std::vector<Diagnostic> found;
    if (inverted_ > 0) {
      const Vec3 at = first_inverted_;
      found.push_back({"mesh.face.inverted", Severity::warning, face, "",
                       fmt::format("{} {} turned over, near {:.1f} {:.1f} {:.1f}", inverted_,
                                   inverted_ == 1 ? "element is" : "elements are", at.x, at.y, at.z),
                       ""});
    }
    tell(found, face, on_boundary_, "on its boundary",
         "between corners of the CAD face nearer than the minimum");
    tell(found, face, across_, "across it", "the face is narrower than the minimum");
    tell(found, face, inside_, "inside", "");
    return found;
  }

 private:
  void add(const MeshElement& element) {
    const int count = corner_count(element);
    for (int i = 0; i < count; ++i) {
      const Index a = element[i], b = element[(i + 1) % count];
      ++uses_[{std::min(a, b), std::max(a, b)}];
    }
    if (scaled_jacobian(mesh_.nodes, element) > 0) return;
    if (inverted_++ == 0) first_inverted_ = mesh_.nodes[element[0]];
  }

  void judge(const std::array<Index, 2>& edge, int uses) {
    const double length = distance(mesh_.nodes[edge[0]], mesh_.nodes[edge[1]]);
    if (length >= min_edge_ * (1 - rounding)) return;
    if (uses == 1)
      on_boundary_.add(length);
    else if (is_boundary(edge[0]) && is_boundary(edge[1]))
      across_.add(length);
    else
      inside_.add(length);
  }

  bool is_boundary(Index node) const { return std::binary_search(boundary_.begin(), boundary_.end(), node); }

  void tell(std::vector<Diagnostic>& found, Index face, const ShortEdges& edges, const char* where,
            const char* why) const {
    if (edges.count == 0) return;
    found.push_back({"mesh.face.min_edge", Severity::warning, face, "",
                     fmt::format("{} {} {} under the minimum of {:g} mm, the shortest {:.3f} mm{}{}",
                                 edges.count, edges.count == 1 ? "edge" : "edges", where, min_edge_,
                                 edges.shortest, *why ? ": " : "", why),
                     ""});
  }

  const ShellMesh& mesh_;
  double min_edge_;
  std::map<std::array<Index, 2>, int> uses_;  ///< by elements of the face
  std::vector<Index> boundary_;               ///< nodes, ascending
  int inverted_ = 0;
  Vec3 first_inverted_;
  ShortEdges on_boundary_, across_, inside_;
};

bool is_short_of_something(const ShellMesh& mesh, const MeshElement& element, double min_edge) {
  return scaled_jacobian(mesh.nodes, element) <= 0 ||
         side_lengths(mesh.nodes, element)[0] < min_edge * (1 - rounding);
}

}  // namespace

std::vector<Diagnostic> face_shortfalls(const ShellMesh& mesh, double min_edge) {
  std::map<Index, std::vector<Index>> elements;  // per number of a face with a finding
  for (const ShellElement& element : mesh.elements)
    if (is_short_of_something(mesh, element.nodes, min_edge)) elements[element.face];
  for (Index e = 0; e < Index(mesh.elements.size()) && !elements.empty(); ++e)
    if (const auto face = elements.find(mesh.elements[e].face); face != elements.end())
      face->second.push_back(e);
  std::vector<Diagnostic> found;
  for (const auto& [face, own] : elements)
    for (Diagnostic& one : FaceReview(mesh, own, min_edge).findings(face)) found.push_back(std::move(one));
  return found;
}

}  // namespace beadmesh
