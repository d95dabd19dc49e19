#include "beadmesh/core/version.h"

namespace beadmesh {

std::string_view version() {
  return BEADMESH_VERSION;
}

}  // namespace beadmesh
