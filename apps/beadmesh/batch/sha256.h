// The SHA-256 of texts and files: whether a panel must be done again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace beadmesh::app {

/// 64 hexadecimal digits. Source: FIPS 180-4, section 6.2.
std::string sha256(std::string_view text);

/// Of the file's bytes; none where it cannot be read.
std::optional<std::string> sha256_of_file(const std::filesystem::path& path);

}  // namespace beadmesh::app
