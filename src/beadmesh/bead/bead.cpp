#include "beadmesh/bead/bead.h"

namespace beadmesh {

std::string name_of(BeadKind kind) {
  switch (kind) {
    case BeadKind::I:
      return "I";
    case BeadKind::generic:
      return "generic";
    case BeadKind::annular:
      return "annular";
  }
  return "generic";
}

}  // namespace beadmesh
