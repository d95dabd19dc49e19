// Time of each stage, taken from the progress that the stages report.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace beadmesh::app {

/// A stage lasts from its first report to the first report of another one. Stages follow each other; within
/// one any thread may report.
class StageClock {
 public:
  struct Stage {
    std::string name;
    double seconds = 0;    ///< on the clock
    double processor = 0;  ///< of all threads of the process
  };

  void enter(std::string_view stage);
  /// Ends the last stage.
  void stop();
  const std::vector<Stage>& stages() const { return stages_; }

 private:
  struct Moment {
    std::chrono::steady_clock::time_point wall;
    double processor = 0;
  };
  static Moment now();
  void end_stage(const Moment& at);

  std::mutex mutex_;
  Moment entered_;
  bool running_ = false;
  std::vector<Stage> stages_;
};

/// Largest memory the process has held so far, in MB.
double peak_memory();

/// A line a stage, then the sum and the memory.
std::string timing_table(const std::vector<StageClock::Stage>& stages);

}  // namespace beadmesh::app
