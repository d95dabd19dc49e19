#include "batch/panel_entry.h"

#include <fmt/format.h>

#include <cctype>

#include "config_file.h"
#include "options.h"

namespace beadmesh::app {
namespace {

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

}  // namespace

std::string place_of(const std::filesystem::path& path, size_t line) {
  return fmt::format("{}:{}", path.string(), line);
}

Result<Layer> layer_of_file(const std::filesystem::path& path) {
  auto text = config_text(path);
  if (!text) return tl::make_unexpected(text.error());
  auto settings = parse_config(*text, path);
  if (!settings) return tl::make_unexpected(settings.error());
  return Layer{std::move(*text), std::move(*settings), path.string()};
}

std::string safe_name(const std::string& text) {
  constexpr size_t longest = 180;
  std::string name;
  for (const char c : text.substr(0, longest)) {
    const auto u = static_cast<unsigned char>(c);
    name += std::isalnum(u) || u >= 0x80 || (c == '.' && !name.empty()) || c == '-' ? c : '_';
  }
  if (name == "state") return "state_";  // its table would be called as the state of the panel
  return name.empty() ? "panel" : name;
}

Result<std::vector<Layer>> take_configs(std::vector<std::string>& words,
                                        const std::filesystem::path& folder) {
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

Result<void> complete(BatchPanel& panel, const std::vector<Layer>& layers, const std::string& place) {
  if (auto put = put_layers(layers, place, panel); !put) return put;
  return check_words(panel, place);
}

}  // namespace beadmesh::app
