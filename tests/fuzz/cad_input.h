// What the fuzzers of STEP, IGES and BREP share: bytes as a file, the CAD kernel apart from what follows it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace beadmesh::fuzz {

/// Any bytes are a sound panel, or an error that says why. OpenCASCADE itself crashes and hangs on some
/// files: the file is read in a process of its own first, and what goes wrong there before the facets is no
/// finding (the program refuses such a file, app/crash_guard.h). Aborts on everything else.
void read_cad_bytes(const std::uint8_t* data, std::size_t size, const std::string& ending);

}  // namespace beadmesh::fuzz
