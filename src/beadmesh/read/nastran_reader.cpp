#include "beadmesh/read/nastran_reader.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <unordered_map>

namespace beadmesh {
namespace {

/// A bulk data card with its continuations; fields without the name, blanks cut off.
struct Card {
  std::string name;
  std::vector<std::string_view> fields;
  int line = 0;
};

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::toupper(c); });
  return result;
}

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

/// "12", blank: `otherwise`.
std::optional<Index> integer(std::string_view text, std::optional<Index> otherwise = std::nullopt) {
  if (text.empty()) return otherwise;
  if (text.front() == '+') text.remove_prefix(1);
  Index value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "1.5", "1.5E+2", "1.5D2", "1.5+2"; blank is 0.
std::optional<double> real(std::string_view text) {
  if (text.empty()) return 0.0;
  std::string plain;
  for (size_t i = text.front() == '+' ? 1 : 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool after_exponent = !plain.empty() && plain.back() == 'e';
    if (c == 'e' || c == 'E' || c == 'd' || c == 'D') {
      plain += 'e';
    } else if ((c == '+' || c == '-') && !plain.empty()) {
      if (!after_exponent) plain += 'e';
      if (c == '-') plain += '-';
    } else {
      plain += c;
    }
  }
  double value = 0;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (error != std::errc() || end != plain.data() + plain.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string at_line(int line) {
  return "line " + std::to_string(line);
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
    if (card.name == "INCLUDE")
      return fail("read.nastran.include", "INCLUDE is not followed", "put the deck into one file",
                  at_line(card.line));
    return {};
  }

  /// Node ids become indices.
  Result<ShellDeck> deck() {
    if (deck_.elements.empty())
      return fail("read.nastran.empty", "the deck has no shells", "CQUAD4 and CTRIA3 are read");
    for (size_t e = 0; e < deck_.elements.size(); ++e)
      for (Index& node : deck_.elements[e]) {
        if (node == no_index) continue;
        const auto found = row_.find(node);
        if (found == row_.end())
          return fail("read.nastran.node", "node " + std::to_string(node) + " of a shell is not in the deck",
                      "", at_line(lines_[e]));
        node = found->second;
      }
    return std::move(deck_);
  }

 private:
  Result<void> take_node(const Card& card) {
    if (card.fields.size() < 5) return bad_card(card, "is too short");
    const auto id = integer(card.fields[0]), system = integer(card.fields[1], 0);
    const auto x = real(card.fields[2]), y = real(card.fields[3]), z = real(card.fields[4]);
    if (!id || *id < 1 || !system || !x || !y || !z) return bad_card(card, "cannot be read");
    if (*system != 0)
      return fail("read.nastran.system",
                  "node " + std::to_string(*id) + " lies in coordinate system " + std::to_string(*system),
                  "export in the basic system", at_line(card.line));
    if (!row_.emplace(*id, static_cast<Index>(deck_.points.size())).second)
      return fail("read.nastran.node", "node " + std::to_string(*id) + " is defined twice", "",
                  at_line(card.line));
    deck_.points.push_back({*x, *y, *z});
    deck_.node_ids.push_back(*id);
    return {};
  }

  Result<void> take_shell(const Card& card, size_t corners) {
    if (card.fields.size() < 2 + corners) return bad_card(card, "is too short");
    const auto id = integer(card.fields[0]), property = integer(card.fields[1], integer(card.fields[0]));
    if (!id || !property) return bad_card(card, "cannot be read");
    std::array<Index, 4> nodes{no_index, no_index, no_index, no_index};
    for (size_t k = 0; k < corners; ++k) {
      const auto node = integer(card.fields[2 + k]);
      if (!node || *node < 1) return bad_card(card, "cannot be read");
      nodes[k] = *node;
    }
    deck_.elements.push_back(nodes);
    deck_.properties.push_back(*property);
    lines_.push_back(card.line);
    return {};
  }

  ShellDeck deck_;
  std::unordered_map<Index, Index> row_;
  std::vector<int> lines_;
};

/// Executive and case control are passed over where there are any.
size_t start_of_bulk(std::string_view text) {
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    if (upper(trimmed(text.substr(at, end - at))).rfind("BEGIN", 0) == 0) return end;
    at = end + 1;
  }
  return 0;
}

std::string extension_of(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
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
    const std::string name = upper(head.substr(0, std::min(head.find('*'), head.find(' '))));
    card = {name, std::move(fields), line_number};
    if (name == "ENDDATA") break;
  }
  if (auto taken = builder.take(card); !taken) return tl::make_unexpected(taken.error());
  return builder.deck();
}

Result<ShellDeck> read_nastran(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return fail("read.not_found", "there is no such file", "", path.string());
  if (std::filesystem::is_directory(path, error))
    return fail("read.directory", "is a folder", "give a file", path.string());
  const std::string extension = extension_of(path);
  if (extension != ".bdf" && extension != ".nas" && extension != ".dat")
    return fail("read.ending", extension.empty() ? "has no ending" : "unknown ending " + extension,
                "known: .bdf .nas .dat", path.string());
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) return fail("read.unreadable", "the file cannot be read", "", path.string());
  auto deck = parse_nastran(text);
  if (!deck) {
    Diagnostic problem = deck.error();
    problem.entity = path.string() + (problem.entity.empty() ? "" : ", " + problem.entity);
    return tl::make_unexpected(std::move(problem));
  }
  return deck;
}

}  // namespace beadmesh
