// Sheets with beads in them, for tests of whole panels.
#pragma once

#include <vector>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"

namespace beadmesh::shapes {

/// A rectangular sheet about the origin with beads; every bead is a face, and what a ring holds inside is
/// another sheet.
class BeadPlate {
 public:
  explicit BeadPlate(double length, double width, const Base& base = flat_base)
      : length_(length), width_(width), plan_(base, 1.5) {}

  /// Returns the bead's face.
  Index add(const Footprint& footprint, double height) {
    const auto loops = plan_.add_bead(footprint, height);
    holes_.push_back(loops[0]);
    islands_.insert(islands_.end(), loops.begin() + 1, loops.end());
    return faces_++;
  }

  /// A ring inside the innermost island so far, sharing its loop.
  Index add_ring_inside(Vec2 centre, double radius, double width, double height) {
    const int outer = islands_.back();
    const auto inner_loop = examples::placed(examples::circle(radius - width), centre, 0);
    const auto outer_loop = examples::placed(examples::circle(radius), centre, 0);
    islands_.back() = plan_.add_loop(points_of(inner_loop, 1.5));
    plan_.add_face(outer, {islands_.back()},
                   raised({outer_loop, examples::reversed(inner_loop)}, width / 2, height, plan_.base()));
    return faces_++;
  }

  Panel take() {
    for (const int island : islands_) plan_.add_face(island, {}, on(plan_.base()), 5);
    std::vector<Vec2> corners{{-length_ / 2, -width_ / 2},
                              {length_ / 2, -width_ / 2},
                              {length_ / 2, width_ / 2},
                              {-length_ / 2, width_ / 2}};
    std::vector<Vec2> points;
    std::vector<Index> breaks;
    for (int k = 0; k < 4; ++k) {
      breaks.push_back(Index(points.size()));
      const int n = int(distance(corners[k], corners[(k + 1) % 4]) / 5);
      for (int i = 0; i < n; ++i) points.push_back(lerp(corners[k], corners[(k + 1) % 4], double(i) / n));
    }
    plan_.add_face(plan_.add_loop(points, breaks), holes_, on(plan_.base()), 5);
    return plan_.take();
  }

 private:
  double length_, width_;
  PlanPanel plan_;
  std::vector<int> holes_, islands_;
  Index faces_ = 0;
};

/// An I, a T and a ring on a gently curved sheet: faces 0 to 2, then the sheet in the ring, then the sheet
/// around.
inline Panel plate_of_every_kind() {
  BeadPlate plate(240, 150, cylinder_base(900));
  plate.add(placed(examples::straight_bead(80, 16), {-60, 50}, 0), 5);
  plate.add(placed(t_footprint(16, 100, 50), {-55, -5}, 0), 5);
  plate.add(placed(examples::circular_ring(40, 14), {60, 0}, 0), -5);
  return plate.take();
}

}  // namespace beadmesh::shapes
