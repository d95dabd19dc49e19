// Private to this room: pieces of SVG text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh::drawing {

/// Text for XML and HTML, attributes included. Bytes that are no UTF-8 and control characters become '?'.
std::string escaped(std::string_view text);

struct Color {
  int red = 0, green = 0, blue = 0;
};

std::string hex(Color color);
/// Every channel times `factor`, clamped.
Color shaded(Color color, double factor);
/// Dark violet over blue and green to yellow for t in [0, 1]: even steps look even, with any colour vision
/// and in grey (after the map "viridis", van der Walt and Smith 2015).
Color ramp(double t);

/// Path data in hundredths of a pixel, relative and without blanks where none is needed: a fifth of the plain
/// text. Belongs inside a group with `scale(0.01)`.
class Path {
 public:
  void polyline(const std::vector<Vec2>& points, bool closed);
  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }

 private:
  void number(long value, bool first);

  std::string text_;
};

/// The points without those that lie within `tolerance` of the line through what is left (Douglas and Peucker
/// 1973); both ends stay.
std::vector<Vec2> thinned(const std::vector<Vec2>& points, double tolerance);

/// A round length (1, 2 or 5 times a power of ten) not above `length`.
double round_length(double length);

/// World to pixels: y turned downwards, the box of the points at `origin`, `width` x `height` at most.
class Frame {
 public:
  Frame(const std::vector<Vec2>& points, Vec2 origin, double width, double height);
  Vec2 operator()(Vec2 p) const {
    return {origin_.x + (p.x - low_.x) * scale_, origin_.y + (high_.y - p.y) * scale_};
  }
  double scale() const { return scale_; }
  double width() const { return (high_.x - low_.x) * scale_; }
  double height() const { return (high_.y - low_.y) * scale_; }

 private:
  Vec2 origin_, low_, high_;
  double scale_ = 1;
};

}  // namespace beadmesh::drawing
