// What the benchmark compares, each behind the same door.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::bench {

/// One run on an input that has been prepared before. Returns what it found, as text for the record (for
/// example "edges 61, junctions 30"); throws std::runtime_error where it failed.
using Run = std::function<std::string()>;

struct Candidate {
  std::string name;
  std::function<Run(const PlanarRegion&)> prepare;  ///< not timed: conversion of coordinates and the like
  int most_segments = 2'000'000;                    ///< too slow above
  bool may_crash = false;                           ///< runs in a process of its own, with a limit of time
};

struct Disc {
  Vec2 centre;
  double radius = 0;
};

std::vector<Candidate> our_candidates();
std::vector<Candidate> boost_candidates();
/// All vertices of Boost's diagram, inside and outside, in the region's coordinates.
std::vector<Disc> boost_discs(const PlanarRegion& region);
/// Only where CGAL was found (BEADMESH_ORACLE).
std::vector<Candidate> cgal_candidates();

}  // namespace beadmesh::bench
