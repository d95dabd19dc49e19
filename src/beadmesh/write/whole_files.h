// Files that appear together and whole, or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <vector>

#include "beadmesh/core/result.h"

namespace beadmesh {

/// Ok where a file can be put at `path`: its folder exists and can be written to, and `path` itself is free
/// or a regular file. Fails with write.folder, write.target. Leaves nothing behind.
Result<void> check_target(const std::filesystem::path& path);

/// Collects files under temporary names beside their targets; commit() renames them all. What is not
/// committed when the object goes is removed. Existing targets are untouched until then.
class WholeFiles {
 public:
  using Writer = std::function<void(std::ostream&)>;

  WholeFiles() = default;
  WholeFiles(const WholeFiles&) = delete;
  WholeFiles& operator=(const WholeFiles&) = delete;
  ~WholeFiles();

  /// Runs `write` on the temporary file of `path`. Fails with write.folder, write.target, write.full.
  Result<void> add(const std::filesystem::path& path, const Writer& write);
  /// Renames every file; where one cannot be, those renamed before it are removed again. Fails with
  /// write.rename.
  Result<void> commit();

 private:
  struct Staged {
    std::filesystem::path temporary, target;
  };
  std::vector<Staged> staged_;
};

/// One file: add and commit.
Result<void> write_whole(const std::filesystem::path& path, const WholeFiles::Writer& write);

}  // namespace beadmesh
