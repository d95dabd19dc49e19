#include "batch/batch_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ostream>
#include <set>

#include "batch/sha256.h"
#include "batch/word_list.h"
#include "beadmesh/write/whole_files.h"

namespace beadmesh::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* state_name = "state.json";
constexpr const char* log_name = "log.txt";

Result<void> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return {};
  return fail("write.folder", "the folder cannot be made: " + error.message(), "", folder.string());
}

std::string toml_list(const std::vector<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) out += (out.empty() ? "" : ", ") + toml_text(text);
  return "[" + out + "]";
}

std::string settings_name(const std::string& text) {
  return "settings/" + sha256(text).substr(0, 16) + ".toml";
}

/// Renaming a folder over another one is no single step: the old one goes aside first.
Result<void> replace_folder(const fs::path& target, const fs::path& with) {
  fs::path aside = with;
  aside += ".old";
  std::error_code error, ignored;
  const bool had_one = fs::exists(target, ignored);
  if (had_one) fs::rename(target, aside, error);
  if (!error) fs::rename(with, target, error);
  if (error) {
    if (had_one && !fs::exists(target, ignored)) fs::rename(aside, target, ignored);
    return fail("write.rename", "the results could not be put in place: " + error.message(), "",
                target.string());
  }
  fs::remove_all(aside, ignored);
  return {};
}

}  // namespace

Result<void> BatchFolder::make() const {
  for (const char* name : {"panels", "settings"})
    if (auto made = make_folder(root_ / name); !made) return made;
  return {};
}

Result<void> BatchFolder::lock(bool alone) const {
  const fs::path path = root_ / ".lock";
  const int file = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
  if (file < 0) return fail("write.folder", "the folder cannot be written to", "", root_.string());
  if (::flock(file, (alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0 || errno != EWOULDBLOCK) return {};
  ::close(file);
  return fail("batch.busy", "another batch is at work in this folder", "wait for it, or give another folder",
              root_.string());
}

void BatchFolder::remove_leftovers() const {
  std::error_code error;
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(root_ / "panels", error))
    if (entry.path().filename().string().front() == '.') left.push_back(entry.path());
  for (const fs::path& path : left) fs::remove_all(path, error);
}

fs::path BatchFolder::settings_file(const std::string& text) const {
  return root_ / settings_name(text);
}

Result<void> BatchFolder::write_manifest(const std::vector<BatchPanel>& panels) const {
  std::set<std::string> texts;
  std::string manifest = "# The panels of this batch as they were resolved; itself a manifest.\n";
  for (const BatchPanel& panel : panels) {
    std::vector<std::string> configs;
    for (const std::string& text : panel.settings) {
      configs.push_back(settings_name(text));
      texts.insert(text);
    }
    manifest += fmt::format("\n[[panel]]\nname = {}\ninput = {}\n", toml_text(panel.name),
                            toml_text(panel.input.string()));
    if (!configs.empty()) manifest += fmt::format("config = {}\n", toml_list(configs));
    if (!panel.options.empty()) manifest += fmt::format("options = {}\n", toml_list(panel.options));
  }
  for (const std::string& text : texts)
    if (auto put = write_whole(settings_file(text), [&](std::ostream& out) { out << text; }); !put)
      return put;
  return write_whole(root_ / "batch.toml", [&](std::ostream& out) { out << manifest; });
}

std::optional<PanelState> BatchFolder::valid_state(const std::string& name,
                                                   const Fingerprint& fingerprint) const {
  auto state = read_state(of_panel(name) / state_name);
  if (!state || state->fingerprint != fingerprint) return {};
  std::error_code error;
  for (const std::string& file : state->files)
    if (!fs::is_regular_file(of_panel(name) / file, error)) return {};
  return state;
}

Result<fs::path> BatchFolder::work_folder(const std::string& name) const {
  char host[256] = "";
  ::gethostname(host, sizeof host - 1);
  const fs::path work = root_ / "panels" / fmt::format(".{}.{}.{}", name, host, ::getpid());
  std::error_code ignored;
  fs::remove_all(work, ignored);
  if (auto made = make_folder(work); !made) return tl::make_unexpected(made.error());
  return work;
}

Result<void> BatchFolder::put(const fs::path& work, PanelState& state, const std::string& log) const {
  std::error_code error;
  state.files = {log_name};
  std::vector<fs::path> half;
  for (const auto& entry : fs::directory_iterator(work, error)) {
    const std::string name = entry.path().filename().string();
    if (name.front() == '.')
      half.push_back(entry.path());  // of a worker that was killed while it wrote
    else
      state.files.push_back(name);
  }
  for (const fs::path& path : half) fs::remove(path, error);
  std::sort(state.files.begin(), state.files.end());
  auto put = write_whole(work / log_name, [&](std::ostream& out) { out << log; });
  if (put) put = write_whole(work / state_name, [&](std::ostream& out) { out << state_text(state); });
  if (put) put = replace_folder(of_panel(state.name), work);
  if (!put) fs::remove_all(work, error);
  return put;
}

}  // namespace beadmesh::app
