// Rings of quads around holes.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

/// What a user asks of the mesh around holes.
struct WasherControl {
  int rows = 1;                        ///< default 1: rings of quads around a hole; 0: none
  std::optional<double> width;         ///< of a ring, mm; default: the element size
  std::optional<double> min_diameter;  ///< mm; default 0: smaller holes have none
  std::optional<double> max_diameter;  ///< mm; default 10 sizes: larger openings have none
  std::optional<int> elements_around;  ///< even; default: by the size in the middle of the first ring

  bool operator==(const WasherControl&) const = default;
};

/// Fails with control.washer where a value makes no sense.
Result<void> check_washers(const WasherControl& control);

/// Width of a ring around a hole of this diameter, so that its quads fit: the one asked for, or less where
/// the hole is small. None where the hole gets no washer.
std::optional<double> washer_width(const WasherControl& control, double diameter, double size,
                                   double min_edge);

/// Rings wanted around a hole.
struct Washer {
  Index loop = 0;  ///< in NodeLoops; not the outer one
  int rows = 1;
  double width = 5;  ///< of a row, mm
};

/// Rings around one hole: a node for each node of the loop, from the hole outwards.
struct WasherRings {
  Index loop = 0;
  std::vector<std::vector<Vec2>> rings;
};

/// As many rings as there is room for: those that come nearer than 0.7 sizes to another loop or ring, fold,
/// or have edges under min_edge are left out. Holes without a ring are not in the result.
std::vector<WasherRings> washer_rings(const NodeLoops& loops, const std::vector<Washer>& wanted, double size,
                                      double min_edge);

/// The face outside of the rings, with node numbers of its own; loops in the same order.
NodeLoops outside_of_washers(const NodeLoops& loops, const std::vector<WasherRings>& washers);

/// Puts the rings to the mesh of what is outside of them. Nodes of `loops` come first, those of the rings are
/// fixed.
PlanarMesh with_washers(const NodeLoops& loops, const std::vector<WasherRings>& washers,
                        const PlanarMesh& outside);

}  // namespace beadmesh
