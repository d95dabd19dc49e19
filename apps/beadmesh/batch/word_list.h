// Words of a line as in a shell, and texts quoted for a shell and for TOML.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beadmesh::app {

/// Single and double quotes, a backslash before any character outside single quotes; `#` at the start of a
/// word begins a comment. None where a quote is not closed.
std::optional<std::vector<std::string>> words_of(std::string_view line);

/// The words as a line that a shell reads as these words.
std::string shell_line(const std::vector<std::string>& words);

/// The text as a basic string of TOML, with its quotes.
std::string toml_text(const std::string& text);

}  // namespace beadmesh::app
