// Inside the read room: how long facet edges may be.
#pragma once

#include <Geom_Surface.hxx>
#include <vector>

#include "beadmesh/core/vector.h"
#include "beadmesh/read/panel_reader.h"

namespace beadmesh {

/// Facet edge length that follows from a curvature (1/mm): sagitta under the chord tolerance, turn under the
/// angle.
class FacetSize {
 public:
  FacetSize(const ReadOptions& options, double model_diagonal);
  double on_surface(double curvature) const;
  double on_curve(double curvature) const;
  double chord() const { return chord_; }
  double largest() const { return largest_; }
  double smallest() const { return smallest_; }

 private:
  double chord_, angle_, largest_, smallest_;
};

/// Position and first derivatives.
struct SurfaceFrame {
  Vec3 point, du, dv;
};
SurfaceFrame frame_at(const Geom_Surface& surface, Vec2 uv);

/// The larger principal curvature, absolute, 1/mm; 0 where the surface is singular.
double largest_curvature(const Geom_Surface& surface, Vec2 uv);

/// Mean stretch of the parameters over a box, mm per unit of u and of v.
Vec2 mean_stretch(const Geom_Surface& surface, Vec2 low, Vec2 high);

/// Facet size over a box of stretched parameters, which grows by at most `growth` mm a mm away from small
/// ones.
class SizeField {
 public:
  /// low, high: box in stretched parameters (u * stretch.x, v * stretch.y).
  SizeField(const Geom_Surface& surface, const FacetSize& size, Vec2 stretch, Vec2 low, Vec2 high);
  /// The size near a boundary point is at most `size`. Takes effect at smooth().
  void limit(Vec2 at, double size);
  void smooth();
  double at(Vec2 stretched) const;

 private:
  double& cell(int i, int j) { return values_[static_cast<std::size_t>(j) * nx_ + i]; }
  double cell(int i, int j) const { return values_[static_cast<std::size_t>(j) * nx_ + i]; }
  void relax(int i, int j, int di, int dj);

  Vec2 low_, step_;
  int nx_, ny_;
  std::vector<double> values_;
};

}  // namespace beadmesh
