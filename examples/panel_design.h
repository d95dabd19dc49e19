// A panel as it was meant: base, features and their places. Plain data, from which the builder makes a B-rep
// and the tests take their expectations.
#pragma once

#include <string>
#include <vector>

#include "examples/footprint.h"

namespace beadmesh::examples {

/// The sheet without its features, as height over the plan: flat, a cylinder about an axis along y under the
/// sheet (`radius` > 0), or a polynomial.
struct Base {
  double radius = 0;              ///< mm, of the cylinder; 0: the polynomial
  double xx = 0, yy = 0, xy = 0;  ///< 1/mm
  double xxx = 0;                 ///< 1/mm^2

  bool is_flat() const { return radius == 0 && xx == 0 && yy == 0 && xy == 0 && xxx == 0; }
  double height(Vec2 p) const;
  /// Upward unit normal.
  Vec3 normal(Vec2 p) const;
  Vec3 point(Vec2 p) const { return {p.x, p.y, height(p)}; }
};

/// How the surface rises from the boundary to full height.
enum class Profile {
  hole,     ///< no face at all
  bead,     ///< round crest
  shoulder  ///< rounded step up to a flat top
};

/// How a CAD system would build a feature: strips of faces along its boundary, and a top.
struct Walls {
  double root_radius = 0;  ///< mm; 0: the feature is one face
  double angle = 0;        ///< radians, of the wall against the sheet
  double top_radius = 0;   ///< mm
  double run_out = 0;      ///< mm, over which the height falls at both ends along the feature's x axis
};

/// A feature in its place on the panel.
struct Feature {
  std::string shape;  ///< "straight", "taper", "arc", "S", "T", ..., "ring", or what it is instead of a bead
  std::string kind;   ///< what the paper's rule makes of it: "I", "generic", "annular"; empty where no bead
  Footprint footprint;
  Profile profile = Profile::bead;
  double height = 0;  ///< mm, negative downwards
  Vec2 origin;
  double angle = 0;       ///< radians
  std::string name = {};  ///< tells features of one shape apart ("wavy" is an S); empty: the shape

  Walls walls = {};

  /// The loops of the footprint on the panel, in plan.
  std::vector<PlanLoop> loops() const;
  /// The centre lines of the footprint on the panel, in plan.
  std::vector<PlanLoop> centrelines() const;
  /// Share of the full height at a point of the plan: less than 1 in run-outs.
  double height_share(Vec2 plan) const;
  /// Rise over the base at a point of the feature's own frame; `boundary` is that of the footprint.
  double rise(Vec2 local, const BoundaryDistance& boundary) const;
};

/// A flange turned down with a fillet along the straight part of the edge x = length / 2.
struct Flange {
  double fillet_radius = 0;  ///< mm; 0: no flange
  double length = 0;         ///< mm, below the fillet
};

struct PanelDesign {
  std::string name;
  double length = 0, width = 0;  ///< mm, along x and y; the panel is centred on the origin
  double corner_radius = 20;
  PlanLoop boundary;  ///< within length x width; empty: a rounded rectangle
  Base base;
  Flange flange;
  std::vector<Feature> features;

  PlanLoop outline() const {
    return boundary.empty() ? rounded_rectangle(length, width, corner_radius) : boundary;
  }
  int count(const std::string& kind) const;
};

}  // namespace beadmesh::examples
