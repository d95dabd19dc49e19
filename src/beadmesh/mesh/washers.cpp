#include "beadmesh/mesh/washers.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/mesh/loop_offset.h"

namespace beadmesh {
namespace {

constexpr double largest_hole = 10;      ///< sizes; larger openings are no holes for bolts
constexpr double least_width = 0.7;      ///< sizes
constexpr double least_clearance = 0.7;  ///< sizes between a ring and what is beside it
constexpr double island_clearance = 2;   ///< the same in an island
/// A ring at most so wide for the radius of the hole: its quads would be too uneven (Gauss points under
/// 0.65).
constexpr double widest_for_radius = 1 / 0.86;

using Polygon = std::vector<Vec2>;

struct Box {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};

  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool is_near(const Box& other, double reach) const {
    return low.x - reach <= other.high.x && other.low.x <= high.x + reach && low.y - reach <= other.high.y &&
           other.low.y <= high.y + reach;
  }
};

Box box_of(const Polygon& line) {
  Box box;
  for (const Vec2 p : line) box.add(p);
  return box;
}

/// Is any node of the line, or any edge, nearer to the other line than `reach`?
bool comes_near(const Polygon& line, const Polygon& other, double reach) {
  const auto near = [reach](const Polygon& nodes, const Polygon& edges) {
    for (size_t i = 0; i < edges.size(); ++i)
      for (const Vec2 p : nodes)
        if (squared_distance_to_segment(p, edges[i], edges[(i + 1) % edges.size()]) < reach * reach)
          return true;
    return false;
  };
  return near(line, other) || near(other, line);
}

/// The lines around which no other ring may come.
class Neighbourhood {
 public:
  explicit Neighbourhood(const NodeLoops& loops) {
    for (const auto& loop : loops.loops) {
      lines_.emplace_back();
      for (const Index n : loop) lines_.back().push_back(loops.nodes[n]);
      boxes_.push_back(box_of(lines_.back()));
    }
  }

  const Polygon& line(Index loop) const { return lines_[loop]; }

  bool leaves_room(Index loop, const Polygon& ring, double reach) const {
    const Box box = box_of(ring);
    for (Index other = 0; other < Index(lines_.size()); ++other)
      if (other != loop && box.is_near(boxes_[other], reach) && comes_near(ring, lines_[other], reach))
        return false;
    return true;
  }

  void replace(Index loop, const Polygon& ring) { lines_[loop] = ring, boxes_[loop] = box_of(ring); }

 private:
  std::vector<Polygon> lines_;
  std::vector<Box> boxes_;
};

/// A face between a hole and one round line, such as the inside of a ring: a narrow band that a washer would
/// leave has more irregular nodes than it is worth.
bool is_island(const NodeLoops& loops) {
  constexpr double sharpest_turn = radians(40);
  if (loops.loops.size() != 2) return false;
  const auto& outer = loops.loops[0];
  for (size_t i = 0; i < outer.size(); ++i) {
    const Vec2 before = loops.nodes[outer[(i + outer.size() - 1) % outer.size()]], at = loops.nodes[outer[i]],
               after = loops.nodes[outer[(i + 1) % outer.size()]];
    if (angle_between(at - before, after - at) > sharpest_turn) return false;
  }
  return true;
}

/// Rings by loop; null where a loop has none.
std::vector<const WasherRings*> by_loop(size_t loops, const std::vector<WasherRings>& washers) {
  std::vector<const WasherRings*> of(loops, nullptr);
  for (const WasherRings& washer : washers) of[washer.loop] = &washer;
  return of;
}

void add_row(PlanarMesh& mesh, const std::vector<Index>& inner, const std::vector<Index>& outer) {
  for (size_t i = 0; i < inner.size(); ++i) {
    const size_t j = (i + 1) % inner.size();
    mesh.elements.push_back({inner[i], inner[j], outer[j], outer[i]});
  }
}

}  // namespace

Result<void> check_washers(const WasherControl& control) {
  const auto wrong = [](const char* what, const char* hint) { return fail("control.washer", what, hint); };
  const auto is_length = [](const std::optional<double>& x) { return !x || (std::isfinite(*x) && *x > 0); };
  if (control.rows < 0 || control.rows > 10)
    return wrong("so many rows of washers are not possible", "0 to 10");
  if (!is_length(control.width)) return wrong("the width of a washer is no length", "above 0");
  for (const auto& diameter : {control.min_diameter, control.max_diameter})
    if (diameter && !(std::isfinite(*diameter) && *diameter >= 0))
      return wrong("a diameter of holes with washers is no length", "at least 0");
  if (control.elements_around && (*control.elements_around < 6 || *control.elements_around % 2 != 0))
    return wrong("so many elements around a hole are not possible", "an even number from 6 on");
  return {};
}

std::optional<double> washer_width(const WasherControl& control, double diameter, double size,
                                   double min_edge) {
  if (control.rows == 0 || diameter < control.min_diameter.value_or(0) ||
      diameter > control.max_diameter.value_or(largest_hole * size))
    return std::nullopt;
  if (control.width) return *control.width >= min_edge ? control.width : std::nullopt;
  const double width = std::min(size, diameter / 2 * widest_for_radius);
  return width >= std::max(least_width * size, 1.05 * min_edge) ? std::optional(width) : std::nullopt;
}

std::vector<WasherRings> washer_rings(const NodeLoops& loops, const std::vector<Washer>& wanted, double size,
                                      double min_edge) {
  Neighbourhood around(loops);
  const double clearance = std::max((is_island(loops) ? island_clearance : least_clearance) * size, min_edge);
  std::vector<WasherRings> out;
  for (const Washer& washer : wanted) {
    WasherRings rings{washer.loop, {}};
    for (int row = 0; row < washer.rows; ++row) {
      const Polygon& line = around.line(washer.loop);
      Polygon ring = offset_into_face(line, washer.width);
      if (!edges_keep_length(line, ring, min_edge) || !around.leaves_room(washer.loop, ring, clearance))
        break;
      around.replace(washer.loop, ring);
      rings.rings.push_back(std::move(ring));
    }
    if (!rings.rings.empty()) out.push_back(std::move(rings));
  }
  return out;
}

NodeLoops outside_of_washers(const NodeLoops& loops, const std::vector<WasherRings>& washers) {
  const auto rings = by_loop(loops.loops.size(), washers);
  NodeLoops out;
  for (size_t l = 0; l < loops.loops.size(); ++l) {
    out.loops.emplace_back();
    for (size_t i = 0; i < loops.loops[l].size(); ++i) {
      out.loops.back().push_back(Index(out.nodes.size()));
      out.nodes.push_back(rings[l] ? rings[l]->rings.back()[i] : loops.nodes[loops.loops[l][i]]);
    }
  }
  return out;
}

PlanarMesh with_washers(const NodeLoops& loops, const std::vector<WasherRings>& washers,
                        const PlanarMesh& outside) {
  PlanarMesh out{loops.nodes, std::vector<NodeFreedom>(loops.nodes.size(), NodeFreedom::fixed), {}};
  const auto add = [&out](Vec2 place, NodeFreedom freedom) {
    out.nodes.push_back(place);
    out.freedom.push_back(freedom);
    return Index(out.nodes.size()) - 1;
  };
  const auto rings = by_loop(loops.loops.size(), washers);
  std::vector<Index> global;  // of the nodes outside; those of the loops come first and in order
  for (size_t l = 0; l < loops.loops.size(); ++l) {
    std::vector<Index> line = loops.loops[l];
    if (rings[l])
      for (const Polygon& ring : rings[l]->rings) {
        std::vector<Index> next;
        for (const Vec2 p : ring) next.push_back(add(p, NodeFreedom::fixed));
        add_row(out, line, next);
        line = std::move(next);
      }
    global.insert(global.end(), line.begin(), line.end());
  }
  for (size_t n = global.size(); n < outside.nodes.size(); ++n)
    global.push_back(add(outside.nodes[n], outside.freedom[n]));
  for (MeshElement element : outside.elements) {
    for (Index& n : element)
      if (n != no_index) n = global[n];
    out.elements.push_back(element);
  }
  return out;
}

}  // namespace beadmesh
