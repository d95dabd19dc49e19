#include "beadmesh/mesh/face_shortfalls.h"

#include <gtest/gtest.h>

namespace beadmesh {
namespace {

/// Two faces of squares side by side; the second is a strip of the given width.
ShellMesh two_faces(double width) {
  ShellMesh mesh;
  for (const double x : {0.0, 5.0, 5.0 + width})
    for (const double y : {0.0, 5.0, 10.0}) mesh.nodes.push_back({x, y, 0});
  const auto add = [&](Index corner, Index face) {
    mesh.elements.push_back({{corner, corner + 3, corner + 4, corner + 1}, 0, face, 0});
  };
  add(0, 7), add(1, 7), add(3, 8), add(4, 8);
  return mesh;
}

TEST(FaceShortfalls, NoneWhereTheRulesHold) {
  EXPECT_TRUE(face_shortfalls(two_faces(2.5), 2.5).empty());
}

TEST(FaceShortfalls, ANarrowFaceIsToldFromAShortBoundary) {
  const auto found = face_shortfalls(two_faces(1.25), 2.5);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].face, 8);
  EXPECT_EQ(found[0].code, "mesh.face.min_edge");
  EXPECT_EQ(found[0].message,
            "2 edges on its boundary under the minimum of 2.5 mm, the shortest 1.250 mm: between corners of "
            "the CAD face "
            "nearer than the minimum");
  EXPECT_EQ(found[1].face, 8);
  EXPECT_EQ(found[1].message,
            "1 edge across it under the minimum of 2.5 mm, the shortest 1.250 mm: the face is narrower than "
            "the minimum");
}

TEST(FaceShortfalls, AnEdgeInside) {
  ShellMesh mesh;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) mesh.nodes.push_back({5.0 * i, 5.0 * j, 0});
  for (Index j = 0; j < 3; ++j)
    for (Index i = 0; i < 3; ++i)
      mesh.elements.push_back({{4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4}, 0, 1, 0});
  mesh.nodes[5].x = 8.5;
  const auto found = face_shortfalls(mesh, 2.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].message, "1 edge inside under the minimum of 2.5 mm, the shortest 1.500 mm");
}

TEST(FaceShortfalls, ElementsTurnedOverAreNamedWithAPlace) {
  ShellMesh mesh = two_faces(5);
  mesh.nodes[8] = {6, 6, 0};
  const auto found = face_shortfalls(mesh, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "mesh.face.inverted");
  EXPECT_EQ(found[0].face, 8);
  EXPECT_EQ(found[0].message, "1 element is turned over, near 5.0 5.0 0.0");
}

}  // namespace
}  // namespace beadmesh
