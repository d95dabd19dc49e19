// Inside the manifest readers: an entry's layers of settings, its words and its name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/manifest.h"

namespace beadmesh::app {

/// One layer of settings, and where it is from.
struct Layer {
  std::string text;
  SettingsLayer settings;
  std::string place;
};

/// "list.txt:3".
std::string place_of(const std::filesystem::path& path, size_t line);

/// Of a configuration file. Fails with config.*.
Result<Layer> layer_of_file(const std::filesystem::path& path);

/// Letters, digits, "-", "_", "." and whatever is not ASCII; never hidden, never too long for a file system.
std::string safe_name(const std::string& text);

/// Takes `--config FILE` and `--config=FILE` out of the words; files are relative to `folder`.
Result<std::vector<Layer>> take_configs(std::vector<std::string>& words, const std::filesystem::path& folder);

/// The texts of the layers go to the panel. Fails where they make no sense together, or an option is wrong or
/// one that the batch sets itself; `place` is named.
Result<void> complete(BatchPanel& panel, const std::vector<Layer>& layers, const std::string& place);

/// The panels of a TOML manifest; `common` lies between [defaults] and [[panel]]. Fails with batch.* and
/// config.*.
Result<std::vector<BatchPanel>> panels_of_toml(const std::string& text, const std::filesystem::path& path,
                                               const std::vector<Layer>& common);

}  // namespace beadmesh::app
