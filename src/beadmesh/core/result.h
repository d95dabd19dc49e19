// The outcome of a step that can fail: a value, or the Diagnostic that says why there is none.
#pragma once

#include <tl/expected.hpp>
#include <utility>

#include "beadmesh/core/diagnostic.h"

namespace beadmesh {

template <class T>
using Result = tl::expected<T, Diagnostic>;

using Failure = tl::unexpected<Diagnostic>;

/// Shorthand for the error branch: `return fail("flatten.flip", "3 triangles are turned over");`
inline Failure fail(std::string code, std::string message, std::string hint = {}, std::string entity = {},
                    Index face = no_index) {
  return Failure(Diagnostic{std::move(code), Severity::error, face, std::move(entity), std::move(message),
                            std::move(hint)});
}

}  // namespace beadmesh
