#include "beadmesh/read/cad_panel.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "beadmesh/read/cad_evaluators.h"
#include "beadmesh/read/orientation.h"

namespace beadmesh {
namespace {

using HalfEdge = std::pair<Index, Index>;

/// Half-edges without an opposite, sorted; false where two triangles run the same way along an edge.
bool boundary_of(const Facets& facets, std::vector<HalfEdge>& boundary) {
  std::vector<HalfEdge> all;
  for (const Triangle& t : facets.triangles)
    for (int k = 0; k < 3; ++k) all.push_back({t[k], t[(k + 1) % 3]});
  std::sort(all.begin(), all.end());
  if (std::adjacent_find(all.begin(), all.end()) != all.end()) return false;
  boundary.clear();
  for (const HalfEdge& h : all)
    if (!std::binary_search(all.begin(), all.end(), HalfEdge{h.second, h.first})) boundary.push_back(h);
  return true;
}

std::vector<HalfEdge> segments_of(const std::vector<std::vector<Index>>& loops) {
  std::vector<HalfEdge> result;
  for (const std::vector<Index>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) result.push_back({loop[i], loop[(i + 1) % loop.size()]});
  std::sort(result.begin(), result.end());
  return result;
}

bool is_connected(const Facets& facets) {
  std::vector<Index> parent(facets.points.size());
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = static_cast<Index>(v);
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : facets.triangles) {
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  for (const Triangle& t : facets.triangles)
    if (root(t[0]) != root(facets.triangles.front()[0])) return false;
  return true;
}

bool is_sound(const Facets& facets) {
  std::vector<HalfEdge> boundary;
  return !facets.triangles.empty() && !facets.loops.empty() && boundary_of(facets, boundary) &&
         boundary == segments_of(facets.loops) && is_connected(facets);
}

/// Facets of one face, while its nodes turn into local vertices and panel points.
struct FaceDraft {
  PanelFace face;
  std::vector<Index> node;    // per node: the node that stands for it (all nodes of a pole are one)
  std::vector<Index> point;   // per node: its panel point, or no_index for an inner node
  std::vector<Index> vertex;  // per node: its local vertex, or no_index
  std::map<Index, std::pair<Vec2, Vec2>>
      pole_side;  // node of a pole -> the side of the parameters it stands for
};

class PanelAssembler {
 public:
  PanelAssembler(const CadModel& model, const CadTopology& topology, const std::vector<FaceNodes>& faces)
      : model_(model), topology_(topology), faces_(faces) {
    panel_.unit = model.unit;
    panel_.diagnostics = model.diagnostics;
    panel_.parts = model.parts;
    panel_.points = topology.vertices;
    edge_points_.resize(topology.edges.size());
    panel_edge_.assign(topology.edges.size(), no_index);
  }

  Panel assemble() {
    for (std::size_t f = 0; f < faces_.size(); ++f) add_face(f);
    panel_ = without_unused_points(std::move(panel_));  // of faces left out, of vertices no edge needs
    const std::vector<bool> turned = orient_faces(panel_);
    for (std::size_t f = 0; f < panel_.faces.size(); ++f) {
      const Index source = source_[f];
      panel_.faces[f].facets.surfaces = {
          surface_of(topology_.faces[source].surface, turned[f] != is_reversed(source))};
    }
    return std::move(panel_);
  }

 private:
  bool is_reversed(std::size_t f) const { return model_.faces[f].Orientation() == TopAbs_REVERSED; }

  void leave_out(std::size_t f, std::string message) {
    panel_.diagnostics.push_back({"read.face.left_out",
                                  Severity::error,
                                  model_.numbers[f],
                                  {},
                                  std::move(message),
                                  "repair the face in the CAD system"});
  }

  void add_face(std::size_t f) {
    const FaceNodes& nodes = faces_[f];
    if (nodes.triangles.empty()) return leave_out(f, "the face cannot be facetted: " + nodes.defect);
    FaceDraft draft;
    place_nodes(nodes, draft);
    fill_triangles(nodes, draft);
    fill_loops(nodes, draft);
    if (is_reversed(f)) turn_over(draft.face);
    if (!is_sound(draft.face.facets)) return leave_out(f, "the facets of the face do not fill its loops");
    finish_face(f, std::move(draft.face));
  }

  /// Panel points of an edge in the direction of its curve, made at its first use.
  const std::vector<Index>& edge_points(Index e) {
    std::vector<Index>& points = edge_points_[e];
    if (!points.empty()) return points;
    const CadEdge& edge = topology_.edges[e];
    points.push_back(edge.first_vertex);
    for (std::size_t i = 1; i + 1 < edge.points.size(); ++i) {
      points.push_back(static_cast<Index>(panel_.points.size()));
      panel_.points.push_back(edge.points[i]);
    }
    points.push_back(edge.last_vertex);
    return points;
  }

  static bool is_pole(const NodeRun& run) { return run.edge == no_index; }

  void place_nodes(const FaceNodes& nodes, FaceDraft& draft) {
    draft.node.resize(nodes.points.size());
    for (std::size_t i = 0; i < draft.node.size(); ++i) draft.node[i] = static_cast<Index>(i);
    draft.point.assign(nodes.points.size(), no_index);
    draft.vertex.assign(nodes.points.size(), no_index);
    for (const std::vector<NodeRun>& loop : nodes.loops)
      for (const NodeRun& run : loop) {
        if (is_pole(run)) {
          draft.point[run.nodes.front()] = run.vertex;
          for (const Index n : run.nodes) draft.node[n] = run.nodes.front();
          draft.pole_side[run.nodes.front()] = {nodes.uv[run.nodes.front()], nodes.uv[run.nodes.back()]};
          continue;
        }
        const std::vector<Index>& points = edge_points(run.edge);
        for (std::size_t i = 0; i < run.nodes.size(); ++i)
          draft.point[run.nodes[i]] = points[run.reversed ? points.size() - 1 - i : i];
      }
  }

  Index vertex_of(const FaceNodes& nodes, Index node, FaceDraft& draft) {
    node = draft.node[node];
    Index& vertex = draft.vertex[node];
    if (vertex != no_index) return vertex;
    Index& point = draft.point[node];
    if (point == no_index) {
      point = static_cast<Index>(panel_.points.size());
      panel_.points.push_back(nodes.points[node]);
    }
    Facets& facets = draft.face.facets;
    vertex = static_cast<Index>(facets.points.size());
    facets.points.push_back(panel_.points[point]);
    facets.panel_points.push_back(point);
    return vertex;
  }

  /// A pole has many parameters: a triangle takes those between its other corners, so that its inside maps
  /// well.
  static std::array<Vec2, 3> corner_uv(const FaceNodes& nodes, const Triangle& t, const FaceDraft& draft) {
    std::array<Vec2, 3> uv{nodes.uv[t[0]], nodes.uv[t[1]], nodes.uv[t[2]]};
    for (int k = 0; k < 3; ++k) {
      const auto pole = draft.pole_side.find(draft.node[t[k]]);
      if (pole == draft.pole_side.end()) continue;
      const auto [from, to] = pole->second;
      const Vec2 along = to - from, others = (uv[(k + 1) % 3] + uv[(k + 2) % 3]) / 2;
      uv[k] = from + along * std::clamp(dot(others - from, along) / squared_norm(along), 0.0, 1.0);
    }
    return uv;
  }

  void fill_triangles(const FaceNodes& nodes, FaceDraft& draft) {
    for (const Triangle& t : nodes.triangles) {
      const Triangle v{vertex_of(nodes, t[0], draft), vertex_of(nodes, t[1], draft),
                       vertex_of(nodes, t[2], draft)};
      if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;  // collapsed at a pole
      draft.face.facets.triangles.push_back(v);
      draft.face.facets.triangle_uv.push_back(corner_uv(nodes, t, draft));
    }
  }

  void fill_loops(const FaceNodes& nodes, FaceDraft& draft) {
    for (const std::vector<NodeRun>& loop : nodes.loops) {
      std::vector<EdgeUse> uses;
      std::vector<Index> vertices;
      for (const NodeRun& run : loop) {
        if (is_pole(run)) continue;
        uses.push_back({run.edge, run.reversed});
        for (std::size_t i = 0; i + 1 < run.nodes.size(); ++i)
          vertices.push_back(vertex_of(nodes, run.nodes[i], draft));
      }
      if (uses.empty()) continue;
      draft.face.loops.push_back(std::move(uses));
      draft.face.facets.loops.push_back(std::move(vertices));
    }
  }

  void finish_face(std::size_t f, PanelFace face) {
    const std::size_t outer = outer_loop(face.facets);
    std::swap(face.loops[0], face.loops[outer]);
    std::swap(face.facets.loops[0], face.facets.loops[outer]);
    face.number = model_.numbers[f];
    face.name = model_.names[f];
    face.part = model_.part_of_face[f];
    source_.push_back(static_cast<Index>(f));
    const Index id = static_cast<Index>(panel_.faces.size());
    face.facets.triangle_surface.assign(face.facets.triangles.size(), 0);
    for (std::vector<EdgeUse>& loop : face.loops)
      for (EdgeUse& use : loop) {
        use.edge = panel_edge(use.edge);
        panel_.edges[use.edge].faces.push_back(id);
      }
    panel_.faces.push_back(std::move(face));
  }

  Index panel_edge(Index e) {
    if (panel_edge_[e] != no_index) return panel_edge_[e];
    PanelEdge edge;
    edge.points = edge_points(e);
    if (ends_on_curve(topology_.edges[e])) {
      edge.curve = curve_of(topology_.edges[e].curve);
      edge.parameters = topology_.edges[e].parameters;
    }
    panel_edge_[e] = static_cast<Index>(panel_.edges.size());
    panel_.edges.push_back(std::move(edge));
    return panel_edge_[e];
  }

  /// In damaged files, and where wide gaps were sewn, vertices lie elsewhere: the points are all there is
  /// then.
  bool ends_on_curve(const CadEdge& edge) const {
    constexpr double limit = 0.01;  // mm
    const auto off = [&](double t, Index vertex) {
      const gp_Pnt p = edge.curve->Value(t);
      return distance({p.X(), p.Y(), p.Z()}, topology_.vertices[vertex]);
    };
    return off(edge.parameters.front(), edge.first_vertex) <= limit &&
           off(edge.parameters.back(), edge.last_vertex) <= limit;
  }

  const CadModel& model_;
  const CadTopology& topology_;
  const std::vector<FaceNodes>& faces_;
  Panel panel_;
  std::vector<Index> source_;                    // per panel face: the model's
  std::vector<std::vector<Index>> edge_points_;  // per CAD edge
  std::vector<Index> panel_edge_;                // per CAD edge: index in panel_.edges, or no_index
};

}  // namespace

Panel assemble_panel(const CadModel& model, const CadTopology& topology,
                     const std::vector<FaceNodes>& faces) {
  return PanelAssembler(model, topology, faces).assemble();
}

}  // namespace beadmesh
