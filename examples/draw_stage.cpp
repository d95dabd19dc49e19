// draw_stage triangulation FILE.wkt OUT.svg: samples and triangles of a plane polygon, as the medial object
// takes them. draw_stage cleanup OUT.svg: a sheet with holes before and after the topological clean-up. The
// pictures of the pages about these stages; and an example of calling stages one by one.
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "beadmesh/medial/boundary_curve.h"
#include "beadmesh/medial/medial_object.h"
#include "beadmesh/medial/sampled_boundary.h"
#include "beadmesh/medial/triangle_type.h"
#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/mesh/subdivision_mesher.h"
#include "beadmesh/mesh/topological_cleanup.h"
#include "beadmesh/read/polygon_reader.h"

namespace {

using namespace beadmesh;

/// A picture of plane things, y upwards, in units of the drawing.
class Picture {
 public:
  Picture(Vec2 low, Vec2 high, double scale) : low_(low), high_(high), scale_(scale) {}

  void polygon(const std::vector<Vec2>& points, const char* style) {
    text_ << "<polygon points=\"";
    for (const Vec2 p : points) text_ << x(p) << ',' << y(p) << ' ';
    text_ << "\" " << style << "/>\n";
  }
  void polyline(const std::vector<Vec2>& points, const char* style) {
    text_ << "<polyline fill=\"none\" points=\"";
    for (const Vec2 p : points) text_ << x(p) << ',' << y(p) << ' ';
    text_ << "\" " << style << "/>\n";
  }
  /// A dot with `corners` corners; 0: round.
  void dot(Vec2 at, double radius, int corners, const char* style) {
    if (corners == 0) {
      text_ << "<circle cx=\"" << x(at) << "\" cy=\"" << y(at) << "\" r=\"" << radius << "\" " << style
            << "/>\n";
      return;
    }
    std::vector<Vec2> points;
    for (int k = 0; k < corners; ++k) {
      const double angle = pi / 2 + 2 * pi * k / corners;
      points.push_back(at + radius / scale_ * Vec2{std::cos(angle), std::sin(angle)});
    }
    polygon(points, style);
  }
  void label(Vec2 at, const std::string& words) {
    text_ << "<text x=\"" << x(at) << "\" y=\"" << y(at) << "\">" << words << "</text>\n";
  }
  std::string svg() const {
    std::ostringstream out;
    const double width = scale_ * (high_.x - low_.x), height = scale_ * (high_.y - low_.y);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
        << "\" width=\"" << width << "\" height=\"" << height
        << "\" font-family=\"sans-serif\" font-size=\"15\">\n"
        << text_.str() << "</svg>\n";
    return out.str();
  }

 private:
  double x(Vec2 p) const { return scale_ * (p.x - low_.x); }
  double y(Vec2 p) const { return scale_ * (high_.y - p.y); }

  Vec2 low_, high_;
  double scale_;
  std::ostringstream text_;
};

// ------------------------------------------------------------------ samples and triangles

constexpr const char* outline = "stroke=\"#222\" stroke-width=\"2\"";

const char* fill_of(TriangleType type) {
  switch (type) {
    case TriangleType::J:
      return "fill=\"#e69f00\" stroke=\"#777\" stroke-width=\"0.6\"";
    case TriangleType::C:
      return "fill=\"#009e73\" stroke=\"#777\" stroke-width=\"0.6\"";
    case TriangleType::S:
      return "fill=\"#56b4e9\" stroke=\"#777\" stroke-width=\"0.6\"";
    default:
      return "fill=\"#f2f2f2\" stroke=\"#777\" stroke-width=\"0.6\"";
  }
}

void draw_triangles(const SampledBoundary& sampled, Picture& picture) {
  const Triangulation& net = sampled.triangulation;
  const auto types = triangle_types(net, sampled.samples);
  for (std::size_t t = 0; t < net.triangles.size(); ++t) {
    std::vector<Vec2> corners;
    for (const Index n : net.triangles[t]) corners.push_back(net.points[n]);
    picture.polygon(corners, fill_of(types[t]));
  }
  for (const Triangle& t : net.triangles)
    picture.dot(circumcircle(net.points[t[0]], net.points[t[1]], net.points[t[2]]).centre, 2.2, 0,
                "fill=\"#d55e00\"");
}

void draw_samples(const BoundarySamples& samples, Picture& picture) {
  for (const BoundarySample& sample : samples.samples)
    if (sample.corner)
      picture.dot(sample.point, 5, 4, "fill=\"#222\"");
    else
      picture.dot(sample.point, 3, 0, sample.t == 0 ? "fill=\"#222\"" : "fill=\"white\" stroke=\"#222\"");
}

void draw_legend(Vec2 at, double step, Picture& picture) {
  const std::array<std::pair<TriangleType, const char*>, 4> types{{{TriangleType::J, "J: three neighbours"},
                                                                   {TriangleType::N, "N: two"},
                                                                   {TriangleType::S, "S: one, smooth end"},
                                                                   {TriangleType::C, "C: one, corner"}}};
  for (const auto& [type, words] : types) {
    picture.dot(at, 8, 4, fill_of(type));
    picture.label(at + Vec2{step / 16, -step / 40}, words);
    at.x += step;
  }
}

Result<std::string> triangulation_picture(const std::filesystem::path& file) {
  const auto region = read_polygon(file);
  if (!region) return tl::unexpected(region.error());
  const BoundaryCurve curve(*region, MedialOptions{}.corner_angle);
  const auto sampled = sampled_boundary(curve, {});
  if (!sampled) return tl::unexpected(sampled.error());
  const auto medial = medial_object(*region);
  if (!medial) return tl::unexpected(medial.error());

  Vec2 low = sampled->triangulation.points[0], high = low;
  for (const Vec2 p : sampled->triangulation.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double width = high.x - low.x, margin = 0.02 * width;
  Picture picture(low - Vec2{margin, 3 * margin}, high + Vec2{margin, margin}, 1100 / width);
  draw_triangles(*sampled, picture);
  for (const MedialEdge& edge : medial->edges) {
    std::vector<Vec2> line;
    for (const MedialPoint& point : edge.points) line.push_back(point.point);
    picture.polyline(line, "stroke=\"#0072b2\" stroke-width=\"2\"");
  }
  draw_samples(sampled->samples, picture);
  draw_legend(low - Vec2{-margin, 1.8 * margin}, width / 4, picture);
  return picture.svg();
}

// ------------------------------------------------------------------ clean-up

void add_loop(const std::vector<Vec2>& points, NodeLoops& loops) {
  loops.loops.emplace_back();
  for (const Vec2 p : points) {
    loops.loops.back().push_back(static_cast<Index>(loops.nodes.size()));
    loops.nodes.push_back(p);
  }
}

std::vector<Vec2> hole(Vec2 centre, double half_length, double half_width, int nodes) {
  std::vector<Vec2> points;
  for (int i = 0; i < nodes; ++i) {
    const double angle = -2 * pi * i / nodes;
    points.push_back(centre + Vec2{half_length * std::cos(angle), half_width * std::sin(angle)});
  }
  return points;
}

/// A plate of 110 x 80 with a round and two oval holes, a node every 5 mm.
NodeLoops plate_with_holes() {
  NodeLoops loops;
  std::vector<Vec2> rim;
  const std::array<Vec2, 4> corners{{{0, 0}, {110, 0}, {110, 80}, {0, 80}}};
  for (int side = 0; side < 4; ++side) {
    const int count = side % 2 ? 16 : 22;
    for (int k = 0; k < count; ++k)
      rim.push_back(lerp(corners[side], corners[(side + 1) % 4], double(k) / count));
  }
  add_loop(rim, loops);
  add_loop(hole({28, 52}, 14, 14, 18), loops);
  add_loop(hole({72, 25}, 22, 9, 20), loops);
  add_loop(hole({80, 60}, 12, 8, 12), loops);
  return loops;
}

std::vector<int> irregular_valences(const PlanarMesh& mesh) {
  std::vector<int> valences(mesh.nodes.size(), 0);
  for (const MeshElement& element : mesh.elements)
    for (int k = 0; k < corner_count(element); ++k) ++valences[element[k]];
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (mesh.freedom[n] == NodeFreedom::fixed || valences[n] == 4) valences[n] = 0;
  return valences;
}

void draw_mesh(const PlanarMesh& mesh, Vec2 shift, const std::string& words, Picture& picture) {
  for (const MeshElement& element : mesh.elements) {
    std::vector<Vec2> corners;
    for (int k = 0; k < corner_count(element); ++k) corners.push_back(mesh.nodes[element[k]] + shift);
    picture.polygon(corners, "fill=\"#f2f2f2\" stroke=\"#777\" stroke-width=\"0.8\"");
  }
  const auto valences = irregular_valences(mesh);
  int count = 0;
  for (std::size_t n = 0; n < valences.size(); ++n) {
    if (valences[n] == 0) continue;
    ++count;
    picture.dot(mesh.nodes[n] + shift, 6, valences[n],
                valences[n] < 4 ? "fill=\"#d55e00\"" : "fill=\"#0072b2\"");
  }
  picture.label(shift + Vec2{0, -5}, words + std::to_string(count) + " irregular nodes");
}

Result<std::string> cleanup_picture() {
  const SmoothingOptions smoothing{5, 2.5};
  auto mesh = mesh_by_subdivision(plate_with_holes(), nullptr, {5, 2.5});
  if (!mesh) return tl::unexpected(mesh.error());
  smooth(*mesh, nullptr, smoothing);
  Picture picture({-3, -9}, {240, 83}, 5);
  draw_mesh(*mesh, {0, 0}, "Before: ", picture);
  clean_up(*mesh, nullptr, {}, {5, 2.5});
  smooth(*mesh, nullptr, smoothing);
  draw_mesh(*mesh, {125, 0}, "After: ", picture);
  return picture.svg();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool triangles = words.size() == 3 && words[0] == "triangulation";
  if (!triangles && (words.size() != 2 || words[0] != "cleanup")) {
    std::fprintf(stderr,
                 "usage: draw_stage triangulation FILE.wkt OUT.svg\n       draw_stage cleanup OUT.svg\n");
    return 2;
  }
  const auto svg = triangles ? triangulation_picture(words[1]) : cleanup_picture();
  if (!svg) {
    std::fprintf(stderr, "%s\n", to_line(svg.error()).c_str());
    return 2;
  }
  std::ofstream out(words.back());
  out << *svg;
  return out.flush() ? 0 : 2;
}
