// How the bytes of a fuzzer become points, loops and regions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::fuzz {

/// Reads from the front; zeros after the end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  bool empty() const { return left_ == 0; }
  int byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  /// In [-128, 127].
  int signed_byte() { return static_cast<std::int8_t>(byte()); }
  /// In [0, 1].
  double fraction() { return (byte() * 256 + byte()) / 65535.0; }
  /// Any bit pattern: NaN, infinities and denormals too.
  double any_double();

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

struct PointsAndLoops {
  std::vector<Vec2> points;
  std::vector<std::vector<Index>> loops;
};

/// Points on a small grid, on a fine one, or anything at all; loops whose indices may be wrong.
PointsAndLoops points_and_loops(Bytes& bytes);

/// An outline and up to three holes, at most about 200 points; not checked.
PlanarRegion region(Bytes& bytes);

/// Prints the violations and aborts where there are any.
void expect_none(const std::vector<std::string>& violations);

}  // namespace beadmesh::fuzz
