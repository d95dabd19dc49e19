#include "config_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config_table.h"

namespace beadmesh::app {
namespace {

/// Puts the value of a key into its target; false where the type is wrong.
template <class Target>
struct Key {
  const char* name;
  const char* type;
  std::function<bool(const toml::node&, Target&)> read;
};

template <class Target>
using Keys = std::vector<Key<Target>>;

template <class Target>
Key<Target> number_key(const char* name, std::optional<double> Target::*member) {
  return {name, "a number", [member](const toml::node& node, Target& target) {
            if (!node.is_number()) return false;
            target.*member = node.value<double>();
            return true;
          }};
}

template <class Target>
Key<Target> count_key(const char* name, std::optional<int> Target::*member) {
  return {name, "a whole number", [member](const toml::node& node, Target& target) {
            target.*member = node.is_integer() ? node.value<std::int32_t>() : std::nullopt;
            return (target.*member).has_value();
          }};
}

Key<SettingsLayer> text_key(const char* name, std::optional<std::string> SettingsLayer::*member) {
  return {name, "a text", [member](const toml::node& node, SettingsLayer& layer) {
            if (!node.is_string()) return false;
            layer.*member = node.value<std::string>();
            return true;
          }};
}

Keys<SettingsLayer> main_keys() {
  return {text_key("preset", &SettingsLayer::preset),
          number_key("size", &SettingsLayer::size),
          number_key("min_edge", &SettingsLayer::min_edge),
          number_key("thickness", &SettingsLayer::thickness),
          number_key("chordal_deviation", &SettingsLayer::chordal_deviation),
          count_key("jobs", &SettingsLayer::jobs),
          text_key("unit", &SettingsLayer::unit)};
}

Keys<SettingsLayer> bead_keys() {
  return {number_key("min_aspect_ratio", &SettingsLayer::min_aspect_ratio),
          number_key("max_joint_angle", &SettingsLayer::max_joint_angle),
          count_key("max_loops", &SettingsLayer::max_loops),
          number_key("min_rise", &SettingsLayer::min_rise)};
}

Keys<SettingsLayer> read_keys() {
  return {number_key("chord", &SettingsLayer::chord),
          number_key("angle", &SettingsLayer::angle),
          number_key("max_facet", &SettingsLayer::max_facet),
          number_key("sew_tolerance", &SettingsLayer::sew_tolerance),
          text_key("skin", &SettingsLayer::skin),
          number_key("feature_angle", &SettingsLayer::feature_angle)};
}

Keys<SettingsLayer> deck_keys() {
  return {count_key("id_offset", &SettingsLayer::id_offset),
          count_key("first_node", &SettingsLayer::first_node),
          count_key("first_element", &SettingsLayer::first_element),
          count_key("first_property", &SettingsLayer::first_property),
          text_key("analysis", &SettingsLayer::analysis)};
}

Keys<DesignLimits> design_keys() {
  return {number_key("max_depth_to_width", &DesignLimits::max_depth_to_width),
          number_key("max_wall_angle", &DesignLimits::max_wall_angle),
          number_key("min_crown_radius", &DesignLimits::min_crown_radius),
          number_key("min_root_radius", &DesignLimits::min_root_radius),
          number_key("min_bead_distance", &DesignLimits::min_bead_distance),
          number_key("min_rim_distance", &DesignLimits::min_rim_distance),
          number_key("min_hole_distance", &DesignLimits::min_hole_distance)};
}

Keys<SettingsLayer> hole_keys() {
  return {count_key("rows", &SettingsLayer::washer_rows), number_key("width", &SettingsLayer::washer_width),
          number_key("min_diameter", &SettingsLayer::min_hole_diameter),
          number_key("max_diameter", &SettingsLayer::max_hole_diameter),
          count_key("elements_around", &SettingsLayer::elements_around_holes)};
}

Key<BeadMeshControl> method_key() {
  return {"method", "automatic, blocks, ridge or face", [](const toml::node& node, BeadMeshControl& control) {
            control.method = bead_method_of(node.value<std::string>().value_or(""));
            return control.method.has_value();
          }};
}

Keys<BeadMeshControl> control_keys() {
  return {number_key("size", &BeadMeshControl::size),
          number_key("min_edge", &BeadMeshControl::min_edge),
          count_key("elements_across", &BeadMeshControl::elements_across),
          count_key("elements_along", &BeadMeshControl::elements_along),
          count_key("clamp_rows", &BeadMeshControl::clamp_rows),
          method_key()};
}

bool read_point(const toml::node& node, Vec3& point) {
  const toml::array* list = node.as_array();
  if (!list || list->size() != 3) return false;
  for (const toml::node& one : *list)
    if (!one.is_number()) return false;
  point = {*(*list)[0].value<double>(), *(*list)[1].value<double>(), *(*list)[2].value<double>()};
  return true;
}

Keys<SettingsLayer> mesh_keys() {
  return {{"keep_edges", "[[x, y, z], ...]", [](const toml::node& node, SettingsLayer& layer) {
             const toml::array* list = node.as_array();
             if (!list) return false;
             for (const toml::node& one : *list)
               if (!read_point(one, layer.kept_edges.emplace_back())) return false;
             return true;
           }}};
}

/// An entry of [[mesh.beads]].
struct SingleBead {
  std::optional<int> id;
  std::optional<Vec3> point;
  BeadMeshControl control;
};

Keys<SingleBead> single_keys() {
  Keys<SingleBead> keys{count_key("id", &SingleBead::id),
                        {"point", "[x, y, z]", [](const toml::node& node, SingleBead& bead) {
                           return read_point(node, bead.point.emplace());
                         }}};
  for (const Key<BeadMeshControl>& key : control_keys())
    keys.push_back({key.name, key.type, [read = key.read](const toml::node& node, SingleBead& bead) {
                      return read(node, bead.control);
                    }});
  return keys;
}

/// An entry of [[mesh.local_size]].
struct LocalSizeEntry {
  std::optional<Vec3> point;
  std::optional<double> radius, size;
};

Keys<LocalSizeEntry> local_size_keys() {
  return {
      {"point", "[x, y, z]",
       [](const toml::node& node, LocalSizeEntry& entry) { return read_point(node, entry.point.emplace()); }},
      number_key("radius", &LocalSizeEntry::radius),
      number_key("size", &LocalSizeEntry::size)};
}

/// A table that lies in another one.
struct Inner {
  const char* name;
  std::function<Result<void>(const toml::node&)> read;
};

/// Reads one file into one layer.
class ConfigReader {
 public:
  explicit ConfigReader(const std::filesystem::path& path) : path_(path) {}

  Result<SettingsLayer> run(const toml::table& root) {
    auto done = read_table(root, "", main_keys(), layer_,
                           {{"bead", table_of("bead.", bead_keys(), layer_)},
                            {"design", table_of("design.", design_keys(), layer_.design)},
                            {"read", table_of("read.", read_keys(), layer_)},
                            {"deck", table_of("deck.", deck_keys(), layer_)},
                            {"mesh", [this](const toml::node& node) { return read_mesh(node); }}});
    if (!done) return tl::make_unexpected(done.error());
    return std::move(layer_);
  }

 private:
  std::string place(const toml::node& node) const {
    return fmt::format("{}:{}", path_.string(), node.source().begin.line);
  }

  Failure wrong_type(const std::string& name, const char* type, const toml::node& node) const {
    return fail("config.type", fmt::format("'{}' must be {}", name, type), "", place(node));
  }

  template <class Target>
  std::function<Result<void>(const toml::node&)> table_of(std::string prefix, Keys<Target> keys,
                                                          Target& target) {
    return [this, prefix, keys, &target](const toml::node& node) -> Result<void> {
      return read_table(node, prefix, keys, target, {});
    };
  }

  template <class Target>
  Result<void> read_table(const toml::node& table, const std::string& prefix, const Keys<Target>& keys,
                          Target& target, const std::vector<Inner>& inner) {
    if (!table.is_table()) return wrong_type(prefix.substr(0, prefix.size() - 1), "a table", table);
    for (const auto& [name, node] : *table.as_table()) {
      const std::string_view word = name.str();
      const std::string full = fmt::format("{}{}", prefix, word);
      const auto sub =
          std::find_if(inner.begin(), inner.end(), [&](const Inner& one) { return word == one.name; });
      if (sub != inner.end()) {
        if (auto done = sub->read(node); !done) return done;
        continue;
      }
      const auto key = std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return word == k.name; });
      if (key == keys.end())
        return fail("config.key", fmt::format("unknown key '{}'", full), known_names(keys, prefix, inner),
                    place(node));
      if (!key->read(node, target)) return wrong_type(full, key->type, node);
    }
    return {};
  }

  template <class Target>
  static std::string known_names(const Keys<Target>& keys, const std::string& prefix,
                                 const std::vector<Inner>& inner) {
    std::string names;
    for (const auto& key : keys) names += (names.empty() ? "" : ", ") + std::string(key.name);
    for (const Inner& one : inner)
      names += fmt::format("{}[{}{}]", names.empty() ? "" : ", ", prefix, one.name);
    return "known: " + names;
  }

  Result<void> read_mesh(const toml::node& node) {
    return read_table<SettingsLayer>(
        node, "mesh.", mesh_keys(), layer_,
        {{"bead", [this](const toml::node& one) { return read_mesh_bead(one); }},
         {"holes", table_of("mesh.holes.", hole_keys(), layer_)},
         {"beads",
          [this](const toml::node& one) { return read_list(one, "mesh.beads", &ConfigReader::add_bead); }},
         {"local_size", [this](const toml::node& one) {
            return read_list(one, "mesh.local_size", &ConfigReader::add_size);
          }}});
  }

  Result<void> read_mesh_bead(const toml::node& node) {
    BeadControls& controls = layer_.controls;
    std::vector<Inner> kinds;
    for (const auto& [kind, name] : {std::pair{BeadKind::I, "I"}, std::pair{BeadKind::generic, "generic"},
                                     std::pair{BeadKind::annular, "annular"}})
      kinds.push_back(
          {name, table_of(fmt::format("mesh.bead.{}.", name), control_keys(), controls.of(kind))});
    return read_table(node, "mesh.bead.", control_keys(), controls.all, kinds);
  }

  Result<void> read_list(const toml::node& node, const char* name,
                         Result<void> (ConfigReader::*add)(const toml::node&)) {
    if (!node.is_array_of_tables())
      return wrong_type(name, fmt::format("written [[{}]]", name).c_str(), node);
    for (const toml::node& one : *node.as_array())
      if (auto done = (this->*add)(one); !done) return done;
    return {};
  }

  Result<void> add_bead(const toml::node& node) {
    SingleBead bead;
    if (auto done = read_table(node, "mesh.beads.", single_keys(), bead, {}); !done) return done;
    if (bead.id.has_value() == bead.point.has_value() || bead.id.value_or(1) < 1)
      return fail("config.bead", "an entry of [[mesh.beads]] needs an id from 1 on, or a point", "",
                  place(node));
    layer_.controls.single.push_back({{bead.id.value_or(0), bead.point.value_or(Vec3{})}, bead.control});
    return {};
  }

  Result<void> add_size(const toml::node& node) {
    LocalSizeEntry entry;
    if (auto done = read_table(node, "mesh.local_size.", local_size_keys(), entry, {}); !done) return done;
    if (!entry.point || !entry.radius || !entry.size)
      return fail("config.local_size", "an entry of [[mesh.local_size]] needs point, radius and size", "",
                  place(node));
    layer_.local_sizes.push_back({*entry.point, *entry.radius, *entry.size});
    return {};
  }

  const std::filesystem::path& path_;
  SettingsLayer layer_;
};

}  // namespace

std::vector<ConfigKey> config_keys() {
  std::vector<ConfigKey> all;
  const auto add = [&](const char* table, const auto& keys) {
    for (const auto& key : keys) all.push_back({table, key.name, key.type});
  };
  add("", main_keys());
  add("[bead]", bead_keys());
  add("[read]", read_keys());
  add("[deck]", deck_keys());
  add("[design]", design_keys());
  add("[mesh]", mesh_keys());
  add("[mesh.holes]", hole_keys());
  add("[mesh.bead], [mesh.bead.I], .generic, .annular", control_keys());
  add("[[mesh.beads]]", single_keys());
  add("[[mesh.local_size]]", local_size_keys());
  return all;
}

Result<std::string> config_text(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return fail("config.not_found", "there is no such configuration file", "", path.string());
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) return fail("config.unreadable", "the configuration file cannot be read", "", path.string());
  return text;
}

Result<SettingsLayer> settings_of_table(const toml::table& table, const std::filesystem::path& source) {
  return ConfigReader(source).run(table);
}

Result<SettingsLayer> parse_config(const std::string& text, const std::filesystem::path& source) {
  try {
    return settings_of_table(toml::parse(text), source);
  } catch (const toml::parse_error& problem) {
    return fail("config.syntax", std::string(problem.description()), "",
                fmt::format("{}:{}", source.string(), problem.source().begin.line));
  }
}

Result<SettingsLayer> read_config(const std::filesystem::path& path) {
  const auto text = config_text(path);
  if (!text) return tl::make_unexpected(text.error());
  return parse_config(*text, path);
}

}  // namespace beadmesh::app
