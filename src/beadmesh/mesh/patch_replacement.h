// Non-local clean-up: patches around irregular nodes filled anew with fewer of them.
#pragma once

#include <set>
#include <vector>

#include "beadmesh/mesh/mesh_editor.h"

namespace beadmesh {

/// Grows a patch around an irregular node, keeps its outline free of inward corners, and fills it with three,
/// four or five blocks once that leaves fewer irregular nodes inside and on the outline (Bunin, "Non-local
/// topological clean-up", 2006; Verma and Tautges, "Jaal", 2012).
class PatchReplacement {
 public:
  explicit PatchReplacement(MeshEditor& editor) : editor_(editor) {}

  /// Replaces the smallest patch of at most `max_quads` around `seed` that can do with fewer irregular nodes;
  /// false where none can. `touched`: the nodes in and around the new patch.
  bool improve(Index seed, int max_quads, std::vector<Index>& touched);
  /// The same for the sake of the worst element around, even where nodes become irregular.
  bool improve_shape(Index seed, int max_quads, std::vector<Index>& touched);

 private:
  bool grow_and_fill(Index seed, int max_quads, EditAim aim, std::vector<Index>& touched);

  MeshEditor& editor_;
  std::set<std::vector<Index>> failed_;  ///< quads and corners of what was tried in vain
  std::vector<int> marks_;               ///< per element: the number of the patch that has it
  int patches_ = 0;
};

}  // namespace beadmesh
