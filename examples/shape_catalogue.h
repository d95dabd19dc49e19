// Every bead shape once, with proportions that follow from the width.
#pragma once

#include <string>
#include <vector>

#include "examples/footprint.h"

namespace beadmesh::examples {

struct CatalogueShape {
  std::string name;   ///< one word
  std::string shape;  ///< letter of the bead table
  std::string kind;   ///< of the paper's rule; empty: no bead, since it has too many loops
  /// Footprints about one origin; several share loops, the outermost first, and lie alternately up and down.
  /// The factors stretch its lengths, 1 for the shape as it is meant.
  std::vector<Footprint> (*make)(double width, double factor, double other_factor);
};

const std::vector<CatalogueShape>& shape_catalogue();

}  // namespace beadmesh::examples
