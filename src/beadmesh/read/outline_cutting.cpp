#include "beadmesh/read/outline_cutting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "beadmesh/read/outline_lines.h"
#include "beadmesh/read/sheet_band.h"

namespace beadmesh {
namespace {

constexpr double least_angle = radians(50);  // of a face at a point of its outline

/// Triangles around each point; cutting adds to them. What lists a triangle may no longer belong to it.
class PointFans {
 public:
  explicit PointFans(const FacetMesh& mesh) : mesh_(mesh), start_(mesh.points.size() + 1, 0) {
    for (const Triangle& t : mesh.triangles)
      for (const Index v : t) ++start_[v + 1];
    for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
    triangles_.resize(start_.back());
    std::vector<Index> at(start_.begin(), start_.end() - 1);
    for (Index t = 0; t < mesh.triangle_count(); ++t)
      for (const Index v : mesh.triangles[t]) triangles_[at[v]++] = t;
  }

  void add(Index triangle) {
    for (const Index v : mesh_.triangles[triangle]) added_[v].push_back(triangle);
  }

  std::vector<Index> around(Index v) const {
    std::vector<Index> found;
    if (v + 1 < Index(start_.size()))
      found.assign(triangles_.begin() + start_[v], triangles_.begin() + start_[v + 1]);
    if (const auto more = added_.find(v); more != added_.end())
      found.insert(found.end(), more->second.begin(), more->second.end());
    std::erase_if(found, [&](Index t) {
      const Triangle& c = mesh_.triangles[t];
      return c[0] != v && c[1] != v && c[2] != v;
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  const FacetMesh& mesh_;
  std::vector<Index> start_, triangles_;
  std::map<Index, std::vector<Index>> added_;
};

/// One outline.
class LineCutter {
 public:
  LineCutter(FacetMesh& mesh, FacetGroups& groups, PointFans& fans, const std::vector<bool>& fixed,
             const OutlineLine& line, const FairedOutline& outline, const OutlineCutOptions& options)
      : mesh_(mesh),
        groups_(groups),
        fans_(fans),
        fixed_(fixed),
        line_(line),
        curve_(outline.curve),
        raised_only_(!groups.is_feature[line.outside]),
        keep_(options.keep * outline.facet),
        move_(options.move * outline.facet),
        band_(options.band * outline.facet) {}

  void run(const std::vector<Index>& points) {
    gather(points);
    for (auto& [v, side] : side_) side = side_of(v);
    cut_edges();
    cut_triangles();
    for (const Index t : triangles_)
      if (Index& face = groups_.face[t]; face == line_.inside || face == line_.outside)
        face = is_inside(t) ? line_.inside : line_.outside;
    for (int round = 0; round < 10 && drop_spikes(); ++round)
      ;
  }

 private:
  /// Facets that touch a point of the line or of the band around the curve.
  void gather(const std::vector<Index>& points) {
    std::vector<Index> queue = points;
    std::set<Index> queued(points.begin(), points.end());
    for (std::size_t i = 0; i < queue.size(); ++i) {
      near_.insert(queue[i]);
      for (const Index t : fans_.around(queue[i])) {
        triangles_.insert(t);
        for (const Index v : mesh_.triangles[t]) {
          side_.try_emplace(v, 0);
          if (queued.insert(v).second && curve_.place(mesh_.points[v]).distance < band_) queue.push_back(v);
        }
      }
    }
  }

  /// 1 inside, -1 outside, 0 on the curve.
  int side_of(Index v) {
    const OutlinePlace place = curve_.place(mesh_.points[v]);
    if (place.distance <= keep_) return 0;
    if (place.distance <= move_ && !fixed_[v] && moved(v, place.nearest)) return 0;
    return inside(place) > 0 ? 1 : -1;
  }

  /// What stands high over the sheet is inside, however steep its walls are.
  double inside(const OutlinePlace& place) const {
    if (raised_only_ && std::abs(place.height) > 2 * std::abs(place.inside) && std::abs(place.height) > move_)
      return std::abs(place.height);
    return place.inside;
  }

  bool moved(Index v, Vec3 to) {
    const Vec3 from = mesh_.points[v];
    mesh_.points[v] = to;
    for (const Index t : fans_.around(v))
      if (dot(area_vector(mesh_.points, mesh_.triangles[t]), mesh_.area_vectors[t]) <
          0.1 * squared_norm(mesh_.area_vectors[t])) {
        mesh_.points[v] = from;
        return false;
      }
    return true;
  }

  void cut_edges() {
    for (const Index t : triangles_)
      for (int k = 0; k < 3; ++k) {
        const Index a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
        if (side_.at(a) * side_.at(b) >= 0 || (!near_.contains(a) && !near_.contains(b))) continue;
        const auto [found, is_new] = cut_.try_emplace(std::minmax(a, b), no_index);
        if (!is_new) continue;
        found->second = Index(mesh_.points.size());
        mesh_.points.push_back(crossing(std::min(a, b), std::max(a, b)));
      }
    for (const auto& [edge, v] : cut_) side_[v] = 0;
  }

  Vec3 crossing(Index a, Index b) const {
    const Vec3 from = mesh_.points[a], to = mesh_.points[b];
    double low = 0, high = 1;
    for (int step = 0; step < 40; ++step) {
      const double middle = (low + high) / 2;
      const bool in = inside(curve_.place(lerp(from, to, middle))) > 0;
      (in == (side_.at(a) > 0) ? low : high) = middle;
    }
    return lerp(from, to, (low + high) / 2);
  }

  void cut_triangles() {
    const std::vector<Index> before(triangles_.begin(), triangles_.end());
    for (const Index t : before) {
      const Triangle v = mesh_.triangles[t];
      std::array<Index, 3> on;  // per side
      int count = 0;
      for (int k = 0; k < 3; ++k) {
        const auto found = cut_.find(std::minmax(v[k], v[(k + 1) % 3]));
        on[k] = found == cut_.end() ? no_index : found->second;
        count += on[k] != no_index;
      }
      for (int k = 0; k < 3; ++k) {
        const Index a = v[k], b = v[(k + 1) % 3], c = v[(k + 2) % 3];
        if (count == 1 && on[k] != no_index) replace(t, {{a, on[k], c}, {on[k], b, c}});
        if (count != 2 || on[k] == no_index || on[(k + 2) % 3] == no_index) continue;
        const Index m = on[k], n = on[(k + 2) % 3];
        const auto& p = mesh_.points;
        if (distance(p[m], p[c]) < distance(p[b], p[n]))
          replace(t, {{a, m, n}, {m, b, c}, {m, c, n}});
        else
          replace(t, {{a, m, n}, {m, b, n}, {b, c, n}});
      }
    }
  }

  void replace(Index t, const std::vector<Triangle>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      Index to = t;
      if (i > 0) {
        to = mesh_.triangle_count();
        mesh_.triangles.push_back(pieces[i]);
        mesh_.parts.push_back(mesh_.parts[t]);
        mesh_.area_vectors.emplace_back();
        groups_.face.push_back(groups_.face[t]);
      }
      mesh_.triangles[to] = pieces[i];
      mesh_.area_vectors[to] = area_vector(mesh_.points, pieces[i]);
      triangles_.insert(to);
      fans_.add(to);
    }
  }

  bool is_inside(Index t) const {
    int least = 1, most = -1;
    for (const Index v : mesh_.triangles[t])
      least = std::min(least, side_.at(v)), most = std::max(most, side_.at(v));
    if (least >= 0 && most > 0) return true;
    if (most <= 0 && least < 0) return false;
    return inside(curve_.place(mesh_.centre(t))) > 0;
  }

  /// Facets along the curve can lie in any order: where a face has but a sharp tip at a point of the outline,
  /// the facets of that tip go to the other side.
  bool drop_spikes() {
    bool any = false;
    for (const auto& [v, side] : side_) {
      if (side != 0) continue;
      std::array<double, 2> angle{0, 0};
      std::array<std::vector<Index>, 2> members;
      bool others = false;
      for (const Index t : fans_.around(v)) {
        others = others || (groups_.face[t] != line_.inside && groups_.face[t] != line_.outside);
        const int out = groups_.face[t] == line_.outside;
        angle[out] += angle_at(v, t);
        members[out].push_back(t);
      }
      const int sharp = angle[0] < angle[1] ? 0 : 1;
      if (others || members[sharp].empty() || angle[sharp] > least_angle) continue;
      for (const Index t : members[sharp]) groups_.face[t] = sharp ? line_.inside : line_.outside;
      any = true;
    }
    return any;
  }

  double angle_at(Index v, Index t) const {
    const Triangle& c = mesh_.triangles[t];
    const int k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    const Vec3 at = mesh_.points[v];
    return angle_between(mesh_.points[c[(k + 1) % 3]] - at, mesh_.points[c[(k + 2) % 3]] - at);
  }

  FacetMesh& mesh_;
  FacetGroups& groups_;
  PointFans& fans_;
  const std::vector<bool>& fixed_;
  const OutlineLine& line_;
  const OutlineCurve& curve_;
  const bool raised_only_;
  const double keep_, move_, band_;  ///< mm
  std::set<Index> triangles_, near_;
  std::map<Index, int> side_;                     ///< per point of the triangles
  std::map<std::pair<Index, Index>, Index> cut_;  ///< the new point on an edge
};

/// Points that belong to lines other than closed outlines, or to borders.
std::vector<bool> fixed_points(const FacetMesh& mesh, const FacetGroups& groups) {
  std::vector<bool> fixed(mesh.points.size(), false);
  for (Index h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const Index other = mesh.beyond(h);
    if (other == no_index || groups.face[other] != groups.face[h / 3])
      fixed[mesh.tail(h)] = fixed[mesh.head(h)] = true;
  }
  return fixed;
}

/// Of each face the largest piece stays, others go to the face with which they share most.
void drop_islets(const FacetMesh& mesh, FacetGroups& groups) {
  std::vector<Index> piece(mesh.triangles.size(), no_index);
  std::vector<std::vector<Index>> pieces;
  std::map<Index, double> largest;  // per face
  std::vector<double> areas;
  for (Index seed = 0; seed < mesh.triangle_count(); ++seed) {
    if (piece[seed] != no_index) continue;
    std::vector<Index> found{seed};
    piece[seed] = Index(pieces.size());
    double area = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      area += mesh.area(found[i]);
      for (Index h = 3 * found[i]; h < 3 * found[i] + 3; ++h) {
        const Index next = mesh.beyond(h);
        if (next == no_index || piece[next] != no_index || groups.face[next] != groups.face[seed]) continue;
        piece[next] = piece[seed];
        found.push_back(next);
      }
    }
    double& most = largest[groups.face[seed]];
    most = std::max(most, area);
    areas.push_back(area);
    pieces.push_back(std::move(found));
  }
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Index own = groups.face[pieces[p].front()];
    if (areas[p] >= largest[own]) continue;
    std::map<Index, double> shared;
    for (const Index t : pieces[p])
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
        if (const Index other = mesh.beyond(h); other != no_index && groups.face[other] != own)
          shared[groups.face[other]] += mesh.length(h);
    Index to = no_index;
    for (const auto& [face, length] : shared)
      if (to == no_index || length > shared[to]) to = face;
    if (to == no_index) continue;
    for (const Index t : pieces[p]) groups.face[t] = to;
  }
}

}  // namespace

void cut_along_outlines(FacetMesh& mesh, FacetGroups& groups, const OutlineCutOptions& options) {
  const std::vector<OutlineLine> lines = outline_lines(mesh, groups);
  std::vector<std::optional<FairedOutline>> curves;
  std::vector<std::vector<Index>> points(lines.size());
  std::vector<bool> fixed = fixed_points(mesh, groups);
  const bool even = is_coarse(mesh);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    curves.push_back(faired_outline(mesh, groups, lines[i], even));
    for (const Index h : lines[i].half_edges) points[i].push_back(mesh.tail(h));
  }
  PointFans fans(mesh);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!curves[i]) continue;
    for (const Index v : points[i]) fixed[v] = false;
    LineCutter(mesh, groups, fans, fixed, lines[i], *curves[i], options).run(points[i]);
    fixed.resize(mesh.points.size(), true);
    for (const Index v : points[i]) fixed[v] = true;
  }
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    mesh.area_vectors[t] = area_vector(mesh.points, mesh.triangles[t]);
  pair_half_edges(mesh);
  drop_islets(mesh, groups);
}

}  // namespace beadmesh
