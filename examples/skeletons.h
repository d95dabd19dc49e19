// Footprints of beads by the letter of their centre lines. Lengths in mm, between cap centres; widths are
// constant.
#pragma once

#include "examples/footprint.h"

namespace beadmesh::examples {

Footprint straight_bead(double length, double width);
/// Arc of the radius of its centre line.
Footprint arc_bead(double radius, double turn_degrees, double width);
/// Two arcs of opposite turn.
Footprint s_bead(double radius, double turn_degrees, double width);
/// Two legs and a concentric bend of `radius` between them.
Footprint l_bead(double leg, double other_leg, double radius, double turn_degrees, double width);
/// A three-quarter circle that ends in an inward leg.
Footprint g_bead(double radius, double leg, double width);
Footprint t_bead(double bar, double stem, double width, double fillet);
/// Three arms, 120 degrees apart.
Footprint y_bead(double arm, double width, double fillet);
/// Two bars crossing in their middle at an angle.
Footprint x_bead(double bar, double crossing_degrees, double width, double fillet);
/// Two bars joined by a bridge between their middles.
Footprint h_bead(double bar, double bridge, double width, double fillet);
/// A spine with teeth at equal steps; the spine reaches half a step beyond the outer teeth.
Footprint comb_bead(int teeth, double step, double tooth, double width, double fillet);
/// A handle, a cross bar and three prongs.
Footprint trident_bead(double bar, double prong, double handle, double width, double fillet);
/// Two rails with rungs at equal steps, the rails reach half a step beyond: rungs - 1 windows.
Footprint ladder_bead(int rungs, double step, double gauge, double width, double fillet);

}  // namespace beadmesh::examples
