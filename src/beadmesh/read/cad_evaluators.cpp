#include "beadmesh/read/cad_evaluators.h"

#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <utility>

namespace beadmesh {
namespace {

// D0 to D2 of Geom curves and surfaces keep no state between calls, unlike the adaptors, which cache spans.

class CadCurve : public CurveEvaluator {
 public:
  explicit CadCurve(Handle(Geom_Curve) curve) : curve_(std::move(curve)) {}
  Vec3 point(double t) const override {
    gp_Pnt p;
    curve_->D0(t, p);
    return {p.X(), p.Y(), p.Z()};
  }
  SpaceCurvePoint at(double t) const override {
    gp_Pnt p;
    gp_Vec v, a;
    curve_->D2(t, p, v, a);
    return {{p.X(), p.Y(), p.Z()}, {v.X(), v.Y(), v.Z()}, {a.X(), a.Y(), a.Z()}};
  }

 private:
  Handle(Geom_Curve) curve_;
};

class CadSurface : public SurfaceEvaluator {
 public:
  CadSurface(Handle(Geom_Surface) surface, bool turned) : surface_(std::move(surface)), turned_(turned) {}
  Vec3 point(Vec2 uv) const override {
    gp_Pnt p;
    surface_->D0(uv.x, uv.y, p);
    return {p.X(), p.Y(), p.Z()};
  }
  Vec3 normal(Vec2 uv) const override {
    gp_Pnt p;
    gp_Vec du, dv;
    surface_->D1(uv.x, uv.y, p, du, dv);
    const double scale = du.Magnitude() * dv.Magnitude();
    const gp_Vec n = turned_ ? dv.Crossed(du) : du.Crossed(dv);
    if (n.Magnitude() <= 1e-12 * scale) return {};
    return normalized(Vec3{n.X(), n.Y(), n.Z()});
  }

 private:
  Handle(Geom_Surface) surface_;
  bool turned_;
};

}  // namespace

std::shared_ptr<const CurveEvaluator> curve_of(const Handle(Geom_Curve) & curve) {
  return std::make_shared<CadCurve>(curve);
}

std::shared_ptr<const SurfaceEvaluator> surface_of(const Handle(Geom_Surface) & surface, bool turned) {
  return std::make_shared<CadSurface>(surface, turned);
}

}  // namespace beadmesh
