// parse_poly: any text is a checked region or an error that says why.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "beadmesh/read/polygon_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto region = beadmesh::parse_poly({reinterpret_cast<const char*>(data), size});
  if (!region && (region.error().code.empty() || region.error().message.empty())) std::abort();
  if (region && !beadmesh::checked_region(*region)) std::abort();
  return 0;
}
