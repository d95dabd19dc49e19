// Crest polylines along which crest nodes slide.
#pragma once

#include <vector>

#include "beadmesh/mesh/surface_nodes.h"

namespace beadmesh {

/// Keeps the original polylines and where each of their nodes is now, as arc length in the flat plane. Ends,
/// nodes of several lines and nodes that are not of NodeFreedom::crest do not slide.
class CrestLines {
 public:
  CrestLines() = default;
  CrestLines(const std::vector<std::vector<Index>>& lines, const std::vector<Vec2>& positions,
             const std::vector<NodeFreedom>& freedom);

  bool slides(Index node) const { return node < places_.size() && places_[node].line != no_index; }
  /// Where the node would be `shift` further along its line; it stays between its neighbours on the line.
  Vec2 shifted(Index node, double shift) const;
  /// Shift that would bring the node half way between its neighbours on the line.
  double shift_to_middle(Index node) const;
  /// Moves the node by `shift`.
  void slide(Index node, double shift) { places_[node].arc = clamped(node, shift); }

 private:
  struct Line {
    std::vector<Index> nodes;
    std::vector<Vec2> points;
    std::vector<double> arc;
  };
  struct Place {
    Index line = no_index, position = no_index;
    double arc = 0;
  };
  double clamped(Index node, double shift) const;
  double arc_of(const Line& line, Index position) const;

  std::vector<Line> lines_;
  std::vector<Place> places_;
};

}  // namespace beadmesh
