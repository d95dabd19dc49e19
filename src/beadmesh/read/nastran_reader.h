// Shells of a Nastran deck.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/core/vector.h"

namespace beadmesh {

/// Nodes and linear shells in the order of the deck.
struct ShellDeck {
  std::vector<Vec3> points;
  std::vector<Index> node_ids;                 ///< per point, as in the deck
  std::vector<std::array<Index, 4>> elements;  ///< indices in points; a triangle has no_index as its fourth
  std::vector<Index> properties;               ///< per element, as in the deck
};

/// GRID, CQUAD4 and CTRIA3 (CQUADR, CTRIAR alike) in small, large and free field; other cards are passed
/// over. Fails with read.nastran.*: a card that cannot be read (with its line), a node that is missing or
/// defined twice, a coordinate system other than the basic one, INCLUDE, no shells.
Result<ShellDeck> parse_nastran(std::string_view text);

/// By ending: .bdf .nas .dat. Fails as above and with read.not_found, read.ending.
Result<ShellDeck> read_nastran(const std::filesystem::path& path);

}  // namespace beadmesh
