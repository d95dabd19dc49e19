// Random numbers that are the same with every compiler and library.
#pragma once

#include <cstdint>

namespace beadmesh::examples {

/// SplitMix64 (Steele, Lea, Flood, 2014). Unlike the distributions of the standard library, between() is
/// specified to the last bit.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// In [low, high).
  double between(double low, double high) { return low + (high - low) * (double(next() >> 11) * 0x1p-53); }
  /// In [0, count).
  int below(int count) { return int(between(0, count)); }

 private:
  std::uint64_t state_;
};

}  // namespace beadmesh::examples
