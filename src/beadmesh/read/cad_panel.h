// Inside the read room: facets of a CAD model put together as a panel.
#pragma once

#include <vector>

#include "beadmesh/panel/panel.h"
#include "beadmesh/read/cad_facets.h"
#include "beadmesh/read/cad_model.h"

namespace beadmesh {

/// Shares points and edges, orients the faces, adds the evaluators. Faces without sound facets are left out
/// and named in Panel::diagnostics.
Panel assemble_panel(const CadModel& model, const CadTopology& topology, const std::vector<FaceNodes>& faces);

}  // namespace beadmesh
