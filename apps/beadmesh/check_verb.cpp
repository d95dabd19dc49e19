#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <ostream>

#include "beadmesh/mesh/criteria_text.h"
#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/read/shell_deck_file.h"
#include "beadmesh/write/quality_json.h"
#include "outputs.h"
#include "summary.h"
#include "verbs.h"

namespace beadmesh::app {
namespace {

constexpr std::uintmax_t longest_criteria_file = 1 << 20;

Result<QualityCriteria> read_criteria(const std::string& name) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error))
    return fail("criteria.not_found", "there is no such criteria file", "", name);
  if (std::filesystem::file_size(name, error) > longest_criteria_file)
    return fail("criteria.unreadable", "far too long for a criteria file", "", name);
  std::ifstream in(name, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) return fail("criteria.unreadable", "the criteria file cannot be read", "", name);
  auto parsed = parse_criteria(text);
  if (!parsed) return fail(parsed.error().code, parsed.error().message, parsed.error().hint, name);
  std::vector<Diagnostic> notes;
  for (const std::string& row : parsed->ignored)
    notes.push_back(
        {"criteria.ignored", Severity::note, no_index, name, "no such criterion here: " + row, ""});
  print_diagnostics(notes);
  return std::move(parsed->criteria);
}

/// The limits asked for; none where none were.
Result<std::optional<QualityCriteria>> criteria_asked_for(const Options& options) {
  if (!options.criteria.empty()) {
    auto read = read_criteria(options.criteria);
    if (!read) return tl::make_unexpected(read.error());
    return std::optional(std::move(*read));
  }
  if (!options.preset.empty()) return criteria_of_preset(options.preset);
  if (!options.outputs.criteria.empty())
    return fail("usage.criteria", "no limits to save", "add --preset or --criteria");
  return std::optional<QualityCriteria>();
}

JudgedMesh judged_mesh(const ShellDeck& deck, const QualityCriteria& criteria) {
  JudgedMesh out{criteria, {{"all", judge(deck.points, deck.elements, criteria)}}};
  std::map<Index, std::vector<Index>> parts;
  for (Index e = 0; e < static_cast<Index>(deck.elements.size()); ++e) parts[deck.properties[e]].push_back(e);
  for (const auto& [property, elements] : parts)
    out.parts.push_back(
        {fmt::format("property {}", property), judge(deck.points, deck.elements, criteria, elements)});
  return out;
}

}  // namespace

Result<int> run_check(const Options& options) {
  const auto criteria = criteria_asked_for(options);
  if (!criteria) return tl::make_unexpected(criteria.error());
  const auto deck = read_shell_deck(options.input);
  if (!deck) return tl::make_unexpected(deck.error());
  const double size = options.has_size ? options.settings.sizes.size : 0;
  const double min_edge = options.has_min_edge ? options.settings.sizes.min_edge : 0;
  const QualitySummary quality = summarise(deck->points, deck->elements, min_edge);
  const JudgedMesh judged = *criteria ? judged_mesh(*deck, **criteria) : JudgedMesh{};

  const std::string name = options.input.filename().string();
  Outputs outputs;
  outputs.add(options.outputs.json,
              [&](std::ostream& out) { out << quality_json(name, quality, size, min_edge, judged); });
  outputs.add(options.outputs.criteria, [&](std::ostream& out) { out << criteria_text(judged.criteria); });
  if (auto put = outputs.put(); !put) return tl::make_unexpected(put.error());
  if (!outputs.uses_stdout())
    fmt::print("{}\n{}{}", name, quality_summary(quality), criteria_summary(judged));
  std::vector<Diagnostic> short_of = shortfalls(quality, min_edge);
  for (Diagnostic& one : shortfalls(judged)) short_of.push_back(std::move(one));
  print_diagnostics(short_of);
  return short_of.empty() ? done : fell_short;
}

}  // namespace beadmesh::app
