// A bar on a terminal.
#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include "beadmesh/core/context.h"
#include "stage_clock.h"

namespace beadmesh::app {

/// Draws on standard error, and only where that is a terminal; gone when the object goes. Takes the time of
/// every stage. Any thread may report.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// A context that reports here; the bar must outlive it.
  Context context(int jobs);
  /// Ends the last stage and takes the bar away.
  void clear();
  const std::vector<StageClock::Stage>& stages() const { return clock_.stages(); }

 private:
  void draw(std::string_view stage, double fraction);

  bool on_terminal_;
  StageClock clock_;
  std::mutex mutex_;
  std::string shown_;
};

}  // namespace beadmesh::app
