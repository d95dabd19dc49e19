#include "beadmesh/bead/recognition.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "beadmesh/bead/crest_offset.h"
#include "beadmesh/bead/ridge.h"
#include "beadmesh/bead/shape_letter.h"

namespace beadmesh {
namespace {

/// A medial point on the surface, with what the bead's cross-section does there.
struct CrossSection {
  Vec3 crest;
  double chord = 0;   ///< distance between the two feet
  double width = 0;   ///< thickness of the bead: the chord, but where both feet lie on one side of the disc
  double height = 0;  ///< of the crest over the chord
  double rise = 0;    ///< of the crest over the sheet, continued as an arc between the feet
};

CrossSection cross_section(const FaceStudy& study, const MedialPoint& medial) {
  CrossSection out;
  const SurfaceMap& map = *study.map;
  const auto crest = map.locate(medial.point);
  const auto left = map.locate(medial.feet[0].point, crest.triangle);
  const auto right = map.locate(medial.feet[1].point, crest.triangle);
  const Vec3 a = map.surface_point(left), b = map.surface_point(right);
  out.crest = map.surface_point(crest);
  out.chord = distance(a, b);
  // At the end of an axis, and on all of it where the face is all but round, both feet run together: the disc
  // is as thick as ever.
  const bool is_across = distance(medial.feet[0].point, medial.feet[1].point) > medial.radius;
  out.width = is_across ? out.chord : std::max(out.chord, 2 * medial.radius);
  if (out.chord <= 0) return out;
  const Vec3 along = (b - a) / out.chord;
  const Vec3 from_chord = (out.crest - a) - along * dot(out.crest - a, along);
  const Vec3 na = map.normal(left), nb = map.normal(right);
  const Vec3 up = normalized(na + nb);
  const double over = dot(from_chord, up);
  out.height = std::abs(over);
  // Normals that lean apart mean a sheet that bulges up between the feet, by chord * angle / 8.
  const double bulge = out.chord * std::asin(std::clamp(dot(nb - na, along) / 2, -1.0, 1.0)) * 2 / 8;
  out.rise = std::abs(over - bulge);
  return out;
}

/// Along a piece of a medial edge.
struct SectionStep {
  double length = 0, width = 0, height = 0, rise = 0;
  bool in_junction = false;  ///< within the disc of a junction: as wide as all its arms together
};

struct Measures {
  std::vector<SectionStep> steps;
  double ratio_sum = 0;  ///< of the edges' length / thickness
};

/// How far a junction reaches: to its touching points, which for one that stands for several are not equally
/// far.
double reach_of(const MedialVertex& junction) {
  double reach = junction.radius;
  for (const Foot& foot : junction.touching_points)
    reach = std::max(reach, distance(foot.point, junction.point));
  return reach;
}

/// Is the place within reach of a junction at an end of the edge?
bool in_junction(const MedialObject& medial, const MedialEdge& edge, Vec2 place) {
  for (const Index v : {edge.start, edge.end}) {
    if (v == no_index || medial.vertices[v].type != MedialVertexType::J) continue;
    if (distance(place, medial.vertices[v].point) < reach_of(medial.vertices[v])) return true;
  }
  return false;
}

/// Adds a medial edge: length on the surface, trapezium rule for the rest.
void add_edge(const FaceStudy& study, const MedialObject& medial, const MedialEdge& edge, Measures& sum) {
  std::vector<CrossSection> sections;
  for (const MedialPoint& p : edge.points) sections.push_back(cross_section(study, p));
  if (edge.type == MedialEdgeType::N && !sections.empty()) sections.push_back(sections.front());
  double length = 0, width = 0;
  for (size_t i = 1; i < sections.size(); ++i) {
    const CrossSection &a = sections[i - 1], &b = sections[i];
    const Vec2 middle = lerp(edge.points[i - 1].point, edge.points[i % edge.points.size()].point, 0.5);
    sum.steps.push_back({distance(a.crest, b.crest), (a.width + b.width) / 2, (a.height + b.height) / 2,
                         (a.rise + b.rise) / 2, in_junction(medial, edge, middle)});
    length += sum.steps.back().length;
    width += sum.steps.back().length * sum.steps.back().width;
  }
  if (width > 0) sum.ratio_sum += length * length / width;
}

/// Mean over the length; of the arms alone where there is something of them outside the junctions.
double mean_width(const std::vector<SectionStep>& steps) {
  for (const bool with_junctions : {false, true}) {
    double length = 0, integral = 0;
    for (const SectionStep& step : steps)
      if (with_junctions || !step.in_junction) length += step.length, integral += step.length * step.width;
    if (length > 0) return integral / length;
  }
  return 0;
}

/// The height that only a tenth of the length exceeds: run-outs at the ends count no less than noise does.
double full_height(std::vector<SectionStep> steps) {
  std::stable_sort(steps.begin(), steps.end(),
                   [](const SectionStep& a, const SectionStep& b) { return a.height > b.height; });
  double whole = 0, walked = 0;
  for (const SectionStep& step : steps) whole += step.length;
  for (const SectionStep& step : steps)
    if ((walked += step.length) >= 0.1 * whole) return step.height;
  return 0;
}

std::string format(const char* pattern, double a, double b) {
  char text[128];
  std::snprintf(text, sizeof text, pattern, a, b);
  return text;
}

BeadKind kind_of(const MedialObject& medial, size_t loops) {
  if (medial.edges.size() == 1 && medial.edges[0].type == MedialEdgeType::N && loops == 2)
    return BeadKind::annular;
  if (medial.edges.size() == 1 && medial.edges[0].type == MedialEdgeType::SS) return BeadKind::I;
  return BeadKind::generic;
}

std::vector<RidgeCurve> curves_of(const FaceStudy& study, const RidgeGraph& graph) {
  std::vector<RidgeCurve> curves;
  for (const RidgeArm& arm : graph.arms) {
    RidgeCurve curve;
    curve.flat = arm.points;
    curve.closed = arm.start == no_index;
    for (Vec2 p : arm.points) curve.points.push_back(study.lift(p));
    curves.push_back(std::move(curve));
  }
  return curves;
}

/// The skeleton seen from above. The flattened face of a curved, raised bead bends less than the bead does,
/// so letters are read in plan: along the mean normal of the sheet at the feet.
Skeleton in_plan(const FaceStudy& study, Skeleton skeleton) {
  const SurfaceMap& map = *study.map;
  Vec3 up;
  for (const SkeletonArm& arm : skeleton.arms)
    for (const MedialPoint& p : arm.points)
      for (const Foot& foot : p.feet) up += map.normal(map.locate(foot.point));
  up = normalized(up);
  const Vec3 x = normalized(cross(std::abs(up.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, up)),
             y = cross(up, x);
  const auto seen = [&](Vec2 flat) {
    const Vec3 p = study.lift(flat);
    return Vec2{dot(p, x), dot(p, y)};
  };
  for (SkeletonNode& node : skeleton.nodes) node.point = seen(node.point);
  for (SkeletonArm& arm : skeleton.arms)
    for (MedialPoint& p : arm.points) {
      p.radius = distance(seen(p.feet[0].point), seen(p.feet[1].point)) / 2;
      p.point = seen(p.point);
    }
  return skeleton;
}

}  // namespace

Result<void> check_boundary(const FaceStudy& study, const BeadOptions& options) {
  const int loops = int(study.region.loops.size());
  if (loops > options.max_loops)
    return fail("bead.loops", "it has " + std::to_string(loops) + " loops, a bead has at most " +
                                  std::to_string(options.max_loops));
  double sharpest = 0;
  for (const auto& loop : study.joint_angles)
    for (double angle : loop) sharpest = std::max(sharpest, angle);
  if (sharpest > options.max_joint_angle)
    return fail("bead.corner", format("its boundary turns by %.1f degrees at a joint, over %.1f",
                                      degrees(sharpest), degrees(options.max_joint_angle)));
  return {};
}

Result<MedialObject> medial_object_of_bead(const PlanarRegion& region) {
  MedialOptions options;
  options.merge_crossings = true;
  options.chord = 1e-2 * diagonal(region);  // the points of the samples are as near as elements get
  return medial_object(region, options);
}

Result<Bead> recognise(const FaceStudy& study, const MedialObject& medial, const BeadOptions& options) {
  Measures sum;
  for (const MedialEdge& edge : medial.edges) add_edge(study, medial, edge, sum);
  double length = 0, width_integral = 0, rise_integral = 0;
  for (const SectionStep& step : sum.steps) {
    length += step.length;
    width_integral += step.length * step.width;
    rise_integral += step.length * step.rise;
  }
  if (width_integral <= 0) return fail("bead.no_axis", "its medial object has no edge of a length");
  Bead bead;
  bead.loops = int(study.region.loops.size());
  bead.length = length;
  bead.width = mean_width(sum.steps);
  bead.height = full_height(sum.steps);
  bead.aspect_ratio = sum.ratio_sum / double(medial.edges.size());
  bead.medial_edges = int(medial.edges.size());
  for (const MedialVertex& v : medial.vertices)
    ++(v.type == MedialVertexType::J ? bead.junctions : bead.ends);
  if (bead.aspect_ratio < options.min_aspect_ratio)
    return fail("bead.aspect_ratio",
                format("aspect ratio %.2f < %.2f", bead.aspect_ratio, options.min_aspect_ratio));
  const double rise = rise_integral / width_integral;
  if (rise < options.min_rise)
    return fail("bead.flat", format("its crest rises by %.3f of its width over the sheet, under %.3f", rise,
                                    options.min_rise));
  const Skeleton skeleton = skeleton_of(medial);
  bead.kind = kind_of(medial, study.region.loops.size());
  bead.shape = shape_letter(in_plan(study, skeleton));
  bead.ridge =
      curves_of(study, ridge_of(moved_to_crest(skeleton, *study.map), study.region, study.map.get()));
  const RidgeCurve& longest = *std::max_element(bead.ridge.begin(), bead.ridge.end(), [](auto& a, auto& b) {
    return a.points.size() < b.points.size();
  });
  bead.point = longest.points[longest.points.size() / 2];
  bead.faces = study.faces;
  return bead;
}

}  // namespace beadmesh
