// Inside the read room: the components of a STEP assembly, with names and colours.
#pragma once

#include <TopoDS_Shape.hxx>
#include <XSControl_WorkSession.hxx>

#include "beadmesh/read/cad_model.h"

namespace beadmesh {

/// Lists the faces of the shape that the session's file became, each with its part: the innermost product it
/// belongs to, one part for each place where an assembly uses it. Names are those of the products, a repeated
/// one is numbered; colours are those of the product's solids, shells or first faces. STEP entities alone are
/// asked, since OpenCASCADE's documents (XDE) need its viewer's libraries.
void list_step_faces(const TopoDS_Shape& shape, const Handle(XSControl_WorkSession) & session,
                     CadModel& model);

}  // namespace beadmesh
