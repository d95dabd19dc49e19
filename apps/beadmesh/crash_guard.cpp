#include "crash_guard.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace beadmesh::app {
namespace {

// All that a handler may touch: ready-made text, and calls that are safe in one.
std::string line;

void refuse(int) {
  const auto written = write(STDERR_FILENO, line.data(), line.size());
  _exit(written >= 0 ? 2 : 3);
}

/// A stack of its own: the fault may be that the usual one is full.
std::vector<char>& spare_stack() {
  static std::vector<char> stack(1 << 16);
  return stack;
}

/// While it lives, faults go to refuse().
class CrashGuard {
 public:
  explicit CrashGuard(const std::string& file) {
    line = "error read.crashed: " + file +
           ": the CAD kernel crashed on this file, which is damaged (export it again)\n";
    stack_t stack{};
    stack.ss_sp = spare_stack().data();
    stack.ss_size = spare_stack().size();
    sigaltstack(&stack, &stack_before_);
    struct sigaction action;
    std::memset(&action, 0, sizeof action);
    action.sa_handler = refuse;
    action.sa_flags = SA_ONSTACK;
    for (std::size_t i = 0; i < faults.size(); ++i) sigaction(faults[i], &action, &before_[i]);
  }
  ~CrashGuard() {
    for (std::size_t i = 0; i < faults.size(); ++i) sigaction(faults[i], &before_[i], nullptr);
    sigaltstack(&stack_before_, nullptr);
  }
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

 private:
  static constexpr std::array<int, 4> faults{SIGSEGV, SIGBUS, SIGFPE, SIGABRT};

  std::array<struct sigaction, faults.size()> before_;
  stack_t stack_before_;
};

}  // namespace

Result<Panel> read_guarded(const std::filesystem::path& path, const ReadOptions& options,
                           const Context& context) {
  const CrashGuard guard(path.filename().string());
  return read_panel(path, options, context);
}

}  // namespace beadmesh::app
