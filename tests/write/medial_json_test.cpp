#include "beadmesh/write/medial_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "write/medial_stadium.h"

namespace beadmesh {
namespace {

using nlohmann::json;
using test::stadium;

TEST(MedialJson, FollowsTheSchema) {
  const json object = json::parse(medial_json({stadium()}));
  EXPECT_EQ(object["schema"], "beadmesh.medial/1");
  EXPECT_EQ(object["unit"], "mm");
  const json& face = object["faces"].at(0);
  EXPECT_EQ(face["face"], 3);
  EXPECT_EQ(face["loops"], 1);
  EXPECT_EQ(face["vertices"].at(1),
            json::parse(R"({"id": 1, "type": "S", "point": [40.0, 0.0, 7.0], "uv": [40.0, 0.0],
      "radius": 10.0, "touching_points": [[40.0, -10.0, 0.0], [50.0, 0.0, 0.0], [40.0, 10.0, 0.0]], "edges": [0]})"));
  const json& edge = face["edges"].at(0);
  EXPECT_EQ(edge["type"], "S-S");
  EXPECT_EQ(edge["start"], 0);
  EXPECT_EQ(edge["end"], 1);
  EXPECT_EQ(edge["thickness"], json::parse(R"({"min": 20.0, "mean": 20.0, "max": 20.0})"));
  EXPECT_EQ(edge["points"].at(1),
            json::parse(R"({"point": [20.0, 0.0, 7.0], "uv": [20.0, 0.0], "radius": 10.0,
      "touching_points": [[20.0, 10.0, 0.0], [20.0, -10.0, 0.0]], "subtended_angle": 180.0})"));
}

TEST(MedialJson, LiftedFeetAreOnTheSurface) {
  FaceMedial face = stadium();
  face.vertex_feet = {{{0, -10, 6}, {-10, 0, 6}, {0, 10, 6}}, {{40, -10, 6}, {50, 0, 6}, {40, 10, 6}}};
  face.edge_feet = {{{Vec3{0, 10, 6}, Vec3{0, -10, 6}},
                     {Vec3{20, 10, 6}, Vec3{20, -10, 6}},
                     {Vec3{40, 10, 6}, Vec3{40, -10, 6}}}};
  const json object = json::parse(medial_json({face}))["faces"][0];
  EXPECT_EQ(object["vertices"][1]["touching_points"][1], json::parse("[50.0, 0.0, 6.0]"));
  EXPECT_EQ(object["edges"][0]["points"][1]["touching_points"][0], json::parse("[20.0, 10.0, 6.0]"));
}

TEST(MedialJson, AClosedEdgeHasNoVertices) {
  FaceMedial face = stadium();
  face.object.vertices.clear();
  face.vertex_points.clear();
  face.object.edges[0].type = MedialEdgeType::N;
  face.object.edges[0].start = face.object.edges[0].end = no_index;
  const json edge = json::parse(medial_json({face}))["faces"][0]["edges"][0];
  EXPECT_EQ(edge["type"], "N");
  EXPECT_TRUE(edge["start"].is_null());
  EXPECT_TRUE(edge["end"].is_null());
}

TEST(MedialJson, NoFacesAreAnEmptyList) {
  EXPECT_EQ(json::parse(medial_json({}))["faces"], json::array());
}

}  // namespace
}  // namespace beadmesh
