// Settings from a parsed TOML table; apart from config_file.h, since toml++ takes seconds to compile.
#pragma once

#include <toml++/toml.h>

#include <filesystem>

#include "settings.h"

namespace beadmesh::app {

/// As read_config (config_file.h); the table must come from a parser, so that it knows its lines.
Result<SettingsLayer> settings_of_table(const toml::table& table, const std::filesystem::path& source);

}  // namespace beadmesh::app
