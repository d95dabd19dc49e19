#include <optional>
#include <string>

#include "beadmesh/medial/face_medial.h"
#include "beadmesh/pipeline.h"
#include "beadmesh/read/polygon_reader.h"
#include "bindings.h"
#include "interruptible.h"

namespace beadmesh::python {
namespace {

py::object index_or_none(Index index) {
  return index == no_index ? py::object(py::none()) : py::object(py::int_(index));
}

py::dict dict_of_edge(const MedialEdge& edge, const std::vector<Vec3>* space) {
  std::vector<Vec2> points;
  std::vector<double> radii, angles;
  py::array_t<double> feet({py::ssize_t(edge.points.size()), py::ssize_t(2), py::ssize_t(2)});
  double* at = feet.mutable_data();
  for (const MedialPoint& p : edge.points) {
    points.push_back(p.point);
    radii.push_back(p.radius);
    angles.push_back(degrees(p.subtended_angle));
    for (const Foot& foot : p.feet) *at++ = foot.point.x, *at++ = foot.point.y;
  }
  py::dict out;
  out["type"] = name_of(edge.type);
  out["start"] = index_or_none(edge.start);
  out["end"] = index_or_none(edge.end);
  out["length"] = edge.length;
  out["thickness"] = py::make_tuple(edge.thickness.min, edge.thickness.mean, edge.thickness.max);
  out["points"] = array_of(points);
  out["radii"] = array_of(radii);
  out["feet"] = feet;
  out["subtended_angles"] = array_of(angles);
  out["space"] = space ? py::object(array_of(*space)) : py::object(py::none());
  return out;
}

/// `face`: its points in space; null for a polygon.
py::dict dict_of_medial(const MedialObject& object, const PlanarRegion& region, const FaceMedial* face) {
  std::vector<Vec2> points;
  std::vector<double> radii;
  py::list types, edges_of, edges, loops;
  for (const MedialVertex& vertex : object.vertices) {
    points.push_back(vertex.point);
    radii.push_back(vertex.radius);
    types.append(name_of(vertex.type));
    edges_of.append(vertex.edges);
  }
  for (size_t e = 0; e < object.edges.size(); ++e)
    edges.append(dict_of_edge(object.edges[e], face ? &face->edge_points[e] : nullptr));
  for (const PlanarLoop& loop : region.loops) loops.append(array_of(loop.points));
  py::dict out;
  out["face"] = face ? py::object(py::int_(face->face)) : py::object(py::none());
  out["loops"] = loops;
  out["vertex_types"] = types;
  out["vertex_points"] = array_of(points);
  out["vertex_radii"] = array_of(radii);
  out["vertex_edges"] = edges_of;
  out["vertex_space"] = face ? py::object(array_of(face->vertex_points)) : py::object(py::none());
  out["edges"] = edges;
  return out;
}

Result<PlanarRegion> region_of(const std::vector<DoubleArray>& loops,
                               const std::optional<std::vector<std::vector<bool>>>& corners) {
  if (corners && corners->size() != loops.size())
    return fail("python.corners", "corners has another number of loops", "give one list a loop");
  PlanarRegion region;
  for (size_t l = 0; l < loops.size(); ++l) {
    auto points = points2_of(loops[l], "a loop");
    if (!points) return tl::unexpected(points.error());
    if (points->size() > 1 && points->front() == points->back()) points->pop_back();
    PlanarLoop loop{std::move(*points), {}, {}};
    if (corners) loop.corner = (*corners)[l];
    region.loops.push_back(std::move(loop));
  }
  return region;
}

struct OfRegion {
  PlanarRegion region;
  MedialObject object;
};

Result<OfRegion> computed(PlanarRegion region, const MedialOptions& options) {
  auto checked = checked_region(std::move(region));
  if (!checked) return tl::unexpected(checked.error());
  auto object = medial_object(*checked, options);
  if (!object) return tl::unexpected(object.error());
  return OfRegion{std::move(*checked), std::move(*object)};
}

py::dict medial_of_loops(const std::vector<DoubleArray>& loops,
                         const std::optional<std::vector<std::vector<bool>>>& corners, double corner_angle,
                         double chord, bool merge_crossings) {
  PlanarRegion region = value_or_raise(region_of(loops, corners));
  MedialOptions options;
  options.corner_angle = radians(corner_angle);
  options.chord = chord;
  options.merge_crossings = merge_crossings;
  auto result = [&] {
    const py::gil_scoped_release released;
    return computed(std::move(region), options);
  }();
  const OfRegion good = value_or_raise(std::move(result));
  return dict_of_medial(good.object, good.region, nullptr);
}

py::dict medial_of_file(const std::string& path) {
  auto result = [&]() -> Result<OfRegion> {
    const py::gil_scoped_release released;
    auto region = read_polygon(path);
    if (!region) return tl::unexpected(region.error());
    return computed(std::move(*region), {});
  }();
  const OfRegion good = value_or_raise(std::move(result));
  return dict_of_medial(good.object, good.region, nullptr);
}

/// Positions in Panel::faces of faces by their numbers; all where none is given.
Result<std::vector<Index>> faces_by_number(const Panel& panel,
                                           const std::optional<std::vector<Index>>& numbers) {
  std::vector<Index> faces;
  if (!numbers) {
    for (size_t f = 0; f < panel.faces.size(); ++f) faces.push_back(Index(f));
    return faces;
  }
  for (const Index number : *numbers) {
    const size_t before = faces.size();
    for (size_t f = 0; f < panel.faces.size(); ++f)
      if (panel.faces[f].number == number) faces.push_back(Index(f));
    if (faces.size() == before)
      return fail("usage.face", "there is no face " + std::to_string(number), "", panel.input);
  }
  return faces;
}

py::tuple medial_of_faces(const Panel& panel, const std::optional<std::vector<Index>>& numbers, int jobs) {
  const std::vector<Index> faces = value_or_raise(faces_by_number(panel, numbers));
  const PanelMedials medials =
      interruptible(jobs, [&](const Context& context) { return medials_of_faces(panel, faces, context); });
  py::list out;
  for (const FaceMedial& face : medials.faces) out.append(dict_of_medial(face.object, face.region, &face));
  return py::make_tuple(out, dicts_of(medials.diagnostics));
}

}  // namespace

void add_medial(py::module_& module) {
  module.def("medial_of_loops", &medial_of_loops, py::arg("loops"), py::arg("corners"),
             py::arg("corner_angle"), py::arg("chord"), py::arg("merge_crossings"));
  module.def("medial_of_file", &medial_of_file, py::arg("path"));
  module.def("medial_of_faces", &medial_of_faces, py::arg("panel"), py::arg("faces"), py::arg("jobs"));
}

}  // namespace beadmesh::python
