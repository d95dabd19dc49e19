// A bead as CAD systems build it: strips of root fillet, drafted wall and top fillet along its boundary, and
// a top.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// A loop of a feature, counter-clockwise in plan, with its edges on the base.
struct BoundaryLoop {
  PlanLoop plan;
  std::vector<TopoDS_Edge> edges;  ///< along the plan's edges
  bool is_outer = true;            ///< the feature lies on its left
};

struct WalledFaces {
  std::vector<TopoDS_Face> faces;  ///< strips around each loop from the root upwards, then the top; look up
  std::vector<TopoDS_Edge> edges;  ///< the new ones
};

/// The edges of the loops receive their curves on the root strips.
WalledFaces walled_faces(const Base& base, const Feature& feature, const std::vector<BoundaryLoop>& loops);

}  // namespace beadmesh::examples
