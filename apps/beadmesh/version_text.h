// What `--version` prints.
#pragma once

#include <string>

namespace beadmesh::app {

/// "beadmesh 0.1.0", then the versions of the compiler and of the libraries that it was built with, one a
/// line.
std::string version_text();

}  // namespace beadmesh::app
