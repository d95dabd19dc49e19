// Inside the read room: what can be said about an input file before a reader looks at it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "beadmesh/core/result.h"

namespace beadmesh {

enum class FileKind { step, iges, brep, stl, obj, ply, shells };

/// By the ending, in any case. Call only on paths that check_input_file has accepted.
FileKind file_kind(const std::filesystem::path& path);

/// Fails with read.not_found, read.directory, read.empty, read.ending or read.unreadable.
Result<FileKind> check_input_file(const std::filesystem::path& path);

/// Is `text` among the first (last) 4,096 bytes?
bool head_contains(const std::filesystem::path& path, std::string_view text);
bool tail_contains(const std::filesystem::path& path, std::string_view text);

/// Does a line of the last section (T in column 73) close the IGES file?
bool iges_is_complete(const std::filesystem::path& path);

/// Does the text BREP file have its last section, and end with the line that names the whole shape?
bool brep_is_complete(const std::filesystem::path& path);

/// mm, cm, m, um, in, inch, ft; none where the name is unknown.
std::optional<double> millimetres_per(std::string_view unit);

}  // namespace beadmesh
