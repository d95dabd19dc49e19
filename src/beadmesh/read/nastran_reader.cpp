#include "beadmesh/read/nastran_reader.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "beadmesh/read/shell_deck_builder.h"

namespace beadmesh {
namespace {

/// A bulk data card with its continuations; fields without the name, blanks cut off.
struct Card {
  std::string name;
  std::vector<std::string_view> fields;
  int line = 0;
};

/// The first field apart, the data fields of the line appended; the last column (continuation mark) is left
/// out.
std::string_view split(std::string_view line, std::vector<std::string_view>& fields) {
  const auto column = [&](size_t at, size_t width) {
    return at < line.size() ? trimmed(line.substr(at, width)) : std::string_view{};
  };
  if (line.find(',') != std::string_view::npos) {
    const size_t comma = line.find(',');
    std::string_view rest = line.substr(comma + 1);
    const bool large = trimmed(line.substr(0, comma)).find('*') != std::string_view::npos;
    for (int k = 0; k < (large ? 4 : 8); ++k) {
      const size_t next = rest.find(',');
      fields.push_back(trimmed(rest.substr(0, next)));
      rest = next == std::string_view::npos ? std::string_view{} : rest.substr(next + 1);
    }
    return trimmed(line.substr(0, comma));
  }
  const std::string_view head = column(0, 8);
  const bool large = head.find('*') != std::string_view::npos;
  for (size_t k = 0; k < (large ? 4 : 8); ++k)
    fields.push_back(large ? column(8 + 16 * k, 16) : column(8 + 8 * k, 8));
  return head;
}

bool continues(std::string_view head) {
  return head.empty() || head.front() == '+' || head.front() == '*';
}

Failure bad_card(const Card& card, const char* what) {
  return fail("read.nastran.card", card.name + " " + what, "", at_line(card.line));
}

class DeckBuilder {
 public:
  Result<void> take(const Card& card) {
    if (card.name == "GRID") return take_node(card);
    if (card.name == "CQUAD4" || card.name == "CQUADR") return take_shell(card, 4);
    if (card.name == "CTRIA3" || card.name == "CTRIAR") return take_shell(card, 3);
    if (card.name == "PSHELL") return take_property(card);
    if (card.name == "INCLUDE")
      return fail("read.nastran.include", "INCLUDE is not followed", "put the deck into one file",
                  at_line(card.line));
    return {};
  }

  Result<ShellDeck> deck() { return builder_.finish("CQUAD4 and CTRIA3 are read"); }

 private:
  Result<void> take_node(const Card& card) {
    if (card.fields.size() < 5) return bad_card(card, "is too short");
    const auto id = deck_integer(card.fields[0]), system = deck_integer(card.fields[1], 0);
    const auto x = deck_real(card.fields[2]), y = deck_real(card.fields[3]), z = deck_real(card.fields[4]);
    if (!id || *id < 1 || !system || !x || !y || !z) return bad_card(card, "cannot be read");
    if (*system != 0)
      return fail("read.nastran.system",
                  "node " + std::to_string(*id) + " lies in coordinate system " + std::to_string(*system),
                  "export in the basic system", at_line(card.line));
    return builder_.add_node(*id, {*x, *y, *z}, card.line);
  }

  Result<void> take_shell(const Card& card, size_t corners) {
    if (card.fields.size() < 2 + corners) return bad_card(card, "is too short");
    const auto id = deck_integer(card.fields[0]),
               property = deck_integer(card.fields[1], deck_integer(card.fields[0]));
    if (!id || !property) return bad_card(card, "cannot be read");
    std::array<Index, 4> nodes{no_index, no_index, no_index, no_index};
    for (size_t k = 0; k < corners; ++k) {
      const auto node = deck_integer(card.fields[2 + k]);
      if (!node || *node < 1) return bad_card(card, "cannot be read");
      nodes[k] = *node;
    }
    builder_.add_shell(*property, nodes, card.line, *id);
    return {};
  }

  /// Shells of a property that cannot be read are still shells.
  Result<void> take_property(const Card& card) {
    const auto field = [&](size_t i) { return i < card.fields.size() ? card.fields[i] : std::string_view{}; };
    const auto id = deck_integer(field(0)), material = deck_integer(field(1), 0);
    const auto thickness = deck_real(field(2));
    if (id && material && thickness && *thickness >= 0)
      builder_.add_property({*id, {}, *thickness, *material});
    return {};
  }

  ShellDeckBuilder builder_{"read.nastran"};
};

/// Executive and case control are passed over where there are any.
size_t start_of_bulk(std::string_view text) {
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    if (upper_case(trimmed(text.substr(at, end - at))).rfind("BEGIN", 0) == 0) return end;
    at = end + 1;
  }
  return 0;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  constexpr std::string_view gaps = " \t\r,=";
  for (size_t at = text.find_first_not_of(gaps); at != std::string_view::npos;
       at = text.find_first_not_of(gaps, at)) {
    const size_t end = std::min(text.find_first_of(gaps, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

/// "12,15 THRU 20" after "SET 7 ="; none where it is anything else. A THRU of absurd length is nothing.
std::optional<std::vector<Index>> members_of(const std::vector<std::string_view>& words) {
  constexpr size_t most = 10'000'000;
  std::vector<Index> members;
  for (size_t i = 2; i < words.size(); ++i) {
    if (upper_case(words[i]) != "THRU") {
      const auto number = deck_integer(words[i]);
      if (!number) return std::nullopt;
      members.push_back(*number);
      continue;
    }
    const auto last = i + 1 < words.size() ? deck_integer(words[i + 1]) : std::nullopt;
    if (!last || members.empty() || *last < members.back() ||
        members.size() + size_t(*last - members.back()) > most)
      return std::nullopt;
    for (Index k = members.back() + 1; k <= *last; ++k) members.push_back(k);
    ++i;
  }
  return members;
}

/// SET entries; a line that ends in a comma goes on.
std::vector<DeckSet> sets_of(std::string_view control) {
  std::vector<DeckSet> sets;
  std::map<Index, std::string> names;
  std::string entry;
  const auto take = [&] {
    const auto words = words_of(entry);
    const auto id = words.size() > 2 && upper_case(words[0]) == "SET" ? deck_integer(words[1]) : std::nullopt;
    if (id)
      if (auto members = members_of(words)) sets.push_back({*id, names[*id], std::move(*members)});
    entry.clear();
  };
  for (size_t at = 0; at < control.size();) {
    const size_t end = std::min(control.find('\n', at), control.size());
    const std::string_view line = trimmed(control.substr(at, end - at));
    at = end + 1;
    const size_t colon = line.find(':');
    if (line.rfind("$ set ", 0) == 0 && colon != std::string_view::npos)
      if (const auto id = deck_integer(trimmed(line.substr(6, colon - 6))))
        names[*id] = trimmed(line.substr(colon + 1));
    if (line.empty() || line.front() == '$') continue;
    entry += line;
    if (line.back() != ',') take();
  }
  take();
  return sets;
}

}  // namespace

Result<ShellDeck> parse_nastran(std::string_view text) {
  const size_t start = start_of_bulk(text);
  int line_number = static_cast<int>(std::count(text.begin(), text.begin() + start, '\n'));
  if (start > 0) ++line_number;
  DeckBuilder builder;
  Card card;
  for (size_t at = start > 0 ? start + 1 : 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view whole = text.substr(at, end - at), line = whole.substr(0, whole.find('$'));
    at = end + 1;
    ++line_number;
    if (trimmed(line).empty()) continue;
    std::vector<std::string_view> fields;
    const std::string_view head = split(line, fields);
    if (continues(head)) {
      card.fields.insert(card.fields.end(), fields.begin(), fields.end());
      continue;
    }
    if (auto taken = builder.take(card); !taken) return tl::make_unexpected(taken.error());
    const std::string name = upper_case(head.substr(0, std::min(head.find('*'), head.find(' '))));
    card = {name, std::move(fields), line_number};
    if (name == "ENDDATA") break;
  }
  if (auto taken = builder.take(card); !taken) return tl::make_unexpected(taken.error());
  auto deck = builder.deck();
  if (deck) deck->sets = sets_of(text.substr(0, start));
  return deck;
}

}  // namespace beadmesh
