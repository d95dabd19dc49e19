// The version of the library, from the build.
#pragma once

#include <string_view>

namespace beadmesh {

/// "0.1.0", of the project in CMakeLists.txt.
std::string_view version();

}  // namespace beadmesh
