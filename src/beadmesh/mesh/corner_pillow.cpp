#include "beadmesh/mesh/corner_pillow.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/element_zone.h"
#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/mesh/surface_nodes.h"

namespace beadmesh {
namespace {

using Block = std::set<Index>;  ///< elements, ascending

std::vector<std::vector<Index>> elements_around(const PlanarMesh& mesh) {
  std::vector<std::vector<Index>> around(mesh.nodes.size());
  for (size_t e = 0; e < mesh.elements.size(); ++e)
    for (Index n : mesh.elements[e])
      if (n != no_index) around[n].push_back(Index(e));
  return around;
}

/// Fixed nodes with a single quad that spans a flat angle, ascending.
std::vector<Index> flat_corners(const PlanarMesh& mesh, const std::vector<std::vector<Index>>& around,
                                double limit) {
  std::vector<Index> corners;
  for (size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.freedom[n] != NodeFreedom::fixed || around[n].size() != 1) continue;
    const MeshElement& element = mesh.elements[around[n][0]];
    const int count = corner_count(element);
    const int k = int(std::find(element.begin(), element.begin() + count, Index(n)) - element.begin());
    const Vec2 before = mesh.nodes[element[(k + count - 1) % count]],
               after = mesh.nodes[element[(k + 1) % count]];
    if (angle_between(before - mesh.nodes[n], after - mesh.nodes[n]) > limit) corners.push_back(Index(n));
  }
  return corners;
}

/// The corner's quad and `layers` of neighbours over nodes.
Block block_around(const PlanarMesh& mesh, const std::vector<std::vector<Index>>& around, Index corner,
                   int layers) {
  Block block{around[corner].begin(), around[corner].end()};
  for (int layer = 0; layer < layers; ++layer) {
    Block grown = block;
    for (Index e : block)
      for (Index n : mesh.elements[e])
        if (n != no_index) grown.insert(around[n].begin(), around[n].end());
    block = std::move(grown);
  }
  return block;
}

void pillow(PlanarMesh& mesh, const Block& block, const std::vector<std::array<Index, 2>>& outline) {
  std::map<Index, Index> inner;
  Vec2 centre{0, 0};
  for (const auto& edge : outline) centre += mesh.nodes[edge[0]] / double(outline.size());
  for (const auto& edge : outline) {
    inner[edge[0]] = Index(mesh.nodes.size());
    mesh.nodes.push_back(lerp(mesh.nodes[edge[0]], centre, 0.3));
    mesh.freedom.push_back(NodeFreedom::free);
  }
  for (Index e : block)
    for (Index& n : mesh.elements[e])
      if (const auto at = inner.find(n); at != inner.end()) n = at->second;
  for (const auto& [a, b] : outline) mesh.elements.push_back({a, b, inner[b], inner[a]});
}

struct Relief {
  Block block;
  std::vector<std::array<Index, 2>> outline;
  double before = 0;  ///< worst scaled Jacobian in the block
};

class Reliever {
 public:
  Reliever(const PlanarMesh& mesh, const SurfaceMap* map, const CornerPillowOptions& options)
      : original_(mesh), map_(map), options_(options), around_(elements_around(mesh)) {}

  /// Blocks of the given depth around the corners; blocks that touch are one.
  std::vector<Relief> reliefs(const std::vector<Index>& corners, int layers) const {
    std::vector<Block> blocks;
    for (Index corner : corners) {
      Block block = block_around(original_, around_, corner, layers);
      for (size_t b = 0; b < blocks.size();) {
        if (touch(block, blocks[b])) {
          block.insert(blocks[b].begin(), blocks[b].end());
          blocks.erase(blocks.begin() + b);
          b = 0;
        } else {
          ++b;
        }
      }
      blocks.push_back(std::move(block));
    }
    const std::vector<Vec3> space = positions(original_);
    std::vector<Relief> out;
    for (Block& block : blocks) {
      Relief relief{std::move(block), {}, 1};
      std::vector<MeshElement> own;
      for (const Index e : relief.block) own.push_back(original_.elements[e]);
      relief.outline = outline_of(own);
      // Only then does the ring close around the block.
      if (!closed_loop(relief.outline) || has_crest(relief.block)) continue;
      for (Index e : relief.block)
        relief.before = std::min(relief.before, scaled_jacobian(space, original_.elements[e]));
      out.push_back(std::move(relief));
    }
    return out;
  }

  /// Applies all, smooths, and says which made things better.
  std::vector<bool> judge(const std::vector<Relief>& reliefs, PlanarMesh& trial) const {
    trial = original_;
    std::vector<Index> first_new;
    for (const Relief& relief : reliefs) {
      first_new.push_back(Index(trial.elements.size()));
      pillow(trial, relief.block, relief.outline);
    }
    first_new.push_back(Index(trial.elements.size()));
    SmoothingOptions smoothing{options_.size, options_.min_edge};
    smoothing.aim = SmoothingOptions::Aim::angles;  // what a relief is judged by
    smooth(trial, map_, smoothing);
    const std::vector<Vec3> space = positions(trial);
    std::vector<bool> good;
    for (size_t r = 0; r < reliefs.size(); ++r) {
      double worst = 1, shortest = 1e300;
      const auto look = [&](Index e) {
        worst = std::min(worst, scaled_jacobian(space, trial.elements[e]));
        shortest = std::min(shortest, side_lengths(space, trial.elements[e])[0]);
      };
      for (Index e : reliefs[r].block) look(e);
      for (Index e = first_new[r]; e < first_new[r + 1]; ++e) look(e);
      good.push_back(worst > reliefs[r].before + 0.05 && shortest >= options_.min_edge);
    }
    return good;
  }

 private:
  std::vector<Vec3> positions(const PlanarMesh& mesh) const {
    const SurfaceNodes nodes(mesh.nodes, map_);
    std::vector<Vec3> out;
    for (size_t n = 0; n < nodes.size(); ++n) out.push_back(nodes.space(Index(n)));
    return out;
  }

  bool touch(const Block& a, const Block& b) const {
    std::set<Index> nodes;
    for (Index e : a) nodes.insert(original_.elements[e].begin(), original_.elements[e].end());
    nodes.erase(no_index);
    for (Index e : b)
      for (Index n : original_.elements[e])
        if (nodes.count(n)) return true;
    return false;
  }

  bool has_crest(const Block& block) const {
    for (Index e : block)
      for (Index n : original_.elements[e])
        if (n != no_index && original_.freedom[n] == NodeFreedom::sliding) return true;
    return false;
  }

  const PlanarMesh original_;
  const SurfaceMap* map_;
  CornerPillowOptions options_;
  std::vector<std::vector<Index>> around_;
};

/// One depth of block: what is bad is taken out again and the rest smoothed once more.
int relieve_with(PlanarMesh& mesh, const SurfaceMap* map, const CornerPillowOptions& options, int layers) {
  const Reliever reliever(mesh, map, options);
  auto reliefs = reliever.reliefs(flat_corners(mesh, elements_around(mesh), options.flat_corner), layers);
  for (int round = 0; round < 3 && !reliefs.empty(); ++round) {
    PlanarMesh trial;
    const std::vector<bool> good = reliever.judge(reliefs, trial);
    if (std::all_of(good.begin(), good.end(), [](bool g) { return g; })) {
      mesh = std::move(trial);
      return int(reliefs.size());
    }
    std::vector<Relief> kept;
    for (size_t r = 0; r < reliefs.size(); ++r)
      if (good[r]) kept.push_back(std::move(reliefs[r]));
    reliefs = std::move(kept);
  }
  return 0;
}

}  // namespace

int relieve_flat_corners(PlanarMesh& mesh, const SurfaceMap* map, const CornerPillowOptions& options) {
  int kept = 0;
  for (int layers : {2, 3, 4, 5, 6, 1}) kept += relieve_with(mesh, map, options, layers);
  return kept;
}

}  // namespace beadmesh
