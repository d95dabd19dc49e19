#include "beadmesh/flatten/flat_face.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "beadmesh/flatten/flat_start.h"
#include "beadmesh/flatten/rigid_layout.h"
#include "beadmesh/flatten/triangle_geometry.h"
#include "beadmesh/flatten/triangle_topology.h"

namespace beadmesh {
namespace {

// Relative to the diagonal of the piece:
constexpr double planar_tolerance = 1e-6;  // facets that leave a plane by less are planar
constexpr double sliver_height =
    1e-5;  // thinner triangles are noise: neither their flips nor their ratios count

enum class Start { mean_plane, unrolled, tutte };

struct Assessment {
  std::size_t flips = 0;
  Distortion distortion;
};

class Flattener {
 public:
  Flattener(const Facets& facets, const TriangleNeighbours& neighbours, const FlattenOptions& options)
      : facets_(facets),
        neighbours_(neighbours),
        options_(options),
        size_(diagonal(facets.points)),
        frame_(mean_plane(facets)) {
    rest_.reserve(facets.triangles.size());
    for (std::size_t t = 0; t < facets.triangles.size(); ++t)
      rest_.push_back(rest_triangle(facets, static_cast<Index>(t)));
    projection_.reserve(facets.points.size());
    for (const Vec3 p : facets.points) projection_.push_back(frame_.project(p));
  }

  Result<FlatFace> run() const {
    if (is_planar()) {
      const Assessment found = assess(projection_);
      if (found.flips == 0) return FlatFace{projection_, found.distortion};
    }
    const RigidLayout layout(facets_.points.size(), facets_.triangles, rest_);
    if (!layout.is_ready()) return fail("flatten.singular", "the facets are too degenerate to be laid out");
    std::optional<FlatFace> best;
    std::size_t fewest_flips = std::numeric_limits<std::size_t>::max();
    for (const Start start : {Start::mean_plane, Start::unrolled, Start::tutte}) {
      const std::vector<Vec2> positions = laid_out(layout, start);
      if (positions.empty()) continue;
      const Assessment found = assess(positions);
      fewest_flips = std::min(fewest_flips, found.flips);
      if (found.flips > 0) continue;
      if (!best || found.distortion.max_ratio < best->distortion.max_ratio)
        best = FlatFace{placed(positions), found.distortion};
      if (best->distortion.max_ratio <= options_.max_distortion) return *best;
    }
    if (!best)
      return fail("flatten.flip", std::to_string(fewest_flips) + " facets turn over in the plane",
                  "split the face");
    return fail("flatten.distortion",
                "the plane image is distorted by " + std::to_string(best->distortion.max_ratio) + " (limit " +
                    std::to_string(options_.max_distortion) + ")",
                "split the face");
  }

 private:
  bool is_planar() const {
    const double level = dot(facets_.points[0], frame_.normal);
    return std::all_of(facets_.points.begin(), facets_.points.end(), [&](Vec3 p) {
      return std::abs(dot(p, frame_.normal) - level) <= planar_tolerance * size_;
    });
  }

  bool is_sliver(const RestTriangle& rest) const { return least_height(rest) <= sliver_height * size_; }

  RestTriangle image_of(std::size_t t, const std::vector<Vec2>& positions) const {
    const Triangle& corners = facets_.triangles[t];
    return {positions[corners[0]], positions[corners[1]], positions[corners[2]]};
  }

  /// Laid out from one start; empty where the start is not to be had.
  std::vector<Vec2> laid_out(const RigidLayout& layout, Start start) const {
    const double tolerance = options_.convergence * size_;
    if (start == Start::mean_plane && leans_over()) return {};
    if (start != Start::tutte) {
      const std::vector<Vec2> guess =
          start == Start::mean_plane ? layout.rotations(projection_) : std::vector<Vec2>{};
      const std::vector<Vec2> turns = unrolled_rotations(facets_.triangles, neighbours_, rest_, guess);
      return layout.relaxed(layout.assembled(turns), options_.iterations, tolerance);
    }
    const std::optional<std::vector<Vec2>> embedded = tutte_layout(facets_);
    if (!embedded || assess(*embedded).flips > 0) return {};
    return layout.relaxed_without_flips(*embedded, options_.iterations, tolerance);
  }

  /// Is a facet tilted against the mean plane so far (over 100 degrees) that its projection says nothing
  /// about its turn?
  bool leans_over() const {
    for (std::size_t t = 0; t < rest_.size(); ++t) {
      if (is_sliver(rest_[t])) continue;
      const RestTriangle image = image_of(t, projection_);
      const double area = doubled_area(rest_[t][0], rest_[t][1], rest_[t][2]);
      if (doubled_area(image[0], image[1], image[2]) < -0.17 * area) return true;
    }
    return false;
  }

  Assessment assess(const std::vector<Vec2>& positions) const {
    Assessment found;
    double stretches = 0, areas = 0;
    for (std::size_t t = 0; t < rest_.size(); ++t) {
      const RestTriangle image = image_of(t, positions);
      if (is_sliver(rest_[t])) {
        if (!(least_height(image) >= -sliver_height * size_)) ++found.flips;
        continue;
      }
      const SingularValues values = singular_values(rest_[t], image);
      if (!(values.least > 0)) {
        ++found.flips;
        continue;
      }
      const double stretch = std::max(values.greatest, 1 / values.least);
      const double area = doubled_area(rest_[t][0], rest_[t][1], rest_[t][2]);
      found.distortion.max_ratio = std::max(found.distortion.max_ratio, values.greatest / values.least);
      found.distortion.max_stretch = std::max(found.distortion.max_stretch, stretch);
      stretches += area * stretch;
      areas += area;
    }
    if (areas > 0) found.distortion.mean_stretch = stretches / areas;
    return found;
  }

  /// Moved over the projection into the mean plane by the rigid motion that comes closest, in the mean over
  /// the surface: the midpoints of the edges integrate it exactly, so that the triangulation of a facet makes
  /// no difference.
  std::vector<Vec2> placed(std::vector<Vec2> positions) const {
    Vec2 from, to;
    double total = 0;
    for_each_midpoint(positions, [&](Vec2 flat, Vec2 projected, double area) {
      from += flat * area;
      to += projected * area;
      total += area;
    });
    if (total > 0) from = from / total, to = to / total;
    Vec2 turn;
    for_each_midpoint(positions, [&](Vec2 flat, Vec2 projected, double area) {
      const Vec2 a = flat - from, b = projected - to;
      turn += area * Vec2{dot(a, b), cross(a, b)};
    });
    turn = norm(turn) > 0 ? normalized(turn) : Vec2{1, 0};
    for (Vec2& p : positions) {
      const Vec2 d = p - from;
      p = to + Vec2{turn.x * d.x - turn.y * d.y, turn.y * d.x + turn.x * d.y};
    }
    return positions;
  }

  template <class Visit>
  void for_each_midpoint(const std::vector<Vec2>& positions, Visit visit) const {
    for (std::size_t t = 0; t < rest_.size(); ++t) {
      const double area = doubled_area(rest_[t][0], rest_[t][1], rest_[t][2]);
      const Triangle& v = facets_.triangles[t];
      for (int k = 0; k < 3; ++k) {
        const Index a = v[k], b = v[(k + 1) % 3];
        visit(lerp(positions[a], positions[b], 0.5), lerp(projection_[a], projection_[b], 0.5), area);
      }
    }
  }

  const Facets& facets_;
  const TriangleNeighbours& neighbours_;
  const FlattenOptions& options_;
  double size_;
  PlaneFrame frame_;
  std::vector<RestTriangle> rest_;
  std::vector<Vec2> projection_;
};

}  // namespace

Result<FlatFace> flatten(const Facets& facets, const FlattenOptions& options) {
  const Result<TriangleNeighbours> neighbours = check_disc(facets);
  if (!neighbours) return Failure(neighbours.error());
  return Flattener(facets, *neighbours, options).run();
}

}  // namespace beadmesh
