// Time and memory of one run.
#pragma once

#include <optional>
#include <string>

#include "candidates.h"

namespace beadmesh::bench {

/// Processor seconds of this thread; waiting for the processor does not count.
double thread_seconds();

struct ChildReport {
  double seconds = 0;
  double peak_bytes = 0;      ///< live at once, allocated by the run
  double resident_bytes = 0;  ///< growth of the resident set to its peak
};

/// One run in a child process, so that it may crash, and no heap of earlier runs hides what it needs. Empty
/// where it crashed, failed, or took longer than the limit.
std::optional<ChildReport> run_in_child(const Run& run, unsigned limit_seconds);

}  // namespace beadmesh::bench
