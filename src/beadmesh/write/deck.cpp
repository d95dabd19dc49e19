#include "beadmesh/write/deck.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "beadmesh/write/nastran.h"

namespace beadmesh {
namespace {

using Format = void (*)(const ShellMesh&, std::ostream&);

struct Ending {
  const char* text;
  Format write;
};

constexpr Ending endings[] = {{".bdf", write_nastran}, {".nas", write_nastran}, {".dat", write_nastran}};

std::string lower_extension(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Format format_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const Ending& ending : endings)
    if (extension == ending.text) return ending.write;
  return nullptr;
}

bool is_finite(Vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool has_good_nodes(const ShellElement& element, Index node_count) {
  for (int corner = 0; corner < 4; ++corner) {
    const Index node = element.nodes[corner];
    if (corner == 3 && node == no_index) continue;
    if (node < 0 || node >= node_count) return false;
  }
  return true;
}

}  // namespace

Result<void> check_deck_ending(const std::filesystem::path& path) {
  if (format_of(path)) return {};
  std::string known;
  for (const Ending& ending : endings) known += std::string(known.empty() ? "" : " ") + ending.text;
  const std::string extension = path.extension().string();
  return fail("write.ending", extension.empty() ? "has no ending" : "unknown ending " + extension,
              "known: " + known, path.string());
}

Result<void> check_deck_mesh(const ShellMesh& mesh) {
  constexpr size_t largest_id = 99'999'999;  // eight columns
  if (mesh.elements.empty()) return fail("write.mesh", "the mesh has no elements");
  if (mesh.nodes.size() > largest_id || mesh.elements.size() > largest_id)
    return fail("write.mesh", "more than 99999999 nodes or elements do not fit the format",
                "use a larger size");
  for (size_t i = 0; i < mesh.nodes.size(); ++i)
    if (!is_finite(mesh.nodes[i]))
      return fail("write.mesh", "a coordinate is not a number", "", "node " + std::to_string(i + 1));
  const Index parts = static_cast<Index>(mesh.parts.size()), nodes = static_cast<Index>(mesh.nodes.size());
  for (size_t i = 0; i < mesh.elements.size(); ++i) {
    const ShellElement& element = mesh.elements[i];
    if (element.part < 0 || element.part >= parts || !has_good_nodes(element, nodes))
      return fail("write.mesh", "a node or the part does not exist", "", "element " + std::to_string(i + 1));
  }
  return {};
}

void write_deck(const ShellMesh& mesh, const std::filesystem::path& path, std::ostream& out) {
  if (const Format write = format_of(path)) write(mesh, out);
}

Result<void> write_deck(const ShellMesh& mesh, const std::filesystem::path& path) {
  if (auto ending = check_deck_ending(path); !ending) return ending;
  if (auto good = check_deck_mesh(mesh); !good) return good;
  return write_whole(path, [&](std::ostream& out) { write_deck(mesh, path, out); });
}

}  // namespace beadmesh
