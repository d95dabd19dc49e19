#include "beadmesh/panel/facets.h"

namespace beadmesh {
namespace {

Vec3 triangle_vector_area(const Facets& facets, const Triangle& t) {
  const Vec3 a = facets.points[t[0]];
  return cross(facets.points[t[1]] - a, facets.points[t[2]] - a) / 2;
}

double loop_length(const Facets& facets, const std::vector<Index>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += distance(facets.points[loop[i]], facets.points[loop[(i + 1) % loop.size()]]);
  return sum;
}

Vec3 loop_vector_area(const Facets& facets, const std::vector<Index>& loop) {
  Vec3 sum;
  const Vec3 origin = facets.points[loop.front()];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += cross(facets.points[loop[i]] - origin, facets.points[loop[i + 1]] - origin) / 2;
  return sum;
}

}  // namespace

Vec3 vector_area(const Facets& facets) {
  Vec3 sum;
  for (const Triangle& t : facets.triangles) sum += triangle_vector_area(facets, t);
  return sum;
}

double area(const Facets& facets) {
  double sum = 0;
  for (const Triangle& t : facets.triangles) sum += norm(triangle_vector_area(facets, t));
  return sum;
}

std::size_t outer_loop(const Facets& facets) {
  const Vec3 mean = vector_area(facets);
  const bool has_normal = norm(mean) > 0.05 * area(facets);
  std::size_t best = 0;
  double best_size = 0;
  for (std::size_t i = 0; i < facets.loops.size(); ++i) {
    const std::vector<Index>& loop = facets.loops[i];
    const double size = has_normal ? dot(loop_vector_area(facets, loop), mean) : loop_length(facets, loop);
    if (i == 0 || size > best_size) best = i, best_size = size;
  }
  return best;
}

}  // namespace beadmesh
