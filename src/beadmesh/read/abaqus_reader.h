// Shells of an Abaqus or CalculiX input deck.
#pragma once

#include <string_view>

#include "beadmesh/core/result.h"
#include "beadmesh/read/shell_deck.h"

namespace beadmesh {

/// *NODE, *ELEMENT with shell types (S3, S3R, S4, S4R, S4RS, STRI3, M3D3, M3D4, ...; of S6, STRI65, S8, S8R
/// the corners), *ELSET and *SHELL SECTION; other keywords are passed over. A property is a section, or where
/// there is none the set of *ELEMENT, numbered from 1 in the order of the deck. Fails with read.abaqus.*: a
/// line that cannot be read (with its number), a node that is missing or defined twice, *INCLUDE, *SYSTEM or
/// *INSTANCE (transformed or repeated parts), no shells.
Result<ShellDeck> parse_abaqus(std::string_view text);

}  // namespace beadmesh
