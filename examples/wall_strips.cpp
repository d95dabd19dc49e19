#include "examples/wall_strips.h"

#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "examples/base_curves.h"
#include "examples/spline_surface.h"

namespace beadmesh::examples {
namespace {

constexpr double exact = 1e-7;  // mm
constexpr int strips = 3;       // root fillet, wall, top fillet

/// Inset from the boundary and share of the full height, over the strips.
class Section {
 public:
  Section(const Walls& walls, double height) {
    const double a = walls.angle, rise = 1 - std::cos(a), h = std::abs(height);
    const double shrink = std::min(1.0, 0.95 * h / ((walls.root_radius + walls.top_radius) * rise));
    root_ = walls.root_radius * shrink;
    top_ = walls.top_radius * shrink;
    angle_ = a;
    wall_ = (h - (root_ + top_) * rise) / std::tan(a);
    height_ = h;
  }

  double inset(int strip, double t) const {
    const double s = std::sin(angle_);
    if (strip == 0) return root_ * std::sin(t * angle_);
    if (strip == 1) return root_ * s + t * wall_;
    return root_ * s + wall_ + top_ * (s - std::sin((1 - t) * angle_));
  }
  double share(int strip, double t) const {
    const double low = root_ * (1 - std::cos(angle_)), high = height_ - top_ * (1 - std::cos(angle_));
    if (strip == 0) return root_ * (1 - std::cos(t * angle_)) / height_;
    if (strip == 1) return (low + t * (high - low)) / height_;
    return (height_ - top_ * (1 - std::cos((1 - t) * angle_))) / height_;
  }
  double width() const { return inset(strips - 1, 1); }

 private:
  double root_, top_, angle_, wall_, height_;
};

/// An edge of the boundary in the sense of its curve, and copies of it further inside.
struct Guide {
  PlanEdge forward;
  bool is_backwards = false;  ///< the curve runs against the loop
  double side = 1;            ///< +1: the feature lies on the left of `forward`

  PlanEdge inset(double by) const {
    if (forward.is_arc())
      return arc(forward.centre, forward.radius - side * by, forward.start_angle, forward.sweep);
    const Vec2 n = left_normal(normalized(forward.end - forward.start)) * (side * by);
    return line(forward.start + n, forward.end + n);
  }
  Vec2 point(double u, double by) const {
    const CurveRange range = curve_range(forward);
    return inset(by).point((u - range.first) / (range.last - range.first));
  }
};

Guide guide_of(const PlanEdge& plan, bool is_outer) {
  Guide guide{plan, plan.sweep < 0, is_outer ? 1.0 : -1.0};
  if (guide.is_backwards) {
    guide.forward = reversed({plan}).front();
    guide.side = -guide.side;
  }
  return guide;
}

class StripBuilder {
 public:
  StripBuilder(const Base& base, const Feature& feature)
      : base_(base), feature_(feature), section_(feature.walls, feature.height) {}

  WalledFaces build(const std::vector<BoundaryLoop>& loops) {
    std::vector<TopoDS_Wire> wires;
    for (const BoundaryLoop& loop : loops) wires.push_back(add_loop(loop));
    BRep_Builder make;
    TopoDS_Face face;
    make.MakeFace(face, top_surface(), exact);
    for (std::size_t i = 0; i < wires.size(); ++i)
      make.Add(face, loops[i].is_outer ? TopoDS_Shape(wires[i]) : wires[i].Reversed());
    out_.faces.push_back(face);
    return std::move(out_);
  }

 private:
  Vec3 lifted(Vec2 p, double share) const {
    return base_.point(p) + Vec3{0, 0, share * feature_.height * feature_.height_share(p)};
  }

  Handle(Geom_Surface) strip_surface(const Guide& guide, int strip) const {
    const CurveRange range = curve_range(guide.forward);
    const double step = guide.forward.is_arc() ? radians(4) : 3;
    const int count = std::max(6, int((range.last - range.first) / step));
    const std::vector<double> us = even_steps(range.first, range.last, count), vs = even_steps(0, 1, 10);
    std::vector<Vec3> points;
    for (const double u : us)
      for (const double v : vs)
        points.push_back(lifted(guide.point(u, section_.inset(strip, v)), section_.share(strip, v)));
    return spline_through(us, vs, points);
  }

  /// In plan coordinates, over the bounding box of the feature.
  Handle(Geom_Surface) top_surface() {
    if (top_.IsNull()) {
      if (base_.is_flat() && feature_.walls.run_out == 0) {
        top_ = new Geom_Plane(gp_Ax3(gp_Pnt(0, 0, feature_.height), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)));
      } else {
        const std::vector<Vec2> outline = sampled(feature_.loops().front());
        const auto steps = [&](double Vec2::*axis) {
          const auto [low, high] = std::minmax_element(outline.begin(), outline.end(),
                                                       [&](Vec2 a, Vec2 b) { return a.*axis < b.*axis; });
          return even_steps((*low).*axis - 2, (*high).*axis + 2,
                            std::max(6, int(((*high).*axis - (*low).*axis) / 3)));
        };
        const std::vector<double> xs = steps(&Vec2::x), ys = steps(&Vec2::y);
        std::vector<Vec3> points;
        for (const double x : xs)
          for (const double y : ys) points.push_back(lifted({x, y}, 1));
        top_ = spline_through(xs, ys, points);
      }
    }
    return top_;
  }

  TopoDS_Edge new_edge(const Handle(Geom_Curve) & curve, CurveRange range, const TopoDS_Vertex& first,
                       const TopoDS_Vertex& last) {
    BRep_Builder make;
    TopoDS_Edge edge;
    make.MakeEdge(edge, curve, exact);
    make.Add(edge, first.Oriented(TopAbs_FORWARD));
    make.Add(edge, last.Oriented(TopAbs_REVERSED));
    make.Range(edge, range.first, range.last);
    make.SameParameter(edge, true);
    make.SameRange(edge, true);
    out_.edges.push_back(edge);
    return edge;
  }

  static void set_line(const TopoDS_Edge& edge, const Handle(Geom_Surface) & surface, gp_Pnt2d from,
                       gp_Dir2d along) {
    BRep_Builder().UpdateEdge(edge, new Geom2d_Line(from, along), surface, TopLoc_Location(), exact);
  }

  /// All strips of a loop; the wire along its top.
  TopoDS_Wire add_loop(const BoundaryLoop& loop) {
    const std::size_t n = loop.plan.size();
    std::vector<Guide> guides;
    std::vector<TopoDS_Edge> rows;  // of the level below, in the sense of their curves
    for (std::size_t i = 0; i < n; ++i) {
      guides.push_back(guide_of(loop.plan[i], loop.is_outer));
      rows.push_back(TopoDS::Edge(loop.edges[i].Oriented(TopAbs_FORWARD)));
    }
    for (int strip = 0; strip < strips; ++strip) rows = add_strip(guides, rows, strip);
    BRep_Builder make;
    TopoDS_Wire wire;
    make.MakeWire(wire);
    for (std::size_t i = 0; i < n; ++i) {
      make.UpdateEdge(rows[i], curve_in_frame(guides[i].inset(section_.width()), {}, 0), top_surface(),
                      TopLoc_Location(), exact);
      make.Add(wire, guides[i].is_backwards ? rows[i].Reversed() : TopoDS_Shape(rows[i]));
    }
    wire.Closed(true);
    return wire;
  }

  std::vector<TopoDS_Edge> add_strip(const std::vector<Guide>& guides, const std::vector<TopoDS_Edge>& below,
                                     int strip) {
    const std::size_t n = guides.size();
    std::vector<Handle(Geom_Surface)> surfaces;
    for (const Guide& guide : guides) surfaces.push_back(strip_surface(guide, strip));
    // Corner i is where edge i starts.
    const auto start_of = [&](std::size_t i) {
      const CurveRange range = curve_range(guides[i].forward);
      return guides[i].is_backwards ? range.last : range.first;
    };
    std::vector<TopoDS_Vertex> upper(n);
    std::vector<TopoDS_Edge> crossing(n), above(n);
    for (std::size_t i = 0; i < n; ++i) {
      BRep_Builder().MakeVertex(upper[i], surfaces[i]->Value(start_of(i), 1), exact);
      const TopoDS_Vertex lower =
          guides[i].is_backwards ? TopExp::LastVertex(below[i]) : TopExp::FirstVertex(below[i]);
      crossing[i] = new_edge(surfaces[i]->UIso(start_of(i)), {0, 1}, lower, upper[i]);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      const CurveRange range = curve_range(guides[i].forward);
      const bool back = guides[i].is_backwards;
      above[i] = new_edge(surfaces[i]->VIso(1), range, upper[back ? next : i], upper[back ? i : next]);
      const TopoDS_Edge& left = crossing[back ? next : i];
      const TopoDS_Edge& right = crossing[back ? i : next];
      set_line(below[i], surfaces[i], {0, 0}, {1, 0});
      set_line(above[i], surfaces[i], {0, 1}, {1, 0});
      set_line(left, surfaces[i], {range.first, 0}, {0, 1});
      set_line(right, surfaces[i], {range.last, 0}, {0, 1});
      add_face(surfaces[i], below[i], right, above[i], left, guides[i].side < 0);
    }
    return above;
  }

  void add_face(const Handle(Geom_Surface) & surface, const TopoDS_Edge& below, const TopoDS_Edge& right,
                const TopoDS_Edge& above, const TopoDS_Edge& left, bool is_turned) {
    BRep_Builder make;
    TopoDS_Wire wire;
    make.MakeWire(wire);
    for (const TopoDS_Shape& edge :
         {TopoDS_Shape(below), TopoDS_Shape(right), above.Reversed(), left.Reversed()})
      make.Add(wire, edge);
    wire.Closed(true);
    TopoDS_Face face;
    make.MakeFace(face, surface, exact);
    make.Add(face, wire);
    out_.faces.push_back(is_turned ? TopoDS::Face(face.Reversed()) : face);
  }

  const Base& base_;
  const Feature& feature_;
  Section section_;
  Handle(Geom_Surface) top_;
  WalledFaces out_;
};

}  // namespace

WalledFaces walled_faces(const Base& base, const Feature& feature, const std::vector<BoundaryLoop>& loops) {
  return StripBuilder(base, feature).build(loops);
}

}  // namespace beadmesh::examples
