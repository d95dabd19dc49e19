// Private to this room: what the colours and marks of a medial picture mean.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/core/vector.h"
#include "beadmesh/medial/medial_object.h"
#include "beadmesh/report/drawing.h"

namespace beadmesh::drawing {

/// How vertices of a type are drawn.
struct Mark {
  MedialVertexType type;
  const char* name;
  const char* fill;
  const char* rim;
  std::vector<Vec2> outline;  ///< about the origin, about 1 across from the middle
};

/// Of all types, in the order of the legend.
const std::vector<Mark>& marks();

/// The range of thicknesses behind the colours, mm.
struct ThicknessRange {
  double low = 0, high = 0;

  /// Fraction of a thickness, 0 to 1.
  double fraction(double thickness) const;
};

/// The range of all edges; an even thickness is widened, so that its noise does not look like change.
ThicknessRange thickness_range(const std::vector<const MedialObject*>& objects);

inline constexpr const char* cut_color = "#c2185b";

struct Legend {
  ThicknessRange range;
  std::vector<int> counts;  ///< of the marks; 0: not shown
  bool has_cuts = false;
};

/// The legend as an SVG group at `origin`, `width` wide and `legend_height` high.
std::string legend_svg(const Legend& legend, Vec2 origin, double width);
inline constexpr double legend_height = 52;

/// Round numbers within [low, high], about `count` of them.
std::vector<double> round_ticks(double low, double high, int count);

}  // namespace beadmesh::drawing
