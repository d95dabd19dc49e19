// The crest of a bead beside its medial axis: where the cross-section is highest over the sheet.
#pragma once

#include "beadmesh/bead/skeleton.h"
#include "beadmesh/flatten/flat_face.h"

namespace beadmesh {

/// A copy of the skeleton whose points lie on the crest; radii and feet stay those of the medial axis. Where
/// a bead stands askew on its sheet (drawn along the press direction, not along the normal), one wall is
/// longer than the other and the middle of the unrolled face is not the crest. Across every touching line the
/// crest lies on the line through the middles between both walls at two heights over the chord. Near
/// junctions and ends, where touching lines are oblique, the offset of the neighbourhood is carried on.
Skeleton moved_to_crest(const Skeleton& skeleton, const SurfaceMap& map);

}  // namespace beadmesh
