// Faces with many openings, counterparts of the figures 6 to 9 of the paper: for the medial object, not for
// beads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// A region of the plane; on a base that is not flat a curved face.
struct ExampleOutline {
  std::string name;
  PlanLoop outer;               ///< counter-clockwise
  std::vector<PlanLoop> holes;  ///< counter-clockwise
  Base base;
};

/// "spiral-bowl": a spiral band that widens, laid into a bowl (figure 6). "gasket": of a cylinder head with
/// four bores, holes of many shapes (figure 7). "circuit-board": over four hundred holes and cut-outs (figure
/// 8). "door": the inner sheet of a car door, curved, with its openings (figure 9).
std::vector<std::string> outline_names();
std::optional<ExampleOutline> example_outline(const std::string& name);

/// By ending: .wkt (the plan, lines and exact arcs as a CURVEPOLYGON) or .step (a face on the base). False
/// where the file cannot be written or has another ending.
bool write_outline(const ExampleOutline& outline, const std::filesystem::path& path);

}  // namespace beadmesh::examples
