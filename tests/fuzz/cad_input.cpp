#include "cad_input.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <string_view>

#include "beadmesh/read/panel_reader.h"
#include "fuzz_input.h"

namespace beadmesh::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr unsigned most_seconds = 20;  // of a file in its own process

/// A file that is gone when it goes out of scope.
class BytesFile {
 public:
  BytesFile(const std::uint8_t* data, std::size_t size, const std::string& ending)
      : path_(fs::temp_directory_path() / ("beadmesh_fuzz_" + std::to_string(getpid()) + ending)) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  ~BytesFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  BytesFile(const BytesFile&) = delete;
  BytesFile& operator=(const BytesFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// One thread: a process that is forked while others run cannot go on with them.
Result<Panel> read_alone(const fs::path& path, std::atomic<bool>* past_kernel) {
  Context context;
  context.jobs = 1;
  context.progress = [past_kernel](std::string_view stage, double) {
    if (past_kernel && stage == "facets") past_kernel->store(true);
  };
  ReadOptions options;
  options.skin = Skin::whole;  // rays through a damaged solid are another subject
  return read_panel(path, options, context);
}

/// Seen by both processes.
std::atomic<bool>& shared_flag() {
  static std::atomic<bool>* const flag = [] {
    void* const memory =
        mmap(nullptr, sizeof(std::atomic<bool>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::abort();
    return new (memory) std::atomic<bool>(false);
  }();
  return *flag;
}

/// Does reading end by itself? Aborts where it is not the kernel that fails.
bool survives(const fs::path& path) {
  std::atomic<bool>& past_kernel = shared_flag();
  past_kernel = false;
  const pid_t child = fork();
  if (child < 0) std::abort();
  if (child == 0) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT}) std::signal(signal, SIG_DFL);
    std::signal(SIGALRM, SIG_DFL);
    alarm(most_seconds);
    (void)read_alone(path, &past_kernel);
    _exit(0);
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child) std::abort();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  if (past_kernel) std::abort();
  return false;
}

}  // namespace

void read_cad_bytes(const std::uint8_t* data, std::size_t size, const std::string& ending) {
  const BytesFile file(data, size, ending);
  if (!survives(file.path())) return;
  const auto panel = read_alone(file.path(), nullptr);
  if (panel) return expect_none(verify_panel(*panel));
  if (panel.error().code.empty() || panel.error().message.empty()) std::abort();
}

}  // namespace beadmesh::fuzz
