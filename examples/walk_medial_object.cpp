// walk_medial_object FILE [FACE]: how a program of yours uses the medial object. Reads a plane polygon (.wkt,
// .poly) or one face of a panel (.step, .iges, .brep, .stl, ...), walks its axis and asks it some questions.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include "beadmesh/medial/medial_query.h"
#include "beadmesh/pipeline.h"
#include "beadmesh/read/panel_reader.h"
#include "beadmesh/read/polygon_reader.h"

namespace {

using namespace beadmesh;

/// From text: read, then compute. Both can fail and say why.
Result<MedialObject> of_polygon(const std::filesystem::path& file) {
  const auto region = read_polygon(file);
  if (!region) return tl::unexpected(region.error());
  return medial_object(*region);
}

/// From CAD: the face is laid flat first. FaceMedial also has every point on the surface, which is not used
/// here.
Result<MedialObject> of_face(const std::filesystem::path& file, Index number) {
  const auto panel = read_panel(file);
  if (!panel) return tl::unexpected(panel.error());
  for (Index i = 0; i < static_cast<Index>(panel->faces.size()); ++i) {
    if (panel->faces[i].number != number) continue;
    auto face = medial_of_face(*panel, i);
    if (!face) return tl::unexpected(face.error());
    return face->object;
  }
  return fail("usage.face", "there is no face " + std::to_string(number));
}

/// Every vertex, and the edges around it.
void print_vertices(const MedialObject& medial) {
  for (Index v = 0; v < static_cast<Index>(medial.vertices.size()); ++v) {
    const MedialVertex& vertex = medial.vertices[v];
    std::printf("vertex %d: %s at (%.3f, %.3f), thickness %.3f\n", v, name_of(vertex.type).c_str(),
                vertex.point.x, vertex.point.y, 2 * vertex.radius);
    for (const Departure way : departures(medial, v)) {
      const MedialEdge& edge = medial.edges[way.edge];
      std::printf("  edge %d (%s) to vertex %d, length %.3f, thickness %.3f to %.3f\n", way.edge,
                  name_of(edge.type).c_str(), arrival(medial, way), edge.length, edge.thickness.min,
                  edge.thickness.max);
    }
  }
}

/// The thickest place along each edge lies somewhere between its ends; here the middle is looked at.
void print_middles(const MedialObject& medial) {
  for (std::size_t e = 0; e < medial.edges.size(); ++e) {
    const MedialPoint middle = point_at(medial.edges[e], medial.edges[e].length / 2);
    std::printf("edge %zu at %.3f: thickness %.3f between (%.3f, %.3f) and (%.3f, %.3f)\n", e,
                medial.edges[e].length / 2, 2 * middle.radius, middle.feet[0].point.x, middle.feet[0].point.y,
                middle.feet[1].point.x, middle.feet[1].point.y);
  }
}

/// Questions about a point: here the middle of the box around all vertices.
void ask_about_the_middle(const MedialObject& medial) {
  Vec2 low = medial.vertices.empty() ? medial.edges[0].points[0].point : medial.vertices[0].point, high = low;
  for (const MedialVertex& vertex : medial.vertices) {
    low = {std::min(low.x, vertex.point.x), std::min(low.y, vertex.point.y)};
    high = {std::max(high.x, vertex.point.x), std::max(high.y, vertex.point.y)};
  }
  const Vec2 p = lerp(low, high, 0.5);
  const MedialQuery query(medial);
  const NearestAxis near = *query.nearest(p);
  const LocalThickness local = *query.thickness_at(p);
  std::printf("point (%.3f, %.3f): axis %.3f away, on edge %d at %.3f; thickness %.3f%s\n", p.x, p.y,
              near.gap, near.place.edge, near.place.distance, local.thickness,
              local.outside > 1e-3 * medial.size ? " (outside)" : "");
}

/// The way along the axis from the first to the last vertex.
void print_path(const MedialObject& medial) {
  if (medial.vertices.size() < 2) return;
  const Index last = static_cast<Index>(medial.vertices.size()) - 1;
  const std::vector<Departure> path = path_between(medial, 0, last);
  std::printf("from vertex 0 to vertex %d: %zu edges, %.3f of %.3f long\n", last, path.size(),
              total_length(medial, path), total_length(medial));
}

int failed(const Diagnostic& diagnostic) {
  std::fprintf(stderr, "%s\n", to_line(diagnostic).c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "walk_medial_object FILE [FACE]\n");
    return 2;
  }
  const std::filesystem::path file = argv[1];
  Index face = 1;
  if (argc == 3 && std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), face).ec != std::errc())
    return failed({"usage.face", Severity::error, no_index, argv[2], "is no number of a face", ""});
  const bool is_polygon = file.extension() == ".wkt" || file.extension() == ".poly";
  const auto medial = is_polygon ? of_polygon(file) : of_face(file, face);
  if (!medial) return failed(medial.error());
  print_vertices(*medial);
  print_middles(*medial);
  ask_about_the_middle(*medial);
  print_path(*medial);
  return 0;
}
