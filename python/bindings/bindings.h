// Internal to the module: what each file adds to it.
#pragma once

#include "arrays.h"
#include "beadmesh/bead/bead_table.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh::python {

/// Beads, other faces with their reasons, diagnostics.
py::dict dict_of_table(const Panel& panel, const BeadTable& table);

void add_panel(py::module_& module);   ///< Panel, read, beads
void add_medial(py::module_& module);  ///< medial objects of faces and of polygons
void add_mesh(py::module_& module);    ///< Mesh, mesh, quality, write

}  // namespace beadmesh::python
