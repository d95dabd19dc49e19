#include "beadmesh/write/medial_json.h"

#include <gtest/gtest.h>

#include <sstream>

#include <nlohmann/json.hpp>

#include "write/medial_stadium.h"

namespace beadmesh {
namespace {

std::string text_of(const std::vector<FaceMedial>& faces, const std::vector<PlaneImage>& images = {}) {
  std::ostringstream out;
  write_medial_json(out, faces, images);
  return out.str();
}

using nlohmann::json;
using test::stadium;

TEST(MedialJson, FollowsTheSchema) {
  const json object = json::parse(text_of({stadium()}));
  EXPECT_EQ(object["schema"], "beadmesh.medial/1");
  EXPECT_EQ(object["unit"], "mm");
  const json& face = object["faces"].at(0);
  EXPECT_EQ(face["face"], 3);
  EXPECT_EQ(face["loops"], 1);
  EXPECT_EQ(face["vertices"].at(1),
            json::parse(R"({"id": 1, "type": "S", "point": [40.0, 0.0, 7.0], "uv": [40.0, 0.0],
      "radius": 10.0, "touching_points": [[40.0, -10.0, 0.0], [50.0, 0.0, 0.0], [40.0, 10.0, 0.0]],
      "contact_intervals": [{"loop": 0, "from": 1.0, "to": 2.0}], "edges": [0]})"));
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
  const json object = json::parse(text_of({face}))["faces"][0];
  EXPECT_EQ(object["vertices"][1]["touching_points"][1], json::parse("[50.0, 0.0, 6.0]"));
  EXPECT_EQ(object["edges"][0]["points"][1]["touching_points"][0], json::parse("[20.0, 10.0, 6.0]"));
}

TEST(MedialJson, AClosedEdgeHasNoVertices) {
  FaceMedial face = stadium();
  face.object.vertices.clear();
  face.vertex_points.clear();
  face.object.edges[0].type = MedialEdgeType::N;
  face.object.edges[0].start = face.object.edges[0].end = no_index;
  const json edge = json::parse(text_of({face}))["faces"][0]["edges"][0];
  EXPECT_EQ(edge["type"], "N");
  EXPECT_TRUE(edge["start"].is_null());
  EXPECT_TRUE(edge["end"].is_null());
}

TEST(MedialJson, SaysHowTheFaceCameIntoThePlane) {
  FaceMedial face;
  face.face = 4;
  face.region.loops = {{{{0, 0}, {30, 0}, {30, 10}, {20, 10}, {10, 10}, {0, 10}}, {}, {}}};
  PlaneImage image;
  image.distortion = {1.5, 1.25, 1.125};
  image.cut_length = 10;
  image.cut_sides = {{false, true, false, false, true, true}};  // the last run ends where the loop starts
  const json object = json::parse(text_of({face}, {image}))["faces"][0];
  EXPECT_EQ(object["plane_image"], json::parse(R"({"distortion": {"max_ratio": 1.5, "max_stretch": 1.25,
      "mean_stretch": 1.125}, "cut_length": 10.0,
      "cut_sides": [{"loop": 0, "from": 30.0, "to": 40.0}, {"loop": 0, "from": 60.0, "to": 80.0}]})"));
  EXPECT_FALSE(json::parse(text_of({face}))["faces"][0].contains("plane_image"));

  PlaneImage over;
  over.cut_sides = {{true, false, false, false, false, true}};
  const json sides = json::parse(text_of({face}, {over}))["faces"][0]["plane_image"]["cut_sides"];
  EXPECT_EQ(sides, json::parse(R"([{"loop": 0, "from": 70.0, "to": 30.0}])")) << "past the first point";
}

TEST(MedialJson, NoFacesAreAnEmptyList) {
  EXPECT_EQ(json::parse(text_of({}))["faces"], json::array());
}

}  // namespace
}  // namespace beadmesh
