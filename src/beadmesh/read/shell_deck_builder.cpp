#include "beadmesh/read/shell_deck_builder.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace beadmesh {

std::string at_line(int line) {
  return "line " + std::to_string(line);
}

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::toupper(c); });
  return result;
}

std::optional<Index> deck_integer(std::string_view text, std::optional<Index> otherwise) {
  if (text.empty()) return otherwise;
  if (text.front() == '+') text.remove_prefix(1);
  Index value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> deck_real(std::string_view text) {
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

Result<void> ShellDeckBuilder::add_node(Index id, Vec3 point, int line) {
  if (!row_.emplace(id, static_cast<Index>(deck_.points.size())).second)
    return fail(prefix_ + ".node", "node " + std::to_string(id) + " is defined twice", "", at_line(line));
  deck_.points.push_back(point);
  deck_.node_ids.push_back(id);
  return {};
}

void ShellDeckBuilder::add_shell(Index property, std::array<Index, 4> nodes, int line, Index id) {
  deck_.elements.push_back(nodes);
  deck_.element_ids.push_back(id > 0 ? id : Index(deck_.elements.size()));
  deck_.properties.push_back(property);
  lines_.push_back(line);
}

Result<ShellDeck> ShellDeckBuilder::finish(const char* which_are_read) {
  if (deck_.elements.empty()) return fail(prefix_ + ".empty", "the deck has no shells", which_are_read);
  for (size_t e = 0; e < deck_.elements.size(); ++e)
    for (Index& node : deck_.elements[e]) {
      if (node == no_index) continue;
      const auto found = row_.find(node);
      if (found == row_.end())
        return fail(prefix_ + ".node", "node " + std::to_string(node) + " of a shell is not in the deck", "",
                    at_line(lines_[e]));
      node = found->second;
    }
  return std::move(deck_);
}

}  // namespace beadmesh
