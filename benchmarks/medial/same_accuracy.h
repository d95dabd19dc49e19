// The medial object of the outlines themselves against Boost's diagram of as many segments as it needs.
#pragma once

namespace beadmesh::bench {

/// Writes lines of JSON: samples or segments, time, and the greatest | r - distance to the outline | over the
/// diagonal of the region, the outline taken as it is, lines and arcs.
void compare_accuracy(double seconds);

}  // namespace beadmesh::bench
