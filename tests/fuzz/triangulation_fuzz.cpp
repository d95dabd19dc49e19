// triangulate: any points and loops are a constrained Delaunay triangulation or an error that says why.
#include <cstdlib>

#include "beadmesh/delaunay/triangulation.h"
#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beadmesh;
  fuzz::Bytes bytes(data, size);
  const fuzz::PointsAndLoops input = fuzz::points_and_loops(bytes);
  const auto triangulation = triangulate(input.points, input.loops);
  if (triangulation)
    fuzz::expect_none(verify_triangulation(*triangulation, input.loops));
  else if (triangulation.error().code.empty() || triangulation.error().message.empty())
    std::abort();
  return 0;
}
