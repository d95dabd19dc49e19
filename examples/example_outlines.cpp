#include "examples/example_outlines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <utility>

#include "examples/step_file.h"

namespace beadmesh::examples {
namespace {

PlanLoop round_hole(double radius, Vec2 at) {
  return placed(circle(radius), at, 0);
}
PlanLoop slot(double length, double width, Vec2 at, double angle_degrees) {
  return placed(rounded_rectangle(length, width, width / 2), at, radians(angle_degrees));
}
PlanLoop window(double length, double width, double corner_radius, Vec2 at, double angle_degrees = 0) {
  return placed(rounded_rectangle(length, width, corner_radius), at, radians(angle_degrees));
}
PlanLoop polygon(const std::vector<Vec2>& corners, double radius) {
  return rounded_polygon(corners, std::vector<double>(corners.size(), radius));
}

/// A slot bent around `centre`, from `start` over `sweep` degrees.
PlanLoop kidney(Vec2 centre, double radius, double width, double start_degrees, double sweep_degrees) {
  const double start = radians(start_degrees), sweep = radians(sweep_degrees), half = width / 2;
  const auto at = [&](double angle) { return centre + Vec2{std::cos(angle), std::sin(angle)} * radius; };
  return {arc(centre, radius + half, start, sweep), arc(at(start + sweep), half, start + sweep, pi),
          arc(centre, radius - half, start + sweep, -sweep), arc(at(start), half, start + pi, pi)};
}

/// Half circles with centres that change sides, each larger by half the pitch: from (radius, 0) outwards.
std::vector<PlanEdge> half_circles(double radius, double pitch, int count) {
  std::vector<PlanEdge> edges;
  for (int i = 0; i < count; ++i)
    edges.push_back(arc({i % 2 == 0 ? 0 : pitch / 2, 0}, radius + i * pitch / 2, i * pi, pi));
  return edges;
}

ExampleOutline spiral_bowl() {
  constexpr int turns = 7;  // half ones
  const std::vector<PlanEdge> outside = half_circles(32, 46, turns), inside = half_circles(20, 42, turns);
  ExampleOutline bowl{"spiral-bowl", outside, {}, {.xx = 2.2e-3, .yy = 2.2e-3}};
  const auto cap = [](Vec2 from, Vec2 to) {  // a half circle, counter-clockwise
    const Vec2 d = from - to;
    return arc(lerp(from, to, 0.5), norm(d) / 2, std::atan2(d.y, d.x), pi);
  };
  bowl.outer.push_back(line(outside.back().end, inside.back().end));
  for (const PlanEdge& edge : reversed(inside)) bowl.outer.push_back(edge);
  bowl.outer.push_back(cap(inside.front().start, outside.front().start));
  return bowl;
}

ExampleOutline gasket() {
  ExampleOutline part{"gasket",
                      rounded_polygon({{-268, -92},
                                       {-205, -92},
                                       {-190, -100},
                                       {190, -100},
                                       {205, -92},
                                       {246, -92},
                                       {258, -60},
                                       {258, 55},
                                       {240, 96},
                                       {150, 96},
                                       {140, 102},
                                       {-140, 102},
                                       {-150, 96},
                                       {-268, 96}},
                                      {14, 8, 8, 8, 8, 16, 20, 20, 18, 6, 6, 6, 6, 14}),
                      {},
                      {}};
  for (int i = 0; i < 4; ++i) {
    const Vec2 bore{-144 + 102.0 * i, 0};
    part.holes.push_back(round_hole(43, bore));
    for (const double side : {90.0, 270.0}) {  // cooling above and below, oil return beside
      part.holes.push_back(kidney(bore, 56, 8, side - 24, 48));
      part.holes.push_back(kidney(bore, 57, 6, side - 44, 9));
      part.holes.push_back(
          round_hole(3.2, bore + Vec2{std::cos(radians(side + 40)), std::sin(radians(side + 40))} * 57));
      part.holes.push_back(window(18, 9, 3, bore + Vec2{0, side < 180 ? 76.0 : -76.0}));
    }
  }
  for (int i = 0; i < 5; ++i) {
    const double x = -195 + 102.0 * i;
    for (const double y : {-68.0, 68.0}) part.holes.push_back(round_hole(6.2, {x, y}));
    for (const double y : {-1.0, 1.0}) {
      if (i == 0 || i == 4) continue;
      part.holes.push_back(polygon({{x - 9 * y, 55 * y}, {x, 36 * y}, {x + 9 * y, 55 * y}}, 2));
      part.holes.push_back(slot(14, 5, {x, y * 87}, 0));
    }
  }
  part.holes.push_back(
      polygon({{-258, -52}, {-222, -58}, {-213, -20}, {-213, 20}, {-222, 58}, {-258, 52}}, 8));
  part.holes.push_back(round_hole(4, {-246, -78}));
  part.holes.push_back(round_hole(4, {-246, 80}));
  part.holes.push_back(polygon({{222, -40}, {244, -32}, {244, 20}, {226, 36}}, 6));
  part.holes.push_back(slot(26, 9, {232, 62}, 60));
  part.holes.push_back(round_hole(5, {236, -72}));
  return part;
}

/// Numbers of our own, the same on every machine.
class Numbers {
 public:
  double next(double low, double high) {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return low + (high - low) * static_cast<double>(state_ >> 33) / 2147483648.0;
  }

 private:
  std::uint64_t state_ = 20;
};

/// Adds a hole where its circle stays `gap` away from those of all before and from the edge.
class Board {
 public:
  explicit Board(ExampleOutline& part) : part_(part) {}

  bool add(const PlanLoop& hole, Vec2 at, double reach, double gap = 0.45) {
    for (const auto& [other, other_reach] : taken_)
      if (distance(at, other) < reach + other_reach + gap) return false;
    add_anyway(hole, at, reach);
    return true;
  }
  void add_anyway(const PlanLoop& hole, Vec2 at, double reach) {
    part_.holes.push_back(hole);
    taken_.emplace_back(at, reach);
  }
  /// Keeps later holes away from a box.
  void reserve(Vec2 low, Vec2 high) {
    for (double x = low.x; x <= high.x; x += 1)
      for (double y = low.y; y <= high.y; y += 1) taken_.emplace_back(Vec2{x, y}, 1.0);
  }
  /// Two rows of pins from `at` on, along x.
  void add_rows(Vec2 at, int pins, double across, double radius) {
    for (int i = 0; i < pins; ++i)
      for (const double y : {0.0, across}) {
        const Vec2 pin = at + Vec2{2.54 * i, y};
        add_anyway(round_hole(radius, pin), pin, radius);
      }
  }

 private:
  ExampleOutline& part_;
  std::vector<std::pair<Vec2, double>> taken_;
};

ExampleOutline circuit_board() {
  ExampleOutline part{"circuit-board",
                      rounded_polygon({{-80, -50},
                                       {-20, -50},
                                       {-20, -45},
                                       {18, -45},
                                       {18, -50},
                                       {80, -50},
                                       {80, -14},
                                       {75, -14},
                                       {75, 10},
                                       {80, 10},
                                       {80, 50},
                                       {-80, 50},
                                       {-80, 30},
                                       {-76, 30},
                                       {-76, 24},
                                       {-80, 24}},
                                      {3, 0, 1, 1, 0, 3, 0, 1, 1, 0, 3, 3, 0, 0, 0, 0}),
                      {},
                      {}};
  Board board(part);
  for (const Vec2 at : {Vec2{-75, -45}, Vec2{75, -45}, Vec2{75, 45}, Vec2{-75, 45}})
    board.add_anyway(round_hole(1.6, at), at, 3);
  board.reserve({-21, -50}, {19, -44});
  board.reserve({74, -15}, {80, 11});
  board.reserve({-80, 23}, {-75, 31});
  board.reserve({-62, 2}, {-24, 32});
  part.holes.push_back(window(36, 26, 0, {-43, 17}));  // a display
  board.reserve({22, -36}, {46, -10});
  part.holes.push_back(window(22, 12, 2, {34, -30}));
  part.holes.push_back(polygon({{25, -20}, {45, -20}, {45, -14}, {37, -14}, {37, -10}, {25, -10}}, 0));
  board.reserve({44, 14}, {68, 38});
  part.holes.push_back(round_hole(10, {56, 26}));  // a fan
  board.add_rows({-66, 39}, 20, 2.54, 0.5);
  board.add_rows({2, 39}, 20, 2.54, 0.5);
  board.add_rows({-66, -40}, 14, 7.62, 0.45);
  board.add_rows({-66, -22}, 14, 7.62, 0.45);
  board.add_rows({-18, -24}, 14, 15.24, 0.45);
  board.add_rows({-12, 4}, 20, 7.62, 0.4);
  board.add_rows({-12, 22}, 20, 7.62, 0.4);
  for (int i = 0; i < 6; ++i) {
    const Vec2 at{-70.0, -30 + 8.0 * i};
    board.add(slot(3.2, 1, at, 90), at, 1.8);
  }
  for (int i = 0; i < 7; ++i) {
    const Vec2 at{52 + 3.4 * i, -38};
    board.add(window(1.6, 4.4, 0, at), at, 2.6, 0.2);
  }
  Numbers numbers;
  for (int tries = 0, vias = 0; tries < 4000 && vias < 190; ++tries) {
    const double x = numbers.next(-77, 77), y = numbers.next(-47, 47), radius = numbers.next(0.2, 0.55);
    vias += board.add(round_hole(radius, {x, y}), {x, y}, radius);
  }
  return part;
}

ExampleOutline door() {
  ExampleOutline part{"door",
                      rounded_polygon({{-520, -330},
                                       {380, -330},
                                       {470, -250},
                                       {520, -60},
                                       {520, 110},
                                       {500, 150},
                                       {300, 390},
                                       {-60, 430},
                                       {-470, 330},
                                       {-560, 150},
                                       {-570, -100}},
                                      {70, 80, 90, 120, 40, 40, 60, 120, 60, 90, 140}),
                      {},
                      {.xx = -1.2e-4, .yy = -3.2e-4, .xxx = 3e-8}};
  const auto add = [&](const PlanLoop& hole) { part.holes.push_back(hole); };
  add(rounded_polygon({{-500, 150}, {420, 150}, {262, 350}, {-60, 385}, {-430, 297}},
                      {30, 24, 36, 90, 40}));  // pane
  add(rounded_polygon({{-215, -150}, {-150, -235}, {120, -235}, {175, -170}, {150, -70}, {-190, -70}},
                      {40, 40, 40, 40, 35, 35}));  // access to the winder
  add(rounded_polygon({{225, -200}, {330, -235}, {400, -190}, {380, -60}, {210, -60}}, {28, 34, 34, 28, 28}));
  add(round_hole(82, {-355, -175}));  // loudspeaker
  for (int i = 0; i < 6; ++i) {
    const double turn = radians(30 + 60 * i);
    add(round_hole(5, Vec2{-355, -175} + Vec2{std::cos(turn), std::sin(turn)} * 100));
  }
  add(window(120, 46, 14, {300, 40}, 4));  // handle
  add(slot(60, 16, {170, 40}, 0));
  add(window(70, 50, 10, {455, -10}, 78));  // lock
  add(round_hole(14, {450, 80}));
  add(slot(46, 18, {455, -130}, 75));
  add(polygon({{-480, 0}, {-440, -30}, {-400, 0}, {-400, 60}, {-470, 60}}, 10));  // hinges
  add(polygon({{-520, -130}, {-480, -110}, {-490, -30}, {-520, -40}}, 8));
  for (int i = 0; i < 4; ++i) add(slot(70, 22, {-310 + 110.0 * i, 60}, i % 2 ? 8 : -8));
  for (int i = 0; i < 3; ++i) add(kidney({-355, -175}, 138, 18, 40 + 34.0 * i, 22));
  for (int i = 0; i < 10; ++i) add(round_hole(i % 3 == 0 ? 11 : 7, {-420 + 84.0 * i, -292}));
  for (int i = 0; i < 11; ++i) add(round_hole(6, {-440 + 80.0 * i, 116}));
  for (int i = 0; i < 6; ++i) add(round_hole(5, {-250 + 90.0 * i, -30 - 6.0 * (i % 2)}));
  add(slot(40, 14, {-250, -255}, 30));
  add(slot(50, 14, {180, -262}, -12));
  add(round_hole(24, {-255, 5}));
  add(round_hole(18, {60, 0}));
  add(window(54, 30, 6, {-30, 5}, 0));
  add(window(30, 30, 0, {-160, 5}, 45));
  return part;
}

void put_point(std::string& text, Vec2 p) {
  char number[80];
  std::snprintf(number, sizeof number, "%.12g %.12g", p.x, p.y);
  text += number;
}

/// A loop of lines and arcs as a COMPOUNDCURVE; the end of each piece is the start of the next, bit for bit.
std::string compound_curve(const PlanLoop& loop) {
  std::string text = "COMPOUNDCURVE(";
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (i > 0) text += ", ";
    text += loop[i].is_arc() ? "CIRCULARSTRING(" : "(";
    put_point(text, loop[i].start);
    if (loop[i].is_arc()) text += ", ", put_point(text, loop[i].point(0.5));
    text += ", ";
    put_point(text, loop[(i + 1) % loop.size()].start);
    text += ")";
  }
  return text + ")";
}

bool write_wkt(const ExampleOutline& outline, const std::filesystem::path& path) {
  std::string text = "CURVEPOLYGON(" + compound_curve(outline.outer);
  for (const PlanLoop& hole : outline.holes) text += ",\n  " + compound_curve(hole);
  std::ofstream out(path);
  out << text << ")\n" << std::flush;
  return out.good();
}

/// The box of the outline, from the origin to the farthest point in x and y.
PanelDesign design_of(const ExampleOutline& outline) {
  PanelDesign design;
  design.name = outline.name;
  design.base = outline.base;
  design.boundary = outline.outer;
  for (const Vec2 p : sampled(outline.outer)) {
    design.length = std::max(design.length, 2 * std::abs(p.x) + 2);
    design.width = std::max(design.width, 2 * std::abs(p.y) + 2);
  }
  for (const PlanLoop& hole : outline.holes) {
    Feature feature;
    feature.shape = "hole";
    feature.footprint = blob(hole, 1);
    feature.profile = Profile::hole;
    design.features.push_back(std::move(feature));
  }
  return design;
}

}  // namespace

std::vector<std::string> outline_names() {
  return {"spiral-bowl", "gasket", "circuit-board", "door"};
}

std::optional<ExampleOutline> example_outline(const std::string& name) {
  if (name == "spiral-bowl") return spiral_bowl();
  if (name == "gasket") return gasket();
  if (name == "circuit-board") return circuit_board();
  if (name == "door") return door();
  return std::nullopt;
}

bool write_outline(const ExampleOutline& outline, const std::filesystem::path& path) {
  if (path.extension() == ".wkt") return write_wkt(outline, path);
  if (path.extension() == ".step") return write_panel(design_of(outline), path);
  return false;
}

}  // namespace beadmesh::examples
