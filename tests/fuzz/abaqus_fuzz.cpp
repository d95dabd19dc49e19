// parse_abaqus: any text is a deck whose shells have their nodes, or an error that says why.
#include <cstddef>
#include <cstdint>

#include "beadmesh/read/abaqus_reader.h"
#include "facet_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return beadmesh::fuzz::check_deck(beadmesh::parse_abaqus({reinterpret_cast<const char*>(data), size}));
}
