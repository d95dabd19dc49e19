#include "beadmesh/mesh/chain_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "beadmesh/blocking/block_layout.h"
#include "mesh/bead_plates.h"

namespace beadmesh {
namespace {

using namespace shapes;

std::vector<Index> ids(const std::vector<LoopNode>& nodes) {
  std::vector<Index> out;
  for (const LoopNode& node : nodes) out.push_back(node.id);
  return out;
}

/// The same cyclic sequence, the other one backwards?
bool runs_against(std::vector<Index> a, std::vector<Index> b) {
  if (a.size() != b.size() || a.empty()) return false;
  std::reverse(b.begin(), b.end());
  const auto at = std::find(b.begin(), b.end(), a.front());
  if (at == b.end()) return false;
  std::rotate(b.begin(), at, b.end());
  return a == b;
}

/// A plate with one I bead (face 0) in a sheet (face 1).
struct Plate {
  Plate() : panel(make()), chains(chains_of(panel)), nodes(panel, chains), bead(study(0)), sheet(study(1)) {}

  static Panel make() {
    BeadPlate plate(120, 60);
    plate.add(examples::straight_bead(60, 16), 4);
    return plate.take();
  }
  std::unique_ptr<FaceStudy> study(Index face) const { return std::move(study_faces(panel, {face}).value()); }
  Index bead_chain() const { return chains.loops[0][0][0].chain; }

  Panel panel;
  ChainSet chains;
  ChainNodes nodes;
  std::unique_ptr<FaceStudy> bead, sheet;
};

TEST(ChainNodes, LoopsWithoutNodesAreEmpty) {
  Plate plate;
  EXPECT_FALSE(plate.nodes.is_set(plate.bead_chain()));
  EXPECT_TRUE(plate.nodes.nodes_of_loop(0, 0, plate.bead->region).empty());
}

TEST(ChainNodes, BothFacesSeeTheSameNodesInOppositeOrder) {
  Plate plate;
  plate.nodes.place_evenly(plate.bead_chain(), 34);
  EXPECT_TRUE(plate.nodes.is_set(plate.bead_chain()));
  EXPECT_EQ(plate.nodes.count(plate.bead_chain()), 34);
  const auto inside = plate.nodes.nodes_of_loop(0, 0, plate.bead->region);
  const auto outside = plate.nodes.nodes_of_loop(1, 1, plate.sheet->region);
  ASSERT_EQ(inside.size(), 34);
  EXPECT_TRUE(runs_against(ids(inside), ids(outside)));
}

TEST(ChainNodes, NodeAtTheSeamIsSeenOnceFromEitherSide) {
  // place_evenly puts node 0 at arc length 0: the face that walks the closed chain backward meets it at the
  // end of it.
  Plate plate;
  plate.nodes.place_evenly(plate.bead_chain(), 4);
  for (const auto& seen : {plate.nodes.nodes_of_loop(0, 0, plate.bead->region),
                           plate.nodes.nodes_of_loop(1, 1, plate.sheet->region)}) {
    const auto numbers = ids(seen);
    EXPECT_EQ(numbers.size(), 4);
    EXPECT_EQ(std::set<Index>(numbers.begin(), numbers.end()).size(), 4);
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 0), 1);
  }
}

TEST(ChainNodes, FlatPlacesLieUnderTheNodes) {
  Plate plate;
  for (Index c = 0; c < Index(plate.chains.chains.size()); ++c) plate.nodes.place_evenly(c, 10);
  for (Index loop : {0, 1}) {
    double before = -1;
    for (const LoopNode& node : plate.nodes.nodes_of_loop(1, loop, plate.sheet->region)) {
      EXPECT_LT(distance(plate.sheet->lift(node.flat), plate.nodes.points()[node.id]), 1e-6);
      EXPECT_GT(node.position, before) << "in order";
      before = node.position;
    }
    EXPECT_GT(before, 0);
  }
}

TEST(ChainNodes, OpenChainsShareTheirEnds) {
  Plate plate;
  for (Index c = 0; c < Index(plate.chains.chains.size()); ++c)
    if (!plate.chains.chains[c].closed) plate.nodes.place_evenly(c, 6);
  const auto outline = plate.nodes.nodes_of_loop(1, 0, plate.sheet->region);
  ASSERT_EQ(outline.size(), 24);
  EXPECT_EQ(plate.nodes.points().size(), 24) << "four corners, not eight";
  int corners = 0;
  for (const LoopNode& node : outline) {
    const Vec3 p = plate.nodes.points()[node.id];
    corners += std::abs(std::abs(p.x) - 60) < 1e-9 && std::abs(std::abs(p.y) - 30) < 1e-9;
  }
  EXPECT_EQ(corners, 4);
}

TEST(ChainNodes, NodesOfABeadAreSeenByTheSheet) {
  Plate plate;
  const BlockLayoutBuilder boundary(plate.bead->region);
  std::vector<BoundaryPosition> positions;
  for (const double share : {0.05, 0.0, 0.31, 0.62, 0.9})
    positions.push_back({0, share * boundary.loop_length(0)});
  const auto placed = plate.nodes.place_from_face(0, plate.bead->region, positions);
  ASSERT_EQ(placed.size(), positions.size());
  for (size_t i = 0; i < placed.size(); ++i)
    EXPECT_LT(distance(plate.nodes.points()[placed[i]], plate.bead->lift(boundary.point_at(positions[i]))),
              1e-3);
  const auto inside = plate.nodes.nodes_of_loop(0, 0, plate.bead->region);
  ASSERT_EQ(inside.size(), 5);
  EXPECT_EQ(ids(inside), (std::vector<Index>{placed[1], placed[0], placed[2], placed[3], placed[4]}));
  EXPECT_TRUE(runs_against(ids(inside), ids(plate.nodes.nodes_of_loop(1, 1, plate.sheet->region))));
}

TEST(ChainNodes, PositionsOutsideOneTurnAreTheSamePlaces) {
  Plate plate;
  const double length = BlockLayoutBuilder(plate.bead->region).loop_length(0);
  const auto placed = plate.nodes.place_from_face(
      0, plate.bead->region, {{0, 10}, {0, 0.6 * length - length}, {0, 0.3 * length + length}});
  const auto seen = plate.nodes.nodes_of_loop(0, 0, plate.bead->region);
  ASSERT_EQ(seen.size(), 3);
  EXPECT_NEAR(seen[1].position, 0.3 * length, 1e-6);
  EXPECT_EQ(seen[1].id, placed[2]);
}

TEST(ChainNodes, EverySegmentOfALoopLiesOnAChain) {
  Plate plate;
  for (Index face : {0, 1})
    for (Index loop = 0; loop < Index(plate.panel.faces[face].loops.size()); ++loop) {
      const auto& segments = plate.nodes.segments_of(face, loop);
      const Facets& facets = plate.panel.faces[face].facets;
      ASSERT_EQ(segments.size(), facets.loops[loop].size());
      for (size_t i = 0; i < segments.size(); ++i) {
        const auto& points = plate.chains.chains[segments[i].chain].points;
        EXPECT_EQ(facets.panel_points[facets.loops[loop][i]],
                  points[segments[i].segment + segments[i].reversed]);
      }
    }
}

}  // namespace
}  // namespace beadmesh
