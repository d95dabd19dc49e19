#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <ostream>

#include "beadmesh/mesh/quality_criteria.h"
#include "beadmesh/report/panel_html.h"
#include "beadmesh/report/panel_svg.h"
#include "beadmesh/write/bead_csv.h"
#include "beadmesh/write/bead_json.h"
#include "beadmesh/write/deck.h"
#include "checked_design.h"
#include "crash_guard.h"
#include "criteria_file.h"
#include "grouping.h"
#include "outputs.h"
#include "progress.h"
#include "settings_text.h"
#include "summary.h"
#include "verbs.h"

namespace beadmesh::app {
namespace {

using Clock = std::chrono::steady_clock;

/// A slip in the size must not fill the memory.
Result<void> check_element_count(const Panel& panel, const MeshSizes& sizes) {
  constexpr double most = 5e6;
  double area = 0;
  for (const PanelFace& face : panel.faces)
    for (const Triangle& t : face.facets.triangles) {
      const Vec3 a = face.facets.points[t[0]], b = face.facets.points[t[1]], c = face.facets.points[t[2]];
      area += norm(cross(b - a, c - a)) / 2;
    }
  const double count = area / (sizes.size * sizes.size);
  if (count <= most) return {};
  return fail("usage.size",
              fmt::format("a size of {} mm would give about {:.1g} elements", sizes.size, count),
              fmt::format("use at least {:.2g} mm", std::sqrt(area / most)), panel.input);
}

std::string report_of(const Panel& panel, const PanelMesh& mesh, const Options& options,
                      const DesignCheck& design) {
  const MeshSizes& sizes = options.settings.sizes;
  ReportFacts facts = facts_of_run(panel, sizes.size, sizes.min_edge, sizes.thickness);
  facts.criteria = mesh.judged.criteria;  // those of --criteria, where it was given
  facts.designs = design.beads, facts.design_limits = design.limits;
  return panel_html(panel, mesh, facts);
}

bool is_picture(const std::string& name) {
  const std::string ending = std::filesystem::path(name).extension().string();
  return ending.size() == 4 && std::tolower(static_cast<unsigned char>(ending[1])) == 's';
}

Outputs outputs_of(const Options& options, const Panel& panel, const PanelMesh& mesh,
                   const DesignCheck& design) {
  const OutputNames& names = options.outputs;
  Outputs outputs;
  DeckOptions deck = options.settings.deck;
  deck.remarks = settings_lines(options.settings);
  outputs.add(names.deck, [&, deck](std::ostream& out) { write_deck(mesh.mesh, names.deck, out, deck); });
  outputs.add(names.json, [&](std::ostream& out) { out << bead_json(panel, mesh, design.beads); });
  outputs.add(names.csv, [&](std::ostream& out) {
    out << (options.design_check ? bead_csv(panel, mesh.table, design.beads) : bead_csv(panel, mesh.table));
  });
  outputs.add(names.report, [&](std::ostream& out) {
    out << (is_picture(names.report) ? panel_svg(mesh) : report_of(panel, mesh, options, design));
  });
  return outputs;
}

void print_summary(const Panel& panel, const PanelMesh& mesh, const DesignCheck& design,
                   const Outputs& outputs, Clock::time_point start) {
  std::string files;
  for (const std::string& name : outputs.names()) files += (files.empty() ? "" : ", ") + name;
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  fmt::print("{}{}{}{}wrote {} in {:.1f} s\n", bead_summary(panel, mesh.table, mesh.meshing),
             quality_summary(mesh.quality), failing_summary(mesh.judged), design_summary(design.beads), files,
             seconds);
}

}  // namespace

Result<int> run_mesh(const Options& options) {
  const auto start = Clock::now();
  MeshSizes sizes = options.settings.sizes;
  if (!options.criteria.empty()) {
    auto limits = read_criteria(options.criteria);
    if (!limits) return tl::make_unexpected(limits.error());
    sizes.criteria = *limits;
  }
  ProgressBar bar;
  const Context context = bar.context(options.settings.jobs);
  auto panel = read_guarded(options.input, options.settings.read, context);
  if (!panel) return tl::make_unexpected(panel.error());
  Grouping grouping(options.outputs.debug_svg, *panel);
  panel = compose_faces(std::move(*panel), options.settings.beads, context, options.settings.kept_edges,
                        grouping.decisions());
  if (auto good = check_element_count(*panel, sizes); !good) return tl::make_unexpected(good.error());
  auto mesh = mesh_panel(*panel, sizes, options.settings.beads, context);
  if (!mesh) return tl::make_unexpected(mesh.error());
  const DesignCheck design = checked_design(options, *panel, mesh->table, context);
  context.report("write", 0);

  mesh->mesh.title =
      fmt::format("{}, size {:g} mm, minimum edge {:g} mm", panel->input, sizes.size, sizes.min_edge);
  std::vector<Diagnostic> short_of = shortfalls(*mesh, sizes.min_edge);
  // Limits that were given are wanted; the usual ones are only reported.
  if (sizes.criteria)
    for (Diagnostic& one : shortfalls(mesh->judged)) short_of.push_back(std::move(one));
  mesh->table.diagnostics.insert(mesh->table.diagnostics.end(), short_of.begin(), short_of.end());
  if (auto good = check_deck_mesh(mesh->mesh, options.settings.deck); !good)
    return tl::make_unexpected(good.error());
  Outputs outputs = outputs_of(options, *panel, *mesh, design);
  grouping.add_to(outputs, *panel, mesh->table);
  if (auto put = outputs.put(); !put) return tl::make_unexpected(put.error());

  bar.clear();
  if (options.timings) fmt::print(stderr, "{}", timing_table(bar.stages()));
  if (!outputs.uses_stdout()) print_summary(*panel, *mesh, design, outputs, start);
  const bool any_error = print_diagnostics(mesh->table.diagnostics);
  return any_error || !short_of.empty() || design.past_limits > 0 ? fell_short : done;
}

}  // namespace beadmesh::app
