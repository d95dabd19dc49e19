// Shells of an LS-DYNA keyword deck.
#pragma once

#include <string_view>

#include "beadmesh/core/result.h"
#include "beadmesh/read/shell_deck.h"

namespace beadmesh {

/// *NODE, *ELEMENT_SHELL with its options (THICKNESS, BETA, MCID, OFFSET, DOF), *PART and *SECTION_SHELL,
/// in columns (standard and, with LONG=Y or "%", wider) or between commas; other keywords are passed over. A
/// property is a part; its thickness is that of its section (T1). Fails with read.lsdyna.*: a card that
/// cannot be read (with its line), a node that is missing or defined twice, *INCLUDE,
/// *ELEMENT_SHELL_COMPOSITE, a binary file, no shells.
Result<ShellDeck> parse_lsdyna(std::string_view text);

}  // namespace beadmesh
