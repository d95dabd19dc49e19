#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace beadmesh::app {

ProgressBar::ProgressBar() : on_terminal_(::isatty(STDERR_FILENO) != 0) {}

Context ProgressBar::context(int jobs) {
  Context context;
  context.jobs = jobs;
  context.progress = [this](std::string_view stage, double fraction) {
    clock_.enter(stage);
    if (on_terminal_) draw(stage, fraction);
  };
  return context;
}

void ProgressBar::draw(std::string_view stage, double fraction) {
  constexpr int width = 30;
  const double done = std::clamp(std::isfinite(fraction) ? fraction : 0.0, 0.0, 1.0);
  const int filled = static_cast<int>(done * width);
  std::string line =
      fmt::format("[{:#<{}}{:.<{}}] {:3.0f} % {}", "", filled, "", width - filled, 100 * done, stage);
  const std::lock_guard lock(mutex_);
  if (line == shown_) return;
  shown_ = std::move(line);
  fmt::print(stderr, "\r{}\x1b[K", shown_);
  std::fflush(stderr);
}

void ProgressBar::clear() {
  clock_.stop();
  if (shown_.empty()) return;
  shown_.clear();
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace beadmesh::app
