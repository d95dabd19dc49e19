// A cut across an arm: left boundary, crest, right boundary.
#pragma once

#include <vector>

#include "beadmesh/blocking/block_layout.h"

namespace beadmesh {

/// Vertices of a cut; left and right as seen when walking along the arm's own direction. `left_path` runs
/// from left to middle, `right_path` from middle to right; a cut that carries a cap has one more vertex in
/// each.
struct Chord {
  double along = 0;  ///< on the ridge arm, from its start
  Index left = no_index, middle = no_index, right = no_index;
  std::vector<Index> left_path, right_path;

  /// The same cut seen against the arm's direction.
  Chord turned() const {
    Chord out{along, right, middle, left, {}, {}};
    out.left_path.assign(right_path.rbegin(), right_path.rend());
    out.right_path.assign(left_path.rbegin(), left_path.rend());
    return out;
  }
};

/// Adds the cut's edges. `bands` > 0: so many outermost elements of each half become an edge of their own
/// where the half has more, as the clamp needs it.
void add_chord_edges(BlockLayoutBuilder& builder, Chord& chord, int elements_across, int bands);

struct CapOptions {
  int elements_across = 4;
  double radius = 0;      ///< of the inscribed circle at the end
  double size = 5;        ///< target element length
  double min_edge = 2.5;  ///< minimum element length
  int extra_rows = 0;     ///< rows along the clamp beyond what suits the size
  int rows = 0;           ///< rows along the clamp; 0: what suits the size
  int bands = 1;          ///< rows around the core, along the foot
};

/// Adds the clamp of figure 15a (m = elements_across, q = m - 2 bands) beyond a cut whose direction points to
/// the tip. `tip`: the boundary vertex; `crest`: inner points of the ridge from the cut to the tip. For m = 2
/// the core vanishes: two bands bend round at 60 degrees from the tip, where round ends have their least
/// sharp corners.
void add_end_cap(BlockLayoutBuilder& builder, const Chord& chord, Index tip, const std::vector<Vec2>& crest,
                 const CapOptions& options);

}  // namespace beadmesh
