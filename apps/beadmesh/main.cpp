// beadmesh: mesh, beads, medial, check, batch. Exit status 0, 1, 2 or 3, see --help.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "options.h"
#include "outputs.h"
#include "verbs.h"

namespace beadmesh::app {
namespace {

Result<int> run_verb(const Options& options) {
  switch (options.verb) {
    case Verb::mesh:
      return run_mesh(options);
    case Verb::beads:
      return run_beads(options);
    case Verb::medial:
      return run_medial(options);
    case Verb::check:
      return run_check(options);
    case Verb::batch:
      return run_batch(options.batch);
    case Verb::options:
      fmt::print("{}", options_page());
      return done;
  }
  return internal_error;
}

int refuse(const Diagnostic& reason) {
  fmt::print(stderr, "{}\n", to_line(reason));
  return reason.code.rfind("internal.", 0) == 0 ? internal_error : refused;
}

int run(int argc, const char* const* argv) {
  const auto options = parse_command_line(argc, argv);
  if (!options) return refuse(options.error());
  if (!*options) return done;
  if (auto good = check_outputs(**options); !good) return refuse(good.error());
  const auto status = run_verb(**options);
  return status ? *status : refuse(status.error());
}

}  // namespace
}  // namespace beadmesh::app

int main(int argc, char** argv) {
  // A closed pipe and a file past the limit of its size are errors of writing, not the end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return beadmesh::app::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("error internal.memory: not enough memory (use a larger element size, or a larger machine)\n",
               stderr);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "error internal.exception: {} (please report it with the input)\n", problem.what());
  } catch (...) {
    fmt::print(stderr, "error internal.exception: unknown (please report it with the input)\n");
  }
  return beadmesh::app::internal_error;
}
