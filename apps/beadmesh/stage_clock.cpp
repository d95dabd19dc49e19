#include "stage_clock.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

namespace beadmesh::app {
namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

rusage usage_of_process() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage;
}

}  // namespace

StageClock::Moment StageClock::now() {
  const rusage usage = usage_of_process();
  return {std::chrono::steady_clock::now(), seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime)};
}

void StageClock::enter(std::string_view stage) {
  const std::lock_guard lock(mutex_);
  if (running_ && stages_.back().name == stage) return;
  const Moment at = now();
  end_stage(at);
  const auto known =
      std::find_if(stages_.begin(), stages_.end(), [&](const Stage& other) { return other.name == stage; });
  if (known == stages_.end())
    stages_.push_back({std::string(stage), 0, 0});
  else
    std::rotate(known, known + 1, stages_.end());
  entered_ = at;
  running_ = true;
}

void StageClock::stop() {
  const std::lock_guard lock(mutex_);
  end_stage(now());
}

void StageClock::end_stage(const Moment& at) {
  if (!running_) return;
  stages_.back().seconds += std::chrono::duration<double>(at.wall - entered_.wall).count();
  stages_.back().processor += at.processor - entered_.processor;
  running_ = false;
}

double peak_memory() {
  return static_cast<double>(usage_of_process().ru_maxrss) / 1024;
}

std::string timing_table(const std::vector<StageClock::Stage>& stages) {
  std::string table = fmt::format("{:<14}{:>10}{:>14}\n", "stage", "seconds", "processor s");
  StageClock::Stage all{"all", 0, 0};
  const auto add = [&](const StageClock::Stage& stage) {
    table += fmt::format("{:<14}{:>10.3f}{:>14.3f}\n", stage.name, stage.seconds, stage.processor);
  };
  for (const StageClock::Stage& stage : stages) {
    add(stage);
    all.seconds += stage.seconds;
    all.processor += stage.processor;
  }
  add(all);
  return table + fmt::format("memory at most {:.0f} MB\n", peak_memory());
}

}  // namespace beadmesh::app
