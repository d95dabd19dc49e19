#include "beadmesh/write/nastran.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "beadmesh/core/version.h"

namespace beadmesh {
namespace {

constexpr size_t line_width = 72;

/// Text that goes out in large pieces.
class Page {
 public:
  explicit Page(std::ostream& out) : out_(out) {}
  ~Page() { flush(); }

  template <class... Values>
  void line(fmt::format_string<Values...> format, const Values&... values) {
    fmt::vformat_to(std::back_inserter(text_), format, fmt::make_format_args(values...));
    text_.push_back('\n');
    if (text_.size() > 1 << 20) flush();
  }

 private:
  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

  std::ostream& out_;
  fmt::memory_buffer text_;
};

/// A coordinate in at most 16 columns, with a decimal point, the same text for 0 and -0.
class Coordinate {
 public:
  explicit Coordinate(double value) {
    const double size = std::abs(value);
    const char* format = size < 1e5 ? "{:.8f}" : size < 1e7 ? "{:.6f}" : "{:.8e}";
    const double shown = size < 5e-9 ? 0.0 : value;
    const auto result = fmt::format_to_n(text_, sizeof(text_), fmt::runtime(format), shown);
    length_ = std::min(result.size, sizeof(text_));
  }
  std::string_view text() const { return {text_, length_}; }

 private:
  char text_[24];
  size_t length_;
};

/// A real in eight columns, with a decimal point.
std::string short_real(double value) {
  for (int digits = 7; digits > 0; --digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    const size_t end = std::min(text.find('e'), text.size());
    if (text.find('.') == std::string::npos) text.insert(end, 1, '.');
    if (text.size() <= 8) return text;
  }
  return "0.";
}

/// Comments and titles must stay on their line and in ASCII.
std::string plain(std::string_view text, size_t width) {
  std::string result;
  for (const unsigned char c : text.substr(0, width))
    result += c >= 32 && c < 127 ? static_cast<char>(c) : '?';
  return result;
}

/// Runs of three and more consecutive ids as "a THRU b"; `items` are ascending indices, ids are index + 1.
std::vector<std::string> ranges(const std::vector<Index>& items) {
  std::vector<std::string> result;
  for (size_t i = 0; i < items.size();) {
    size_t end = i + 1;
    while (end < items.size() && items[end] == items[end - 1] + 1) ++end;
    if (end - i >= 3) {
      result.push_back(fmt::format("{} THRU {}", items[i] + 1, items[end - 1] + 1));
      i = end;
    } else {
      result.push_back(fmt::format("{}", items[i] + 1));
      ++i;
    }
  }
  return result;
}

/// A continued line ends in a comma; a THRU is never broken.
void set_card(Page& page, Index id, const std::vector<Index>& items) {
  const std::vector<std::string> parts = ranges(items);
  std::string line = fmt::format("SET {} = ", id);
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string text = parts[i] + (i + 1 < parts.size() ? "," : "");
    if (line.size() + text.size() > line_width) {
      page.line("{}", line);
      line = "  ";
    }
    line += text;
  }
  page.line("{}", line);
}

void write_sets(Page& page, const ShellMesh& mesh) {
  Index base = 10'000;
  for (const BeadSet& bead : mesh.beads)
    while (bead.bead >= base) base *= 10;
  for (const BeadSet& bead : mesh.beads) {
    const std::string name =
        plain(fmt::format("bead {}, kind {}, shape {}", bead.bead, bead.kind, bead.shape), 40);
    if (!bead.elements.empty()) {
      page.line("$ set {}: elements of {}", base + bead.bead, name);
      set_card(page, base + bead.bead, bead.elements);
    }
    if (!bead.crest_nodes.empty()) {
      page.line("$ set {}: crest nodes of {}", 2 * base + bead.bead, name);
      set_card(page, 2 * base + bead.bead, bead.crest_nodes);
    }
  }
}

void write_control(Page& page, const ShellMesh& mesh) {
  page.line("$ beadmesh {}", version());
  page.line("$ {}", plain(mesh.title, 200));
  page.line("$ {} nodes, {} elements, {} beads; units: mm, N, tonne, s", mesh.nodes.size(),
            mesh.elements.size(), mesh.beads.size());
  page.line("SOL 103");
  page.line("CEND");
  page.line("TITLE = {}", plain(mesh.title.empty() ? "beadmesh" : mesh.title, line_width - 8));
  page.line("ECHO = NONE");
  page.line("METHOD = 1");
  page.line("DISPLACEMENT(PLOT) = ALL");
  write_sets(page, mesh);
  page.line("BEGIN BULK");
  page.line("PARAM,POST,-1");
  page.line("$ the first 16 modes, six of them rigid");
  page.line("EIGRL   {:>8}{:>8}{:>8}{:>8}", 1, "", "", 16);
}

void write_properties(Page& page, const ShellMesh& mesh) {
  page.line("$ steel, a placeholder: E in N/mm2, density in tonne/mm3");
  page.line("MAT1    {:>8}{:>8}{:>8}{:>8}{:>8}", 1, "210000.", "", "0.3", "7.85-9");
  for (const ShellPart& part : mesh.parts) {
    page.line("$ property {}: {}", part.id, plain(part.name, 40));
    page.line("PSHELL  {:>8}{:>8}{:>8}{:>8}{:>8}{:>8}", part.id, 1, short_real(part.thickness), 1, "", 1);
  }
}

void write_nodes(Page& page, const std::vector<Vec3>& nodes) {
  Index id = 0;
  for (const Vec3& p : nodes) {
    page.line("GRID*   {:>16}{:16}{:>16}{:>16}*", ++id, "", Coordinate(p.x).text(), Coordinate(p.y).text());
    page.line("*       {:>16}", Coordinate(p.z).text());
  }
}

void write_elements(Page& page, const ShellMesh& mesh) {
  Index id = 0;
  for (const ShellElement& element : mesh.elements) {
    const Index part = mesh.parts[element.part].id;
    const MeshElement& n = element.nodes;
    ++id;
    if (is_quad(n))
      page.line("CQUAD4  {:8}{:8}{:8}{:8}{:8}{:8}", id, part, n[0] + 1, n[1] + 1, n[2] + 1, n[3] + 1);
    else
      page.line("CTRIA3  {:8}{:8}{:8}{:8}{:8}", id, part, n[0] + 1, n[1] + 1, n[2] + 1);
  }
}

}  // namespace

void write_nastran(const ShellMesh& mesh, std::ostream& out) {
  Page page(out);
  write_control(page, mesh);
  write_properties(page, mesh);
  write_nodes(page, mesh.nodes);
  write_elements(page, mesh);
  page.line("ENDDATA");
}

}  // namespace beadmesh
