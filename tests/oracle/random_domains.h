// Domains on which our results are compared with other libraries'; the same on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::oracle {

struct NamedRegion {
  std::string name;
  PlanarRegion region;
};

/// A small generator of our own.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2654435769u + 1) {}
  /// In [low, high).
  double between(double low, double high) { return low + (high - low) * fraction(); }
  int below(int end) { return static_cast<int>(fraction() * end); }

 private:
  double fraction() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) / 9007199254740992.0;
  }
  std::uint64_t state_;
};

/// A star-shaped outline of `corners` corners with up to three star-shaped holes.
PlanarRegion random_region(std::uint64_t seed, int corners);
/// Right angles, equal lengths and points in a row: many ties.
PlanarRegion random_skyline(std::uint64_t seed, int columns);
/// L, T, comb and a plate with holes, all of straight lines and sharp corners.
std::vector<NamedRegion> letters();

/// Turned, and stretched to whole coordinates up to 2^bits.
PlanarRegion on_grid(const PlanarRegion& region, double angle, int bits);

}  // namespace beadmesh::oracle
