// Inside the read room: one orientation for each connected piece of a panel.
#pragma once

#include <vector>

#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// Reverses triangles and loops; the evaluators are left to the caller.
void turn_over(PanelFace& face);

/// Turns faces over so that the two faces of every inner edge run through it in opposite directions. In each
/// connected piece the side that carries more area stays. Returns per face whether it was turned; names in
/// panel.diagnostics the pieces that have no orientation (a Moebius strip) and how many faces were turned.
std::vector<bool> orient_faces(Panel& panel);

}  // namespace beadmesh
