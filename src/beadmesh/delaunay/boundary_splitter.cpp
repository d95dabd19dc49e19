#include "beadmesh/delaunay/boundary_splitter.h"

#include <utility>

#include "beadmesh/geometry/predicates.h"

namespace beadmesh {

BoundarySplitter::BoundarySplitter(BoundarySamples samples, Triangulation triangulation)
    : samples_(std::move(samples)), triangulation_(std::move(triangulation)) {
  const Index n = count();
  next_.resize(n);
  previous_.resize(n);
  for (Index i = 0; i < n; ++i) {
    next_[i] = next_sample(samples_, i);
    previous_[next_[i]] = i;
  }
  half_edge_.assign(n, no_index);
  for (std::size_t t = 0; t < triangulation_.triangles.size(); ++t)
    for (Index h = 3 * static_cast<Index>(t), k = 0; k < 3; ++k, ++h)
      if (triangulation_.neighbours[t][k] == no_index) half_edge_[start(h)] = h;
}

Index BoundarySplitter::apex(Index edge) const {
  return corner(half_edge_[edge]);
}

bool BoundarySplitter::fits(Vec2 p, Index edge) const {
  const Vec2 a = triangulation_.points[edge], b = triangulation_.points[next_[edge]],
             c = triangulation_.points[apex(edge)];
  return orient2d(a, p, c) > 0 && orient2d(p, b, c) > 0;
}

Index BoundarySplitter::split(Index edge, const BoundarySample& added, Vec2 on_chord,
                              std::vector<Index>& touched) {
  BoundarySample sample = added;
  if (!is_in_exact_range(sample.point) || !fits(sample.point, edge)) {
    sample.point = on_chord;
    if (!fits(on_chord, edge)) return no_index;
  }
  const Index b = next_[edge], made = count();
  samples_.samples.push_back(sample);
  triangulation_.points.push_back(sample.point);
  next_.push_back(b);
  previous_.push_back(edge);
  next_[edge] = previous_[b] = made;

  // (apex, edge, b) becomes (apex, edge, made) and (apex, made, b).
  const Index h = half_edge_[edge], t = h / 3, c = corner(h);
  const Index after =
      triangulation_.neighbours[t][(h % 3 + 1) % 3];  // opposite of the edge's start: b to apex
  const Index before = triangulation_.neighbours[t][(h % 3 + 2) % 3];  // apex to the edge's start
  const auto t2 = static_cast<Index>(triangulation_.triangles.size());
  triangulation_.triangles[t] = {c, edge, made};
  triangulation_.neighbours[t] = {no_index, t2, before};
  triangulation_.triangles.push_back({c, made, b});
  triangulation_.neighbours.push_back({no_index, after, t});
  half_edge_[edge] = 3 * t;
  half_edge_.push_back(3 * t2);
  touched.push_back(edge);
  touched.push_back(made);
  if (before == no_index) {
    half_edge_[c] = 3 * t + 2;
    touched.push_back(c);
  }
  if (after == no_index) {
    half_edge_[b] = 3 * t2 + 1;
    touched.push_back(b);
  } else {
    for (Index& neighbour : triangulation_.neighbours[after])
      if (neighbour == t) neighbour = t2;
  }
  pending_ = {3 * t2 + 1, 3 * t + 2, 3 * t + 1};  // the edge to the apex first: a point far out is an ear
  while (!pending_.empty()) {
    const Index next = pending_.back();
    pending_.pop_back();
    legalise(next, touched);
  }
  return made;
}

Index BoundarySplitter::opposite(Index half_edge) const {
  const Index t = half_edge / 3, other = triangulation_.neighbours[t][half_edge % 3];
  if (other == no_index) return no_index;
  // The half-edge that starts where this one ends: two triangles may share two edges of different ends only.
  const Index end = triangulation_.triangles[t][(half_edge % 3 + 2) % 3];
  for (Index h = 3 * other; h < 3 * other + 3; ++h)
    if (start(h) == end && triangulation_.neighbours[other][h % 3] == t) return h;
  return no_index;
}

// Flips the half-edge where it is not locally Delaunay; then those beyond it are to be looked at.
void BoundarySplitter::legalise(Index half_edge, std::vector<Index>& touched) {
  const Index other = opposite(half_edge);
  if (other == no_index) return;
  const Triangle& corners = triangulation_.triangles[half_edge / 3];
  const auto point = [&](Index i) { return triangulation_.points[i]; };
  if (!(incircle(point(corners[0]), point(corners[1]), point(corners[2]), point(corner(other))) > 0)) return;
  flip(half_edge, other);
  for (const Index t : {half_edge / 3, other / 3}) {
    pending_.push_back(3 * t);
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      if (triangulation_.neighbours[t][h % 3] == no_index) touched.push_back(start(h));
  }
}

// p opposite of the edge (a, b), q beyond it: (p, a, b), (q, b, a) become (p, a, q), (p, q, b).
void BoundarySplitter::flip(Index half_edge, Index other) {
  const Index t = half_edge / 3, u = other / 3, k = half_edge % 3, j = other % 3;
  const Triangle in = triangulation_.triangles[t], beyond = triangulation_.triangles[u];
  const Index p = in[k], a = in[(k + 1) % 3], b = in[(k + 2) % 3], q = beyond[j];
  const Index over_pb = triangulation_.neighbours[t][(k + 1) % 3],
              over_pa = triangulation_.neighbours[t][(k + 2) % 3];
  const Index over_qa = triangulation_.neighbours[u][(j + 1) % 3],
              over_qb = triangulation_.neighbours[u][(j + 2) % 3];
  triangulation_.triangles[t] = {p, a, q};
  triangulation_.neighbours[t] = {over_qa, u, over_pa};
  triangulation_.triangles[u] = {p, q, b};
  triangulation_.neighbours[u] = {over_qb, over_pb, t};
  const auto relink = [&](Index neighbour, Index from, Index to, Index starts, Index half) {
    if (neighbour == no_index) {
      half_edge_[starts] = half;
      return;
    }
    // A neighbour on two sides keeps its other side: the one whose corners fit is changed.
    for (int s = 0; s < 3; ++s)
      if (triangulation_.neighbours[neighbour][s] == from &&
          triangulation_.triangles[neighbour][(s + 2) % 3] == starts)
        triangulation_.neighbours[neighbour][s] = to;
  };
  relink(over_qa, u, t, a, 3 * t);
  relink(over_pa, t, t, p, 3 * t + 2);
  relink(over_qb, u, u, q, 3 * u);
  relink(over_pb, t, u, b, 3 * u + 1);
}

void BoundarySplitter::finish(BoundarySamples& samples, Triangulation& triangulation) {
  if (count() == given()) {
    samples = std::move(samples_);
    triangulation = std::move(triangulation_);
    return;
  }
  std::vector<Index> place(count());
  samples.samples.clear();
  samples.samples.reserve(count());
  samples.first.clear();
  for (std::size_t l = 0; l + 1 < samples_.first.size(); ++l) {
    samples.first.push_back(static_cast<Index>(samples.samples.size()));
    const Index first = samples_.first[l];
    Index i = first;
    do {
      place[i] = static_cast<Index>(samples.samples.size());
      samples.samples.push_back(samples_.samples[i]);
      i = next_[i];
    } while (i != first);
  }
  samples.first.push_back(count());
  triangulation = std::move(triangulation_);
  for (Triangle& corners : triangulation.triangles)
    for (Index& i : corners) i = place[i];
  for (Index i = 0; i < count(); ++i) triangulation.points[place[i]] = samples_.samples[i].point;
  samples_ = {};
}

}  // namespace beadmesh
