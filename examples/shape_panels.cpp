#include "examples/shape_panels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "examples/chance.h"
#include "examples/shape_catalogue.h"
#include "examples/skeletons.h"

namespace beadmesh::examples {
namespace {

struct Box {
  Vec2 low, high;
  Vec2 size() const { return high - low; }
};

Box box_of(const std::vector<Vec2>& points) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Box box{{inf, inf}, {-inf, -inf}};
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

/// Features that keep their places to each other: one, or rings that share loops.
struct Group {
  std::vector<Feature> features;
  Box box;  ///< of the outermost loop

  const Feature& outermost() const { return features.front(); }
  void move_to(Vec2 origin) {
    for (Feature& feature : features) feature.origin = origin;
    box = box_of(sampled(outermost().loops().front()));
  }
};

/// A shape of the catalogue, its lengths stretched by factors between 1 - spread and 1 + spread.
Group group_of(const CatalogueShape& shape, double width, double height, double angle, Chance& chance,
               double spread) {
  Group group;
  const double factor = chance.between(1 - spread, 1 + spread);
  const double other_factor = chance.between(1 - spread, 1 + spread);
  for (Footprint& footprint : shape.make(width, factor, other_factor)) {
    group.features.push_back(
        {shape.shape, shape.kind, std::move(footprint), Profile::bead, height, {}, angle, shape.name});
    height = -height;
  }
  group.move_to({});
  return group;
}

Base curved(BaseKind kind, double radius) {
  switch (kind) {
    case BaseKind::cylinder:
      return {.radius = radius};
    case BaseKind::double_curved:
      return {.xx = -1 / (2 * radius), .yy = -1 / (3 * radius)};
    case BaseKind::saddle:
      return {.xx = -1 / (2 * radius), .yy = 1 / (3 * radius)};
    default:
      return {};
  }
}

// ---------------------------------------------------------------- in rows

/// Places the groups in rows of about `row_length`, the tall ones first; returns the size of the whole.
Vec2 place_in_rows(std::vector<Group>& groups, double row_length, double gap) {
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.box.size().y > b.box.size().y; });
  Vec2 at{gap, gap}, whole;
  double row_height = 0;
  for (Group& group : groups) {
    const Vec2 size = group.box.size();
    if (at.x > gap && at.x + size.x > row_length) {
      at = {gap, at.y + row_height + gap};
      row_height = 0;
    }
    group.move_to(at - group.box.low);
    row_height = std::max(row_height, size.y);
    at.x += size.x + gap;
    whole = {std::max(whole.x, at.x), at.y + row_height + gap};
  }
  for (Group& group : groups) group.move_to(group.outermost().origin - whole / 2);
  return whole;
}

// ---------------------------------------------------------------- by chance

constexpr double clearance = 9;  // mm, between features and to the edge

/// Straight edges may cross another loop with no end of theirs in it.
bool cross_each_other(const PlanLoop& loop, const BoundaryDistance& other) {
  constexpr double step = 2;  // mm
  for (const PlanEdge& edge : loop)
    for (double at = step; !edge.is_arc() && at < edge.length(); at += step)
      if (other(edge.point(at / edge.length())) > 0) return true;
  return false;
}

/// Least distance of the sampled loops of two features; 0 where one lies within the other.
double distance_between(const Feature& a, const Feature& b) {
  const PlanLoop of_a = a.loops().front(), of_b = b.loops().front();
  const BoundaryDistance to_a({of_a}), to_b({of_b});
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 p : sampled(of_b)) least = std::min(least, -to_a(p));
  for (const Vec2 p : sampled(of_a)) least = std::min(least, -to_b(p));
  return cross_each_other(of_a, to_b) ? 0 : std::max(least, 0.0);
}

constexpr double own_clearance = 5;  // mm, between the arms of one feature

/// Ends of a bent bead may come near its own side, nearer than any element could be.
bool keeps_clear_of_itself(const Feature& feature) {
  const PlanLoop loop = feature.loops().front();
  const BoundaryDistance inside({loop});
  const std::vector<Vec2> points = sampled(loop);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 along = normalized(points[(i + 1) % n] - points[(i + n - 1) % n]);
    if (inside(points[i] + Vec2{along.y, -along.x} * own_clearance) > 0) return false;
  }
  return true;
}

class RandomPanel {
 public:
  explicit RandomPanel(const RandomPanelOptions& options) : chance_(options.seed) {
    panel_.name = "random-" + std::to_string(options.seed);
    panel_.length = chance_.between(400, 900);
    if (options.length > 0) panel_.length = options.length;
    panel_.width = panel_.length * chance_.between(0.5, 0.9);
    if (options.width > 0) panel_.width = options.width;
    const auto by_chance = BaseKind(chance_.below(4));
    const double radius = panel_.length * chance_.between(1.3, 5);
    panel_.base = curved(options.base.value_or(by_chance), radius);
    for (int i = 0; i < options.beads; ++i) place([&] { return bead(); });
    const int holes = 2 + chance_.below(5);
    for (int i = 0; i < holes; ++i) place([&] { return hole(); });
  }

  PanelDesign take() { return std::move(panel_); }

 private:
  double any_angle() { return chance_.between(0, 2 * pi); }

  Group bead() {
    const std::vector<CatalogueShape>& shapes = shape_catalogue();
    const CatalogueShape& shape = shapes[chance_.below(int(shapes.size()))];
    // Narrow ones are more frequent, as on real panels.
    const double width = 8 * std::pow(5, std::pow(chance_.between(0, 1), 1.5));
    const double height = std::clamp(width * chance_.between(0.15, 0.4), 2.0, 10.0);
    const double side = chance_.below(2) == 0 ? 1 : -1, angle = any_angle();
    return group_of(shape, width, side * height, angle, chance_, 0.15);
  }

  Group hole() {
    Group group;
    const double width = chance_.between(8, 24);
    const bool round = chance_.below(2) == 0;
    Footprint footprint =
        round ? blob(circle(width / 2, 1), width / 2) : straight_bead(width * chance_.between(1, 3), width);
    group.features.push_back(
        {round ? "hole" : "slot", "", std::move(footprint), Profile::hole, 0, {}, any_angle(), {}});
    group.move_to({});
    return group;
  }

  /// Tries places for a thing, then another thing, until there is one that keeps clear of all others.
  template <class Make>
  void place(const Make& make) {
    for (int thing = 0; thing < 4; ++thing) {
      Group group = make();
      const Vec2 room = Vec2{panel_.length, panel_.width} - group.box.size();
      if (room.x <= 2 * clearance || room.y <= 2 * clearance) continue;
      if (!keeps_clear_of_itself(group.outermost())) continue;
      for (int attempt = 0; attempt < 40; ++attempt) {
        group.move_to({chance_.between(-panel_.length, panel_.length) / 2,
                       chance_.between(-panel_.width, panel_.width) / 2});
        if (!keeps_clear(group)) continue;
        panel_.features.insert(panel_.features.end(), group.features.begin(), group.features.end());
        return;
      }
    }
  }

  bool keeps_clear(const Group& group) const {
    const BoundaryDistance inside({panel_.outline()});
    for (const Vec2 p : sampled(group.outermost().loops().front()))
      if (inside(p) < clearance) return false;
    for (const Feature& other : panel_.features) {
      const Box box = box_of(sampled(other.loops().front()));
      const bool apart = box.low.x - group.box.high.x > clearance ||
                         group.box.low.x - box.high.x > clearance ||
                         box.low.y - group.box.high.y > clearance || group.box.low.y - box.high.y > clearance;
      if (!apart && distance_between(group.outermost(), other) < clearance) return false;
    }
    return true;
  }

  Chance chance_;
  PanelDesign panel_;
};

}  // namespace

std::optional<PanelDesign> shapes_panel(const ShapePanelOptions& options) {
  const std::vector<CatalogueShape>& all = shape_catalogue();
  for (const std::string& name : options.only)
    if (std::none_of(all.begin(), all.end(), [&](const CatalogueShape& s) { return s.name == name; }))
      return std::nullopt;
  Chance chance(options.seed);
  const double spread = options.seed == 0 ? 0 : 0.12;
  std::vector<Group> groups;
  double area = 0;
  for (const CatalogueShape& shape : all) {
    const bool wanted = options.only.empty() ||
                        std::find(options.only.begin(), options.only.end(), shape.name) != options.only.end();
    const double angle = options.seed == 0 ? 0 : chance.between(0, 2 * pi);
    const double side = options.seed == 0 || chance.below(2) == 0 ? 1 : -1;
    Group group = group_of(shape, options.width, side * options.height, angle, chance, spread);
    if (!wanted) continue;
    groups.push_back(std::move(group));
    area += groups.back().box.size().x * groups.back().box.size().y;
  }
  const double gap = 0.5 * options.width + 8;
  const Vec2 size = place_in_rows(groups, 1.4 * std::sqrt(area), gap);
  PanelDesign panel;
  panel.name = "shapes";
  panel.length = size.x;
  panel.width = size.y;
  panel.corner_radius = gap;
  const double radius = options.radius > 0 ? options.radius : 1.6 * std::max(size.x, size.y);
  panel.base = curved(options.base, radius);
  for (const Group& group : groups)
    panel.features.insert(panel.features.end(), group.features.begin(), group.features.end());
  return panel;
}

namespace {

/// Of an eccentric ring at its narrowest place.
double least_half_width(const Footprint& footprint) {
  double half = std::min(footprint.half_width, footprint.end_half_width);
  if (!footprint.between_loops) return half;
  const BoundaryDistance boundary(footprint.loops);
  for (const Vec2 p : sampled(footprint.loops.front())) half = std::min(half, boundary.to_loop(1, p) / 2);
  return half;
}

}  // namespace

void add_walls(PanelDesign& panel, std::uint64_t seed) {
  Chance chance(seed ^ 0x77616c6c73);
  for (Feature& feature : panel.features) {
    Walls walls;
    const double half = least_half_width(feature.footprint);
    const double h = std::abs(feature.height);
    walls.angle = radians(chance.between(40, 75));
    walls.root_radius = h * chance.between(0.3, 0.7);
    walls.top_radius = h * chance.between(0.25, 0.6);
    const double run_out = chance.between(-1, 1) * 2 * half;
    if (feature.profile == Profile::hole) continue;
    // Height, draft and fillets must fit into most of the half width.
    const double most = 0.8 * half;
    const double rise = 1 - std::cos(walls.angle), fillets = walls.root_radius + walls.top_radius;
    const double width = fillets * std::sin(walls.angle) + (h - fillets * rise) / std::tan(walls.angle);
    if (width > most) {
      const double shrink = most / width;
      feature.height *= shrink;
      walls.root_radius *= shrink;
      walls.top_radius *= shrink;
    }
    if (feature.name == "straight" && run_out > 0) walls.run_out = run_out;
    feature.walls = walls;
  }
}

PanelDesign random_panel(const RandomPanelOptions& options) {
  return RandomPanel(options).take();
}

}  // namespace beadmesh::examples
