#include "beadmesh/report/medial_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "beadmesh/report/drawing.h"
#include "beadmesh/report/medial_legend.h"
#include "beadmesh/report/svg_text.h"

namespace beadmesh {
namespace {

using namespace drawing;

constexpr double margin = 24, header = 84, drawing_width = 1400, drawing_height = 1000, gap = 36;
constexpr int bins = 48;
constexpr double fine = 0.12;     // pixels: shapes keep to this
constexpr double foot_step = 12;  // pixels between lines to the feet
constexpr double band_step = 2;   // pixels: a change of colour is not cut finer

std::vector<Vec2> boundary_points(const PlanarRegion& region) {
  std::vector<Vec2> all;
  for (const PlanarLoop& loop : region.loops) all.insert(all.end(), loop.points.begin(), loop.points.end());
  return all;
}

std::string counted(size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// Sizes in pixels that suit a face: large where it is simple, small where it is crowded.
struct Sizes {
  double mark, axis, outline, circle;

  Sizes(const FaceMedial& face, const Frame& frame) {
    double area = 0;
    for (const PlanarLoop& loop : face.region.loops) area += signed_area(loop);
    const double vertices = std::max<double>(1, static_cast<double>(face.object.vertices.size()));
    const double spacing = std::sqrt(std::abs(area) / vertices) * frame.scale();
    mark = std::clamp(std::min(0.11 * spacing, 0.45 * typical_radius(face) * frame.scale()), 1.1, 5.5);
    axis = std::clamp(0.6 * mark, 0.9, 3.2);
    outline = std::clamp(0.04 * spacing, 0.5, 1.3);
    circle = std::clamp(0.012 * spacing, 0.2, 0.8);
  }

  /// The mean thickness of the axis is twice that.
  static double typical_radius(const FaceMedial& face) {
    double length = 0, area = 0;
    for (const MedialEdge& edge : face.object.edges)
      length += edge.length, area += edge.length * edge.thickness.mean;
    if (length > 0) return area / length / 2;
    return face.object.vertices.empty() ? 0 : face.object.vertices[0].radius;
  }
};

class Picture : drawing::SvgText {
 public:
  Picture(const std::vector<FaceMedial>& faces, const std::string& title, const MedialPicture& options)
      : faces_(faces), title_(title), options_(options) {
    lay_out();
    std::vector<const MedialObject*> objects;
    for (const FaceMedial& face : faces_) objects.push_back(&face.object);
    legend_.range = thickness_range(objects);
    legend_.counts.assign(marks().size(), 0);
    for (const FaceMedial& face : faces_)
      for (const MedialVertex& vertex : face.object.vertices)
        for (size_t m = 0; m < marks().size(); ++m) legend_.counts[m] += marks()[m].type == vertex.type;
    for (const PlaneImage& image : options_.images) legend_.has_cuts |= image.is_cut();
  }

  std::string text() {
    const double width = drawing_width + 2 * margin, height = bottom_ + margin + legend_height + 8;
    put(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:.0f} {:.0f}" width="{:.0f}" height="{:.0f}" )"
        R"(font-family="Helvetica,Arial,sans-serif">)"
        "\n",
        width, height, width, height);
    put("<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n", escaped(title_));
    draw_heading();
    draw_length_scale();
    for (size_t i = 0; i < faces_.size(); ++i) draw_face(i);
    put_text(legend_svg(legend_, {margin, bottom_ + margin}, drawing_width));
    put("</svg>\n");
    return written();
  }

 private:
  /// Rows from the top left, in the order of the faces, at the scale at which the largest face fits.
  void lay_out() {
    std::vector<std::vector<Vec2>> points;
    double widest = 0, tallest = 0;
    for (const FaceMedial& face : faces_) {
      points.push_back(boundary_points(face.region));
      const Frame plain(points.back(), {}, 1, 1);
      widest = std::max(widest, plain.width() / plain.scale());
      tallest = std::max(tallest, plain.height() / plain.scale());
    }
    if (widest > 0 || tallest > 0) scale_ = 1 / std::max(widest / drawing_width, tallest / drawing_height);
    double x = margin, y = header, row = 0;
    for (const auto& of_face : points) {
      const Frame plain(of_face, {}, 1, 1);
      const double w = plain.width() / plain.scale() * scale_, h = plain.height() / plain.scale() * scale_;
      if (x > margin && x + w > margin + drawing_width) x = margin, y += row + gap, row = 0;
      frames_.emplace_back(of_face, Vec2{x, y}, std::max(w, 1e-9), std::max(h, 1e-9));
      x += w + gap, row = std::max(row, h);
    }
    bottom_ = y + row;
  }

  void draw_heading() {
    size_t vertices = 0, edges = 0;
    for (const FaceMedial& face : faces_)
      vertices += face.object.vertices.size(), edges += face.object.edges.size();
    put("<text x=\"{}\" y=\"36\" font-size=\"22\" font-weight=\"bold\" fill=\"#1b1f24\">{}</text>\n", margin,
        escaped(title_));
    put("<text x=\"{}\" y=\"62\" font-size=\"15\" fill=\"#57606a\">medial object: {}, {}, {}</text>\n",
        margin, counted(faces_.size(), "face", "faces"), counted(vertices, "vertex", "vertices"),
        counted(edges, "edge", "edges"));
  }

  void draw_length_scale() {
    if (faces_.empty()) return;
    const double length = round_length(160 / scale_), right = margin + drawing_width;
    put("<path d=\"M{:.1f} 52v6h{:.1f}v-6\" fill=\"none\" stroke=\"#57606a\" stroke-width=\"1.2\"/>"
        "<text x=\"{:.1f}\" y=\"48\" font-size=\"13\" text-anchor=\"middle\" fill=\"#57606a\">{:g} "
        "mm</text>\n",
        right - length * scale_, length * scale_, right - length * scale_ / 2, length);
  }

  void draw_face(size_t i) {
    const FaceMedial& face = faces_[i];
    const Frame& frame = frames_[i];
    const Sizes sizes(face, frame);
    put("<g id=\"face-{}\">\n", face.face);
    draw_boundary(face, frame, sizes);
    if (i < options_.images.size() && options_.images[i].is_cut()) draw_cuts(face, options_.images[i], frame);
    if (options_.feet) draw_feet(face, frame, sizes);
    draw_circles(face, frame, sizes);
    draw_axis(face, frame, sizes);
    draw_marks(face, frame, sizes);
    if (faces_.size() > 1 && !face.region.loops.empty() && !face.region.loops[0].points.empty()) {
      const Vec2 at = frame(face.region.loops[0].points[0]);
      put("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" fill=\"#57606a\">{}</text>\n", at.x + 3, at.y - 3,
          face.face);
    }
    put("</g>\n");
  }

  void draw_boundary(const FaceMedial& face, const Frame& frame, const Sizes& sizes) {
    Path outline;
    for (const PlanarLoop& loop : face.region.loops) {
      std::vector<Vec2> line;
      for (const Vec2 p : loop.points) line.push_back(frame(p));
      outline.polyline(thinned(line, fine), true);
    }
    put("<path transform=\"scale(.01)\" fill=\"#f1f4f7\" fill-rule=\"evenodd\" stroke=\"#30363d\" "
        "stroke-width=\"{:.0f}\" stroke-linejoin=\"round\" d=\"{}\"/>\n",
        100 * sizes.outline, outline.text());
  }

  void draw_cuts(const FaceMedial& face, const PlaneImage& image, const Frame& frame) {
    Path sides;
    for (size_t l = 0; l < image.cut_sides.size(); ++l) {
      const std::vector<Vec2>& points = face.region.loops[l].points;
      for (size_t i = 0; i < points.size(); ++i)
        if (image.cut_sides[l][i])
          sides.polyline({frame(points[i]), frame(points[(i + 1) % points.size()])}, false);
    }
    put("<path class=\"cut\" transform=\"scale(.01)\" fill=\"none\" stroke=\"{}\" stroke-width=\"240\" "
        "stroke-dasharray=\"600 400\" d=\"{}\"/>\n",
        cut_color, sides.text());
  }

  void draw_circles(const FaceMedial& face, const Frame& frame, const Sizes& sizes) {
    put("<g fill=\"none\" stroke=\"#9aa4af\" stroke-width=\"{:.2f}\">\n", sizes.circle);
    for (const MedialVertex& vertex : face.object.vertices) {
      const Vec2 at = frame(vertex.point);
      const double radius = vertex.radius * frame.scale();
      if (radius > 1.5 * sizes.mark)
        put("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", at.x, at.y, radius);
    }
    put("</g>\n");
  }

  void draw_feet(const FaceMedial& face, const Frame& frame, const Sizes& sizes) {
    Path spokes;
    for (const MedialEdge& edge : face.object.edges) {
      Vec2 last{-1e9, -1e9};
      for (const MedialPoint& point : edge.points) {
        const Vec2 at = frame(point.point);
        if (distance(at, last) < foot_step) continue;
        spokes.polyline({frame(point.feet[0].point), at, frame(point.feet[1].point)}, false);
        last = at;
      }
    }
    for (const MedialVertex& vertex : face.object.vertices)
      for (const Foot& foot : vertex.touching_points)
        spokes.polyline({frame(vertex.point), frame(foot.point)}, false);
    if (spokes.empty()) return;
    put("<path class=\"feet\" transform=\"scale(.01)\" fill=\"none\" stroke=\"#7d8a99\" "
        "stroke-opacity=\".55\" "
        "stroke-width=\"{:.0f}\" d=\"{}\"/>\n",
        80 * sizes.circle + 15, spokes.text());
  }

  /// One path a colour over a dark rim: a run of the axis goes to the bin of its thickness.
  void draw_axis(const FaceMedial& face, const Frame& frame, const Sizes& sizes) {
    std::array<Path, bins> paths;
    Path rim;
    for (const MedialEdge& edge : face.object.edges) add_edge(edge, frame, paths, rim);
    if (rim.empty()) return;
    put("<g class=\"axis\" transform=\"scale(.01)\" fill=\"none\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n");
    put("<path stroke=\"#30363d\" stroke-width=\"{:.0f}\" d=\"{}\"/>\n<g stroke-width=\"{:.0f}\">\n",
        100 * sizes.axis + 70, rim.text(), 100 * sizes.axis);
    for (int bin = 0; bin < bins; ++bin)
      if (!paths[bin].empty())
        put("<path stroke=\"{}\" d=\"{}\"/>\n", hex(ramp((bin + 0.5) / bins)), paths[bin].text());
    put("</g>\n</g>\n");
  }

  void add_edge(const MedialEdge& edge, const Frame& frame, std::array<Path, bins>& paths, Path& rim) const {
    const size_t count = edge.points.size();
    const size_t segments = edge.type == MedialEdgeType::N ? count : count - (count > 0);
    std::vector<Vec2> whole, run;
    int run_bin = -1;
    const auto flush = [&] {
      if (run_bin >= 0) paths[run_bin].polyline(thinned(run, fine), false);
    };
    for (size_t i = 0; i < segments; ++i) {
      const MedialPoint &a = edge.points[i], &b = edge.points[(i + 1) % count];
      const Vec2 from = frame(a.point), to = frame(b.point);
      const double start = bins * legend_.range.fraction(2 * a.radius),
                   end = bins * legend_.range.fraction(2 * b.radius);
      const int pieces =
          std::max(1, static_cast<int>(std::min(std::abs(end - start), distance(from, to) / band_step)));
      whole.push_back(from);
      for (int k = 0; k < pieces; ++k) {
        const double middle = start + (end - start) * (k + 0.5) / pieces;
        const int bin = std::clamp(static_cast<int>(middle), 0, bins - 1);
        const Vec2 next = lerp(from, to, (k + 1.0) / pieces);
        if (bin != run_bin) {
          flush();
          run_bin = bin;
          run = {lerp(from, to, static_cast<double>(k) / pieces)};
        }
        run.push_back(next);
      }
    }
    flush();
    if (segments == 0) return;
    whole.push_back(frame(edge.points[segments % count].point));
    rim.polyline(thinned(whole, fine), false);
  }

  void draw_marks(const FaceMedial& face, const Frame& frame, const Sizes& sizes) {
    for (const Mark& mark : marks()) {
      Path path;
      for (const MedialVertex& vertex : face.object.vertices) {
        if (vertex.type != mark.type) continue;
        std::vector<Vec2> outline;
        for (const Vec2 p : mark.outline) outline.push_back(frame(vertex.point) + p * sizes.mark);
        path.polyline(outline, true);
      }
      if (!path.empty())
        put("<path class=\"{}\" transform=\"scale(.01)\" d=\"{}\" fill=\"{}\" stroke=\"{}\" "
            "stroke-width=\"{:.0f}\"/>\n",
            name_of(mark.type), path.text(), mark.fill, mark.rim, 20 * sizes.mark + 10);
    }
  }

  const std::vector<FaceMedial>& faces_;
  const std::string& title_;
  const MedialPicture& options_;
  std::vector<Frame> frames_;
  double scale_ = 1;
  double bottom_ = header;
  Legend legend_;
};

}  // namespace

std::string medial_svg(const std::vector<FaceMedial>& faces, const std::string& title,
                       const MedialPicture& picture) {
  return Picture(faces, title, picture).text();
}

}  // namespace beadmesh
