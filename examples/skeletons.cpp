#include "examples/skeletons.h"

#include <cmath>

namespace beadmesh::examples {
namespace {

using Nodes = std::vector<Vec2>;
using Arms = std::vector<std::pair<int, int>>;

Vec2 polar(double radius, double angle_degrees) {
  return Vec2{std::cos(radians(angle_degrees)), std::sin(radians(angle_degrees))} * radius;
}

}  // namespace

Footprint straight_bead(double length, double width) {
  return strip({{.length = length}}, width);
}

Footprint arc_bead(double radius, double turn_degrees, double width) {
  return strip({{.radius = radius, .turn = radians(turn_degrees)}}, width);
}

Footprint s_bead(double radius, double turn_degrees, double width) {
  const double turn = radians(turn_degrees);
  return strip({{.radius = radius, .turn = turn}, {.radius = radius, .turn = -turn}}, width);
}

Footprint wavy_bead(double radius, double turn_degrees, int waves, double width) {
  const double turn = radians(turn_degrees);
  std::vector<PathStep> path{{.radius = radius, .turn = turn / 2}};
  for (int i = 0; i < waves; ++i) path.push_back({.radius = radius, .turn = i % 2 == 0 ? -turn : turn});
  path.push_back({.radius = radius, .turn = waves % 2 == 0 ? -turn / 2 : turn / 2});
  return strip(path, width);
}

Footprint l_bead(double leg, double other_leg, double radius, double turn_degrees, double width) {
  return strip({{.length = leg}, {.radius = radius, .turn = radians(turn_degrees)}, {.length = other_leg}},
               width);
}

Footprint g_bead(double radius, double leg, double width) {
  const double bend = width;
  return strip(
      {{.radius = radius, .turn = radians(250)}, {.radius = bend, .turn = radians(90)}, {.length = leg}},
      width);
}

Footprint t_bead(double bar, double stem, double width, double fillet) {
  return network(Nodes{{0, 0}, {-bar / 2, 0}, {bar / 2, 0}, {0, -stem}}, Arms{{0, 1}, {0, 2}, {0, 3}}, width,
                 fillet);
}

Footprint f_bead(double spine, double tooth, double width, double fillet) {
  return network(Nodes{{0, 0}, {0, spine / 2}, {0, spine}, {tooth, spine}, {tooth, spine / 2}},
                 Arms{{0, 1}, {1, 2}, {2, 3}, {1, 4}}, width, fillet);
}

Footprint y_bead(double arm, double width, double fillet) {
  return network(Nodes{{0, 0}, polar(arm, 90), polar(arm, 210), polar(arm, 330)},
                 Arms{{0, 1}, {0, 2}, {0, 3}}, width, fillet);
}

Footprint x_bead(double bar, double crossing_degrees, double width, double fillet) {
  const Vec2 a = polar(bar / 2, 0), b = polar(bar / 2, crossing_degrees);
  return network(Nodes{{0, 0}, a, b, -a, -b}, Arms{{0, 1}, {0, 2}, {0, 3}, {0, 4}}, width, fillet);
}

Footprint h_bead(double bar, double bridge, double width, double fillet) {
  const double x = bridge / 2, y = bar / 2;
  return network(Nodes{{-x, 0}, {x, 0}, {-x, y}, {-x, -y}, {x, y}, {x, -y}},
                 Arms{{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}}, width, fillet);
}

Footprint comb_bead(int teeth, double step, double tooth, double width, double fillet) {
  Nodes nodes{{-step / 2, 0}};
  Arms arms;
  int spine = 0;
  for (int i = 0; i < teeth; ++i) {
    const int root = int(nodes.size());
    nodes.push_back({i * step, 0});
    nodes.push_back({i * step, -tooth});
    arms.emplace_back(spine, root);
    arms.emplace_back(root, root + 1);
    spine = root;
  }
  nodes.push_back({(teeth - 0.5) * step, 0});
  arms.emplace_back(spine, int(nodes.size()) - 1);
  return network(nodes, arms, width, fillet);
}

Footprint curved_comb_bead(int teeth, double radius, double step_degrees, double tooth, double width,
                           double fillet) {
  const double half = width / 2, step = radians(step_degrees), outer = radius + half, tip = radius + tooth;
  // The fillets touch the spine's outer side and the tooth's flank.
  const double reach = outer + fillet, lean = std::asin((half + fillet) / reach);
  const double first = pi / 2 - (teeth + 1) * step / 2, last = first + (teeth + 1) * step;
  const auto at = [](double r, double angle) { return Vec2{std::cos(angle), std::sin(angle)} * r; };
  PlanLoop loop;
  double done = first;
  for (int i = 1; i <= teeth; ++i) {
    const double angle = first + i * step;
    loop.push_back(arc({}, outer, done, angle - lean - done));
    const PlanEdge in = arc(at(reach, angle - lean), fillet, angle - lean + pi, lean - pi / 2);
    const PlanEdge cap = arc(at(tip, angle), half, angle - pi / 2, pi);
    const PlanEdge out = arc(at(reach, angle + lean), fillet, angle - pi / 2, lean - pi / 2);
    loop.insert(loop.end(), {in, line(in.end, cap.start), cap, line(cap.end, out.start), out});
    done = angle + lean;
  }
  loop.push_back(arc({}, outer, done, last - done));
  loop.push_back(arc(at(radius, last), half, last, pi));
  loop.push_back(arc({}, radius - half, last, first - last));
  loop.push_back(arc(at(radius, first), half, first + pi, pi));
  Footprint result = blob(loop, half);
  result.centrelines.push_back({arc({}, radius, first, last - first)});
  for (int i = 1; i <= teeth; ++i)
    result.centrelines.push_back({line(at(radius, first + i * step), at(tip, first + i * step))});
  result.centreline_length = radius * (last - first) + teeth * tooth;
  centre_on_origin(result);
  return result;
}

Footprint tree_bead(double trunk, double limb, double twig, double width, double fillet) {
  const Vec2 fork{0, trunk}, left = fork + polar(limb, 145), right = fork + polar(limb, 35);
  return network(Nodes{{0, 0},
                       fork,
                       left,
                       right,
                       left + polar(twig, 90),
                       left + polar(twig, 200),
                       right + polar(twig, 90),
                       right + polar(twig, -20)},
                 Arms{{0, 1}, {1, 2}, {1, 3}, {2, 4}, {2, 5}, {3, 6}, {3, 7}}, width, fillet);
}

Footprint trident_bead(double bar, double prong, double handle, double width, double fillet) {
  const double x = bar / 2;
  return network(Nodes{{0, 0}, {-x, 0}, {x, 0}, {-x, prong}, {0, prong}, {x, prong}, {0, -handle}},
                 Arms{{0, 1}, {0, 2}, {1, 3}, {0, 4}, {2, 5}, {0, 6}}, width, fillet);
}

Footprint ladder_bead(int rungs, double step, double gauge, double width, double fillet) {
  Nodes nodes;
  Arms arms;
  for (const double y : {-gauge / 2, gauge / 2}) {
    const int first = int(nodes.size());
    nodes.push_back({-step / 2, y});
    for (int i = 0; i < rungs; ++i) nodes.push_back({i * step, y});
    nodes.push_back({(rungs - 0.5) * step, y});
    for (int i = first; i + 1 < int(nodes.size()); ++i) arms.emplace_back(i, i + 1);
  }
  for (int i = 1; i <= rungs; ++i) arms.emplace_back(i, rungs + 2 + i);
  return network(nodes, arms, width, fillet);
}

}  // namespace beadmesh::examples
