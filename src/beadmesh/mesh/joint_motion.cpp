#include "beadmesh/mesh/joint_motion.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/element_zone.h"
#include "beadmesh/mesh/node_motion.h"

namespace beadmesh {
namespace {

constexpr int rings = 2;
constexpr int most_steps = 40;

/// Limits of the criteria that all presets share, and what is aimed at to keep clear of them.
constexpr double most_warpage = radians(15), aimed_warpage = radians(14.6);
constexpr double least_evenness = 0.6, aimed_evenness = 0.607;
constexpr double longest_side = 2, aimed_side = 1.96;  ///< sizes
constexpr double sharpest = radians(40), flattest = radians(140);
/// What costs 1 when it is missed by so much: warpage, evenness, scaled Jacobian, a length as a share of its
/// limit, a distance from the surface as a share of the size.
constexpr double warpage_scale = radians(4), evenness_scale = 0.06, shape_scale = 0.03, length_scale = 0.02,
                 distance_scale = 0.03;
/// Holds nodes that nobody wants elsewhere: cost of a move by the size.
constexpr double inertia = 0.05;
constexpr double softness = 0.3;
/// Elements that miss a limit by more of these units are beyond help by movements.
constexpr double hopeless = 5;

/// Warpage by both diagonals, evenness, four shapes, four lengths, five distances.
constexpr int terms_of_element = 16;
using Terms = std::array<double, terms_of_element>;

/// A coordinate of the zone: a free node's x or y, a sliding node's arc length.
struct Variable {
  Index node;
  int axis;  ///< 0, 1; 2: along the line
};

/// What is missed of a limit; begins softly before it, so that steps see it coming.
double above(double value, double limit, double scale) {
  const double over = (value - limit) / scale;
  return (over + std::sqrt(over * over + softness * softness)) / 2;
}

/// Measures of one quad or triangle in space.
struct Measures {
  std::array<double, 2> warpage{};
  double evenness = 1;
  std::array<double, 4> shape{1, 1, 1, 1}, side{};
  double sharpest = 4, flattest = 0;
};

class JointMotion {
 public:
  JointMotion(SurfaceNodes& nodes, const QuadConnectivity& mesh, const std::vector<NodeFreedom>& freedom,
              SlidingLines& lines, const JointMotionOptions& options)
      : nodes_(nodes), mesh_(mesh), freedom_(freedom), lines_(lines), options_(options) {}

  int run() {
    int mended = 0;
    // What failed beside an element in vain would be tried with nearly the same nodes again.
    std::vector<bool> in_vain(mesh_.element_count(), false);
    for (Index e = 0; e < mesh_.element_count(); ++e) {
      if (!mesh_.is_alive(e) || in_vain[e] || !fails(e)) continue;
      const int now = mend(e);
      mended += now;
      if (now == 0)
        for (const Index near : elements_within(mesh_, e, 1)) in_vain[near] = true;
    }
    return mended;
  }

 private:
  Measures measures(Index e) const {
    const MeshElement& element = mesh_.element(e);
    const int count = corner_count(element);
    Measures out;
    std::array<Vec3, 4> side, corner;
    for (int i = 0; i < count; ++i) {
      side[i] = nodes_.space(element[(i + 1) % count]) - nodes_.space(element[i]);
      out.side[i] = norm(side[i]);
    }
    const Vec3 normal =
        normalized(count == 4 ? cross(side[0] + side[1], side[1] + side[2]) : cross(side[0], side[1]));
    const double scale = count == 4 ? 1 : 2 / std::sqrt(3.0);
    std::array<double, 4> area{};
    for (int i = 0; i < count; ++i) {
      const int before = (i + count - 1) % count;
      corner[i] = cross(side[before], side[i]);
      area[i] = dot(corner[i], normal);
      const double lengths = out.side[i] * out.side[before];
      out.shape[i] = lengths > 0 ? scale * area[i] / lengths : 0;
      const double angle = pi - angle_between(side[before], side[i]);
      out.sharpest = std::min(out.sharpest, angle), out.flattest = std::max(out.flattest, angle);
    }
    if (count < 4) return out;
    out.evenness = jacobian_ratio(area);
    out.warpage = {angle_between(corner[0], corner[2]), angle_between(corner[1], corner[3])};
    return out;
  }

  bool is_turned_over(Index e) const { return signed_quality(nodes_, mesh_.element(e)) <= 0; }

  bool fails(Index e) const {
    const Measures m = measures(e);
    return std::max(m.warpage[0], m.warpage[1]) > most_warpage || m.evenness < least_evenness ||
           *std::max_element(m.side.begin(), m.side.end()) > longest_side * options_.size ||
           m.sharpest < sharpest || m.flattest > flattest;
  }

  /// Distances from the surface: of the sides at their middles, and of the centre. Along the normal, as
  /// places in the plane are only near the nearest ones.
  std::array<double, 5> distances(Index e) const {
    const MeshElement& element = mesh_.element(e);
    const int count = corner_count(element);
    Vec2 flat_sum;
    Vec3 sum;
    for (int i = 0; i < count; ++i) flat_sum += nodes_.flat(element[i]), sum += nodes_.space(element[i]);
    const Vec3 a = nodes_.space(element[0]), b = nodes_.space(element[1]), c = nodes_.space(element[2]);
    const Vec3 normal =
        normalized(count == 4 ? cross(c - a, nodes_.space(element[3]) - b) : cross(b - a, c - a));
    const auto off = [&](Vec2 flat, Vec3 space, Index hint) {
      return std::abs(dot(nodes_.place(flat, hint).space - space, normal));
    };
    std::array<double, 5> out{};
    for (int i = 0; i < count; ++i) {
      const Index p = element[i], q = element[(i + 1) % count];
      out[i] = off((nodes_.flat(p) + nodes_.flat(q)) / 2, (nodes_.space(p) + nodes_.space(q)) / 2,
                   nodes_[p].triangle);
    }
    out[4] = off(flat_sum / count, sum / count, nodes_[element[0]].triangle);
    return out;
  }

  bool is_crest(const MeshElement& element, int side) const {
    return lines_.on_crest(element[side]) && lines_.on_crest(element[(side + 1) % corner_count(element)]);
  }

  /// What is allowed in a zone: the limits, or what there is already.
  struct Allowance {
    double shape, shortest, deviation, crest;
  };

  struct Standing {
    int failing = 0;
    bool turned_over = false;
    double shape = 1, shortest = 1e300, deviation = 0, crest = 0;
  };

  Standing standing(const std::vector<Index>& zone) const {
    Standing out;
    for (const Index e : zone) {
      const MeshElement& element = mesh_.element(e);
      const Measures m = measures(e);
      out.failing += fails(e);
      out.turned_over |= is_turned_over(e);
      const std::array<double, 5> off = distances(e);
      for (int i = 0; i < corner_count(element); ++i) {
        out.shape = std::min(out.shape, m.shape[i]);
        out.shortest = std::min(out.shortest, m.side[i]);
        double& worst = is_crest(element, i) ? out.crest : out.deviation;
        worst = std::max(worst, off[i]);
      }
      out.deviation = std::max(out.deviation, off[4]);
    }
    return out;
  }

  Terms terms(Index e, const Allowance& allowed) const {
    const MeshElement& element = mesh_.element(e);
    const int count = corner_count(element);
    const Measures m = measures(e);
    Terms out{};
    for (int k = 0; k < 2; ++k) out[k] = above(m.warpage[k], aimed_warpage, warpage_scale);
    out[2] = above(aimed_evenness, m.evenness, evenness_scale);
    const std::array<double, 5> off = distances(e);
    for (int i = 0; i < count; ++i) {
      out[3 + i] = above(allowed.shape, m.shape[i], shape_scale);
      out[7 + i] = above(allowed.shortest, m.side[i], length_scale * allowed.shortest) +
                   above(m.side[i], aimed_side * options_.size, length_scale * options_.size);
      out[11 + i] = is_crest(element, i) ? above(off[i], allowed.crest, 0.1 * distance_scale * options_.size)
                                         : above(off[i], allowed.deviation, distance_scale * options_.size);
    }
    out[15] = above(off[4], allowed.deviation, distance_scale * options_.size);
    return out;
  }

  /// The node next to a tip stays on the edge of the dome: further in, the last edge would cut that corner.
  bool is_movable(Index node) const {
    return freedom_[node] == NodeFreedom::free ||
           (freedom_[node] == NodeFreedom::sliding && lines_.slides(node) && !lines_.next_to_tip(node));
  }

  /// Everything that one step needs to know.
  struct Zone {
    std::vector<Variable> variables;
    std::vector<Index> elements;                   ///< all around the moving nodes, ascending
    std::vector<std::vector<Index>> variables_of;  ///< per element of the zone
  };

  Zone zone_around(Index e) const {
    std::set<Index> moving, around;
    for (const Index near : elements_within(mesh_, e, rings))
      for (int i = 0; i < corner_count(mesh_.element(near)); ++i)
        if (is_movable(mesh_.element(near)[i])) moving.insert(mesh_.element(near)[i]);
    Zone zone;
    for (const Index node : moving) {
      around.insert(mesh_.star(node).begin(), mesh_.star(node).end());
      if (freedom_[node] == NodeFreedom::free)
        zone.variables.insert(zone.variables.end(), {{node, 0}, {node, 1}});
      else
        zone.variables.push_back({node, 2});
    }
    zone.elements.assign(around.begin(), around.end());
    zone.variables_of.resize(zone.elements.size());
    for (size_t k = 0; k < zone.elements.size(); ++k) {
      const MeshElement& element = mesh_.element(zone.elements[k]);
      for (Index v = 0; v < Index(zone.variables.size()); ++v)
        if (std::find(element.begin(), element.end(), zone.variables[v].node) != element.end())
          zone.variables_of[k].push_back(v);
    }
    return zone;
  }

  /// Puts a node where its variables say, counted from its place at the start.
  void put(const Zone& zone, const Eigen::VectorXd& x, Index v, const std::vector<SurfacePlace>& start) {
    const Variable& first = zone.variables[v];
    const SurfacePlace& from = start[v];
    const Vec2 to = first.axis == 2 ? lines_.shifted(first.node, x[v]) : from.flat + Vec2{x[v], x[v + 1]};
    nodes_.set(first.node, nodes_.place(to, nodes_[first.node].triangle));
  }

  void put_all(const Zone& zone, const Eigen::VectorXd& x, const std::vector<SurfacePlace>& start) {
    for (Index v = 0; v < Index(zone.variables.size()); ++v)
      if (zone.variables[v].axis != 1) put(zone, x, v, start);
  }

  std::vector<Terms> all_terms(const Zone& zone, const Allowance& allowed) const {
    std::vector<Terms> out;
    for (const Index e : zone.elements) out.push_back(terms(e, allowed));
    return out;
  }

  static double missed(const std::vector<Terms>& all) {
    double sum = 0;
    for (const Terms& one : all)
      for (const double t : one) sum += t * t;
    return sum;
  }

  double cost(const std::vector<Terms>& all, const Eigen::VectorXd& x) const {
    return missed(all) + x.squaredNorm() * inertia * inertia / (options_.size * options_.size);
  }

  /// Gradient and Gauss-Newton matrix at x, by differences.
  void linearise(const Zone& zone, Eigen::VectorXd& x, const std::vector<SurfacePlace>& start,
                 const Allowance& allowed, const std::vector<Terms>& now, Eigen::VectorXd& gradient,
                 Eigen::MatrixXd& matrix) {
    const double h = 2e-3 * options_.size, hold = inertia * inertia / (options_.size * options_.size);
    const Index n = Index(zone.variables.size());
    std::vector<std::vector<Terms>> slopes(zone.elements.size());
    for (size_t k = 0; k < zone.elements.size(); ++k) slopes[k].resize(zone.variables_of[k].size());
    for (Index v = 0; v < n; ++v) {
      const Index first = zone.variables[v].axis == 1 ? v - 1 : v;
      const SurfacePlace before = nodes_[zone.variables[v].node];
      x[v] += h;
      put(zone, x, first, start);
      x[v] -= h;
      for (size_t k = 0; k < zone.elements.size(); ++k) {
        const auto& of = zone.variables_of[k];
        const auto at = std::lower_bound(of.begin(), of.end(), v);
        if (at == of.end() || *at != v) continue;
        Terms& slope = slopes[k][at - of.begin()];
        slope = terms(zone.elements[k], allowed);
        for (int t = 0; t < terms_of_element; ++t) slope[t] = (slope[t] - now[k][t]) / h;
      }
      nodes_.set(zone.variables[v].node, before);
    }
    gradient = hold * x;
    matrix = Eigen::MatrixXd::Identity(n, n) * hold;
    for (size_t k = 0; k < zone.elements.size(); ++k)
      for (size_t i = 0; i < slopes[k].size(); ++i)
        for (int t = 0; t < terms_of_element; ++t) {
          if (slopes[k][i][t] == 0) continue;
          const Index v = zone.variables_of[k][i];
          gradient[v] += slopes[k][i][t] * now[k][t];
          for (size_t j = 0; j < slopes[k].size(); ++j)
            matrix(v, zone.variables_of[k][j]) += slopes[k][i][t] * slopes[k][j][t];
        }
  }

  /// Minimises what the zone misses; leaves the nodes there.
  Eigen::VectorXd minimise(const Zone& zone, const std::vector<SurfacePlace>& start,
                           const Allowance& allowed) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(Index(zone.variables.size()));
    std::vector<Terms> now = all_terms(zone, allowed);
    double damping = 1e-2;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd matrix;
    for (int step = 0; step < most_steps && missed(now) > 1e-6; ++step) {
      linearise(zone, x, start, allowed, now, gradient, matrix);
      bool moved = false;
      for (int attempt = 0; attempt < 6 && !moved; ++attempt) {
        Eigen::MatrixXd damped = matrix;
        damped.diagonal() +=
            damping * (matrix.diagonal().array() + 1e-3 * matrix.trace() / double(x.size())).matrix();
        const Eigen::VectorXd delta = damped.ldlt().solve(-gradient);
        if (!delta.allFinite()) break;
        const double longest = delta.cwiseAbs().maxCoeff(), most = 0.3 * options_.size;
        const Eigen::VectorXd next = x + delta * std::min(1.0, most / std::max(longest, 1e-12));
        put_all(zone, next, start);
        std::vector<Terms> then = all_terms(zone, allowed);
        if (cost(then, next) < cost(now, x) * (1 - 1e-4)) {
          x = next, now = std::move(then), moved = true;
          damping = std::max(1e-6, damping / 4);
        } else {
          damping *= 5;
        }
      }
      if (!moved) break;
    }
    put_all(zone, x, start);
    return x;
  }

  /// How many elements fail no more.
  int mend(Index e) {
    const Zone zone = zone_around(e);
    if (zone.variables.empty()) return 0;
    const Standing before = standing(zone.elements);
    if (before.turned_over) return 0;
    const Allowance allowed{std::min(options_.shape, before.shape) + 1e-3,
                            std::min(options_.min_edge, before.shortest) * (1 + 1e-3),
                            std::max(options_.deviation, before.deviation) * 0.95,
                            std::max(options_.crest, before.crest) * 0.98};
    for (const double term : terms(e, allowed))
      if (term > hopeless) return 0;
    std::vector<SurfacePlace> start;
    for (const Variable& variable : zone.variables) start.push_back(nodes_[variable.node]);
    const Eigen::VectorXd x = minimise(zone, start, allowed);
    const Standing after = standing(zone.elements);
    const bool kept = after.failing < before.failing && !after.turned_over &&
                      after.shape >= std::min(options_.shape, before.shape) - 1e-6 &&
                      after.shortest >= std::min(options_.min_edge, before.shortest) - 1e-9 &&
                      after.deviation <= std::max(options_.deviation, before.deviation) &&
                      after.crest <= std::max(options_.crest, before.crest);
    for (Index v = 0; v < Index(zone.variables.size()); ++v) {
      const Variable& variable = zone.variables[v];
      if (!kept)
        nodes_.set(variable.node, start[v]);
      else if (variable.axis == 2)
        lines_.slide(variable.node, x[v]);
    }
    // Neighbours that moved along the same line may have held a node back.
    for (const Variable& variable : zone.variables)
      if (kept && variable.axis == 2)
        nodes_.set(variable.node,
                   nodes_.place(lines_.shifted(variable.node, 0), nodes_[variable.node].triangle));
    return kept ? before.failing - after.failing : 0;
  }

  SurfaceNodes& nodes_;
  const QuadConnectivity& mesh_;
  const std::vector<NodeFreedom>& freedom_;
  SlidingLines& lines_;
  JointMotionOptions options_;
};

}  // namespace

int move_jointly(PlanarMesh& mesh, const SurfaceMap* map, const JointMotionOptions& options) {
  SurfaceNodes nodes(mesh.nodes, map);
  SlidingLines none({}, mesh.freedom);
  const int mended = move_jointly(nodes, QuadConnectivity(mesh), mesh.freedom, none, options);
  for (Index n = 0; n < Index(mesh.nodes.size()); ++n) mesh.nodes[n] = nodes.flat(n);
  return mended;
}

int move_jointly(SurfaceNodes& nodes, const QuadConnectivity& mesh, const std::vector<NodeFreedom>& freedom,
                 SlidingLines& lines, const JointMotionOptions& options) {
  return JointMotion(nodes, mesh, freedom, lines, options).run();
}

}  // namespace beadmesh
