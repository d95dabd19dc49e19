// Internal to the room: lines, numbers and sets that the text formats have in common.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <iosfwd>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/deck_options.h"

namespace beadmesh {

/// Steel, a placeholder, in N, mm, tonne, s.
inline constexpr double steel_modulus = 210'000, steel_poisson = 0.3, steel_density = 7.85e-9;
/// Of DeckAnalysis::modes; six of them are rigid.
inline constexpr int mode_count = 16;

/// Text that goes out in large pieces.
class Page {
 public:
  explicit Page(std::ostream& out) : out_(out) {}
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  ~Page() { flush(); }

  /// A line, its end included.
  template <class... Values>
  void line(fmt::format_string<Values...> format, const Values&... values) {
    text(format, values...);
    end_line();
  }
  template <class... Values>
  void text(fmt::format_string<Values...> format, const Values&... values) {
    fmt::vformat_to(std::back_inserter(text_), format, fmt::make_format_args(values...));
  }
  void end_line() {
    text_.push_back('\n');
    if (text_.size() > 1 << 20) flush();
  }
  /// Numbers from `first` on in rows of `per_row`, each in `width` columns, with `mark` between those of a
  /// row.
  void rows_of_ids(const std::vector<Index>& items, Index first, int per_row, int width,
                   std::string_view mark);

 private:
  void flush();

  std::ostream& out_;
  fmt::memory_buffer text_;
};

/// A coordinate in at most 16 columns, with a decimal point, the same text for 0 and -0.
class Coordinate {
 public:
  explicit Coordinate(double value);
  std::string_view text() const { return {text_, length_}; }

 private:
  char text_[24];
  size_t length_;
};

/// A real in `width` columns (at least eight), with a decimal point.
std::string short_real(double value, size_t width = 8);

/// At most `width` characters of a text for a comment or a title, on one line, in ASCII.
std::string plain(std::string_view text, size_t width);

/// The head of a file, as lines: version, title, counts and units, then the remarks asked for.
std::vector<std::string> head_lines(const ShellMesh& mesh, const DeckOptions& options);
/// The same as comments, each with the mark of the format before it.
void write_head(Page& page, const ShellMesh& mesh, const DeckOptions& options, std::string_view mark);

/// One set of a bead.
struct NamedSet {
  Index id = 0;
  std::string name;  ///< "bead_1_crest", from letters, digits and underlines
  std::string text;  ///< "crest nodes of bead 1, kind I, shape I"
  bool is_of_nodes = false;
  const std::vector<Index>* items = nullptr;  ///< indices, ascending, at least one
};

/// The sets of all beads that have members, bead by bead: elements (10000 + bead), crest nodes (20000 +),
/// boundary nodes (30000 +), elements of the caps (40000 +). With 10,000 beads and more these bases grow by
/// powers of ten.
std::vector<NamedSet> sets_of(const ShellMesh& mesh, const DeckOptions& options);

/// The largest id that these can have.
std::int64_t largest_set_id(const ShellMesh& mesh, const DeckOptions& options);

/// Id of a part in the deck.
inline Index property_id(const ShellPart& part, const DeckOptions& options) {
  return part.id - 1 + options.first_property;
}

}  // namespace beadmesh
