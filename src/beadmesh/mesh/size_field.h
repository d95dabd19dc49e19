// The target size where it is not the same everywhere.
#pragma once

#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/panel/chain.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// Inside the ball the target size is another one; outside it changes to the size around by 0.25 mm a mm.
struct LocalSize {
  Vec3 point;         ///< centre, mm
  double radius = 0;  ///< mm
  double size = 0;    ///< mm
};

/// How far the mesh may be off curves and surfaces by the sagitta of its edges.
struct ChordLimit {
  double deviation = 0;  ///< mm; 0: no limit
  double finest = 0;     ///< mm: no size falls below it
};

/// Fails with control.local_size where a radius or size is not above 0, or a size is under min_edge (mm).
Result<void> check_local_sizes(const std::vector<LocalSize>& local, double min_edge);

/// Target size along a chain: `at[i]` is the number of elements of the target size from its start to the arc
/// length `arc_length[i]`.
struct ChainSizing {
  std::vector<double> arc_length, at;
  double finest = 0;  ///< least target size on it, mm

  double count() const { return at.back(); }
  /// Arc lengths that cut the chain into elements in proportion to the target size; both ends among them.
  std::vector<double> stations(int elements) const;
};

class SizeField {
 public:
  SizeField(double size, std::vector<LocalSize> local, ChordLimit chord = {})
      : size_(size), local_(std::move(local)), chord_(chord) {}

  bool is_uniform() const { return local_.empty() && chord_.deviation <= 0; }
  /// Where balls overlap the last one holds.
  double at(Vec3 point) const;
  /// One size for the whole face: as many elements of it as of those of the field, no facet's element larger
  /// than its curvature allows.
  double of_face(const Facets& facets) const;
  ChainSizing along(const Panel& panel, const Chain& chain) const;
  /// Size whose sagitta on a curve of this curvature (1/mm) is the limit; infinite where there is none.
  double size_on_curvature(double curvature) const;

 private:
  double ramp_width(const LocalSize& local) const;
  bool varies_near(Vec3 centre, double reach) const;
  double elements_in(Vec3 a, Vec3 b, Vec3 c, double largest, int depth) const;

  double size_;
  std::vector<LocalSize> local_;
  ChordLimit chord_;
};

}  // namespace beadmesh
