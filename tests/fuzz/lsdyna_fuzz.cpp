// parse_lsdyna: any text is a deck whose shells have their nodes, or an error that says why.
#include <cstddef>
#include <cstdint>

#include "beadmesh/read/lsdyna_reader.h"
#include "facet_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return beadmesh::fuzz::check_deck(beadmesh::parse_lsdyna({reinterpret_cast<const char*>(data), size}));
}
