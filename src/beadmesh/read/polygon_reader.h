// Plane polygons with holes, from text.
#pragma once

#include <filesystem>
#include <string_view>

#include "beadmesh/core/result.h"
#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh {

// All three return a checked_region: loops ordered and oriented, its errors passed on, with loops and points
// counted as in the text. Their own errors name the line: read.wkt.syntax, read.wkt.arc (no arc through the
// points, or one that touches the boundary), read.poly.syntax, read.poly.loop (segments that form no closed
// loop), read.ending; and for files read.not_found, read.directory, read.empty, read.unreadable.

/// WKT: POLYGON((x y, ...), (...)), one polygon, also a MULTIPOLYGON of one; the words in any case; a third
/// and fourth coordinate are skipped. The closing point may repeat the first. CURVEPOLYGON with loops of
/// points, CIRCULARSTRING and COMPOUNDCURVE (SQL/MM): the region has exact arcs, facets of at most 7.5
/// degrees, and a corner tag wherever the tangent turns by more than 0.01 degrees.
Result<PlanarRegion> parse_wkt(std::string_view text);
/// Triangle's .poly: vertices, segments, holes; '#' starts a comment; vertices counted from 0 or 1,
/// attributes and boundary markers are skipped. Segments must form closed loops, in any order and direction;
/// vertices without a segment are left out. Loops inside the outer one are holes by their place; the hole
/// points are only read. Errors call the points vertices, by their numbers.
Result<PlanarRegion> parse_poly(std::string_view text);
/// By ending: .wkt, .poly.
Result<PlanarRegion> read_polygon(const std::filesystem::path& path);

}  // namespace beadmesh
