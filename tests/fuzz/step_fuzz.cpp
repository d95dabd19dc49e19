// The STEP reader: any bytes are a sound panel, or an error that says why.
#include "cad_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  beadmesh::fuzz::read_cad_bytes(data, size, ".step");
  return 0;
}
