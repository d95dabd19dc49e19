#include "examples/shape_catalogue.h"

#include "examples/skeletons.h"

namespace beadmesh::examples {
namespace {

using Footprints = std::vector<Footprint>;

Footprints corrugated_rings(double outer_radius, double width, int rings) {
  Footprints result;
  for (int i = 0; i < rings; ++i) result.push_back(circular_ring(outer_radius - i * width, width));
  return result;
}

/// One arm, or two ends and no junction.
std::vector<CatalogueShape> arms() {
  return {
      {"straight", "I", "I",
       [](double w, double a, double) -> Footprints { return {straight_bead(6 * w * a, w)}; }},
      {"tapered", "I", "I",
       [](double w, double a, double) -> Footprints { return {taper(6 * w * a, 1.25 * w, 0.75 * w)}; }},
      {"arc", "arc", "I",
       [](double w, double a, double) -> Footprints { return {arc_bead(4 * w * a, 80, w)}; }},
      {"S", "S", "I",
       [](double w, double a, double b) -> Footprints { return {s_bead(3 * w * a, 75 * b, w)}; }},
      {"wavy", "S", "I",
       [](double w, double a, double) -> Footprints { return {wavy_bead(2.5 * w * a, 90, 2, w)}; }},
      {"L", "L", "I",
       [](double w, double a, double b) -> Footprints {
         return {l_bead(3.2 * w * a, 3.2 * w * b, 1.2 * w, 90, w)};
       }},
      {"J", "J", "I",
       [](double w, double a, double) -> Footprints {
         return {l_bead(4 * w * a, 0.8 * w, 1.3 * w, 150, w)};
       }},
      {"U", "U", "I",
       [](double w, double a, double) -> Footprints {
         const double leg = 3.4 * w * a;
         return {l_bead(leg, leg, 1.4 * w, 180, w)};
       }},
      {"G", "G", "I",
       [](double w, double a, double) -> Footprints { return {g_bead(2.5 * w * a, 1.2 * w, w)}; }},
  };
}

std::vector<CatalogueShape> junctions() {
  return {
      {"T", "T", "generic",
       [](double w, double a, double b) -> Footprints {
         return {t_bead(7 * w * a, 3.6 * w * b, w, 0.6 * w)};
       }},
      {"Y", "Y", "generic",
       [](double w, double a, double) -> Footprints { return {y_bead(3.4 * w * a, w, 0.6 * w)}; }},
      {"X", "X", "generic",
       [](double w, double a, double b) -> Footprints { return {x_bead(7 * w * a, 75 * b, w, 0.6 * w)}; }},
      {"H", "H", "generic",
       [](double w, double a, double b) -> Footprints {
         return {h_bead(6.4 * w * a, 3.8 * w * b, w, 0.6 * w)};
       }},
      {"F", "F", "generic",
       [](double w, double a, double b) -> Footprints {
         return {f_bead(7.2 * w * a, 3.4 * w * b, w, 0.6 * w)};
       }},
      {"trident", "trident", "generic",
       [](double w, double a, double b) -> Footprints {
         return {trident_bead(5.6 * w * a, 3 * w * b, 3.2 * w * b, w, 0.6 * w)};
       }},
      {"comb", "comb", "generic",
       [](double w, double a, double b) -> Footprints {
         return {comb_bead(3, 3 * w * a, 3.6 * w * b, w, 0.6 * w)};
       }},
      {"curved-comb", "comb", "generic",
       [](double w, double a, double b) -> Footprints {
         return {curved_comb_bead(3, 7 * w * a, 24, 3.4 * w * b, w, 0.6 * w)};
       }},
      {"ladder", "ladder", "generic",
       [](double w, double a, double b) -> Footprints {
         return {ladder_bead(2, 3.6 * w * a, 3.6 * w * b, w, 0.6 * w)};
       }},
      {"ladder-of-two", "ladder", "",
       [](double w, double a, double b) -> Footprints {
         return {ladder_bead(3, 3.2 * w * a, 3.6 * w * b, w, 0.6 * w)};
       }},
      {"tree", "tree", "generic",
       [](double w, double a, double b) -> Footprints {
         return {tree_bead(3.6 * w * a, 3.8 * w * b, 3 * w * b, w, 0.6 * w)};
       }},
  };
}

std::vector<CatalogueShape> rings() {
  return {
      {"circle", "ring", "annular",
       [](double w, double a, double) -> Footprints { return {circular_ring(3.2 * w * a, w)}; }},
      {"oval", "ring", "annular",
       [](double w, double a, double) -> Footprints { return {rounded_ring(9 * w * a, 5 * w, 2.5 * w, w)}; }},
      {"rectangle", "ring", "annular",
       [](double w, double a, double b) -> Footprints {
         return {rounded_ring(8 * w * a, 6.5 * w * b, 1.8 * w, w)};
       }},
      {"eccentric", "ring", "annular",
       [](double w, double a, double) -> Footprints { return {eccentric_ring(3.4 * w * a, w, 0.25 * w)}; }},
      {"circle-in-oval", "ring", "annular",
       [](double w, double a, double) -> Footprints {
         const double height = 6 * w * a;
         return {oval_with_round_window(height + 0.8 * w, height, w)};
       }},
      {"corrugated", "ring", "annular",
       [](double w, double a, double) -> Footprints { return corrugated_rings(5 * w * a, w, 3); }},
  };
}

}  // namespace

const std::vector<CatalogueShape>& shape_catalogue() {
  static const std::vector<CatalogueShape> all = [] {
    std::vector<CatalogueShape> shapes = arms();
    for (const auto& more : {junctions(), rings()}) shapes.insert(shapes.end(), more.begin(), more.end());
    return shapes;
  }();
  return all;
}

}  // namespace beadmesh::examples
