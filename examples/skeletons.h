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
/// `waves` arcs that turn to alternate sides, half an arc more at either end.
Footprint wavy_bead(double radius, double turn_degrees, int waves, double width);
/// Two legs and a concentric bend of `radius` between them.
Footprint l_bead(double leg, double other_leg, double radius, double turn_degrees, double width);
/// A three-quarter circle that ends in an inward leg.
Footprint g_bead(double radius, double leg, double width);
Footprint t_bead(double bar, double stem, double width, double fillet);
/// Three arms, 120 degrees apart.
/// A spine whose upper end bends into a tooth, and a second tooth in its middle.
Footprint f_bead(double spine, double tooth, double width, double fillet);
Footprint y_bead(double arm, double width, double fillet);
/// Two bars crossing in their middle at an angle.
Footprint x_bead(double bar, double crossing_degrees, double width, double fillet);
/// Two bars joined by a bridge between their middles.
Footprint h_bead(double bar, double bridge, double width, double fillet);
/// A spine with teeth at equal steps; the spine reaches half a step beyond the outer teeth.
Footprint comb_bead(int teeth, double step, double tooth, double width, double fillet);
/// A spine along an arc of `radius` with teeth outwards, `step_degrees` apart; it reaches one such step
/// beyond the outer teeth.
Footprint curved_comb_bead(int teeth, double radius, double step_degrees, double tooth, double width,
                           double fillet);
/// A trunk that forks twice: two limbs, each with two twigs.
Footprint tree_bead(double trunk, double limb, double twig, double width, double fillet);
/// A handle, a cross bar and three prongs.
Footprint trident_bead(double bar, double prong, double handle, double width, double fillet);
/// Two rails with rungs at equal steps, the rails reach half a step beyond: rungs - 1 windows.
Footprint ladder_bead(int rungs, double step, double gauge, double width, double fillet);

}  // namespace beadmesh::examples
