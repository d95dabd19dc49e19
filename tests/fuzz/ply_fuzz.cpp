// parse_ply and what follows: any bytes are a sound panel, or an error that says why.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "beadmesh/read/facet_skin.h"
#include "beadmesh/read/ply_reader.h"
#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto facets = beadmesh::parse_ply(std::string(reinterpret_cast<const char*>(data), size), "input");
  if (!facets) {
    if (facets.error().code.empty() || facets.error().message.empty()) std::abort();
    return 0;
  }
  for (const auto& corners : facets->corners)
    for (const beadmesh::Vec3 p : corners)
      if (!(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1e12))
        return 0;  // refused by the caller, or no panel
  const beadmesh::Panel panel = beadmesh::panel_of_facets(*facets, beadmesh::radians(40));
  beadmesh::fuzz::expect_none(beadmesh::verify_panel(panel));
  return 0;
}
