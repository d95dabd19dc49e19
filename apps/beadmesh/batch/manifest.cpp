#include "batch/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

#include "batch/panel_entry.h"
#include "batch/word_list.h"
#include "beadmesh/read/panel_reader.h"

namespace beadmesh::app {
namespace {

namespace fs = std::filesystem;
using Panels = std::vector<BatchPanel>;

std::optional<Layer> layer_of_options(const SettingsLayer& given) {
  Layer layer{"", {}, "the command line"};
  const auto add = [&](const char* key, const auto& value, const auto& written) {
    if (value) layer.text += fmt::format("{} = {}\n", key, written(*value));
  };
  const auto number = [](double value) { return fmt::format("{:#}", value); };
  add("preset", given.preset, toml_text);
  add("size", given.size, number);
  add("min_edge", given.min_edge, number);
  add("thickness", given.thickness, number);
  add("unit", given.unit, toml_text);
  if (layer.text.empty()) return {};
  layer.settings = given;
  layer.settings.jobs.reset();
  return layer;
}

Result<std::vector<Layer>> common_layers(const CommonSettings& common) {
  std::vector<Layer> layers;
  for (const fs::path& path : common.configs) {
    auto layer = layer_of_file(path);
    if (!layer) return tl::make_unexpected(layer.error());
    layers.push_back(std::move(*layer));
  }
  if (auto layer = layer_of_options(common.layer)) layers.push_back(std::move(*layer));
  return layers;
}

/// Names that are taken get a number, in the order of the panels.
void make_names_unique(Panels& panels) {
  std::set<std::string> taken;
  for (BatchPanel& panel : panels) {
    std::string name = panel.name;
    for (int number = 2; !taken.insert(name).second; ++number)
      name = fmt::format("{}-{}", panel.name, number);
    panel.name = name;
  }
}

bool lies_below(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

Result<Panels> of_folder(const fs::path& folder, const std::vector<Layer>& common, const fs::path& except) {
  std::vector<fs::path> inputs;
  std::error_code error;
  const fs::path hidden = fs::weakly_canonical(fs::absolute(except), error);
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && it != end; it.increment(error)) {
    if (it->is_directory(error) && lies_below(fs::weakly_canonical(it->path(), error), hidden))
      it.disable_recursion_pending();
    else if (it->is_regular_file(error) && has_panel_ending(it->path()))
      inputs.push_back(it->path());
  }
  if (error)
    return fail("batch.folder", "the folder cannot be read: " + error.message(), "", folder.string());
  std::sort(inputs.begin(), inputs.end());
  Panels panels;
  for (const fs::path& input : inputs) {
    const fs::path inside = fs::relative(input, folder, error).replace_extension();
    BatchPanel& panel = panels.emplace_back();
    panel.name = safe_name(inside.string()), panel.input = fs::absolute(input);
    if (auto put = complete(panel, common, folder.string()); !put) return tl::make_unexpected(put.error());
  }
  return panels;
}

Result<BatchPanel> of_line(const std::string& line, const fs::path& folder, const std::string& place,
                           std::vector<Layer> layers) {
  BatchPanel panel;
  std::error_code error;
  auto words = words_of(line);
  if (fs::is_regular_file(folder / line, error)) words = {{line}};  // a name with spaces
  if (!words) return fail("batch.quote", "a quote is not closed", "", place);
  panel.input = fs::absolute(folder / words->front()).lexically_normal();
  panel.name = safe_name(panel.input.stem().string());
  panel.options.assign(words->begin() + 1, words->end());
  auto configs = take_configs(panel.options, folder);
  if (!configs) return tl::make_unexpected(configs.error());
  for (Layer& layer : *configs) layers.push_back(std::move(layer));
  if (auto put = complete(panel, layers, place); !put) return tl::make_unexpected(put.error());
  return panel;
}

Result<Panels> of_list(const std::string& text, const fs::path& path, const std::vector<Layer>& common) {
  Panels panels;
  std::istringstream lines(text);
  std::string line;
  for (size_t number = 1; std::getline(lines, line); ++number) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    line.erase(0, std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.empty() || line.front() == '#') continue;
    if (line.find('\0') != std::string::npos)
      return fail("batch.list", "this is no list of paths", "give a text file, a panel a line, or a .toml",
                  place_of(path, number));
    auto panel = of_line(line, path.parent_path(), place_of(path, number), common);
    if (!panel) return tl::make_unexpected(panel.error());
    panels.push_back(std::move(*panel));
  }
  return panels;
}

Result<Panels> of_file(const fs::path& path, const std::vector<Layer>& common) {
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) return fail("batch.unreadable", "the manifest cannot be read", "", path.string());
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".toml") {
    if (has_panel_ending(path))
      return fail("batch.list", "this is a panel, not a manifest", "use beadmesh mesh", path.string());
    return of_list(text, path, common);
  }
  return panels_of_toml(text, path, common);
}

}  // namespace

Result<Panels> read_manifest(const fs::path& path, const CommonSettings& common, const fs::path& except) {
  const auto layers = common_layers(common);
  if (!layers) return tl::make_unexpected(layers.error());
  std::error_code error;
  if (!fs::exists(path, error))
    return fail("batch.not_found", "there is no such manifest or folder", "", path.string());
  auto panels = fs::is_directory(path, error) ? of_folder(path, *layers, except) : of_file(path, *layers);
  if (!panels) return panels;
  if (panels->empty())
    return fail("batch.empty", "no panel in it", "a folder with panel files, a path a line, or [[panel]]",
                path.string());
  make_names_unique(*panels);
  return panels;
}

}  // namespace beadmesh::app
