#include "beadmesh/read/lsdyna_reader.h"

#include <map>
#include <string>

#include "beadmesh/read/shell_deck_builder.h"

namespace beadmesh {
namespace {

constexpr const char* shells_read = "*ELEMENT_SHELL is read";

/// A line of a card cut into fields of given widths, or at its commas.
class Fields {
 public:
  Fields(std::string_view line, std::initializer_list<int> widths) {
    if (line.find(',') != std::string_view::npos) {
      for (size_t at = 0; at <= line.size();) {
        const size_t comma = std::min(line.find(',', at), line.size());
        fields_.push_back(trimmed(line.substr(at, comma - at)));
        at = comma + 1;
      }
    } else {
      size_t at = 0;
      for (const int width : widths) {
        fields_.push_back(at < line.size() ? trimmed(line.substr(at, width)) : std::string_view{});
        at += width;
      }
    }
  }
  std::string_view operator[](size_t i) const { return i < fields_.size() ? fields_[i] : std::string_view{}; }

 private:
  std::vector<std::string_view> fields_;
};

class KeywordReader {
 public:
  explicit KeywordReader(std::string_view text) : text_(text), builder_("read.lsdyna") {}

  Result<ShellDeck> run() {
    if (text_.find('\0') != std::string_view::npos)
      return fail("read.lsdyna.binary", "the deck is not a text file", "write it as keywords");
    for (std::string_view line; next_line(line);) {
      if (line.front() == '*') {
        if (!begin_keyword(line)) break;
        if (keyword_.starts_with("*INCLUDE") && keyword_ != "*INCLUDE_PATH")
          return fail("read.lsdyna.include", keyword_ + " is not followed", "put the deck into one file",
                      at_line(line_));
        if (keyword_.starts_with("*ELEMENT_SHELL_COMPOSITE"))
          return fail("read.lsdyna.composite", keyword_ + " is not read", "give the layers with the part",
                      at_line(line_));
        continue;
      }
      if (auto taken = take(line); !taken) return tl::make_unexpected(taken.error());
    }
    for (DeckProperty& part : parts_) {
      const auto section = thickness_.find(part.material);  // holds the section until here
      const double thickness = section == thickness_.end() ? 0 : section->second;
      builder_.add_property({part.id, part.name, thickness, material_[part.id]});
    }
    return builder_.finish(shells_read);
  }

 private:
  /// The next line that is no comment and not blank.
  bool next_line(std::string_view& line) {
    while (at_ < text_.size()) {
      const size_t end = std::min(text_.find('\n', at_), text_.size());
      line = text_.substr(at_, end - at_);
      at_ = end + 1;
      ++line_;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      if (!trimmed(line).empty() && line.front() != '$') return true;
    }
    return false;
  }

  /// False at *END.
  bool begin_keyword(std::string_view line) {
    std::string word = upper_case(trimmed(line));
    if (const size_t blank = word.find_first_of(" \t"); blank != std::string::npos) {
      if (word.starts_with("*KEYWORD")) long_ = word.find("LONG=Y") != std::string::npos;
      if (word.find('%') == std::string::npos && word.find('+') == std::string::npos) word.resize(blank);
    }
    wide_ = long_;
    while (!word.empty() &&
           (word.back() == '%' || word.back() == '+' || word.back() == '-' || word.back() == ' ')) {
      if (word.back() == '%' || word.back() == '+') wide_ = true;
      if (word.back() == '-') wide_ = false;
      word.pop_back();
    }
    keyword_ = std::move(word);
    card_ = 0;
    skip_ = 0;
    return keyword_ != "*END";
  }

  Result<void> take(std::string_view line) {
    if (keyword_ == "*NODE") return take_node(line);
    if (keyword_ == "*ELEMENT_SHELL" || keyword_.starts_with("*ELEMENT_SHELL_")) return take_shell(line);
    if (keyword_ == "*PART" || keyword_ == "*PART_INERTIA" || keyword_ == "*PART_CONTACT")
      return take_part(line);
    if (keyword_ == "*SECTION_SHELL" || keyword_ == "*SECTION_SHELL_TITLE") return take_section(line);
    return {};
  }

  Failure bad(const char* what) const {
    return fail("read.lsdyna.card", keyword_ + " " + what, "", at_line(line_));
  }

  Result<void> take_node(std::string_view line) {
    const Fields f = wide_ ? Fields(line, {20, 20, 20, 20}) : Fields(line, {8, 16, 16, 16});
    const auto id = deck_integer(f[0]);
    const auto x = deck_real(f[1]), y = deck_real(f[2]), z = deck_real(f[3]);
    if (!id || *id < 1 || !x || !y || !z) return bad("cannot be read");
    return builder_.add_node(*id, {*x, *y, *z}, line_);
  }

  /// The first card has the nodes; options bring further cards.
  Result<void> take_shell(std::string_view line) {
    if (skip_ > 0) {
      --skip_;
      return {};
    }
    const Fields f = wide_ ? Fields(line, {20, 20, 20, 20, 20, 20, 20, 20, 20, 20})
                           : Fields(line, {8, 8, 8, 8, 8, 8, 8, 8, 8, 8});
    const auto id = deck_integer(f[0]), part = deck_integer(f[1]);
    if (!id || !part) return bad("cannot be read");
    std::array<Index, 4> nodes{no_index, no_index, no_index, no_index};
    for (size_t k = 0; k < 4; ++k) {
      const auto node = deck_integer(f[2 + k], 0);
      if (!node || *node < 0 || (*node == 0 && k < 3)) return bad("cannot be read");
      if (*node > 0) nodes[k] = *node;
    }
    if (nodes[3] == nodes[2]) nodes[3] = no_index;
    builder_.add_shell(*part, nodes, line_);
    const bool has_middle_nodes = deck_integer(f[6], 0).value_or(0) > 0;
    const auto has = [&](const char* option) { return keyword_.find(option) != std::string::npos; };
    if (has("_THICKNESS") || has("_BETA") || has("_MCID")) skip_ += has_middle_nodes ? 2 : 1;
    if (has("_OFFSET")) ++skip_;
    if (has("_DOF")) ++skip_;
    return {};
  }

  Result<void> take_part(std::string_view line) {
    const int card = keyword_ == "*PART" ? card_++ % 2 : card_++;
    if (card == 0) heading_ = std::string(trimmed(line));
    if (card != 1) return {};
    const Fields f = wide_ ? Fields(line, {20, 20, 20}) : Fields(line, {10, 10, 10});
    const auto id = deck_integer(f[0]), section = deck_integer(f[1], 0), material = deck_integer(f[2], 0);
    if (!id || !section || !material) return {};  // ids may be names; the shells tell what counts
    parts_.push_back({*id, heading_, 0, *section});
    material_[*id] = *material;
    return {};
  }

  Result<void> take_section(std::string_view line) {
    int card = card_++;
    if (keyword_ == "*SECTION_SHELL_TITLE" && card-- == 0) return {};
    if (card == 0) section_ = deck_integer(Fields(line, {wide_ ? 20 : 10})[0]).value_or(0);
    if (card != 1) return {};
    const auto thickness = deck_real(Fields(line, {wide_ ? 20 : 10})[0]);
    if (thickness && *thickness > 0) thickness_[section_] = *thickness;
    // Further sections may follow under the same keyword.
    card_ = 0;
    return {};
  }

  std::string_view text_;
  size_t at_ = 0;
  int line_ = 0;
  std::string keyword_, heading_;
  bool long_ = false, wide_ = false;
  int card_ = 0;  ///< cards under the keyword so far
  int skip_ = 0;  ///< cards that belong to the shell before
  Index section_ = 0;
  ShellDeckBuilder builder_;
  std::vector<DeckProperty> parts_;
  std::map<Index, double> thickness_;  ///< per section
  std::map<Index, Index> material_;    ///< per part
};

}  // namespace

Result<ShellDeck> parse_lsdyna(std::string_view text) {
  return KeywordReader(text).run();
}

}  // namespace beadmesh
