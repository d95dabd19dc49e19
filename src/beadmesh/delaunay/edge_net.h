// A planar net of directed edges on which triangulations are built: every edge knows its origin and its
// neighbours around that origin. Internal to this room. Based on: Guibas, Stolfi, "Primitives for the
// Manipulation of General Subdivisions", 1985 (without the dual edges).
#pragma once

#include <cstdint>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh::delaunay {

/// Edge e goes from origin(e) to destination(e); reversed(e) goes back. The two share e / 2. Vertices are
/// indices into `points`.
class EdgeNet {
 public:
  struct Edge {
    Index origin = no_index;  ///< no_index: the edge is deleted
    Index next = 0;           ///< counter-clockwise around the origin
    Index previous = 0;       ///< clockwise around the origin
    Index face = no_index;    ///< for the owner's use: the face on the left
  };

  static Index reversed(Index e) { return e ^ 1; }
  Index origin(Index e) const { return edges_[e].origin; }
  Index destination(Index e) const { return edges_[e ^ 1].origin; }
  Index next_around(Index e) const { return edges_[e].next; }
  Index previous_around(Index e) const { return edges_[e].previous; }
  /// The edge after e along the face on its left.
  Index next_of_face(Index e) const { return edges_[e ^ 1].previous; }
  Vec2 from(Index e) const { return points[edges_[e].origin]; }
  Vec2 to(Index e) const { return points[edges_[e ^ 1].origin]; }
  Index& face(Index e) { return edges_[e].face; }
  Index face(Index e) const { return edges_[e].face; }
  bool is_alive(Index e) const { return edges_[e].origin != no_index; }
  /// Directed edges, deleted ones included.
  Index size() const { return static_cast<Index>(edges_.size()); }
  void reserve(std::size_t directed_edges) { edges_.reserve(directed_edges); }

  /// An edge on its own: both ends are alone around their origins.
  Index add(Index origin, Index destination) {
    Index e = free_;
    if (e == no_index) {
      e = size();
      edges_.resize(edges_.size() + 2);
    } else {
      free_ = edges_[e].next;
    }
    edges_[e] = {origin, e, e, no_index};
    edges_[e + 1] = {destination, e + 1, e + 1, no_index};
    return e;
  }
  /// Puts the lone end e behind b, counter-clockwise around their common origin.
  void attach(Index e, Index b) {
    const Index after = edges_[b].next;
    edges_[e].next = after;
    edges_[e].previous = b;
    edges_[after].previous = e;
    edges_[b].next = e;
  }
  /// A new edge from the end of a to the start of b, both with the same face on the left; a's end of it keeps
  /// a on its left.
  Index connect(Index a, Index b) {
    const Index e = add(destination(a), origin(b));
    attach(e, next_of_face(a));
    attach(e ^ 1, b);
    return e;
  }
  void remove(Index e) {
    detach(e);
    detach(e ^ 1);
    const Index even = e & ~1;
    edges_[even].origin = edges_[even + 1].origin = no_index;
    edges_[even].next = free_;
    free_ = even;
  }

  std::vector<Vec2> points;

 private:
  void detach(Index e) {
    const Index next = edges_[e].next, previous = edges_[e].previous;
    edges_[next].previous = previous;
    edges_[previous].next = next;
  }

  std::vector<Edge> edges_;
  Index free_ = no_index;
};

}  // namespace beadmesh::delaunay
