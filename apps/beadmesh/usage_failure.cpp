#include "usage_failure.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace beadmesh::app {
namespace {

using Words = std::vector<std::string>;

/// Letters to change, add or leave out (Levenshtein).
size_t distance_between(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t(0));
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i + 1;
    for (size_t k = 0; k < b.size(); ++k) {
      const size_t kept = diagonal + (a[i] != b[k]);
      diagonal = row[k + 1];
      row[k + 1] = std::min({kept, row[k] + 1, row[k + 1] + 1});
    }
  }
  return row.back();
}

/// "did you mean --size? "; empty where nothing is near.
std::string suggestion(const std::string& word, const Words& known) {
  constexpr size_t near = 2;
  const auto best = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return distance_between(word, a) < distance_between(word, b);
  });
  if (best == known.end() || distance_between(word, *best) > near) return "";
  return fmt::format("did you mean {}? ", *best);
}

Words verbs_of(const CLI::App& app) {
  Words names;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!verb->get_group().empty()) names.push_back(verb->get_name());
  return names;
}

Words options_of(const CLI::App& verb) {
  Words names;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

Failure about(const std::string& message, const std::string& hint) {
  return fail("usage.arguments", message, hint);
}

Failure unknown_verb(const CLI::App& app, const std::string& word) {
  const Words verbs = verbs_of(app);
  return about(fmt::format("there is no verb '{}'", word),
               fmt::format("{}the verbs are {}; see beadmesh --help", suggestion(word, verbs),
                           fmt::join(verbs, ", ")));
}

Failure unexpected(const CLI::App& verb, const Words& left, const std::string& help) {
  for (const std::string& word : left) {
    const std::string name = word.substr(0, word.find('='));
    if (word.size() > 1 && word[0] == '-' && !std::isdigit(static_cast<unsigned char>(word[1])))
      return about(fmt::format("there is no option {}", name), suggestion(name, options_of(verb)) + help);
  }
  return about(fmt::format("'{}' is one word too many", left.empty() ? "" : left.front()), help);
}

}  // namespace

Failure usage_failure(const CLI::App& app, int argc, const char* const* argv,
                      const CLI::ParseError& problem) {
  const auto verbs = app.get_subcommands();
  if (verbs.empty()) {
    const std::string word = argc > 1 ? argv[1] : "";
    if (!word.empty() && word[0] != '-') return unknown_verb(app, word);
    if (word.empty())
      return about("no verb is given",
                   "the usual one: beadmesh mesh PANEL -o DECK; beadmesh --help lists all");
    return unexpected(app, {word}, "see beadmesh --help");
  }
  const CLI::App& verb = *verbs.front();
  const std::string help = fmt::format("see beadmesh {} --help", verb.get_name());
  if (dynamic_cast<const CLI::ExtrasError*>(&problem)) return unexpected(verb, app.remaining(true), help);
  return about(problem.what(), help);
}

}  // namespace beadmesh::app
