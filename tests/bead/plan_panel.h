// Panels drawn in plan: faces between shared loops, each lifted by a function, so that crests are known
// exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "beadmesh/bead/face_study.h"
#include "beadmesh/delaunay/triangulation.h"
#include "beadmesh/panel/panel.h"
#include "examples/footprint.h"

namespace beadmesh::shapes {

using examples::Footprint;

/// Plan point to space.
using Lift = std::function<Vec3(Vec2)>;
/// Height of the sheet over the plan.
using Base = std::function<double(Vec2)>;

inline double flat_base(Vec2) {
  return 0;
}

/// A cylinder about an axis along y under the sheet.
inline Base cylinder_base(double radius) {
  return [=](Vec2 p) { return std::sqrt(radius * radius - p.x * p.x) - radius; };
}

inline Lift on(const Base& base) {
  return [=](Vec2 p) { return Vec3{p.x, p.y, base(p)}; };
}

/// Tangent to the base at the boundary, highest on the medial axis. `lean`: the press direction is (lean, 1).
inline Lift raised(const std::vector<examples::PlanLoop>& loops, double half_width, double height,
                   const Base& base = flat_base, Vec2 lean = {}) {
  const auto inside = std::make_shared<examples::BoundaryDistance>(loops);
  return [=](Vec2 p) {
    const double share = std::clamp((*inside)(p) / half_width, 0.0, 1.0);
    const double rise = height * std::pow(std::sin(share * pi / 2), 2);
    return Vec3{p.x + lean.x * rise, p.y + lean.y * rise, base(p) + rise};
  };
}

/// Points of a loop: lines at most `spacing` long, arcs also within 0.02 mm.
inline std::vector<Vec2> points_of(const examples::PlanLoop& loop, double spacing = 2) {
  std::vector<Vec2> points;
  for (const examples::PlanEdge& edge : loop) {
    double step = spacing;
    if (edge.is_arc()) step = std::min(step, 2 * edge.radius * std::acos(1 - 0.02 / edge.radius));
    const int n = std::max(1, static_cast<int>(std::ceil(edge.length() / step - 1e-9)));
    for (int i = 0; i < n; ++i) points.push_back(edge.point(static_cast<double>(i) / n));
  }
  return points;
}

/// The exact surface behind the facets: its parameters are the plan.
class LiftedSurface : public SurfaceEvaluator {
 public:
  explicit LiftedSurface(Lift lift) : lift_(std::move(lift)) {}
  Vec3 point(Vec2 uv) const override { return lift_(uv); }
  Vec3 normal(Vec2 uv) const override {
    constexpr double h = 1e-4;
    const Vec3 u = lift_(uv + Vec2{h, 0}) - lift_(uv - Vec2{h, 0});
    const Vec3 v = lift_(uv + Vec2{0, h}) - lift_(uv - Vec2{0, h});
    return normalized(cross(u, v));
  }

 private:
  Lift lift_;
};

class PlanPanel {
 public:
  explicit PlanPanel(Base base = flat_base, double spacing = 2) : base_(std::move(base)), spacing_(spacing) {}

  /// A counter-clockwise loop that lies on the base; a new edge begins at each of `breaks` (none: one closed
  /// edge, from point 0). Returns its number.
  int add_loop(const std::vector<Vec2>& points, const std::vector<Index>& breaks = {}) {
    Loop loop{points, {}, {}};
    for (const Vec2 p : points) {
      loop.panel_points.push_back(static_cast<Index>(panel_.points.size()));
      panel_.points.push_back({p.x, p.y, base_(p)});
    }
    const Index n = static_cast<Index>(points.size());
    const std::vector<Index> starts = breaks.empty() ? std::vector<Index>{0} : breaks;
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const Index from = starts[k], to = k + 1 < starts.size() ? starts[k + 1] : starts[0] + n;
      PanelEdge edge;
      for (Index i = from; i <= to; ++i) edge.points.push_back(loop.panel_points[i % n]);
      loop.edges.push_back(static_cast<Index>(panel_.edges.size()));
      panel_.edges.push_back(std::move(edge));
    }
    loops_.push_back(std::move(loop));
    return static_cast<int>(loops_.size()) - 1;
  }

  /// A face inside loop `outer` and outside `holes`; `spacing` of its inner points (0: the panel's). Returns
  /// its index.
  Index add_face(int outer, const std::vector<int>& holes, const Lift& lift, double spacing = 0) {
    const Index index = static_cast<Index>(panel_.faces.size());
    PanelFace face;
    face.number = index + 1;
    PlanPoints plan;
    add_loop_to(face, plan, outer, false, index);
    for (int hole : holes) add_loop_to(face, plan, hole, true, index);
    add_inner_points(face.facets, plan, lift, spacing > 0 ? spacing : spacing_);
    fill(face.facets, plan, lift);
    panel_.faces.push_back(std::move(face));
    return index;
  }

  /// A bead that is one face; its loops become the panel's.
  std::vector<int> add_bead(const Footprint& footprint, double height, Vec2 lean = {}) {
    std::vector<int> loops;
    for (const auto& loop : footprint.loops) {
      auto points = points_of(loop, spacing_);
      if (!loops.empty()) std::reverse(points.begin(), points.end());  // windows are drawn clockwise
      loops.push_back(add_loop(points));
    }
    add_face(loops[0], {loops.begin() + 1, loops.end()},
             raised(footprint.loops, footprint.half_width, height, base_, lean));
    return loops;
  }

  const Base& base() const { return base_; }
  Panel take() { return std::move(panel_); }

 private:
  struct Loop {
    std::vector<Vec2> points;
    std::vector<Index> panel_points, edges;
  };
  using PlanPoints = std::vector<Vec2>;

  void add_loop_to(PanelFace& face, PlanPoints& plan, int l, bool backward, Index index) {
    const Loop& loop = loops_[l];
    const Index first = static_cast<Index>(plan.size()), n = static_cast<Index>(loop.points.size());
    for (Index i = 0; i < n; ++i) {
      plan.push_back(loop.points[i]);
      face.facets.points.push_back(panel_.points[loop.panel_points[i]]);
      face.facets.panel_points.push_back(loop.panel_points[i]);
    }
    std::vector<EdgeUse> uses;
    for (Index e : loop.edges) {
      uses.push_back({e, backward});
      panel_.edges[e].faces.push_back(index);
    }
    if (backward) std::reverse(uses.begin(), uses.end());
    const Index begin = panel_.edges[uses.front().edge].points[0] - loop.panel_points[0];
    std::vector<Index> order;
    for (Index i = 0; i < n; ++i) order.push_back(first + (begin + (backward ? n - i : i)) % n);
    face.loops.push_back(uses);
    face.facets.loops.push_back(order);
  }

  bool is_inside(const Facets& facets, const PlanPoints& plan, Vec2 p) const {
    bool inside = false;
    for (const auto& loop : facets.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = plan[loop[i]], b = plan[loop[(i + 1) % loop.size()]];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
          inside = !inside;
      }
    return inside;
  }

  /// A skew grid, so that the facets do not share the symmetries of the shape.
  void add_inner_points(Facets& facets, PlanPoints& plan, const Lift& lift, double spacing) {
    Vec2 low = plan[0], high = plan[0];
    const std::size_t boundary = plan.size();
    for (const Vec2 p : plan) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    int row = 0;
    for (double y = low.y + 0.37 * spacing; y < high.y; y += 0.87 * spacing, ++row)
      for (double x = low.x + (0.31 + 0.47 * (row % 2)) * spacing; x < high.x; x += spacing) {
        const Vec2 p{x, y};
        if (!is_inside(facets, plan, p)) continue;
        const bool crowded =
            std::any_of(plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(boundary),
                        [&](Vec2 q) { return squared_norm(q - p) < 0.36 * spacing * spacing; });
        if (crowded) continue;
        plan.push_back(p);
        facets.points.push_back(lift(p));
        facets.panel_points.push_back(static_cast<Index>(panel_.points.size()));
        panel_.points.push_back(lift(p));
      }
  }

  static void fill(Facets& facets, const PlanPoints& plan, const Lift& lift) {
    const auto triangulation = triangulate(plan, facets.loops);
    if (!triangulation) throw std::runtime_error(triangulation.error().message);
    facets.triangles = triangulation->triangles;
    for (const Triangle& t : facets.triangles)
      facets.triangle_uv.push_back({plan[t[0]], plan[t[1]], plan[t[2]]});
    facets.triangle_surface.assign(facets.triangles.size(), 0);
    facets.surfaces = {std::make_shared<LiftedSurface>(lift)};
  }

  Base base_;
  double spacing_;
  Panel panel_;
  std::vector<Loop> loops_;
};

}  // namespace beadmesh::shapes
