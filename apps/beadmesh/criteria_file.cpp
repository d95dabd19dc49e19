#include "criteria_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "beadmesh/mesh/criteria_text.h"
#include "summary.h"

namespace beadmesh::app {

namespace {
constexpr std::uintmax_t longest_criteria_file = 1 << 20;
}  // namespace

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

}  // namespace beadmesh::app
