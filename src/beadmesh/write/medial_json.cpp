#include "beadmesh/write/medial_json.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "beadmesh/write/json_lines.h"

namespace beadmesh {
namespace {

using json::Value;

/// Numbers of one face: with as many digits as the medial object has, 12 of the face's size.
class Numbers {
 public:
  explicit Numbers(double size) : unit_(std::pow(10, std::floor(std::log10(std::max(size, 1e-300))) - 12)) {}

  Value operator()(double value) const {
    if (!std::isfinite(value)) return nullptr;
    const double steps = std::round(value / unit_);
    if (!(std::abs(steps) < 1e15)) return value;
    // By a division where that is exact in decimal: 0.1 and not 0.1000000000000001.
    const double rounded = unit_ < 1 ? steps / std::round(1 / unit_) : steps * unit_;
    return rounded == 0 ? 0.0 : rounded;
  }
  Value operator()(Vec2 p) const { return {(*this)(p.x), (*this)(p.y)}; }
  Value operator()(Vec3 p) const { return {(*this)(p.x), (*this)(p.y), (*this)(p.z)}; }
  Value in_space(Vec2 p) const { return (*this)(Vec3{p.x, p.y, 0}); }

 private:
  double unit_;
};

Value index_or_null(Index index) {
  return index == no_index ? Value(nullptr) : Value(index);
}

Value vertex_feet(const FaceMedial& face, const Numbers& number, size_t vertex) {
  Value list = Value::array();
  const std::vector<Foot>& feet = face.object.vertices[vertex].touching_points;
  for (size_t k = 0; k < feet.size(); ++k)
    list.push_back(face.vertex_feet.empty() ? number.in_space(feet[k].point)
                                            : number(face.vertex_feet[vertex][k]));
  return list;
}

/// Where the circle touches the boundary all along: arc lengths along the loop; the end lies before the start
/// where the interval passes the loop's first point.
Value contact_intervals(const MedialVertex& vertex, const Numbers& number) {
  Value list = Value::array();
  for (const ContactInterval& interval : vertex.contact_intervals)
    list.push_back({{"loop", interval.loop}, {"from", number(interval.start)}, {"to", number(interval.end)}});
  return list;
}

Value vertex_of(const FaceMedial& face, const Numbers& number, size_t i) {
  const MedialVertex& vertex = face.object.vertices[i];
  Value edges = Value::array();
  for (const Index edge : vertex.edges) edges.push_back(edge);
  return {{"id", i},
          {"type", name_of(vertex.type)},
          {"point", number(face.vertex_points[i])},
          {"uv", number(vertex.point)},
          {"radius", number(vertex.radius)},
          {"touching_points", vertex_feet(face, number, i)},
          {"contact_intervals", contact_intervals(vertex, number)},
          {"edges", std::move(edges)}};
}

Value point_of(const FaceMedial& face, const Numbers& number, size_t edge, size_t k) {
  const MedialPoint& point = face.object.edges[edge].points[k];
  Value feet = Value::array();
  for (size_t side = 0; side < 2; ++side)
    feet.push_back(face.edge_feet.empty() ? number.in_space(point.feet[side].point)
                                          : number(face.edge_feet[edge][k][side]));
  return {{"point", number(face.edge_points[edge][k])},
          {"uv", number(point.point)},
          {"radius", number(point.radius)},
          {"touching_points", std::move(feet)},
          {"subtended_angle", json::number(degrees(point.subtended_angle))}};
}

Value edge_of(const FaceMedial& face, const Numbers& number, size_t i) {
  const MedialEdge& edge = face.object.edges[i];
  Value points = Value::array();
  for (size_t k = 0; k < edge.points.size(); ++k) points.push_back(point_of(face, number, i, k));
  return {{"id", i},
          {"type", name_of(edge.type)},
          {"start", index_or_null(edge.start)},
          {"end", index_or_null(edge.end)},
          {"length", number(edge.length)},
          {"thickness",
           {{"min", number(edge.thickness.min)},
            {"mean", number(edge.thickness.mean)},
            {"max", number(edge.thickness.max)}}},
          {"points", std::move(points)}};
}

/// Runs of cut segments, each {"loop", "from", "to"} in arc length along the loop; one that passes the start
/// of the loop ends beyond its length.
Value cut_runs(const PlanarRegion& region, const Numbers& number, const PlaneImage& image) {
  Value runs = Value::array();
  for (size_t l = 0; l < image.cut_sides.size(); ++l) {
    const std::vector<Vec2>& points = region.loops[l].points;
    const std::vector<bool>& cut = image.cut_sides[l];
    const size_t n = points.size();
    std::vector<double> at{0};
    for (size_t i = 0; i < n; ++i) at.push_back(at.back() + distance(points[i], points[(i + 1) % n]));
    for (size_t i = 0; i < n; ++i) {
      if (!cut[i] || cut[(i + n - 1) % n]) continue;  // a run starts here
      size_t end = i + 1;
      while (end < i + n && cut[end % n]) ++end;
      const double to = at[end <= n ? end : end - n];
      runs.push_back({{"loop", l}, {"from", number(at[i])}, {"to", number(to)}});
    }
  }
  return runs;
}

Value image_of(const PlanarRegion& region, const Numbers& number, const PlaneImage& image) {
  return {{"distortion",
           {{"max_ratio", number(image.distortion.max_ratio)},
            {"max_stretch", number(image.distortion.max_stretch)},
            {"mean_stretch", number(image.distortion.mean_stretch)}}},
          {"cut_length", number(image.cut_length)},
          {"cut_sides", cut_runs(region, number, image)}};
}

/// An item a line, so that never more than one of them is in memory as values.
template <class Item>
void write_list(std::ostream& out, size_t count, Item item) {
  out << '[';
  for (size_t i = 0; i < count; ++i) out << (i ? ",\n      " : "\n      ") << json::text_of(item(i));
  out << ']';
}

void write_face(std::ostream& out, const FaceMedial& face, const PlaneImage* image) {
  const Numbers number(face.object.size);
  out << "{\"face\":" << face.face << ",\"loops\":" << face.object.loops;
  if (image) out << ",\"plane_image\":" << json::text_of(image_of(face.region, number, *image));
  out << ",\"vertices\":";
  write_list(out, face.object.vertices.size(), [&](size_t i) { return vertex_of(face, number, i); });
  out << ",\"edges\":";
  write_list(out, face.object.edges.size(), [&](size_t i) { return edge_of(face, number, i); });
  out << '}';
}

}  // namespace

void write_medial_json(std::ostream& out, const std::vector<FaceMedial>& faces,
                       const std::vector<PlaneImage>& images) {
  out << "{\n  \"schema\": \"beadmesh.medial/1\",\n  \"unit\": \"mm\",\n  \"faces\": [";
  for (size_t i = 0; i < faces.size(); ++i) {
    out << (i ? ",\n    " : "\n    ");
    write_face(out, faces[i], i < images.size() ? &images[i] : nullptr);
  }
  out << (faces.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

}  // namespace beadmesh
