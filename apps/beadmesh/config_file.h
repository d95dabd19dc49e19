// Settings from a TOML file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "settings.h"

namespace beadmesh::app {

/// Keys: preset, size, min_edge, thickness, jobs, unit; [bead] min_aspect_ratio, max_joint_angle, max_loops,
/// min_rise; [design] max_depth_to_width, max_wall_angle, min_crown_radius, min_root_radius,
/// min_bead_distance, min_rim_distance, min_hole_distance; [read] chord, angle, max_facet, sew_tolerance,
/// feature_angle; [mesh.bead], [mesh.bead.I], .generic, .annular size, min_edge, elements_across,
/// elements_along, clamp_rows, method; [[mesh.beads]] the same with id or point; [[mesh.local_size]] point,
/// radius, size. Lengths in mm, angles in degrees. Fails with config.*: no such file, a syntax error, an
/// unknown key or a value of the wrong type, with its line.
Result<SettingsLayer> read_config(const std::filesystem::path& path);

struct ConfigKey {
  std::string table, name, type;
};

/// All keys, table by table, for the reference of options.
std::vector<ConfigKey> config_keys();

/// The bytes of a configuration file. Fails with config.not_found, config.unreadable.
Result<std::string> config_text(const std::filesystem::path& path);

/// The same as read_config, of a text; `source` is what messages name.
Result<SettingsLayer> parse_config(const std::string& text, const std::filesystem::path& source);

}  // namespace beadmesh::app
