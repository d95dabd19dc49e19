// One function a verb. Each returns the exit status of the program, or why there is none to speak of (exit
// 2).
#pragma once

#include "beadmesh/core/result.h"
#include "options.h"

namespace beadmesh::app {

inline constexpr int done = 0, fell_short = 1, refused = 2, internal_error = 3;

Result<int> run_mesh(const Options& options);
Result<int> run_beads(const Options& options);
Result<int> run_medial(const Options& options);
Result<int> run_check(const Options& options);
Result<int> run_batch(const BatchOptions& options);

}  // namespace beadmesh::app
