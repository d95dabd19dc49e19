// The panels of a batch: from a folder, a list of paths, or a TOML manifest.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"
#include "settings.h"

namespace beadmesh::app {

struct BatchPanel {
  std::string name;                   ///< of its folder and files; unique in the batch
  std::filesystem::path input;        ///< absolute; need not exist
  std::vector<std::string> settings;  ///< texts of configuration files; later ones win
  std::vector<std::string> options;   ///< words for `beadmesh mesh`; they win over the settings
};

/// What the command line of `batch` says for all panels: wins over [defaults], loses against [[panel]].
struct CommonSettings {
  std::vector<std::filesystem::path> configs;
  SettingsLayer layer;  ///< preset, size, min_edge, thickness and unit of it
};

/// By what `path` is. A folder: its panel files and those of folders below, in the order of their paths,
/// without those below `except`. `.toml`: [defaults] and a [[panel]] each. Anything else: a list, a panel a
/// line, options behind it. Paths are relative to the folder of the manifest. Fails with batch.* and
/// config.*, naming the line: nothing to read, no panel, an unknown key, settings that make no sense. A panel
/// file that is missing is no failure here.
Result<std::vector<BatchPanel>> read_manifest(const std::filesystem::path& path, const CommonSettings& common,
                                              const std::filesystem::path& except);

}  // namespace beadmesh::app
