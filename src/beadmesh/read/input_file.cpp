#include "beadmesh/read/input_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <utility>

#include "beadmesh/read/panel_reader.h"

namespace beadmesh {
namespace {

constexpr std::streamoff window = 4096;

constexpr std::pair<std::string_view, FileKind> endings[]{
    {".step", FileKind::step},  {".stp", FileKind::step},   {".igs", FileKind::iges},
    {".iges", FileKind::iges},  {".brep", FileKind::brep},  {".stl", FileKind::stl},
    {".obj", FileKind::obj},    {".ply", FileKind::ply},    {".bdf", FileKind::shells},
    {".nas", FileKind::shells}, {".dat", FileKind::shells}, {".k", FileKind::shells},
    {".key", FileKind::shells}, {".dyn", FileKind::shells}, {".inp", FileKind::shells}};

std::optional<FileKind> kind_of_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [name, kind] : endings)
    if (ending == name) return kind;
  return {};
}

std::string bytes(const std::filesystem::path& path, bool from_end) {
  std::ifstream stream(path, std::ios::binary);
  if (from_end) {
    stream.seekg(0, std::ios::end);
    stream.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(stream.tellg()) - window));
  }
  std::string text(window, '\0');
  stream.read(text.data(), window);
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return text;
}

}  // namespace

bool has_panel_ending(const std::filesystem::path& path) {
  const auto kind = kind_of_ending(path);
  return kind && *kind != FileKind::shells;  // decks stand in the same folders as results
}

FileKind file_kind(const std::filesystem::path& path) {
  return kind_of_ending(path).value_or(FileKind::step);
}

Result<FileKind> check_input_file(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return fail("read.not_found", "there is no such file", {}, name);
  if (std::filesystem::is_directory(status))
    return fail("read.directory", "this is a directory, not a file", {}, name);
  const std::optional<FileKind> kind = kind_of_ending(path);
  if (!kind)
    return fail(
        "read.ending", "the ending '" + path.extension().string() + "' is unknown",
        "use .step, .stp, .igs, .iges, .brep, .stl, .obj, .ply, .bdf, .nas, .dat, .k, .key, .dyn or .inp",
        name);
  if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(path, error) == 0)
    return fail("read.empty", "the file is empty", {}, name);
  if (!std::ifstream(path))
    return fail("read.unreadable", "the file cannot be opened", "check its permissions", name);
  return *kind;
}

bool head_contains(const std::filesystem::path& path, std::string_view text) {
  return bytes(path, false).find(text) != std::string::npos;
}

bool tail_contains(const std::filesystem::path& path, std::string_view text) {
  return bytes(path, true).find(text) != std::string::npos;
}

bool iges_is_complete(const std::filesystem::path& path) {
  const std::string text = bytes(path, true);
  for (std::size_t line = 0; line < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", line), text.size());
    if (end - line >= 73 && text[line + 72] == 'T') return true;
    line = end + 1;
  }
  return false;
}

bool brep_is_complete(const std::filesystem::path& path) {
  bool in_shapes = false, complete = false;
  std::string line;
  for (std::ifstream stream(path); std::getline(stream, line);) {
    in_shapes = in_shapes || line.starts_with("TShapes ");
    if (!in_shapes || line.empty()) continue;
    // The whole shape is such as "+1 0"; lists of sub-shapes end with a star.
    if (line.find('*') != std::string::npos)
      complete = false;
    else if (line[0] == '+' || line[0] == '-')
      complete = true;
  }
  return complete;
}

std::optional<double> millimetres_per(std::string_view unit) {
  if (unit == "mm") return 1;
  if (unit == "cm") return 10;
  if (unit == "m") return 1000;
  if (unit == "um") return 1e-3;
  if (unit == "in" || unit == "inch") return 25.4;
  if (unit == "ft") return 304.8;
  return {};
}

}  // namespace beadmesh
