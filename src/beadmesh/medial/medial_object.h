// The typed medial object of a face (section 3.7 and table 2 of the paper).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/medial/sampled_boundary.h"

namespace beadmesh {

/// J junction; C end at a corner of the boundary; S end in a smooth cap (centre of its osculating arc);
/// isolated: the single vertex of a full disc.
enum class MedialVertexType { J, C, S, isolated };

/// Named by the types of the end vertices; N is closed and has none.
enum class MedialEdgeType { SS, SC, SJ, CC, CJ, JJ, N };

/// A touching point of an inscribed circle: its foot on the boundary.
struct Foot {
  Vec2 point;  ///< on the boundary: its exact curve, or the smooth curve through its facets' points
  Index loop = 0;
  double position = 0;  ///< arc length along the region's loop polyline
};

/// A stretch of the boundary that an inscribed circle touches all along, forward from start to end: arc
/// lengths along the region's loop polyline; end < start where it passes the loop's first point, equal where
/// it is the whole loop.
struct ContactInterval {
  Index loop = 0;
  double start = 0, end = 0;
};

struct MedialVertex {
  MedialVertexType type = MedialVertexType::J;
  Vec2 point;
  double radius = 0;
  std::vector<Foot> touching_points;  ///< a C: the corner; an S: both ends and the middle of the contact arc;
                                      ///< a J: 3 or more
  std::vector<ContactInterval> contact_intervals;  ///< finite contact zones: of most S, of a J on an arc
  std::vector<Index> edges;                        ///< incident edges, counter-clockwise; a loop edge twice
  bool merged = false;  ///< a J that stands for several near ones: on the axis between them, so that its
                        ///< circle touches at two points only; the other touching points lie outside it
};

struct MedialPoint {
  Vec2 point;
  double radius = 0;           ///< half the thickness
  std::array<Foot, 2> feet;    ///< left and right of the edge's direction
  double subtended_angle = 0;  ///< radians between the directions to the feet, in [0, pi]
};

/// Of an edge, between its points too: the radius is taken as the cubic with the slopes that the feet tell.
struct Thickness {
  double min = 0, mean = 0, max = 0;  ///< diameters; mean = integral over length
};

struct MedialEdge {
  MedialEdgeType type = MedialEdgeType::JJ;
  Index start = no_index, end = no_index;  ///< vertices; no_index for N
  std::vector<MedialPoint> points;         ///< from start to end, both included; N: first point not repeated
  double length = 0;
  Thickness thickness;
};

struct MedialObject {
  std::vector<MedialVertex> vertices;
  std::vector<MedialEdge> edges;
  Index loops = 1;  ///< boundary loops of the region
  double size = 0;  ///< diagonal of the region
};

struct MedialOptions {
  SamplingOptions sampling;
  double corner_angle =
      radians(160);           ///< default 160 degrees: sharper ends are C, where no tag decides (section 3.2)
  double contraction = 1e-3;  ///< default 1e-3: centres nearer than this times the radius are one
  double prune_protrusion = 0;  ///< default 0: from the sampling; leaves that add less than this are noise
  /// Default false. True: two junctions nearer than the local thickness, with concave boundary of one loop on
  /// both sides of the edge between them (the crossing of an X), become one (section 3.5); it is no longer
  /// equidistant from all that it stands for (MedialVertex::merged).
  bool merge_crossings = false;
  /// Default 2: passes of the cubic filter (section 3.6) where the boundary is noisy; everywhere without
  /// polish.
  int smoothing_passes = 2;
  /// Default true: centres moved to exact equidistance of the boundary's own pieces: straight segments,
  /// corners, exact curves; of facetted smooth curves (points without corner) a smooth curve through the
  /// facets' points.
  bool polish = true;
  /// Default 0: 1e-7 of the size, or more where that would take more than 1e5 points and 4 a sample. Greatest
  /// distance of the polyline of an edge from the axis, where the boundary is known so well.
  double chord = 0;
};

/// Sections 3.1 to 3.7: samples, triangulates, marches, contracts, prunes, cleans up, polishes, smooths, adds
/// feet. `region` must be a checked_region. Fails with medial.* or delaunay.*.
Result<MedialObject> medial_object(const PlanarRegion& region, const MedialOptions& options = {});

/// Checks: E - V + pieces = holes, types against degrees and ends, radii equal to the distance of the feet
/// and of the region's boundary (its exact curves, else its polyline: then the facets' sagitta must fit)
/// within `tolerance` (brute force), incidence both ways. Returns the violations in words.
std::vector<std::string> verify_medial_object(const MedialObject& object, const PlanarRegion& region,
                                              double tolerance);

std::string name_of(MedialVertexType type);
std::string name_of(MedialEdgeType type);

/// Point at a distance along an edge (clamped; modulo the length for N): position and feet interpolated, the
/// radius as for the thickness.
MedialPoint point_at(const MedialEdge& edge, double distance);

}  // namespace beadmesh
