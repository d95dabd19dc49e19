#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <ostream>

#include "beadmesh/mesh/criteria_text.h"
#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/shell_repair.h"
#include "beadmesh/read/shell_deck_file.h"
#include "beadmesh/write/nastran_nodes.h"
#include "beadmesh/write/quality_json.h"
#include "criteria_file.h"
#include "outputs.h"
#include "summary.h"
#include "verbs.h"

namespace beadmesh::app {
namespace {

/// The limits asked for; none where none were.
Result<std::optional<QualityCriteria>> criteria_asked_for(const Options& options) {
  if (!options.criteria.empty()) {
    auto read = read_criteria(options.criteria);
    if (!read) return tl::make_unexpected(read.error());
    return std::optional(std::move(*read));
  }
  if (!options.preset.empty()) return criteria_of_preset(options.preset);
  if (!options.outputs.criteria.empty() || !options.outputs.repaired.empty())
    return fail("usage.criteria",
                options.outputs.repaired.empty() ? "no limits to save" : "no limits to repair by",
                "add --preset or --criteria");
  return std::optional<QualityCriteria>();
}

std::vector<ElementGroup> properties_of(const ShellDeck& deck) {
  std::map<Index, ElementGroup> parts;
  for (Index e = 0; e < static_cast<Index>(deck.elements.size()); ++e) {
    ElementGroup& part = parts[deck.properties[e]];
    part.name = fmt::format("property {}", deck.properties[e]);
    part.elements.push_back(e);
  }
  std::vector<ElementGroup> out;
  for (auto& [property, part] : parts) out.push_back(std::move(part));
  return out;
}

/// What follows the words in the name of a set; none where it does not begin with them.
std::optional<std::string> after(const std::string& words, const DeckSet& set) {
  if (set.name.rfind(words, 0) != 0) return std::nullopt;
  return set.name.substr(words.size());
}

/// Positions of the members that are in the deck.
std::vector<Index> positions(const std::vector<Index>& members, const std::map<Index, Index>& position) {
  std::vector<Index> out;
  for (const Index id : members)
    if (const auto at = position.find(id); at != position.end()) out.push_back(at->second);
  return out;
}

std::map<Index, Index> position_of(const std::vector<Index>& ids) {
  std::map<Index, Index> position;
  for (Index i = 0; i < static_cast<Index>(ids.size()); ++i) position.emplace(ids[i], i);
  return position;
}

/// Sets with the names that `mesh` gives to the elements of beads.
std::vector<ElementGroup> beads_of(const ShellDeck& deck) {
  std::vector<ElementGroup> beads;
  const auto position = position_of(deck.element_ids);
  for (const DeckSet& set : deck.sets)
    if (const auto bead = after("elements of ", set))
      beads.push_back({*bead, positions(set.members, position)});
  return beads;
}

JudgedMesh judged_mesh(const ShellDeck& deck, const QualityCriteria& criteria) {
  return judge(deck.points, deck.elements, criteria, properties_of(deck), beads_of(deck));
}

double mean_side(const ShellDeck& deck) {
  double sum = 0;
  for (const MeshElement& e : deck.elements) {
    const auto [shortest, longest] = side_lengths(deck.points, e);
    sum += (shortest + longest) / 2;
  }
  return sum / static_cast<double>(deck.elements.size());
}

ShellRepairOptions repair_options(const ShellDeck& deck, const Options& options,
                                  const QualityCriteria& criteria) {
  ShellRepairOptions repair;
  repair.size = options.has_size ? options.settings.sizes.size : mean_side(deck);
  const Criterion& least = criteria[QualityMeasure::min_length];
  repair.min_edge =
      options.has_min_edge ? options.settings.sizes.min_edge : (least.on ? least.fail : repair.size / 2);
  repair.groups = deck.properties;
  Index next = *std::max_element(deck.properties.begin(), deck.properties.end());
  for (const ElementGroup& bead : beads_of(deck)) {
    ++next;
    for (const Index e : bead.elements) repair.groups[e] = next;
  }
  const auto position = position_of(deck.node_ids);
  for (const DeckSet& set : deck.sets)
    if (after("crest nodes of ", set))
      for (const Index n : positions(set.members, position)) repair.kept.push_back(n);
  return repair;
}

/// The deck is changed; the ids of the nodes that moved, with their places.
std::map<Index, Vec3> repair(ShellDeck& deck, const Options& options, const QualityCriteria& criteria,
                             RepairFacts& facts) {
  const ShellRepairReport report =
      repair_by_moving(deck.points, deck.elements, criteria, repair_options(deck, options, criteria));
  std::map<Index, Vec3> places;
  for (const Index n : report.moved) places[deck.node_ids[n]] = deck.points[n];
  facts.zones = report.zones;
  facts.moved_nodes = static_cast<int>(report.moved.size());
  return places;
}

/// A repair puts new places into the cards of a Nastran deck and leaves all other lines as they are.
Result<void> check_repair(const Options& options) {
  if (options.outputs.repaired.empty()) return {};
  std::string ending = options.input.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == ".bdf" || ending == ".nas" || ending == ".dat") return {};
  return fail("usage.repair", "only Nastran decks (.bdf .nas .dat) are repaired",
              "mesh the panel to such a deck, or check without --repair", options.input.filename().string());
}

Result<std::string> text_of_file(const std::filesystem::path& name) {
  std::ifstream in(name, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) return fail("read.unreadable", "the file cannot be read", "", name.string());
  return text;
}

}  // namespace

Result<int> run_check(const Options& options) {
  const auto criteria = criteria_asked_for(options);
  if (!criteria) return tl::make_unexpected(criteria.error());
  if (const auto can = check_repair(options); !can) return tl::make_unexpected(can.error());
  auto deck = read_shell_deck(options.input);
  if (!deck) return tl::make_unexpected(deck.error());
  Outputs outputs;
  JudgedMesh judged = *criteria ? judged_mesh(*deck, **criteria) : JudgedMesh{};
  std::optional<RepairFacts> facts;
  if (!options.outputs.repaired.empty()) {
    auto text = text_of_file(options.input);
    if (!text) return tl::make_unexpected(text.error());
    facts = RepairFacts{0, 0, judged.parts.front().findings};
    const auto places = repair(*deck, options, **criteria, *facts);
    outputs.add(options.outputs.repaired,
                [text = with_moved_nodes(*text, places)](std::ostream& out) { out << text; });
    judged = judged_mesh(*deck, **criteria);
  }
  const double size = options.has_size ? options.settings.sizes.size : 0;
  const double min_edge = options.has_min_edge ? options.settings.sizes.min_edge : 0;
  const QualitySummary quality = summarise(deck->points, deck->elements, min_edge);

  const std::string name = options.input.filename().string();
  outputs.add(options.outputs.json, [&](std::ostream& out) {
    out << quality_json(name, quality, size, min_edge, judged, deck->element_ids, facts);
  });
  outputs.add(options.outputs.criteria, [&](std::ostream& out) { out << criteria_text(judged.criteria); });
  if (auto put = outputs.put(); !put) return tl::make_unexpected(put.error());
  if (!outputs.uses_stdout())
    fmt::print("{}\n{}{}{}", name, quality_summary(quality), criteria_summary(judged),
               facts ? repair_summary(*facts, judged) : "");
  std::vector<Diagnostic> short_of = shortfalls(quality, min_edge);
  for (Diagnostic& one : shortfalls(judged)) short_of.push_back(std::move(one));
  print_diagnostics(short_of);
  return short_of.empty() ? done : fell_short;
}

}  // namespace beadmesh::app
