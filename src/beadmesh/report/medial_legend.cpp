#include "beadmesh/report/medial_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace beadmesh::drawing {
namespace {

constexpr int color_stops = 18;

std::vector<Vec2> regular(int corners, double radius) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i)
    points.push_back(Vec2{std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners)} * radius);
  return points;
}

std::vector<Vec2> square() {
  return {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}};
}

std::vector<Vec2> plus() {
  constexpr double a = 0.42, b = 1.35;
  return {{-a, -b}, {a, -b}, {a, -a}, {b, -a}, {b, a},   {a, a},
          {a, b},   {-a, b}, {-a, a}, {-b, a}, {-b, -a}, {-a, -a}};
}

/// As many decimals as tell the ticks apart.
int decimals(const std::vector<double>& ticks) {
  if (ticks.size() < 2) return 2;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(ticks[1] - ticks[0]) - 1e-9)), 0, 9);
}

template <class... Values>
void put(std::string& text, fmt::format_string<Values...> format, const Values&... values) {
  fmt::vformat_to(std::back_inserter(text), format, fmt::make_format_args(values...));
}

void put_entries(std::string& text, const Legend& legend) {
  double x = 8;
  for (size_t i = 0; i < marks().size(); ++i) {
    if (i >= legend.counts.size() || legend.counts[i] == 0) continue;
    const Mark& mark = marks()[i];
    Path path;
    std::vector<Vec2> outline;
    for (const Vec2 p : mark.outline) outline.push_back(Vec2{x, 15} + p * 6);
    path.polyline(outline, true);
    put(text,
        "<path transform=\"scale(.01)\" d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"120\"/>"
        "<text x=\"{:.0f}\" y=\"20\">{} <tspan fill=\"#57606a\">{}</tspan></text>\n",
        path.text(), mark.fill, mark.rim, x + 15, mark.name, legend.counts[i]);
    x += 165;
  }
  if (legend.has_cuts)
    put(text,
        "<path d=\"M{:.0f} 15h26\" stroke=\"{}\" stroke-width=\"2.4\" stroke-dasharray=\"6 4\"/>"
        "<text x=\"{:.0f}\" y=\"20\">side of a cut</text>\n",
        x - 8, cut_color, x + 25);
}

void put_scale(std::string& text, const ThicknessRange& range, double x) {
  constexpr double width = 340, label = 108;
  put(text, "<text x=\"{:.0f}\" y=\"20\">thickness, mm</text>\n", x);
  put(text, "<linearGradient id=\"thickness\">");
  for (int i = 0; i <= color_stops; ++i) {
    const double t = static_cast<double>(i) / color_stops;
    put(text, "<stop offset=\"{:.4g}\" stop-color=\"{}\"/>", t, hex(ramp(t)));
  }
  put(text,
      "</linearGradient>\n<rect x=\"{:.0f}\" y=\"8\" width=\"{:.0f}\" height=\"14\" "
      "fill=\"url(#thickness)\"/>\n",
      x + label, width);
  const std::vector<double> ticks = round_ticks(range.low, range.high, 6);
  for (const double tick : ticks) {
    const double at = x + label + range.fraction(tick) * width;
    put(text,
        "<path d=\"M{:.1f} 22v5\" stroke=\"#1b1f24\"/><text x=\"{:.1f}\" y=\"42\" font-size=\"12\" "
        "text-anchor=\"middle\">{:.{}f}</text>\n",
        at, at, tick, decimals(ticks));
  }
}

}  // namespace

const std::vector<Mark>& marks() {
  static const std::vector<Mark> all{
      {MedialVertexType::J, "J junction", "#1b1f24", "#ffffff", square()},
      {MedialVertexType::C, "C corner end", "#d55e00", "#ffffff", regular(4, 1.3)},
      {MedialVertexType::S, "S smooth end", "#ffffff", "#1b1f24", regular(20, 1)},
      {MedialVertexType::isolated, "full disc", "#cc79a7", "#ffffff", plus()},
  };
  return all;
}

double ThicknessRange::fraction(double thickness) const {
  return high > low ? std::clamp((thickness - low) / (high - low), 0.0, 1.0) : 0.5;
}

ThicknessRange thickness_range(const std::vector<const MedialObject*>& objects) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const MedialObject* object : objects)
    for (const MedialEdge& edge : object->edges)
      for (const MedialPoint& point : edge.points)
        low = std::min(low, 2 * point.radius), high = std::max(high, 2 * point.radius);
  if (!(high > 0)) return {};
  const double middle = (low + high) / 2, half = std::max((high - low) / 2, 0.01 * high);
  return {middle - half, middle + half};
}

std::vector<double> round_ticks(double low, double high, int count) {
  std::vector<double> ticks;
  if (!(high > low) || count < 1) return ticks;
  const double step = round_length(1.6 * (high - low) / count);
  const double first = std::ceil(low / step - 1e-9);
  for (double k = first; k * step <= high + 1e-9 * step; ++k)
    ticks.push_back(k == 0 ? 0 : k * step);  // no -0
  return ticks;
}

std::string legend_svg(const Legend& legend, Vec2 origin, double width) {
  std::string text;
  put(text, "<g id=\"legend\" transform=\"translate({:.1f} {:.1f})\" font-size=\"14\" fill=\"#1b1f24\">\n",
      origin.x, origin.y);
  put_entries(text, legend);
  if (legend.range.high > 0) put_scale(text, legend.range, width - 465);
  return text + "</g>\n";
}

}  // namespace beadmesh::drawing
