// From a design to a B-rep: one open shell whose features share their boundary edges with the sheet.
#pragma once

#include <TopoDS_Shell.hxx>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// Faces in this order: the sheet, the features in the design's order (holes have none, those with walls
/// several), the flat islands
/// inside windows, the flange's fillet and wall. Every face looks up. Edges carry their curves in the
/// parameters of both faces, exact to rounding, and a tolerance that covers the surfaces' distance from the
/// base.
TopoDS_Shell build_panel(const PanelDesign& design);

}  // namespace beadmesh::examples
