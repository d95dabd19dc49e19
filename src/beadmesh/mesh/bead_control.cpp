#include "beadmesh/mesh/bead_control.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace beadmesh {
namespace {

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

std::string text_of(Vec3 p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%g, %g, %g)", p.x, p.y, p.z);
  return text;
}

Result<void> check_lengths(const BeadMeshControl& control, double size, double min_edge) {
  for (const auto& length : {control.size, control.min_edge})
    if (length && !(std::isfinite(*length) && *length > 0))
      return fail("control.size", "a length for beads is " + text_of(*length) + " mm", "it must be above 0");
  if (control.min_edge && *control.min_edge < min_edge)
    return fail("control.min_edge",
                "the minimum edge length of a bead, " + text_of(*control.min_edge) +
                    " mm, is below that of the panel, " + text_of(min_edge) + " mm",
                "that of the panel holds everywhere");
  const double own_size = control.size.value_or(size), own_min_edge = control.min_edge.value_or(min_edge);
  if ((control.size || control.min_edge) && own_min_edge > own_size)
    return fail("control.size", "the element size of a bead, " + text_of(own_size) +
                                    " mm, is below the minimum edge length, " + text_of(own_min_edge) +
                                    " mm");
  return {};
}

Result<void> check_count(const std::optional<int>& count, const char* code, const char* what, int most) {
  if (!count || (*count >= 1 && *count <= most)) return {};
  return fail(code, std::string("the number of ") + what + " is " + std::to_string(*count),
              "it must be at least 1 and at most " + std::to_string(most));
}

/// The point of the triangle nearest to p lies inside or on an edge.
double distance_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 normal = cross(b - a, c - a);
  const double doubled = norm(normal);
  const auto left_of = [&](Vec3 from, Vec3 to) { return dot(cross(to - from, p - from), normal) >= 0; };
  if (doubled > 0 && left_of(a, b) && left_of(b, c) && left_of(c, a))
    return std::abs(dot(p - a, normal)) / doubled;
  const auto to_edge = [&](Vec3 from, Vec3 to) {
    const Vec3 u = to - from;
    const double uu = dot(u, u);
    const double t = uu > 0 ? std::clamp(dot(p - from, u) / uu, 0.0, 1.0) : 0;
    return distance(p, from + u * t);
  };
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

double distance_to_bead(Vec3 p, const Panel& panel, const Bead& bead) {
  double least = 1e300;
  for (const Index face : bead.faces) {
    const Facets& facets = panel.faces[face].facets;
    for (const Triangle& t : facets.triangles)
      least = std::min(
          least, distance_to_triangle(p, facets.points[t[0]], facets.points[t[1]], facets.points[t[2]]));
  }
  return least;
}

Result<size_t> bead_at(Vec3 p, const Panel& panel, const BeadTable& table) {
  size_t best = 0;
  double nearest = 1e300;
  for (size_t b = 0; b < table.beads.size(); ++b) {
    const double d = distance_to_bead(p, panel, table.beads[b]);
    if (d < nearest) nearest = d, best = b;
  }
  if (!table.beads.empty() && nearest <= table.beads[best].width / 2) return best;
  const std::string hint = table.beads.empty()
                               ? "the panel has no beads"
                               : "the nearest is bead " + std::to_string(table.beads[best].id) + ", " +
                                     text_of(nearest) + " mm away";
  return fail("control.bead", "there is no bead at " + text_of(p), hint);
}

Result<size_t> bead_of(const BeadSelection& selection, const Panel& panel, const BeadTable& table) {
  if (selection.id == 0) return bead_at(selection.point, panel, table);
  for (size_t b = 0; b < table.beads.size(); ++b)
    if (table.beads[b].id == selection.id) return b;
  return fail("control.bead", "there is no bead " + std::to_string(selection.id),
              table.beads.empty() ? "the panel has no beads"
                                  : "they are numbered 1 to " + std::to_string(table.beads.size()));
}

}  // namespace

std::optional<BeadMethod> bead_method_of(const std::string& name) {
  if (name == "automatic") return BeadMethod::automatic;
  if (name == "blocks") return BeadMethod::blocks;
  if (name == "ridge") return BeadMethod::ridge;
  if (name == "face") return BeadMethod::face;
  return std::nullopt;
}

BeadMeshControl overlaid(BeadMeshControl base, const BeadMeshControl& over) {
  if (over.size) base.size = over.size;
  if (over.min_edge) base.min_edge = over.min_edge;
  if (over.elements_across) base.elements_across = over.elements_across;
  if (over.elements_along) base.elements_along = over.elements_along;
  if (over.clamp_rows) base.clamp_rows = over.clamp_rows;
  if (over.method) base.method = over.method;
  return base;
}

Result<void> check_control(const BeadMeshControl& control, double size, double min_edge) {
  if (auto good = check_lengths(control, size, min_edge); !good) return good;
  if (auto good = check_count(control.elements_across, "control.elements_across", "elements across", 200);
      !good)
    return good;
  if (control.elements_across.value_or(2) % 2 && *control.elements_across != 1)
    return fail("control.elements_across",
                "the number of elements across is " + std::to_string(*control.elements_across),
                "it must be even, so that the crest is a line of the mesh, or 1");
  if (auto good = check_count(control.elements_along, "control.elements_along", "elements along", 10000);
      !good)
    return good;
  return check_count(control.clamp_rows, "control.clamp_rows", "clamp rows", 100);
}

Result<std::vector<BeadMeshControl>> controls_of_beads(const BeadControls& controls, const Panel& panel,
                                                       const BeadTable& table, double size, double min_edge) {
  std::vector<BeadMeshControl> out;
  for (const Bead& bead : table.beads) out.push_back(overlaid(controls.all, controls.of(bead.kind)));
  for (const auto& [selection, control] : controls.single) {
    const auto b = bead_of(selection, panel, table);
    if (!b) return tl::unexpected(b.error());
    out[*b] = overlaid(out[*b], control);
  }
  for (const BeadMeshControl& control : out)
    if (auto good = check_control(control, size, min_edge); !good) return tl::unexpected(good.error());
  return out;
}

}  // namespace beadmesh
