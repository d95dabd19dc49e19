#include "beadmesh/bead/face_study.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "beadmesh/bead/plane_curves.h"
#include "beadmesh/flatten/cut_open.h"
#include "beadmesh/flatten/flat_region.h"

namespace beadmesh {
namespace {

/// Direction in which the boundary leaves its point i, forward or backward, on the exact curve where there is
/// one.
Vec3 boundary_direction(const Panel& panel, const EdgeUse& use, bool at_start) {
  const PanelEdge& edge = panel.edges[use.edge];
  const bool front = at_start != use.reversed;  // of the edge's own points
  const size_t n = edge.points.size();
  const Vec3 here = panel.points[front ? edge.points.front() : edge.points.back()];
  if (edge.curve && edge.parameters.size() == n) {
    const double t0 = front ? edge.parameters.front() : edge.parameters.back();
    const double t1 = front ? edge.parameters[1] : edge.parameters[n - 2];
    // The curve's own direction: its end may lie beside the point, where a gap was sewn.
    const SpaceCurvePoint near = edge.curve->at(t0 + 0.02 * (t1 - t0));
    if (norm(near.velocity) > 0) return normalized(near.velocity * (t1 > t0 ? 1.0 : -1.0));
  }
  return normalized(panel.points[front ? edge.points[1] : edge.points[n - 2]] - here);
}

/// Turn of the loop at the joint between two uses, radians.
double joint_angle(const Panel& panel, const EdgeUse& before, const EdgeUse& after) {
  return angle_between(-boundary_direction(panel, before, false), boundary_direction(panel, after, true));
}

/// A single face knows its edges: joints are where two of them meet.
std::vector<std::vector<double>> joints_of_face(const Panel& panel, const PanelFace& face) {
  std::vector<std::vector<double>> angles;
  for (size_t l = 0; l < face.loops.size(); ++l) {
    const auto& uses = face.loops[l];
    std::vector<double> of_loop(face.facets.loops[l].size(), 0);
    size_t at = 0;
    for (size_t u = 0; u < uses.size(); ++u) {
      const EdgeUse& before = uses[(u + uses.size() - 1) % uses.size()];
      if (at < of_loop.size()) of_loop[at] = joint_angle(panel, before, uses[u]);
      at += panel.edges[uses[u].edge].points.size() - 1;
    }
    angles.push_back(std::move(of_loop));
  }
  return angles;
}

/// Turns of loops that were sewn up or cut: a joint is where the runs before and behind are not neighbours on
/// one edge; at a cut the plane image decides.
class OpenedJoints {
 public:
  OpenedJoints(const Panel& panel, const PanelFace& face) : panel_(panel) {
    for (const auto& loop : face.loops)
      for (const EdgeUse& use : loop) add(use);
  }

  std::vector<double> of_loop(const Facets& facets, const FlatFace& flat,
                              const std::vector<Index>& loop) const {
    const size_t n = loop.size();
    std::vector<double> angles;
    for (size_t i = 0; i < n; ++i) {
      const Index before = loop[(i + n - 1) % n], here = loop[i], after = loop[(i + 1) % n];
      const auto in = find(facets, before, here), out = find(facets, here, after);
      if (in && out)
        angles.push_back(in->use == out->use && in->step + 1 == out->step
                             ? 0
                             : joint_angle(panel_, uses_[in->use], uses_[out->use]));
      else
        angles.push_back(angle_between(flat.positions[here] - flat.positions[before],
                                       flat.positions[after] - flat.positions[here]));
    }
    return angles;
  }

  /// The edge under the segment of the boundary from one vertex to the next.
  std::optional<EdgeSegment> segment(const Facets& facets, Index from, Index to) const {
    const auto run = find(facets, from, to);
    if (!run) return std::nullopt;
    const EdgeUse& use = uses_[run->use];
    const auto last = static_cast<Index>(panel_.edges[use.edge].points.size()) - 2;
    return EdgeSegment{use.edge, use.reversed ? last - run->step : run->step, use.reversed};
  }

 private:
  struct Run {
    Index use, step;
  };

  void add(const EdgeUse& use) {
    std::vector<Index> points = panel_.edges[use.edge].points;
    if (use.reversed) std::reverse(points.begin(), points.end());
    for (size_t k = 0; k + 1 < points.size(); ++k)
      runs_.try_emplace({points[k], points[k + 1]}, Run{Index(uses_.size()), Index(k)});
    uses_.push_back(use);
  }

  std::optional<Run> find(const Facets& facets, Index from, Index to) const {
    const auto run = runs_.find({facets.panel_points[from], facets.panel_points[to]});
    return run == runs_.end() ? std::nullopt : std::optional<Run>(run->second);
  }

  const Panel& panel_;
  std::vector<EdgeUse> uses_;
  std::map<std::pair<Index, Index>, Run> runs_;  // by the panel points of a segment
};

std::vector<std::vector<bool>> corners_over(const std::vector<std::vector<double>>& angles, double limit) {
  std::vector<std::vector<bool>> corners;
  for (const auto& loop : angles) {
    std::vector<bool> of_loop;
    for (double angle : loop) of_loop.push_back(angle > limit);
    corners.push_back(std::move(of_loop));
  }
  return corners;
}

}  // namespace

Vec3 FaceStudy::lift(Vec2 flat_point) const {
  return map->surface_point(map->locate(flat_point));
}

Result<std::unique_ptr<FaceStudy>> study_faces(const Panel& panel, const std::vector<Index>& faces,
                                               double corner_angle) {
  auto study = std::make_unique<FaceStudy>();
  study->faces = faces;
  study->facets = facets_of(panel, faces);
  auto flat = flatten(study->facets);
  if (!flat) return tl::unexpected(flat.error());
  study->flat = std::move(*flat);
  study->map = std::make_unique<SurfaceMap>(study->facets, study->flat);
  if (faces.size() == 1)
    study->joint_angles = joints_of_face(panel, panel.faces[faces[0]]);
  else
    for (const auto& loop : study->facets.loops) study->joint_angles.emplace_back(loop.size(), 0.0);
  study->region = flat_region(study->facets, study->flat, corners_over(study->joint_angles, corner_angle));
  return study;
}

Result<std::unique_ptr<FaceStudy>> study_opened_face(const Panel& panel, Index face, double corner_angle) {
  auto opened = lay_open(panel.faces[face].facets);
  if (!opened) return tl::unexpected(opened.error());
  auto study = std::make_unique<FaceStudy>();
  study->faces = {face};
  study->facets = std::move(opened->facets);
  study->flat = std::move(opened->flat);
  study->cut_sides = std::move(opened->cut_sides);
  study->map = std::make_unique<SurfaceMap>(study->facets, study->flat);
  const OpenedJoints joints(panel, panel.faces[face]);
  for (const auto& loop : study->facets.loops)
    study->joint_angles.push_back(joints.of_loop(study->facets, study->flat, loop));
  study->region = flat_region(study->facets, study->flat, corners_over(study->joint_angles, corner_angle));
  add_plane_curves(*study, panel, [&](std::size_t l, std::size_t i) {
    const std::vector<Index>& loop = study->facets.loops[l];
    return joints.segment(study->facets, loop[i], loop[(i + 1) % loop.size()]);
  });
  return study;
}

double cut_length(const FaceStudy& study) {
  return cut_length(study.facets, study.cut_sides);
}

}  // namespace beadmesh
