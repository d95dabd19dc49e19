#include "beadmesh/report/panel_scene.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/report/element_measures.h"
#include "beadmesh/report/packed_numbers.h"

namespace beadmesh {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PackedNumbers& numbers) {
  return {{"rows", numbers.rows},
          {"stride", numbers.stride},
          {"bytes", numbers.bytes},
          {"differences", numbers.packing == Packing::differences},
          {"text", numbers.text}};
}

Json json_of(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// The grid that coordinates are rounded to.
class Grid {
 public:
  void take(Vec3 p) {
    if (!std::isfinite(p.x + p.y + p.z)) return;
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }

  void close() {
    if (low_.x > high_.x) low_ = high_ = {0, 0, 0};
    const Vec3 size = high_ - low_;
    step_ = std::max({size.x, size.y, size.z, 1e-9}) / 1e6;
  }

  Vec3 low() const { return low_; }
  double step() const { return step_; }

  void put(std::vector<std::int32_t>& out, Vec3 p) const {
    for (const double value : {p.x - low_.x, p.y - low_.y, p.z - low_.z}) out.push_back(rounded(value));
  }
  std::int32_t rounded(double length) const {
    return std::isfinite(length)
               ? static_cast<std::int32_t>(std::clamp(std::round(length / step_), -2e9, 2e9))
               : 0;
  }

  PackedNumbers packed_points(const std::vector<Vec3>& points) const {
    std::vector<std::int32_t> values;
    values.reserve(3 * points.size());
    for (const Vec3& p : points) put(values, p);
    return packed(values, 3, Packing::differences);
  }

 private:
  Vec3 low_{1e300, 1e300, 1e300}, high_{-1e300, -1e300, -1e300};
  double step_ = 1;
};

/// Polylines behind each other.
class Lines {
 public:
  explicit Lines(const Grid& grid) : grid_(grid) {}

  void add(const std::vector<Vec3>& points, bool closed, Index bead, Index kind = 0) {
    if (points.size() < 2) return;
    for (const Vec3& p : points) grid_.put(points_, p);
    if (closed) grid_.put(points_, points.front());
    counts_.push_back(static_cast<std::int32_t>(points.size() + closed));
    beads_.push_back(bead);
    kinds_.push_back(kind);
  }

  Json json() const {
    return {{"counts", json_of(packed(counts_))},
            {"beads", json_of(packed(beads_))},
            {"kinds", json_of(packed(kinds_))},
            {"points", json_of(packed(points_, 3, Packing::differences))}};
  }

 private:
  const Grid& grid_;
  std::vector<std::int32_t> points_, counts_, beads_, kinds_;
};

class Scene {
 public:
  Scene(const Panel& panel, const PanelMesh& mesh, const ReportFacts& facts)
      : panel_(panel), mesh_(mesh), facts_(facts) {
    for (const PanelFace& face : panel.faces)
      for (const Vec3& p : face.facets.points) grid_.take(p);
    for (const Vec3& p : mesh.mesh.nodes) grid_.take(p);
    grid_.close();
    bead_of_face_.assign(panel.faces.size(), 0);
    for (const Bead& bead : mesh.table.beads)
      for (const Index f : bead.faces)
        if (f >= 0 && f < static_cast<Index>(bead_of_face_.size())) bead_of_face_[f] = bead.id;
  }

  std::string text() const {
    Json all = {{"schema", "beadmesh.report/1"},
                {"title", facts_.title},
                {"origin", json_of(grid_.low())},
                {"step", grid_.step()},
                {"minimum_edge", facts_.min_edge},
                {"beads", beads()},
                {"faces", faces()},
                {"surface", surface()},
                {"crests", crests()},
                {"axes", axes()},
                {"blocks", blocks()},
                {"mesh", mesh()}};
    return without_brackets(all.dump(-1, ' ', false, Json::error_handler_t::replace));
  }

 private:
  static std::string without_brackets(const std::string& text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) c == '<' ? out += "\\u003c" : out += c;
    return out;
  }

  Json beads() const {
    Json list = Json::array();
    for (const Bead& bead : mesh_.table.beads)
      list.push_back({{"id", bead.id},
                      {"kind", name_of(bead.kind)},
                      {"shape", bead.shape},
                      {"point", json_of(bead.point)},
                      {"width", bead.width}});
    return list;
  }

  Json faces() const {
    Json list = Json::array();
    for (size_t f = 0; f < panel_.faces.size(); ++f) {
      const Index face = static_cast<Index>(f);
      list.push_back({{"numbers", input_numbers(panel_, {face})}, {"bead", bead_of_face_[f]}});
    }
    return list;
  }

  Json surface() const {
    std::vector<std::int32_t> points, triangles, point_counts, triangle_counts;
    for (const PanelFace& face : panel_.faces) {
      for (const Vec3& p : face.facets.points) grid_.put(points, p);
      for (const Triangle& t : face.facets.triangles)
        for (const Index corner : t) triangles.push_back(corner);
      point_counts.push_back(static_cast<std::int32_t>(face.facets.points.size()));
      triangle_counts.push_back(static_cast<std::int32_t>(face.facets.triangles.size()));
    }
    return {{"point_counts", json_of(packed(point_counts))},
            {"triangle_counts", json_of(packed(triangle_counts))},
            {"points", json_of(packed(points, 3, Packing::differences))},
            {"triangles", json_of(packed(triangles, 3, Packing::differences))}};
  }

  Json crests() const {
    Lines lines(grid_);
    for (const Bead& bead : mesh_.table.beads)
      for (const RidgeCurve& curve : bead.ridge) lines.add(curve.points, curve.closed, bead.id);
    return lines.json();
  }

  /// With the thickness at every point.
  Json axes() const {
    Lines lines(grid_);
    std::vector<std::int32_t> thickness;
    for (size_t b = 0; b < mesh_.table.medials.size(); ++b) {
      const FaceMedial& medial = mesh_.table.medials[b];
      const Index bead = b < mesh_.table.beads.size() ? mesh_.table.beads[b].id : 0;
      for (size_t e = 0; e < medial.edge_points.size(); ++e) {
        const MedialEdge& edge = medial.object.edges[e];
        const bool closed = edge.type == MedialEdgeType::N;
        if (medial.edge_points[e].size() < 2) continue;
        lines.add(medial.edge_points[e], closed, bead);
        for (const MedialPoint& p : edge.points) thickness.push_back(grid_.rounded(2 * p.radius));
        if (closed) thickness.push_back(grid_.rounded(2 * edge.points.front().radius));
      }
    }
    Json json = lines.json();
    json["thickness"] = json_of(packed(thickness, 1, Packing::differences));
    return json;
  }

  Json blocks() const {
    Lines lines(grid_);
    int count = 0;
    for (size_t b = 0; b < std::min(mesh_.meshing.size(), mesh_.table.beads.size()); ++b) {
      count += mesh_.meshing[b].blocks;
      for (const BlockSideLine& line : mesh_.meshing[b].block_lines)
        lines.add(line.points, false, mesh_.table.beads[b].id, static_cast<Index>(line.kind));
    }
    Json json = lines.json();
    json["count"] = count;
    json["kind_names"] = {"boundary", "split line", "crest", "inner line"};
    return json;
  }

  Json mesh() const {
    const ShellMesh& shell = mesh_.mesh;
    std::vector<std::int32_t> corners, runs;
    for (const ShellElement& element : shell.elements) {
      for (const Index node : element.nodes) corners.push_back(node == no_index ? element.nodes[2] : node);
      const size_t last = runs.size();
      if (last > 0 && runs[last - 3] == element.face && runs[last - 2] == element.bead)
        ++runs[last - 1];
      else
        runs.insert(runs.end(), {element.face, element.bead, 1});
    }
    Json json = {{"nodes", json_of(grid_.packed_points(shell.nodes))},
                 {"corners", json_of(packed(corners, 4, Packing::differences))},
                 {"runs", json_of(packed(runs, 3))}};
    Json measures = Json::array();
    for (const ElementMeasure& measure : element_measures(shell, facts_.criteria))
      measures.push_back(measure_json(measure));
    json["measures"] = std::move(measures);
    return json;
  }

  static Json measure_json(const ElementMeasure& measure) {
    std::vector<std::int32_t> steps, failing;
    steps.reserve(measure.values.size());
    const double range = measure.high - measure.low;
    for (size_t e = 0; e < measure.values.size(); ++e) {
      const auto& value = measure.values[e];
      steps.push_back(!value ? -1
                             : static_cast<std::int32_t>(
                                   range > 0 ? std::lround((*value - measure.low) / range * 65535) : 0));
      if (measure.failing[e]) failing.push_back(static_cast<std::int32_t>(e));
    }
    Json json = {{"name", measure.name},
                 {"unit", measure.unit},
                 {"meaning", measure.meaning},
                 {"low", measure.low},
                 {"high", measure.high},
                 {"large_is_bad", measure.large_is_bad},
                 {"values", json_of(packed(steps))}};
    json["limit"] = measure.limit ? Json(*measure.limit) : Json();
    json["failing"] = json_of(packed(failing, 1, Packing::differences));
    return json;
  }

  const Panel& panel_;
  const PanelMesh& mesh_;
  const ReportFacts& facts_;
  Grid grid_;
  std::vector<Index> bead_of_face_;  ///< per face of the panel the id of its bead, 0: none
};

}  // namespace

std::string panel_scene(const Panel& panel, const PanelMesh& mesh, const ReportFacts& facts) {
  return Scene(panel, mesh, facts).text();
}

}  // namespace beadmesh
