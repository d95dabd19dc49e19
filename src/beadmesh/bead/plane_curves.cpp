#include "beadmesh/bead/plane_curves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace beadmesh {
namespace {

constexpr double plane_tolerance = 1e-9;  // of the points from the plane image / size
constexpr double curve_tolerance = 1e-7;  // of the points from their curves / size
constexpr double straight_bulge = 1e-11;  // of a curve that is a line / size

/// A rigid motion of a plane in space onto the plane of the flat image.
struct PlaneFrame {
  Vec3 origin, x_axis, y_axis;
  Vec2 image, x_image, y_image;

  Vec2 direction(Vec3 v) const { return x_image * dot(v, x_axis) + y_image * dot(v, y_axis); }
  Vec2 point(Vec3 p) const { return image + direction(p - origin); }
};

class CurveInPlane final : public PlanarCurve {
 public:
  CurveInPlane(std::shared_ptr<const CurveEvaluator> curve, const PlaneFrame& frame)
      : curve_(std::move(curve)), frame_(frame) {}
  CurvePoint at(double parameter) const override {
    const SpaceCurvePoint p = curve_->at(parameter);
    return {frame_.point(p.point), frame_.direction(p.velocity), frame_.direction(p.acceleration)};
  }

 private:
  std::shared_ptr<const CurveEvaluator> curve_;
  PlaneFrame frame_;
};

/// Nothing where the flat image is no rigid image of the face.
std::optional<PlaneFrame> plane_frame(const FaceStudy& study, double size) {
  const std::vector<Vec3>& points = study.facets.points;
  if (points.size() < 3) return std::nullopt;
  const auto farthest = std::max_element(points.begin(), points.end(), [&](Vec3 a, Vec3 b) {
    return distance(a, points[0]) < distance(b, points[0]);
  });
  const auto far = static_cast<std::size_t>(farthest - points.begin());
  const Vec3 normal = normalized(vector_area(study.facets));
  PlaneFrame frame;
  frame.origin = points[0];
  frame.x_axis = normalized(points[far] - points[0]);
  frame.y_axis = cross(normal, frame.x_axis);
  frame.image = study.flat.positions[0];
  frame.x_image = normalized(study.flat.positions[far] - frame.image);
  frame.y_image = left_normal(frame.x_image);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool in_plane = std::abs(dot(points[i] - frame.origin, normal)) <= plane_tolerance * size;
    if (!in_plane || distance(frame.point(points[i]), study.flat.positions[i]) > plane_tolerance * size)
      return std::nullopt;
  }
  return frame;
}

class PlaneCurves {
 public:
  PlaneCurves(const FaceStudy& study, const Panel& panel, const PlaneFrame& frame, double size)
      : panel_(panel), frame_(frame), size_(size), region_(study.region) {}

  /// The region with curves; nothing where an edge has none or it is off its points.
  std::optional<PlanarRegion> run(const EdgeOfSegment& edge_of) {
    for (std::size_t l = 0; l < region_.loops.size(); ++l)
      for (std::size_t i = 0; i < region_.loops[l].points.size(); ++i) {
        const std::optional<EdgeSegment> segment = edge_of(l, i);
        if (!segment || !add(region_.loops[l], i, *segment)) return std::nullopt;
      }
    return std::move(region_);
  }

 private:
  Index curve_of(Index edge) {
    const auto [found, is_new] = ids_.try_emplace(edge, static_cast<Index>(region_.curves.size()));
    if (is_new) region_.curves.push_back(std::make_shared<CurveInPlane>(panel_.edges[edge].curve, frame_));
    return found->second;
  }

  bool add(PlanarLoop& loop, std::size_t i, const EdgeSegment& segment) {
    const PanelEdge& edge = panel_.edges[segment.edge];
    if (!edge.curve || edge.parameters.size() != edge.points.size()) return false;
    double from = edge.parameters[segment.step], to = edge.parameters[segment.step + 1];
    if (segment.reversed) std::swap(from, to);
    const Vec2 a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
    const auto off = [&](double t, Vec2 p) { return distance(frame_.point(edge.curve->point(t)), p); };
    if (off(from, a) > curve_tolerance * size_ || off(to, b) > curve_tolerance * size_) return false;
    const bool straight = is_straight(*edge.curve, from, to, a, b);
    loop.curve.push_back(straight ? no_index : curve_of(segment.edge));
    loop.parameters.push_back({from, to});
    return true;
  }

  bool is_straight(const CurveEvaluator& curve, double from, double to, Vec2 a, Vec2 b) const {
    const Vec2 along = normalized(b - a);
    for (const double part : {0.2, 0.5, 0.8})
      if (std::abs(cross(along, frame_.point(curve.point(std::lerp(from, to, part))) - a)) >
          straight_bulge * size_)
        return false;
    return true;
  }

  const Panel& panel_;
  const PlaneFrame& frame_;
  double size_;
  PlanarRegion region_;
  std::map<Index, Index> ids_;  // per edge of the panel: its curve
};

}  // namespace

bool add_plane_curves(FaceStudy& study, const Panel& panel, const EdgeOfSegment& edge_of,
                      double corner_angle) {
  const double size = diagonal(study.region);
  const std::optional<PlaneFrame> frame = plane_frame(study, size);
  if (!frame) return false;
  std::optional<PlanarRegion> region = PlaneCurves(study, panel, *frame, size).run(edge_of);
  if (!region || region->curves.empty()) return false;
  for (std::size_t l = 0; l < region->loops.size(); ++l)
    for (std::size_t i = 0; i < region->loops[l].points.size(); ++i)
      region->loops[l].corner[i] = study.joint_angles[l][i] > corner_angle;
  study.region = std::move(*region);
  return true;
}

}  // namespace beadmesh
