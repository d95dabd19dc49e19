// Shells of a Nastran deck.
#pragma once

#include <string_view>

#include "beadmesh/core/result.h"
#include "beadmesh/read/shell_deck.h"

namespace beadmesh {

/// GRID, CQUAD4 and CTRIA3 (CQUADR, CTRIAR alike) and PSHELL in small, large and free field; other cards are
/// passed over, but for SET in the case control (what is not understood there is passed over). Fails with
/// read.nastran.*: a card that cannot be read (with its line), a node that is missing or defined twice, a
/// coordinate system other than the basic one, INCLUDE, no shells.
Result<ShellDeck> parse_nastran(std::string_view text);

}  // namespace beadmesh
