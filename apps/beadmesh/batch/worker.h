// One run of a program as a process of its own, with what it printed and what it cost.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"

namespace beadmesh::app {

struct WorkerLimits {
  double seconds = 0;    ///< default 0: none
  double memory_mb = 0;  ///< default 0: none; of address space
};

/// False in a build with a sanitizer that reserves far more addresses than it uses: a limit of memory would
/// end every worker before its first line, and is not set.
bool memory_can_be_limited();

struct WorkerEnd {
  int exit_status = 0;  ///< 0 where a signal ended it
  int signal = 0;
  bool timed_out = false;
  std::string output;  ///< standard output and error as they came; the middle of a long one is left out
  double seconds = 0, cpu_seconds = 0, peak_mb = 0;
};

/// A process that does not outlive this one, in a group of its own. Killed with the object, where it still
/// runs.
class Worker {
 public:
  /// This very program with other words (words[0] is only its name). Fails with batch.process.
  static Result<Worker> start(const std::vector<std::string>& words, const WorkerLimits& limits);

  Worker(Worker&& other) noexcept;
  Worker& operator=(Worker&& other) noexcept;
  ~Worker();

  /// To wait for with poll(): readable when there is output, or the end.
  int descriptor() const { return pipe_; }
  /// Takes what there is without waiting, kills a worker that is past its time; true once it has ended.
  bool poll();
  /// After the end.
  const WorkerEnd& end() const { return end_; }
  void kill();

 private:
  using Clock = std::chrono::steady_clock;
  Worker() = default;
  void read_output();
  bool reap();

  pid_t process_ = 0;  ///< 0: none, or ended
  int pipe_ = -1;      ///< -1: at its end
  WorkerLimits limits_;
  Clock::time_point started_;
  WorkerEnd end_;
};

}  // namespace beadmesh::app
