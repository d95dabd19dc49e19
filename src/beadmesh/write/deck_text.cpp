#include "beadmesh/write/deck_text.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "beadmesh/core/version.h"

namespace beadmesh {
namespace {

constexpr size_t longest_head_line = 200;
constexpr int set_kinds = 4;

Index base_of_sets(const ShellMesh& mesh) {
  Index base = 10'000;
  for (const BeadSet& bead : mesh.beads)
    while (bead.bead >= base) base *= 10;
  return base;
}

}  // namespace

void Page::flush() {
  out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
  text_.clear();
}

void Page::rows_of_ids(const std::vector<Index>& items, Index first, int per_row, int width,
                       std::string_view mark) {
  for (size_t i = 0; i < items.size(); ++i) {
    const bool ends = i + 1 == items.size() || i % per_row + 1 == size_t(per_row);
    text("{:>{}}{}", items[i] + first, width, ends ? std::string_view() : mark);
    if (ends) end_line();
  }
}

Coordinate::Coordinate(double value) {
  const double size = std::abs(value);
  const char* format = size < 1e5 ? "{:.8f}" : size < 1e7 ? "{:.6f}" : "{:.8e}";
  const double shown = size < 5e-9 ? 0.0 : value;
  const auto result = fmt::format_to_n(text_, sizeof(text_), fmt::runtime(format), shown);
  length_ = std::min(result.size, sizeof(text_));
}

std::string short_real(double value, size_t width) {
  for (int digits = int(width) - 1; digits > 0; --digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    const size_t end = std::min(text.find('e'), text.size());
    if (text.find('.') == std::string::npos) text.insert(end, 1, '.');
    if (text.size() <= width) return text;
  }
  return "0.";
}

std::string plain(std::string_view text, size_t width) {
  std::string result;
  for (const unsigned char c : text.substr(0, width))
    result += c >= 32 && c < 127 ? static_cast<char>(c) : '?';
  return result;
}

std::vector<std::string> head_lines(const ShellMesh& mesh, const DeckOptions& options) {
  std::vector<std::string> lines = {fmt::format("beadmesh {}", version()), mesh.title,
                                    fmt::format("{} nodes, {} elements, {} beads; units: mm, N, tonne, s",
                                                mesh.nodes.size(), mesh.elements.size(), mesh.beads.size())};
  lines.insert(lines.end(), options.remarks.begin(), options.remarks.end());
  for (std::string& line : lines) line = plain(line, longest_head_line);
  return lines;
}

void write_head(Page& page, const ShellMesh& mesh, const DeckOptions& options, std::string_view mark) {
  for (const std::string& line : head_lines(mesh, options)) page.line("{}{}", mark, line);
}

std::int64_t largest_set_id(const ShellMesh& mesh, const DeckOptions& options) {
  Index last = 0;
  for (const BeadSet& bead : mesh.beads) last = std::max(last, bead.bead);
  return set_kinds * std::int64_t(base_of_sets(mesh)) + last + options.set_offset;
}

std::vector<NamedSet> sets_of(const ShellMesh& mesh, const DeckOptions& options) {
  const Index base = base_of_sets(mesh);
  std::vector<NamedSet> sets;
  for (const BeadSet& bead : mesh.beads) {
    const std::string name = fmt::format("bead_{}", bead.bead);
    const std::string whose = fmt::format("bead {}, kind {}, shape {}", bead.bead, bead.kind, bead.shape);
    Index number = 0;
    const auto add = [&](const char* suffix, const char* what, bool of_nodes,
                         const std::vector<Index>& items) {
      const Index id = ++number * base + bead.bead + options.set_offset;
      if (!items.empty())
        sets.push_back(
            {id, name + suffix, plain(fmt::format("{} of {}", what, whose), 60), of_nodes, &items});
    };
    add("", "elements", false, bead.elements);
    add("_crest", "crest nodes", true, bead.crest_nodes);
    add("_boundary", "boundary nodes", true, bead.boundary_nodes);
    add("_caps", "cap elements", false, bead.cap_elements);
  }
  return sets;
}

}  // namespace beadmesh
