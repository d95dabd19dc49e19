#include "beadmesh/bead/composite_faces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <numeric>
#include <tuple>
#include <utility>

#include "beadmesh/bead/continued_sheet.h"
#include "beadmesh/bead/face_study.h"
#include "beadmesh/panel/edge_shape.h"

namespace beadmesh {
namespace {

using FaceList = std::vector<Index>;

class CompositeFinder {
 public:
  CompositeFinder(const Panel& panel, const CompositeOptions& options, const Context& context)
      : panel_(panel),
        options_(options),
        context_(context),
        settled_(panel.faces.size(), false),
        searched_(panel.faces.size(), false),
        shapes_(edge_shapes(panel)) {
    for (const PanelFace& face : panel.faces) areas_.push_back(area(face.facets));
  }

  std::vector<GroupDecision> run() {
    FaceList order(panel_.faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return areas_[a] > areas_[b]; });
    for (const Index f : order)
      if (!settled_[f] && !context_.is_cancelled()) search_inside(f);
    for (GroupDecision& group : groups_) std::sort(group.faces.begin(), group.faces.end());
    std::sort(groups_.begin(), groups_.end(), [](const GroupDecision& a, const GroupDecision& b) {
      return std::tie(a.faces, a.verdict, a.reason) < std::tie(b.faces, b.verdict, b.reason);
    });
    return std::move(groups_);
  }

 private:
  /// What lies inside the inner loops of a face that counts as sheet.
  void search_inside(Index host) {
    if (searched_[host]) return;  // loops of a face that closes around itself have no inside
    searched_[host] = settled_[host] = true;
    // What different loops enclose has no face in common: they can be searched at once.
    tbb::parallel_for(size_t(1), std::max(size_t(1), panel_.faces[host].loops.size()), [&](size_t l) {
      const FaceList inside = enclosed(host, l);
      if (inside.empty()) return;
      for (const Index f : inside) settled_[f] = true;
      search_feature(host, l, inside);
    });
  }

  /// The groups are sorted in the end.
  void note(FaceList group, GroupVerdict verdict, std::string reason) {
    const std::lock_guard lock(mutex_);
    groups_.push_back({std::move(group), verdict, std::move(reason)});
  }

  void search_feature(Index host, size_t loop, const FaceList& inside) {
    const ContinuedSheet sheet(panel_.faces[host].facets, loop);
    const double low = options_.level_height * height_of(sheet, inside);
    FaceList level = level_faces(sheet, inside, low);
    FaceList feature = reachable(host, loop, level);
    if (!feature.empty()) {
      // Small level faces at the very foot are part of the feature.
      const auto at_foot =
          std::partition(level.begin(), level.end(), [&](Index f) { return !touches(f, {host}); });
      level.erase(at_foot, level.end());
      feature = reachable(host, loop, level);
    }
    judge_feature(feature, inside, sheet, low);
    for (const Index f : level)
      if (touches(f, feature) || feature.empty()) search_inside(f);
  }

  void judge_feature(const FaceList& feature, const FaceList& inside, const ContinuedSheet& sheet,
                     double low) {
    if (feature.empty()) return note(inside, GroupVerdict::left, "it is level with the sheet around it");
    if (const std::string sharp = sharp_edge(feature); !sharp.empty()) {
      note(feature, GroupVerdict::left, sharp);
      return search_inside_largest(feature);
    }
    if (has_own_bead(feature, sheet, low)) {
      note(feature, GroupVerdict::left, "one of its faces is a bead by itself");
      for (const Index f : feature) search_inside(f);
      return;
    }
    const std::vector<FaceList> beads = beads_side_by_side(feature, sheet, low);
    for (const FaceList& bead : beads)
      note(bead, GroupVerdict::bead, "it meets its neighbours at the level of the sheet only");
    if (beads.empty()) decide(feature);
  }

  void search_inside_largest(const FaceList& faces) {
    if (!faces.empty()) search_inside(largest(faces));
  }

  double height_of(const ContinuedSheet& sheet, const FaceList& faces) const {
    double height = 0;
    for (const Index f : faces)
      for (const Vec3 p : panel_.faces[f].facets.points) height = std::max(height, std::abs(sheet.height(p)));
    return height;
  }

  /// A face that is a bead by itself and starts from the sheet on all its loops: rings that share loops.
  bool has_own_bead(const FaceList& feature, const ContinuedSheet& sheet, double low) const {
    return feature.size() > 1 && std::any_of(feature.begin(), feature.end(), [&](Index f) {
             const Facets& facets = panel_.faces[f].facets;
             for (const auto& loop : facets.loops)
               for (const Index v : loop)
                 if (std::abs(sheet.height(facets.points[v])) > low) return false;
             return is_bead({f});
           });
  }

  /// The pieces of a feature that meet at the level of the sheet only (rings of many faces that share loops),
  /// where each is a bead; none where it is one piece, or another piece is no bead.
  std::vector<FaceList> beads_side_by_side(const FaceList& feature, const ContinuedSheet& sheet,
                                           double low) const {
    std::vector<FaceList> pieces = pieces_above(feature, sheet, low);
    const bool all_beads = pieces.size() > 1 && std::all_of(pieces.begin(), pieces.end(),
                                                            [&](const FaceList& p) { return is_bead(p); });
    if (!all_beads) pieces.clear();
    return pieces;
  }

  /// Faces of the feature connected over edges that leave the sheet somewhere, in height or direction.
  std::vector<FaceList> pieces_above(const FaceList& feature, const ContinuedSheet& sheet, double low) const {
    const std::vector<bool> leaves = points_off_sheet(feature, sheet, low);
    std::vector<FaceList> pieces;
    std::vector<bool> is_free(panel_.faces.size(), false);
    for (const Index f : feature) is_free[f] = true;
    for (const Index first : feature) {
      if (!is_free[first]) continue;
      FaceList piece{first};
      is_free[first] = false;
      for (size_t i = 0; i < piece.size(); ++i)
        for (const auto& loop : panel_.faces[piece[i]].loops)
          for (const EdgeUse use : loop) {
            const PanelEdge& edge = panel_.edges[use.edge];
            if (std::none_of(edge.points.begin(), edge.points.end(), [&](Index p) { return leaves[p]; }))
              continue;
            for (const Index f : edge.faces)
              if (is_free[f]) is_free[f] = false, piece.push_back(f);
          }
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  /// Per point of the panel: is it off the continued sheet, or does a face of the feature lean there?
  std::vector<bool> points_off_sheet(const FaceList& feature, const ContinuedSheet& sheet, double low) const {
    std::vector<bool> off(panel_.points.size(), false);
    for (const Index f : feature) {
      const Facets& facets = panel_.faces[f].facets;
      for (Index t = 0; t < Index(facets.triangles.size()); ++t)
        for (int k = 0; k < 3; ++k) {
          const Index v = facets.triangles[t][k], p = facets.panel_points[v];
          if (off[p]) continue;
          const double lean = angle_between(sheet.normal(facets.points[v]), corner_normal(facets, t, k));
          off[p] = lean > options_.level_angle || std::abs(sheet.height(facets.points[v])) > low;
        }
    }
    return off;
  }

  /// All faces behind a loop of a face; empty where they can be reached past that loop, or there is none.
  FaceList enclosed(Index host, size_t loop) const {
    const FaceList faces = reachable(host, loop, {});
    std::vector<bool> in_loop(panel_.edges.size(), false);
    for (const EdgeUse use : panel_.faces[host].loops[loop]) in_loop[use.edge] = true;
    for (const Index f : faces)
      for (const auto& of_face : panel_.faces[f].loops)
        for (const EdgeUse use : of_face)
          if (!in_loop[use.edge] && is_in(host, panel_.edges[use.edge].faces)) return {};
    return faces;
  }

  /// Faces reached through a loop of `host` without passing through it or through `blocked`.
  FaceList reachable(Index host, size_t loop, const FaceList& blocked) const {
    std::vector<bool> seen(panel_.faces.size(), false);
    seen[host] = true;
    for (const Index f : blocked) seen[f] = true;
    FaceList found;
    const auto step_over = [&](const std::vector<EdgeUse>& uses) {
      for (const EdgeUse use : uses)
        for (const Index f : panel_.edges[use.edge].faces)
          if (!seen[f]) seen[f] = true, found.push_back(f);
    };
    step_over(panel_.faces[host].loops[loop]);
    for (size_t i = 0; i < found.size(); ++i)
      for (const auto& of_face : panel_.faces[found[i]].loops) step_over(of_face);
    return found;
  }

  /// Those of the faces that could be the sheet itself: as high, and leaning as much. All where nothing
  /// rises.
  FaceList level_faces(const ContinuedSheet& sheet, const FaceList& faces, double low) const {
    if (low < options_.level_height * options_.min_height) return faces;
    FaceList level;
    for (const Index f : faces)
      if (is_level(sheet, panel_.faces[f].facets, low)) level.push_back(f);
    return level;
  }

  bool is_level(const ContinuedSheet& sheet, const Facets& facets, double height) const {
    double sum = 0, lean = 0;
    int corners = 0;
    for (Index t = 0; t < Index(facets.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k, ++corners) {
        const Vec3 p = facets.points[facets.triangles[t][k]];
        sum += std::abs(sheet.height(p));
        lean = std::max(lean, angle_between(sheet.normal(p), corner_normal(facets, t, k)));
      }
    return lean < options_.level_angle && sum < height * corners;
  }

  /// Says which edge inside the group, or between it and what lies around, is not smooth; empty where all
  /// are.
  std::string sharp_edge(const FaceList& group) const {
    double turn = 0;
    for (const Index f : group)
      for (const auto& loop : panel_.faces[f].loops)
        for (const EdgeUse use : loop) {
          const size_t sides = panel_.edges[use.edge].faces.size();
          if (sides > 2) return "more than two faces meet at an edge";
          if (sides == 2) turn = std::max(turn, shapes_[use.edge].turn);  // with one: the rim of a hole
        }
    if (turn <= options_.feature_angle) return {};
    return text("an edge turns by %.0f degrees, over %.0f", degrees(turn), degrees(options_.feature_angle));
  }

  static std::string text(const char* pattern, double a, double b) {
    char out[128];
    std::snprintf(out, sizeof out, pattern, a, b);
    return out;
  }

  /// One face of many, or none: a plateau's top may carry beads of its own.
  void decide(FaceList feature) {
    const Index top = largest(feature);
    if (feature.size() == 1) return search_inside(top);
    const Result<BeadKind> kind = judge(feature);
    if (kind) return note(std::move(feature), GroupVerdict::bead, "it is a bead by the rule for one face");
    FaceList above;
    for (size_t l = 1; l < panel_.faces[top].loops.size(); ++l) {
      const FaceList inside = enclosed(top, l);
      if (height_of(ContinuedSheet(panel_.faces[top].facets, l), inside) >= options_.min_height)
        above.insert(above.end(), inside.begin(), inside.end());
    }
    search_inside(top);
    feature.erase(std::remove_if(feature.begin(), feature.end(), [&](Index f) { return is_in(f, above); }),
                  feature.end());
    if (feature.size() < 2) return;
    const bool has_bead = std::any_of(feature.begin(), feature.end(), [&](Index f) { return is_bead({f}); });
    const bool is_one = !has_bead && study_faces(panel_, feature);
    note(std::move(feature), is_one ? GroupVerdict::one_face : GroupVerdict::left, kind.error().message);
  }

  /// The rule for one face, over several.
  Result<BeadKind> judge(const FaceList& faces) const {
    const auto study = study_faces(panel_, faces);
    if (!study) return tl::unexpected(study.error());
    if (const auto good = check_boundary(**study, options_.bead); !good) return tl::unexpected(good.error());
    const auto medial = medial_object_of_bead((*study)->region);
    if (!medial) return tl::unexpected(medial.error());
    const auto bead = recognise(**study, *medial, options_.bead);
    if (!bead) return tl::unexpected(bead.error());
    return bead->kind;
  }

  bool is_bead(const FaceList& faces) const { return judge(faces).has_value(); }

  Index largest(const FaceList& faces) const {
    return *std::max_element(faces.begin(), faces.end(), [&](Index a, Index b) {
      return areas_[a] != areas_[b] ? areas_[a] < areas_[b] : a > b;
    });
  }

  bool touches(Index face, const FaceList& others) const {
    for (const auto& loop : panel_.faces[face].loops)
      for (const EdgeUse use : loop)
        for (const Index f : panel_.edges[use.edge].faces)
          if (is_in(f, others)) return true;
    return false;
  }

  static bool is_in(Index f, const FaceList& faces) {
    return std::find(faces.begin(), faces.end(), f) != faces.end();
  }

  const Panel& panel_;
  CompositeOptions options_;
  const Context& context_;
  std::vector<char>
      settled_;  ///< part of something that was searched; each face a place of its own in memory
  std::vector<char> searched_;     ///< what lies inside it is known
  std::vector<double> areas_;      ///< per face
  std::vector<EdgeShape> shapes_;  ///< per edge
  std::mutex mutex_;               ///< for the groups
  std::vector<GroupDecision> groups_;
};

}  // namespace

std::vector<GroupDecision> group_decisions(const Panel& panel, const CompositeOptions& options,
                                           const Context& context) {
  return CompositeFinder(panel, options, context).run();
}

std::vector<std::vector<Index>> composite_faces(const Panel& panel, const CompositeOptions& options,
                                                const Context& context) {
  std::vector<FaceList> groups;
  for (GroupDecision& group : group_decisions(panel, options, context))
    if (group.verdict != GroupVerdict::left) groups.push_back(std::move(group.faces));
  return groups;
}

}  // namespace beadmesh
