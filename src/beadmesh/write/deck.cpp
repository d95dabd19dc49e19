#include "beadmesh/write/deck.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "beadmesh/write/abaqus.h"
#include "beadmesh/write/deck_text.h"
#include "beadmesh/write/gmsh.h"
#include "beadmesh/write/ls_dyna.h"
#include "beadmesh/write/nastran.h"
#include "beadmesh/write/stl.h"
#include "beadmesh/write/vtu.h"

namespace beadmesh {
namespace {

using Writer = void (*)(const ShellMesh&, std::ostream&, const DeckOptions&);

struct Format {
  const char* name;
  std::vector<std::string> endings;
  Writer write;
};

const std::vector<Format>& formats() {
  static const std::vector<Format> all = {
      {"Nastran", {".bdf", ".nas", ".dat"}, write_nastran},
      {"LS-DYNA", {".k", ".key"}, write_ls_dyna},
      {"Abaqus, CalculiX", {".inp"}, write_abaqus},
      {"VTK", {".vtu"}, write_vtu},
      {"Gmsh 4.1", {".msh"}, write_gmsh},
      {"facets only", {".stl"}, write_stl},
  };
  return all;
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Writer writer_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const Format& format : formats())
    if (std::count(format.endings.begin(), format.endings.end(), extension)) return format.write;
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

constexpr std::int64_t largest_id = 99'999'999;  // eight columns

/// All ids from 1 on and in eight columns.
Result<void> check_ids(const ShellMesh& mesh, const DeckOptions& options) {
  const auto check = [](const char* what, std::int64_t first, std::int64_t last) -> Result<void> {
    if (first >= 1 && last <= largest_id) return {};
    return fail("write.ids", fmt::format("the {} would be {} to {}", what, first, last),
                fmt::format("they must lie between 1 and {}", largest_id));
  };
  const auto span = [](Index first, size_t count) { return first + std::int64_t(count) - 1; };
  Index parts = 1;
  for (const ShellPart& part : mesh.parts) parts = std::max(parts, part.id);
  if (auto good = check("node ids", options.first_node, span(options.first_node, mesh.nodes.size())); !good)
    return good;
  if (auto good =
          check("element ids", options.first_element, span(options.first_element, mesh.elements.size()));
      !good)
    return good;
  if (auto good = check("property ids", options.first_property, span(options.first_property, parts)); !good)
    return good;
  return check("set ids", std::int64_t(1) + options.set_offset, largest_set_id(mesh, options));
}

}  // namespace

std::string deck_endings() {
  std::string text;
  for (const Format& format : formats()) {
    text += text.empty() ? "" : ", ";
    for (const std::string& ending : format.endings) text += ending + " ";
    text += fmt::format("({})", format.name);
  }
  return text;
}

Result<void> check_deck_ending(const std::filesystem::path& path) {
  if (writer_of(path)) return {};
  const std::string extension = path.extension().string();
  return fail("write.ending", extension.empty() ? "has no ending" : "unknown ending " + extension,
              "known: " + deck_endings(), path.string());
}

Result<void> check_deck_mesh(const ShellMesh& mesh, const DeckOptions& options) {
  if (mesh.elements.empty()) return fail("write.mesh", "the mesh has no elements");
  if (auto fit = check_ids(mesh, options); !fit) return fit;
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

void write_deck(const ShellMesh& mesh, const std::filesystem::path& path, std::ostream& out,
                const DeckOptions& options) {
  if (const Writer write = writer_of(path)) write(mesh, out, options);
}

Result<void> write_deck(const ShellMesh& mesh, const std::filesystem::path& path,
                        const DeckOptions& options) {
  if (auto ending = check_deck_ending(path); !ending) return ending;
  if (auto good = check_deck_mesh(mesh, options); !good) return good;
  return write_whole(path, [&](std::ostream& out) { write_deck(mesh, path, out, options); });
}

}  // namespace beadmesh
