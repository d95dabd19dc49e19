#include "beadmesh/medial/medial_query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace beadmesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Index leaf_size = 4;

/// A straight piece of the axis between two neighbouring points, or an isolated vertex (a == b).
struct Piece {
  Vec2 a, b;
  double radius_a, radius_b;
  double start, end;  ///< arc length along the edge
  Index edge, vertex;

  Vec2 point(double t) const { return lerp(a, b, t); }
  double radius(double t) const { return radius_a + (radius_b - radius_a) * t; }
  AxisPlace place(double t) const { return {edge, start + (end - start) * t, vertex, point(t), radius(t)}; }
  double nearest(Vec2 p) const {
    const double length = squared_norm(b - a);
    return length > 0 ? std::clamp(dot(p - a, b - a) / length, 0.0, 1.0) : 0;
  }
};

struct Node {
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};  ///< of the centres
  double largest = 0;                                        ///< radius
  Index begin = 0, end = 0;                                  ///< pieces
  Index child = no_index;                                    ///< of two in a row; no_index: a leaf

  double gap(Vec2 p) const {
    return norm(Vec2{std::max({low.x - p.x, 0.0, p.x - high.x}), std::max({low.y - p.y, 0.0, p.y - high.y})});
  }
};

/// Parameter of the largest disc of the piece that holds p; negative where none does.
double largest_holding(const Piece& piece, Vec2 p) {
  const Vec2 d = piece.b - piece.a, q = piece.a - p;
  const double growth = piece.radius_b - piece.radius_a;
  const auto holds = [&](double t) { return distance(piece.point(t), p) <= piece.radius(t); };
  const double best = growth >= 0 ? 1 : 0;
  if (holds(best)) return best;
  // |q + t d|^2 = (radius_a + t growth)^2: of its roots within the piece the one with the largest disc.
  const double a = dot(d, d) - growth * growth, b = dot(q, d) - piece.radius_a * growth,
               c = dot(q, q) - piece.radius_a * piece.radius_a;
  double found = holds(1 - best) ? 1 - best : -1;
  const auto consider = [&](double t) {
    if (t >= 0 && t <= 1 && (found < 0 || piece.radius(t) > piece.radius(found))) found = t;
  };
  const double root = b * b - a * c;
  if (a == 0) {
    if (b != 0) consider(-c / (2 * b));
  } else if (root >= 0) {
    const double far = -(b + std::copysign(std::sqrt(root), b));
    consider(far / a);
    if (far != 0) consider(c / far);
  }
  return found;
}

/// Parameter at which p lies least far outside the disc.
double least_outside(const Piece& piece, Vec2 p) {
  const auto outside = [&](double t) { return distance(piece.point(t), p) - piece.radius(t); };
  double low = 0, high = 1;  // a convex function: golden section
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 60; ++i) {
    const double s = high - golden * (high - low), t = low + golden * (high - low);
    (outside(s) <= outside(t) ? high : low) = outside(s) <= outside(t) ? t : s;
  }
  double best = (low + high) / 2;
  for (const double t : {0.0, 1.0})
    if (outside(t) < outside(best)) best = t;
  return best;
}

}  // namespace

/// A tree of boxes over the pieces, each node split at the middle of its wider side.
class MedialQuery::Tree {
 public:
  explicit Tree(const MedialObject& object) {
    for (Index e = 0; e < static_cast<Index>(object.edges.size()); ++e) add_edge(object.edges[e], e);
    for (Index v = 0; v < static_cast<Index>(object.vertices.size()); ++v) {
      const MedialVertex& vertex = object.vertices[v];
      if (vertex.edges.empty())
        pieces_.push_back({vertex.point, vertex.point, vertex.radius, vertex.radius, 0, 0, no_index, v});
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) order_.push_back(static_cast<Index>(i));
    if (!pieces_.empty()) build();
  }

  std::optional<NearestAxis> nearest(Vec2 p) const {
    const auto [piece, gap] = least(
        p, [&](const Node& node) { return node.gap(p); },
        [&](const Piece& at) { return distance(at.point(at.nearest(p)), p); });
    if (!piece) return std::nullopt;
    return NearestAxis{piece->place(piece->nearest(p)), gap};
  }

  std::optional<LocalThickness> thickness_at(Vec2 p) const {
    const auto [disc, size] = least(
        p, [&](const Node& node) { return node.gap(p) <= node.largest ? -node.largest : infinity; },
        [&](const Piece& at) {
          const double t = largest_holding(at, p);
          return t < 0 ? infinity : -at.radius(t);
        });
    if (disc) return LocalThickness{-2 * size, disc->place(largest_holding(*disc, p)), 0};
    const auto [near, outside] = least(
        p, [&](const Node& node) { return node.gap(p) - node.largest; },
        [&](const Piece& at) {
          const double t = least_outside(at, p);
          return distance(at.point(t), p) - at.radius(t);
        });
    if (!near) return std::nullopt;
    const AxisPlace place = near->place(least_outside(*near, p));
    return LocalThickness{2 * place.radius, place, std::max(outside, 0.0)};
  }

 private:
  void add_edge(const MedialEdge& edge, Index number) {
    const std::size_t count = edge.points.size();
    const std::size_t pieces = edge.type == MedialEdgeType::N ? count : count - (count > 0);
    double along = 0;
    for (std::size_t i = 0; i < pieces; ++i) {
      const MedialPoint &a = edge.points[i], &b = edge.points[(i + 1) % count];
      const double end = along + distance(a.point, b.point);
      pieces_.push_back({a.point, b.point, a.radius, b.radius, along, end, number, no_index});
      along = end;
    }
  }

  void build() {
    nodes_.push_back({});
    nodes_[0].end = static_cast<Index>(pieces_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) split(i);
  }

  void split(std::size_t i) {
    Node& node = nodes_[i];
    for (Index k = node.begin; k < node.end; ++k) {
      const Piece& piece = pieces_[order_[k]];
      for (const Vec2 p : {piece.a, piece.b}) {
        node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
        node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
      }
      node.largest = std::max({node.largest, piece.radius_a, piece.radius_b});
    }
    if (node.end - node.begin <= leaf_size) return;
    const bool wide = node.high.x - node.low.x >= node.high.y - node.low.y;
    const auto key = [&](Index k) {
      const Vec2 sum = pieces_[k].a + pieces_[k].b;
      return std::pair{wide ? sum.x : sum.y, k};
    };
    const Index begin = node.begin, end = node.end, middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](Index a, Index b) { return key(a) < key(b); });
    node.child = static_cast<Index>(nodes_.size());
    nodes_.push_back({}), nodes_.push_back({});  // `node` is no longer valid
    Node &left = nodes_[nodes_.size() - 2], &right = nodes_.back();
    left.begin = begin, left.end = right.begin = middle, right.end = end;
  }

  /// The piece with the least cost and that cost; `bound`: no piece of the node costs less. Of equals the
  /// first.
  template <class Bound, class Cost>
  std::pair<const Piece*, double> least(Vec2 p, Bound bound, Cost cost) const {
    if (nodes_.empty() || !std::isfinite(p.x) || !std::isfinite(p.y)) return {nullptr, infinity};
    Index best = no_index;
    double least = infinity;
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.push({bound(nodes_[0]), 0});
    while (!open.empty() && open.top().first <= least) {
      const auto [reach, index] = open.top();
      open.pop();
      if (reach == infinity) break;
      const Node& node = nodes_[index];
      if (node.child == no_index) {
        for (Index k = node.begin; k < node.end; ++k) {
          const double value = cost(pieces_[order_[k]]);
          if (value < least || (value == least && value < infinity && order_[k] < best))
            least = value, best = order_[k];
        }
        continue;
      }
      for (const Index child : {node.child, node.child + 1}) {
        const double value = bound(nodes_[child]);
        if (value <= least) open.push({value, child});
      }
    }
    return {best == no_index ? nullptr : &pieces_[best], least};
  }

  std::vector<Piece> pieces_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

MedialQuery::MedialQuery(const MedialObject& object) : tree_(std::make_unique<Tree>(object)) {}
MedialQuery::~MedialQuery() = default;
MedialQuery::MedialQuery(MedialQuery&&) noexcept = default;

std::optional<NearestAxis> MedialQuery::nearest(Vec2 p) const {
  return tree_->nearest(p);
}

std::optional<LocalThickness> MedialQuery::thickness_at(Vec2 p) const {
  return tree_->thickness_at(p);
}

}  // namespace beadmesh
