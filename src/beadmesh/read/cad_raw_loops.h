// Inside the read room: a look at the faces of a STEP or IGES file before OpenCASCADE mends them.
#pragma once

#include <optional>

#include "beadmesh/core/result.h"
#include "beadmesh/read/cad_model.h"

namespace beadmesh {

/// The first face with a boundary that crosses itself; none where all are sound or cannot be judged (closed
/// surfaces).
std::optional<Diagnostic> crossing_loop(const CadModel& model);

/// While it lives, OpenCASCADE's readers hand it each shape before they mend it: mending cuts a face whose
/// boundary crosses itself into pieces, silently. Only one may live at a time.
class RawLoopWatch {
 public:
  RawLoopWatch();
  ~RawLoopWatch();
  RawLoopWatch(const RawLoopWatch&) = delete;
  RawLoopWatch& operator=(const RawLoopWatch&) = delete;

  /// What was seen so far.
  const std::optional<Diagnostic>& defect() const { return defect_; }

 private:
  std::optional<Diagnostic> defect_;
};

}  // namespace beadmesh
