#include "examples/example_panels.h"

#include <algorithm>
#include <utility>

#include "examples/skeletons.h"

namespace beadmesh::examples {
namespace {

/// Where and how high: centre (mm), turn (degrees), height (mm, negative downwards).
struct Place {
  double x, y, angle, height;
};

Feature placed_feature(std::string shape, std::string kind, Footprint footprint, Profile profile, Place at) {
  return {std::move(shape), std::move(kind), std::move(footprint), profile,
          at.height,        {at.x, at.y},    radians(at.angle)};
}

Feature bead(std::string shape, Footprint footprint, Place at) {
  static const std::vector<std::string> one_edge{"I", "arc", "S", "L", "J", "U", "G"};
  const bool is_i = std::find(one_edge.begin(), one_edge.end(), shape) != one_edge.end();
  return placed_feature(std::move(shape), is_i ? "I" : "generic", std::move(footprint), Profile::bead, at);
}

Feature ring_bead(Footprint footprint, Place at) {
  return placed_feature("ring", "annular", std::move(footprint), Profile::bead, at);
}

Feature no_bead(std::string shape, Footprint footprint, Profile profile, Place at) {
  return placed_feature(std::move(shape), "", std::move(footprint), profile, at);
}

Feature round_hole(double radius, double x, double y) {
  return no_bead("hole", blob(circle(radius, 1), radius), Profile::hole, {x, y, 0, 0});
}
Feature slot_hole(double length, double width, Place at) {
  return no_bead("slot", straight_bead(length, width), Profile::hole, at);
}
Feature emboss(double radius, double x, double y, double height) {
  return no_bead("emboss", blob(circle(radius), radius), Profile::bead, {x, y, 0, height});
}
Feature plateau(double length, double width, Place at) {
  return no_bead("plateau", blob(rounded_rectangle(length, width, 16), 12), Profile::shoulder, at);
}
Feature sharp_pad(double length, double width, Place at) {
  return no_bead("pad", blob(rounded_rectangle(length, width, 0), width / 2), Profile::bead, at);
}

/// A ladder with two windows has three loops, which is one more than the paper's rule allows a bead.
Feature many_loops(Footprint footprint, Place at) {
  return no_bead("ladder", std::move(footprint), Profile::bead, at);
}

/// Rings whose loops are shared, the outermost first, alternately up and down.
std::vector<Feature> ring_cluster(double outer_radius, double width, int rings, Place at) {
  std::vector<Feature> result;
  for (int i = 0; i < rings; ++i) {
    result.push_back(ring_bead(circular_ring(outer_radius - i * width, width), at));
    at.height = -at.height;
  }
  return result;
}

void add(PanelDesign& panel, std::vector<Feature> features) {
  for (Feature& feature : features) panel.features.push_back(std::move(feature));
}

PanelDesign sheet(std::string name, double length, double width, Base base) {
  PanelDesign panel;
  panel.name = std::move(name);
  panel.length = length;
  panel.width = width;
  panel.base = base;
  return panel;
}

}  // namespace

PanelDesign single_panel() {
  PanelDesign panel = sheet("single", 200, 100, {});
  add(panel, {bead("I", straight_bead(104, 16), {0, 0, 0, 5})});
  return panel;
}

PanelDesign basic_panel() {
  PanelDesign panel = sheet("basic", 260, 200, {});
  add(panel, {
                 bead("I", straight_bead(84, 18), {-68, 72, 0, 6}),
                 bead("I", taper(76, 22, 13), {64, 68, 0, 5}),
                 bead("T", t_bead(104, 52, 15, 9), {-58, 4, 0, 5}),
                 ring_bead(circular_ring(44, 14), {70, -34, 0, 5}),
                 emboss(13, -98, -66, 3),
                 round_hole(9, -20, -70),
             });
  return panel;
}

PanelDesign rotated_panel() {
  PanelDesign panel = sheet("rotated", 320, 260, {});
  add(panel, {
                 bead("I", straight_bead(97, 21.3), {-93.1, 76.7, 23.4, 7.2}),
                 bead("I", taper(88, 13.1, 25.7), {76.2, 83.9, -31.7, -5.1}),
                 bead("T", t_bead(118, 57, 12.7, 7.3), {-72.4, -31.8, 128.6, 4.4}),
                 ring_bead(rounded_ring(112, 86, 27, 15.9), {79.3, -57.1, 17.9, -6.3}),
                 emboss(16.3, 2.3, 37.2, -3.7),
                 round_hole(11.7, -8.1, -94.6),
             });
  return panel;
}

PanelDesign curved_panel() {
  PanelDesign panel = sheet("curved", 460, 320, {.radius = 1400});
  add(panel, {
                 bead("arc", arc_bead(80, 75, 16), {-160, 115, 0, 5}),
                 bead("arc", arc_bead(45, 120, 12), {-40, 108, 200, -4}),
                 bead("S", s_bead(60, 60, 15), {85, 104, 14, 5}),
                 bead("I", straight_bead(90, 24), {188, 90, 80, 8}),
                 bead("X", x_bead(110, 75, 15, 8), {-155, 16, 20, 4.5}),
                 bead("L", l_bead(55, 45, 22, 90, 14), {-30, 8, 35, 5}),
                 bead("T", t_bead(90, 48, 13, 8), {82, 16, -105, 4}),
                 ring_bead(rounded_ring(110, 90, 24, 14), {-150, -96, 0, 5}),
                 slot_hole(34, 12, {183, -30, 40, 0}),
                 round_hole(10, -50, -70),
                 emboss(15, -45, -128, 3.5),
             });
  add(panel, ring_cluster(56, 14, 3, {60, -97, 0, 5}));
  add(panel, {bead("I", straight_bead(84, 12), {170, -105, -60, -4})});
  return panel;
}

PanelDesign floor_panel() {
  PanelDesign panel = sheet("floor", 710, 420, {.xx = -1.6e-4, .yy = -2.4e-4, .xxx = 4e-8});
  panel.flange = {8, 20};
  add(panel, {
                 bead("comb", comb_bead(5, 34, 46, 12, 8), {-155, 150, 0, 4.5}),
                 ring_bead(circular_ring(44, 13), {-7, 152, 0, 5}),
                 ring_bead(circular_ring(22, 11), {-7, 152, 0, 4}),
                 many_loops(ladder_bead(3, 30, 44, 11, 6), {100, 152, 0, 4}),
                 ring_bead(rounded_ring(86, 70, 20, 13), {205, 152, 12, 5}),
                 bead("J", l_bead(52, 10, 20, 150, 13), {297, 152, 60, 4.5}),
             });
  add(panel, {
                 bead("ladder", ladder_bead(2, 42, 46, 13, 8), {-303, 140, 90, 4.5}),
                 bead("U", l_bead(44, 44, 18, 180, 13), {-303, 25, 90, -4.5}),
                 ring_bead(rounded_ring(70, 52, 18, 14), {-303, -65, 0, 5}),
                 bead("arc", arc_bead(38, 130, 14), {-303, -155, 25, -5}),
             });
  add(panel, ring_cluster(46, 13, 3, {-205, 48, 0, 4.5}));
  add(panel, {
                 bead("Y", y_bead(44, 14, 8), {-107, 46, 10, 5}),
                 bead("X", x_bead(92, 80, 13, 8), {-3, 52, 30, 4}),
                 bead("H", h_bead(76, 52, 13, 8), {97, 52, 15, 4.5}),
                 bead("trident", trident_bead(60, 34, 38, 12, 7), {200, 52, 0, 4.5}),
                 bead("G", g_bead(30, 14, 12), {297, 52, 40, 4.5}),
                 bead("I", taper(72, 24, 12), {-230, -55, 90, 6}),
                 bead("I", straight_bead(70, 20), {-187, -55, 90, 7}),
                 bead("T", t_bead(84, 48, 14, 9), {-105, -52, 0, 5}),
                 bead("L", l_bead(48, 40, 20, 90, 13), {-5, -48, 0, -4.5}),
                 plateau(84, 62, {100, -50, -10, 6}),
                 ring_bead(rounded_ring(92, 56, 28, 13), {205, -50, -20, 5}),
                 bead("S", s_bead(40, 65, 13), {300, -50, 70, 4.5}),
                 bead("arc", arc_bead(60, 80, 15), {-210, -158, 30, 5.5}),
                 sharp_pad(72, 18, {-113, -130, 8, 4}),
                 slot_hole(44, 13, {-115, -175, 0, 0}),
                 bead("I", straight_bead(150, 28), {35, -128, 0, 8}),
                 emboss(14, -35, -176, 3),
                 round_hole(11, 20, -178),
                 round_hole(7, 60, -178),
                 bead("I", straight_bead(90, 16), {160, -165, 25, -5}),
                 bead("I", taper(78, 18, 10), {260, -140, -35, 4.5}),
                 bead("I", straight_bead(60, 10), {295, -190, 3, 3.5}),
             });
  return panel;
}

std::vector<std::string> example_names() {
  return {"single", "basic", "rotated", "curved", "floor"};
}

std::optional<PanelDesign> example_panel(const std::string& name) {
  if (name == "single") return single_panel();
  if (name == "basic") return basic_panel();
  if (name == "rotated") return rotated_panel();
  if (name == "curved") return curved_panel();
  if (name == "floor") return floor_panel();
  return std::nullopt;
}

}  // namespace beadmesh::examples
