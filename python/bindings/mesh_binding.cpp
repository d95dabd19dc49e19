#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/pipeline.h"
#include "beadmesh/report/panel_html.h"
#include "beadmesh/report/panel_svg.h"
#include "beadmesh/write/deck.h"
#include "beadmesh/write/whole_files.h"
#include "bindings.h"
#include "interruptible.h"

namespace beadmesh::python {
namespace {

/// What a report needs of a run beside the arrays: as it was made, whatever is done to these later.
struct MadeMesh {
  Panel panel;
  PanelMesh mesh;
  MeshSizes sizes;
};

// ------------------------------------------------------------------ a mesh from the library to Python

py::array_t<Index> elements_of(const ShellMesh& mesh) {
  py::array_t<Index> out({py::ssize_t(mesh.elements.size()), py::ssize_t(4)});
  Index* at = out.mutable_data();
  for (const ShellElement& element : mesh.elements)
    for (const Index node : element.nodes) *at++ = node;
  return out;
}

py::array_t<Index> column_of(const ShellMesh& mesh, Index ShellElement::*member) {
  std::vector<Index> column;
  for (const ShellElement& element : mesh.elements) column.push_back(element.*member);
  return array_of(column);
}

py::list dicts_of_sets(const ShellMesh& mesh) {
  py::list out;
  for (const BeadSet& set : mesh.beads) {
    py::list lines;
    for (const auto& line : set.crest_lines) lines.append(array_of(line));
    py::dict one;
    one["bead"] = set.bead;
    one["kind"] = set.kind;
    one["shape"] = set.shape;
    one["elements"] = array_of(set.elements);
    one["crest_nodes"] = array_of(set.crest_nodes);
    one["boundary_nodes"] = array_of(set.boundary_nodes);
    one["cap_elements"] = array_of(set.cap_elements);
    one["crest_lines"] = lines;
    out.append(one);
  }
  return out;
}

py::dict dict_of_mesh(const ShellMesh& mesh) {
  py::list parts;
  for (const ShellPart& part : mesh.parts) parts.append(py::make_tuple(part.id, part.name, part.thickness));
  py::dict out;
  out["title"] = mesh.title;
  out["nodes"] = array_of(mesh.nodes);
  out["elements"] = elements_of(mesh);
  out["part"] = column_of(mesh, &ShellElement::part);
  out["face"] = column_of(mesh, &ShellElement::face);
  out["bead"] = column_of(mesh, &ShellElement::bead);
  out["parts"] = parts;
  out["sets"] = dicts_of_sets(mesh);
  return out;
}

py::list dicts_of_meshing(const std::vector<BeadMeshing>& meshing) {
  py::list out;
  for (const BeadMeshing& bead : meshing) {
    py::dict one;
    one["method"] = bead.method;
    one["elements"] = bead.elements;
    one["elements_across"] = bead.elements_across;
    one["notes"] = bead.notes;
    out.append(one);
  }
  return out;
}

// ------------------------------------------------------------------ what is asked of a mesh

Result<BeadMeshControl> control_of(const py::dict& values) {
  BeadMeshControl control;
  for (const auto& [key, value] : values) {
    const std::string name = py::str(key);
    try {
      if (name == "size")
        control.size = value.cast<double>();
      else if (name == "min_edge")
        control.min_edge = value.cast<double>();
      else if (name == "elements_across")
        control.elements_across = value.cast<int>();
      else if (name == "elements_along")
        control.elements_along = value.cast<int>();
      else if (name == "clamp_rows")
        control.clamp_rows = value.cast<int>();
      else if (name == "method")
        control.method = bead_method_of(value.cast<std::string>());
      else
        return fail("control.key", "unknown key '" + name + "'",
                    "known: size, min_edge, elements_across, elements_along, clamp_rows, method");
    } catch (const py::cast_error&) {
      return fail("control.type", "the value of '" + name + "' has the wrong type");
    }
    if (name == "method" && !control.method)
      return fail("control.method", "unknown method", "known: automatic, blocks, ridge, face");
  }
  return control;
}

using Ball = std::tuple<std::array<double, 3>, double, double>;

Result<MeshSizes> sizes_of(double size, double min_edge, double thickness, const py::dict& all,
                           const std::map<std::string, py::dict>& kinds,
                           const std::map<Index, py::dict>& single, const std::vector<Ball>& balls) {
  MeshSizes sizes{size, min_edge, thickness, {}, {}};
  const auto put = [&](const py::dict& values, BeadMeshControl& target) -> Result<void> {
    auto control = control_of(values);
    if (!control) return tl::unexpected(control.error());
    target = *control;
    return {};
  };
  if (auto done = put(all, sizes.beads.all); !done) return tl::unexpected(done.error());
  for (const auto& [name, values] : kinds) {
    if (name != "I" && name != "generic" && name != "annular")
      return fail("control.kind", "unknown kind '" + name + "'", "known: I, generic, annular");
    const BeadKind kind = name == "I"         ? BeadKind::I
                          : name == "generic" ? BeadKind::generic
                                              : BeadKind::annular;
    if (auto done = put(values, sizes.beads.of(kind)); !done) return tl::unexpected(done.error());
  }
  for (const auto& [id, values] : single) {
    BeadMeshControl control;
    if (auto done = put(values, control); !done) return tl::unexpected(done.error());
    sizes.beads.single.push_back({{id, {}}, control});
  }
  for (const auto& [point, radius, local] : balls)
    sizes.local.push_back({{point[0], point[1], point[2]}, radius, local});
  return sizes;
}

/// Lengths that make sense, as the program checks them.
Result<void> check_sizes(const MeshSizes& sizes) {
  const std::pair<const char*, double> lengths[] = {
      {"size", sizes.size}, {"min_edge", sizes.min_edge}, {"thickness", sizes.thickness}};
  for (const auto& [name, value] : lengths)
    if (!(value > 0) || !std::isfinite(value))
      return fail("usage." + std::string(name), std::string(name) + " is " + std::to_string(value),
                  "it must be above 0");
  if (sizes.min_edge > sizes.size)
    return fail("usage.min_edge", "min_edge is above size", "half the size is usual");
  return {};
}

py::dict mesh(const Panel& panel, double size, double min_edge, double thickness, const BeadOptions& options,
              const py::dict& all, const std::map<std::string, py::dict>& kinds,
              const std::map<Index, py::dict>& single, const std::vector<Ball>& balls, int jobs) {
  const MeshSizes sizes = value_or_raise(sizes_of(size, min_edge, thickness, all, kinds, single, balls));
  if (auto good = check_sizes(sizes); !good) raise(good.error());
  PanelMesh made = value_or_raise(interruptible(
      jobs, [&](const Context& context) { return mesh_panel(panel, sizes, options, context); }));
  made.mesh.title = panel.input;
  py::dict out = dict_of_mesh(made.mesh);
  out["table"] = dict_of_table(panel, made.table);
  out["meshing"] = dicts_of_meshing(made.meshing);
  out["made"] = MadeMesh{panel, std::move(made), sizes};
  return out;
}

bool ends_with(const std::string& text, std::string_view ending) {
  return text.size() > ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

void write_report(const MadeMesh& made, const std::string& path) {
  const bool is_flat = ends_with(path, ".svg");
  if (!is_flat && !ends_with(path, ".html") && !ends_with(path, ".htm"))
    raise(Diagnostic{"usage.report", Severity::error, no_index, path, "unknown ending of a report",
                     "known: .html .htm .svg"});
  const Result<void> done = [&] {
    const py::gil_scoped_release released;
    return write_whole(path, [&](std::ostream& out) {
      const MeshSizes& sizes = made.sizes;
      out << (is_flat ? panel_svg(made.mesh)
                      : panel_html(made.panel, made.mesh,
                                   facts_of_run(made.panel, sizes.size, sizes.min_edge, sizes.thickness)));
    });
  }();
  if (!done) raise(done.error());
}

// ------------------------------------------------------------------ a mesh from Python to the library

Result<std::vector<MeshElement>> elements_from(const IndexArray& elements, Index node_count) {
  if (elements.ndim() != 2 || elements.shape(1) != 4)
    return fail("python.shape", "elements must have the shape (m, 4)",
                "a triangle has -1 as its fourth node");
  std::vector<MeshElement> out(elements.shape(0));
  const Index* at = elements.data();
  for (size_t e = 0; e < out.size(); ++e)
    for (int k = 0; k < 4; ++k, ++at) {
      out[e][k] = *at;
      if ((*at < 0 || *at >= node_count) && !(k == 3 && *at == no_index))
        return fail("python.element", "its node " + std::to_string(*at) + " does not exist", "",
                    "element " + std::to_string(e));
    }
  return out;
}

py::dict quality(const DoubleArray& nodes, const IndexArray& elements, double min_edge) {
  const std::vector<Vec3> points = value_or_raise(points3_of(nodes, "nodes"));
  const auto corners = value_or_raise(elements_from(elements, Index(points.size())));
  std::vector<double> jacobian, warped, shortest, longest, smallest, largest;
  QualitySummary s;
  {
    const py::gil_scoped_release released;
    for (const MeshElement& element : corners) {
      jacobian.push_back(scaled_jacobian(points, element));
      warped.push_back(degrees(warpage(points, element)));
      const auto sides = side_lengths(points, element), angles = corner_angles(points, element);
      shortest.push_back(sides[0]);
      longest.push_back(sides[1]);
      smallest.push_back(degrees(angles[0]));
      largest.push_back(degrees(angles[1]));
    }
    s = summarise(points, corners, min_edge);
  }
  py::dict out;
  out["scaled_jacobian"] = array_of(jacobian);
  out["warpage"] = array_of(warped);
  out["shortest_edge"] = array_of(shortest);
  out["longest_edge"] = array_of(longest);
  out["smallest_angle"] = array_of(smallest);
  out["largest_angle"] = array_of(largest);
  out["quads"] = s.quads;
  out["triangles"] = s.trias;
  out["inverted"] = s.inverted;
  out["edges_below_min"] = s.edges_below_min;
  out["irregular_nodes"] = s.irregular;
  return out;
}

using Part = std::tuple<Index, std::string, double>;

Result<ShellMesh> shell_mesh_of(const py::dict& from) {
  ShellMesh mesh;
  mesh.title = from["title"].cast<std::string>();
  auto nodes = points3_of(from["nodes"].cast<DoubleArray>(), "nodes");
  if (!nodes) return tl::unexpected(nodes.error());
  mesh.nodes = std::move(*nodes);
  auto elements = elements_from(from["elements"].cast<IndexArray>(), Index(mesh.nodes.size()));
  if (!elements) return tl::unexpected(elements.error());
  const auto part = from["part"].cast<std::vector<Index>>(), face = from["face"].cast<std::vector<Index>>(),
             bead = from["bead"].cast<std::vector<Index>>();
  if (part.size() != elements->size() || face.size() != part.size() || bead.size() != part.size())
    return fail("python.shape", "part, face and bead must have one item an element");
  for (size_t e = 0; e < part.size(); ++e)
    mesh.elements.push_back({(*elements)[e], part[e], face[e], bead[e]});
  for (const auto& [id, name, thickness] : from["parts"].cast<std::vector<Part>>())
    mesh.parts.push_back({id, name, thickness});
  return mesh;
}

Result<void> add_sets(const py::list& sets, ShellMesh& mesh) {
  using Items = std::vector<Index>;
  const auto exist = [](const Items& items, size_t count) {
    return std::all_of(items.begin(), items.end(), [&](Index i) { return i >= 0 && size_t(i) < count; });
  };
  for (const auto& item : sets) {
    const py::dict from = item.cast<py::dict>();
    BeadSet set{from["bead"].cast<Index>(), from["kind"].cast<std::string>(),
                from["shape"].cast<std::string>(), from["elements"].cast<Items>(),
                from["crest_nodes"].cast<Items>()};
    set.boundary_nodes = from["boundary_nodes"].cast<Items>();
    set.cap_elements = from["cap_elements"].cast<Items>();
    set.crest_lines = from["crest_lines"].cast<std::vector<Items>>();
    bool good = exist(set.elements, mesh.elements.size()) && exist(set.cap_elements, mesh.elements.size()) &&
                exist(set.crest_nodes, mesh.nodes.size()) && exist(set.boundary_nodes, mesh.nodes.size());
    for (const Items& line : set.crest_lines) good = good && exist(line, mesh.nodes.size());
    if (!good)
      return fail("python.set", "a member does not exist", "", "set of bead " + std::to_string(set.bead));
    for (Items* items : {&set.elements, &set.cap_elements, &set.crest_nodes, &set.boundary_nodes})
      std::sort(items->begin(), items->end());
    mesh.beads.push_back(std::move(set));
  }
  return {};
}

void write(const py::dict& from, const std::string& path, const DeckOptions& options) {
  ShellMesh mesh = value_or_raise(shell_mesh_of(from));
  if (auto good = add_sets(from["sets"].cast<py::list>(), mesh); !good) raise(good.error());
  const Result<void> done = [&] {
    const py::gil_scoped_release released;
    return write_deck(mesh, path, options);
  }();
  if (!done) raise(done.error());
}

Result<DeckAnalysis> analysis_of(const std::string& name) {
  if (name == "modes") return DeckAnalysis::modes;
  if (name == "none") return DeckAnalysis::none;
  return fail("usage.analysis", "unknown analysis '" + name + "'", "known: modes, none");
}

}  // namespace

void add_mesh(py::module_& module) {
  py::class_<MadeMesh>(module, "MadeMesh").def("write_report", &write_report, py::arg("path"));
  py::class_<DeckOptions>(module, "DeckOptions")
      .def(py::init([](Index first_node, Index first_element, Index first_property, Index set_offset,
                       const std::string& analysis) {
             return DeckOptions{first_node, first_element, first_property, set_offset,
                                value_or_raise(analysis_of(analysis))};
           }),
           py::arg("first_node"), py::arg("first_element"), py::arg("first_property"), py::arg("set_offset"),
           py::arg("analysis"));
  module.def("mesh", &mesh, py::arg("panel"), py::arg("size"), py::arg("min_edge"), py::arg("thickness"),
             py::arg("options"), py::arg("beads"), py::arg("kinds"), py::arg("single"),
             py::arg("local_sizes"), py::arg("jobs"));
  module.def("quality", &quality, py::arg("nodes"), py::arg("elements"), py::arg("min_edge"));
  module.def("write", &write, py::arg("mesh"), py::arg("path"), py::arg("options"));
}

}  // namespace beadmesh::python
