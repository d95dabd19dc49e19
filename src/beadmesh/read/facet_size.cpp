#include "beadmesh/read/facet_size.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace beadmesh {
namespace {

constexpr double growth = 0.8;  // mm of facet size a mm of distance

Vec3 vec(const gp_Vec& v) {
  return {v.X(), v.Y(), v.Z()};
}

/// Knot spans of a B-spline surface between `low` and `high` (plain parameters).
std::array<int, 2> spans_between(const Geom_BSplineSurface& spline, Vec2 low, Vec2 high) {
  std::array<int, 2> spans{1, 1};
  for (int i = 1; i <= spline.NbUKnots(); ++i)
    spans[0] += spline.UKnot(i) > low.x && spline.UKnot(i) < high.x ? 1 : 0;
  for (int i = 1; i <= spline.NbVKnots(); ++i)
    spans[1] += spline.VKnot(i) > low.y && spline.VKnot(i) < high.y ? 1 : 0;
  return spans;
}

/// Sizes from a grid of points. A narrow stripe of strong curvature does not ask for facets as small as its
/// radius: what counts is how far the middle of a chord of a given length is from the surface.
class GridSizes {
 public:
  GridSizes(const Geom_Surface& surface, const FacetSize& size, int nx, int ny)
      : surface_(surface), size_(size), nx_(nx), ny_(ny) {}

  std::vector<double> sizes(Vec2 low, Vec2 step) {
    for (int j = 0; j < ny_; ++j)
      for (int i = 0; i < nx_; ++i) {
        const SurfaceFrame frame = frame_at(surface_, {low.x + i * step.x, low.y + j * step.y});
        points_.push_back(frame.point);
        normals_.push_back(normalized(cross(frame.du, frame.dv)));
      }
    std::vector<double> result(points_.size());
    for (int j = 0; j < ny_; ++j)
      for (int i = 0; i < nx_; ++i) {
        double h = size_.largest();
        for (const auto& [di, dj] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}})
          h = std::min(h, longest_chord(i, j, di, dj, h));
        result[at(i, j)] = std::max(h, size_.smallest());
      }
    return result;
  }

 private:
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * nx_ + i; }

  /// Longest chord centred at (i, j) whose middle is within the tolerance.
  double longest_chord(int i, int j, int di, int dj, double limit) const {
    for (int k = 1;; ++k) {
      const int i0 = i - k * di, i1 = i + k * di, j0 = j - k * dj, j1 = j + k * dj;
      if (std::min(i0, i1) < 0 || std::max(i0, i1) >= nx_ || std::min(j0, j1) < 0 || std::max(j0, j1) >= ny_)
        return limit;
      const Vec3 a = points_[at(i0, j0)], b = points_[at(i1, j1)];
      const double length = distance(a, b);
      const double off = std::abs(dot((a + b) / 2 - points_[at(i, j)], normals_[at(i, j)]));
      if (off > 0.8 * size_.chord()) return length * std::sqrt(0.8 * size_.chord() / off);
      if (length >= limit) return limit;
    }
  }

  const Geom_Surface& surface_;
  const FacetSize& size_;
  int nx_, ny_;
  std::vector<Vec3> points_, normals_;
};

}  // namespace

FacetSize::FacetSize(const ReadOptions& options, double model_diagonal)
    : chord_(std::max(options.chord, 1e-4)), angle_(std::clamp(options.angle, radians(1), radians(45))) {
  largest_ = std::clamp(model_diagonal / 12, 1e-3, 40.0);
  if (options.max_facet > 0) largest_ = std::min(largest_, options.max_facet);
  smallest_ = std::min(largest_, 16 * chord_);
}

double FacetSize::on_surface(double curvature) const {
  // Facets may turn more than edges do, since normals come from the surface.
  const double k = std::max(curvature, 1e-9);
  return std::clamp(std::min(std::sqrt(6.5 * chord_ / k), 2.5 * angle_ / k), smallest_, largest_);
}

double FacetSize::on_curve(double curvature) const {
  const double k = std::max(curvature, 1e-9);
  return std::clamp(std::min(std::sqrt(4 * chord_ / k), angle_ / k), smallest_, largest_);
}

SurfaceFrame frame_at(const Geom_Surface& surface, Vec2 uv) {
  gp_Pnt p;
  gp_Vec du, dv;
  surface.D1(uv.x, uv.y, p, du, dv);
  return {{p.X(), p.Y(), p.Z()}, vec(du), vec(dv)};
}

double largest_curvature(const Geom_Surface& surface, Vec2 uv) {
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv;
  surface.D2(uv.x, uv.y, p, du, dv, duu, dvv, duv);
  const double e = du.SquareMagnitude(), f = du.Dot(dv), g = dv.SquareMagnitude();
  const double det = e * g - f * f;
  if (!(det > 1e-12 * e * g)) return 0;
  const gp_Vec n = du.Crossed(dv) / std::sqrt(det);
  const double l = n.Dot(duu), m = n.Dot(duv), o = n.Dot(dvv);
  const double mean = (e * o - 2 * f * m + g * l) / (2 * det), gauss = (l * o - m * m) / det;
  const double k = std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
  return std::isfinite(k) ? k : 0;
}

Vec2 mean_stretch(const Geom_Surface& surface, Vec2 low, Vec2 high) {
  Vec2 sum;
  constexpr int n = 5;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec2 at{std::lerp(low.x, high.x, (i + 0.5) / n), std::lerp(low.y, high.y, (j + 0.5) / n)};
      const SurfaceFrame frame = frame_at(surface, at);
      sum += {norm(frame.du), norm(frame.dv)};
    }
  const auto usable = [](double x) { return x > 1e-9 && std::isfinite(x) ? x : 1.0; };
  return {usable(sum.x / (n * n)), usable(sum.y / (n * n))};
}

SizeField::SizeField(const Geom_Surface& surface, const FacetSize& size, Vec2 stretch, Vec2 low, Vec2 high)
    : low_(low) {
  const Vec2 extent{std::max(high.x - low.x, 1e-9), std::max(high.y - low.y, 1e-9)};
  const Vec2 plain_low{low.x / stretch.x, low.y / stretch.y},
      plain_high{high.x / stretch.x, high.y / stretch.y};
  const bool is_spline = surface.IsKind(STANDARD_TYPE(Geom_BSplineSurface));
  std::array<int, 2> least{16, 16};
  if (is_spline)
    least = spans_between(static_cast<const Geom_BSplineSurface&>(surface), plain_low, plain_high);
  const auto cells = [](double length, int spans) {
    return std::clamp(static_cast<int>(length / 3), std::clamp(2 * spans + 8, 16, 400), 400) + 1;
  };
  nx_ = cells(extent.x, least[0]);
  ny_ = cells(extent.y, least[1]);
  step_ = {extent.x / (nx_ - 1), extent.y / (ny_ - 1)};
  values_.assign(static_cast<std::size_t>(nx_) * ny_, size.largest());
  const Vec2 plain_step{step_.x / stretch.x, step_.y / stretch.y};
  if (is_spline) {
    values_ = GridSizes(surface, size, nx_, ny_).sizes(plain_low, plain_step);
  } else if (!surface.IsKind(STANDARD_TYPE(Geom_Plane))) {
    for (int j = 0; j < ny_; ++j)
      for (int i = 0; i < nx_; ++i)
        cell(i, j) =
            size.on_surface(largest_curvature(surface, plain_low + Vec2{i * plain_step.x, j * plain_step.y}));
  }
}

void SizeField::limit(Vec2 at, double size) {
  const int i = std::clamp(static_cast<int>(std::lround((at.x - low_.x) / step_.x)), 0, nx_ - 1);
  const int j = std::clamp(static_cast<int>(std::lround((at.y - low_.y) / step_.y)), 0, ny_ - 1);
  cell(i, j) = std::min(cell(i, j), size);
}

void SizeField::relax(int i, int j, int di, int dj) {
  if (i + di < 0 || i + di >= nx_ || j + dj < 0 || j + dj >= ny_) return;
  const double reach = std::hypot(di * step_.x, dj * step_.y);
  cell(i, j) = std::min(cell(i, j), cell(i + di, j + dj) + growth * reach);
}

void SizeField::smooth() {
  // Two chamfer sweeps: each cell looks at the half of its neighbours that the sweep has passed.
  for (int j = 0; j < ny_; ++j)
    for (int i = 0; i < nx_; ++i) {
      relax(i, j, -1, 0), relax(i, j, -1, -1), relax(i, j, 0, -1), relax(i, j, 1, -1);
    }
  for (int j = ny_ - 1; j >= 0; --j)
    for (int i = nx_ - 1; i >= 0; --i) {
      relax(i, j, 1, 0), relax(i, j, 1, 1), relax(i, j, 0, 1), relax(i, j, -1, 1);
    }
}

double SizeField::at(Vec2 stretched) const {
  // What is no number, as in damaged files, counts as the lower side.
  const auto within = [](double t, double most) { return t > 0 ? std::min(t, most) : 0.0; };
  const double x = within((stretched.x - low_.x) / step_.x, nx_ - 1.0);
  const double y = within((stretched.y - low_.y) / step_.y, ny_ - 1.0);
  const int i = std::min(static_cast<int>(x), nx_ - 2), j = std::min(static_cast<int>(y), ny_ - 2);
  const double fx = x - i, fy = y - j;
  return std::lerp(std::lerp(cell(i, j), cell(i + 1, j), fx),
                   std::lerp(cell(i, j + 1), cell(i + 1, j + 1), fx), fy);
}

}  // namespace beadmesh
