// Inside the read room: which facets are one face: sheet, or what rises from it.
#pragma once

#include <vector>

#include "beadmesh/read/facet_mesh.h"
#include "beadmesh/read/sheet_growth.h"

namespace beadmesh {

struct FacetGroupingOptions {
  double feature_angle =
      radians(40);  ///< default 40 degrees: a sharper turn between facets ends smooth material
  double coarse_angle = radians(70);  ///< default 70 degrees: the same where facets are as large as fillets
  double min_height = 0.2;            ///< default 0.2 mm: what rises less is sheet
  double level_height = 0.2;          ///< default 0.2 of the feature's height: lower patches can be sheet
  double most_level_height = 1.2;     ///< default 1.2 mm: but no higher ones
  double level_angle = radians(6);    ///< default 6 degrees: sheet leans no more against the continued sheet
  double saddle = 0.35;               ///< default 0.35 of the lower peak: a lower saddle parts two features
};

/// Faces of a facetted skin.
struct FacetGroups {
  std::vector<Index> face;       ///< per triangle, from 0 in the order of their first triangles
  std::vector<bool> is_feature;  ///< per face: rises from the sheet around it
};

/// Patches of sheet, the largest first. What lies between them and is enclosed by one is a feature, together
/// with the patches that lie higher (crowns, tops), cut off where the sheet begins to turn; patches as high
/// as the sheet continued below them (islands in rings) are sheet again. Features that only meet at their
/// feet are parted. Whatever else lies between sheets (fillets of flanges, steps) is split at sharp edges
/// only.
FacetGroups group_facets(const FacetMesh& mesh, const std::vector<Index>& patch,
                         const FacetGroupingOptions& options);

}  // namespace beadmesh
