#include "examples/panel_builder.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>

#include "examples/base_curves.h"
#include "examples/bead_surface.h"
#include "examples/spline_surface.h"
#include "examples/wall_strips.h"

namespace beadmesh::examples {
namespace {

constexpr double exact = 1e-7;  // mm, tolerance of what is exact to rounding

gp_Pnt to_gp(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// A loop of the plan lifted onto the base: counter-clockwise, edges shared by the faces on either side.
struct LiftedLoop {
  PlanLoop plan;
  std::vector<TopoDS_Edge> edges;
  TopoDS_Wire wire;
};

bool is_counter_clockwise(const PlanLoop& loop) {
  const std::vector<Vec2> points = sampled(loop);
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) twice += cross(points[i], points[(i + 1) % points.size()]);
  return twice > 0;
}

bool same_loop(const PlanLoop& a, const PlanLoop& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PlanEdge& e, const PlanEdge& f) {
    return distance(e.start, f.start) < 1e-6 && distance(e.point(0.5), f.point(0.5)) < 1e-6;
  });
}

class Builder {
 public:
  explicit Builder(const PanelDesign& design)
      : design_(design), base_(design.base), sheet_(base_surface(base_, design.length, design.width)) {}

  TopoDS_Shell build() {
    const int outline = lift(design_.outline());
    std::vector<TopoDS_Face> features;
    for (const Feature& feature : design_.features) add_feature(feature, features);
    BRep_Builder make;
    TopoDS_Shell shell;
    make.MakeShell(shell);
    make.Add(shell, base_face(outline));
    for (const TopoDS_Face& face : features) make.Add(shell, face);
    for (const int window : windows_)
      if (std::find(outers_.begin(), outers_.end(), window) == outers_.end())
        make.Add(shell, base_face(window));
    if (design_.flange.fillet_radius > 0) add_flange(outline, shell);
    settle_tolerances();
    return shell;
  }

 private:
  /// Index of the lifted loop of a plan loop of either sense; made where it is new.
  int lift(PlanLoop plan) {
    if (!is_counter_clockwise(plan)) plan = reversed(plan);
    for (int i = 0; i < int(loops_.size()); ++i)
      if (same_loop(loops_[i].plan, plan)) return i;
    LiftedLoop loop{plan, {}, {}};
    std::vector<TopoDS_Vertex> corners;
    for (const PlanEdge& edge : plan) corners.push_back(vertex(edge.start));
    BRep_Builder make;
    make.MakeWire(loop.wire);
    for (std::size_t i = 0; i < plan.size(); ++i) {
      loop.edges.push_back(lifted_edge(plan[i], corners[i], corners[(i + 1) % plan.size()]));
      make.Add(loop.wire, loop.edges.back());
    }
    loop.wire.Closed(true);
    loops_.push_back(std::move(loop));
    return int(loops_.size()) - 1;
  }

  TopoDS_Vertex vertex(Vec2 plan) { return vertex(base_.point(plan)); }
  TopoDS_Vertex vertex(Vec3 p) {
    TopoDS_Vertex v;
    BRep_Builder().MakeVertex(v, to_gp(p), exact);
    return v;
  }

  /// The edge over a plan edge, forward in the sense of the plan edge, with its curve on the sheet's surface.
  TopoDS_Edge lifted_edge(const PlanEdge& plan, const TopoDS_Vertex& start, const TopoDS_Vertex& end) {
    const bool backwards = plan.sweep < 0;  // curves of arcs run counter-clockwise
    const PlanEdge forward = backwards ? reversed({plan}).front() : plan;
    TopoDS_Edge edge = bare_edge(curve_in_space(base_, forward), curve_range(forward),
                                 backwards ? end : start, backwards ? start : end);
    BRep_Builder().UpdateEdge(edge, curve_on_base(base_, forward), sheet_, TopLoc_Location(), exact);
    edges_.push_back(edge);
    return backwards ? TopoDS::Edge(edge.Reversed()) : edge;
  }

  static TopoDS_Edge bare_edge(const Handle(Geom_Curve) & curve, CurveRange range, const TopoDS_Vertex& first,
                               const TopoDS_Vertex& last) {
    BRep_Builder make;
    TopoDS_Edge edge;
    make.MakeEdge(edge, curve, exact);
    make.Add(edge, first.Oriented(TopAbs_FORWARD));
    make.Add(edge, last.Oriented(TopAbs_REVERSED));
    make.Range(edge, range.first, range.last);
    make.SameParameter(edge, true);
    make.SameRange(edge, true);
    return edge;
  }

  void add_feature(const Feature& feature, std::vector<TopoDS_Face>& faces) {
    std::vector<int> loops;
    for (const PlanLoop& loop : feature.loops()) loops.push_back(lift(loop));
    outers_.push_back(loops.front());
    if (feature.profile == Profile::hole) return;
    windows_.insert(windows_.end(), loops.begin() + 1, loops.end());
    if (feature.walls.root_radius > 0) return add_walled(feature, loops, faces);
    const Handle(Geom_Surface) surface = bead_surface(base_, feature);
    for (const int loop : loops)
      for (std::size_t i = 0; i < loops_[loop].edges.size(); ++i) {
        const PlanEdge& plan = loops_[loop].plan[i];
        const PlanEdge forward = plan.sweep < 0 ? reversed({plan}).front() : plan;
        BRep_Builder().UpdateEdge(loops_[loop].edges[i],
                                  curve_in_frame(forward, feature.origin, feature.angle), surface,
                                  TopLoc_Location(), exact);
      }
    faces.push_back(face(surface, loops.front(), {loops.begin() + 1, loops.end()}));
  }

  void add_walled(const Feature& feature, const std::vector<int>& loops, std::vector<TopoDS_Face>& faces) {
    std::vector<BoundaryLoop> boundary;
    for (const int loop : loops)
      boundary.push_back({loops_[loop].plan, loops_[loop].edges, loop == loops.front()});
    const WalledFaces walled = walled_faces(base_, feature, boundary);
    faces.insert(faces.end(), walled.faces.begin(), walled.faces.end());
    edges_.insert(edges_.end(), walled.edges.begin(), walled.edges.end());
  }

  TopoDS_Face face(const Handle(Geom_Surface) & surface, int outer, const std::vector<int>& windows) const {
    BRep_Builder make;
    TopoDS_Face face;
    make.MakeFace(face, surface, exact);
    make.Add(face, loops_[outer].wire);
    for (const int window : windows) make.Add(face, loops_[window].wire.Reversed());
    return face;
  }

  /// The part of the base inside a loop, outside the features that lie directly in it.
  TopoDS_Face base_face(int boundary) const {
    std::vector<int> holes;
    for (const int outer : outers_)
      if (outer != boundary && parent(outer) == boundary) holes.push_back(outer);
    return face(sheet_, boundary, holes);
  }

  /// The smallest of the outline and the windows around a loop; the loop itself where it is a window.
  int parent(int loop) const {
    if (std::find(windows_.begin(), windows_.end(), loop) != windows_.end()) return loop;
    int best = 0;
    for (const int window : windows_)
      if (encloses(window, loop) && encloses(best, window)) best = window;
    return best;
  }
  bool encloses(int outer, int inner) const {
    return outer != inner && BoundaryDistance({loops_[outer].plan})(loops_[inner].plan.front().start) > 0;
  }

  /// A sweep of the arc and of the straight wall along the straight edge at x = length / 2.
  void add_flange(int outline, TopoDS_Shell& shell) {
    const double x = design_.length / 2;
    const LiftedLoop& loop = loops_[outline];
    const auto side = std::find_if(loop.plan.begin(), loop.plan.end(), [&](const PlanEdge& e) {
      return !e.is_arc() && std::abs(e.start.x - x) < 1e-6 && std::abs(e.end.x - x) < 1e-6;
    });
    const TopoDS_Edge top = loop.edges[side - loop.plan.begin()];
    const double r = design_.flange.fillet_radius;
    const auto fillet = [&](double turn, Frame f) {
      return f.at + f.up * (r * (std::cos(turn) - 1)) + f.out * (r * std::sin(turn));
    };
    const auto wall = [&](double down, Frame f) { return f.at + f.out * r - f.up * (r + down); };
    const double last = curve_range(*side).last, y = side->start.y;
    const Handle(Geom_Surface) round = swept(even_steps(0, pi / 2, 16), x, y, last, fillet);
    const Handle(Geom_Surface) flat = swept(even_steps(0, design_.flange.length, 4), x, y, last, wall);
    const TopoDS_Edge middle = strip_face(round, top, pi / 2, last, shell);
    strip_face(flat, middle, design_.flange.length, last, shell);
  }

  /// The sheet's own axes on its edge.
  struct Frame {
    Vec3 at, out, up;
  };
  template <class Section>
  Handle(Geom_Surface)
      swept(const std::vector<double>& us, double x, double y, double last, const Section& section) const {
    const std::vector<double> vs = even_steps(0, last, std::max(12, int(last / 10)));
    std::vector<Vec3> points;
    for (const double u : us)
      for (const double v : vs) {
        const Vec2 p{x, y + v};
        const Vec3 up = base_.normal(p),
                   ahead = base_.point(p + Vec2{0, 1e-4}) - base_.point(p - Vec2{0, 1e-4});
        points.push_back(section(u, Frame{base_.point(p), normalized(cross(ahead, up)), up}));
      }
    return spline_through(us, vs, points);
  }

  /// Adds the face that hangs on the edge u = 0, which it shares; returns its edge u = depth.
  TopoDS_Edge strip_face(const Handle(Geom_Surface) & surface, const TopoDS_Edge& top, double depth,
                         double last, TopoDS_Shell& shell) {
    BRep_Builder make;
    const TopoDS_Vertex a = TopExp::FirstVertex(top), b = TopExp::LastVertex(top);
    const auto corner = [&](double v) {
      const gp_Pnt p = surface->Value(depth, v);
      return vertex(Vec3{p.X(), p.Y(), p.Z()});
    };
    const TopoDS_Vertex c = corner(0), d = corner(last);
    const TopoDS_Edge bottom = bare_edge(surface->UIso(depth), {0, last}, c, d);
    const TopoDS_Edge left = bare_edge(surface->VIso(0), {0, depth}, a, c);
    const TopoDS_Edge right = bare_edge(surface->VIso(last), {0, depth}, b, d);
    const auto on_surface = [&](const TopoDS_Edge& edge, gp_Pnt2d from, gp_Dir2d along) {
      make.UpdateEdge(edge, new Geom2d_Line(from, along), surface, TopLoc_Location(), exact);
      edges_.push_back(edge);
    };
    on_surface(top, {0, 0}, {0, 1});
    on_surface(bottom, {depth, 0}, {0, 1});
    on_surface(left, {0, 0}, {1, 0});
    on_surface(right, {0, last}, {1, 0});
    TopoDS_Wire wire;
    make.MakeWire(wire);
    for (const TopoDS_Shape& edge :
         {TopoDS_Shape(left), TopoDS_Shape(bottom), right.Reversed(), top.Reversed()})
      make.Add(wire, edge);
    wire.Closed(true);
    TopoDS_Face face;
    make.MakeFace(face, surface, exact);
    make.Add(face, wire);
    make.Add(shell, face);
    return bottom;
  }

  /// Sets the tolerance of edges and vertices to what their curves need on all surfaces.
  void settle_tolerances() {
    BRep_Builder make;
    for (const TopoDS_Edge& edge : edges_) {
      const double gap = 1.05 * largest_gap(edge) + exact;
      make.UpdateEdge(edge, gap);
      for (TopExp_Explorer it(edge, TopAbs_VERTEX); it.More(); it.Next())
        make.UpdateVertex(TopoDS::Vertex(it.Current()), 1.05 * gap);
    }
  }
  static double largest_gap(const TopoDS_Edge& edge) {
    double first, last, gap = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    for (int i = 1;; ++i) {
      Handle(Geom2d_Curve) on_surface;
      Handle(Geom_Surface) surface;
      TopLoc_Location location;
      BRep_Tool::CurveOnSurface(edge, on_surface, surface, location, first, last, i);
      if (on_surface.IsNull()) return gap;
      for (const double t : even_steps(first, last, 200)) {
        const gp_Pnt2d uv = on_surface->Value(t);
        gap = std::max(gap, curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
      }
    }
  }

  const PanelDesign& design_;
  const Base& base_;
  Handle(Geom_Surface) sheet_;
  std::vector<LiftedLoop> loops_;  // the panel's outline first
  std::vector<TopoDS_Edge> edges_;
  std::vector<int> outers_;   // loops around a feature
  std::vector<int> windows_;  // loops within a feature
};

}  // namespace

TopoDS_Shell build_panel(const PanelDesign& design) {
  return Builder(design).build();
}

}  // namespace beadmesh::examples
