#include "beadmesh/read/part_lines.h"

#include <algorithm>
#include <map>
#include <utility>

namespace beadmesh {
namespace {

constexpr double least_width = 5;  // mm

class PartSplitter {
 public:
  PartSplitter(const FacetMesh& mesh, std::vector<Index>& face)
      : mesh_(mesh), face_(face), piece_(face.size(), no_index) {}

  void run(const std::vector<bool>& is_feature) {
    for (Index t = 0; t < mesh_.triangle_count(); ++t)
      if (piece_[t] == no_index) flood(t, is_feature[face_[t]]);
    measure();
    for (Index p = 0; p < Index(into_.size()); ++p)
      if (2 * areas_[p] < least_width * circumferences_[p]) join_neighbour(p);
    number(Index(is_feature.size()));
  }

 private:
  void flood(Index seed, bool whole) {
    const Index p = Index(into_.size());
    into_.push_back(p);
    std::vector<Index> found{seed};
    piece_[seed] = p;
    for (size_t i = 0; i < found.size(); ++i)
      for (Index h = 3 * found[i]; h < 3 * found[i] + 3; ++h) {
        const Index t = mesh_.beyond(h);
        if (t == no_index || piece_[t] != no_index || face_[t] != face_[seed]) continue;
        if (!whole && mesh_.parts[t] != mesh_.parts[seed]) continue;
        piece_[t] = p;
        found.push_back(t);
      }
  }

  void measure() {
    areas_.assign(into_.size(), 0);
    circumferences_.assign(into_.size(), 0);
    shared_.resize(into_.size());
    for (Index h = 0; h < Index(mesh_.partner.size()); ++h) {
      const Index p = piece_[h / 3], t = mesh_.beyond(h);
      if (h % 3 == 0) areas_[p] += mesh_.area(h / 3);
      if (t != no_index && piece_[t] == p) continue;
      circumferences_[p] += mesh_.length(h);
      if (t != no_index && face_[t] == face_[h / 3]) shared_[p][piece_[t]] += mesh_.length(h);
    }
  }

  void join_neighbour(Index p) {
    const auto longest = std::max_element(shared_[p].begin(), shared_[p].end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    if (longest == shared_[p].end()) return;
    const Index from = end_of(p), to = end_of(longest->first);
    into_[std::max(from, to)] = std::min(from, to);
  }

  Index end_of(Index p) const {
    while (into_[p] != p) p = into_[p];
    return p;
  }

  /// The first piece of a face keeps its number.
  void number(Index next) {
    std::map<Index, Index> number_of_piece;
    std::map<Index, bool> used;
    for (size_t t = 0; t < face_.size(); ++t) {
      const Index p = end_of(piece_[t]);
      const auto found = number_of_piece.find(p);
      if (found == number_of_piece.end())
        number_of_piece[p] = used.emplace(face_[t], true).second ? face_[t] : next++;
      face_[t] = number_of_piece[p];
    }
  }

  const FacetMesh& mesh_;
  std::vector<Index>& face_;
  std::vector<Index> piece_;  ///< per triangle: connected, of one face and part
  std::vector<Index> into_;   ///< per piece: itself, or one that has taken it in
  std::vector<double> areas_, circumferences_;
  std::vector<std::map<Index, double>> shared_;  ///< per piece: length along others of its face
};

}  // namespace

void split_by_parts(const FacetMesh& mesh, const std::vector<bool>& is_feature, std::vector<Index>& face) {
  if (!face.empty()) PartSplitter(mesh, face).run(is_feature);
}

std::vector<Index> parts_of_faces(const FacetMesh& mesh, const std::vector<Index>& face) {
  std::vector<std::map<Index, double>> areas;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    if (face[t] >= Index(areas.size())) areas.resize(face[t] + 1);
    areas[face[t]][mesh.parts[t]] += mesh.area(t);
  }
  std::vector<Index> parts;
  for (const auto& of_face : areas)
    parts.push_back(std::max_element(of_face.begin(), of_face.end(), [](const auto& a, const auto& b) {
                      return a.second < b.second;
                    })->first);
  return parts;
}

}  // namespace beadmesh
