#include "beadmesh/mesh/lattice_core.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>

#include "beadmesh/mesh/segment_grid.h"

namespace beadmesh {
namespace {

constexpr double pitch_range = 0.06;     // the steps may differ from the size by this share
constexpr double largest_lattice = 4e7;  // points; a face beyond it gets no core

template <class Visit>
void for_edges(const std::vector<NodeLoop>& loops, Visit visit) {
  for (const NodeLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[(i + 1) % loop.size()]);
  }
}

Vec2 main_direction(const MeshDraft& draft, const std::vector<NodeLoop>& loops) {
  std::complex<double> sum;
  for_edges(loops, [&](Index a, Index b) {
    const Vec2 d = draft.at(b) - draft.at(a);
    sum += std::polar(norm(d), 4 * std::atan2(d.y, d.x));
  });
  const double angle = std::abs(sum) > 0 ? std::arg(sum) / 4 : 0;
  return {std::cos(angle), std::sin(angle)};
}

// Length of a flat step in the direction that measures the size on the surface, averaged over the loops'
// nodes.
double flat_size(const MeshDraft& draft, const std::vector<NodeLoop>& loops, Vec2 direction) {
  double sum = 0, count = 0;
  for_edges(loops, [&](Index a, Index) {
    const SurfaceMetric& m = draft.metric(a);
    const double square = m.xx * direction.x * direction.x + 2 * m.xy * direction.x * direction.y +
                          m.yy * direction.y * direction.y;
    sum += std::sqrt(std::max(square, 1e-12));
    count += 1;
  });
  return sum > 0 ? draft.size() * count / sum : draft.size();
}

struct Comb {
  double pitch, phase;
};

// The comb of parallel lines that the places prefer; a pitch off the size has to pay for it.
Comb fit_comb(const std::vector<std::array<double, 2>>& places, double pitch) {
  if (places.empty()) return {pitch, 0};
  double low = 1e300, high = -1e300, total = 0;
  for (const auto& [place, weight] : places) {
    low = std::min(low, place), high = std::max(high, place), total += weight;
  }
  const int steps = std::clamp(static_cast<int>((high - low) / pitch * pitch_range / 0.15), 1, 300);
  Comb best{pitch, low};
  double best_score = -1;
  for (int i = 0; i <= 2 * steps; ++i) {
    // From the middle outwards, so that the pitch nearest to the size wins ties.
    const int k = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
    const double trial = pitch * (1 + pitch_range * k / steps);
    std::complex<double> sum;
    for (const auto& [place, weight] : places) sum += std::polar(weight, 2 * pi * (place - low) / trial);
    const double score = std::abs(sum) / total - 0.2 * std::abs(k) / steps;
    if (score > best_score + 1e-9) {
      best_score = score;
      best = {trial, low + trial * std::arg(sum) / (2 * pi)};
    }
  }
  return best;
}

class LatticeCore {
 public:
  LatticeCore(MeshDraft& draft, const std::vector<NodeLoop>& loops, const Lattice& lattice, double clearance)
      : draft_(draft), loops_(loops), lattice_(lattice), clearance_(clearance) {}

  std::vector<NodeLoop> add() {
    if (!measure()) return {};
    choose_points();
    choose_cells();
    while (drop_bad_cells()) {
    }
    return emit();
  }

 private:
  // Lattice coordinates of a node; cell (i, j) spans [i, i+1] x [j, j+1].
  Vec2 coordinates(Index node) const {
    const Vec2 d = draft_.at(node) - lattice_.origin;
    return {dot(d, lattice_.first) / squared_norm(lattice_.first) - i0_,
            dot(d, lattice_.second) / squared_norm(lattice_.second) - j0_};
  }

  bool measure() {
    Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
    for (const Index node : loops_[0]) {
      const Vec2 c = coordinates(node);
      low = {std::min(low.x, c.x), std::min(low.y, c.y)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    }
    if (!((high.x - low.x + 4) * (high.y - low.y + 4) < largest_lattice)) return false;
    i0_ = std::floor(low.x) - 1, j0_ = std::floor(low.y) - 1;
    columns_ = static_cast<int>(std::ceil(high.x) - i0_) + 2;
    rows_ = static_cast<int>(std::ceil(high.y) - j0_) + 2;
    return true;
  }

  std::size_t slot(int i, int j) const { return static_cast<std::size_t>(j) * columns_ + i; }

  // Inside by the even-odd rule row by row, then off where a loop edge is near.
  void choose_points() {
    std::vector<std::vector<double>> crossings(rows_);
    for_edges(loops_, [&](Index a, Index b) {
      Vec2 p = coordinates(a), q = coordinates(b);
      if (p.y > q.y) std::swap(p, q);
      const int from = std::max(0, static_cast<int>(std::ceil(p.y)));
      for (int j = from; j < q.y && j < rows_; ++j)
        crossings[j].push_back(p.x + (q.x - p.x) * (j - p.y) / (q.y - p.y));
    });
    kept_points_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
    for (int j = 0; j < rows_; ++j) {
      std::sort(crossings[j].begin(), crossings[j].end());
      for (std::size_t k = 0; k + 1 < crossings[j].size(); k += 2) {
        const int last = std::min(columns_ - 1, static_cast<int>(std::floor(crossings[j][k + 1])));
        for (int i = std::max(0, static_cast<int>(std::ceil(crossings[j][k]))); i <= last; ++i) {
          kept_points_[slot(i, j)] = 1;
        }
      }
    }
    for_edges(loops_, [&](Index a, Index b) { drop_points_near(coordinates(a), coordinates(b)); });
    open_slots_between_odd_loops();
  }

  // What is left over around a loop with an odd count could not be meshed by quads: two such loops get a
  // common area.
  void open_slots_between_odd_loops() {
    const NodeLoop* waiting = nullptr;
    for (const NodeLoop& loop : loops_) {
      if (loop.size() % 2 == 0) continue;
      if (waiting) {
        const auto [a, b] = nearest_nodes(*waiting, loop);
        drop_points_near(coordinates(a), coordinates(b));
      }
      waiting = waiting ? nullptr : &loop;
    }
  }

  std::array<Index, 2> nearest_nodes(const NodeLoop& first, const NodeLoop& second) const {
    std::array<Index, 2> nearest{first[0], second[0]};
    for (const Index a : first) {
      for (const Index b : second) {
        if (distance(draft_.at(a), draft_.at(b)) < distance(draft_.at(nearest[0]), draft_.at(nearest[1])))
          nearest = {a, b};
      }
    }
    return nearest;
  }

  void drop_points_near(Vec2 p, Vec2 q) {
    const int i_low = std::max(0, static_cast<int>(std::ceil(std::min(p.x, q.x) - clearance_)));
    const int i_high = std::min(columns_ - 1, static_cast<int>(std::floor(std::max(p.x, q.x) + clearance_)));
    const int j_low = std::max(0, static_cast<int>(std::ceil(std::min(p.y, q.y) - clearance_)));
    const int j_high = std::min(rows_ - 1, static_cast<int>(std::floor(std::max(p.y, q.y) + clearance_)));
    for (int j = j_low; j <= j_high; ++j) {
      for (int i = i_low; i <= i_high; ++i) {
        if (distance_to_segment({double(i), double(j)}, p, q) < clearance_ - 1e-6)
          kept_points_[slot(i, j)] = 0;
      }
    }
  }

  bool cell(int i, int j) const {
    return i >= 0 && j >= 0 && i + 1 < columns_ && j + 1 < rows_ && cells_[slot(i, j)] != 0;
  }
  int neighbours(int i, int j) const {
    return cell(i - 1, j) + cell(i + 1, j) + cell(i, j - 1) + cell(i, j + 1);
  }

  void choose_cells() {
    cells_.assign(kept_points_.size(), 0);
    for (int j = 0; j + 1 < rows_; ++j) {
      for (int i = 0; i + 1 < columns_; ++i) {
        cells_[slot(i, j)] = kept_points_[slot(i, j)] && kept_points_[slot(i + 1, j)] &&
                             kept_points_[slot(i, j + 1)] && kept_points_[slot(i + 1, j + 1)];
      }
    }
    for_edges(loops_, [&](Index a, Index) {
      const Vec2 c = coordinates(a);
      cells_[slot(std::clamp(int(c.x), 0, columns_ - 1), std::clamp(int(c.y), 0, rows_ - 1))] = 0;
    });
  }

  bool drop_bad_cells() {
    bool dropped = false;
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) {
        if (cell(i, j) && neighbours(i, j) < 2) cells_[slot(i, j)] = 0, dropped = true;
        if (i == 0 || j == 0) continue;
        if (cell(i, j) && cell(i - 1, j - 1) && !cell(i - 1, j) && !cell(i, j - 1)) {
          drop_fewer_neighbours(i, j, i - 1, j - 1), dropped = true;
        }
        if (cell(i - 1, j) && cell(i, j - 1) && !cell(i, j) && !cell(i - 1, j - 1)) {
          drop_fewer_neighbours(i - 1, j, i, j - 1), dropped = true;
        }
      }
    }
    return dropped;
  }

  void drop_fewer_neighbours(int i, int j, int k, int l) {
    cells_[neighbours(i, j) <= neighbours(k, l) ? slot(i, j) : slot(k, l)] = 0;
  }

  Index node_at(int i, int j) {
    Index& node = point_nodes_[slot(i, j)];
    if (node == no_index) {
      node = draft_.add_node(lattice_.origin + (i + i0_) * lattice_.first + (j + j0_) * lattice_.second);
    }
    return node;
  }

  std::vector<NodeLoop> emit() {
    point_nodes_.assign(cells_.size(), no_index);
    std::map<Index, Index> next;  // outline edges, cells on the right: each outline node has one successor
    for (int j = 0; j + 1 < rows_; ++j) {
      for (int i = 0; i + 1 < columns_; ++i) {
        if (!cell(i, j)) continue;
        const Index a = node_at(i, j), b = node_at(i + 1, j), c = node_at(i + 1, j + 1),
                    d = node_at(i, j + 1);
        draft_.add_element({a, b, c, d});
        if (!cell(i, j - 1)) next[b] = a;
        if (!cell(i + 1, j)) next[c] = b;
        if (!cell(i, j + 1)) next[d] = c;
        if (!cell(i - 1, j)) next[a] = d;
      }
    }
    std::vector<NodeLoop> outlines;
    while (!next.empty()) {
      NodeLoop outline;
      for (auto at = next.begin(); at != next.end(); at = next.find(outline.back())) {
        outline.push_back(at->second);
        next.erase(at);
      }
      outlines.push_back(std::move(outline));
    }
    return outlines;
  }

  MeshDraft& draft_;
  const std::vector<NodeLoop>& loops_;
  const Lattice lattice_;
  const double clearance_;
  double i0_ = 0, j0_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<char> kept_points_, cells_;
  std::vector<Index> point_nodes_;
};

}  // namespace

Lattice fit_lattice(const MeshDraft& draft, const std::vector<NodeLoop>& loops) {
  const Vec2 u = main_direction(draft, loops), v = left_normal(u);
  std::vector<std::array<double, 2>> u_places, v_places;
  for_edges(loops, [&](Index a, Index b) {
    const Vec2 d = draft.at(b) - draft.at(a);
    const double length = norm(d);
    if (std::min(std::abs(dot(d, u)), std::abs(dot(d, v))) > 0.05 * length) return;
    const bool along_u = std::abs(dot(d, u)) > std::abs(dot(d, v));
    // A line across the comb's direction should fall on it most of all, nodes along a line less.
    u_places.push_back({dot(draft.at(a), u), along_u ? length : 2 * length});
    v_places.push_back({dot(draft.at(a), v), along_u ? 2 * length : length});
  });
  const Comb first = fit_comb(u_places, flat_size(draft, loops, u));
  const Comb second = fit_comb(v_places, flat_size(draft, loops, v));
  return {first.phase * u + second.phase * v, first.pitch * u, second.pitch * v};
}

std::vector<NodeLoop> add_lattice_core(MeshDraft& draft, const std::vector<NodeLoop>& loops,
                                       const Lattice& lattice, double clearance) {
  return LatticeCore(draft, loops, lattice, clearance).add();
}

}  // namespace beadmesh
