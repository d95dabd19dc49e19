#include "beadmesh/blocking/narrow_blocks.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/blocking/axis_station.h"

namespace beadmesh {
namespace {

/// A cut from side to side.
struct Cut {
  Index left = no_index, right = no_index;
};

class NarrowBlocks {
 public:
  NarrowBlocks(const SkeletonArm& arm, const RidgeGraph& ridge, const PlanarRegion& region,
               const NarrowBlockOptions& options)
      : arm_(arm),
        ridge_(ridge),
        options_(options),
        builder_(region),
        loop_lengths_(loop_lengths_of(region)),
        length_(length_of(arm)) {}

  Result<BlockLayout> run() {
    const RidgeNode &start = ridge_.nodes[arm_.start], &end = ridge_.nodes[arm_.end];
    if (!start.tip || !end.tip) return fail("blocking.narrow", "an arm ends without a tip on the boundary");
    const Cut first_end = end_cut(start, true), last_end = end_cut(end, false);
    // The end quads reach one element behind the end of the axis.
    const double reach = std::max(options_.size - start.radius, 1.1 * options_.min_edge);
    if (length_ < 2 * reach + 1.1 * options_.min_edge)
      return fail("blocking.narrow", "too short for two ends of one element and a strip between them");
    const int pieces = std::max(1, int(std::lround((length_ - 2 * reach) / (4 * options_.size))));
    Cut before = first_end;
    for (int i = 0; i <= pieces; ++i) {
      const Cut cut = cut_at(reach + (length_ - 2 * reach) * i / pieces);
      join(before, cut, i == 0 ? 1 : 0);
      before = cut;
    }
    join(before, last_end, 1);
    return builder_.take();
  }

 private:
  Cut cut_at(double along) {
    const AxisStation station = station_at(arm_, along, loop_lengths_);
    return add({builder_.add_boundary_vertex(station.left), builder_.add_boundary_vertex(station.right)});
  }

  Cut add(const Cut& cut) {
    builder_.add_edge(cut.left, cut.right, VirtualEdgeKind::split, {}, 1);
    return cut;
  }

  /// The last side of an end: on the boundary, around the tip, its chord no shorter than the minimum.
  Cut end_cut(const RidgeNode& node, bool at_start) {
    const double wanted = std::max(node.radius, 1.12 * options_.min_edge);
    const auto at = [&](double s) {
      return BoundaryPosition{node.boundary.loop, node.boundary.position + s};
    };
    double half = wanted / 2;
    while (half < 2 * wanted && distance(builder_.point_at(at(-half)), builder_.point_at(at(half))) < wanted)
      half *= 1.02;
    const Index before = builder_.add_boundary_vertex(at(-half)),
                after = builder_.add_boundary_vertex(at(half));
    // Loops run counter-clockwise: at the far end the right side comes before the tip.
    const Cut cut = at_start ? Cut{before, after} : Cut{after, before};
    builder_.add_boundary_edge(before, after, false, 1);
    return cut;
  }

  void join(const Cut& a, const Cut& b, int count) {
    builder_.add_boundary_edge(a.left, b.left, true, count);
    builder_.add_boundary_edge(a.right, b.right, false, count);
    builder_.add_block({{{a.left, a.right}, {a.right, b.right}, {b.right, b.left}, {b.left, a.left}}});
  }

  const SkeletonArm& arm_;
  const RidgeGraph& ridge_;
  NarrowBlockOptions options_;
  BlockLayoutBuilder builder_;
  std::vector<double> loop_lengths_;
  double length_;
};

}  // namespace

Result<BlockLayout> blocks_of_narrow_bead(const Skeleton& skeleton, const RidgeGraph& ridge,
                                          const PlanarRegion& region, const NarrowBlockOptions& options) {
  if (skeleton.arms.size() != 1 || skeleton.arms[0].start == no_index || region.loops.size() != 1)
    return fail("blocking.narrow", "only a bead of one arm can be one element wide");
  return NarrowBlocks(skeleton.arms[0], ridge, region, options).run();
}

}  // namespace beadmesh
