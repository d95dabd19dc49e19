#include "beadmesh/report/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beadmesh::drawing {
namespace {

/// Length of the UTF-8 sequence at `i`, 0 where there is none.
size_t sequence_length(std::string_view text, size_t i) {
  const auto byte = [&](size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0; };
  const int lead = byte(i);
  const size_t length = lead < 0x80                   ? 1
                        : lead >= 0xC2 && lead < 0xE0 ? 2
                        : lead >= 0xE0 && lead < 0xF0 ? 3
                        : lead >= 0xF0 && lead < 0xF5 ? 4
                                                      : 0;
  for (size_t k = 1; k < length; ++k)
    if ((byte(i + k) & 0xC0) != 0x80) return 0;
  return length;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (size_t i = 0; i < text.size();) {
    const size_t length = sequence_length(text, i);
    const unsigned char c = static_cast<unsigned char>(text[i]);
    if (length == 0 || c < 32 || c == 127) {
      result += '?';
    } else if (length > 1) {
      result += text.substr(i, length);
    } else {
      switch (c) {
        case '&':
          result += "&amp;";
          break;
        case '<':
          result += "&lt;";
          break;
        case '>':
          result += "&gt;";
          break;
        case '"':
          result += "&quot;";
          break;
        case '\'':
          result += "&#39;";
          break;
        default:
          result += static_cast<char>(c);
      }
    }
    i += std::max<size_t>(1, length);
  }
  return result;
}

std::string hex(Color color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue);
}

Color shaded(Color color, double factor) {
  const auto channel = [&](int value) {
    return std::clamp(static_cast<int>(std::lround(value * factor)), 0, 255);
  };
  return {channel(color.red), channel(color.green), channel(color.blue)};
}

Color ramp(double t) {
  constexpr Color stops[] = {{68, 1, 84},    {72, 40, 120},  {62, 74, 137},  {49, 104, 142}, {38, 130, 142},
                             {31, 158, 137}, {53, 183, 121}, {109, 205, 89}, {180, 222, 44}, {253, 231, 37}};
  constexpr int last = 9;
  const double at = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * last;
  const int i = std::min(static_cast<int>(at), last - 1);
  const auto mix = [&](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * (at - i))); };
  return {mix(stops[i].red, stops[i + 1].red), mix(stops[i].green, stops[i + 1].green),
          mix(stops[i].blue, stops[i + 1].blue)};
}

void Path::number(long value, bool first) {
  if (!first && value >= 0) text_ += ' ';
  text_ += std::to_string(value);
}

void Path::polyline(const std::vector<Vec2>& points, bool closed) {
  long x = 0, y = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const long next_x = std::lround(points[i].x * 100), next_y = std::lround(points[i].y * 100);
    if (i == 0) text_ += 'M';
    if (i == 1) text_ += 'l';
    number(next_x - x, i <= 1);
    number(next_y - y, false);
    x = next_x, y = next_y;
  }
  if (closed && !points.empty()) text_ += 'z';
}

std::vector<Vec2> thinned(const std::vector<Vec2>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<size_t, size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const Vec2 chord = points[last] - points[first];
    const double length = squared_norm(chord);
    size_t worst = first;
    double farthest = tolerance;
    for (size_t i = first + 1; i < last; ++i) {
      const Vec2 d = points[i] - points[first];
      const double along = length > 0 ? std::clamp(dot(d, chord) / length, 0.0, 1.0) : 0;
      const double gap = norm(d - chord * along);
      if (gap > farthest) farthest = gap, worst = i;
    }
    if (worst == first) continue;
    kept[worst] = true;
    open.emplace_back(first, worst);
    open.emplace_back(worst, last);
  }
  std::vector<Vec2> result;
  for (size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

double round_length(double length) {
  if (!(length > 0) || !std::isfinite(length)) return 1;
  const double power = std::pow(10, std::floor(std::log10(length)));
  const double ratio = length / power;
  return power * (ratio >= 5 ? 5 : ratio >= 2 ? 2 : 1);
}

Frame::Frame(const std::vector<Vec2>& points, Vec2 origin, double width, double height) : origin_(origin) {
  constexpr double far = std::numeric_limits<double>::infinity();
  low_ = {far, far}, high_ = {-far, -far};
  for (const Vec2 p : points) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  if (points.empty()) low_ = high_ = {0, 0};
  const double x = high_.x - low_.x, y = high_.y - low_.y;
  if (x > 0 || y > 0) scale_ = std::min(x > 0 ? width / x : far, y > 0 ? height / y : far);
}

}  // namespace beadmesh::drawing
