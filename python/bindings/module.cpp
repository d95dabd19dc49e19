#include "beadmesh/core/version.h"
#include "bindings.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The library under the package beadmesh; use that instead.";
  module.attr("__version__") = std::string(beadmesh::version());
  beadmesh::python::add_panel(module);
  beadmesh::python::add_medial(module);
  beadmesh::python::add_mesh(module);
}
