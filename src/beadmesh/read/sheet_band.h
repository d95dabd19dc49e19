// Inside the read room: the sheet beside a piece of a facetted skin, continued under it.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/geometry/quadratic_sheet.h"
#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// Through the facets of face `sheet` (numbers per triangle in `face`) that lie beside `piece`, a few rows
/// deep. Nothing where they do not touch.
std::optional<QuadraticSheet> sheet_beside(const FacetMesh& mesh, const std::vector<Index>& face, Index sheet,
                                           const std::vector<Index>& piece);

/// Are facets of one size nearly everywhere, and as large as the fillets of beads (over 1 mm)? Then a turn of
/// 60 degrees can be a fillet.
bool is_coarse(const FacetMesh& mesh);

}  // namespace beadmesh
