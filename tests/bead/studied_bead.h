// Single beads, studied as the pipeline does, and footprints for them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bead/plan_panel.h"
#include "beadmesh/bead/recognition.h"
#include "beadmesh/bead/skeleton.h"

namespace beadmesh::shapes {

struct StudiedBead {
  std::unique_ptr<FaceStudy> study;
  MedialObject medial;

  const SurfaceMap& map() const { return *study->map; }
  Skeleton skeleton() const { return skeleton_of(medial); }
};

inline StudiedBead studied_face(const Panel& panel, Index face) {
  auto study = study_faces(panel, {face});
  if (!study) throw std::runtime_error(study.error().message);
  auto medial = medial_object_of_bead((*study)->region);
  if (!medial) throw std::runtime_error(medial.error().message);
  return {std::move(*study), std::move(*medial)};
}

inline StudiedBead studied_bead(const Footprint& footprint, double height, const Base& base = flat_base,
                                Vec2 lean = {}, double spacing = 2) {
  PlanPanel plan(base, spacing);
  plan.add_bead(footprint, height, lean);
  return studied_face(plan.take(), 0);
}

/// The footprint turned about the origin by `angle`, then mirrored in the x axis if asked, then shifted.
inline Footprint placed(Footprint footprint, Vec2 origin, double angle, bool mirrored = false) {
  for (auto& loop : footprint.loops) {
    loop = examples::placed(loop, {0, 0}, angle);
    if (mirrored) {
      for (auto& edge : loop) {
        const auto flip = [](Vec2 p) { return Vec2{p.x, -p.y}; };
        edge.start = flip(edge.start), edge.end = flip(edge.end), edge.centre = flip(edge.centre);
        edge.start_angle = -edge.start_angle, edge.sweep = -edge.sweep;
      }
      loop = examples::reversed(loop);
    }
    loop = examples::placed(loop, origin, 0);
  }
  return footprint;
}

inline PlanarRegion region_of(const Footprint& footprint, double spacing = 2) {
  PlanarRegion region;
  for (const auto& loop : footprint.loops) {
    auto points = points_of(loop, spacing);
    std::vector<bool> corners(points.size(), false);
    region.loops.push_back({std::move(points), std::move(corners), {}});
  }
  return region;
}

inline MedialObject medial_of(const PlanarRegion& region) {
  auto medial = medial_object_of_bead(checked_region(region).value());
  if (!medial) throw std::runtime_error(medial.error().message);
  return *medial;
}

// ---------------------------------------------------------------- footprints with a junction at a known
// place

/// Bar along x through the origin, stem down from it.
inline Footprint t_footprint(double width = 16, double bar = 104, double stem = 62, double fillet = 9) {
  Footprint t = examples::network({{0, 0}, {-bar / 2, 0}, {bar / 2, 0}, {0, -stem}}, {{0, 1}, {0, 2}, {0, 3}},
                                  width, fillet);
  return placed(t, {0, -stem / 2}, 0);
}

/// Arms of one length at the given angles (degrees) about the origin.
inline Footprint star_footprint(const std::vector<double>& angles, double arm, double width, double fillet) {
  std::vector<Vec2> nodes{{0, 0}};
  std::vector<std::pair<int, int>> arms;
  double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
  for (double angle : angles) {
    const Vec2 tip{arm * std::cos(radians(angle)), arm * std::sin(radians(angle))};
    arms.emplace_back(0, static_cast<int>(nodes.size()));
    nodes.push_back(tip);
    low_x = std::min(low_x, tip.x), high_x = std::max(high_x, tip.x);
    low_y = std::min(low_y, tip.y), high_y = std::max(high_y, tip.y);
  }
  // network() centres the bounding box, whose caps stand out equally far on all sides.
  return placed(examples::network(nodes, arms, width, fillet), {(low_x + high_x) / 2, (low_y + high_y) / 2},
                0);
}

}  // namespace beadmesh::shapes
