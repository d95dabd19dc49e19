#include "batch/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

#include "batch/word_list.h"
#include "beadmesh/read/panel_reader.h"
#include "config_file.h"
#include "config_table.h"
#include "options.h"

namespace beadmesh::app {
namespace {

namespace fs = std::filesystem;
using Panels = std::vector<BatchPanel>;

/// One layer of settings, and where it is from.
struct Layer {
  std::string text;
  SettingsLayer settings;
  std::string place;
};

std::string place_of(const fs::path& path, size_t line) {
  return fmt::format("{}:{}", path.string(), line);
}

Result<Layer> layer_of_file(const fs::path& path) {
  auto text = config_text(path);
  if (!text) return tl::make_unexpected(text.error());
  auto settings = parse_config(*text, path);
  if (!settings) return tl::make_unexpected(settings.error());
  return Layer{std::move(*text), std::move(*settings), path.string()};
}

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

std::optional<Layer> layer_of_options(const SettingsLayer& given) {
  Layer layer{"", {}, "the command line"};
  const auto add = [&](const char* key, const auto& value, const auto& written) {
    if (value) layer.text += fmt::format("{} = {}\n", key, written(*value));
  };
  const auto number = [](double value) { return fmt::format("{:#}", value); };
  add("preset", given.preset, quoted);
  add("size", given.size, number);
  add("min_edge", given.min_edge, number);
  add("thickness", given.thickness, number);
  add("unit", given.unit, quoted);
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

/// The layers make sense together; their texts go to the panel.
Result<void> put_layers(const std::vector<Layer>& layers, const std::string& place, BatchPanel& panel) {
  Settings settings;
  const auto named = [&](Diagnostic reason) {
    reason.entity = place;
    return tl::make_unexpected(reason);
  };
  for (const Layer& layer : layers) {
    if (auto good = apply(layer.settings, settings); !good) return named(good.error());
    panel.settings.push_back(layer.text);
  }
  if (auto good = check(settings); !good) return named(good.error());
  return {};
}

/// Letters, digits, "-", "_", "." and whatever is not ASCII; never hidden, never too long for a file system.
std::string safe_name(const std::string& text) {
  constexpr size_t longest = 180;
  std::string name;
  for (const char c : text.substr(0, longest)) {
    const auto u = static_cast<unsigned char>(c);
    name += std::isalnum(u) || u >= 0x80 || (c == '.' && !name.empty()) || c == '-' ? c : '_';
  }
  return name.empty() ? "panel" : name;
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

/// What the batch sets itself, and what would print instead of mesh.
Result<void> check_words(const BatchPanel& panel, const std::string& place) {
  for (const std::string& word : panel.options)
    for (const std::string name :
         {"-o", "--output", "--json", "--csv", "--report", "--jobs", "-h", "--help", "--version"})
      if (word == name || word.rfind(name + "=", 0) == 0)
        return fail("batch.option", fmt::format("{} cannot be set for a panel", name),
                    "the batch sets outputs and jobs", place);
  std::vector<std::string> words{"beadmesh", "mesh", panel.input.string(), "-o", "out.bdf"};
  words.insert(words.end(), panel.options.begin(), panel.options.end());
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  const auto options = parse_command_line(static_cast<int>(argv.size()), argv.data());
  if (options) return {};
  return fail("batch.option", options.error().message, options.error().hint, place);
}

/// `--config FILE` and `--config=FILE` among the words become layers.
Result<std::vector<Layer>> take_configs(std::vector<std::string>& words, const fs::path& folder) {
  std::vector<Layer> layers;
  std::vector<std::string> kept;
  for (size_t i = 0; i < words.size(); ++i) {
    const bool joined = words[i].rfind("--config=", 0) == 0;
    if (!joined && (words[i] != "--config" || i + 1 == words.size())) {
      kept.push_back(words[i]);
      continue;
    }
    auto layer = layer_of_file(folder / (joined ? words[i].substr(9) : words[++i]));
    if (!layer) return tl::make_unexpected(layer.error());
    layers.push_back(std::move(*layer));
  }
  words = std::move(kept);
  return layers;
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
    if (auto put = put_layers(common, folder.string(), panel); !put) return tl::make_unexpected(put.error());
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
  if (auto put = put_layers(layers, place, panel); !put) return tl::make_unexpected(put.error());
  if (auto good = check_words(panel, place); !good) return tl::make_unexpected(good.error());
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

/// Reads a TOML manifest.
class TomlManifest {
 public:
  TomlManifest(const fs::path& path, const std::vector<Layer>& common) : path_(path), common_(common) {}

  Result<Panels> run(toml::table& root) {
    for (const auto& [key, node] : root)
      if (key != "defaults" && key != "panel")
        return fail("batch.key", fmt::format("unknown key '{}'", key.str()), "known: [defaults], [[panel]]",
                    place(node));
    if (root.contains("defaults")) {
      toml::table* table = root["defaults"].as_table();
      if (!table) return wrong("'defaults' must be a table", *root.get("defaults"));
      if (auto taken = take_layers(*table, defaults_); !taken) return tl::make_unexpected(taken.error());
    }
    defaults_.insert(defaults_.end(), common_.begin(), common_.end());
    if (!root.contains("panel")) return Panels{};
    if (!root.get("panel")->is_array_of_tables())
      return wrong("'panel' must be written [[panel]]", *root.get("panel"));
    Panels panels;
    for (toml::node& entry : *root["panel"].as_array()) {
      auto panel = panel_of(*entry.as_table());
      if (!panel) return tl::make_unexpected(panel.error());
      panels.push_back(std::move(*panel));
    }
    return panels;
  }

 private:
  std::string place(const toml::node& node) const { return place_of(path_, node.source().begin.line); }

  Failure wrong(const std::string& message, const toml::node& node) const {
    return fail("batch.key", message, "", place(node));
  }

  /// A text or a list of texts, taken out of the table.
  Result<std::vector<std::string>> take_texts(toml::table& table, const char* key) const {
    std::vector<std::string> texts;
    const toml::node* node = table.get(key);
    if (!node) return texts;
    const std::string message = fmt::format("'{}' must be a text or a list of texts", key);
    if (const auto text = node->value<std::string>()) {
      texts.push_back(*text);
    } else {
      if (!node->is_array()) return wrong(message, *node);
      for (const toml::node& one : *node->as_array()) {
        if (!one.is_string()) return wrong(message, one);
        texts.push_back(*one.value<std::string>());
      }
    }
    table.erase(key);
    return texts;
  }

  /// Its `config` files, then its other keys.
  Result<void> take_layers(toml::table& table, std::vector<Layer>& layers) const {
    const std::string at = place(table);
    const auto configs = take_texts(table, "config");
    if (!configs) return tl::make_unexpected(configs.error());
    for (const std::string& name : *configs) {
      auto layer = layer_of_file(path_.parent_path() / name);
      if (!layer) return tl::make_unexpected(layer.error());
      layers.push_back(std::move(*layer));
    }
    if (table.empty()) return {};
    auto settings = settings_of_table(table, path_);
    if (!settings) return tl::make_unexpected(settings.error());
    if (settings->jobs)
      return fail("batch.option", "jobs cannot be set in a manifest", "use --jobs and --threads", at);
    std::ostringstream text;
    text << table << '\n';
    layers.push_back({text.str(), std::move(*settings), at});
    return {};
  }

  Result<BatchPanel> panel_of(toml::table& table) const {
    const std::string at = place(table);
    const auto inputs = take_texts(table, "input");
    if (!inputs) return tl::make_unexpected(inputs.error());
    if (inputs->size() != 1 || inputs->front().empty())
      return fail("batch.key", "a [[panel]] needs one 'input'", "", at);
    const auto names = take_texts(table, "name");
    if (!names) return tl::make_unexpected(names.error());
    auto options = take_texts(table, "options");
    if (!options) return tl::make_unexpected(options.error());

    BatchPanel panel;
    panel.input = fs::absolute(path_.parent_path() / inputs->front()).lexically_normal();
    panel.name = names->empty() ? safe_name(panel.input.stem().string()) : names->front();
    if (panel.name != safe_name(panel.name))
      return fail("batch.name", fmt::format("'{}' cannot be the name of a folder here", panel.name),
                  "use letters, digits, - and _", at);
    panel.options = std::move(*options);
    std::vector<Layer> layers = defaults_;
    if (auto taken = take_layers(table, layers); !taken) return tl::make_unexpected(taken.error());
    auto more = take_configs(panel.options, path_.parent_path());
    if (!more) return tl::make_unexpected(more.error());
    for (Layer& layer : *more) layers.push_back(std::move(layer));
    if (auto put = put_layers(layers, at, panel); !put) return tl::make_unexpected(put.error());
    if (auto good = check_words(panel, at); !good) return tl::make_unexpected(good.error());
    return panel;
  }

  const fs::path& path_;
  const std::vector<Layer>& common_;
  std::vector<Layer> defaults_;
};

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
  try {
    toml::table root = toml::parse(text);
    return TomlManifest(path, common).run(root);
  } catch (const toml::parse_error& problem) {
    return fail("batch.syntax", std::string(problem.description()), "",
                place_of(path, problem.source().begin.line));
  }
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
