// The folder of a batch: where things are in it, and how a panel's results get there, whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "batch/panel_state.h"

namespace beadmesh::app {

/// Files of the folder `root`:
///   batch.toml            the panels as they were resolved; itself a manifest
///   settings/<hash>.toml  the settings that it names
///   panels/<name>/        deck, table, report, log.txt and state.json of a panel
///   batch.json .csv .html the summary; times.csv what each run cost
class BatchFolder {
 public:
  explicit BatchFolder(std::filesystem::path root) : root_(std::move(root)) {}

  /// Makes the folders. Fails with write.folder.
  Result<void> make() const;
  /// Held until the process ends: alone, or with others that hold it so. Fails with batch.busy where another
  /// batch works here; a file system without locks is let pass.
  Result<void> lock(bool alone) const;
  /// What batches that were killed have left. Only while locked alone.
  void remove_leftovers() const;
  /// batch.toml and settings/. Fails with write.*.
  Result<void> write_manifest(const std::vector<BatchPanel>& panels) const;

  std::filesystem::path file(const std::string& name) const { return root_ / name; }
  std::filesystem::path of_panel(const std::string& name) const { return root_ / "panels" / name; }
  std::filesystem::path settings_file(const std::string& text) const;
  /// The state of a panel, where it is that of this fingerprint and all its files are there.
  std::optional<PanelState> valid_state(const std::string& name, const Fingerprint& fingerprint) const;

  /// A new, empty folder to work in. Fails with write.folder.
  Result<std::filesystem::path> work_folder(const std::string& name) const;
  /// Adds log and state to the folder and puts it in the place of the panel's old one. Fails with write.*;
  /// then the old one is as it was and `work` is gone.
  Result<void> put(const std::filesystem::path& work, PanelState& state, const std::string& log) const;

 private:
  std::filesystem::path root_;
};

}  // namespace beadmesh::app
