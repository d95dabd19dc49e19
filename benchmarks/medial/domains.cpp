#include "domains.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

namespace beadmesh::bench {
namespace {

Piece line(Vec2 from, Vec2 to) {
  return {from, to, {}, 0, 0, 0};
}

Piece arc(Vec2 centre, double radius, double start, double angle) {
  const auto on = [&](double at) { return centre + Vec2{std::cos(at), std::sin(at)} * radius; };
  return {on(start), on(start + angle), centre, radius, start, angle};
}

std::vector<Piece> polygon(const std::vector<Vec2>& corners) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < corners.size(); ++i)
    pieces.push_back(line(corners[i], corners[(i + 1) % corners.size()]));
  return pieces;
}

std::vector<Piece> rounded_rectangle(double width, double height, double r) {
  const double w = width, h = height;
  return {line({r, 0}, {w - r, 0}), arc({w - r, r}, r, -pi / 2, pi / 2),
          line({w, r}, {w, h - r}), arc({w - r, h - r}, r, 0, pi / 2),
          line({w - r, h}, {r, h}), arc({r, h - r}, r, pi / 2, pi / 2),
          line({0, h - r}, {0, r}), arc({r, r}, r, pi, pi / 2)};
}

/// How many segments each piece gets: by length, the largest remainders first, at least one.
std::vector<int> shares(const std::vector<double>& lengths, int segments) {
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  std::vector<int> share;
  std::vector<std::size_t> order(lengths.size());
  std::iota(order.begin(), order.end(), 0);
  for (const double length : lengths)
    share.push_back(std::max(1, static_cast<int>(length / total * segments)));
  const auto remainder = [&](std::size_t i) { return lengths[i] / total * segments - share[i]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainder(a) > remainder(b); });
  int missing = segments - std::accumulate(share.begin(), share.end(), 0);
  for (std::size_t k = 0; missing > 0; ++k, --missing) ++share[order[k % order.size()]];
  return share;
}

Vec2 turned(Vec2 p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

}  // namespace

double Piece::distance_to(Vec2 p) const {
  const double to_ends = std::min(distance(p, from), distance(p, to));
  if (radius == 0) {
    const Vec2 d = to - from;
    const double t = dot(p - from, d) / dot(d, d);
    return t > 0 && t < 1 ? std::abs(cross(d, p - from)) / norm(d) : to_ends;
  }
  const Vec2 from_centre = p - centre;
  double turn = (std::atan2(from_centre.y, from_centre.x) - start) * (angle > 0 ? 1 : -1);
  turn -= 2 * pi * std::floor(turn / (2 * pi));
  return turn <= std::abs(angle) ? std::abs(norm(from_centre) - radius) : to_ends;
}

double Piece::length() const {
  return radius > 0 ? radius * std::abs(angle) : distance(from, to);
}

Vec2 Piece::at(double t) const {
  if (t == 0) return from;
  if (radius == 0) return lerp(from, to, t);
  const double a = start + angle * t;
  return centre + Vec2{std::cos(a), std::sin(a)} * radius;
}

Domain i_bead() {
  const double r = 10, length = 180;
  return {"I-bead",
          {{line({0, -r}, {length, -r}), arc({length, 0}, r, -pi / 2, pi), line({length, r}, {0, r}),
            arc({0, 0}, r, pi / 2, pi)}},
          1,
          0,
          0};
}

Domain gasket() {
  Domain domain{"gasket", {rounded_rectangle(177, 104, 12)}, 117, 78, 0};
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 8; ++column) {
      // Off the grid, so that no inscribed circle touches four holes.
      const Vec2 centre{14 + 20.0 * column + (row % 2 ? 9.0 : 0.0) + 0.3 * ((row * 5 + column * 3) % 7),
                        14 + 19.0 * row + 0.4 * ((row * 3 + column * 5) % 4)};
      domain.loops.push_back({arc(centre, 3.5 + 0.7 * ((row * 3 + column) % 6), 0.1, -2 * pi)});
    }
  return domain;
}

Domain comb() {
  constexpr int teeth = 15;
  const double width = 8, pitch = 20, length = 60, end = (teeth - 1) * pitch + width;
  std::vector<Vec2> corners{{end, width}, {0, width}};
  for (int k = 0; k < teeth; ++k) {
    const double x = k * pitch;
    if (k > 0) corners.push_back({x, 0});
    corners.push_back({x, -length});
    corners.push_back({x + width, -length});
    if (k + 1 < teeth) corners.push_back({x + width, 0});
  }
  return {"comb", {polygon(corners)}, 61, 30, 32};
}

PlanarRegion cut(const Domain& domain, int segments, double angle) {
  std::vector<double> lengths;
  for (const auto& loop : domain.loops)
    for (const Piece& piece : loop) lengths.push_back(piece.length());
  const std::vector<int> share = shares(lengths, segments);
  PlanarRegion region;
  std::size_t number = 0;
  for (const auto& loop : domain.loops) {
    PlanarLoop& cut_loop = region.loops.emplace_back();
    for (const Piece& piece : loop) {
      const int n = share[number++];
      for (int i = 0; i < n; ++i)
        cut_loop.points.push_back(turned(piece.at(static_cast<double>(i) / n), angle));
    }
  }
  return region;
}

PlanarRegion exact(const Domain& domain, double angle) {
  PlanarRegion region;
  for (const auto& loop : domain.loops) {
    PlanarLoop& exact_loop = region.loops.emplace_back();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Piece& piece = loop[k];
      const bool is_arc = piece.radius > 0, after_arc = loop[(k + loop.size() - 1) % loop.size()].radius > 0;
      Index curve = no_index;
      if (is_arc) {
        curve = static_cast<Index>(region.curves.size());
        region.curves.push_back(std::make_shared<CircularArc>(turned(piece.centre, angle), piece.radius));
      }
      const int n = is_arc ? static_cast<int>(std::ceil(std::abs(piece.angle) / radians(15.0) - 1e-9)) : 1;
      for (int i = 0; i < n; ++i) {
        exact_loop.points.push_back(turned(piece.at(static_cast<double>(i) / n), angle));
        exact_loop.corner.push_back(i == 0 && !is_arc && !after_arc);  // here arcs join smoothly
        exact_loop.curve.push_back(curve);
        const double step = piece.angle / n, start = piece.start + angle + i * step;
        exact_loop.parameters.push_back({start, start + step});
      }
    }
  }
  return region;
}

double distance_to_outline(const Domain& domain, double angle, Vec2 p) {
  const Vec2 q = turned(p, -angle);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& loop : domain.loops)
    for (const Piece& piece : loop) least = std::min(least, piece.distance_to(q));
  return least;
}

}  // namespace beadmesh::bench
