#include "beadmesh/read/sheet_band.h"

#include <algorithm>
#include <map>

namespace beadmesh {
namespace {

constexpr int band_rows = 4;
constexpr double band_width = 10;  // mm

struct BandPoint {
  Vec3 source;  ///< point of the border from which it was reached
  Vec3 normal;  ///< of the sheet alone, weighed by area
  int row = 0;
};

}  // namespace

std::optional<QuadraticSheet> sheet_beside(const FacetMesh& mesh, const std::vector<Index>& face, Index sheet,
                                           const std::vector<Index>& piece) {
  std::map<Index, BandPoint> band;
  std::vector<Index> row;  // triangles
  std::map<Index, bool> taken;
  const auto take = [&](Index t, int number, Vec3 source) {
    if (!taken.try_emplace(t, true).second) return;
    row.push_back(t);
    for (const Index v : mesh.triangles[t]) {
      const auto [found, is_new] =
          band.try_emplace(v, BandPoint{number == 0 ? mesh.points[v] : source, {}, number});
      found->second.normal += mesh.area_vectors[t];
    }
  };
  for (const Index t : piece)
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      if (const Index s = mesh.beyond(h); s != no_index && face[s] == sheet)
        take(s, 0, mesh.points[mesh.tail(h)]);
  if (row.empty()) return std::nullopt;
  for (int number = 1; number < band_rows; ++number) {
    const std::vector<Index> last = std::move(row);
    row.clear();
    for (const Index t : last)
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        const Index s = mesh.beyond(h);
        if (s == no_index || face[s] != sheet) continue;
        const Vec3 source = band.at(mesh.tail(h)).source;
        if (distance(mesh.centre(s), source) < band_width) take(s, number, source);
      }
  }
  std::vector<SheetContact> contacts;
  for (const auto& [v, point] : band)
    if (distance(mesh.points[v], point.source) < band_width)
      contacts.push_back({mesh.points[v], normalized(point.normal)});
  if (contacts.size() < 3) return std::nullopt;
  return QuadraticSheet(contacts);
}

bool is_coarse(const FacetMesh& mesh) {
  std::vector<std::pair<double, double>> sizes;  // shortest height, area
  double whole = 0, even = 0;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const double longest = std::max({mesh.length(3 * t), mesh.length(3 * t + 1), mesh.length(3 * t + 2)});
    const double area = mesh.area(t), lowest = longest > 0 ? 2 * area / longest : 0;
    whole += area;
    if (longest < 4 * lowest) even += area;
    sizes.push_back({longest, area});
  }
  std::sort(sizes.begin(), sizes.end());
  double sum = 0;
  for (const auto& [size, area] : sizes)
    if ((sum += area) >= whole / 2) return even > 0.8 * whole && size > 1.5 && size < 12;
  return false;
}

}  // namespace beadmesh
