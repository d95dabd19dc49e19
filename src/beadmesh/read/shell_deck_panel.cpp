#include "beadmesh/read/shell_deck_panel.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "beadmesh/read/facet_skin.h"
#include "beadmesh/read/input_file.h"
#include "beadmesh/read/shell_deck_file.h"

namespace beadmesh {
namespace {

/// Parts in the order in which the shells first name them.
class PartList {
 public:
  explicit PartList(const ShellDeck& deck) {
    for (const DeckProperty& card : deck.property_cards) cards_.try_emplace(card.id, &card);
  }

  Index number_of(Index property) {
    const auto [found, is_new] = number_.try_emplace(property, Index(parts.size()));
    if (is_new) {
      const auto card = cards_.find(property);
      parts.push_back({card == cards_.end() ? "" : card->second->name, property, {}});
      thicknesses.push_back(card == cards_.end() ? 0 : card->second->thickness);
    }
    return found->second;
  }

  std::vector<PanelPart> parts;
  std::vector<double> thicknesses;

 private:
  std::map<Index, const DeckProperty*> cards_;
  std::map<Index, Index> number_;
};

/// Corners of the triangles that a shell is cut into; none where it has fewer than three.
std::vector<std::array<Index, 3>> triangles_of(const ShellDeck& deck, const std::array<Index, 4>& shell) {
  std::vector<Index> v;
  for (const Index node : shell)
    if (node != no_index && std::find(v.begin(), v.end(), node) == v.end()) v.push_back(node);
  if (v.size() < 3) return {};
  if (v.size() == 3) return {{v[0], v[1], v[2]}};
  const auto& p = deck.points;
  if (distance(p[v[0]], p[v[2]]) <= distance(p[v[1]], p[v[3]]))
    return {{v[0], v[1], v[2]}, {v[0], v[2], v[3]}};
  return {{v[0], v[1], v[3]}, {v[1], v[2], v[3]}};
}

}  // namespace

Result<Panel> panel_of_shells(const ShellDeck& deck, const std::string& name, const ReadOptions& options) {
  const std::optional<double> factor = millimetres_per(options.unit);
  if (!factor)
    return fail("read.unit", "the unit '" + options.unit + "' is unknown", "use mm, cm, m, um, in or ft",
                name);
  PartList parts(deck);
  LooseFacets facets;
  for (size_t e = 0; e < deck.elements.size(); ++e)
    for (const auto& [a, b, c] : triangles_of(deck, deck.elements[e])) {
      facets.corners.push_back(
          {deck.points[a] * *factor, deck.points[b] * *factor, deck.points[c] * *factor});
      facets.parts.push_back(parts.number_of(deck.properties[e]));
    }
  Panel panel = panel_of_facets(facets, options.feature_angle);
  if (panel.faces.empty()) return fail("read.no_faces", "the file has no shells", {}, name);
  panel.input = name;
  panel.unit = options.unit;
  panel.parts = std::move(parts.parts);
  for (PanelFace& face : panel.faces) face.thickness = parts.thicknesses[face.part] * *factor;
  return panel;
}

Result<Panel> read_shell_panel(const std::filesystem::path& path, const ReadOptions& options) {
  const auto deck = read_shell_deck(path);
  if (!deck) return tl::make_unexpected(deck.error());
  return panel_of_shells(*deck, path.filename().string(), options);
}

}  // namespace beadmesh
