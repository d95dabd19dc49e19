#include "beadmesh/report/panel_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/report/drawing.h"
#include "beadmesh/report/picture_view.h"
#include "beadmesh/report/svg_text.h"

namespace beadmesh {
namespace {

using namespace drawing;

constexpr double margin = 24, header = 84, footer = 64, tallest = 1100;

/// What an element is painted as; the order of painting.
enum Paint { sheet, bead_I, bead_generic, bead_annular, bead_fallback, triangle, paint_count };

struct PaintStyle {
  Color color;
  const char* name;
};

constexpr PaintStyle styles[paint_count] = {
    {{226, 229, 233}, "sheet"},       {{86, 160, 211}, "I bead"},         {{240, 173, 40}, "generic bead"},
    {{46, 178, 140}, "annular bead"}, {{222, 110, 60}, "bead, fallback"}, {{204, 121, 167}, "triangle"},
};

PictureView view_of(const ShellMesh& mesh, Vec3 wanted) {
  if (norm(wanted) > 0) return view_along(wanted);
  Vec3 sum;
  double area = 0;
  for (const ShellElement& element : mesh.elements) {
    const Vec3 n = area_normal(mesh.nodes, element.nodes);
    sum += n;
    area += norm(n);
  }
  return view_of_area(sum, area);
}

/// Light from the upper left; elements turned away from it are darker. Coarse steps, so that few paths
/// suffice.
constexpr int shades = 7;

int shade_of(const PictureView& view, Vec3 normal) {
  Vec3 n = normalized(normal);
  if (dot(n, view.eye) < 0) n = -n;
  const Vec3 light = normalized(view.eye * 1.0 - view.right * 0.55 + view.up * 0.65);
  return std::clamp(static_cast<int>(std::lround(dot(n, light) * (shades - 1))), 0, shades - 1);
}

double shade_factor(int shade) {
  return 0.66 + 0.40 * shade / (shades - 1);
}

class Picture : drawing::SvgText {
 public:
  Picture(const PanelMesh& panel, const PanelPictureOptions& options)
      : panel_(panel),
        options_(options),
        view_(view_of(panel.mesh, options.view)),
        frame_(flat_nodes(), {margin, header}, options.width, tallest) {}

  std::string text() {
    width_ = std::max(frame_.width(), 900.0) + 2 * margin;
    height_ = frame_.height() + header + footer;
    put(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:.0f} {:.0f}" width="{:.0f}" height="{:.0f}" )"
        R"(font-family="Helvetica,Arial,sans-serif">)"
        "\n",
        width_, height_, width_, height_);
    put("<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n");
    draw_heading();
    draw_elements();
    draw_crests();
    draw_axes();
    if (options_.labels) draw_labels();
    draw_legend();
    put("</svg>\n");
    return written();
  }

 private:
  std::vector<Vec2> flat_nodes() {
    flat_.reserve(panel_.mesh.nodes.size());
    for (const Vec3& p : panel_.mesh.nodes) flat_.push_back(view_(p));
    return flat_;
  }

  Vec2 place(Vec3 p) const { return frame_(view_(p)); }

  Paint paint_of_bead(size_t i) const {
    if (i < panel_.meshing.size() && panel_.meshing[i].method == "fallback") return bead_fallback;
    switch (panel_.table.beads[i].kind) {
      case BeadKind::I:
        return bead_I;
      case BeadKind::generic:
        return bead_generic;
      case BeadKind::annular:
        return bead_annular;
    }
    return sheet;
  }

  void draw_heading() {
    const std::string& title = panel_.mesh.title;
    const QualitySummary& q = panel_.quality;
    put("<text x=\"{}\" y=\"36\" font-size=\"22\" font-weight=\"bold\" fill=\"#1b1f24\">{}</text>\n", margin,
        escaped(title.empty() ? "Panel" : title));
    put("<text x=\"{}\" y=\"62\" font-size=\"15\" fill=\"#57606a\">{} beads, {} nodes, {} quads, {} "
        "triangles; "
        "scaled Jacobian min {:.2f}, mean {:.3f}; shortest edge {:.2f} mm</text>\n",
        margin, panel_.table.beads.size(), q.nodes, q.quads, q.trias, q.scaled_jacobian_min,
        q.scaled_jacobian_mean, q.edge_min);
  }

  void draw_elements() {
    std::map<Index, Paint> paint_of;
    for (size_t i = 0; i < panel_.table.beads.size(); ++i)
      paint_of[panel_.table.beads[i].id] = paint_of_bead(i);
    std::array<std::array<Path, shades>, paint_count> paths;
    std::vector<Vec2> corners;
    for (const ShellElement& element : panel_.mesh.elements) {
      const auto found = paint_of.find(element.bead);
      const Paint paint = !is_quad(element.nodes)   ? triangle
                          : found == paint_of.end() ? sheet
                                                    : found->second;
      corners.clear();
      for (const Index node : element.nodes)
        if (node != no_index) corners.push_back(frame_(flat_[node]));
      paths[paint][shade_of(view_, area_normal(panel_.mesh.nodes, element.nodes))].polyline(corners, true);
      ++count_[paint];
    }
    put("<g id=\"mesh\" transform=\"scale(.01)\" stroke=\"#6e7781\" stroke-width=\"{:.0f}\" "
        "stroke-linejoin=\"round\">\n",
        line_width());
    for (int paint = 0; paint < paint_count; ++paint)
      for (int shade = 0; shade < shades; ++shade)
        if (!paths[paint][shade].empty())
          put("<path fill=\"{}\" d=\"{}\"/>\n", hex(shaded(styles[paint].color, shade_factor(shade))),
              paths[paint][shade].text());
    put("</g>\n");
  }

  /// Of the element edges, in hundredths of a pixel: thin where elements are small.
  double line_width() const {
    const double count = std::max<size_t>(1, panel_.mesh.elements.size());
    const double side = std::sqrt(frame_.width() * frame_.height() / count);
    return std::clamp(6 * side, 8.0, 60.0);
  }

  void draw_crests() {
    Path crest;
    std::vector<Vec2> line;
    for (const Bead& bead : panel_.table.beads)
      for (const RidgeCurve& curve : bead.ridge) {
        line.clear();
        for (const Vec3& p : curve.points) line.push_back(place(p));
        crest.polyline(line, curve.closed);
      }
    if (!crest.empty())
      put("<path id=\"crests\" transform=\"scale(.01)\" fill=\"none\" stroke=\"#14191f\" "
          "stroke-width=\"170\" "
          "stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"{}\"/>\n",
          crest.text());
  }

  /// The medial axes as they are, before squaring and before they move to the crest.
  void draw_axes() {
    Path axes;
    std::vector<Vec2> line;
    for (const FaceMedial& medial : panel_.table.medials)
      for (size_t e = 0; e < medial.edge_points.size(); ++e) {
        line.clear();
        for (const Vec3& p : medial.edge_points[e]) line.push_back(place(p));
        axes.polyline(line, medial.object.edges[e].type == MedialEdgeType::N);
      }
    if (!axes.empty())
      put("<path id=\"axes\" transform=\"scale(.01)\" fill=\"none\" stroke=\"#c2185b\" stroke-width=\"110\" "
          "stroke-linejoin=\"round\" d=\"{}\"/>\n",
          axes.text());
  }

  void draw_labels() {
    put("<g id=\"labels\" font-size=\"13\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"#14191f\" "
        "stroke=\"#ffffff\" "
        "stroke-width=\"3.5\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n");
    for (const Bead& bead : panel_.table.beads) {
      const Vec2 at = place(bead.point);
      put("<text x=\"{:.1f}\" y=\"{:.1f}\">{} {}</text>\n", at.x, at.y + 4.5, bead.id, escaped(bead.shape));
    }
    put("</g>\n");
  }

  void draw_legend() {
    const double y = height_ - 26;
    double x = margin;
    put("<g id=\"legend\" font-size=\"14\" fill=\"#1b1f24\">\n");
    for (int paint = 0; paint < paint_count; ++paint) {
      if (count_[paint] == 0) continue;
      put("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"18\" height=\"14\" fill=\"{}\" stroke=\"#6e7781\" "
          "stroke-width=\".6\"/>"
          "<text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n",
          x, y - 12, hex(styles[paint].color), x + 24, y, styles[paint].name);
      x += 52 + 7.2 * std::string_view(styles[paint].name).size();
    }
    put("<path d=\"M{:.0f} {:.0f}h26\" stroke=\"#14191f\" stroke-width=\"1.7\"/><text x=\"{:.0f}\" "
        "y=\"{:.0f}\">crest line</text>\n",
        x, y - 5, x + 32, y);
    x += 110;
    put("<path d=\"M{:.0f} {:.0f}h26\" stroke=\"#c2185b\" stroke-width=\"1.1\"/><text x=\"{:.0f}\" "
        "y=\"{:.0f}\">medial axis</text>\n",
        x, y - 5, x + 32, y);
    const double length = round_length(0.2 * options_.width / frame_.scale()), bar = length * frame_.scale();
    const double end = width_ - margin;
    put("<path d=\"M{:.1f} {:.0f}v6h{:.1f}v-6\" fill=\"none\" stroke=\"#1b1f24\"/>"
        "<text x=\"{:.1f}\" y=\"{:.0f}\" text-anchor=\"middle\">{:g} mm</text>\n",
        end - bar, y - 2, bar, end - bar / 2, y - 6, length);
    put("</g>\n");
  }

  const PanelMesh& panel_;
  const PanelPictureOptions& options_;
  PictureView view_;
  std::vector<Vec2> flat_;
  Frame frame_;
  double width_ = 0, height_ = 0;
  std::array<int, paint_count> count_{};
};

}  // namespace

std::string panel_svg(const PanelMesh& panel, const PanelPictureOptions& options) {
  return Picture(panel, options).text();
}

}  // namespace beadmesh
