// Do the features of a panel keep clear of each other?
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// Least distance between two loops; 0 where they coincide.
inline double clearance(const PlanLoop& a, const PlanLoop& b) {
  const BoundaryDistance to_b({b});
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 p : sampled(a)) least = std::min(least, std::abs(to_b(p)));
  return least;
}

inline bool coincide(const PlanLoop& a, const PlanLoop& b) {
  return a.size() == b.size() && distance(a.front().centre, b.front().centre) < 1e-9 &&
         std::abs(a.front().radius - b.front().radius) < 1e-9;
}

/// Every loop at least 5 mm from the outline and from all others that it is not shared with.
inline void expect_clear(const PanelDesign& panel, const std::string& name) {
  for (std::size_t i = 0; i < panel.features.size(); ++i)
    for (const PlanLoop& loop : panel.features[i].loops()) {
      EXPECT_GT(clearance(loop, panel.outline()), 5) << name << " feature " << i;
      for (std::size_t j = 0; j < i; ++j)
        for (const PlanLoop& other : panel.features[j].loops()) {
          if (coincide(loop, other)) continue;
          EXPECT_GT(clearance(loop, other), 5) << name << " features " << i << ", " << j;
        }
    }
}

}  // namespace beadmesh::examples
