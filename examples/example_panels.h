// The example panels, by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// `single`: flat, 200 x 100 mm: one straight bead of 120 x 16 x 5.
PanelDesign single_panel();
/// `basic`: flat, 260 x 200 mm: an I, a taper, a T, a ring, an emboss, a hole.
PanelDesign basic_panel();
/// `rotated`: the same kinds in other sizes, at odd angles, some pressed downwards.
PanelDesign rotated_panel();
/// `curved`: on a cylinder of radius 1400 mm: arcs, S, X, L, rings, a corrugated cluster of rings with shared
/// loops.
PanelDesign curved_panel();
/// `floor`: doubly curved, 710 x 420 mm, every kind of bead and of what is none.
PanelDesign floor_panel();

std::vector<std::string> example_names();
/// The panel of that name, nothing where there is none.
std::optional<PanelDesign> example_panel(const std::string& name);

}  // namespace beadmesh::examples
