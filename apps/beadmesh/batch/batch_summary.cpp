#include "batch/batch_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace beadmesh::app {
namespace {

using Value = nlohmann::ordered_json;

std::string text_of(const Value& value) {
  return value.dump(-1, ' ', false, Value::error_handler_t::replace);
}

/// Quotes where a reader of CSV needs them.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

Value beads_of(const PanelFigures& figures) {
  Value value;
  visit_beads(figures, [&](const char* name, int figure) { value[name] = figure; });
  return value;
}

Value mesh_of(const PanelFigures& figures) {
  Value value;
  visit_mesh(figures, [&](const char* name, auto figure) { value[name] = figure; });
  return value;
}

Value row_of(const PanelState& s) {
  Value files = Value::array();
  for (const std::string& file : s.files) files.push_back("panels/" + s.name + "/" + file);
  Value row{{"name", s.name},
            {"input", s.input},
            {"outcome", name_of(s.outcome)},
            {"exit_status", s.exit_status},
            {"signal", s.signal},
            {"message", s.message}};
  if (has_results(s.outcome)) {
    row["beads"] = beads_of(s.figures), row["mesh"] = mesh_of(s.figures);
    row["warnings"] = s.figures.warnings, row["errors"] = s.figures.errors;
  }
  row["files"] = std::move(files);
  return row;
}

std::string figure_names() {
  const PanelFigures nothing;
  std::string text = "beads";
  visit_all(nothing, [&](const char* name, auto) { text.append(1, ',').append(name); });
  return text;
}

std::string figure_field(int figure) {
  return std::to_string(figure);
}

std::string figure_field(double figure) {
  return fmt::format("{:.4f}", figure);
}

std::string figure_fields(const PanelFigures& figures) {
  std::string text = std::to_string(figures.beads());
  visit_all(figures, [&](const char*, auto figure) { text.append(1, ',').append(figure_field(figure)); });
  return text;
}

}  // namespace

BatchTotals totals_of(const std::vector<PanelState>& states) {
  BatchTotals t;
  for (const PanelState& s : states) {
    ++t.panels;
    ++(s.outcome == Outcome::done         ? t.done
       : s.outcome == Outcome::fell_short ? t.fell_short
       : s.outcome == Outcome::not_run    ? t.not_run
                                          : t.failed);
    if (!has_results(s.outcome)) continue;
    const PanelFigures& f = s.figures;
    PanelFigures& sum = t.figures;
    sum.I += f.I, sum.generic += f.generic, sum.annular += f.annular, sum.fallbacks += f.fallbacks;
    sum.nodes += f.nodes, sum.quads += f.quads, sum.trias += f.trias;
    sum.inverted += f.inverted, sum.edges_below_min += f.edges_below_min;
    sum.warnings += f.warnings, sum.errors += f.errors;
  }
  return t;
}

std::string batch_json(const std::vector<PanelState>& states) {
  const BatchTotals t = totals_of(states);
  const Value totals{{"panels", t.panels},
                     {"done", t.done},
                     {"fell_short", t.fell_short},
                     {"failed", t.failed},
                     {"not_run", t.not_run},
                     {"beads", beads_of(t.figures)},
                     {"nodes", t.figures.nodes},
                     {"quads", t.figures.quads},
                     {"trias", t.figures.trias},
                     {"inverted", t.figures.inverted},
                     {"edges_below_min", t.figures.edges_below_min}};
  std::string text = fmt::format(
      "{{\n  \"schema\": \"beadmesh.batch/1\",\n  \"totals\": {},\n  \"panels\": [", text_of(totals));
  for (size_t i = 0; i < states.size(); ++i)
    text += fmt::format("{}\n    {}", i ? "," : "", text_of(row_of(states[i])));
  return text + "\n  ]\n}\n";
}

std::string batch_csv(const std::vector<PanelState>& states) {
  const std::string names = figure_names(), none(std::count(names.begin(), names.end(), ','), ',');
  std::string text = "name,outcome,exit_status,signal," + names + ",message,input\n";
  for (const PanelState& s : states) {
    const std::string figures = has_results(s.outcome) ? figure_fields(s.figures) : none;
    text += fmt::format("{},{},{},{},{},{},{}\n", csv_field(s.name), name_of(s.outcome), s.exit_status,
                        s.signal, figures, csv_field(s.message), csv_field(s.input));
  }
  return text;
}

std::string times_csv(const std::vector<PanelState>& states) {
  std::string text = "name,outcome,attempts,seconds,cpu_seconds,peak_mb\n";
  for (const PanelState& s : states)
    text += fmt::format("{},{},{},{:.3f},{:.3f},{:.1f}\n", csv_field(s.name), name_of(s.outcome),
                        s.cost.attempts, s.cost.seconds, s.cost.cpu_seconds, s.cost.peak_mb);
  return text;
}

std::string batch_text(const std::vector<PanelState>& states) {
  const BatchTotals t = totals_of(states);
  std::string text;
  for (const PanelState& s : states)
    if (s.outcome != Outcome::done)
      text += fmt::format("  {:<24} {:<13} {}\n", s.name, name_of(s.outcome), s.message);
  text +=
      fmt::format("{} panels: {} done, {} fell short, {} failed", t.panels, t.done, t.fell_short, t.failed);
  if (t.not_run) text += fmt::format(", {} not run", t.not_run);
  const PanelFigures& f = t.figures;
  return text + fmt::format("\n{} beads ({} I, {} generic, {} annular), {} nodes, {} quads, {} triangles\n",
                            f.beads(), f.I, f.generic, f.annular, f.nodes, f.quads, f.trias);
}

}  // namespace beadmesh::app
