#include "beadmesh/read/cad_edges.h"

#include <GeomAdaptor_Curve.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "beadmesh/read/parallel.h"

namespace beadmesh {
namespace {

struct UseInFace {
  Index face;
  const CadUse* use;
};

std::vector<std::vector<UseInFace>> uses_per_edge(const CadTopology& topology) {
  std::vector<std::vector<UseInFace>> result(topology.edges.size());
  for (Index f = 0; f < static_cast<Index>(topology.faces.size()); ++f) {
    if (topology.faces[f].broken) continue;
    for (const std::vector<CadUse>& loop : topology.faces[f].loops)
      for (const CadUse& use : loop) result[use.edge].push_back({f, &use});
  }
  return result;
}

constexpr double greatest_turn = radians(60);  // of a curve over one step
constexpr int most_by_turn = 24;               // steps that its turn alone asks for

Vec3 point_on(const CadEdge& edge, double t) {
  const gp_Pnt p = edge.curve->Value(t);
  return {p.X(), p.Y(), p.Z()};
}

double curvature_on(const CadEdge& edge, double t) {
  gp_Pnt p;
  gp_Vec d1, d2;
  edge.curve->D2(t, p, d1, d2);
  const double speed = d1.Magnitude();
  const double k = d1.Crossed(d2).Magnitude() / (speed * speed * speed);
  return std::isfinite(k) ? k : 0;
}

/// Places samples along one edge so that each step has about the wanted size there.
class EdgeSampler {
 public:
  EdgeSampler(CadEdge& edge, const std::vector<UseInFace>& uses, const FaceSpaces& spaces,
              const FacetSize& size)
      : edge_(edge), uses_(uses), spaces_(spaces), size_(size) {}

  void sample() {
    edge_.parameters = {edge_.first};
    GeomAdaptor_Curve adaptor(edge_.curve, edge_.first, edge_.last);
    const int pieces = adaptor.NbIntervals(GeomAbs_C1);
    TColStd_Array1OfReal breaks(1, pieces + 1);
    adaptor.Intervals(breaks, GeomAbs_C1);
    for (int i = 1; i <= pieces; ++i) {
      const int probes = std::clamp(8 * adaptor.NbIntervals(GeomAbs_C3) / pieces, 32, 2000);
      sample_piece(i == 1 ? edge_.first : breaks(i), i == pieces ? edge_.last : breaks(i + 1), probes,
                   least_steps(pieces));
    }
    for (const double t : edge_.parameters) edge_.points.push_back(point_on(edge_, t));
  }

 private:
  int least_steps(int pieces) const {
    const bool closed = edge_.first_vertex == edge_.last_vertex;
    return closed ? (pieces >= 3 ? 2 : 6) : 1;
  }

  double wanted(double t) const {
    double h = size_.on_curve(curvature_on(edge_, t));
    for (const UseInFace& u : uses_) {
      const FaceSpace& space = *spaces_[u.face];
      h = std::min(h, space.sizes.at(space.stretched(u.use->uv(edge_, t))));
    }
    return h;
  }

  void sample_piece(double from, double to, int probes, int least) {
    std::vector<double> steps(probes + 1, 0.0);  // how many steps of the wanted size fit before probe i
    Vec3 last = point_on(edge_, from);
    double last_wanted = wanted(from), turn = 0;
    for (int i = 1; i <= probes; ++i) {
      const double t = std::lerp(from, to, static_cast<double>(i) / probes);
      const Vec3 here = point_on(edge_, t);
      const double here_wanted = wanted(t);
      steps[i] = steps[i - 1] + distance(last, here) * 0.5 * (1 / last_wanted + 1 / here_wanted);
      turn += distance(last, here) * curvature_on(edge_, t);
      last = here;
      last_wanted = here_wanted;
    }
    // However small it is, a curve must not shrink to a line: two half circles are a loop of points, too.
    const double wanted_steps = std::max(steps.back(), std::min(turn / greatest_turn, double{most_by_turn}));
    const int count = std::clamp(static_cast<int>(std::ceil(wanted_steps - 1e-6)), least, 200000);
    int probe = 1;
    for (int k = 1; k < count; ++k) {
      const double target = steps.back() * k / count;
      while (probe < probes && steps[probe] < target) ++probe;
      const double step = steps[probe] - steps[probe - 1];
      const double within = step > 0 ? (target - steps[probe - 1]) / step : 0;
      edge_.parameters.push_back(std::lerp(from, to, (probe - 1 + std::clamp(within, 0.0, 1.0)) / probes));
    }
    edge_.parameters.push_back(to);
  }

  CadEdge& edge_;
  const std::vector<UseInFace>& uses_;
  const FaceSpaces& spaces_;
  const FacetSize& size_;
};

struct PointCloud {
  std::vector<Vec3> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t d) const {
    return d == 0 ? points[i].x : d == 1 ? points[i].y : points[i].z;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// Halves segments that are long for what is around them in the same face, until none is left.
class EdgeRefiner {
 public:
  EdgeRefiner(CadTopology& topology, const FacetSize& size) : topology_(topology), size_(size) {}

  void refine() {
    std::vector<bool> dirty(topology_.edges.size(), true);
    for (int round = 0; round < max_rounds && std::find(dirty.begin(), dirty.end(), true) != dirty.end();
         ++round) {
      marks_.resize(topology_.edges.size());
      for (std::size_t e = 0; e < marks_.size(); ++e)
        marks_[e].assign(topology_.edges[e].points.size(), false);
      for (const CadFace& face : topology_.faces)
        if (!face.broken && touches(face, dirty)) mark_face(face);
      for (std::size_t e = 0; e < marks_.size(); ++e) dirty[e] = split_marked(e);
    }
  }

 private:
  static constexpr int max_rounds = 12;
  static constexpr double reach = 0.45;     // of the segment: a point this near to its middle is too near
  static constexpr double max_ratio = 2.5;  // of neighbouring segments along a loop

  static bool touches(const CadFace& face, const std::vector<bool>& dirty) {
    for (const std::vector<CadUse>& loop : face.loops)
      for (const CadUse& use : loop)
        if (dirty[use.edge]) return true;
    return false;
  }

  void mark_face(const CadFace& face) {
    PointCloud cloud;
    for (const std::vector<CadUse>& loop : face.loops)
      for (const CadUse& use : loop) {
        const std::vector<Vec3>& points = topology_.edges[use.edge].points;
        cloud.points.insert(cloud.points.end(), points.begin(), points.end());
      }
    using Tree =
        nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointCloud>, PointCloud, 3>;
    const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    for (const std::vector<CadUse>& loop : face.loops) {
      for (const CadUse& use : loop) mark_crowded(use.edge, tree);
      mark_uneven(loop);
    }
  }

  double length(Index e, std::size_t segment) const {
    const std::vector<Vec3>& p = topology_.edges[e].points;
    return distance(p[segment], p[segment + 1]);
  }

  template <class Tree>
  void mark_crowded(Index e, const Tree& tree) {
    const std::vector<Vec3>& p = topology_.edges[e].points;
    for (std::size_t s = 0; s + 1 < p.size(); ++s) {
      const double l = length(e, s);
      if (l < 4 * size_.smallest()) continue;
      const Vec3 middle = (p[s] + p[s + 1]) / 2;
      const double query[3] = {middle.x, middle.y, middle.z};
      unsigned nearest = 0;
      double squared = std::numeric_limits<double>::infinity();
      tree.knnSearch(query, 1, &nearest, &squared);
      if (squared < reach * reach * l * l) marks_[e][s] = true;
    }
  }

  void mark_uneven(const std::vector<CadUse>& loop) {
    struct Step {
      Index edge;
      std::size_t segment;
    };
    std::vector<Step> steps;
    for (const CadUse& use : loop) {
      const std::size_t n = topology_.edges[use.edge].points.size();
      for (std::size_t i = 0; i + 1 < n; ++i) steps.push_back({use.edge, use.reversed ? n - 2 - i : i});
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Step &a = steps[i], &b = steps[(i + 1) % steps.size()];
      const double la = length(a.edge, a.segment), lb = std::max(length(b.edge, b.segment), size_.smallest());
      if (la > max_ratio * lb) marks_[a.edge][a.segment] = true;
      if (lb > max_ratio * std::max(la, size_.smallest())) marks_[b.edge][b.segment] = true;
    }
  }

  bool split_marked(std::size_t e) {
    CadEdge& edge = topology_.edges[e];
    const std::vector<bool>& marks = marks_[e];
    if (std::find(marks.begin(), marks.end(), true) == marks.end()) return false;
    std::vector<double> parameters;
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      parameters.push_back(edge.parameters[i]);
      points.push_back(edge.points[i]);
      if (!marks[i]) continue;
      parameters.push_back((edge.parameters[i] + edge.parameters[i + 1]) / 2);
      points.push_back(point_on(edge, parameters.back()));
    }
    edge.parameters = std::move(parameters);
    edge.points = std::move(points);
    return true;
  }

  CadTopology& topology_;
  const FacetSize& size_;
  std::vector<std::vector<bool>> marks_;  // per edge and segment
};

struct Box {
  Vec2 low, high;
};

/// Of the parameters along all loops; none where they are not finite.
std::optional<Box> parameter_box(const CadFace& face) {
  if (face.broken || face.loops.empty()) return {};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
  for (const std::vector<CadUse>& loop : face.loops)
    for (const CadUse& use : loop)
      for (int i = 0; i <= 32; ++i) {
        const gp_Pnt2d p = use.curve->Value(std::lerp(use.first, use.last, i / 32.0));
        low = {std::min(low.x, p.X()), std::min(low.y, p.Y())};
        high = {std::max(high.x, p.X()), std::max(high.y, p.Y())};
      }
  if (!std::isfinite(low.x + low.y + high.x + high.y)) return {};
  return Box{low, high};
}

std::optional<FaceSpace> face_space(const CadFace& face, const FacetSize& size) try {
  const std::optional<Box> box = parameter_box(face);
  if (!box) return {};
  const Vec2 stretch = mean_stretch(*face.surface, box->low, box->high);
  FaceSpace space{stretch,
                  SizeField(*face.surface, size, stretch, {box->low.x * stretch.x, box->low.y * stretch.y},
                            {box->high.x * stretch.x, box->high.y * stretch.y})};
  space.sizes.smooth();
  return space;
} catch (const Standard_Failure&) {
  return {};
}

}  // namespace

void sample_edges_by_curve(CadTopology& topology, double chord) {
  ReadOptions options;
  options.chord = chord;
  const FacetSize size(options, std::numeric_limits<double>::max());
  const std::vector<UseInFace> no_uses;
  const FaceSpaces no_spaces;
  for (CadEdge& edge : topology.edges)
    if (!edge.is_pole()) EdgeSampler(edge, no_uses, no_spaces, size).sample();
}

Vec2 face_stretch(const CadFace& face) {
  const std::optional<Box> box = parameter_box(face);
  return box ? mean_stretch(*face.surface, box->low, box->high) : Vec2{1, 1};
}

FaceSpaces face_spaces(const CadTopology& topology, const FacetSize& size, const Context& context) {
  FaceSpaces spaces(topology.faces.size());
  for_each_index(spaces.size(), context,
                 [&](std::size_t f) { spaces[f] = face_space(topology.faces[f], size); });
  return spaces;
}

void sample_edges(CadTopology& topology, const FaceSpaces& spaces, const FacetSize& size) {
  for (std::size_t f = 0; f < spaces.size(); ++f) topology.faces[f].broken = !spaces[f];
  const auto uses = uses_per_edge(topology);
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    if (!topology.edges[e].is_pole()) EdgeSampler(topology.edges[e], uses[e], spaces, size).sample();
  EdgeRefiner(topology, size).refine();
}

}  // namespace beadmesh
