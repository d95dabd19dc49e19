// Manifests in TOML.
#include <fmt/format.h>

#include <filesystem>
#include <sstream>

#include "batch/panel_entry.h"
#include "config_table.h"

namespace beadmesh::app {
namespace {

namespace fs = std::filesystem;
using Panels = std::vector<BatchPanel>;

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
    if (auto put = complete(panel, layers, at); !put) return tl::make_unexpected(put.error());
    return panel;
  }

  const fs::path& path_;
  const std::vector<Layer>& common_;
  std::vector<Layer> defaults_;
};

}  // namespace

Result<Panels> panels_of_toml(const std::string& text, const fs::path& path,
                              const std::vector<Layer>& common) {
  try {
    toml::table root = toml::parse(text);
    return TomlManifest(path, common).run(root);
  } catch (const toml::parse_error& problem) {
    return fail("batch.syntax", std::string(problem.description()), "",
                place_of(path, problem.source().begin.line));
  }
}

}  // namespace beadmesh::app
