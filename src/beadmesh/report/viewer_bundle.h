// Internal to the room: the viewer of the report, built into the program from viewer/dist.
#pragma once

#include <string_view>

namespace beadmesh {

std::string_view viewer_script();  ///< JavaScript
std::string_view viewer_style();   ///< CSS

}  // namespace beadmesh
