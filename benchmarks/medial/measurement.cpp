#include "measurement.h"

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>

#include "live_memory.h"

namespace beadmesh::bench {
namespace {

double status_kilobytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::strtod(line.c_str() + key.size() + 1, nullptr);
  return 0;
}

ChildReport measured(const Run& run) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak of the resident set starts anew
  const double resident = status_kilobytes("VmRSS");
  start_counting_memory();
  const double start = thread_seconds();
  run();
  const double seconds = thread_seconds() - start;
  const auto peak = static_cast<double>(peak_of_counted_memory());
  return {seconds, peak, (status_kilobytes("VmHWM") - resident) * 1024};
}

}  // namespace

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::optional<ChildReport> run_in_child(const Run& run, unsigned limit_seconds) {
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child < 0) return std::nullopt;
  if (child == 0) {
    alarm(limit_seconds);
    try {
      const ChildReport report = measured(run);
      if (write(ends[1], &report, sizeof report) != sizeof report) _exit(1);
    } catch (const std::exception&) {
      _exit(1);
    }
    _exit(0);
  }
  close(ends[1]);
  ChildReport report;
  const bool complete = read(ends[0], &report, sizeof report) == sizeof report;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!complete || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return report;
}

}  // namespace beadmesh::bench
