// More samples where the triangulation shows that they are too coarse for the medial axis.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/delaunay/boundary_sampling.h"
#include "beadmesh/delaunay/triangulation.h"
#include "beadmesh/medial/boundary_curve.h"

namespace beadmesh {

/// Halves every boundary edge longer than the circumradius of its triangle, and the two edges at a convex
/// corner that has no triangle of its own. New samples lie on the smooth curve, so that a facetted arc is not
/// flattened further. Nothing where all is well. A corner's own triangle is left alone: its radius goes to
/// zero with its sides.
std::optional<BoundarySamples> refined_samples(const BoundarySamples& samples,
                                               const Triangulation& triangulation,
                                               const BoundaryCurve& curve);

/// The samples and new ones at these contacts, where there is none near. Nothing where no new one is needed.
std::optional<BoundarySamples> with_contacts(const BoundarySamples& samples,
                                             const std::vector<Contact>& contacts,
                                             const BoundaryCurve& curve);

}  // namespace beadmesh
