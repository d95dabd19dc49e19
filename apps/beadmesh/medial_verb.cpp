#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <ostream>

#include "beadmesh/read/polygon_reader.h"
#include "beadmesh/report/medial_svg.h"
#include "beadmesh/write/medial_json.h"
#include "crash_guard.h"
#include "outputs.h"
#include "progress.h"
#include "summary.h"
#include "verbs.h"

namespace beadmesh::app {
namespace {

bool is_polygon(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending == ".wkt" || ending == ".poly";
}

Vec3 in_space(Vec2 p) {
  return {p.x, p.y, 0};
}

/// The plane is the surface: every point and foot gets z = 0.
void lift_flat(FaceMedial& face) {
  for (const MedialVertex& vertex : face.object.vertices) {
    face.vertex_points.push_back(in_space(vertex.point));
    std::vector<Vec3>& feet = face.vertex_feet.emplace_back();
    for (const Foot& foot : vertex.touching_points) feet.push_back(in_space(foot.point));
  }
  for (const MedialEdge& edge : face.object.edges) {
    std::vector<Vec3>& points = face.edge_points.emplace_back();
    auto& feet = face.edge_feet.emplace_back();
    for (const MedialPoint& point : edge.points) {
      points.push_back(in_space(point.point));
      feet.push_back({in_space(point.feet[0].point), in_space(point.feet[1].point)});
    }
  }
}

Result<PanelMedials> of_polygon(const Options& options) {
  if (options.face > 1) return fail("usage.face", "a plane polygon has one face only", "use --face 1 or all");
  auto region = read_polygon(options.input);
  if (!region) return tl::make_unexpected(region.error());
  auto object = medial_object(*region);
  if (!object) return tl::make_unexpected(object.error());
  FaceMedial face;
  face.face = 1;
  face.region = std::move(*region);
  face.object = std::move(*object);
  lift_flat(face);
  PanelMedials medials;
  medials.faces.push_back(std::move(face));
  return medials;
}

Result<PanelMedials> of_panel(const Options& options, const Context& context) {
  ReadOptions read = options.settings.read;
  read.skin = Skin::whole;  // any face of the file may be asked for
  const auto panel = read_guarded(options.input, read, context);
  if (!panel) return tl::make_unexpected(panel.error());
  std::vector<Index> faces;
  for (Index i = 0; i < static_cast<Index>(panel->faces.size()); ++i)
    if (!options.face || panel->faces[i].number == options.face) faces.push_back(i);
  if (faces.empty())
    return fail("usage.face", fmt::format("there is no face {}", options.face),
                fmt::format("the panel has {} faces", panel->faces.size()), panel->input);
  PanelMedials medials = medials_of_faces(*panel, faces, context);
  if (medials.faces.empty()) return tl::make_unexpected(medials.diagnostics.front());
  medials.diagnostics.insert(medials.diagnostics.begin(), panel->diagnostics.begin(),
                             panel->diagnostics.end());
  return medials;
}

}  // namespace

Result<int> run_medial(const Options& options) {
  ProgressBar bar;
  const auto medials =
      is_polygon(options.input) ? of_polygon(options) : of_panel(options, bar.context(options.settings.jobs));
  if (!medials) return tl::make_unexpected(medials.error());
  bar.clear();

  const std::string name = options.input.filename().string();
  Outputs outputs;
  outputs.add(options.outputs.json,
              [&](std::ostream& out) { write_medial_json(out, medials->faces, medials->images); });
  outputs.add(options.outputs.svg, [&](std::ostream& out) {
    out << medial_svg(medials->faces, name, {options.feet, medials->images});
  });
  if (auto put = outputs.put(); !put) return tl::make_unexpected(put.error());
  if (!outputs.uses_stdout()) fmt::print("{}", medial_summary(name, medials->faces, medials->images));
  return print_diagnostics(medials->diagnostics) ? fell_short : done;
}

}  // namespace beadmesh::app
