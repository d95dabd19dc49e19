// Inside the read room: points of space that each claim a ball around them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// Points filed by the size wanted around them; answers whether a ball is free. Expects sizes that vary
/// slowly in space.
class PointHash {
 public:
  void insert(Vec3 point, double size);
  /// Is there no point within `radius`, where the wanted size is `size`?
  bool is_free(Vec3 centre, double radius, double size) const;

 private:
  struct Item {
    Vec3 point;
    Index next;
  };
  /// Cells of one edge length, chained in a table.
  struct Level {
    double cell = 1;
    std::vector<Index> heads = std::vector<Index>(64, no_index);
    std::vector<Item> items;
    std::size_t slot(std::int64_t i, std::int64_t j, std::int64_t k) const;
    std::size_t slot(Vec3 p) const;
    void insert(Vec3 p);
    void grow();
    bool is_free(Vec3 centre, double radius) const;
  };
  std::map<int, Level> levels_;  // by exponent of two
};

}  // namespace beadmesh
