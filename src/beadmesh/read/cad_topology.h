// Inside the read room: vertices, edges and the loops of faces, taken out of OpenCASCADE's shapes.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <array>
#include <vector>

#include "beadmesh/core/vector.h"
#include "beadmesh/read/cad_model.h"

namespace beadmesh {

/// A B-rep edge in the direction of its curve, and the points that all its faces share.
struct CadEdge {
  TopoDS_Edge edge;
  Handle(Geom_Curve) curve;  ///< null: a pole, where a side of the parameter domain is one point
  double first = 0, last = 0;
  Index first_vertex = no_index, last_vertex = no_index;  ///< equal on a closed edge
  std::vector<double> parameters;                         ///< rising; empty at a pole
  std::vector<Vec3> points;

  bool is_pole() const { return curve.IsNull(); }
};

/// One passage of a loop along an edge.
struct CadUse {
  Index edge = no_index;
  bool reversed = false;
  Handle(Geom2d_Curve) curve;  ///< in the parameters of the surface
  double first = 0, last = 0;  ///< range of `curve`; first belongs to CadEdge::first

  Vec2 uv(const CadEdge& edge, double t) const;
};

struct CadFace {
  Handle(Geom_Surface) surface;
  std::vector<std::vector<CadUse>> loops;  ///< head to tail
  bool broken = false;                     ///< a loop is open or an edge has no curve on the surface
};

struct CadTopology {
  std::vector<Vec3> vertices;
  std::vector<CadEdge> edges;
  std::vector<CadFace> faces;  ///< as CadModel::faces
};

CadTopology topology_of(const CadModel& model);

}  // namespace beadmesh
