// The medial object as a person sees it: a graph of arms, spurs left out, near junctions counted as one.
#pragma once

#include <vector>

#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

struct SkeletonNode {
  Vec2 point;
  double radius = 0;
  MedialVertexType type = MedialVertexType::J;
  std::vector<Index> arms;  ///< counter-clockwise; a closed arm at one node twice
  Index medial_vertex = no_index;
};

struct SkeletonArm {
  Index start = no_index, end = no_index;  ///< nodes; no_index for a closed arm without nodes
  std::vector<MedialPoint> points;         ///< from start to end; feet left and right of this direction
};

struct Skeleton {
  std::vector<SkeletonNode> nodes;
  std::vector<SkeletonArm> arms;
};

struct SkeletonOptions {
  double spur_length =
      0.5;  ///< default 0.5: leaves shorter than this times the thickness at their junction are spurs
  double merge_distance =
      1.0;  ///< default 1.0: junctions nearer than this times their mean thickness are one
};

/// Spurs are dropped, nodes of degree 2 dissolved, near junctions merged (their connecting arm vanishes).
Skeleton skeleton_of(const MedialObject& medial, const SkeletonOptions& options = {});

double length_of(const SkeletonArm& arm);
/// Unit direction in which an arm leaves its start (or its end, where at_end), over a reach of `distance`.
Vec2 direction_at(const SkeletonArm& arm, bool at_end, double distance);

}  // namespace beadmesh
