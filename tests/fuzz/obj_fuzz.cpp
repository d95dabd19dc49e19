// parse_obj and what follows: any bytes are a sound panel, or an error that says why.
#include <cstddef>
#include <cstdint>
#include <string>

#include "beadmesh/read/obj_reader.h"
#include "facet_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return beadmesh::fuzz::check_facets(beadmesh::parse_obj(bytes, "input"));
}
