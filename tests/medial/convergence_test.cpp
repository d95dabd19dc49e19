// How the error falls with the spacing of the samples.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "beadmesh/medial/medial_object.h"
#include "medial/axis_comparison.h"
#include "medial/exact_region.h"
#include "medial/reference_axis.h"

namespace beadmesh {
namespace {

using namespace exact_shapes;
using namespace reference;

MedialObject object_of(const PlanarRegion& region, const MedialOptions& options) {
  auto object = medial_object(region, options);
  EXPECT_TRUE(object) << (object ? "" : to_line(object.error()));
  return object ? *object : MedialObject{};
}

struct Study {
  std::string name;
  std::function<PlanarRegion(const Accuracy&)> make;
  Axis axis;
};

std::vector<Study> studies() {
  return {{"stadium", [](const Accuracy& a) { return stadium(104, 8, a); }, {straight({0, 0}, {104, 0})}},
          {"ring",
           [](const Accuracy& a) {
             return annulus(40, 20, {9, 4}, a);
           },
           annulus_axis(40, 20, {9, 4})},
          {"plate", [](const Accuracy& a) { return holed_plate(30, 12, a); }, holed_plate_axis(30, 12)}};
}

/// Distances to the exact axis, parts of the size: of the polylines, and of their points alone.
double axis_error(const MedialObject& object, const Axis& axis) {
  return hausdorff(object, axis).found_to_known / object.size;
}
double point_error(MedialObject object, const Axis& axis) {
  for (const MedialEdge& edge : object.edges)
    for (const MedialPoint& point : edge.points) object.vertices.emplace_back().point = point.point;
  object.edges.clear();
  return axis_error(object, axis);
}

double order(const std::vector<double>& errors) {
  return std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
}

// Facets stand for a smooth curve through their points, so that the axis is
// better than second order.
TEST(Convergence, FacetsOfAHalfTheLength) {
  for (const Study& study : studies()) {
    std::vector<double> errors;
    for (const double step : {12.0, 6.0, 3.0, 1.5})
      errors.push_back(point_error(object_of(study.make({false, radians(step), 0.3}), {}), study.axis));
    RecordProperty(study.name, testing::PrintToString(errors));
    EXPECT_LT(errors.back(), 1e-5) << study.name;
    if (errors.front() < 1e-9) continue;  // symmetric: exact at once
    EXPECT_GT(order(errors), 3) << study.name << ": " << testing::PrintToString(errors);
  }
}

// Without the polish the centres are those of the triangles: second order
// (section 3.1).
TEST(Convergence, CentresOfTrianglesAreSecondOrder) {
  for (const Study& study : studies()) {
    std::vector<double> errors;
    for (const double step : {12.0, 6.0, 3.0, 1.5}) {
      MedialOptions options;
      options.polish = false;
      options.sampling.spacing = 30 * radians(step);
      errors.push_back(point_error(object_of(study.make({true, radians(step), 0.3}), options), study.axis));
    }
    RecordProperty(study.name, testing::PrintToString(errors));
    if (errors.front() < 1e-9) continue;  // symmetric: the centres are exact at once
    EXPECT_GT(order(errors), 1.5) << study.name << ": " << testing::PrintToString(errors);
  }
}

// With it the samples decide the topology only: exact at any density.
TEST(Convergence, PolishedCentresAreExactAtAnySpacing) {
  for (const Study& study : studies())
    for (const double step : {15.0, 7.5, 3.0, 1.0}) {
      const PlanarRegion region = study.make({true, radians(step), 0.3});
      const MedialObject object = object_of(region, {});
      EXPECT_LT(radius_error(object, Boundary(region)) / object.size, 1e-10) << study.name << ", " << step;
      EXPECT_LT(axis_error(object, study.axis), 1.2e-7) << study.name << ", " << step;
    }
}

TEST(Convergence, PolylinesAreAsNearTheAxisAsAskedFor) {
  const PlanarRegion region = holed_plate(30, 12);
  std::size_t last = 0;
  for (const double chord : {1e-1, 1e-2, 1e-3, 1e-4}) {
    MedialOptions options;
    options.chord = chord;
    const MedialObject object = object_of(region, options);
    const Hausdorff error = hausdorff(object, holed_plate_axis(30, 12));
    EXPECT_LE(error.found_to_known, chord);
    EXPECT_LE(error.known_to_found, chord);
    std::size_t points = 0;
    for (const MedialEdge& edge : object.edges) points += edge.points.size();
    EXPECT_GE(points, last);
    last = points;
  }
}

}  // namespace
}  // namespace beadmesh
