// A region triangulated on its own points, for tests of single stages.
#pragma once

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

inline BoundarySamples points_as_samples(const PlanarRegion& region) {
  BoundarySamples samples;
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    const PlanarLoop& loop = region.loops[l];
    samples.first.push_back(static_cast<Index>(samples.samples.size()));
    double position = 0;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      samples.samples.push_back({loop.points[i], static_cast<Index>(l), position, loop.corner[i], 0});
      position += distance(loop.points[i], loop.points[(i + 1) % loop.points.size()]);
    }
    samples.loop_length.push_back(position);
  }
  samples.first.push_back(static_cast<Index>(samples.samples.size()));
  return samples;
}

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
  BoundarySamples samples = points_as_samples(curve.tagged_region());
  Triangulation triangulation = triangulated(samples);
  return {std::move(curve), std::move(samples), std::move(triangulation)};
}

}  // namespace beadmesh::shapes
