// What every long stage shares with its caller: progress, cancelling, the number of threads.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace beadmesh {

struct Context {
  std::function<void(std::string_view stage, double fraction)>
      progress;                                  ///< default: none; may be called by several threads at once
  const std::atomic<bool>* cancelled = nullptr;  ///< default: never
  int jobs = 0;                                  ///< default: 0 = all cores

  bool is_cancelled() const { return cancelled && cancelled->load(std::memory_order_relaxed); }
  void report(std::string_view stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }
};

}  // namespace beadmesh
