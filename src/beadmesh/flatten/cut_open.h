// Faces that close around themselves (tubes, cones, spheres, tori) cut open, so that they can be laid flat.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "beadmesh/flatten/flat_face.h"

namespace beadmesh {

/// A face laid flat, with what had to be cut for it.
struct OpenedFace {
  Facets facets;  ///< points added along a cut have panel_points no_index
  FlatFace flat;
  /// Per loop of `facets` and segment (i to i + 1): is it a side of a cut, which the face continues across.
  /// Empty where nothing was cut.
  std::vector<std::vector<bool>> cut_sides;
};

/// Length of the cuts on the surface, mm; each counts once although it has two sides.
double cut_length(const Facets& facets, const std::vector<std::vector<bool>>& cut_sides);

/// What the reader of a result must know of how its face came into the plane.
struct PlaneImage {
  Distortion distortion;
  double cut_length = 0;  ///< mm on the surface; 0: nothing was cut
  /// As OpenedFace::cut_sides, for the loops of the flat region.
  std::vector<std::vector<bool>> cut_sides;

  bool is_cut() const { return !cut_sides.empty(); }
};

/// Lays a face flat, cut as little as possible:
///  1. A seam (a pair of boundary stretches over the same panel points) that only closes the parameters of
///  the
///     surface is sewn up, and the face laid flat whole where that works: a dome of revolution is a disc.
///  2. A face that closes around itself stays cut along its seam; where it has none, along the shortest way
///     between its loops.
///  3. What still cannot be laid flat within the limit of distortion gets up to four cuts more, each from the
///     deepest point to the boundary (after Gu, Gortler, Hoppe 2002, "Geometry images").
/// Fails with flatten.* as `flatten` does; a piece with a handle and without a seam through it is refused.
Result<OpenedFace> lay_open(const Facets& facets, const FlattenOptions& options = {});

/// Turn of each loop in the piece itself, in full turns: the sum of pi less the angle of the piece, over 2
/// pi. About 1 for the outer loop of a flat piece, -1 for its holes, 0 for the ends of a cylinder.
std::vector<double> loop_turns(const Facets& facets);

/// Two loops between which a piece closes around itself like a tube, from its loop_turns: laid flat as a ring
/// it would be stretched at one of them and squeezed at the other. Nothing where one loop bounds the piece
/// and all others are holes in it.
std::optional<std::pair<std::size_t, std::size_t>> tube_ends(const std::vector<double>& turns);

}  // namespace beadmesh
