// A Nastran deck with other places of some of its nodes.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// The deck with the GRID cards of the given nodes (ids as in the deck) written anew in large fields, their
/// coordinate systems, constraints and superelements kept. Everything else stays byte by byte. The text must
/// be one that parse_nastran reads.
std::string with_moved_nodes(std::string_view deck, const std::map<Index, Vec3>& places);

}  // namespace beadmesh
