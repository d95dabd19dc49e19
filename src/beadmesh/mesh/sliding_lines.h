// Lines along which nodes slide: crests, and boundaries that nobody else has set.
#pragma once

#include <vector>

#include "beadmesh/geometry/polyline.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

/// A polyline in the flat plane and the nodes on it.
struct SlidingLine {
  Polyline<Vec2> curve;
  std::vector<Index> nodes;  ///< in their order along the curve, each once
  std::vector<double> at;    ///< arc length of each node along the curve
  bool is_crest = true;      ///< else a boundary
};

/// The polyline through the nodes themselves; closed where the last node is the first again.
SlidingLine line_through(const std::vector<Index>& nodes, const std::vector<Vec2>& positions);

/// Knows where on its line each node is now. Ends of open lines, nodes of several lines and nodes that are
/// not of NodeFreedom::sliding do not slide.
class SlidingLines {
 public:
  SlidingLines() = default;
  SlidingLines(std::vector<SlidingLine> lines, const std::vector<NodeFreedom>& freedom);

  bool slides(Index node) const { return node < places_.size() && places_[node].line != no_index; }
  /// Where the node would be `shift` further along its line; it stays between its neighbours on the line.
  Vec2 shifted(Index node, double shift) const;
  /// Shift that would bring the node half way between its neighbours on the line.
  double shift_to_middle(Index node) const;
  /// Moves the node by `shift`.
  void slide(Index node, double shift);

  /// The neighbour of an end of an open crest line.
  bool next_to_tip(Index node) const;
  bool on_crest(Index node) const { return node < crest_.size() && crest_[node]; }

  /// The lines with their nodes' present places.
  const std::vector<SlidingLine>& lines() const { return lines_; }

 private:
  struct Place {
    Index line = no_index, position = no_index;  ///< the position-th node of the line
  };
  struct Range {
    double low, high;
  };
  Range room(Index node) const;
  double clamped(Index node, double shift) const;
  double position(Index node) const;

  std::vector<SlidingLine> lines_;
  std::vector<Place> places_;
  std::vector<bool> crest_;  ///< nodes of crests, their ends as well
};

}  // namespace beadmesh
