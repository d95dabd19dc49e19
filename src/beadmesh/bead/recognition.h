// The bead rule (section 4.1 of the paper) and what it leaves unsaid: a bead is raised.
#pragma once

#include "beadmesh/bead/bead.h"
#include "beadmesh/bead/face_study.h"
#include "beadmesh/core/result.h"
#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

struct BeadOptions {
  double min_aspect_ratio = 2.0;         ///< default 2.0: mean length / thickness of the medial edges
  double max_joint_angle = radians(10);  ///< default 10 degrees: sharper joints in a loop are no G1 boundary
  int max_loops = 2;                     ///< default 2, the paper's rule; ladders of n windows have n + 1
  double min_rise =
      0.03;  ///< default 0.03: crest height over the sheet continued below it, per chord; flatter is no bead
};

/// What can be said before the medial object is made: not too many loops, G1 boundary. Fails with the reason
/// (bead.loops, bead.corner).
Result<void> check_boundary(const FaceStudy& study, const BeadOptions& options = {});

/// The medial object as recognition and blocks want it: a crossing is one junction, and edges have no more
/// points than the samples ask for.
Result<MedialObject> medial_object_of_bead(const PlanarRegion& region);

/// Measures, classifies and names the bead. `id` and the number of the faces are the caller's. Fails with the
/// reason why the face is no bead: bead.aspect_ratio, bead.flat, bead.no_axis.
Result<Bead> recognise(const FaceStudy& study, const MedialObject& medial, const BeadOptions& options = {});

}  // namespace beadmesh
