#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "beadmesh/read/cad_model.h"

namespace beadmesh {
namespace {

/// What two copies of a face have alike.
struct FaceMark {
  gp_Pnt low, high;             // of points along its boundary
  std::vector<gp_Pnt> middles;  // of its edges
};

FaceMark mark_of(const TopoDS_Face& face) {
  constexpr double far = 1e100;
  FaceMark mark{gp_Pnt(far, far, far), gp_Pnt(-far, -far, -far), {}};
  for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
    double first = 0, last = 0;
    const TopoDS_Edge edge = TopoDS::Edge(at.Current());
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) continue;
    mark.middles.push_back(curve->Value((first + last) / 2));
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const gp_Pnt p = curve->Value(first + (last - first) * t);
      mark.low = {std::min(mark.low.X(), p.X()), std::min(mark.low.Y(), p.Y()),
                  std::min(mark.low.Z(), p.Z())};
      mark.high = {std::max(mark.high.X(), p.X()), std::max(mark.high.Y(), p.Y()),
                   std::max(mark.high.Z(), p.Z())};
    }
  }
  return mark;
}

bool same_boundary(const FaceMark& a, const FaceMark& b, double tolerance) {
  if (a.middles.size() != b.middles.size() || a.low.Distance(b.low) > tolerance ||
      a.high.Distance(b.high) > tolerance)
    return false;
  return std::all_of(a.middles.begin(), a.middles.end(), [&](const gp_Pnt& p) {
    return std::any_of(b.middles.begin(), b.middles.end(),
                       [&](const gp_Pnt& q) { return p.Distance(q) <= tolerance; });
  });
}

/// Two faces with one boundary may still be the two halves of a lens.
bool same_area(const TopoDS_Face& a, const TopoDS_Face& b, double tolerance) {
  GProp_GProps of_a, of_b;
  BRepGProp::SurfaceProperties(a, of_a);
  BRepGProp::SurfaceProperties(b, of_b);
  return of_a.CentreOfMass().Distance(of_b.CentreOfMass()) <= tolerance &&
         std::abs(std::abs(of_a.Mass()) - std::abs(of_b.Mass())) <= 1e-3 * std::abs(of_a.Mass());
}

}  // namespace

void drop_duplicates(CadModel& model, double tolerance) {
  std::vector<FaceMark> marks;
  for (const TopoDS_Face& face : model.faces) marks.push_back(mark_of(face));
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (!marks[i].middles.empty()) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return marks[a].low.X() < marks[b].low.X(); });
  std::vector<bool> dropped(marks.size(), false);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const auto [first, second] = std::minmax(order[i], order[j]);
      if (marks[order[j]].low.X() > marks[order[i]].low.X() + tolerance) break;
      if (dropped[first] || dropped[second] || !same_boundary(marks[first], marks[second], tolerance))
        continue;
      dropped[second] = same_area(model.faces[first], model.faces[second], tolerance);
    }
  const auto count = std::count(dropped.begin(), dropped.end(), true);
  if (count == 0) return;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < dropped.size(); ++f) {
    if (dropped[f]) continue;
    model.faces[kept] = model.faces[f];
    model.names[kept] = model.names[f];
    model.numbers[kept] = model.numbers[f];
    model.part_of_face[kept] = model.part_of_face[f];
    ++kept;
  }
  model.faces.resize(kept);
  model.names.resize(kept);
  model.numbers.resize(kept);
  model.part_of_face.resize(kept);
  model.diagnostics.push_back({"read.duplicates",
                               Severity::note,
                               no_index,
                               {},
                               std::to_string(count) + (count == 1 ? " face that lies" : " faces that lie") +
                                   " on another one of the same shape left out",
                               {}});
}

}  // namespace beadmesh
