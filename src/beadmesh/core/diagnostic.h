// What can be said about something that went wrong or fell short.
#pragma once

#include <string>
#include <string_view>

#include "beadmesh/core/vector.h"

namespace beadmesh {

enum class Severity { note, warning, error };

/// A message that names its entity. `code` is "stage.what" (for example "read.no_faces"), stable across
/// versions.
struct Diagnostic {
  std::string code;
  Severity severity = Severity::error;
  Index face = no_index;  ///< 1-based number of the face in the file's order, or no_index
  std::string entity;     ///< what it is about: a file, "loop 2", "edge 17"; empty where the face says it all
  std::string message;    ///< one sentence, no line break
  std::string hint;       ///< what the user can do; may be empty
};

std::string_view name_of(Severity severity);

/// "error read.no_faces: panel.step: the file has no faces (export the surfaces, not only curves)", one line.
std::string to_line(const Diagnostic& diagnostic);

}  // namespace beadmesh
