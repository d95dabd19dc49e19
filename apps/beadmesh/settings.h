// What the user can set, and the layers it comes from: defaults, configuration file, command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/pipeline.h"
#include "beadmesh/read/panel_reader.h"
#include "beadmesh/write/deck_options.h"

namespace beadmesh::app {

struct Settings {
  MeshSizes sizes;
  BeadOptions beads;
  ReadOptions read;
  DeckOptions deck;
  std::vector<Vec3> kept_edges;  ///< points on edges that rows of nodes follow
  DesignLimits design;           ///< default: none; of --design-check
  int jobs = 0;                  ///< default 0: all cores
};

/// What one layer says; what it leaves out stays as it was.
struct SettingsLayer {
  std::optional<std::string> preset;  ///< crash, nvh, durability
  std::optional<double> size, min_edge, thickness, chordal_deviation;
  std::optional<int> jobs, max_loops;
  std::optional<int> id_offset, first_node, first_element, first_property;
  std::optional<std::string> analysis;  ///< modes, none
  std::optional<std::string> unit, skin;
  std::optional<double> min_aspect_ratio, max_joint_angle, min_rise;            ///< angle in degrees
  std::optional<double> chord, angle, max_facet, sew_tolerance, feature_angle;  ///< angles in degrees
  DesignLimits design;                                                          ///< angle in degrees
  BeadControls controls;
  std::vector<LocalSize> local_sizes;
  std::vector<Vec3> kept_edges;
  std::optional<int> washer_rows, elements_around_holes;
  std::optional<double> washer_width, min_hole_diameter, max_hole_diameter;
};

/// The preset of the layer first, then its values. A size without a minimum edge keeps their ratio. Single
/// beads and local sizes of the layer follow those of earlier layers. An offset of ids is for all of them,
/// the first ids of the layer win. Fails with usage.preset, usage.analysis,
/// usage.skin.
Result<void> apply(const SettingsLayer& layer, Settings& settings);

/// Fails with usage.* and control.* where a value makes no sense, alone or with the others; says which.
Result<void> check(const Settings& settings);

}  // namespace beadmesh::app
