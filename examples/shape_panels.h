// Panels made to order: every bead shape at chosen dimensions, or a mix by chance.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "examples/panel_design.h"

namespace beadmesh::examples {

enum class BaseKind { flat, cylinder, double_curved, saddle };

struct ShapePanelOptions {
  double width = 16;  ///< mm, mean width of every bead
  double height = 5;  ///< mm, negative downwards
  BaseKind base = BaseKind::flat;
  double radius = 0;                   ///< mm, of the base's stronger curvature; 0: 1.6 times the larger side
  std::uint64_t seed = 0;              ///< 0: shapes as in the catalogue; else turned and stretched by chance
  std::vector<std::string> only = {};  ///< names of the catalogue; empty: all of them
};

/// Each shape once, in rows, at least half a width and 8 mm apart; nothing where a name is unknown.
std::optional<PanelDesign> shapes_panel(const ShapePanelOptions& options);

struct RandomPanelOptions {
  std::uint64_t seed = 1;
  int beads = 20;                               ///< that are tried; what finds no place is left out
  std::optional<BaseKind> base = std::nullopt;  ///< nothing: by chance
  double length = 0, width = 0;                 ///< mm, of the sheet; 0: by chance
};

/// Gives every feature that has faces walls by chance: a root fillet, a drafted wall, a top fillet, all
/// narrower than its half width; straight ones may run out at their ends.
void add_walls(PanelDesign& panel, std::uint64_t seed);

/// Shapes, sizes (8 to 40 mm wide, 2 to 10 mm high), turns, base, holes and the sheet's size by chance; the
/// same for the same options, everywhere.
PanelDesign random_panel(const RandomPanelOptions& options);

}  // namespace beadmesh::examples
