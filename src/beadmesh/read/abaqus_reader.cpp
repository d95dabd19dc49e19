#include "beadmesh/read/abaqus_reader.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "beadmesh/read/shell_deck_builder.h"

namespace beadmesh {
namespace {

/// Keyword line: upper case without blanks, "*ELEMENT" and its options.
struct Keyword {
  std::string name;
  std::map<std::string, std::string> options;
};

std::vector<std::string_view> at_commas(std::string_view line) {
  std::vector<std::string_view> fields;
  for (size_t at = 0; at <= line.size();) {
    const size_t comma = std::min(line.find(',', at), line.size());
    fields.push_back(trimmed(line.substr(at, comma - at)));
    at = comma + 1;
  }
  return fields;
}

Keyword keyword_of(std::string_view line) {
  Keyword keyword;
  for (const std::string_view field : at_commas(line)) {
    const size_t equals = field.find('=');
    const std::string name = upper_case(trimmed(field.substr(0, equals)));
    if (keyword.name.empty())
      keyword.name = name;
    else
      keyword.options[name] =
          equals == std::string_view::npos ? "" : upper_case(trimmed(field.substr(equals + 1)));
  }
  return keyword;
}

/// Nodes of an element of this type and how many of them are corners; {0, 0} for what is no shell.
std::array<int, 2> nodes_of_type(const std::string& type) {
  if (type == "S6" || type == "STRI65" || type == "M3D6") return {6, 3};
  if (type == "S8" || type == "S8R" || type == "S8R5" || type == "M3D8" || type == "M3D8R") return {8, 4};
  if (type.starts_with("S3") || type.starts_with("STRI3") || type == "M3D3" || type == "DS3") return {3, 3};
  if (type.starts_with("S4") || type.starts_with("M3D4") || type == "DS4") return {4, 4};
  return {0, 0};
}

class DeckReader {
 public:
  explicit DeckReader(std::string_view text) : text_(text), builder_("read.abaqus") {}

  Result<ShellDeck> run() {
    if (text_.find('\0') != std::string_view::npos)
      return fail("read.abaqus.binary", "the deck is not a text file", "");
    for (std::string_view line; next_line(line);) {
      const auto taken = line.front() == '*' ? begin_keyword(line) : take(line);
      if (!taken) return tl::make_unexpected(taken.error());
    }
    give_properties();
    return builder_.finish("S3, S4 and their relatives are read");
  }

 private:
  bool next_line(std::string_view& line) {
    while (at_ < text_.size()) {
      const size_t end = std::min(text_.find('\n', at_), text_.size());
      line = trimmed(text_.substr(at_, end - at_));
      at_ = end + 1;
      ++line_;
      if (!line.empty() && !line.starts_with("**")) return true;
    }
    return false;
  }

  Result<void> begin_keyword(std::string_view line) {
    std::string whole(line);
    for (std::string_view more; whole.back() == ',' && next_line(more);) whole += more;
    keyword_ = keyword_of(whole);
    rest_.clear();
    first_data_ = true;
    if (keyword_.name == "*INCLUDE")
      return fail("read.abaqus.include", "*INCLUDE is not followed", "put the deck into one file",
                  at_line(line_));
    if (keyword_.name == "*SYSTEM" || (keyword_.name == "*NODE" && keyword_.options.contains("SYSTEM") &&
                                       keyword_.options["SYSTEM"] != "R"))
      return fail("read.abaqus.system", "nodes lie in a coordinate system of their own",
                  "export in the global system", at_line(line_));
    if (keyword_.name == "*INSTANCE" && ++instances_ > 1)
      return fail("read.abaqus.instance", "the assembly has several instances", "write a flat deck",
                  at_line(line_));
    if (keyword_.name == "*SHELL SECTION")
      sections_.push_back({keyword_.options["ELSET"], 0, keyword_.options["MATERIAL"]});
    in_instance_ = keyword_.name == "*INSTANCE";
    return {};
  }

  Result<void> take(std::string_view line) {
    if (in_instance_)
      return fail("read.abaqus.instance", "an instance is moved or turned", "write a flat deck",
                  at_line(line_));
    if (keyword_.name == "*NODE") return take_node(line);
    if (keyword_.name == "*ELEMENT") return take_element(line);
    if (keyword_.name == "*ELSET") return take_set(line);
    if (keyword_.name == "*SHELL SECTION" && first_data_) {
      first_data_ = false;
      const auto thickness = deck_real(at_commas(line)[0]);
      if (thickness && *thickness > 0 && !keyword_.options.contains("COMPOSITE"))
        sections_.back().thickness = *thickness;
    }
    return {};
  }

  Failure bad(const char* what) const {
    return fail("read.abaqus.card", keyword_.name + " " + what, "", at_line(line_));
  }

  Result<void> take_node(std::string_view line) {
    const auto f = at_commas(line);
    const auto id = deck_integer(f[0]);
    const auto x = deck_real(f.size() > 1 ? f[1] : ""), y = deck_real(f.size() > 2 ? f[2] : ""),
               z = deck_real(f.size() > 3 ? f[3] : "");
    if (!id || *id < 1 || !x || !y || !z) return bad("cannot be read");
    return builder_.add_node(*id, {*x, *y, *z}, line_);
  }

  /// An element may take several lines, of which all but the last end in a comma.
  Result<void> take_element(std::string_view line) {
    const auto [count, corners] = nodes_of_type(keyword_.options["TYPE"]);
    if (count == 0) return {};
    for (const std::string_view field : at_commas(line)) {
      if (field.empty()) continue;
      const auto number = deck_integer(field);
      if (!number || *number < 1) return bad("cannot be read");
      rest_.push_back(*number);
    }
    if (Index(rest_.size()) < count + 1)
      return line.back() == ',' ? Result<void>{} : Result<void>(bad("has too few nodes"));
    std::array<Index, 4> nodes{no_index, no_index, no_index, no_index};
    for (int k = 0; k < corners; ++k) nodes[k] = rest_[k + 1];
    builder_.add_shell(0, nodes, line_);
    ids_.push_back(rest_[0]);
    sets_.push_back(keyword_.options["ELSET"]);
    rest_.clear();
    return {};
  }

  Result<void> take_set(std::string_view line) {
    const auto f = at_commas(line);
    const std::string& name = keyword_.options["ELSET"];
    if (keyword_.options.contains("GENERATE")) {
      const auto first = deck_integer(f[0]), last = deck_integer(f.size() > 1 ? f[1] : "", first),
                 step = deck_integer(f.size() > 2 ? f[2] : "", 1);
      if (!first || !last || !step || *step < 1) return bad("cannot be read");
      members_[name].ranges.push_back({*first, *last, *step});
      return {};
    }
    for (const std::string_view field : f) {
      if (const auto id = deck_integer(field))
        members_[name].ranges.push_back({*id, *id, 1});
      else if (!field.empty())
        members_[name].sets.push_back(upper_case(field));
    }
    return {};
  }

  struct Members {
    std::vector<std::array<Index, 3>> ranges;  ///< first, last, step
    std::vector<std::string> sets;
  };

  struct Section {
    std::string set;
    double thickness;
    std::string material;
  };

  /// Elements of the section's set, whether it was named with the elements or lists them.
  void give_properties() {
    auto& properties = builder_.deck().properties;
    std::multimap<Index, size_t> row;
    for (size_t e = 0; e < ids_.size(); ++e) row.emplace(ids_[e], e);
    Index number = 0;
    for (const Section& section : sections_) {
      builder_.add_property({++number, section.set, section.thickness, 0});
      std::set<std::string> seen;
      give(section.set, number, row, seen);
    }
    std::map<std::string, Index> of_set;
    for (size_t e = 0; e < ids_.size(); ++e) {
      if (properties[e] != 0) continue;
      const auto [found, is_new] = of_set.try_emplace(sets_[e], number + 1);
      if (is_new) builder_.add_property({++number, sets_[e], 0, 0});
      properties[e] = found->second;
    }
  }

  void give(const std::string& set, Index number, const std::multimap<Index, size_t>& row,
            std::set<std::string>& seen) {
    if (set.empty() || !seen.insert(set).second) return;
    auto& properties = builder_.deck().properties;
    for (size_t e = 0; e < sets_.size(); ++e)
      if (sets_[e] == set) properties[e] = number;
    const auto found = members_.find(set);
    if (found == members_.end()) return;
    for (const auto& [first, last, step] : found->second.ranges)
      for (auto at = row.lower_bound(first); at != row.end() && at->first <= last; ++at)
        if ((at->first - first) % step == 0) properties[at->second] = number;
    for (const std::string& other : found->second.sets) give(other, number, row, seen);
  }

  std::string_view text_;
  size_t at_ = 0;
  int line_ = 0;
  Keyword keyword_;
  bool first_data_ = false, in_instance_ = false;
  int instances_ = 0;
  std::vector<Index> rest_;  ///< of an element that goes on in the next line
  ShellDeckBuilder builder_;
  std::vector<Index> ids_;         ///< per shell
  std::vector<std::string> sets_;  ///< per shell: the set of its *ELEMENT
  std::map<std::string, Members> members_;
  std::vector<Section> sections_;
};

}  // namespace

Result<ShellDeck> parse_abaqus(std::string_view text) {
  return DeckReader(text).run();
}

}  // namespace beadmesh
