#include "beadmesh/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <set>

#include "beadmesh/read/panel_reader.h"
#include "examples/example_panels.h"
#include "examples/step_file.h"
#include "examples/truth.h"
#include "mesh/bead_plates.h"

namespace beadmesh {
namespace {

using namespace shapes;

bool same_mesh(const ShellMesh& a, const ShellMesh& b) {
  return a.nodes == b.nodes && std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(),
                                          b.elements.end(), [](const ShellElement& p, const ShellElement& q) {
                                            return p.nodes == q.nodes && p.part == q.part && p.bead == q.bead;
                                          });
}

Context with_jobs(int jobs) {
  Context context;
  context.jobs = jobs;
  return context;
}

TEST(Pipeline, FindsTheBeadsAndSaysWhyTheOthersAreNone) {
  const Panel panel = plate_of_every_kind();
  const BeadTable table = recognise_beads(panel);
  ASSERT_EQ(table.beads.size(), 3);
  EXPECT_EQ(table.beads[0].shape, "I");
  EXPECT_EQ(table.beads[1].shape, "T");
  EXPECT_EQ(table.beads[2].shape, "ring");
  for (Index b = 0; b < 3; ++b) {
    EXPECT_EQ(table.beads[b].id, b + 1) << "numbered in the order of the faces";
    EXPECT_EQ(table.beads[b].faces, std::vector<Index>{b});
    EXPECT_EQ(table.medials[b].face, panel.faces[b].number);
  }
  ASSERT_EQ(table.faces_not_beads.size(), 2);
  EXPECT_EQ(table.faces_not_beads[0].face, 4);
  EXPECT_EQ(table.faces_not_beads[1].face, 5);
  for (const RejectedFace& face : table.faces_not_beads) EXPECT_FALSE(face.reason.empty());
  EXPECT_TRUE(table.diagnostics.empty());
}

TEST(Pipeline, RuleIsAnOption) {
  BeadOptions options;
  options.min_aspect_ratio = 4.9;
  const BeadTable table = recognise_beads(plate_of_every_kind(), options);
  ASSERT_EQ(table.beads.size(), 2) << "the T is left out";
  EXPECT_EQ(table.beads[1].shape, "ring");
  EXPECT_EQ(table.beads[1].id, 2);
}

TEST(Pipeline, SameBitsForOneAndTwoJobs) {
  const Panel panel = plate_of_every_kind();
  const auto one = mesh_panel(panel, {}, {}, with_jobs(1)), two = mesh_panel(panel, {}, {}, with_jobs(2));
  ASSERT_TRUE(one && two);
  EXPECT_FALSE(one->mesh.nodes.empty());
  EXPECT_TRUE(same_mesh(one->mesh, two->mesh));
}

TEST(Pipeline, CancelledIsAFailure) {
  const std::atomic<bool> cancelled = true;
  Context context;
  context.cancelled = &cancelled;
  EXPECT_FALSE(mesh_panel(plate_of_every_kind(), {}, {}, context));
}

TEST(Pipeline, ProgressEndsAtOne) {
  std::mutex mutex;
  double recognised = 0, meshed = 0;
  Context context;
  context.progress = [&](std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex);
    (stage == "sheet" ? meshed : recognised) = std::max(fraction, stage == "sheet" ? meshed : recognised);
  };
  ASSERT_TRUE(mesh_panel(plate_of_every_kind(), {}, {}, context));
  EXPECT_EQ(recognised, 1);
  EXPECT_EQ(meshed, 1);
}

TEST(Pipeline, EmptyPanelIsAFailure) {
  EXPECT_FALSE(mesh_panel(Panel{}, {}));
}

TEST(Pipeline, MedialObjectOfAnyFace) {
  const Panel panel = plate_of_every_kind();
  const auto medial = medial_of_face(panel, 1);
  ASSERT_TRUE(medial) << medial.error().message;
  EXPECT_EQ(medial->face, 2);
  EXPECT_EQ(medial->object.edges.size(), 3);
  ASSERT_EQ(medial->edge_points.size(), 3);
  for (size_t e = 0; e < 3; ++e) {
    ASSERT_EQ(medial->edge_points[e].size(), medial->object.edges[e].points.size());
    ASSERT_EQ(medial->edge_feet[e].size(), medial->object.edges[e].points.size());
  }
  EXPECT_EQ(medial->vertex_points.size(), 4);
  EXPECT_TRUE(medial_of_face(panel, 4)) << "the sheet has one as well";
}

TEST(Pipeline, FaceThatCannotBeLaidFlatIsNamed) {
  Panel panel = plate_of_every_kind();
  panel.faces[3].facets.triangles.clear();
  const BeadTable table = recognise_beads(panel);
  EXPECT_EQ(table.beads.size(), 3);
  ASSERT_EQ(table.diagnostics.size(), 1);
  EXPECT_EQ(table.diagnostics[0].face, 4);
  EXPECT_FALSE(medial_of_face(panel, 3));
}

// ---------------------------------------------------------------- examples, through STEP

Panel example(const std::string& name) {
  const auto path = std::filesystem::path(testing::TempDir()) / ("pipeline_" + name + ".step");
  EXPECT_TRUE(examples::write_panel(*examples::example_panel(name), path));
  auto panel = read_panel(path);
  std::filesystem::remove(path);
  EXPECT_TRUE(panel) << panel.error().message;
  return panel ? std::move(*panel) : Panel{};
}

class ExamplePanel : public ::testing::TestWithParam<std::string> {};

TEST_P(ExamplePanel, EveryBeadIsFoundAsDrawnAndNoOther) {
  const Panel panel = example(GetParam());
  const BeadTable table = recognise_beads(panel);
  const auto truth = examples::truth_of(*examples::example_panel(GetParam()));
  std::set<Index> matched;
  int expected = 0;
  for (const examples::FeatureTruth& feature : truth) {
    if (feature.kind.empty()) continue;
    ++expected;
    const auto found = std::find_if(table.beads.begin(), table.beads.end(), [&](const Bead& b) {
      return !matched.contains(b.id) && feature.contains({b.point.x, b.point.y});
    });
    ASSERT_NE(found, table.beads.end()) << feature.shape << " of length " << feature.length;
    matched.insert(found->id);
    EXPECT_EQ(name_of(found->kind), feature.kind) << feature.shape;
    EXPECT_EQ(found->shape, feature.shape);
    EXPECT_EQ(found->loops, feature.loops);
    EXPECT_NEAR(found->width, feature.width, 0.12 * feature.width) << feature.shape;
    EXPECT_NEAR(found->height, feature.height, 0.15 * feature.height) << feature.shape;
  }
  EXPECT_EQ(int(table.beads.size()), expected);
}

INSTANTIATE_TEST_SUITE_P(Pipeline, ExamplePanel,
                         ::testing::Values("single", "basic", "rotated", "curved", "floor"),
                         [](const auto& test) { return test.param; });

TEST(Pipeline, BasicExampleHoldsTheHardRules) {
  const Panel panel = example("basic");
  const auto mesh = mesh_panel(panel, {});
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(verify_shell_mesh(mesh->mesh), std::vector<std::string>{});
  EXPECT_EQ(mesh->quality.inverted, 0);
  EXPECT_EQ(mesh->quality.edges_below_min, 0);
  EXPECT_GE(mesh->quality.scaled_jacobian_min, 0.3);
  EXPECT_LE(mesh->quality.trias, 0.005 * double(mesh->mesh.elements.size()));
  for (const BeadMeshing& meshing : mesh->meshing) EXPECT_EQ(meshing.method, "blocks");
}

TEST(Pipeline, MedialObjectsOfAllFacesInTheirOrder) {
  const Panel panel = plate_of_every_kind();
  std::vector<Index> all;
  for (Index f = 0; f < static_cast<Index>(panel.faces.size()); ++f) all.push_back(f);
  const PanelMedials one = medials_of_faces(panel, all, with_jobs(1)),
                     two = medials_of_faces(panel, all, with_jobs(2));
  ASSERT_EQ(one.faces.size(), panel.faces.size());
  ASSERT_EQ(one.images.size(), panel.faces.size());
  EXPECT_TRUE(one.diagnostics.empty());
  for (std::size_t f = 0; f < panel.faces.size(); ++f) {
    EXPECT_EQ(one.faces[f].face, panel.faces[f].number);
    EXPECT_FALSE(one.images[f].is_cut());
    ASSERT_EQ(one.faces[f].object.vertices.size(), two.faces[f].object.vertices.size());
    EXPECT_EQ(one.faces[f].vertex_points, two.faces[f].vertex_points) << "the same bits";
    EXPECT_EQ(one.faces[f].edge_points, two.faces[f].edge_points);
  }
}

TEST(Pipeline, AFaceWithoutAMedialObjectIsNamedAndDoesNotStopTheOthers) {
  Panel panel = plate_of_every_kind();
  panel.faces[1].facets.triangles.clear();
  const PanelMedials medials = medials_of_faces(panel, {0, 1, 2});
  ASSERT_EQ(medials.faces.size(), 2);
  ASSERT_EQ(medials.diagnostics.size(), 1);
  EXPECT_EQ(medials.diagnostics[0].face, panel.faces[1].number);
  EXPECT_EQ(medials.diagnostics[0].severity, Severity::error);
  EXPECT_FALSE(medials.diagnostics[0].hint.empty());
}

TEST(Pipeline, ALadderOfTwoWindowsIsMeshedByBlocksAndNotListed) {
  BeadPlate plate(190, 150);
  plate.add(examples::ladder_bead(3, 52, 56, 16, 8), 5);
  const Panel panel = plate.take();
  const auto mesh = mesh_panel(panel, {});
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_TRUE(mesh->table.beads.empty());
  EXPECT_TRUE(mesh->meshing.empty());
  EXPECT_TRUE(mesh->table.medials.empty());
  EXPECT_TRUE(mesh->mesh.beads.empty());
  ASSERT_FALSE(mesh->table.faces_not_beads.empty());
  EXPECT_EQ(mesh->table.faces_not_beads[0].reason, "it has 3 loops, a bead has at most 2");
  const BeadTable alone = recognise_beads(panel);
  ASSERT_EQ(mesh->table.faces_not_beads.size(), alone.faces_not_beads.size());
  for (size_t i = 0; i < alone.faces_not_beads.size(); ++i)
    EXPECT_EQ(mesh->table.faces_not_beads[i].reason, alone.faces_not_beads[i].reason);
  ASSERT_EQ(mesh->mesh.parts.size(), 1u);
  EXPECT_EQ(mesh->mesh.parts[0].name, "sheet");
  // By blocks nodes lie on the crest, 5 mm up.
  const auto on_crest = std::count_if(mesh->mesh.nodes.begin(), mesh->mesh.nodes.end(),
                                      [](const Vec3& p) { return p.z > 4.9; });
  EXPECT_GT(on_crest, 60);
  EXPECT_EQ(mesh->quality.edges_below_min, 0);
  BeadOptions more;
  more.max_loops = 3;
  const auto listed = mesh_panel(panel, {}, more);
  ASSERT_TRUE(listed);
  ASSERT_EQ(listed->table.beads.size(), 1u);
  EXPECT_EQ(listed->table.beads[0].id, 1);
  EXPECT_EQ(listed->meshing[0].method, "blocks");
  EXPECT_EQ(listed->mesh.nodes, mesh->mesh.nodes) << "the same mesh";
}

}  // namespace
}  // namespace beadmesh
