#include <memory>
#include <string>
#include <vector>

#include "beadmesh/pipeline.h"
#include "beadmesh/read/panel_reader.h"
#include "bindings.h"
#include "interruptible.h"

namespace beadmesh::python {
namespace {

Panel read(const std::string& path, const std::string& unit, double chord, double angle, double max_facet,
           double sew_tolerance, double feature_angle, const std::string& skin, int jobs) {
  ReadOptions options;
  options.unit = unit;
  options.chord = chord;
  options.angle = radians(angle);
  options.max_facet = max_facet;
  options.sew_tolerance = sew_tolerance;
  options.feature_angle = radians(feature_angle);
  options.skin = value_or_raise(skin_of(skin));
  return value_or_raise(
      interruptible(jobs, [&](const Context& context) { return read_panel(path, options, context); }));
}

Panel compose(const Panel& panel, const BeadOptions& options, int jobs) {
  return interruptible(jobs, [&](const Context& context) { return compose_faces(panel, options, context); });
}

py::list facets(const Panel& panel) {
  py::list out;
  for (const PanelFace& face : panel.faces) {
    py::array_t<Index> triangles({py::ssize_t(face.facets.triangles.size()), py::ssize_t(3)});
    Index* at = triangles.mutable_data();
    for (const Triangle& t : face.facets.triangles)
      for (const Index corner : t) *at++ = corner;
    out.append(py::make_tuple(face.number, array_of(face.facets.points), triangles));
  }
  return out;
}

py::dict dict_of_bead(const Panel& panel, const Bead& bead) {
  py::list ridge;
  for (const RidgeCurve& curve : bead.ridge) {
    std::vector<Vec3> points = curve.points;
    if (curve.closed && !points.empty()) points.push_back(points.front());
    ridge.append(array_of(points));
  }
  py::dict out;
  out["id"] = bead.id;
  out["kind"] = name_of(bead.kind);
  out["shape"] = bead.shape;
  out["faces"] = input_numbers(panel, bead.faces);
  out["point"] = py::make_tuple(bead.point.x, bead.point.y, bead.point.z);
  out["loops"] = bead.loops;
  out["length"] = bead.length;
  out["width"] = bead.width;
  out["height"] = bead.height;
  out["aspect_ratio"] = bead.aspect_ratio;
  out["confidence"] = bead.confidence;
  out["junctions"] = bead.junctions;
  out["ends"] = bead.ends;
  out["medial_edges"] = bead.medial_edges;
  out["ridge"] = ridge;
  return out;
}

}  // namespace

py::dict dict_of_table(const Panel& panel, const BeadTable& table) {
  py::list beads, others;
  for (const Bead& bead : table.beads) beads.append(dict_of_bead(panel, bead));
  for (const RejectedFace& face : table.faces_not_beads)
    others.append(py::make_tuple(face.face, face.reason));
  py::dict out;
  out["beads"] = beads;
  out["faces_not_beads"] = others;
  out["diagnostics"] = dicts_of(table.diagnostics);
  return out;
}

namespace {

py::dict beads(const Panel& panel, const BeadOptions& options, int jobs) {
  const BeadTable table =
      interruptible(jobs, [&](const Context& context) { return recognise_beads(panel, options, context); });
  return dict_of_table(panel, table);
}

}  // namespace

void add_panel(py::module_& module) {
  py::class_<BeadOptions>(module, "BeadOptions")
      .def(py::init([](double min_aspect_ratio, double max_joint_angle, int max_loops, double min_rise) {
             BeadOptions options;
             options.min_aspect_ratio = min_aspect_ratio;
             options.max_joint_angle = radians(max_joint_angle);
             options.max_loops = max_loops;
             options.min_rise = min_rise;
             return options;
           }),
           py::arg("min_aspect_ratio"), py::arg("max_joint_angle"), py::arg("max_loops"),
           py::arg("min_rise"));
  py::class_<Panel>(module, "Panel")
      .def_readonly("input", &Panel::input)
      .def_readonly("unit", &Panel::unit)
      .def_property_readonly("face_count", [](const Panel& panel) { return input_face_count(panel); })
      .def_property_readonly("diagnostics", [](const Panel& panel) { return dicts_of(panel.diagnostics); })
      .def("facets", &facets);
  module.def("read", &read, py::arg("path"), py::arg("unit"), py::arg("chord"), py::arg("angle"),
             py::arg("max_facet"), py::arg("sew_tolerance"), py::arg("feature_angle"), py::arg("skin"),
             py::arg("jobs"));
  module.def("compose", &compose, py::arg("panel"), py::arg("options"), py::arg("jobs"));
  module.def("beads", &beads, py::arg("panel"), py::arg("options"), py::arg("jobs"));
}

}  // namespace beadmesh::python
