// Shells of a solver deck, whatever its format.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// A property (Nastran), part (LS-DYNA) or section (Abaqus) that shells refer to.
struct DeckProperty {
  Index id = 0;
  std::string name;      ///< may be empty
  double thickness = 0;  ///< in the deck's unit of length; 0: not in the deck
  Index material = 0;    ///< id in the deck; 0: none
};

/// A SET of Nastran's case control; the name is that of a comment "$ set ID: NAME" before it, else empty.
struct DeckSet {
  Index id = 0;
  std::string name;
  std::vector<Index> members;  ///< numbers as in the deck
};

/// Nodes and linear shells in the order of the deck.
struct ShellDeck {
  std::vector<Vec3> points;
  std::vector<Index> node_ids;                 ///< per point, as in the deck
  std::vector<std::array<Index, 4>> elements;  ///< indices in points; a triangle has no_index as its fourth
  std::vector<Index> element_ids;            ///< per element, as in the deck; its position from 1 if unknown
  std::vector<Index> properties;             ///< per element, as in the deck
  std::vector<DeckSet> sets;                 ///< of Nastran decks
  std::vector<DeckProperty> property_cards;  ///< those that the deck defines, in its order
};

}  // namespace beadmesh
