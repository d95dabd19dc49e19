// Inside the read room: nodes and shells as a deck's reader meets them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/read/shell_deck.h"

namespace beadmesh {

/// "line 12".
std::string at_line(int line);

/// Blanks at both ends cut off.
std::string_view trimmed(std::string_view text);
std::string upper_case(std::string_view text);

/// "12", "+12"; blank: `otherwise`. None where it is no number that fits.
std::optional<Index> deck_integer(std::string_view text, std::optional<Index> otherwise = std::nullopt);

/// "1.5", "1.5E+2", "1.5D2", "1.5+2"; blank is 0. None where it is no finite number.
std::optional<double> deck_real(std::string_view text);

/// Collects in any order; ids become indices at the end. Fails with `prefix`.node where a node is missing or
/// defined twice, with `prefix`.empty where there are no shells.
class ShellDeckBuilder {
 public:
  explicit ShellDeckBuilder(std::string prefix) : prefix_(std::move(prefix)) {}

  Result<void> add_node(Index id, Vec3 point, int line);
  /// Ids of its nodes; the fourth of a triangle is no_index. `id` 0: its position from 1.
  void add_shell(Index property, std::array<Index, 4> nodes, int line, Index id = 0);
  void add_property(DeckProperty property) { deck_.property_cards.push_back(std::move(property)); }
  ShellDeck& deck() { return deck_; }

  Result<ShellDeck> finish(const char* which_are_read);

 private:
  std::string prefix_;
  ShellDeck deck_;
  std::unordered_map<Index, Index> row_;
  std::vector<int> lines_;
};

}  // namespace beadmesh
