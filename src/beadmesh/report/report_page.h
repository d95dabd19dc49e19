// Private to this room: the fixed parts of the HTML report.
#pragma once

namespace beadmesh {

extern const char* const report_style;   ///< CSS
extern const char* const report_script;  ///< JavaScript: pan and zoom of the picture, sorting of tables

}  // namespace beadmesh
