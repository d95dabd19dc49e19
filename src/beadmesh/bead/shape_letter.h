// The letter a person would give to a bead: ends, junctions, cycles, bends.
#pragma once

#include <string>

#include "beadmesh/bead/skeleton.h"

namespace beadmesh {

/// I arc C S Z L J U G | T Y X H F trident comb ladder tree | ring: the table of docs/recognition.md.
std::string shape_letter(const Skeleton& skeleton);

}  // namespace beadmesh
