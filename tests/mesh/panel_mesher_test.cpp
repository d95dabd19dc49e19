#include "beadmesh/mesh/panel_mesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>

#include "beadmesh/bead/recognition.h"
#include "mesh/bead_plates.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// The first `beads` faces are the beads.
StudiedPanel studied(const Panel& panel, Index beads) {
  StudiedPanel out;
  for (Index f = 0; f < Index(panel.faces.size()); ++f) {
    auto study = study_faces(panel, {f});
    out.studies.push_back(std::move(study.value()));
    out.medials.emplace_back();
    if (f >= beads) continue;
    out.medials.back() = std::make_unique<MedialObject>(medial_of(out.studies.back()->region));
    Bead bead = recognise(*out.studies.back(), *out.medials.back()).value();
    bead.id = f + 1;
    out.table.beads.push_back(std::move(bead));
  }
  return out;
}

/// Edges with one element only that do not lie on the rectangular outline.
int free_edges_inside(const ShellMesh& mesh, double length, double width) {
  std::map<std::pair<Index, Index>, int> uses;
  for (const ShellElement& element : mesh.elements)
    for (int k = 0; k < corner_count(element.nodes); ++k)
      ++uses[std::minmax(element.nodes[k], element.nodes[(k + 1) % corner_count(element.nodes)])];
  const auto on_outline = [&](Index n) {
    const Vec3 p = mesh.nodes[n];
    return std::abs(std::abs(p.x) - length / 2) < 1e-6 || std::abs(std::abs(p.y) - width / 2) < 1e-6;
  };
  return static_cast<int>(std::count_if(uses.begin(), uses.end(), [&](const auto& edge) {
    return edge.second == 1 && !(on_outline(edge.first.first) && on_outline(edge.first.second));
  }));
}

const BeadSet* set_of(const ShellMesh& mesh, Index bead) {
  for (const BeadSet& set : mesh.beads)
    if (set.bead == bead) return &set;
  return nullptr;
}

void expect_conforming_and_good(const PanelMesh& mesh) {
  EXPECT_EQ(verify_shell_mesh(mesh.mesh), std::vector<std::string>{});
  EXPECT_EQ(free_edges_inside(mesh.mesh, 240, 150), 0);
  EXPECT_EQ(mesh.quality.trias, 0);
  EXPECT_EQ(mesh.quality.inverted, 0);
  EXPECT_EQ(mesh.quality.edges_below_min, 0);
  EXPECT_GE(mesh.quality.scaled_jacobian_min, 0.3);
  EXPECT_GE(mesh.quality.scaled_jacobian_mean, 0.9);
  for (const BeadMeshing& meshing : mesh.meshing) EXPECT_EQ(meshing.method, "blocks");
  EXPECT_TRUE(mesh.table.diagnostics.empty());
}

void expect_nodes_on_the_surface(const PanelMesh& mesh) {
  const Base base = cylinder_base(900);
  for (const ShellElement& element : mesh.mesh.elements)
    for (const Index n : element.nodes) {
      const Vec3 p = mesh.mesh.nodes[n];
      if (element.bead == 0) {
        EXPECT_NEAR(p.z, base({p.x, p.y}), 0.02);
      } else {
        EXPECT_GE((p.z - base({p.x, p.y})) * (element.bead == 3 ? -1 : 1), -0.02) << "bead " << element.bead;
      }
    }
}

void expect_parts_and_sets_of_the_beads(const PanelMesh& mesh, const Panel& panel) {
  std::set<std::string> names;
  std::set<Index> ids;
  for (const ShellPart& part : mesh.mesh.parts) {
    names.insert(part.name);
    ids.insert(part.id);
    EXPECT_EQ(part.thickness, 0.8);
  }
  EXPECT_EQ(names, (std::set<std::string>{"sheet", "bead_I", "bead_generic", "bead_annular"}));
  EXPECT_EQ(ids.size(), 4);
  const Base base = cylinder_base(900);
  for (const Index b : {1, 2, 3}) {
    const BeadSet* set = set_of(mesh.mesh, b);
    ASSERT_TRUE(set);
    EXPECT_EQ(int(set->elements.size()), mesh.meshing[b - 1].elements);
    for (const Index e : set->elements) {
      EXPECT_EQ(mesh.mesh.elements[e].bead, b);
      EXPECT_EQ(mesh.mesh.elements[e].face, panel.faces[b - 1].number);
    }
    EXPECT_TRUE(std::is_sorted(set->crest_nodes.begin(), set->crest_nodes.end()));
    const auto on_top = std::count_if(set->crest_nodes.begin(), set->crest_nodes.end(), [&](Index n) {
      const Vec3 p = mesh.mesh.nodes[n];
      return std::abs(std::abs(p.z - base({p.x, p.y})) - 5) < 0.05;
    });
    EXPECT_GT(on_top, int(0.7 * double(set->crest_nodes.size()))) << "all but the caps";
  }
}

/// All nodes of some elements.
std::set<Index> nodes_of(const ShellMesh& mesh, const std::vector<Index>& elements) {
  std::set<Index> nodes;
  for (const Index e : elements)
    for (const Index n : mesh.elements[e].nodes)
      if (n != no_index) nodes.insert(n);
  return nodes;
}

void expect_sets_of_boundaries_crest_lines_and_caps(const PanelMesh& mesh) {
  const size_t ends[] = {2, 3, 0};  // of the I-bead, the T and the ring
  for (const Index b : {1, 2, 3}) {
    const BeadSet* set = set_of(mesh.mesh, b);
    ASSERT_TRUE(set);
    std::set<Index> of_others, shared;
    for (const ShellElement& element : mesh.mesh.elements)
      if (element.bead != b)
        for (const Index n : element.nodes) of_others.insert(n);
    for (const Index n : nodes_of(mesh.mesh, set->elements))
      if (of_others.count(n)) shared.insert(n);
    EXPECT_EQ(std::set<Index>(set->boundary_nodes.begin(), set->boundary_nodes.end()), shared);

    std::set<Index> crest;
    for (const auto& line : set->crest_lines) crest.insert(line.begin(), line.end());
    EXPECT_EQ(std::vector<Index>(crest.begin(), crest.end()), set->crest_nodes);

    EXPECT_TRUE(std::includes(set->elements.begin(), set->elements.end(), set->cap_elements.begin(),
                              set->cap_elements.end()));
    const std::set<Index> capped = nodes_of(mesh.mesh, set->cap_elements);
    const size_t tips = std::count_if(crest.begin(), crest.end(),
                                      [&](Index n) { return shared.count(n) && capped.count(n); });
    EXPECT_EQ(tips, ends[b - 1]);
    EXPECT_LT(set->cap_elements.size(), 0.7 * double(set->elements.size()));
  }
}

void expect_sides_of_the_blocks_as_meshed(const PanelMesh& mesh) {
  for (size_t b = 0; b < mesh.meshing.size(); ++b) {
    const BeadMeshing& meshing = mesh.meshing[b];
    ASSERT_EQ(meshing.method, "blocks");
    EXPECT_GT(meshing.blocks, 1);
    std::map<VirtualEdgeKind, int> lines;
    for (const BlockSideLine& line : meshing.block_lines) {
      ++lines[line.kind];
      for (const Vec3& p : line.points)
        EXPECT_NE(std::find(mesh.mesh.nodes.begin(), mesh.mesh.nodes.end(), p), mesh.mesh.nodes.end());
    }
    EXPECT_GT(lines[VirtualEdgeKind::boundary], 1);
    EXPECT_GT(lines[VirtualEdgeKind::split], 1) << "bead " << b;
  }
}

/// One mesh for all that is asked of it: it takes a while, and each test is a process.
TEST(PanelMesher, PanelOfEveryKindIsAsItShouldBe) {
  const Panel panel = plate_of_every_kind();
  PanelMesherOptions options;
  options.thickness = 0.8;
  const auto mesh = mesh_studied_panel(panel, studied(panel, 3), options);
  ASSERT_TRUE(mesh) << mesh.error().message;
  expect_conforming_and_good(*mesh);
  expect_nodes_on_the_surface(*mesh);
  expect_parts_and_sets_of_the_beads(*mesh, panel);
  expect_sets_of_boundaries_crest_lines_and_caps(*mesh);
  expect_sides_of_the_blocks_as_meshed(*mesh);
}

TEST(PanelMesher, NestedRingsShareTheirNodes) {
  BeadPlate plate(140, 140);
  plate.add(examples::circular_ring(50, 14), 5);
  plate.add_ring_inside({0, 0}, 36, 14, -5);
  const Panel panel = plate.take();
  const auto mesh = mesh_studied_panel(panel, studied(panel, 2), {});
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(verify_shell_mesh(mesh->mesh), std::vector<std::string>{});
  EXPECT_EQ(free_edges_inside(mesh->mesh, 140, 140), 0);
  for (const BeadMeshing& meshing : mesh->meshing) EXPECT_EQ(meshing.method, "blocks");
  EXPECT_EQ(mesh->quality.edges_below_min, 0);
}

/// Positions of the nodes of a bead's elements, in the order of the elements.
std::vector<Vec3> bead_nodes(const ShellMesh& mesh, Index bead) {
  std::vector<Vec3> points;
  for (const ShellElement& element : mesh.elements)
    for (int k = 0; element.bead == bead && k < corner_count(element.nodes); ++k)
      points.push_back(mesh.nodes[element.nodes[k]]);
  return points;
}

TEST(PanelMesher, ControlOfOneBeadChangesNoOther) {
  const Panel panel = plate_of_every_kind();
  const StudiedPanel study = studied(panel, 3);
  PanelMesherOptions options;
  const auto before = mesh_studied_panel(panel, study, options);
  BeadMeshControl control;
  control.size = 4;
  control.elements_across = 2;
  options.controls.single = {{{0, study.table.beads[0].point}, control}};
  const auto after = mesh_studied_panel(panel, study, options);
  ASSERT_TRUE(before && after);
  EXPECT_NE(before->meshing[0].elements_across, 2);
  EXPECT_EQ(after->meshing[0].elements_across, 2);
  EXPECT_EQ(after->meshing[0].size, 4);
  EXPECT_NE(bead_nodes(after->mesh, 1), bead_nodes(before->mesh, 1));
  for (const Index other : {2, 3}) {
    EXPECT_EQ(after->meshing[other - 1].size, 5);
    EXPECT_EQ(bead_nodes(after->mesh, other), bead_nodes(before->mesh, other));
  }
  EXPECT_EQ(free_edges_inside(after->mesh, 240, 150), 0);
}

TEST(PanelMesher, MethodFaceIsNoShortfallAndARefusalIsNamed) {
  const Panel panel = plate_of_every_kind();
  PanelMesherOptions options;
  options.controls.of(BeadKind::I).method = BeadMethod::face;
  options.controls.of(BeadKind::annular).elements_along = 31;
  const auto mesh = mesh_studied_panel(panel, studied(panel, 3), options);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->meshing[0].method, "face");
  EXPECT_GT(mesh->meshing[0].elements, 0);
  EXPECT_EQ(mesh->meshing[1].method, "blocks");
  EXPECT_EQ(mesh->meshing[2].method, "blocks");
  ASSERT_EQ(mesh->meshing[2].notes.size(), 1);
  ASSERT_EQ(mesh->table.diagnostics.size(), 1) << "none for the face that was asked for";
  EXPECT_EQ(mesh->table.diagnostics[0].code, "mesh.bead.control");
  EXPECT_EQ(mesh->table.diagnostics[0].entity, "bead 3");
  EXPECT_EQ(free_edges_inside(mesh->mesh, 240, 150), 0);
}

TEST(PanelMesher, ControlsOfNestedRingsAreShared) {
  BeadPlate plate(140, 140);
  plate.add(examples::circular_ring(50, 14), 5);
  plate.add_ring_inside({0, 0}, 36, 14, -5);
  const Panel panel = plate.take();
  PanelMesherOptions options;
  BeadMeshControl control;
  control.elements_along = 36;
  options.controls.single = {{{2, {}}, control}};
  const auto mesh = mesh_studied_panel(panel, studied(panel, 2), options);
  ASSERT_TRUE(mesh) << mesh.error().message;
  for (const BeadMeshing& meshing : mesh->meshing) {
    EXPECT_EQ(meshing.notes, std::vector<std::string>{});
    EXPECT_EQ(meshing.elements, 36 * meshing.elements_across);
  }
}

TEST(PanelMesher, LocalSizeRefinesTheBoundariesAndTheBeadInTheBall) {
  const Panel panel = plate_of_every_kind();
  const StudiedPanel study = studied(panel, 3);
  PanelMesherOptions options;
  options.min_edge = 1.2;
  const auto before = mesh_studied_panel(panel, study, options);
  options.local_sizes = {{{-120, 75, 0}, 90, 3}};
  const auto after = mesh_studied_panel(panel, study, options);
  ASSERT_TRUE(before && after);
  const auto on_top = [](const ShellMesh& mesh, bool left) {
    return std::count_if(mesh.nodes.begin(), mesh.nodes.end(),
                         [&](Vec3 p) { return std::abs(p.y - 75) < 1e-6 && (left ? p.x < -40 : p.x > 40); });
  };
  EXPECT_GT(on_top(after->mesh, true), 1.5 * double(on_top(before->mesh, true)));
  EXPECT_NEAR(double(on_top(after->mesh, false)), double(on_top(before->mesh, false)), 1)
      << "an even number on the whole chain may shift one";
  EXPECT_LT(after->meshing[0].size, 3.5);
  EXPECT_GT(after->meshing[0].elements, 1.5 * before->meshing[0].elements);
  EXPECT_EQ(after->meshing[2].size, 5);
  EXPECT_EQ(after->quality.edges_below_min, 0);
  EXPECT_EQ(free_edges_inside(after->mesh, 240, 150), 0);
}

TEST(PanelMesher, RefusesControlsThatMakeNoSense) {
  const Panel panel = plate_of_every_kind();
  const StudiedPanel study = studied(panel, 3);
  PanelMesherOptions options;
  options.controls.single = {{{9, {}}, {}}};
  EXPECT_EQ(mesh_studied_panel(panel, study, options).error().code, "control.bead");
  options.controls = {};
  options.local_sizes = {{{0, 0, 0}, 10, 1}};
  EXPECT_EQ(mesh_studied_panel(panel, study, options).error().code, "control.local_size");
}

TEST(PanelMesher, BeadThatDefeatsItsMethodsIsAnOrdinaryFaceAndNamed) {
  BeadPlate plate(120, 60);
  plate.add(examples::straight_bead(60, 4), 0.7);
  const Panel panel = plate.take();
  // Two elements of 6 mm do not fit its width.
  const auto mesh = mesh_studied_panel(panel, studied(panel, 1), {12, 6, 1});
  ASSERT_TRUE(mesh) << mesh.error().message;
  ASSERT_EQ(mesh->meshing.size(), 1);
  EXPECT_EQ(mesh->meshing[0].method, "fallback");
  EXPECT_GT(mesh->meshing[0].elements, 0);
  EXPECT_FALSE(mesh->meshing[0].notes.empty());
  ASSERT_EQ(mesh->table.diagnostics.size(), 1);
  EXPECT_EQ(mesh->table.diagnostics[0].code, "mesh.bead.fallback");
  EXPECT_EQ(mesh->table.diagnostics[0].face, 1);
  EXPECT_EQ(mesh->table.diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(verify_shell_mesh(mesh->mesh), std::vector<std::string>{});
  EXPECT_EQ(free_edges_inside(mesh->mesh, 120, 60), 0);
}

TEST(PanelMesher, FaceThatCouldNotBeLaidFlatIsLeftOut) {
  const Panel panel = plate_of_every_kind();
  StudiedPanel study = studied(panel, 3);
  study.studies[3].reset();  // the island in the ring
  const auto mesh = mesh_studied_panel(panel, study, {});
  ASSERT_TRUE(mesh);
  EXPECT_EQ(verify_shell_mesh(mesh->mesh), std::vector<std::string>{});
  for (const ShellElement& element : mesh->mesh.elements) EXPECT_NE(element.face, panel.faces[3].number);
  EXPECT_GT(free_edges_inside(mesh->mesh, 240, 150), 0);
}

TEST(PanelMesher, NothingToMeshIsAFailure) {
  const Panel panel = plate_of_every_kind();
  StudiedPanel study = studied(panel, 0);
  for (auto& face : study.studies) face.reset();
  const auto mesh = mesh_studied_panel(panel, study, {});
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, "mesh.nothing");
}

TEST(PanelMesher, CancelledIsAFailure) {
  const Panel panel = plate_of_every_kind();
  const std::atomic<bool> cancelled = true;
  Context context;
  context.cancelled = &cancelled;
  const auto mesh = mesh_studied_panel(panel, studied(panel, 3), {}, context);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, "mesh.cancelled");
}

TEST(PanelMesher, SizesFollowTheOptions) {
  BeadPlate plate(160, 100);
  plate.add(examples::straight_bead(70, 30), 6);
  const Panel panel = plate.take();
  const StudiedPanel study = studied(panel, 1);
  const auto fine = mesh_studied_panel(panel, study, {4, 2, 1}),
             coarse = mesh_studied_panel(panel, study, {9, 4.5, 1});
  ASSERT_TRUE(fine && coarse);
  EXPECT_EQ(fine->quality.edges_below_min + coarse->quality.edges_below_min, 0);
  EXPECT_GE(fine->quality.edge_min, 2);
  EXPECT_GE(coarse->quality.edge_min, 4.5);
  EXPECT_GT(fine->mesh.elements.size(), 3 * coarse->mesh.elements.size());
}

}  // namespace
}  // namespace beadmesh
