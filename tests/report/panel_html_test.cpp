#include "beadmesh/report/panel_html.h"

#include <gtest/gtest.h>

#include <string>

#include "report/synthetic_panel.h"
#include "report/well_formed.h"
#include "write/bead_plate.h"

namespace beadmesh {
namespace {

using test::plate;
using test::plate_panel;

ReportFacts facts(const std::string& title) {
  return {title, {{"size", "5 mm"}}, 2.5, criteria_of_sizes(5, 2.5)};
}

/// The page without style, script and data.
std::string markup(std::string html) {
  for (const auto& [from, to] : {std::pair{"<style>", "</style>"},
                                 {"<script", "</script>"},
                                 {"<script", "</script>"},
                                 {"<script", "</script>"}}) {
    const size_t begin = html.find(from), end = html.find(to, begin);
    if (begin != std::string::npos && end != std::string::npos) html.erase(begin, end - begin);
  }
  return html;
}

TEST(PanelHtml, HoldsTablesAndSettings) {
  PanelMesh mesh = plate();
  mesh.table.diagnostics = {{"read.face", Severity::warning, 3, "", "left out <now>", "repair it"}};
  mesh.meshing[0] = {"fallback", 48, {"end cap too short"}};
  const std::string html = panel_html(plate_panel(), mesh, facts("plate.step"));
  for (const char* part : {"<title>plate.step</title>", "size <b>5 mm</b>", "aspect ratio 1.1 &lt; 2.0",
                           "end cap too short", "left out &lt;now&gt;", "class=\"fallback\"",
                           "<dt>nodes</dt><dd>231</dd>", "id=\"flat-picture\"", "id=\"scene\""})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST(PanelHtml, RowsSayWhatTheyAreAbout) {
  PanelMesh mesh = plate();
  mesh.table.diagnostics = {{"mesh.bead.fallback", Severity::warning, 2, "bead 1", "no", ""}};
  const std::string html = panel_html(plate_panel(), mesh, facts("plate.step"));
  EXPECT_NE(html.find("<tr data-bead=\"1\"><th scope=\"row\""), std::string::npos);
  EXPECT_NE(html.find("<tr data-bead=\"1\" data-face=\"2\"><td class=\"warning\""), std::string::npos);
  EXPECT_NE(html.find("<tr data-face=\"1\"><th scope=\"row\""), std::string::npos);
  EXPECT_NE(html.find("<tr data-element="), std::string::npos);
}

TEST(PanelHtml, QualityIsJudgedByTheLimits) {
  ReportFacts strict = facts("plate");
  (*strict.criteria)[QualityMeasure::min_length] = {true, 1, 9, 8, 7, 5.9, 0};
  const std::string html = panel_html(plate_panel(), plate(), strict);
  EXPECT_NE(html.find("≥ 5.9"), std::string::npos);
  EXPECT_NE(html.find("✗ fails"), std::string::npos);
  EXPECT_EQ(test::count(html, "no such element"), 2) << "angles of triangles";
  EXPECT_NE(html.find("200 of 200 elements fail a criterion (100.00 %)"), std::string::npos);
}

TEST(PanelHtml, DesignIsATableOfItsOwnWithLimitsInItsHeads) {
  ReportFacts judged = facts("plate");
  BeadDesign design{1, {31, 6.0, 0.333, radians(61.5), 6.7, {}}, {24.1, 3, 15.0, {}}, {}};
  judged.designs = {design};
  judged.design_limits.max_wall_angle = radians(60);
  judge_design(judged.designs, judged.design_limits);
  const std::string html = panel_html(plate_panel(), plate(), judged);
  const std::string section = html.substr(html.find("<section id=\"design\""));
  for (const char* part :
       {"wall angle, ° (≤ 60)", "<td class=\"number fails\">✗ 61.5</td>", "<td class=\"number\">0.333</td>",
        "<td class=\"number\">–</td>", "<tr data-bead=\"1\">"})
    EXPECT_NE(section.find(part), std::string::npos) << part;
  EXPECT_EQ(panel_html(plate_panel(), plate(), facts("plate")).find("<section id=\"design\""),
            std::string::npos);
}

TEST(PanelHtml, AsksForNothingFromOutside) {
  const std::string html = markup(panel_html(plate_panel(), plate(), facts("plate")));
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_EQ(html.find(" src="), std::string::npos);
  EXPECT_EQ(html.find("<link"), std::string::npos);
}

TEST(PanelHtml, TextOfTheInputCannotLeaveItsElement) {
  PanelMesh mesh = plate();
  mesh.table.beads[0].shape = "</script><b>";
  const std::string html = panel_html(plate_panel(), mesh, facts("</script><b>"));
  // Script elements of the page: flat picture, scene, viewer.
  EXPECT_EQ(test::count(html, "</script>"), 3);
  EXPECT_EQ(html.find("</script><b>"), std::string::npos);
}

TEST(PanelHtml, WithoutMeshShowsWhatWasRecognised) {
  test::SyntheticPanel synthetic = test::synthetic_panel(60);
  synthetic.mesh.mesh = {};
  synthetic.mesh.meshing.clear();
  synthetic.mesh.quality = {};
  const std::string html = panel_html(synthetic.panel, synthetic.mesh, facts("beads only"));
  EXPECT_NE(html.find("<tr data-bead=\"3\">"), std::string::npos);
  EXPECT_EQ(html.find("meshed by"), std::string::npos);
  EXPECT_EQ(html.find("<section id=\"quality\""), std::string::npos);
}

TEST(PanelHtml, IsTheSameEveryTime) {
  const auto page = [] {
    const test::SyntheticPanel synthetic = test::synthetic_panel(60);
    return panel_html(synthetic.panel, synthetic.mesh, facts("same"));
  };
  EXPECT_EQ(page(), page());
}

TEST(PanelHtml, TakesFewBytesAnElement) {
  const auto size = [](int along) {
    const test::SyntheticPanel synthetic = test::synthetic_panel(along);
    return std::pair{double(panel_html(synthetic.panel, synthetic.mesh, facts("size")).size()),
                     double(synthetic.mesh.mesh.elements.size())};
  };
  const auto [small, few] = size(100);
  const auto [large, many] = size(300);
  EXPECT_LT((large - small) / (many - few), 50);
}

TEST(PanelHtml, SaysNoneWhereThereIsNothing) {
  EXPECT_EQ(test::count(panel_html(Panel{}, PanelMesh{}, {"empty", {}}), "None."), 3);
}

}  // namespace
}  // namespace beadmesh
