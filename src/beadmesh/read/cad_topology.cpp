#include "beadmesh/read/cad_topology.h"

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <limits>
#include <utility>

namespace beadmesh {
namespace {

class TopologyReader {
 public:
  CadTopology read(const CadModel& model) {
    for (const TopoDS_Face& face : model.faces) {
      TopExp::MapShapes(face, TopAbs_VERTEX, vertices_);
      TopExp::MapShapes(face, TopAbs_EDGE, edges_);
    }
    for (int i = 1; i <= vertices_.Extent(); ++i) {
      const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices_(i)));
      topology_.vertices.push_back({p.X(), p.Y(), p.Z()});
    }
    for (int i = 1; i <= edges_.Extent(); ++i) add_edge(TopoDS::Edge(edges_(i).Oriented(TopAbs_FORWARD)));
    for (const TopoDS_Face& face : model.faces) add_face(TopoDS::Face(face.Oriented(TopAbs_FORWARD)));
    return std::move(topology_);
  }

 private:
  void add_edge(const TopoDS_Edge& edge) {
    CadEdge item;
    item.edge = edge;
    if (!BRep_Tool::Degenerated(edge)) {
      item.curve = BRep_Tool::Curve(edge, item.first, item.last);
      if (item.curve.IsNull() && BRepLib::BuildCurve3d(edge))
        item.curve = BRep_Tool::Curve(edge, item.first, item.last);
    }
    item.first_vertex = vertex(TopExp::FirstVertex(edge), item, item.first);
    item.last_vertex = TopExp::LastVertex(edge).IsNull() ? item.first_vertex
                                                         : vertex(TopExp::LastVertex(edge), item, item.last);
    topology_.edges.push_back(std::move(item));
  }

  /// A closed edge need not have a vertex: then its curve's start becomes one.
  Index vertex(const TopoDS_Vertex& v, const CadEdge& edge, double parameter) {
    if (!v.IsNull()) return vertices_.FindIndex(v) - 1;
    const gp_Pnt p = edge.is_pole() ? gp_Pnt() : edge.curve->Value(parameter);
    topology_.vertices.push_back({p.X(), p.Y(), p.Z()});
    return static_cast<Index>(topology_.vertices.size()) - 1;
  }

  void add_face(const TopoDS_Face& face) {
    CadFace item;
    item.surface = BRep_Tool::Surface(face);
    item.broken = item.surface.IsNull();
    for (TopoDS_Iterator at(face); at.More() && !item.broken; at.Next()) {
      if (at.Value().ShapeType() != TopAbs_WIRE) continue;
      std::vector<CadUse> uses;
      for (TopoDS_Iterator e(at.Value()); e.More(); e.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(e.Value());
        if (edge.Orientation() == TopAbs_INTERNAL || edge.Orientation() == TopAbs_EXTERNAL) continue;
        uses.push_back(use_of(edge, face));
        item.broken = item.broken || uses.back().curve.IsNull();
      }
      if (!item.broken) chain_uses(std::move(uses), item);
    }
    topology_.faces.push_back(std::move(item));
  }

  CadUse use_of(const TopoDS_Edge& edge, const TopoDS_Face& face) const {
    CadUse use;
    use.edge = edges_.FindIndex(edge) - 1;
    use.reversed = edge.Orientation() == TopAbs_REVERSED;
    use.curve = BRep_Tool::CurveOnSurface(edge, face, use.first, use.last);
    return use;
  }

  Index tail(const CadUse& use) const {
    const CadEdge& edge = topology_.edges[use.edge];
    return use.reversed ? edge.last_vertex : edge.first_vertex;
  }
  Index head(const CadUse& use) const {
    const CadEdge& edge = topology_.edges[use.edge];
    return use.reversed ? edge.first_vertex : edge.last_vertex;
  }
  static Vec2 uv_at(const CadUse& use, bool at_tail) {
    const gp_Pnt2d p = use.curve->Value(at_tail != use.reversed ? use.first : use.last);
    return {p.X(), p.Y()};
  }

  /// Orders the edges of a wire head to tail: by shared vertex, and where several edges leave it (a seam), by
  /// the nearest parameters.
  void chain_uses(std::vector<CadUse> uses, CadFace& face) const {
    std::vector<bool> taken(uses.size(), false);
    for (std::size_t first = 0; first < uses.size(); ++first) {
      if (taken[first]) continue;
      std::vector<CadUse> loop;
      for (std::size_t at = first; at != uses.size(); at = next_use(uses, taken, loop.back())) {
        taken[at] = true;
        loop.push_back(uses[at]);
      }
      face.broken = face.broken || head(loop.back()) != tail(loop.front());
      face.loops.push_back(std::move(loop));
    }
  }

  std::size_t next_use(const std::vector<CadUse>& uses, const std::vector<bool>& taken,
                       const CadUse& last) const {
    std::size_t best = uses.size();
    double best_gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < uses.size(); ++i) {
      if (taken[i] || tail(uses[i]) != head(last)) continue;
      const double gap = distance(uv_at(last, false), uv_at(uses[i], true));
      if (gap < best_gap) best = i, best_gap = gap;
    }
    return best;
  }

  TopTools_IndexedMapOfShape vertices_, edges_;
  CadTopology topology_;
};

}  // namespace

Vec2 CadUse::uv(const CadEdge& of, double t) const {
  const double span = of.last - of.first;
  const bool same_range = of.is_pole() || (of.first == first && of.last == last) || span == 0;
  const gp_Pnt2d p = curve->Value(same_range ? t : first + (t - of.first) * ((last - first) / span));
  return {p.X(), p.Y()};
}

CadTopology topology_of(const CadModel& model) {
  return TopologyReader().read(model);
}

}  // namespace beadmesh
