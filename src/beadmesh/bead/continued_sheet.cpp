#include "beadmesh/bead/continued_sheet.h"

#include <vector>

namespace beadmesh {
namespace {

/// One for each corner on the loop.
std::vector<SheetContact> contacts_of(const Facets& sheet, std::size_t loop) {
  std::vector<bool> on_loop(sheet.points.size(), false);
  for (const Index v : sheet.loops[loop]) on_loop[v] = true;
  std::vector<SheetContact> contacts;
  for (Index t = 0; t < Index(sheet.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k)
      if (const Index v = sheet.triangles[t][k]; on_loop[v])
        contacts.push_back({sheet.points[v], corner_normal(sheet, t, k)});
  return contacts;
}

}  // namespace

ContinuedSheet::ContinuedSheet(const Facets& sheet, std::size_t loop) : sheet_(contacts_of(sheet, loop)) {}

double ContinuedSheet::height(Vec3 point) const {
  return sheet_.height(point);
}

Vec3 ContinuedSheet::normal(Vec3 point) const {
  return sheet_.normal(point);
}

}  // namespace beadmesh
