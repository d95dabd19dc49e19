#include "beadmesh/mesh/node_motion.h"

#include <algorithm>
#include <array>

#include "beadmesh/mesh/element_corners.h"

namespace beadmesh {
namespace {

/// Distance from the surface that weighs as much as a poor shape, as a share of the size.
constexpr double surface_share = 0.08;

/// Weight of crest edges among all places looked at: the crest is what the mesh is made for.
constexpr double crest_weight = 8;

/// Places on an edge that are looked at, as shares of its length.
constexpr std::array<double, 2> places_on_edge{0.3, 0.7};
/// Places of an element that remember their facet: two an edge and the centre.
constexpr int places_of_element = 9;

/// Warpage up to which nothing is done about it: criteria of crash models let no element have more than 15
/// degrees.
constexpr double fair_warpage = radians(12);
constexpr double warpage_weight = 2;
/// Distance of crest edges from the surface, as a share of the size, that less warpage is not worth.
constexpr double crest_share = 0.02;
constexpr double crest_wall = 40;
/// Least over largest determinant at the Gauss points that is aimed at: programs let elements fail under 0.6.
constexpr double evenness_aim = 0.68;
/// The same for what is not to be made worse while warpage is taken away, and how far under it costs 1.
constexpr double fair_evenness = 0.64, evenness_scale = 0.04;
/// Sides up to so many sizes are fair; criteria let them have two.
constexpr double fair_length = 1.9, length_scale = 0.1;

double square(double x) {
  return x * x;
}

bool looks_at_surface(MotionAim aim) {
  return aim == MotionAim::surface || aim == MotionAim::flat;
}

/// Grows with the squared angle between the two triangles of a quad, summed over both diagonals.
double warpage_cost(const CornerPlaces& places) {
  Vec3 side[4], normal[4];
  for (int i = 0; i < 4; ++i) side[i] = places.space((i + 1) % 4) - places.space(i);
  for (int i = 0; i < 4; ++i) normal[i] = normalized(cross(side[(i + 3) % 4], side[i]));
  const double angles = 2 * (2 - dot(normal[0], normal[2]) - dot(normal[1], normal[3]));
  return warpage_weight * square(std::max(0.0, angles / square(fair_warpage) - 1));
}

/// Grows where a quad falls short of what criteria ask besides warpage: evenness and long sides.
double failing_cost(const CornerShapes& corners, double size) {
  const double uneven = std::max(0.0, fair_evenness - corners.evenness()) / evenness_scale;
  const double longest = *std::max_element(corners.side.begin(), corners.side.begin() + corners.count);
  const double too_long = std::max(0.0, longest / size - fair_length) / length_scale;
  return square(uneven) + square(too_long);
}

}  // namespace

double signed_quality(const SurfaceNodes& nodes, const MeshElement& element) {
  return signed_quality(places_of(nodes, element));
}

double evenness(const SurfaceNodes& nodes, const MeshElement& element) {
  return shapes_of(places_of(nodes, element)).evenness();
}

double NodeMotion::worst_around(Index node) const {
  double worst = 1;
  for (const Index e : mesh_.star(node)) worst = std::min(worst, signed_quality(nodes_, mesh_.element(e)));
  return worst;
}

double NodeMotion::evenness_around(Index node) const {
  double least = 1;
  for (const Index e : mesh_.star(node)) least = std::min(least, evenness(nodes_, mesh_.element(e)));
  return least;
}

double NodeMotion::shortfall(Index node) const {
  double shortest = limits_.min_edge;
  for (const Index e : mesh_.star(node)) {
    const auto [next, previous] = corner_neighbours(mesh_.element(e), node);
    shortest = std::min({shortest, distance(nodes_.space(node), nodes_.space(next)),
                         distance(nodes_.space(node), nodes_.space(previous))});
  }
  return 1 - shortest / limits_.min_edge;
}

void NodeMotion::gather(Index node, MotionAim aim) const {
  star_.gather(node, nodes_, mesh_);
  if (looks_at_surface(aim)) star_.gather_edges(node, mesh_, lines_);
}

/// Of the node whose star is gathered, where that star has been moved to.
NodeMotion::State NodeMotion::measure(MotionAim aim) const {
  // Near the minimum edge length a soft wall begins; what is below it weighs more than any shape.
  const double soft = 1.2 * limits_.min_edge, width = soft - limits_.min_edge, long_side = 1.6 * limits_.size;
  const double wall = aim == MotionAim::edges ? 2000 : 50;
  const bool near_surface = looks_at_surface(aim);
  State state;
  state.worst = 1;
  for (const StarElement& element : star_.elements()) {
    const double orientation = flat_orientation(element.places);
    const CornerShapes corners = shapes_of(element.places);
    state.worst = std::min(state.worst, orientation > 0 ? corners.worst : orientation - 1);
    if (orientation <= 0) state.cost += 20 * (1 - orientation);
    if (aim == MotionAim::flat && corners.count == 4) state.cost += warpage_cost(element.places);
    if (aim == MotionAim::even) state.cost += 40 * square(std::max(0.0, evenness_aim - corners.evenness()));
    if (aim == MotionAim::flat) state.cost += failing_cost(corners, limits_.size);
    for (int i = 0; i < corners.count; ++i) {
      const double t = square(1 - corners.jacobian[i]);
      state.cost += aim == MotionAim::worst || aim == MotionAim::even ? t + 30 * t * t * t : t + 4 * t * t;
      // Seen from the surface alone, skew costs nothing: rows would run zigzag.
      if (near_surface) state.cost += 1 - corners.jacobian[i];
      if (corners.jacobian[i] < limits_.aim) state.cost += 40 * square(limits_.aim - corners.jacobian[i]);
      if (!element.is_own[i]) continue;
      const double side = corners.side[i];
      if (side < soft) state.cost += 0.5 * square((soft - side) / width);
      if (side < limits_.min_edge) {
        const double missing = square((limits_.min_edge - side) / width);
        state.cost += wall * missing;
        state.shortage += missing;
      }
      if (side > long_side) state.cost += 0.5 * square((side - long_side) / limits_.size);
    }
  }
  if (near_surface) add_deviations(aim, state);
  return state;
}

/// Distances from the surface of places on the elements around the node and on the edges that end there, with
/// weights. The flat point of a place on an element is near that place's nearest surface point: what counts
/// is the distance along the element's normal.
template <class Visit>
void NodeMotion::visit_deviations(Visit visit) const {
  along_edges_.resize(star_.edge_count());
  for (const StarElement& element : star_.elements()) {
    const int count = element.places.count;
    Vec2 flat[4], flat_sum;
    Vec3 space[4], space_sum;
    for (int i = 0; i < count; ++i) {
      const int corner = (element.at + i) % count;
      flat[i] = element.places.flat[corner], flat_sum += flat[i];
      space[i] = element.places.space(corner), space_sum += space[i];
    }
    const Vec3 normal = normalized(cross(space[1] - space[0], space[count - 1] - space[0]));
    const auto add = [&](const Vec3& on_surface, const Vec3& on_element, double weight) {
      visit(std::abs(dot(on_surface - on_element, normal)), weight);
    };
    for (const int side : {0, 1}) {
      const StarElement::Edge& edge = element.edges[side];
      const int k = side == 0 ? 1 : count - 1;
      std::array<Vec3, 2>& surface = along_edges_[edge.number];
      if (edge.is_first) surface = surface_along(element, side, flat[0], flat[k]);
      for (size_t i = 0; i < places_on_edge.size(); ++i)
        add(surface[i], lerp(space[0], space[k], places_on_edge[i]), edge.is_crest ? crest_weight : 0.5);
    }
    add(surface_at(flat_sum / count, element.element, places_of_element - 1), space_sum / count, 1.0);
  }
}

void NodeMotion::prepare_for_surface() {
  facet_hints_->assign(static_cast<size_t>(mesh_.element_count()) * places_of_element, no_index);
}

/// A place moves little from one look to the next: the search starts where it ended before.
Vec3 NodeMotion::surface_at(Vec2 flat, Index element, int slot) const {
  Index& hint = (*facet_hints_)[static_cast<size_t>(element) * places_of_element + slot];
  if (hint == no_index) hint = nodes_[mesh_.element(element)[0]].triangle;
  const SurfacePlace place = nodes_.place(flat, hint);
  hint = place.triangle;
  return place.space;
}

/// Surface at the places of an edge of the element: the one that leaves the node (side 0), or the one that
/// arrives.
std::array<Vec3, 2> NodeMotion::surface_along(const StarElement& element, int side, Vec2 node,
                                              Vec2 end) const {
  const int count = element.places.count;
  const int edge = side == 0 ? element.at : (element.at + count - 1) % count;
  std::array<Vec3, 2> surface;
  for (int i = 0; i < 2; ++i)
    surface[i] = surface_at(lerp(node, end, places_on_edge[i]), element.element, 2 * edge + (i ^ side));
  return surface;
}

void NodeMotion::add_deviations(MotionAim aim, State& state) const {
  visit_deviations([&](double deviation, double weight) {
    state.cost += 0.4 * weight * square(square(deviation / (surface_share * limits_.size)));
    if (aim == MotionAim::flat && weight == crest_weight)
      state.cost += crest_wall * square(std::max(0.0, deviation / (crest_share * limits_.size) - 1));
    state.deviation = std::max(state.deviation, deviation);
  });
}

double NodeMotion::deviation(Index node) const {
  gather(node, MotionAim::surface);
  double largest = 0;
  visit_deviations([&](double deviation, double) { largest = std::max(largest, deviation); });
  return largest;
}

double NodeMotion::cost_at(const SurfacePlace& place, MotionAim aim) {
  star_.move_to(place);
  return measure(aim).cost;
}

/// Scaled Jacobian above which a step may make elements worse. Far from the surface, shape gives way.
double NodeMotion::floor_of(const State& before, MotionAim aim) const {
  if (aim == MotionAim::edges) return 0.25;
  if (aim == MotionAim::flat) return limits_.flat_floor;
  if (aim != MotionAim::surface) return limits_.floor;
  // Rings: shapes that are better than what others strive for are kept.
  if (limits_.flat_floor > limits_.aim) return limits_.flat_floor;
  return before.deviation > 1.5 * surface_share * limits_.size ? 0.7 : 0.97 * limits_.aim;
}

/// Guards: no new or greater shortage of edges, no worse element below the floor, and a gain (a variational
/// step need not gain).
bool NodeMotion::keep_if_better(Index node, const SurfacePlace& place, const State& before, MotionAim aim) {
  star_.move_to(place);
  const State after = measure(aim);
  const double floor = floor_of(before, aim);
  const bool kept = after.cost < before.cost * (1 - 1e-7) && after.shortage <= before.shortage &&
                    after.worst >= std::min(before.worst, floor);
  if (!kept) return false;
  last_step_ = distance(nodes_[node].flat, place.flat);
  nodes_.set(node, place);
  return true;
}

bool NodeMotion::untangle(Index node) {
  if (freedom_[node] != NodeFreedom::free) return false;
  // Twice the area of a corner triangle is linear in the node's position: n . x + c.
  struct Term {
    Vec2 n;
    double c;
  };
  std::vector<Term> terms;
  double scale = 0;
  const auto add = [&](Index a, Index b) {  // triangle (node, a, b), counter-clockwise
    const Vec2 pa = nodes_.flat(a), pb = nodes_.flat(b);
    terms.push_back({left_normal(pb - pa), cross(pa, pb)});
    scale += squared_norm(pb - pa);
  };
  for (const Index e : mesh_.star(node)) {
    const MeshElement& element = mesh_.element(e);
    const auto [next, previous] = corner_neighbours(element, node);
    add(next, previous);
    if (!is_quad(element)) continue;
    const Index opposite = element[(corner_of(element, node) + 2) % 4];
    add(next, opposite);
    add(opposite, previous);
  }
  const double target = 0.15 * scale / static_cast<double>(terms.size());
  const Vec2 start = nodes_.flat(node);
  Vec2 x = start;
  for (int round = 0; round < 12; ++round) {
    double gx = 0, gy = 0, hxx = 1e-9 * scale, hxy = 0, hyy = 1e-9 * scale;
    for (const Term& term : terms) {
      const double missing = target - dot(term.n, x) - term.c;
      if (missing <= 0) continue;
      gx -= missing * term.n.x, gy -= missing * term.n.y;
      hxx += term.n.x * term.n.x, hxy += term.n.x * term.n.y, hyy += term.n.y * term.n.y;
    }
    const double determinant = hxx * hyy - hxy * hxy;
    if (!(determinant > 0) || (gx == 0 && gy == 0)) break;
    const Vec2 step = {-(hyy * gx - hxy * gy) / determinant, -(hxx * gy - hxy * gx) / determinant};
    x += step;
    if (squared_norm(step) < 1e-10 * squared_norm(x - start)) break;
  }
  if (!std::isfinite(x.x) || !std::isfinite(x.y) || x == start) return false;
  last_step_ = distance(start, x);
  nodes_.set(node, nodes_.place(x, nodes_[node].triangle));
  return true;
}

/// Neighbours in turn and the far corners between them, counter-clockwise; false where not all are quads in a
/// closed fan.
bool NodeMotion::fan(Index node, std::vector<Index>& sides, std::vector<Index>& diagonals) const {
  sides.clear();
  diagonals.clear();
  const std::vector<Index>& star = mesh_.star(node);
  Index element = star.front();
  for (size_t i = 0; i < star.size(); ++i) {
    if (element == no_index || !is_quad(mesh_.element(element))) return false;
    const MeshElement& corners = mesh_.element(element);
    const int at = corner_of(corners, node);
    sides.push_back(corners[(at + 1) % 4]);
    diagonals.push_back(corners[(at + 2) % 4]);
    element = mesh_.element_with_edge(node, corners[(at + 3) % 4]);
  }
  return element == star.front();
}

Vec2 NodeMotion::winslow(std::span<const Index> sides, std::span<const Index> diagonals) const {
  // alpha x_uu - 2 beta x_uv + gamma x_vv = 0 with the metric of the surface; u: sides 2 -> 0, v: sides 3
  // -> 1.
  const Vec3 du = (nodes_.space(sides[0]) - nodes_.space(sides[2])) / 2;
  const Vec3 dv = (nodes_.space(sides[1]) - nodes_.space(sides[3])) / 2;
  const double alpha = squared_norm(dv), beta = dot(du, dv), gamma = squared_norm(du);
  const Vec2 mixed = (nodes_.flat(diagonals[0]) - nodes_.flat(diagonals[1]) + nodes_.flat(diagonals[2]) -
                      nodes_.flat(diagonals[3])) /
                     4;
  const Vec2 sum = alpha * (nodes_.flat(sides[0]) + nodes_.flat(sides[2])) +
                   gamma * (nodes_.flat(sides[1]) + nodes_.flat(sides[3])) - 2 * beta * mixed;
  return sum / (2 * (alpha + gamma));
}

Vec2 NodeMotion::isoparametric(std::span<const Index> sides, std::span<const Index> diagonals) const {
  // Herrmann 1976 with weight 1/2: half way between Laplace and isoparametric.
  Vec2 sum;
  for (size_t i = 0; i < sides.size(); ++i)
    sum += 2 * nodes_.flat(sides[i]) - 0.5 * nodes_.flat(diagonals[i]);
  return sum / (1.5 * static_cast<double>(sides.size()));
}

Vec2 NodeMotion::length_weighted(Index node) const {
  Vec2 sum;
  double weights = 0;
  for (const Index e : mesh_.star(node)) {
    const Index next = corner_neighbours(mesh_.element(e), node).first;
    const double length = distance(nodes_.space(node), nodes_.space(next));
    sum += length * nodes_.flat(next);
    weights += length;
  }
  return weights > 0 ? sum / weights : nodes_.flat(node);
}

bool NodeMotion::relax(Index node) {
  const SurfacePlace old = nodes_[node];
  if (freedom_[node] != NodeFreedom::free) {
    if (!is_movable(node)) return false;
    const double shift = lines_.shift_to_middle(node);
    const SurfacePlace middle = nodes_.place(lines_.shifted(node, shift), old.triangle);
    if (std::abs(shift) < 1e-3 * limits_.size) return false;
    gather(node, MotionAim::mean);
    if (!keep_if_better(node, middle, measure(MotionAim::mean), MotionAim::mean)) return false;
    lines_.slide(node, shift);
    return true;
  }
  Vec2 target;
  if (!fan(node, sides_, diagonals_))
    target = length_weighted(node);
  else if (sides_.size() == 4)
    target = winslow(sides_, diagonals_);
  else
    target = isoparametric(sides_, diagonals_);
  if (!std::isfinite(target.x) || !std::isfinite(target.y)) return false;
  if (distance(target, old.flat) < 1e-3 * limits_.size) return false;
  gather(node, MotionAim::mean);
  return keep_if_better(node, nodes_.place(target, old.triangle), measure(MotionAim::mean), MotionAim::mean);
}

bool NodeMotion::optimise(Index node, MotionAim aim) {
  if (freedom_[node] == NodeFreedom::free) return optimise_free(node, aim);
  return freedom_[node] == NodeFreedom::sliding && lines_.slides(node) && optimise_sliding(node, aim);
}

bool NodeMotion::optimise_free(Index node, MotionAim aim) {
  const SurfacePlace old = nodes_[node];
  gather(node, aim);
  const State before = measure(aim);
  const double h = 0.01 * limits_.size;
  const auto cost = [&](double x, double y) {
    return cost_at(nodes_.place({old.flat.x + x, old.flat.y + y}, old.triangle), aim);
  };
  const double right = cost(h, 0), left = cost(-h, 0), up = cost(0, h), down = cost(0, -h), both = cost(h, h);
  const double gx = (right - left) / (2 * h), gy = (up - down) / (2 * h);
  double hxx = (right + left - 2 * before.cost) / (h * h), hyy = (up + down - 2 * before.cost) / (h * h);
  const double hxy = (both - right - up + before.cost) / (h * h);
  // Shifted until positive definite.
  const double mean = (hxx + hyy) / 2, spread = std::sqrt(square((hxx - hyy) / 2) + square(hxy));
  const double least = mean - spread, wanted = 0.05 * (std::abs(mean) + spread) + 1e-9;
  const double shift = least < wanted ? wanted - least : 0;
  hxx += shift, hyy += shift;
  const double determinant = hxx * hyy - hxy * hxy;
  Vec2 step = {-(hyy * gx - hxy * gy) / determinant, -(hxx * gy - hxy * gx) / determinant};
  const double length = norm(step), longest = 0.4 * limits_.size;
  if (!std::isfinite(length) || length < 1e-4 * limits_.size) return false;
  if (length > longest) step = step * (longest / length);
  for (int halving = 0; halving < 5; ++halving, step = step / 2)
    if (keep_if_better(node, nodes_.place(old.flat + step, old.triangle), before, aim)) return true;
  return false;
}

bool NodeMotion::optimise_sliding(Index node, MotionAim aim) {
  const SurfacePlace old = nodes_[node];
  gather(node, aim);
  const State before = measure(aim);
  const double h = 0.01 * limits_.size;
  const auto place = [&](double shift) { return nodes_.place(lines_.shifted(node, shift), old.triangle); };
  const double ahead = cost_at(place(h), aim), back = cost_at(place(-h), aim);
  const double slope = (ahead - back) / (2 * h), bend = (ahead + back - 2 * before.cost) / (h * h);
  double step = bend > 0 ? -slope / bend : (slope > 0 ? -0.1 : 0.1) * limits_.size;
  if (!std::isfinite(step)) return false;
  step = std::clamp(step, -0.4 * limits_.size, 0.4 * limits_.size);
  for (int halving = 0; halving < 5; ++halving, step /= 2) {
    if (!keep_if_better(node, place(step), before, aim)) continue;
    lines_.slide(node, step);
    return true;
  }
  return false;
}

}  // namespace beadmesh
