#include "beadmesh/write/whole_files.h"

#include <unistd.h>

#include <fstream>
#include <system_error>

namespace beadmesh {
namespace {

namespace fs = std::filesystem;

/// The file that a symbolic link stands for, so that the link survives the rename.
fs::path resolved(fs::path path) {
  std::error_code error;
  for (int hops = 0; hops < 40 && fs::is_symlink(path, error); ++hops) {
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Hidden, and different for every process, so that two runs do not share one.
fs::path temporary_of(const fs::path& path) {
  fs::path name = folder_of(path) / ".";
  name += path.filename();
  name += '.' + std::to_string(::getpid());
  name += ".part";
  return name;
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

Result<void> check_place(const fs::path& path) {
  std::error_code error;
  if (path.empty() || !path.has_filename())
    return fail("write.target", "the name of the output file is empty", "give a file, not a folder",
                path.string());
  const fs::path folder = folder_of(path);
  if (!fs::is_directory(folder, error))
    return fail("write.folder", "the folder " + folder.string() + " does not exist", "create it first",
                path.string());
  if (fs::is_directory(path, error))
    return fail("write.target", "is a folder", "give the name of a file", path.string());
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))
    return fail("write.target", "exists and is no regular file", "give the name of a file", path.string());
  return {};
}

}  // namespace

Result<void> check_target(const fs::path& given) {
  const fs::path path = resolved(given);
  if (auto place = check_place(path); !place) return place;
  const fs::path probe = temporary_of(path);
  const bool writable = std::ofstream(probe, std::ios::binary).good();
  remove_quietly(probe);
  if (!writable)
    return fail("write.folder", "the folder " + folder_of(path).string() + " cannot be written to",
                "check its permissions", given.string());
  return {};
}

WholeFiles::~WholeFiles() {
  for (const Staged& file : staged_) remove_quietly(file.temporary);
}

Result<void> WholeFiles::add(const fs::path& given, const Writer& write) {
  const fs::path path = resolved(given);
  if (auto place = check_place(path); !place) return place;
  staged_.push_back({temporary_of(path), path});
  std::ofstream out(staged_.back().temporary, std::ios::binary | std::ios::trunc);
  if (!out)
    return fail("write.folder", "the folder " + folder_of(path).string() + " cannot be written to",
                "check its permissions", given.string());
  write(out);
  out.close();
  if (!out)
    return fail("write.full", "the file could not be written to its end", "is the disk full?",
                given.string());
  return {};
}

Result<void> WholeFiles::commit() {
  for (size_t i = 0; i < staged_.size(); ++i) {
    std::error_code error;
    fs::rename(staged_[i].temporary, staged_[i].target, error);
    if (!error) continue;
    for (size_t done = 0; done < i; ++done) remove_quietly(staged_[done].target);
    return fail("write.rename", "the file could not be put in place: " + error.message(), "",
                staged_[i].target.string());
  }
  staged_.clear();
  return {};
}

Result<void> write_whole(const fs::path& path, const WholeFiles::Writer& write) {
  WholeFiles files;
  if (auto added = files.add(path, write); !added) return added;
  return files.commit();
}

}  // namespace beadmesh
