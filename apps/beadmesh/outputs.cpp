#include "outputs.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <utility>

#include "beadmesh/write/deck.h"
#include "beadmesh/write/whole_files.h"

namespace beadmesh::app {
namespace {

namespace fs = std::filesystem;

struct Named {
  const char* flag;
  const std::string& name;
  std::vector<std::string> endings;  ///< empty: any
  bool may_be_stdout;
};

std::vector<Named> asked_for(const Options& options) {
  const OutputNames& names = options.outputs;
  std::vector<std::string> reports = {".html", ".htm"};
  if (options.verb == Verb::mesh) reports.push_back(".svg");  // the flat picture is one of the mesh
  std::vector<Named> all = {{"--output", names.deck, {}, false},
                            {"--json", names.json, {}, true},
                            {"--csv", names.csv, {}, true},
                            {"--report", names.report, reports, false},
                            {"--svg", names.svg, {".svg"}, false},
                            {"--debug-svg", names.debug_svg, {".svg"}, false},
                            {"--save-criteria", names.criteria, {}, false},
                            {"--repair", names.repaired, {".bdf", ".nas", ".dat"}, false}};
  std::vector<Named> asked;
  for (Named& one : all)
    if (!one.name.empty()) asked.push_back(std::move(one));
  return asked;
}

Result<void> check_ending(const Named& output) {
  std::string ending = fs::path(output.name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (output.endings.empty() || std::count(output.endings.begin(), output.endings.end(), ending)) return {};
  std::string known;
  for (const std::string& one : output.endings) known += (known.empty() ? "" : " ") + one;
  return fail("usage.output", std::string("unknown ending of ") + output.flag, "known: " + known,
              output.name);
}

/// The same file under any spelling.
fs::path identity(const fs::path& path) {
  std::error_code error;
  const fs::path full = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path.lexically_normal() : full;
}

Result<void> check_names(const std::vector<Named>& asked, const fs::path& input) {
  for (size_t i = 0; i < asked.size(); ++i) {
    for (size_t k = 0; k < i; ++k)
      if (asked[i].name == asked[k].name || identity(asked[i].name) == identity(asked[k].name))
        return fail("usage.output",
                    std::string(asked[k].flag) + " and " + asked[i].flag + " name the same file", "",
                    asked[i].name);
    if (asked[i].name != "-" && identity(asked[i].name) == identity(input))
      return fail("usage.output", std::string(asked[i].flag) + " would overwrite the input",
                  "give another name", asked[i].name);
  }
  return {};
}

}  // namespace

Result<void> check_outputs(const Options& options) {
  const std::vector<Named> asked = asked_for(options);
  if (!options.outputs.deck.empty())
    if (auto known = check_deck_ending(options.outputs.deck); !known) return known;
  if (auto good = check_names(asked, options.input); !good) return good;
  for (const Named& output : asked) {
    if (output.name == "-" && output.may_be_stdout) continue;
    if (auto known = check_ending(output); !known) return known;
    if (auto place = check_target(output.name); !place) return place;
  }
  return {};
}

void Outputs::add(const std::string& name, Writer write) {
  if (name == "-")
    stdout_ = std::move(write);
  else if (!name.empty())
    names_.push_back(name), writers_.push_back(std::move(write));
}

Result<void> Outputs::put() {
  WholeFiles files;
  for (size_t i = 0; i < names_.size(); ++i)
    if (auto added = files.add(names_[i], writers_[i]); !added) return added;
  if (auto done = files.commit(); !done) return done;
  if (!stdout_) return {};
  stdout_(std::cout);
  std::cout.flush();
  if (!std::cout) return fail("write.stdout", "standard output could not be written to");
  return {};
}

}  // namespace beadmesh::app
