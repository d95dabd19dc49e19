#include "beadmesh/report/medial_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "beadmesh/report/drawing.h"

namespace beadmesh {
namespace {

using namespace drawing;

constexpr double margin = 24, header = 84, footer = 72, drawing_width = 1400, drawing_height = 1000, gap = 36;
constexpr int bins = 48;

struct Mark {
  MedialVertexType type;
  const char* name;
  const char* color;
  const char* shape;  ///< path about the origin
};

constexpr Mark marks[] = {
    {MedialVertexType::J, "J junction", "#d55e00", "M-5-5h10v10h-10z"},
    {MedialVertexType::C, "C corner end", "#0072b2", "M0-6.5l6.5 6.5l-6.5 6.5l-6.5-6.5z"},
    {MedialVertexType::S, "S smooth end", "#009e73", "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0z"},
    {MedialVertexType::isolated, "full disc", "#cc79a7", "M-7-2h5v-5h4v5h5v4h-5v5h-4v-5h-5z"},
};

const Mark& mark_of(MedialVertexType type) {
  for (const Mark& mark : marks)
    if (mark.type == type) return mark;
  return marks[0];
}

std::vector<Vec2> boundary_points(const PlanarRegion& region) {
  std::vector<Vec2> all;
  for (const PlanarLoop& loop : region.loops) all.insert(all.end(), loop.points.begin(), loop.points.end());
  return all;
}

struct Box {
  Vec2 low{0, 0}, size{0, 0};
};

Box box_of(const std::vector<Vec2>& points) {
  if (points.empty()) return {};
  Vec2 low = points[0], high = points[0];
  for (const Vec2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low, high - low};
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  /// Noise of an even thickness must not look like change.
  void widen() {
    const double middle = (low + high) / 2, half = std::max((high - low) / 2, 0.01 * high);
    low = middle - half, high = middle + half;
  }
  double fraction(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

class Picture {
 public:
  Picture(const std::vector<FaceMedial>& faces, const std::string& title) : faces_(faces), title_(title) {
    lay_out();
    for (const FaceMedial& face : faces_)
      for (const MedialEdge& edge : face.object.edges)
        for (const MedialPoint& point : edge.points) thickness_.add(2 * point.radius);
    if (thickness_.high > 0) thickness_.widen();
  }

  std::string text() {
    const double width = drawing_width + 2 * margin, height = bottom_ + footer;
    put(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:.0f} {:.0f}" width="{:.0f}" height="{:.0f}" )"
        R"(font-family="Helvetica,Arial,sans-serif">)"
        "\n",
        width, height, width, height);
    put("<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n");
    draw_heading();
    for (size_t i = 0; i < faces_.size(); ++i) draw_face(faces_[i], frames_[i]);
    draw_legend(height);
    put("</svg>\n");
    return fmt::to_string(out_);
  }

 private:
  template <class... Values>
  void put(fmt::format_string<Values...> format, const Values&... values) {
    fmt::vformat_to(std::back_inserter(out_), format, fmt::make_format_args(values...));
  }

  /// Rows from the top left, in the order of the faces, at the scale at which the largest face fits.
  void lay_out() {
    std::vector<Box> boxes;
    double widest = 0, tallest = 0;
    for (const FaceMedial& face : faces_) {
      boxes.push_back(box_of(boundary_points(face.region)));
      widest = std::max(widest, boxes.back().size.x), tallest = std::max(tallest, boxes.back().size.y);
    }
    const double scale =
        widest > 0 && tallest > 0 ? std::min(drawing_width / widest, drawing_height / tallest) : 1;
    double x = margin, y = header, row = 0;
    for (size_t i = 0; i < boxes.size(); ++i) {
      const double w = boxes[i].size.x * scale, h = boxes[i].size.y * scale;
      if (x > margin && x + w > margin + drawing_width) x = margin, y += row + gap, row = 0;
      frames_.emplace_back(boundary_points(faces_[i].region), Vec2{x, y}, std::max(w, 1e-9),
                           std::max(h, 1e-9));
      x += w + gap, row = std::max(row, h);
    }
    bottom_ = y + row;
  }

  void draw_heading() {
    int vertices = 0, edges = 0;
    for (const FaceMedial& face : faces_) {
      vertices += static_cast<int>(face.object.vertices.size());
      edges += static_cast<int>(face.object.edges.size());
    }
    put("<text x=\"{}\" y=\"36\" font-size=\"22\" font-weight=\"bold\" fill=\"#1b1f24\">{}</text>\n", margin,
        escaped(title_));
    put("<text x=\"{}\" y=\"62\" font-size=\"15\" fill=\"#57606a\">medial object: {} face{}, {} vertices, {} "
        "edges</text>\n",
        margin, faces_.size(), faces_.size() == 1 ? "" : "s", vertices, edges);
  }

  void draw_face(const FaceMedial& face, const Frame& frame) {
    put("<g id=\"face-{}\">\n", face.face);
    draw_boundary(face, frame);
    draw_circles(face, frame);
    draw_axis(face, frame);
    for (const MedialVertex& vertex : face.object.vertices) {
      const Vec2 at = frame(vertex.point);
      const Mark& mark = mark_of(vertex.type);
      put("<path transform=\"translate({:.2f} {:.2f})\" d=\"{}\" fill=\"{}\" stroke=\"#ffffff\" "
          "stroke-width=\"1.2\"/>\n",
          at.x, at.y, mark.shape, mark.color);
    }
    if (faces_.size() > 1) {
      const Vec2 at = frame(face.region.loops.empty() || face.region.loops[0].points.empty()
                                ? Vec2{}
                                : face.region.loops[0].points[0]);
      put("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" fill=\"#57606a\">{}</text>\n", at.x + 3, at.y - 3,
          face.face);
    }
    put("</g>\n");
  }

  void draw_boundary(const FaceMedial& face, const Frame& frame) {
    Path outline;
    for (const PlanarLoop& loop : face.region.loops) {
      std::vector<Vec2> line;
      for (const Vec2 p : loop.points) line.push_back(frame(p));
      outline.polyline(line, true);
    }
    put("<path transform=\"scale(.01)\" fill=\"#eef1f4\" fill-rule=\"evenodd\" stroke=\"#1b1f24\" "
        "stroke-width=\"120\" d=\"{}\"/>\n",
        outline.text());
  }

  void draw_circles(const FaceMedial& face, const Frame& frame) {
    Path spokes;
    put("<g fill=\"none\" stroke=\"#8c959f\" stroke-width=\".8\">\n");
    for (const MedialVertex& vertex : face.object.vertices) {
      const Vec2 at = frame(vertex.point);
      if (vertex.radius > 0)
        put("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", at.x, at.y,
            vertex.radius * frame.scale());
      for (const Foot& foot : vertex.touching_points) spokes.polyline({at, frame(foot.point)}, false);
    }
    put("</g>\n");
    if (!spokes.empty())
      put("<path transform=\"scale(.01)\" fill=\"none\" stroke=\"#8c959f\" stroke-width=\"80\" "
          "stroke-dasharray=\"400 300\" "
          "d=\"{}\"/>\n",
          spokes.text());
  }

  /// One path a colour: every segment goes to the bin of the thickness at its middle.
  void draw_axis(const FaceMedial& face, const Frame& frame) {
    std::array<Path, bins> paths;
    for (const MedialEdge& edge : face.object.edges) {
      const size_t count = edge.points.size(),
                   segments = edge.type == MedialEdgeType::N ? count : count - (count > 0);
      for (size_t i = 0; i < segments; ++i) {
        const MedialPoint &a = edge.points[i], &b = edge.points[(i + 1) % count];
        const double t = thickness_.fraction(a.radius + b.radius);
        paths[std::clamp(static_cast<int>(t * bins), 0, bins - 1)].polyline({frame(a.point), frame(b.point)},
                                                                            false);
      }
    }
    put("<g transform=\"scale(.01)\" fill=\"none\" stroke-width=\"320\" stroke-linecap=\"round\">\n");
    for (int bin = 0; bin < bins; ++bin)
      if (!paths[bin].empty())
        put("<path stroke=\"{}\" d=\"{}\"/>\n", hex(ramp((bin + 0.5) / bins)), paths[bin].text());
    put("</g>\n");
  }

  void draw_legend(double height) {
    const double y = height - 30;
    double x = margin + 8;
    put("<g id=\"legend\" font-size=\"14\" fill=\"#1b1f24\">\n");
    for (const Mark& mark : marks) {
      if (!occurs(mark.type)) continue;
      put("<path transform=\"translate({:.0f} {:.0f})\" d=\"{}\" fill=\"{}\"/><text x=\"{:.0f}\" "
          "y=\"{:.0f}\">{}</text>\n",
          x, y - 5, mark.shape, mark.color, x + 14, y, mark.name);
      x += 132;
    }
    if (thickness_.high > 0) draw_scale(margin + drawing_width - 420, y);
    put("</g>\n");
  }

  bool occurs(MedialVertexType type) const {
    for (const FaceMedial& face : faces_)
      for (const MedialVertex& vertex : face.object.vertices)
        if (vertex.type == type) return true;
    return false;
  }

  void draw_scale(double x, double y) {
    constexpr double width = 300;
    put("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">thickness, mm</text>\n", x + 92, y);
    for (int bin = 0; bin < bins; ++bin)
      put("<rect x=\"{:.2f}\" y=\"{:.0f}\" width=\"{:.2f}\" height=\"12\" fill=\"{}\"/>\n",
          x + 110 + bin * width / bins, y - 11, width / bins + 0.3, hex(ramp((bin + 0.5) / bins)));
    for (const double t : {0.0, 0.5, 1.0})
      put("<text x=\"{:.1f}\" y=\"{:.0f}\" font-size=\"12\" text-anchor=\"middle\">{:.4g}</text>\n",
          x + 110 + t * width, y + 17, thickness_.low + t * (thickness_.high - thickness_.low));
  }

  const std::vector<FaceMedial>& faces_;
  const std::string& title_;
  std::vector<Frame> frames_;
  double bottom_ = header;
  Range thickness_;
  fmt::memory_buffer out_;
};

}  // namespace

std::string medial_svg(const std::vector<FaceMedial>& faces, const std::string& title) {
  return Picture(faces, title).text();
}

}  // namespace beadmesh
