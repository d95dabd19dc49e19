#include "beadmesh/write/medial_json.h"

#include "beadmesh/write/json_lines.h"

namespace beadmesh {
namespace {

using json::number;
using json::Value;

Value flat_point(Vec2 p) {
  return json::point(Vec3{p.x, p.y, 0});
}

Value index_or_null(Index index) {
  return index == no_index ? Value(nullptr) : Value(index);
}

Value vertex_feet(const FaceMedial& face, size_t vertex) {
  Value list = Value::array();
  const std::vector<Foot>& feet = face.object.vertices[vertex].touching_points;
  for (size_t k = 0; k < feet.size(); ++k)
    list.push_back(face.vertex_feet.empty() ? flat_point(feet[k].point)
                                            : json::point(face.vertex_feet[vertex][k]));
  return list;
}

Value vertex_of(const FaceMedial& face, size_t i) {
  const MedialVertex& vertex = face.object.vertices[i];
  Value edges = Value::array();
  for (const Index edge : vertex.edges) edges.push_back(edge);
  return {{"id", i},
          {"type", name_of(vertex.type)},
          {"point", json::point(face.vertex_points[i])},
          {"uv", json::point(vertex.point)},
          {"radius", number(vertex.radius)},
          {"touching_points", vertex_feet(face, i)},
          {"edges", std::move(edges)}};
}

Value point_of(const FaceMedial& face, size_t edge, size_t k) {
  const MedialPoint& point = face.object.edges[edge].points[k];
  Value feet = Value::array();
  for (size_t side = 0; side < 2; ++side)
    feet.push_back(face.edge_feet.empty() ? flat_point(point.feet[side].point)
                                          : json::point(face.edge_feet[edge][k][side]));
  return {{"point", json::point(face.edge_points[edge][k])},
          {"uv", json::point(point.point)},
          {"radius", number(point.radius)},
          {"touching_points", std::move(feet)},
          {"subtended_angle", number(degrees(point.subtended_angle))}};
}

Value edge_of(const FaceMedial& face, size_t i) {
  const MedialEdge& edge = face.object.edges[i];
  Value points = Value::array();
  for (size_t k = 0; k < edge.points.size(); ++k) points.push_back(point_of(face, i, k));
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

Value face_of(const FaceMedial& face) {
  Value vertices = Value::array(), edges = Value::array();
  for (size_t i = 0; i < face.object.vertices.size(); ++i) vertices.push_back(vertex_of(face, i));
  for (size_t i = 0; i < face.object.edges.size(); ++i) edges.push_back(edge_of(face, i));
  return {{"face", face.face},
          {"loops", face.object.loops},
          {"vertices", std::move(vertices)},
          {"edges", std::move(edges)}};
}

}  // namespace

std::string medial_json(const std::vector<FaceMedial>& faces) {
  Value list = Value::array();
  for (const FaceMedial& face : faces) list.push_back(face_of(face));
  Value object;
  object["schema"] = "beadmesh.medial/1";
  object["unit"] = "mm";
  object["faces"] = std::move(list);
  return json::lines_of(object);
}

}  // namespace beadmesh
