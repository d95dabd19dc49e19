#include "beadmesh/panel/thin_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "beadmesh/geometry/ray_search.h"
#include "beadmesh/panel/edge_shape.h"
#include "beadmesh/panel/skin_offset.h"

namespace beadmesh {
namespace {

/// In the order of Skin.
constexpr std::array<std::string_view, 4> skin_names{"outer", "inner", "middle", "whole"};

using FaceList = std::vector<Index>;

/// Where a ray from a place of a face, straight into the material, comes out.
struct Crossing {
  Index opposite = no_index;  ///< face that it leaves through, about against its normal; no_index: none
  double length = 0;          ///< mm
  double area = 0;            ///< of the face, that this place stands for, mm^2
};

struct FaceCrossings {
  double area = 0;
  std::vector<Crossing> crossings;
};

/// Pieces of faces that share edges, each with its faces ascending.
std::vector<FaceList> pieces_of(const Panel& panel) {
  std::vector<bool> seen(panel.faces.size(), false);
  std::vector<FaceList> pieces;
  for (Index seed = 0; seed < static_cast<Index>(seen.size()); ++seed) {
    if (seen[seed]) continue;
    FaceList piece{seed};
    seen[seed] = true;
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (const auto& loop : panel.faces[piece[i]].loops)
        for (const EdgeUse use : loop)
          for (const Index f : panel.edges[use.edge].faces)
            if (!seen[f]) seen[f] = true, piece.push_back(f);
    std::sort(piece.begin(), piece.end());
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

bool is_closed(const Panel& panel, const FaceList& piece) {
  for (const Index f : piece)
    for (const auto& loop : panel.faces[f].loops)
      for (const EdgeUse use : loop)
        if (panel.edges[use.edge].faces.size() != 2) return false;
  return true;
}

double volume_of(const Panel& panel, const FaceList& piece) {
  double six = 0;
  const Vec3 origin = panel.faces[piece.front()].facets.points.front();
  for (const Index f : piece) {
    const Facets& facets = panel.faces[f].facets;
    for (const Triangle& t : facets.triangles)
      six += dot(facets.points[t[0]] - origin,
                 cross(facets.points[t[1]] - origin, facets.points[t[2]] - origin));
  }
  return six / 6;
}

std::string format(const char* pattern, double a, double b = 0, double c = 0) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, a, b, c);
  return text;
}

/// One closed piece, looked through.
class ThinSolid {
 public:
  ThinSolid(const Panel& panel, const FaceList& piece, double sign, const ThinSolidOptions& options)
      : panel_(panel), piece_(piece), sign_(sign), options_(options) {}

  /// Faces of the two sides, the larger one first; none with a reason where it is no thin sheet.
  struct Sides {
    FaceList outer, inner;
    double thickness = 0;             ///< mm, median over both sides
    std::map<Index, double> of_face;  ///< mm, median over the face
    std::string reason;               ///< why there are none
  };

  Sides find() {
    cross_all();
    Sides sides;
    sides.thickness = median(all_crossings({}));
    if (sides.thickness <= 0) return refused("no place of it lies opposite to another");
    limit_ = options_.spread * sides.thickness;
    if (const std::string reason = why_thick(sides.thickness); !reason.empty()) return refused(reason);
    // Sides meet rims at sharp edges. So they do where a narrow rim lies opposite to another one and passes
    // for a side: then only smooth edges join.
    if (!colour_sides(pi) && !colour_sides(radians(45))) return refused("its two sides cannot be told apart");
    double area[2] = {0, 0};
    FaceList faces[2];
    for (std::size_t i = 0; i < piece_.size(); ++i)
      if (side_[i] >= 0) faces[side_[i]].push_back(piece_[i]), area[side_[i]] += seen_[i].area;
    if (faces[0].empty() || faces[1].empty()) return refused("it has one side only");
    constexpr double alike = 1e-6;
    const int outer = area[1] > area[0] * (1 + alike) ? 1 : 0;
    sides.outer = std::move(faces[outer]);
    sides.inner = std::move(faces[1 - outer]);
    for (std::size_t i = 0; i < piece_.size(); ++i)
      if (side_[i] >= 0) {
        const double own = median(all_crossings({i}));
        sides.of_face[piece_[i]] = own > 0 ? own : sides.thickness;
      }
    return sides;
  }

 private:
  static Sides refused(std::string reason) {
    Sides sides;
    sides.reason = std::move(reason);
    return sides;
  }

  void cross_all() {
    std::vector<std::array<Vec3, 3>> triangles;
    for (const Index f : piece_) {
      const Facets& facets = panel_.faces[f].facets;
      first_.push_back(triangles.size());
      for (const Triangle& t : facets.triangles) {
        triangles.push_back({facets.points[t[0]], facets.points[t[1]], facets.points[t[2]]});
        owner_.push_back(static_cast<Index>(seen_.size()));
      }
      seen_.push_back({area(facets), {}});
    }
    triangles_ = triangles;
    const RaySearch search(std::move(triangles));
    double size = 0;
    for (const auto& t : triangles_) size = std::max(size, distance(t[0], triangles_[0][0]));
    for (std::size_t begin = 0, end = 0; begin < owner_.size(); begin = end) {
      while (end < owner_.size() && owner_[end] == owner_[begin]) ++end;
      // A hundred places tell what a face does.
      const std::size_t stride = std::max<std::size_t>(1, (end - begin) / 100);
      for (std::size_t t = begin; t < end; t += stride) cross_at(search, t, size);
    }
  }

  Vec3 area_vector(std::size_t t) const {
    const auto& p = triangles_[t];
    return cross(p[1] - p[0], p[2] - p[0]) * (sign_ / 2);
  }

  void cross_at(const RaySearch& search, std::size_t t, double size) {
    const auto& p = triangles_[t];
    const Vec3 middle = (p[0] + p[1] + p[2]) / 3, normal = normalized(area_vector(t));
    Crossing crossing;
    crossing.area = norm(area_vector(t));
    if (const auto hit = search.first_hit(middle, -normal, 1e-6 * size, 2 * size)) {
      const Vec3 there = middle - normal * hit->distance;
      crossing.length = dot(surface_point(t, middle) - surface_point(hit->triangle, there), normal);
      constexpr double against = -0.8;
      if (dot(normalized(area_vector(hit->triangle)), normal) < against)
        crossing.opposite = owner_[hit->triangle];
    }
    seen_[owner_[t]].crossings.push_back(crossing);
  }

  /// On the exact surface, where there is one, over a point of a triangle.
  Vec3 surface_point(std::size_t t, Vec3 p) const {
    const Facets& facets = panel_.faces[piece_[owner_[t]]].facets;
    const std::size_t local = t - first_[owner_[t]];
    if (facets.triangle_uv.empty() || facets.surfaces.empty()) return p;
    const auto& surface = facets.surfaces[facets.triangle_surface[local]];
    if (!surface) return p;
    const auto& [a, b, c] = triangles_[t];
    const Vec3 normal = cross(b - a, c - a);
    const double whole = squared_norm(normal);
    if (whole == 0) return p;
    const double of_a = dot(cross(b - p, c - p), normal) / whole,
                 of_b = dot(cross(c - p, a - p), normal) / whole;
    const auto& uv = facets.triangle_uv[local];
    return surface->point(uv[0] * of_a + uv[1] * of_b + uv[2] * (1 - of_a - of_b));
  }

  /// (length, area) of what comes out opposite: of the faces at these places of the piece, or of all.
  std::vector<std::pair<double, double>> all_crossings(const std::vector<std::size_t>& of) const {
    std::vector<std::pair<double, double>> result;
    const auto add = [&](const FaceCrossings& face) {
      for (const Crossing& c : face.crossings)
        if (c.opposite != no_index && (limit_ == 0 || c.length <= limit_))
          result.push_back({c.length, c.area});
    };
    if (of.empty())
      for (const FaceCrossings& face : seen_) add(face);
    for (const std::size_t i : of) add(seen_[i]);
    return result;
  }

  static double median(std::vector<std::pair<double, double>> weighted) {
    std::sort(weighted.begin(), weighted.end());
    double whole = 0, walked = 0;
    for (const auto& [length, weight] : weighted) whole += weight;
    for (const auto& [length, weight] : weighted)
      if ((walked += weight) >= whole / 2) return length;
    return 0;
  }

  bool is_opposite(const Crossing& c) const { return c.opposite != no_index && c.length <= limit_; }

  /// The share of a face's places that lie opposite to another one.
  double paired_share(const FaceCrossings& face) const {
    double all = 0, paired = 0;
    for (const Crossing& c : face.crossings) {
      all += c.area;
      if (is_opposite(c)) paired += c.area;
    }
    return all > 0 ? paired / all : 0;
  }

  std::string why_thick(double thickness) const {
    double all = 0, paired = 0;
    for (const FaceCrossings& face : seen_) {
      all += face.area;
      paired += face.area * paired_share(face);
    }
    if (paired < options_.least_pairs * all)
      return format("only %.0f %% of its surface lies opposite to another side at up to %.3g mm",
                    100 * paired / all, limit_);
    // A cube is as thick as it is wide.
    constexpr double slender = 8;
    if (std::sqrt(all / 2) < slender * thickness)
      return format("it is %.3g mm thick and only about %.3g mm wide", thickness, std::sqrt(all / 2));
    return {};
  }

  /// Faces joined by edges that turn by no more than this, without those of the rim, are on one side; what
  /// lies opposite is on the other. False where that contradicts itself.
  bool colour_sides(double most_turn) {
    const std::vector<EdgeShape> shapes = most_turn < pi ? edge_shapes(panel_) : std::vector<EdgeShape>();
    constexpr double rim = 0.5;
    std::map<Index, std::size_t> place;
    for (std::size_t i = 0; i < piece_.size(); ++i) place[piece_[i]] = i;
    std::vector<Index> sheet(piece_.size(), no_index);  // which of the sheets
    Index sheets = 0;
    for (std::size_t seed = 0; seed < piece_.size(); ++seed) {
      if (sheet[seed] != no_index || paired_share(seen_[seed]) < rim) continue;
      std::vector<std::size_t> faces{seed};
      sheet[seed] = sheets++;
      for (std::size_t i = 0; i < faces.size(); ++i)
        for (const auto& loop : panel_.faces[piece_[faces[i]]].loops)
          for (const EdgeUse use : loop) {
            if (most_turn < pi && shapes[use.edge].turn > most_turn) continue;
            for (const Index f : panel_.edges[use.edge].faces)
              if (const std::size_t n = place.at(f); sheet[n] == no_index && paired_share(seen_[n]) >= rim)
                sheet[n] = sheet[seed], faces.push_back(n);
          }
    }
    return colour_sheets(sheet, static_cast<std::size_t>(sheets));
  }

  /// From the largest sheet on, what lies opposite has the other colour. Little may stay without one.
  bool colour_sheets(const std::vector<Index>& sheet, std::size_t count) {
    std::vector<std::vector<double>> weight(count, std::vector<double>(count, 0));
    std::vector<double> areas(count, 0);
    for (std::size_t i = 0; i < piece_.size(); ++i) {
      if (sheet[i] == no_index) continue;
      areas[sheet[i]] += seen_[i].area;
      for (const Crossing& c : seen_[i].crossings)
        if (is_opposite(c) && sheet[c.opposite] != no_index) {
          weight[sheet[i]][sheet[c.opposite]] += c.area;
          weight[sheet[c.opposite]][sheet[i]] += c.area;
        }
    }
    std::vector<int> colour(count, -1);
    std::vector<std::size_t> todo{
        static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin())};
    colour[todo[0]] = 0;
    for (std::size_t i = 0; i < todo.size(); ++i)
      for (std::size_t b = 0; b < count; ++b)
        if (colour[b] < 0 && weight[todo[i]][b] > 0.05 * std::min(areas[todo[i]], areas[b]))
          colour[b] = 1 - colour[todo[i]], todo.push_back(b);
    double good = 0, bad = 0, without = 0, all = 0;
    for (std::size_t a = 0; a < count; ++a) {
      all += areas[a];
      if (colour[a] < 0) without += areas[a];
      for (std::size_t b = 0; b < count; ++b)
        if (colour[a] >= 0 && colour[b] >= 0) (colour[a] == colour[b] ? bad : good) += weight[a][b];
    }
    if (bad > 0.05 * (good + bad) || without > 0.05 * all) return false;
    side_.assign(piece_.size(), -1);
    for (std::size_t i = 0; i < piece_.size(); ++i)
      if (sheet[i] != no_index) side_[i] = colour[sheet[i]];
    return true;
  }

  const Panel& panel_;
  const FaceList& piece_;
  double sign_;  ///< -1 where the faces look into the material
  ThinSolidOptions options_;
  double limit_ = 0;                 ///< mm, longest way across
  std::vector<FaceCrossings> seen_;  ///< per face of the piece
  std::vector<std::size_t> first_;   ///< per face of the piece: its first triangle
  std::vector<Index> owner_;         ///< per triangle: the place of its face in the piece
  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<int> side_;  ///< per face of the piece: 0, 1, or -1 at the rim
};

Diagnostic note(const Panel& panel, const FaceList& piece, std::string code, Severity severity,
                std::string message, std::string hint = {}) {
  return {std::move(code),    severity,       panel.faces[piece.front()].number, {},
          std::move(message), std::move(hint)};
}

std::string range(const std::vector<double>& sorted) {
  const double low = sorted.front(), high = sorted.back();
  return high - low < 0.01 * high ? format("%.3g mm", (low + high) / 2)
                                  : format("%.3g to %.3g mm", low, high);
}

/// The panel with these faces alone.
Panel only(Panel panel, const std::vector<bool>& kept) {
  std::vector<Index> renumbered(panel.faces.size(), no_index), edges(panel.edges.size(), no_index);
  std::vector<PanelFace> faces;
  std::vector<PanelEdge> kept_edges;
  for (std::size_t f = 0; f < panel.faces.size(); ++f) {
    if (!kept[f]) continue;
    renumbered[f] = static_cast<Index>(faces.size());
    faces.push_back(std::move(panel.faces[f]));
  }
  for (PanelFace& face : faces)
    for (auto& loop : face.loops)
      for (EdgeUse& use : loop) {
        if (edges[use.edge] == no_index) {
          edges[use.edge] = static_cast<Index>(kept_edges.size());
          kept_edges.push_back(panel.edges[use.edge]);
          auto& around = kept_edges.back().faces;
          around.erase(std::remove_if(around.begin(), around.end(), [&](Index f) { return !kept[f]; }),
                       around.end());
          for (Index& f : around) f = renumbered[f];
        }
        use.edge = edges[use.edge];
      }
  panel.faces = std::move(faces);
  panel.edges = std::move(kept_edges);
  return panel;
}

}  // namespace

std::string_view name_of(Skin skin) {
  return skin_names[static_cast<std::size_t>(skin)];
}

Result<Skin> skin_of(std::string_view name) {
  const auto found = std::find(skin_names.begin(), skin_names.end(), name);
  if (found == skin_names.end())
    return fail("usage.skin", "unknown skin '" + std::string(name) + "'", "outer, inner, middle or whole");
  return static_cast<Skin>(found - skin_names.begin());
}

Panel with_skins(Panel panel, const ThinSolidOptions& options) {
  if (options.skin == Skin::whole) return panel;
  std::vector<bool> kept(panel.faces.size(), true);
  std::vector<double> inwards(panel.faces.size(), 0);
  bool is_changed = false;
  for (const FaceList& piece : pieces_of(panel)) {
    if (piece.size() < 3 || !is_closed(panel, piece)) continue;
    const double sign = volume_of(panel, piece) < 0 ? -1 : 1;
    const ThinSolid::Sides sides = ThinSolid(panel, piece, sign, options).find();
    if (!sides.reason.empty()) {
      panel.diagnostics.push_back(
          note(panel, piece, "read.solid", Severity::note,
               "a closed solid of " + std::to_string(piece.size()) +
                   " faces is no thin sheet, its whole surface is taken: " + sides.reason,
               "export one side of the sheet where it is one"));
      continue;
    }
    is_changed = true;
    const FaceList& skin = options.skin == Skin::inner ? sides.inner : sides.outer;
    for (const Index f : piece) kept[f] = false;
    std::vector<double> thicknesses;
    for (const Index f : skin) {
      kept[f] = true;
      panel.faces[f].thickness = sides.of_face.at(f);
      thicknesses.push_back(panel.faces[f].thickness);
      if (options.skin == Skin::middle) inwards[f] = sign * panel.faces[f].thickness / 2;
    }
    std::sort(thicknesses.begin(), thicknesses.end());
    panel.diagnostics.push_back(note(panel, piece, "read.skin", Severity::note,
                                     "a thin solid of " + std::to_string(piece.size()) +
                                         " faces became its " + std::string(name_of(options.skin)) +
                                         " skin of " + std::to_string(skin.size()) + ", " +
                                         range(thicknesses) + " thick"));
  }
  if (!is_changed) return panel;
  std::vector<double> of_kept;
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (kept[f]) of_kept.push_back(inwards[f]);
  panel = without_unused_points(only(std::move(panel), kept));
  if (options.skin == Skin::middle) move_inwards(panel, of_kept);
  return panel;
}

}  // namespace beadmesh
