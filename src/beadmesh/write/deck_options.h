// How a mesh is numbered in a deck, and what the deck makes the solver do.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

enum class DeckAnalysis {
  modes,  ///< runs as it is: the first 16 normal modes of the free panel
  none,   ///< nodes, elements, properties and sets only, to be included in another deck
};

struct DeckOptions {
  Index first_node = 1;      ///< default 1: id of the first node
  Index first_element = 1;   ///< default 1: id of the first element
  Index first_property = 1;  ///< default 1: id of the first property; the material has it too
  Index set_offset = 0;      ///< default 0: added to the ids of the sets
  DeckAnalysis analysis = DeckAnalysis::modes;
  std::vector<std::string> remarks = {};  ///< comment lines for the head, such as the options of the run
};

}  // namespace beadmesh
