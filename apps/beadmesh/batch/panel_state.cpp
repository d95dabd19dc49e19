#include "batch/panel_state.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "batch/sha256.h"
#include "beadmesh/core/version.h"

namespace beadmesh::app {
namespace {

using Value = nlohmann::ordered_json;

constexpr const char* schema = "beadmesh.batch.panel/1";

constexpr std::array<std::pair<Outcome, std::string_view>, 9> names{
    {{Outcome::done, "done"},
     {Outcome::fell_short, "fell short"},
     {Outcome::refused, "refused"},
     {Outcome::not_written, "not written"},
     {Outcome::crashed, "crashed"},
     {Outcome::killed, "killed"},
     {Outcome::timed_out, "timed out"},
     {Outcome::out_of_memory, "out of memory"},
     {Outcome::not_run, "not run"}}};

Outcome outcome_of(const std::string& name) {
  for (const auto& [outcome, word] : names)
    if (word == name) return outcome;
  return Outcome::not_run;
}

double number_of(const Value& value) {
  return value.is_number() ? value.get<double>() : 0;
}

std::optional<Value> parsed_file(const std::filesystem::path& path, const char* wanted) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::ifstream in(path, std::ios::binary);
  Value value = Value::parse(in, nullptr, false);
  if (!value.is_object() || value.value("schema", "") != wanted) return {};
  return value;
}

Value value_of(const PanelFigures& figures) {
  Value value;
  visit_all(figures, [&](const char* name, auto figure) { value[name] = figure; });
  return value;
}

PanelFigures figures_of_value(const Value& value) {
  PanelFigures figures;
  visit_all(figures, [&](const char* name, auto& figure) { value.at(name).get_to(figure); });
  return figures;
}

PanelState state_of_value(const Value& v) {
  PanelState state;
  state.name = v.at("name"), state.input = v.at("input");
  state.fingerprint = {v.at("input_sha256"), v.at("options_sha256"), v.at("version")};
  state.outcome = outcome_of(v.at("outcome"));
  state.exit_status = v.at("exit_status"), state.signal = v.at("signal");
  state.message = v.at("message");
  state.figures = figures_of_value(v.at("figures"));
  const Value& cost = v.at("cost");
  state.cost = {cost.at("attempts"), cost.at("seconds"), cost.at("cpu_seconds"), cost.at("peak_mb")};
  state.files = v.at("files").get<std::vector<std::string>>();
  return state;
}

}  // namespace

std::string_view name_of(Outcome outcome) {
  return names[static_cast<size_t>(outcome)].second;
}

bool has_results(Outcome outcome) {
  return outcome == Outcome::done || outcome == Outcome::fell_short;
}

Fingerprint fingerprint_of(const BatchPanel& panel, const std::string& kinds) {
  // Every part with its length, so that no two lists read the same.
  std::string text = fmt::format("{}\n", kinds);
  for (const auto* list : {&panel.settings, &panel.options})
    for (const std::string& one : *list)
      text += fmt::format("{} {} {}\n", list == &panel.settings ? "settings" : "option", one.size(), one);
  return {sha256_of_file(panel.input).value_or(""), sha256(text), std::string(version())};
}

std::optional<PanelFigures> figures_of(const std::filesystem::path& bead_json) {
  const auto table = parsed_file(bead_json, "beadmesh.beads/1");
  if (!table) return {};
  PanelFigures f;
  try {
    for (const Value& bead : table->at("beads")) {
      const std::string kind = bead.at("kind");
      ++(kind == "I" ? f.I : kind == "annular" ? f.annular : f.generic);
      f.fallbacks += bead.at("mesh").at("method") == "fallback";
    }
    const Value& mesh = table->at("mesh");
    const Value& quality = mesh.at("quality");
    f.nodes = mesh.at("nodes"), f.quads = mesh.at("quads"), f.trias = mesh.at("trias");
    f.scaled_jacobian_min = number_of(quality.at("scaled_jacobian_min"));
    f.scaled_jacobian_mean = number_of(quality.at("scaled_jacobian_mean"));
    f.edge_min = number_of(quality.at("edge_min"));
    f.inverted = quality.at("inverted"), f.edges_below_min = quality.at("edges_below_min");
    for (const Value& diagnostic : table->at("diagnostics")) {
      f.warnings += diagnostic.at("severity") == "warning";
      f.errors += diagnostic.at("severity") == "error";
    }
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return f;
}

std::string state_text(const PanelState& s) {
  const Value value{{"schema", schema},
                    {"name", s.name},
                    {"input", s.input},
                    {"input_sha256", s.fingerprint.input},
                    {"options_sha256", s.fingerprint.options},
                    {"version", s.fingerprint.version},
                    {"outcome", name_of(s.outcome)},
                    {"exit_status", s.exit_status},
                    {"signal", s.signal},
                    {"message", s.message},
                    {"figures", value_of(s.figures)},
                    {"cost",
                     {{"attempts", s.cost.attempts},
                      {"seconds", s.cost.seconds},
                      {"cpu_seconds", s.cost.cpu_seconds},
                      {"peak_mb", s.cost.peak_mb}}},
                    {"files", s.files}};
  return value.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}

std::optional<PanelState> read_state(const std::filesystem::path& path) {
  const auto value = parsed_file(path, schema);
  if (!value) return {};
  try {
    return state_of_value(*value);
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

}  // namespace beadmesh::app
