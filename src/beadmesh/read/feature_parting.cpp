#include "beadmesh/read/feature_parting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace beadmesh {
namespace {

class FeatureParter {
 public:
  FeatureParter(const FacetMesh& mesh, const std::vector<Index>& piece, const std::vector<double>& heights,
                double saddle)
      : mesh_(mesh), piece_(piece), heights_(heights), saddle_(saddle), root_(piece.size(), no_index) {
    for (const double h : heights) highest_ = std::max(highest_, std::abs(h));
  }

  std::vector<std::vector<Index>> run(double min_height) {
    std::vector<Index> order(piece_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return std::abs(heights_[a]) > std::abs(heights_[b]); });
    for (const Index i : order) flow(i);
    join_low(order, std::max(min_height, highest_ / 5));
    std::map<Index, std::vector<Index>> parts;
    for (Index i = 0; i < Index(piece_.size()); ++i) parts[top_of(i)].push_back(piece_[i]);
    std::vector<std::vector<Index>> result;
    for (auto& [top, part] : parts) result.push_back(std::move(part));
    return result;
  }

 private:
  Index top_of(Index i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }

  double height(Index i) const { return std::abs(heights_[i]); }

  /// Positions in the piece of the neighbours of one.
  std::vector<Index> beside(Index i) const {
    std::vector<Index> found;
    for (Index h = 3 * piece_[i]; h < 3 * piece_[i] + 3; ++h) {
      const Index t = mesh_.beyond(h);
      if (t == no_index) continue;
      const auto at = std::lower_bound(piece_.begin(), piece_.end(), t);
      if (at != piece_.end() && *at == t) found.push_back(Index(at - piece_.begin()));
    }
    return found;
  }

  /// From the peaks down: a facet joins the higher of its neighbours' parts, and joins them to one unless it
  /// lies too deep between them.
  void flow(Index i) {
    std::vector<Index> tops;
    for (const Index n : beside(i))
      if (root_[n] != no_index) tops.push_back(top_of(n));
    std::sort(tops.begin(), tops.end(),
              [&](Index a, Index b) { return height(a) != height(b) ? height(a) > height(b) : a < b; });
    tops.erase(std::unique(tops.begin(), tops.end()), tops.end());
    root_[i] = tops.empty() ? i : tops[0];
    for (size_t k = 1; k < tops.size(); ++k)
      if (height(i) >= saddle_ * height(tops[k])) root_[tops[k]] = tops[0];
  }

  /// Low peaks join the part beside which they lie.
  void join_low(const std::vector<Index>& order, double least) {
    for (auto i = order.rbegin(); i != order.rend(); ++i)
      for (const Index n : beside(*i)) {
        const Index a = top_of(*i), b = top_of(n);
        if (a == b || std::min(height(a), height(b)) >= least) continue;
        height(a) < height(b) ? root_[a] = b : root_[b] = a;
      }
  }

  const FacetMesh& mesh_;
  const std::vector<Index>& piece_;
  const std::vector<double>& heights_;
  const double saddle_;
  std::vector<Index> root_;  ///< per position: one nearer to the peak of its part; no_index: not yet reached
  double highest_ = 0;
};

}  // namespace

std::vector<std::vector<Index>> parted_features(const FacetMesh& mesh, const std::vector<Index>& piece,
                                                const std::vector<double>& heights, double saddle,
                                                double min_height) {
  return FeatureParter(mesh, piece, heights, saddle).run(min_height);
}

}  // namespace beadmesh
