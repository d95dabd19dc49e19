// A region triangulated on its own points, for tests of single stages.
#pragma once

#include "beadmesh/delaunay/boundary_samples.h"
#include "beadmesh/delaunay/triangulation.h"
#include "beadmesh/medial/axis_graph.h"
#include "beadmesh/medial/boundary_curve.h"
#include "medial/shapes.h"

namespace beadmesh::shapes {

struct SampledShape {
  BoundaryCurve curve;
  BoundarySamples samples;
  Triangulation triangulation;
};

inline Triangulation triangulated(const BoundarySamples& samples) {
  std::vector<Vec2> points;
  std::vector<std::vector<Index>> loops(samples.first.size() - 1);
  for (const BoundarySample& sample : samples.samples) {
    loops[sample.loop].push_back(static_cast<Index>(points.size()));
    points.push_back(sample.point);
  }
  return triangulate(points, loops).value();
}

inline SampledShape sampled(const PlanarRegion& region) {
  BoundaryCurve curve(checked_region(region).value(), radians(160));
  BoundarySamples samples = samples_of(curve.tagged_region());
  Triangulation triangulation = triangulated(samples);
  return {std::move(curve), std::move(samples), std::move(triangulation)};
}

}  // namespace beadmesh::shapes
