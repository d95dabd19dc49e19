#include <fmt/format.h>

#include <cstdio>
#include <ostream>

#include "beadmesh/report/panel_html.h"
#include "beadmesh/write/bead_csv.h"
#include "beadmesh/write/bead_json.h"
#include "checked_design.h"
#include "crash_guard.h"
#include "grouping.h"
#include "outputs.h"
#include "progress.h"
#include "summary.h"
#include "verbs.h"

namespace beadmesh::app {

namespace {

/// The report of the beads alone: on the surface, without a mesh.
std::string report_of(const Panel& panel, const BeadTable& table, const DesignCheck& design) {
  PanelMesh recognised;
  recognised.table = table;
  ReportFacts facts = facts_of_recognition(panel, table);
  facts.designs = design.beads, facts.design_limits = design.limits;
  return panel_html(panel, recognised, facts);
}

}  // namespace

Result<int> run_beads(const Options& options) {
  ProgressBar bar;
  const Context context = bar.context(options.settings.jobs);
  auto panel = read_guarded(options.input, options.settings.read, context);
  if (!panel) return tl::make_unexpected(panel.error());
  Grouping grouping(options.outputs.debug_svg, *panel);
  panel = compose_faces(std::move(*panel), options.settings.beads, context, {}, grouping.decisions());
  BeadTable table = recognise_beads(*panel, options.settings.beads, context);
  const DesignCheck design = checked_design(options, *panel, table, context);
  context.report("write", 0);

  Outputs outputs;
  outputs.add(options.outputs.json, [&](std::ostream& out) {
    out << (options.design_check ? bead_json(*panel, table, design.beads) : bead_json(*panel, table));
  });
  outputs.add(options.outputs.csv, [&](std::ostream& out) {
    out << (options.design_check ? bead_csv(*panel, table, design.beads) : bead_csv(*panel, table));
  });
  outputs.add(options.outputs.report, [&](std::ostream& out) { out << report_of(*panel, table, design); });
  grouping.add_to(outputs, *panel, table);
  if (auto put = outputs.put(); !put) return tl::make_unexpected(put.error());
  bar.clear();
  if (options.timings) fmt::print(stderr, "{}", timing_table(bar.stages()));
  if (!outputs.uses_stdout()) fmt::print("{}{}", bead_summary(*panel, table), design_summary(design.beads));
  return print_diagnostics(table.diagnostics) || design.past_limits > 0 ? fell_short : done;
}

}  // namespace beadmesh::app
