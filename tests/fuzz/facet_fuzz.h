// What the fuzzers of facet and deck readers ask of any bytes: a sound result, or an error that says why.
#pragma once

#include <cmath>
#include <cstdlib>

#include "beadmesh/read/facet_skin.h"
#include "beadmesh/read/shell_deck.h"
#include "fuzz_input.h"

namespace beadmesh::fuzz {

inline void expect_reason(const Diagnostic& error) {
  if (error.code.empty() || error.message.empty()) std::abort();
}

/// Facets become a sound panel; corners that are far off or not finite are refused by the caller.
inline int check_facets(const Result<LooseFacets>& facets) {
  if (!facets) return expect_reason(facets.error()), 0;
  for (const auto& corners : facets->corners)
    for (const Vec3 p : corners)
      if (!(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1e12)) return 0;
  expect_none(verify_panel(panel_of_facets(*facets, radians(40))));
  return 0;
}

/// Shells have their nodes and properties.
inline int check_deck(const Result<ShellDeck>& deck) {
  if (!deck) return expect_reason(deck.error()), 0;
  if (deck->elements.empty() || deck->properties.size() != deck->elements.size()) std::abort();
  for (const auto& shell : deck->elements)
    for (const Index node : shell)
      if (node < no_index || node >= Index(deck->points.size())) std::abort();
  return 0;
}

}  // namespace beadmesh::fuzz
