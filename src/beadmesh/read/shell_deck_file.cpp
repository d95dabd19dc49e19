#include "beadmesh/read/shell_deck_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "beadmesh/read/abaqus_reader.h"
#include "beadmesh/read/lsdyna_reader.h"
#include "beadmesh/read/nastran_reader.h"

namespace beadmesh {
namespace {

using Parser = Result<ShellDeck> (*)(std::string_view);

Parser parser_for(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == ".bdf" || ending == ".nas" || ending == ".dat") return parse_nastran;
  if (ending == ".k" || ending == ".key" || ending == ".dyn") return parse_lsdyna;
  if (ending == ".inp") return parse_abaqus;
  return nullptr;
}

}  // namespace

Result<ShellDeck> read_shell_deck(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return fail("read.not_found", "there is no such file", "", path.string());
  if (std::filesystem::is_directory(path, error))
    return fail("read.directory", "is a folder", "give a file", path.string());
  const Parser parse = parser_for(path);
  if (!parse) {
    const std::string ending = path.extension().string();
    return fail("read.ending", ending.empty() ? "has no ending" : "unknown ending " + ending,
                "known: .bdf .nas .dat .k .key .dyn .inp", path.string());
  }
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) return fail("read.unreadable", "the file cannot be read", "", path.string());
  auto deck = parse(text);
  if (!deck) {
    Diagnostic problem = deck.error();
    problem.entity = path.string() + (problem.entity.empty() ? "" : ", " + problem.entity);
    return tl::make_unexpected(std::move(problem));
  }
  return deck;
}

}  // namespace beadmesh
