#include "settings.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

namespace beadmesh::app {
namespace {

constexpr BeadKind all_kinds[] = {BeadKind::I, BeadKind::generic, BeadKind::annular};

struct Preset {
  const char* name;
  double size, min_edge;
};

constexpr Preset presets[] = {{"crash", 5, 2.5}, {"nvh", 10, 4}, {"durability", 5, 1.5}};

Result<void> apply_preset(const std::string& name, MeshSizes& sizes) {
  for (const Preset& preset : presets) {
    if (name != preset.name) continue;
    sizes.size = preset.size;
    sizes.min_edge = preset.min_edge;
    return {};
  }
  return fail("usage.preset", fmt::format("unknown preset '{}'", name), "known: crash, nvh, durability");
}

void apply_sizes(const SettingsLayer& layer, MeshSizes& sizes) {
  const double ratio = sizes.size > 0 ? sizes.min_edge / sizes.size : 0.5;
  if (layer.size) sizes.size = *layer.size;
  if (layer.min_edge)
    sizes.min_edge = *layer.min_edge;
  else if (layer.size)
    sizes.min_edge = ratio * *layer.size;
  sizes.thickness = layer.thickness.value_or(sizes.thickness);
  sizes.chordal_deviation = layer.chordal_deviation.value_or(sizes.chordal_deviation);
}

void apply_controls(const SettingsLayer& layer, MeshSizes& sizes) {
  sizes.beads.all = overlaid(sizes.beads.all, layer.controls.all);
  for (const BeadKind kind : all_kinds)
    sizes.beads.of(kind) = overlaid(sizes.beads.of(kind), layer.controls.of(kind));
  const auto append = [](auto& list, const auto& more) { list.insert(list.end(), more.begin(), more.end()); };
  append(sizes.beads.single, layer.controls.single);
  append(sizes.local, layer.local_sizes);
}

Result<void> apply_deck(const SettingsLayer& layer, DeckOptions& deck) {
  if (const auto offset = layer.id_offset) {
    deck.first_node = deck.first_element = deck.first_property = *offset + 1;
    deck.set_offset = *offset;
  }
  deck.first_node = layer.first_node.value_or(deck.first_node);
  deck.first_element = layer.first_element.value_or(deck.first_element);
  deck.first_property = layer.first_property.value_or(deck.first_property);
  if (!layer.analysis) return {};
  if (*layer.analysis != "modes" && *layer.analysis != "none")
    return fail("usage.analysis", fmt::format("unknown analysis '{}'", *layer.analysis),
                "known: modes, none");
  deck.analysis = *layer.analysis == "none" ? DeckAnalysis::none : DeckAnalysis::modes;
  return {};
}

void apply_washers(const SettingsLayer& layer, WasherControl& washers) {
  washers.rows = layer.washer_rows.value_or(washers.rows);
  const auto take = [](auto& target, const auto& value) {
    if (value) target = value;
  };
  take(washers.width, layer.washer_width);
  take(washers.min_diameter, layer.min_hole_diameter);
  take(washers.max_diameter, layer.max_hole_diameter);
  take(washers.elements_around, layer.elements_around_holes);
}

void set(double& target, const std::optional<double>& value, double factor = 1) {
  if (value) target = *value * factor;
}

void apply_design(const DesignLimits& layer, DesignLimits& limits) {
  const auto keep = [](std::optional<double>& target, const std::optional<double>& value, double factor = 1) {
    if (value) target = *value * factor;
  };
  keep(limits.max_depth_to_width, layer.max_depth_to_width);
  keep(limits.max_wall_angle, layer.max_wall_angle, radians(1));
  keep(limits.min_crown_radius, layer.min_crown_radius);
  keep(limits.min_root_radius, layer.min_root_radius);
  keep(limits.min_bead_distance, layer.min_bead_distance);
  keep(limits.min_rim_distance, layer.min_rim_distance);
  keep(limits.min_hole_distance, layer.min_hole_distance);
}

struct Bound {
  const char* code;
  const char* what;
  double value;
  double low, high;  ///< both allowed, unless low is 0 and `open`
  bool open;
};

Result<void> check_bound(const Bound& b) {
  const bool good =
      std::isfinite(b.value) && (b.open ? b.value > b.low : b.value >= b.low) && b.value <= b.high;
  if (good) return {};
  return fail(b.code, fmt::format("the {} is {}", b.what, b.value),
              fmt::format("it must be {} {} and at most {}", b.open ? "above" : "at least", b.low, b.high));
}

Result<void> check_design(const DesignLimits& d) {
  const std::pair<const char*, std::optional<double>> limits[] = {
      {"max_depth_to_width", d.max_depth_to_width}, {"max_wall_angle", d.max_wall_angle},
      {"min_crown_radius", d.min_crown_radius},     {"min_root_radius", d.min_root_radius},
      {"min_bead_distance", d.min_bead_distance},   {"min_rim_distance", d.min_rim_distance},
      {"min_hole_distance", d.min_hole_distance}};
  for (const auto& [name, value] : limits)
    if (value && (!std::isfinite(*value) || *value < 0))
      return fail("usage.design", fmt::format("the limit {} is {}", name, *value), "it must be 0 or more");
  return {};
}

Result<void> check_beads(const MeshSizes& sizes) {
  std::vector<BeadMeshControl> controls{sizes.beads.all};
  for (const BeadKind kind : all_kinds) controls.push_back(sizes.beads.of(kind));
  for (const auto& [selection, control] : sizes.beads.single) controls.push_back(control);
  for (const BeadMeshControl& control : controls)
    if (auto good = check_control(control, sizes.size, sizes.min_edge); !good) return good;
  return {};
}

Result<void> apply_skin(const std::string& name, ReadOptions& read) {
  const auto skin = skin_of(name);
  if (!skin) return tl::make_unexpected(skin.error());
  read.skin = *skin;
  return {};
}

}  // namespace

Result<void> apply(const SettingsLayer& layer, Settings& settings) {
  if (layer.preset)
    if (auto known = apply_preset(*layer.preset, settings.sizes); !known) return known;
  apply_sizes(layer, settings.sizes);
  apply_controls(layer, settings.sizes);
  if (auto known = apply_deck(layer, settings.deck); !known) return known;
  apply_washers(layer, settings.sizes.washers);
  settings.kept_edges.insert(settings.kept_edges.end(), layer.kept_edges.begin(), layer.kept_edges.end());
  settings.jobs = layer.jobs.value_or(settings.jobs);
  settings.read.unit = layer.unit.value_or(settings.read.unit);
  if (layer.skin)
    if (auto known = apply_skin(*layer.skin, settings.read); !known) return known;
  set(settings.beads.min_aspect_ratio, layer.min_aspect_ratio);
  set(settings.beads.max_joint_angle, layer.max_joint_angle, radians(1));
  set(settings.beads.min_rise, layer.min_rise);
  apply_design(layer.design, settings.design);
  settings.beads.max_loops = layer.max_loops.value_or(settings.beads.max_loops);
  set(settings.read.chord, layer.chord);
  set(settings.read.angle, layer.angle, radians(1));
  set(settings.read.max_facet, layer.max_facet);
  set(settings.read.sew_tolerance, layer.sew_tolerance);
  set(settings.read.feature_angle, layer.feature_angle, radians(1));
  return {};
}

Result<void> check(const Settings& s) {
  const Bound bounds[] = {
      {"usage.size", "element size (mm)", s.sizes.size, 0, 1e6, true},
      {"usage.min_edge", "minimum edge length (mm)", s.sizes.min_edge, 0, 1e6, true},
      {"usage.thickness", "thickness (mm)", s.sizes.thickness, 0, 1e6, true},
      {"usage.ids", "first node id", double(s.deck.first_node), 1, 99'999'999, false},
      {"usage.ids", "first element id", double(s.deck.first_element), 1, 99'999'999, false},
      {"usage.ids", "first property id", double(s.deck.first_property), 1, 99'999'999, false},
      {"usage.chordal_deviation", "chordal deviation (mm)", s.sizes.chordal_deviation, 0, 1e6, false},
      {"usage.jobs", "number of jobs", static_cast<double>(s.jobs), 0, 1024, false},
      {"usage.min_aspect_ratio", "least aspect ratio of a bead", s.beads.min_aspect_ratio, 0, 1e6, false},
      {"usage.max_joint_angle", "largest joint angle (degrees)", degrees(s.beads.max_joint_angle), 0, 180,
       false},
      {"usage.max_loops", "most loops of a bead", static_cast<double>(s.beads.max_loops), 1, 1e6, false},
      {"usage.min_rise", "least rise of a bead", s.beads.min_rise, 0, 1e6, false},
      {"usage.chord", "chord error of the facets (mm)", s.read.chord, 0, 1e6, true},
      {"usage.angle", "angle of the facets (degrees)", degrees(s.read.angle), 0, 90, true},
      {"usage.max_facet", "longest facet edge (mm)", s.read.max_facet, 0, 1e6, false},
      {"usage.sew_tolerance", "tolerance of sewing (mm)", s.read.sew_tolerance, 0, 1e6, false},
      {"usage.feature_angle", "feature angle (degrees)", degrees(s.read.feature_angle), 0, 180, false},
  };
  for (const Bound& bound : bounds)
    if (auto good = check_bound(bound); !good) return good;
  if (s.sizes.min_edge > s.sizes.size)
    return fail("usage.min_edge",
                fmt::format("the minimum edge length {} mm is above the element size {} mm", s.sizes.min_edge,
                            s.sizes.size),
                "half the size is usual");
  if (auto good = check_washers(s.sizes.washers); !good) return good;
  if (auto good = check_local_sizes(s.sizes.local, s.sizes.min_edge); !good) return good;
  if (auto good = check_design(s.design); !good) return good;
  return check_beads(s.sizes);
}

}  // namespace beadmesh::app
