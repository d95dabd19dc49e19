#include "beadmesh/core/diagnostic.h"

namespace beadmesh {

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

std::string to_line(const Diagnostic& diagnostic) {
  std::string line = std::string(name_of(diagnostic.severity)) + " " + diagnostic.code + ": ";
  if (diagnostic.face != no_index) line += "face " + std::to_string(diagnostic.face) + ": ";
  if (!diagnostic.entity.empty()) line += diagnostic.entity + ": ";
  line += diagnostic.message;
  if (!diagnostic.hint.empty()) line += " (" + diagnostic.hint + ")";
  for (char& c : line)
    if (c == '\n' || c == '\r') c = ' ';
  return line;
}

}  // namespace beadmesh
