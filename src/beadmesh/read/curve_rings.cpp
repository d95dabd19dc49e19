#include "beadmesh/read/curve_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "beadmesh/geometry/predicates.h"
#include "beadmesh/read/facet_bulges.h"

namespace beadmesh::read {
namespace {

constexpr double facet_angle = radians(7.5), smooth_turn = radians(0.01);
constexpr double flat_height = 1e-8;  // of the chord
constexpr int refinements = 7;        // 7.5 degrees become 0.06

// A piece with its circle, if it has one.
struct Piece {
  Piece(const RingPiece& from, std::size_t of_loop) : given(from), loop(of_loop) {}

  RingPiece given;
  std::size_t loop = 0;
  Index curve = no_index;
  Vec2 centre;
  double radius = 0, angle = 0, sweep = 0;
  int facets = 1;

  Vec2 point(double t) const {
    const double at = angle + sweep * t;
    return centre + Vec2{std::cos(at), std::sin(at)} * radius;
  }
  Vec2 tangent(double t) const {
    if (curve == no_index) return given.end - given.start;
    const double at = angle + sweep * t;
    return Vec2{-std::sin(at), std::cos(at)} * sweep;
  }
};

Failure arc_failure(std::size_t loop, std::string message) {
  return fail("read.wkt.arc", std::move(message), {}, fmt::format("loop {}", loop + 1));
}

std::string name_of(const Piece& piece) {
  return fmt::format("the {} from point {} to point {} of loop {}", piece.given.is_arc ? "arc" : "line",
                     piece.given.number, piece.given.number + (piece.given.is_arc ? 2 : 1), piece.loop + 1);
}

// The circle through the three points of an arc; none where they are on one line or nearly so.
Result<void> find_circle(Piece& piece) {
  const auto& [start, middle, end, is_arc, number] = piece.given;
  const Vec2 u = middle - start, v = end - start;
  const double chord = norm(v), turn = cross(u, v);
  const auto failure = [&](const char* why) { return arc_failure(piece.loop, name_of(piece) + " " + why); };
  if (middle == start || middle == end) return failure("has the same point twice");
  if (v == Vec2{}) {
    piece.centre = lerp(start, middle, 0.5);
    piece.sweep = 2 * pi;
  } else {
    const bool between = dot(u, v) >= 0 && dot(middle - end, v) <= 0;
    if (std::abs(turn) <= 4 * flat_height * chord * chord) {
      if (!between) return failure("has its middle point on the line through its ends, but not between them");
      return {};
    }
    piece.centre = start + Vec2{v.y * squared_norm(u) - u.y * squared_norm(v),
                                u.x * squared_norm(v) - v.x * squared_norm(u)} /
                               (2 * turn);
  }
  const Vec2 from = start - piece.centre, to = end - piece.centre;
  piece.radius = norm(from);
  piece.angle = std::atan2(from.y, from.x);
  if (!(v == Vec2{})) {
    double sweep = std::atan2(to.y, to.x) - piece.angle;
    if (turn > 0 && sweep < 0) sweep += 2 * pi;  // the middle point is on the right of the chord
    if (turn < 0 && sweep > 0) sweep -= 2 * pi;
    piece.sweep = sweep;
  }
  piece.curve = 0;  // numbered later
  piece.facets = std::max(1, static_cast<int>(std::ceil(std::abs(piece.sweep) / facet_angle - 1e-9)));
  return {};
}

// Where a point of the polygon comes from.
struct Origin {
  std::size_t piece = 0;
  int facet = 0;  // 0: the start of the piece
};

class RingRegion {
 public:
  explicit RingRegion(const std::vector<Ring>& rings) : rings_(rings) {}

  Result<PlanarRegion> run() {
    if (auto done = collect(); !done) return Failure(done.error());
    for (int round = 0;; ++round) {
      PlanarRegion region = facetted();
      const std::vector<BulgeConflict> conflicts = bulge_conflicts(region);
      if (conflicts.empty() || round == refinements) return checked(std::move(region), conflicts);
      refine(region, conflicts);
    }
  }

 private:
  Result<void> collect();
  PlanarRegion facetted();
  void refine(const PlanarRegion& region, const std::vector<BulgeConflict>& conflicts);
  Result<PlanarRegion> checked(PlanarRegion region, const std::vector<BulgeConflict>& conflicts) const;
  const Piece& piece_of(const SegmentName& segment) const {
    return pieces_[origins_[segment.loop][segment.segment].piece];
  }
  std::string name(std::size_t loop, std::size_t point) const {
    const Origin& origin = origins_[loop][point];
    const Piece& piece = pieces_[origin.piece];
    return origin.facet > 0 ? "a point of " + name_of(piece)
                            : fmt::format("point {} of loop {}", piece.given.number, loop + 1);
  }

  const std::vector<Ring>& rings_;
  std::vector<Piece> pieces_;  // of all rings, in order
  std::vector<bool> corner_;   // per piece: at its start
  std::vector<std::shared_ptr<const PlanarCurve>> curves_;
  std::vector<std::vector<Origin>> origins_;  // per loop, per point of the polygon
};

Result<void> RingRegion::collect() {
  for (std::size_t l = 0; l < rings_.size(); ++l) {
    const std::size_t first = pieces_.size();
    for (const RingPiece& given : rings_[l]) {
      for (const Vec2 p : {given.start, given.middle, given.end})
        if (!is_in_exact_range(p))
          return fail("delaunay.region.not_finite",
                      fmt::format("a point of {} ({}, {}) is not finite or out of range",
                                  name_of(Piece(given, l)), p.x, p.y),
                      {}, fmt::format("loop {}", l + 1));
      Piece piece(given, l);
      if (given.is_arc)
        if (auto done = find_circle(piece); !done) return done;
      if (piece.curve != no_index) {
        piece.curve = static_cast<Index>(curves_.size());
        curves_.push_back(std::make_shared<CircularArc>(piece.centre, piece.radius));
      }
      pieces_.push_back(piece);
    }
    for (std::size_t i = first; i < pieces_.size(); ++i) {
      const Piece& before = pieces_[i == first ? pieces_.size() - 1 : i - 1];
      corner_.push_back(angle_between(before.tangent(1), pieces_[i].tangent(0)) > smooth_turn);
    }
  }
  return {};
}

PlanarRegion RingRegion::facetted() {
  PlanarRegion region;
  region.curves = curves_;
  region.loops.resize(rings_.size());
  origins_.assign(rings_.size(), {});
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    PlanarLoop& loop = region.loops[piece.loop];
    for (int k = 0; k < piece.facets; ++k) {
      const double t = static_cast<double>(k) / piece.facets,
                   next = static_cast<double>(k + 1) / piece.facets;
      loop.points.push_back(k == 0 ? piece.given.start : piece.point(t));
      loop.corner.push_back(k == 0 && corner_[i]);
      loop.curve.push_back(piece.curve);
      loop.parameters.push_back({piece.angle + piece.sweep * t, piece.angle + piece.sweep * next});
      origins_[piece.loop].push_back({i, k});
    }
  }
  return region;
}

void RingRegion::refine(const PlanarRegion& region, const std::vector<BulgeConflict>& conflicts) {
  std::vector<bool> wanted(pieces_.size(), false);
  for (const BulgeConflict& conflict : conflicts)
    for (const SegmentName& side : {conflict.bulge, conflict.other})
      if (region.loops[side.loop].curve[side.segment] != no_index)
        wanted[origins_[side.loop][side.segment].piece] = true;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (wanted[i]) pieces_[i].facets *= 2;
}

Result<PlanarRegion> RingRegion::checked(PlanarRegion region,
                                         const std::vector<BulgeConflict>& conflicts) const {
  auto result = checked_region(std::move(region),
                               [&](std::size_t loop, std::size_t point) { return name(loop, point); });
  if (!result || conflicts.empty()) return result;
  const Piece &a = piece_of(conflicts.front().bulge), &b = piece_of(conflicts.front().other);
  return arc_failure(a.loop, name_of(a) + " touches or crosses " + name_of(b) + ", or nearly so");
}

}  // namespace

Result<PlanarRegion> region_of_rings(const std::vector<Ring>& rings) {
  return RingRegion(rings).run();
}

}  // namespace beadmesh::read
