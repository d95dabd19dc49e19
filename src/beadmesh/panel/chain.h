// Boundary chains: the stretches of B-rep edges between two real corners, that receive mesh nodes once for
// all faces.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// Position on a chain's polyline: segment i runs from points[i] to points[i + 1], fraction in [0, 1].
struct ChainPosition {
  Index segment = 0;
  double fraction = 0;
};

/// A maximal run of edges between the same two faces without a corner. A vertex inside a chain where the
/// edges meet tangentially is no mesh constraint.
struct Chain {
  std::vector<EdgeUse> edges;                      ///< head to tail
  std::vector<Index> points;                       ///< indices into Panel::points; closed: first == last
  std::vector<double> arc_length;                  ///< per point, from 0; last = length
  std::array<Index, 2> faces{no_index, no_index};  ///< left (runs along its loop) and right; no_index: free
  bool closed = false;

  double length() const { return arc_length.back(); }
};

struct ChainUse {
  Index chain = no_index;
  bool reversed = false;
};

struct ChainSet {
  std::vector<Chain> chains;
  /// face -> loop -> uses, head to tail in the direction of Panel::faces[f].loops[l].
  std::vector<std::vector<std::vector<ChainUse>>> loops;
};

/// corner_angle: edges that turn by more than this (radians) end a chain. Default 30 degrees.
ChainSet chains_of(const Panel& panel, double corner_angle = radians(30));

ChainPosition position_at(const Chain& chain, double arc_length);

/// Point at a position: on the exact curve where there is one, else on the polyline.
Vec3 point_at(const Panel& panel, const Chain& chain, ChainPosition position);

}  // namespace beadmesh
