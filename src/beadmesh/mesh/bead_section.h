// The cross-sections of a bead: how well a number of elements across them follows the surface.
#pragma once

#include "beadmesh/bead/skeleton.h"
#include "beadmesh/flatten/flat_face.h"

namespace beadmesh {

/// Distance of the sections from the polygons through m + 1 points, `elements_across` = m equal lengths from
/// foot over crest to foot: the distance that three quarters of the sections keep, in mm. `crest`: arms with
/// their points on the crest. Sections lie where touching lines run across an arm; 0 where none does.
double section_deviation(const Skeleton& crest, const SurfaceMap& map, int elements_across);

}  // namespace beadmesh
