#include "examples/kernel_panel.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>

#include "examples/chance.h"
#include "examples/step_shape.h"

namespace beadmesh::examples {
namespace {

constexpr double thickness = 30;  // mm, of the block under the skin
constexpr double exact = 1e-5;    // mm

TopoDS_Wire wire_of(const PlanLoop& loop, double z) {
  const auto to_gp = [z](Vec2 p) { return gp_Pnt(p.x, p.y, z); };
  BRepBuilderAPI_MakeWire wire;
  for (const PlanEdge& edge : loop) {
    if (edge.is_arc()) {
      const Vec2 out = edge.point(0) - edge.centre;
      const gp_Ax2 axes(to_gp(edge.centre), gp_Dir(0, 0, edge.sweep > 0 ? 1 : -1), gp_Dir(out.x, out.y, 0));
      wire.Add(BRepBuilderAPI_MakeEdge(gp_Circ(axes, edge.radius), 0, std::abs(edge.sweep)).Edge());
    } else {
      wire.Add(BRepBuilderAPI_MakeEdge(to_gp(edge.point(0)), to_gp(edge.point(1))).Edge());
    }
  }
  return wire.Wire();
}

TopoDS_Shape block(const std::vector<PlanLoop>& loops, double from, double to) {
  BRepBuilderAPI_MakeFace face(wire_of(loops.front(), from), true);
  for (std::size_t i = 1; i < loops.size(); ++i) face.Add(wire_of(loops[i], from));
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, to - from)).Shape();
}

/// The loop moved to its left.
PlanLoop moved_left(const PlanLoop& loop, double by) {
  PlanLoop moved;
  for (const PlanEdge& edge : loop) {
    if (edge.is_arc()) {
      const double radius = edge.radius - (edge.sweep > 0 ? by : -by);
      moved.push_back(arc(edge.centre, radius, edge.start_angle, edge.sweep));
    } else {
      const Vec2 shift = left_normal(normalized(edge.end - edge.start)) * by;
      moved.push_back(line(edge.start + shift, edge.end + shift));
    }
  }
  return moved;
}

/// Where the walls stand: the loops run with the feature on their left.
std::vector<PlanLoop> wall_loops(const Feature& feature) {
  std::vector<PlanLoop> loops;
  for (const PlanLoop& loop : feature.loops()) loops.push_back(moved_left(loop, feature.walls.root_radius));
  return loops;
}

Vec2 direction(const PlanEdge& edge, double at) {
  if (!edge.is_arc()) return normalized(edge.end - edge.start);
  const Vec2 out = edge.point(at) - edge.centre;
  return left_normal(normalized(out)) * (edge.sweep > 0 ? 1.0 : -1.0);
}

bool is_smooth(const PlanLoop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (dot(direction(loop[i], 1), direction(loop[(i + 1) % loop.size()], 0)) < 0.999) return false;
  return true;
}

bool can_be_made(const Feature& feature) {
  if (feature.name == "corrugated") return false;
  const std::vector<PlanLoop> loops = feature.loops();
  return std::all_of(loops.begin(), loops.end(), is_smooth);
}

class KernelPanel {
 public:
  explicit KernelPanel(const PanelDesign& design) : design_(design) {}

  TopoDS_Shell skin() {
    solid_ = block({design_.outline()}, -thickness, 0);
    for (const Feature& feature : design_.features) add(feature);
    add_fillets();
    return upper_side();
  }

 private:
  void add(const Feature& feature) {
    if (feature.profile == Profile::hole)
      solid_ = BRepAlgoAPI_Cut(solid_, block(feature.loops(), -thickness - 1, 1)).Shape();
    else if (feature.height > 0)
      solid_ = BRepAlgoAPI_Fuse(solid_, block(wall_loops(feature), -1, feature.height)).Shape();
    else
      solid_ = BRepAlgoAPI_Cut(solid_, block(wall_loops(feature), feature.height, 1)).Shape();
  }

  void add_fillets() {
    BRepFilletAPI_MakeFillet fillets(solid_);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solid_, TopAbs_EDGE, edges);
    for (const Feature& feature : design_.features) {
      if (feature.profile == Profile::hole) continue;
      const BoundaryDistance wall(wall_loops(feature));
      for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        const BRepAdaptor_Curve curve(edge);
        const gp_Pnt a = curve.Value(curve.FirstParameter()), b = curve.Value(curve.LastParameter());
        const gp_Pnt m = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
        if (std::abs(a.Z() - b.Z()) > exact || std::abs(wall({m.X(), m.Y()})) > 0.02) continue;
        if (std::abs(m.Z()) < exact) fillets.Add(feature.walls.root_radius, edge);
        if (std::abs(m.Z() - feature.height) < exact) fillets.Add(feature.walls.top_radius, edge);
      }
    }
    if (fillets.NbContours() > 0) solid_ = fillets.Shape();
  }

  /// Faces that do not reach the bottom.
  TopoDS_Shell upper_side() const {
    BRep_Builder make;
    TopoDS_Shell shell;
    make.MakeShell(shell);
    for (TopExp_Explorer face(solid_, TopAbs_FACE); face.More(); face.Next()) {
      bool is_above = true;
      for (TopExp_Explorer at(face.Current(), TopAbs_VERTEX); at.More(); at.Next())
        is_above = is_above && BRep_Tool::Pnt(TopoDS::Vertex(at.Current())).Z() > exact - thickness;
      if (is_above) make.Add(shell, face.Current());
    }
    return shell;
  }

  const PanelDesign& design_;
  TopoDS_Shape solid_;
};

}  // namespace

void prepare_for_kernel(PanelDesign& panel, std::uint64_t seed) {
  Chance chance(seed ^ 0x6b65726e656c);
  panel.base = {};
  panel.flange = {};
  std::vector<Feature> kept;
  for (Feature& feature : panel.features) {
    const double half = std::min(feature.footprint.half_width, feature.footprint.end_half_width);
    const double most = std::min(std::abs(feature.height), 0.6 * half) * chance.between(0.5, 0.95);
    const double share = chance.between(0.35, 0.65);
    feature.walls = {};
    feature.walls.root_radius = most * share;
    feature.walls.top_radius = most * (1 - share);
    if (can_be_made(feature)) kept.push_back(std::move(feature));
  }
  panel.features = std::move(kept);
}

bool write_kernel_panel(const PanelDesign& panel, const std::filesystem::path& path) {
  try {
    return write_shape(KernelPanel(panel).skin(), path);
  } catch (const Standard_Failure&) {
    return false;
  }
}

}  // namespace beadmesh::examples
