// medial_object: a checked region has a medial object that keeps its own rules, or an error that says why.
#include <cstdlib>

#include "beadmesh/medial/medial_object.h"
#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beadmesh;
  fuzz::Bytes bytes(data, size);
  const bool tagged = bytes.byte() % 2;
  PlanarRegion drawn = fuzz::region(bytes);
  if (tagged)
    for (PlanarLoop& loop : drawn.loops) loop.corner.assign(loop.points.size(), true);
  const auto region = checked_region(std::move(drawn));
  if (!region) return 0;
  const auto object = medial_object(*region);
  if (!object) {
    if (object.error().code == "medial.topology" || object.error().message.empty())
      fuzz::expect_none({to_line(object.error())});
    return 0;
  }
  // Points without a tag may stand for a smooth curve, off which the polygon is by its facets' bulge.
  const double tolerance = tagged ? 1e-6 * object->size : 0.5 * object->size;
  fuzz::expect_none(verify_medial_object(*object, *region, tolerance));
  return 0;
}
