#include "beadmesh/flatten/cut_open.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "beadmesh/flatten/facet_cutting.h"
#include "beadmesh/flatten/surface_path.h"

namespace beadmesh {
namespace {

constexpr double tube_turn = -0.5;  // half way between a tube's end (0) and a hole (-1)
constexpr double sewn_distortion =
    2;  // a face with a seam stays whole up to this ratio; a hemisphere has 1.44
constexpr int most_relief_cuts = 4;

std::vector<Index> boundary_vertices(const Facets& facets) {
  std::vector<Index> all;
  for (const auto& loop : facets.loops) all.insert(all.end(), loop.begin(), loop.end());
  return all;
}

class Opener {
 public:
  Opener(const Facets& facets, const FlattenOptions& options) : facets_(facets), options_(options) {}

  Result<OpenedFace> run() {
    CutFacets piece{facets_, facets_.panel_points};
    const bool has_seam = is_seamed();
    if (has_seam) {
      if (auto whole = sewn_up()) return std::move(*whole);
      auto flat = flatten(facets_, options_);
      if (flat) return opened(piece, std::move(*flat));
    } else {
      std::iota(piece.origin.begin(), piece.origin.end(), 0);
    }
    return cut_open(std::move(piece), has_seam);
  }

 private:
  /// Does the boundary run twice over the same panel points, there and back?
  bool is_seamed() const {
    if (facets_.panel_points.size() != facets_.points.size()) return false;
    for (const auto& loop : cut_sides(facets_.loops, facets_.panel_points))
      if (std::find(loop.begin(), loop.end(), true) != loop.end()) return true;
    return false;
  }

  /// The face with its seam closed, where it can be laid flat like that.
  std::optional<OpenedFace> sewn_up() const {
    const CutFacets whole = sewn(facets_, facets_.panel_points);
    if (whole.facets.loops.empty() || tube_ends(loop_turns(whole.facets))) return std::nullopt;
    FlattenOptions strict = options_;
    strict.max_distortion = std::min(options_.max_distortion, sewn_distortion);
    auto flat = flatten(whole.facets, strict);
    if (!flat) return std::nullopt;
    return OpenedFace{whole.facets, std::move(*flat), {}};
  }

  static OpenedFace opened(const CutFacets& piece, FlatFace flat) {
    return {piece.facets, std::move(flat), cut_sides(piece.facets.loops, piece.origin)};
  }

  /// Cuts until the piece can be laid flat.
  Result<OpenedFace> cut_open(CutFacets piece, bool is_cut) const {
    if (auto closed = open_closed(piece); !closed) return Failure(closed.error());
    is_cut |= piece.facets.points.size() != facets_.points.size();
    while (cut_tube(piece)) is_cut = true;
    auto flat = flatten(piece.facets, options_);
    for (int cuts = 0; !flat && cuts < most_relief_cuts && can_be_relieved(flat.error()); ++cuts) {
      if (!relieve(piece)) break;
      is_cut = true;
      flat = flatten(piece.facets, options_);
    }
    if (!flat) return Failure(flat.error());
    OpenedFace face = opened(piece, std::move(*flat));
    if (!is_cut) face.cut_sides.clear();
    return face;
  }

  static bool can_be_relieved(const Diagnostic& error) {
    return error.code == "flatten.distortion" || error.code == "flatten.flip";
  }

  /// A piece without boundary: cut between two points far apart.
  Result<void> open_closed(CutFacets& piece) const {
    if (!piece.facets.loops.empty() || piece.facets.triangles.empty()) return {};
    const Index one = farthest_vertex(piece.facets, {0}), other = farthest_vertex(piece.facets, {one});
    if (!cut_along(piece, shortest_path(piece.facets, {one}, {other})))
      return fail("flatten.closed", "the piece is closed and could not be cut open", "split the face");
    return {};
  }

  /// The shortest way between the ends of a tube. False where there is none to cut.
  static bool cut_tube(CutFacets& piece) {
    const auto ends = tube_ends(loop_turns(piece.facets));
    if (!ends) return false;
    const auto& loops = piece.facets.loops;
    return cut_along(piece, shortest_path(piece.facets, loops[ends->first], loops[ends->second]));
  }

  /// A cut from the point farthest from the boundary to the boundary.
  static bool relieve(CutFacets& piece) {
    const std::vector<Index> boundary = boundary_vertices(piece.facets);
    if (boundary.empty()) return false;
    const Index deep = farthest_vertex(piece.facets, boundary);
    return deep != no_index && cut_along(piece, shortest_path(piece.facets, {deep}, boundary));
  }

  const Facets& facets_;
  const FlattenOptions& options_;
};

}  // namespace

std::vector<double> loop_turns(const Facets& facets) {
  std::vector<double> angle(facets.points.size(), 0);
  for (const Triangle& t : facets.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 here = facets.points[t[k]];
      angle[t[k]] +=
          angle_between(facets.points[t[(k + 1) % 3]] - here, facets.points[t[(k + 2) % 3]] - here);
    }
  std::vector<double> turns;
  for (const auto& loop : facets.loops) {
    double sum = 0;
    for (const Index v : loop) sum += pi - angle[v];
    turns.push_back(sum / (2 * pi));
  }
  return turns;
}

std::optional<std::pair<std::size_t, std::size_t>> tube_ends(const std::vector<double>& turns) {
  if (turns.size() < 2) return std::nullopt;
  std::size_t most = 0, second = 1;
  if (turns[second] > turns[most]) std::swap(most, second);
  for (std::size_t l = 2; l < turns.size(); ++l) {
    if (turns[l] > turns[most])
      second = most, most = l;
    else if (turns[l] > turns[second])
      second = l;
  }
  const bool closes = turns[second] > tube_turn || turns[most] < tube_turn;
  if (!closes) return std::nullopt;
  return std::minmax(most, second);
}

double cut_length(const Facets& facets, const std::vector<std::vector<bool>>& cut_sides) {
  double sum = 0;
  for (std::size_t l = 0; l < cut_sides.size(); ++l) {
    const auto& loop = facets.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (cut_sides[l][i])
        sum += distance(facets.points[loop[i]], facets.points[loop[(i + 1) % loop.size()]]);
  }
  return sum / 2;
}

Result<OpenedFace> lay_open(const Facets& facets, const FlattenOptions& options) {
  return Opener(facets, options).run();
}

}  // namespace beadmesh
