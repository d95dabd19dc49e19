// What fails in a finished mesh, mended by moving nodes.
#pragma once

#include <vector>

#include "beadmesh/mesh/quality_criteria.h"

namespace beadmesh {

struct ShellRepairOptions {
  double size = 5;                 ///< default 5 mm: target element length
  double min_edge = 2.5;           ///< default 2.5 mm: no edge becomes shorter
  double sharp = radians(30);      ///< default 30 degrees: edges with a greater turn stay
  std::vector<Index> groups = {};  ///< per element: nodes between elements of different groups stay
  std::vector<Index> kept = {};    ///< nodes that stay, such as those of crests
};

struct ShellRepairReport {
  int zones = 0;             ///< looked at
  std::vector<Index> moved;  ///< nodes, ascending
};

/// Around each element that fails, two rings of elements are laid flat and smoothed (smoothing.h) with their
/// outline, free edges, sharp edges and borders of groups fixed; places are on the surface that the mesh
/// spanned before. Kept where fewer elements of the zone fail and no edge has become shorter than the
/// minimum. Elements keep their nodes. Zones that cannot be laid flat are left alone. Deterministic.
ShellRepairReport repair_by_moving(std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
                                   const QualityCriteria& criteria, const ShellRepairOptions& options = {});

}  // namespace beadmesh
