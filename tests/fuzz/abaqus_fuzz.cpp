// parse_abaqus: any text is a deck whose shells have their nodes, or an error that says why.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "beadmesh/read/abaqus_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto deck = beadmesh::parse_abaqus({reinterpret_cast<const char*>(data), size});
  if (!deck) {
    if (deck.error().code.empty() || deck.error().message.empty()) std::abort();
    return 0;
  }
  if (deck->elements.empty() || deck->properties.size() != deck->elements.size()) std::abort();
  for (const auto& shell : deck->elements)
    for (const beadmesh::Index node : shell)
      if (node < -1 || node >= beadmesh::Index(deck->points.size())) std::abort();
  return 0;
}
