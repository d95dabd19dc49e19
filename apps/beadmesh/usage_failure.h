// What a command line that cannot be parsed is told: the word that is wrong, and what may have been meant.
#pragma once

#include "beadmesh/core/result.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace beadmesh::app {

/// usage.arguments, after `app` has thrown `problem` on these words.
Failure usage_failure(const CLI::App& app, int argc, const char* const* argv, const CLI::ParseError& problem);

}  // namespace beadmesh::app
