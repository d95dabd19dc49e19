#include "beadmesh/delaunay/loop_division.h"

#include <algorithm>
#include <cmath>

namespace beadmesh::delaunay {
namespace {

constexpr double rounding = 1e-9;  // relative; so that a length of exactly n sizes makes n pieces
constexpr double least_peel =
    2.5;  // sizes that a segment must be long for one of them to be cut off at its corner
constexpr double facet_leniency = 2.0;  // how many times longer than asked for a facet may be
constexpr double line_to_facet = 4.0;  // a segment so many times longer than the next one is a line, no facet

bool turns_sharply(Vec2 before, Vec2 at, Vec2 after) {
  return angle_between(at - before, after - at) > corner_turn;
}

}  // namespace

LoopDivision::LoopDivision(const PlanarLoop& loop, Index number, const SamplingOptions& options, double least)
    : number_(number),
      grading_(std::max(options.grading, 1.1)),
      growth_(0.5 * std::log(grading_)),
      least_(least) {
  read(loop);
  if (options.facetted) mark_facets(!loop.curve.empty());
  number_pieces();
  start_undivided();
  std::vector<double> piece_length(pieces_, 0);
  for (const Given& g : given_) piece_length[g.piece] += g.length;
  for (std::size_t i = 0; i < given_.size(); ++i) {
    if (options.spacing > 0) limit(i, options.spacing);
    if (options.min_segments > 1) limit(i, piece_length[given_[i].piece] / options.min_segments);
  }
}

void LoopDivision::read(const PlanarLoop& loop) {
  const std::size_t n = loop.points.size();
  given_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = loop.points[i], next = loop.points[(i + 1) % n];
    const bool corner =
        loop.corner.empty() ? turns_sharply(loop.points[(i + n - 1) % n], p, next) : bool(loop.corner[i]);
    given_[i] = {p, length_, distance(p, next), corner, false, loop.curve.empty() ? 0 : loop.curve[i], 0};
    length_ += given_[i].length;
  }
}

// A curve of several segments is curved; without curves, segments of about the same length that join smoothly
// are facets.
void LoopDivision::mark_facets(bool has_curves) {
  const std::size_t n = given_.size();
  for (std::size_t i = 0; i < n && has_curves; ++i)
    given_[i].facet = (!given_[i].corner && given_before(i).curve == given_[i].curve) ||
                      (!given_after(i).corner && given_after(i).curve == given_[i].curve);
  for (std::size_t i = 0; i < n && !has_curves; ++i) {
    const auto smooth_beside = [&](const Given& end, const Given& next) {
      return !end.corner && given_[i].length < line_to_facet * next.length;
    };
    given_[i].facet =
        smooth_beside(given_[i], given_before(i)) || smooth_beside(given_after(i), given_after(i));
  }
}

// Pieces run from corner to corner; the first given points belong to the last piece unless a corner starts
// them.
void LoopDivision::number_pieces() {
  Index piece = -1;
  for (Given& g : given_) g.piece = g.corner ? ++piece : piece;
  pieces_ = std::max(piece + 1, 1);
  for (Given& g : given_)
    if (g.piece < 0) g.piece = pieces_ - 1;
}

void LoopDivision::start_undivided() {
  for (std::size_t g = 0; g < given_.size(); ++g) {
    samples_.push_back({given_[g].point, number_, given_[g].position, given_[g].corner, given_[g].curve});
    given_of_.push_back(g);
    size_.push_back(given_[g].length);
  }
}

bool LoopDivision::limit_by_neighbours() {
  bool any = false;
  for (std::size_t i = 0; i < size(); ++i) {
    const double least = std::min(segment_length(before(i)), segment_length(after(i)));
    if (segment_length(i) <= grading_ * least * (1 + rounding) || given_[given_of_[i]].facet) continue;
    limit(i, grading_ * least * (1 - rounding));
    any = true;
  }
  return any;
}

double LoopDivision::prepare() {
  smooth_sizes();
  share_sizes_at_corners();
  double count = 0;
  for (std::size_t i = 0; i < size(); ++i) count += segment_length(i) / size_[i] + 1;
  return count;
}

// Sizes grow no faster than `growth_` along the loop, in both directions; twice round, since it is closed.
void LoopDivision::smooth_sizes() {
  const std::size_t n = size();
  const auto pull = [&](std::size_t i, std::size_t from) {
    size_[i] = std::min(size_[i], size_[from] + growth_ * (segment_length(i) + segment_length(from)) / 2);
  };
  for (std::size_t k = 0; k < 2 * n; ++k) pull(k % n, before(k % n));
  for (std::size_t k = 2 * n; k-- > 0;) pull(k % n, after(k % n));
}

// Both segments at a corner get one size with which both given segments can start: all of it, half of it, or
// little of it.
void LoopDivision::share_sizes_at_corners() {
  for (std::size_t i = 0; i < size(); ++i) {
    if (!samples_[i].corner) continue;
    const std::size_t j = before(i);
    double common = std::min(size_[i], size_[j]);
    for (int round = 0; round < 4; ++round)
      for (const std::size_t side : {i, j}) {
        const double whole = given_[given_of_[side]].length;
        if (whole < least_peel * common) common = whole / std::ceil(whole / common - rounding);
      }
    size_[i] = size_[j] = common;
  }
}

// The integral of 1 / size over part of a given segment whose samples are [first, end).
double LoopDivision::pieces_wanted(double from, double to, std::size_t first, std::size_t end) const {
  double sum = 0;
  for (std::size_t i = first; i < end; ++i) {
    const double overlap = std::min(end_of(i), to) - std::max(samples_[i].position, from);
    if (overlap > 0) sum += overlap / size_[i];
  }
  return sum;
}

// Cuts between the two positions so that every part has the same integral of 1 / size.
void LoopDivision::cut_evenly(double from, double to, std::size_t first, std::size_t end, double leniency,
                              std::vector<double>& cuts) const {
  const double wanted = pieces_wanted(from, to, first, end);
  const double parts = std::max(1.0, std::ceil(wanted / leniency * (1 - rounding) - rounding));
  double sum = 0, k = 1;
  for (std::size_t i = first; i < end && k < parts; ++i) {
    const double start = std::max(samples_[i].position, from), stop = std::min(end_of(i), to);
    if (stop <= start) continue;
    const double share = (stop - start) / size_[i];
    for (; k < parts && wanted * k / parts <= sum + share; ++k)
      cuts.push_back(start + (wanted * k / parts - sum) * size_[i]);
    sum += share;
  }
}

void LoopDivision::divide_segment(std::size_t g, std::size_t first, std::size_t end,
                                  std::vector<double>& cuts) const {
  const Given& given = given_[g];
  double from = given.position, to = given.position + given.length;
  const double wanted = pieces_wanted(from, to, first, end);
  const double leniency = given.facet ? facet_leniency : 1;
  if (wanted <= leniency * (1 + rounding)) return;
  const double head = given.corner && !given.facet ? size_[first] : 0;
  const double tail = given_after(g).corner && !given.facet ? size_[end - 1] : 0;
  const bool peel = head + tail <= given.length * (1 - 1 / least_peel);
  if (peel && head > 0) cuts.push_back(from += head);
  if (peel) to -= tail;
  cut_evenly(from, to, first, end, leniency, cuts);
  if (peel && tail > 0) cuts.push_back(to);
}

bool LoopDivision::divide() {
  std::vector<BoundarySample> samples;
  std::vector<std::size_t> given_of;
  std::vector<double> sizes, cuts;
  for (std::size_t g = 0, first = 0, end; g < given_.size(); ++g, first = end) {
    for (end = first; end < size() && given_of_[end] == g;) ++end;
    const Given& given = given_[g];
    cuts.assign(1, given.position);
    divide_segment(g, first, end, cuts);
    std::size_t old = first;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      const double stop = k + 1 < cuts.size() ? cuts[k + 1] : given.position + given.length;
      const double t = (cuts[k] - given.position) / given.length;
      const Vec2 point = k == 0 ? given.point : lerp(given.point, given_after(g).point, t);
      samples.push_back({point, number_, cuts[k], k == 0 && given.corner, given.curve});
      given_of.push_back(g);
      while (old + 1 < end && end_of(old) < (cuts[k] + stop) / 2) ++old;
      sizes.push_back(size_[old]);
    }
  }
  const bool grew = samples.size() > samples_.size();
  samples_ = std::move(samples);
  given_of_ = std::move(given_of);
  size_ = std::move(sizes);
  return grew;
}

}  // namespace beadmesh::delaunay
