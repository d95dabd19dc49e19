#include "version_text.h"

#include "beadmesh/core/version.h"
#include "version_parts.h"  // made by the build

namespace beadmesh::app {

std::string version_text() {
  return "beadmesh " + std::string(version()) + "\nbuilt with" + version_parts;
}

}  // namespace beadmesh::app
