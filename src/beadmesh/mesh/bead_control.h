// What a user asks of the mesh of beads: of all, of a kind, of one.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/core/result.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

enum class BeadMethod {
  automatic,  ///< blocks, then ridge insertion, then the ordinary face
  blocks,     ///< blocks, else the ordinary face
  ridge,      ///< ridge insertion, else the ordinary face
  face,       ///< the ordinary face
};

/// What is not set is chosen by the program.
struct BeadMeshControl {
  std::optional<double> size;          ///< target element length, mm
  std::optional<double> min_edge;      ///< minimum element length, mm; at least that of the panel
  std::optional<int> elements_across;  ///< even, so that the crest is a line of the mesh; or 1
  std::optional<int>
      elements_along;             ///< on the strip of every arm, between clamps and hubs; ring: around, even
  std::optional<int> clamp_rows;  ///< p of the clamp (figure 15a of the paper)
  std::optional<BeadMethod> method;

  bool operator==(const BeadMeshControl&) const = default;
};

/// One bead: by its number in the table, or the bead nearest to a point.
struct BeadSelection {
  Index id = 0;  ///< 1-based; 0: by the point
  Vec3 point;    ///< mm
};

/// The special wins over the general, and of several for one bead the later.
struct BeadControls {
  BeadMeshControl all;
  std::array<BeadMeshControl, 3> of_kind;  ///< by BeadKind
  std::vector<std::pair<BeadSelection, BeadMeshControl>> single;

  BeadMeshControl& of(BeadKind kind) { return of_kind[static_cast<size_t>(kind)]; }
  const BeadMeshControl& of(BeadKind kind) const { return of_kind[static_cast<size_t>(kind)]; }
};

std::optional<BeadMethod> bead_method_of(const std::string& name);
/// What `over` sets wins.
BeadMeshControl overlaid(BeadMeshControl base, const BeadMeshControl& over);

/// Fails with control.* where a value makes no sense in a panel of this size and minimum edge (mm).
Result<void> check_control(const BeadMeshControl& control, double size, double min_edge);

/// The control of every bead of the table. A point means the bead whose face is nearest to it, and not
/// further than half the bead's width. Fails with control.bead where a selection means no bead, and like
/// check_control.
Result<std::vector<BeadMeshControl>> controls_of_beads(const BeadControls& controls, const Panel& panel,
                                                       const BeadTable& table, double size, double min_edge);

}  // namespace beadmesh
