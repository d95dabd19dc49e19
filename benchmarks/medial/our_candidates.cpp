#include <stdexcept>
#include <utility>

#include "beadmesh/delaunay/triangulation.h"
#include "beadmesh/medial/medial_object.h"
#include "beadmesh/medial/sampled_boundary.h"
#include "candidates.h"

namespace beadmesh::bench {
namespace {

Run prepared_check(const PlanarRegion& region) {
  return [region] {
    const auto checked = checked_region(region);
    if (!checked) throw std::runtime_error(to_line(checked.error()));
    return std::to_string(checked->loops.size()) + " loops";
  };
}

Run prepared_triangulation(const PlanarRegion& region) {
  std::vector<Vec2> points;
  std::vector<std::vector<Index>> loops;
  for (const PlanarLoop& loop : region.loops) {
    auto& indices = loops.emplace_back();
    for (const Vec2 p : loop.points) {
      indices.push_back(static_cast<Index>(points.size()));
      points.push_back(p);
    }
  }
  return [points, loops] {
    const auto triangulation = triangulate(points, loops);
    if (!triangulation) throw std::runtime_error(to_line(triangulation.error()));
    return std::to_string(triangulation->triangles.size()) + " triangles";
  };
}

std::string described(const MedialObject& object) {
  int junctions = 0, corner_ends = 0, smooth_ends = 0;
  for (const MedialVertex& vertex : object.vertices) {
    junctions += vertex.type == MedialVertexType::J;
    corner_ends += vertex.type == MedialVertexType::C;
    smooth_ends += vertex.type == MedialVertexType::S;
  }
  return "edges " + std::to_string(object.edges.size()) + ", J " + std::to_string(junctions) + ", C " +
         std::to_string(corner_ends) + ", S " + std::to_string(smooth_ends);
}

PlanarRegion checked(const PlanarRegion& region) {
  auto result = checked_region(region);
  if (!result) throw std::runtime_error(to_line(result.error()));
  return std::move(*result);
}

/// The first stages: the curve of the boundary, samples, triangulation.
Run prepared_sampling(const PlanarRegion& region) {
  return [region = checked(region)] {
    const MedialOptions options;
    const BoundaryCurve curve(region, options.corner_angle);
    const auto sampled = sampled_boundary(curve, options.sampling);
    if (!sampled) throw std::runtime_error(to_line(sampled.error()));
    return std::to_string(sampled->samples.samples.size()) + " samples";
  };
}

Run prepared_object(const PlanarRegion& region, const MedialOptions& options) {
  return [region = checked(region), options] {
    const auto object = medial_object(region, options);
    if (!object) throw std::runtime_error(to_line(object.error()));
    return described(*object);
  };
}

Run prepared_medial_object(const PlanarRegion& region) {
  return prepared_object(region, {});
}

/// All stages but the polish and what follows it.
Run prepared_rough_object(const PlanarRegion& region) {
  MedialOptions options;
  options.polish = false;
  options.smoothing_passes = 0;
  return prepared_object(region, options);
}

}  // namespace

std::vector<Candidate> our_candidates() {
  return {{"medial object", prepared_medial_object},
          {"object without polish", prepared_rough_object},
          {"samples and CDT", prepared_sampling},
          {"our CDT", prepared_triangulation},
          {"check of the region", prepared_check}};
}

}  // namespace beadmesh::bench
