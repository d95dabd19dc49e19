// Sheet that CAD has cut along construction lines, as one face.
#pragma once

#include <vector>

#include "beadmesh/core/context.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

struct JoinedSheetOptions {
  double feature_angle = radians(3);   ///< default 3 degrees: what turns more at an edge is not joined
  double least_radius = 150;           ///< default 150 mm: what bends more beside an edge is not joined
  double max_stretch = 1.15;           ///< default 1.15: what cannot be laid flat so well is not joined
  std::vector<Index> kept_edges = {};  ///< faces are not joined over them, and do not get into one group
};

/// The edge of the panel nearest to each point, inner edges before those of the rim, ascending; points
/// further than `reach` (mm) from every edge go to `missed`.
std::vector<Index> edges_at(const Panel& panel, const std::vector<Vec3>& points, double reach,
                            std::vector<Vec3>& missed);

/// Groups of faces (indices, ascending) that meet at edges without a turn and without a bend: the edges carry
/// no feature, and nothing of the mesh should follow them. A group that cannot be laid flat well is left out.
std::vector<std::vector<Index>> joined_sheets(const Panel& panel, const JoinedSheetOptions& options = {},
                                              const Context& context = {});

}  // namespace beadmesh
