// beadmesh: mesh, beads, medial, check. Exit status 0, 1, 2 or 3, see --help.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>

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
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of writing, not the end
  try {
    return beadmesh::app::run(argc, argv);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "error internal.exception: {} (please report it with the input)\n", problem.what());
  } catch (...) {
    fmt::print(stderr, "error internal.exception: unknown (please report it with the input)\n");
  }
  return beadmesh::app::internal_error;
}
