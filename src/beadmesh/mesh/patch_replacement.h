// Non-local clean-up: patches around irregular nodes filled anew with fewer of them.
#pragma once

#include <vector>

#include "beadmesh/mesh/mesh_editor.h"

namespace beadmesh {

struct PatchOptions {
  int max_quads = 120;  ///< default 120: a patch does not grow beyond
};

/// Grows a patch around the irregular node, keeps its outline free of inward corners, and fills it with
/// three, four or five blocks once that leaves fewer irregular nodes inside and on the outline (Bunin,
/// "Non-local topological clean-up", 2006; Verma and Tautges, "Jaal", 2012). False where no size of patch
/// helps.
bool replace_patch(MeshEditor& editor, Index seed, const PatchOptions& options, std::vector<Index>& touched);

}  // namespace beadmesh
