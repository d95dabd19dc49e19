#include "batch/worker.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace beadmesh::app {
namespace {

/// Of the output this much is kept of its beginning, and as much of its end.
constexpr size_t kept_output = 512 * 1024;
constexpr int cannot_start = 126;

void append(std::string& output, const char* bytes, size_t count) {
  output.append(bytes, count);
  if (output.size() > 3 * kept_output)
    output.replace(kept_output, output.size() - 2 * kept_output, "\n[left out]\n");
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void limit_memory(double memory_mb) {
  if (memory_mb <= 0 || !memory_can_be_limited()) return;
  const auto bytes = static_cast<rlim_t>(memory_mb * 1024 * 1024);
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_AS, &limit);
}

/// The child's side of the fork: nothing here may allocate.
[[noreturn]] void become(char* const* argv, int output, const WorkerLimits& limits, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(cannot_start);  // the parent ended before the line above
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  limit_memory(limits.memory_mb);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execv("/proc/self/exe", argv);
  const char message[] = "error batch.process: the program cannot be started again\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message, sizeof message - 1);
  ::_exit(cannot_start);
}

}  // namespace

bool memory_can_be_limited() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;
#else
  return true;
#endif
}

Result<Worker> Worker::start(const std::vector<std::string>& words, const WorkerLimits& limits) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    return fail("batch.process", std::string("no pipe for a worker: ") + std::strerror(errno));
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);

  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) become(argv.data(), ends[1], limits, parent);
  const int problem = errno;
  ::close(ends[1]);
  if (process < 0) {
    ::close(ends[0]);
    return fail("batch.process", std::string("no process for a worker: ") + std::strerror(problem));
  }
  ::setpgid(process, process);  // here too, so that it holds whichever side comes first
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  Worker worker;
  worker.process_ = process, worker.pipe_ = ends[0];
  worker.limits_ = limits, worker.started_ = Clock::now();
  return worker;
}

Worker::Worker(Worker&& other) noexcept {
  *this = std::move(other);
}

Worker& Worker::operator=(Worker&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(pipe_, other.pipe_);
  std::swap(limits_, other.limits_);
  std::swap(started_, other.started_);
  std::swap(end_, other.end_);
  return *this;
}

Worker::~Worker() {
  kill();
  if (process_ > 0) ::waitpid(process_, nullptr, 0);
  if (pipe_ >= 0) ::close(pipe_);
}

void Worker::kill() {
  if (process_ > 0) ::kill(-process_, SIGKILL);
}

void Worker::read_output() {
  char buffer[16384];
  while (pipe_ >= 0) {
    const ssize_t count = ::read(pipe_, buffer, sizeof buffer);
    if (count > 0) {
      append(end_.output, buffer, static_cast<size_t>(count));
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && errno == EAGAIN) {
      return;
    } else {
      ::close(pipe_);
      pipe_ = -1;
    }
  }
}

bool Worker::reap() {
  int status = 0;
  rusage usage{};
  if (::wait4(process_, &status, WNOHANG, &usage) != process_) return false;
  process_ = 0;
  if (WIFSIGNALED(status)) end_.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end_.exit_status = WEXITSTATUS(status);
  end_.cpu_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  end_.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  return true;
}

bool Worker::poll() {
  read_output();
  end_.seconds = std::chrono::duration<double>(Clock::now() - started_).count();
  if (process_ > 0 && reap()) read_output();
  if (process_ == 0) return true;
  if (limits_.seconds > 0 && end_.seconds > limits_.seconds && !end_.timed_out) {
    end_.timed_out = true;
    kill();
  }
  return false;
}

}  // namespace beadmesh::app
