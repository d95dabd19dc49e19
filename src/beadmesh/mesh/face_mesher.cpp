#include "beadmesh/mesh/face_mesher.h"

#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/mesh/subdivision_mesher.h"
#include "beadmesh/mesh/topological_cleanup.h"

namespace beadmesh {

Result<PlanarMesh> mesh_face(const NodeLoops& loops, const SurfaceMap& map, const FaceMesherOptions& options) {
  auto mesh = mesh_by_subdivision(loops, &map, {options.size, options.min_edge});
  if (!mesh) return mesh;
  smooth(*mesh, &map, {}, {options.size, options.min_edge});
  clean_up(*mesh, &map, {}, {options.size, options.min_edge});
  smooth(*mesh, &map, {}, {options.size, options.min_edge});
  return mesh;
}

}  // namespace beadmesh
