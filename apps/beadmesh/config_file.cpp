#include "config_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace beadmesh::app {
namespace {

/// Puts the value of a key into the layer; false where the type is wrong.
struct Key {
  const char* name;
  const char* type;
  std::function<bool(const toml::node&, SettingsLayer&)> read;
};

Key number_key(const char* name, std::optional<double> SettingsLayer::*member) {
  return {name, "a number", [member](const toml::node& node, SettingsLayer& layer) {
            if (!node.is_number()) return false;
            layer.*member = node.value<double>();
            return true;
          }};
}

Key text_key(const char* name, std::optional<std::string> SettingsLayer::*member) {
  return {name, "a text", [member](const toml::node& node, SettingsLayer& layer) {
            if (!node.is_string()) return false;
            layer.*member = node.value<std::string>();
            return true;
          }};
}

Key jobs_key() {
  return {"jobs", "a whole number", [](const toml::node& node, SettingsLayer& layer) {
            const auto value = node.is_integer() ? node.value<std::int32_t>() : std::nullopt;
            layer.jobs = value;
            return value.has_value();
          }};
}

using Keys = std::vector<Key>;

Keys main_keys() {
  return {text_key("preset", &SettingsLayer::preset),
          number_key("size", &SettingsLayer::size),
          number_key("min_edge", &SettingsLayer::min_edge),
          number_key("thickness", &SettingsLayer::thickness),
          jobs_key(),
          text_key("unit", &SettingsLayer::unit)};
}

Keys bead_keys() {
  return {number_key("min_aspect_ratio", &SettingsLayer::min_aspect_ratio),
          number_key("max_joint_angle", &SettingsLayer::max_joint_angle),
          number_key("min_rise", &SettingsLayer::min_rise)};
}

Keys read_keys() {
  return {number_key("chord", &SettingsLayer::chord), number_key("angle", &SettingsLayer::angle),
          number_key("max_facet", &SettingsLayer::max_facet),
          number_key("sew_tolerance", &SettingsLayer::sew_tolerance),
          number_key("feature_angle", &SettingsLayer::feature_angle)};
}

std::string place(const std::filesystem::path& path, const toml::source_region& source) {
  return fmt::format("{}:{}", path.string(), source.begin.line);
}

std::string known_names(const Keys& keys) {
  std::string names;
  for (const Key& key : keys) names += (names.empty() ? "" : ", ") + std::string(key.name);
  return names;
}

Result<void> read_table(const toml::table& table, std::string_view prefix, const Keys& keys,
                        std::string_view more, const std::filesystem::path& path, SettingsLayer& layer) {
  for (const auto& [name, node] : table) {
    if (node.is_table() && prefix.empty() && (name.str() == "bead" || name.str() == "read")) continue;
    const auto key =
        std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return name.str() == k.name; });
    const std::string full = fmt::format("{}{}", prefix, name.str());
    if (key == keys.end())
      return fail("config.key", fmt::format("unknown key '{}'", full),
                  fmt::format("known: {}{}", known_names(keys), more), place(path, node.source()));
    if (!key->read(node, layer))
      return fail("config.type", fmt::format("'{}' must be {}", full, key->type), "",
                  place(path, node.source()));
  }
  return {};
}

Result<SettingsLayer> layer_of(const toml::table& root, const std::filesystem::path& path) {
  SettingsLayer layer;
  if (auto done = read_table(root, "", main_keys(), ", [bead], [read]", path, layer); !done)
    return tl::make_unexpected(done.error());
  if (const toml::table* bead = root["bead"].as_table())
    if (auto done = read_table(*bead, "bead.", bead_keys(), "", path, layer); !done)
      return tl::make_unexpected(done.error());
  if (const toml::table* read = root["read"].as_table())
    if (auto done = read_table(*read, "read.", read_keys(), "", path, layer); !done)
      return tl::make_unexpected(done.error());
  return layer;
}

}  // namespace

Result<SettingsLayer> read_config(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return fail("config.not_found", "there is no such configuration file", "", path.string());
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) return fail("config.unreadable", "the configuration file cannot be read", "", path.string());
  try {
    return layer_of(toml::parse(text), path);
  } catch (const toml::parse_error& problem) {
    return fail("config.syntax", std::string(problem.description()), "", place(path, problem.source()));
  }
}

}  // namespace beadmesh::app
