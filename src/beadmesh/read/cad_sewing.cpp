#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "beadmesh/read/cad_model.h"

namespace beadmesh {
namespace {

struct FreeEdge {
  std::vector<gp_Pnt> points;  // along the curve, both ends included
};

std::vector<FreeEdge> free_edges_of(const std::vector<TopoDS_Face>& faces) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  for (const TopoDS_Face& face : faces)
    TopExp::MapShapesAndAncestors(face, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  std::vector<FreeEdge> result;
  for (int i = 1; i <= faces_of_edge.Extent(); ++i) {
    if (faces_of_edge(i).Extent() != 1) continue;  // a seam is listed twice
    const TopoDS_Edge edge = TopoDS::Edge(faces_of_edge.FindKey(i));
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (BRep_Tool::Degenerated(edge) || curve.IsNull()) continue;
    FreeEdge item;
    constexpr int segments = 8;
    for (int k = 0; k <= segments; ++k)
      item.points.push_back(curve->Value(first + (last - first) * k / segments));
    result.push_back(std::move(item));
  }
  return result;
}

double distance_to_segment(const gp_Pnt& p, const gp_Pnt& a, const gp_Pnt& b) {
  const gp_Vec along(a, b), to(a, p);
  const double length2 = along.SquareMagnitude();
  const double t = length2 > 0 ? std::clamp(to.Dot(along) / length2, 0.0, 1.0) : 0.0;
  return (to - along * t).Magnitude();
}

/// Largest step between a chord of the samples and the curve: how far `lies_near` must look.
double sagitta(const FreeEdge& e) {
  double worst = 0;
  for (std::size_t i = 1; i + 1 < e.points.size(); ++i)
    worst = std::max(worst, distance_to_segment(e.points[i], e.points[i - 1], e.points[i + 1]));
  return worst;
}

bool lies_near(const gp_Pnt& p, const FreeEdge& e, double reach) {
  for (std::size_t i = 0; i + 1 < e.points.size(); ++i)
    if (distance_to_segment(p, e.points[i], e.points[i + 1]) <= reach) return true;
  return false;
}

/// A quick look that only spares clean models the sewing: could any two free edges run along each other?
bool may_coincide(const FreeEdge& a, const FreeEdge& b, double tolerance) {
  const double reach = tolerance + sagitta(b);
  int near = 0;
  for (const gp_Pnt& p : a.points) near += lies_near(p, b, reach) ? 1 : 0;
  return near >= 3;
}

bool has_open_joints(const std::vector<FreeEdge>& edges, double tolerance) {
  struct Span {
    double low, high;
    std::size_t edge;
  };
  std::vector<Span> spans;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    Span span{edges[i].points[0].X(), edges[i].points[0].X(), i};
    for (const gp_Pnt& p : edges[i].points) {
      span.low = std::min(span.low, p.X());
      span.high = std::max(span.high, p.X());
    }
    const double reach = tolerance + sagitta(edges[i]);
    spans.push_back({span.low - reach, span.high + reach, i});
  }
  std::sort(spans.begin(), spans.end(),
            [](const Span& a, const Span& b) { return a.low != b.low ? a.low < b.low : a.edge < b.edge; });
  for (std::size_t i = 0; i < spans.size(); ++i)
    for (std::size_t j = i + 1; j < spans.size() && spans[j].low <= spans[i].high; ++j) {
      const FreeEdge &a = edges[spans[i].edge], &b = edges[spans[j].edge];
      if (may_coincide(a, b, tolerance) || may_coincide(b, a, tolerance)) return true;
    }
  return false;
}

void sew_faces(std::vector<TopoDS_Face>& faces, double tolerance) {
  if (!has_open_joints(free_edges_of(faces), tolerance)) return;
  BRepBuilderAPI_Sewing sewing(tolerance);
  for (const TopoDS_Face& face : faces) sewing.Add(face);
  sewing.Perform();
  for (TopoDS_Face& face : faces) {
    const TopoDS_Shape after = sewing.IsModified(face) ? sewing.Modified(face) : TopoDS_Shape(face);
    TopExp_Explorer at(after, TopAbs_FACE);
    if (at.More()) face = TopoDS::Face(at.Current());
  }
}

/// Faces of one part each. Systems write loose faces of one panel as components of their own: parts of a
/// single face are sewn together.
std::map<Index, std::vector<std::size_t>> faces_to_sew(const CadModel& model) {
  std::map<Index, int> count;
  for (const Index part : model.part_of_face) ++count[part];
  std::map<Index, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const Index part = model.part_of_face[f];
    faces[count[part] == 1 ? no_index : part].push_back(f);
  }
  return faces;
}

}  // namespace

void sew(CadModel& model, double tolerance) {
  if (tolerance <= 0) return;
  std::size_t before = 0, open = 0;
  for (const auto& [part, faces] : faces_to_sew(model)) {
    std::vector<TopoDS_Face> of_part;
    for (const std::size_t f : faces) of_part.push_back(model.faces[f]);
    before += free_edges_of(of_part).size();
    sew_faces(of_part, tolerance);
    open += free_edges_of(of_part).size();
    for (std::size_t i = 0; i < faces.size(); ++i) model.faces[faces[i]] = of_part[i];
  }
  if (open < before)
    model.diagnostics.push_back({"read.sewn",
                                 Severity::note,
                                 no_index,
                                 {},
                                 std::to_string(before - open) + " free edges were sewn to their neighbours",
                                 {}});
}

}  // namespace beadmesh
