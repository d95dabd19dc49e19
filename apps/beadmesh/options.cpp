#include "options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>

#include "beadmesh/write/deck.h"
#include "config_file.h"
#include "control_text.h"
#include "options_page.h"
#include "usage_failure.h"
#include "version_text.h"

namespace beadmesh::app {
namespace {

/// What CLI11 fills in, before it is checked.
struct RawOptions {
  std::string input, face = "all", method, criteria;
  std::vector<std::string> configs, beads, local_sizes, kept_edges;
  BatchOptions batch;
  OutputNames outputs;
  bool feet = false, timings = false, design_check = false;
  SettingsLayer flags;
};

void add_unit(CLI::App& verb, RawOptions& raw) {
  verb.add_option("--unit", raw.flags.unit,
                  "unit of inputs that carry none: mm, cm, m, um, in, ft (default mm)");
}

void add_config(CLI::App& verb, RawOptions& raw) {
  verb.add_option("--config", raw.configs,
                  "settings from a TOML file; options given here win; may be repeated, later files win")
      ->allow_extra_args(false);
}

void add_reading(CLI::App& verb, RawOptions& raw) {
  verb.add_option("--skin", raw.flags.skin,
                  "what a thin solid becomes: outer, inner, middle, whole (default outer)");
  verb.add_option("--gap", raw.flags.sew_tolerance, "free edges closer than this are one, mm (default 0.01)");
}

void add_common(CLI::App& verb, RawOptions& raw) {
  verb.add_option("PANEL", raw.input, "panel: .step .stp .iges .igs .brep .stl")->required();
  verb.add_option("--json", raw.outputs.json, "bead table as JSON; - for standard output");
  add_config(verb, raw);
  verb.add_option("--jobs", raw.flags.jobs, "threads (default: all cores)");
  verb.add_flag("--timings", raw.timings, "print the time of each stage and the memory on standard error");
  add_unit(verb, raw);
  add_reading(verb, raw);
}

void add_controls(CLI::App& verb, RawOptions& raw) {
  BeadMeshControl& all = raw.flags.controls.all;
  verb.add_option("--elements-across", all.elements_across, "elements across beads: even, or 1");
  verb.add_option("--elements-along", all.elements_along,
                  "elements along the strip of every arm; around a ring");
  verb.add_option("--clamp-rows", all.clamp_rows, "rows of elements in the ends of beads");
  verb.add_option("--method", raw.method, "automatic (default), blocks, ridge or face");
  verb.add_option("--bead", raw.beads,
                  "one bead: id=N or at=X:Y:Z, then size, min-edge, across, along, rows, method, as in\n"
                  "id=3,across=6,size=4; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--keep-edge", raw.kept_edges,
                  "rows of nodes follow the edge at X:Y:Z, though it is smooth; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--washer-rows", raw.flags.washer_rows, "rings of quads around holes (default 1; 0: none)");
  verb.add_option("--washer-width", raw.flags.washer_width,
                  "width of a ring, mm (default: the element size)");
  verb.add_option("--local-size", raw.local_sizes,
                  "element size in a ball: at=X:Y:Z,radius=R,size=S; may be repeated")
      ->allow_extra_args(false);
}

void add_deck(CLI::App& verb, RawOptions& raw) {
  verb.add_option("--thickness", raw.flags.thickness, "sheet thickness in the properties, mm (default 1)");
  verb.add_option(
      "--analysis", raw.flags.analysis,
      "what the deck makes the solver do: modes (default; runs as it is), or none (to be included\n"
      "in another deck)");
  verb.add_option("--id-offset", raw.flags.id_offset,
                  "added to the ids of nodes, elements, properties and sets (default 0)");
  verb.add_option("--first-node", raw.flags.first_node, "id of the first node (default 1)");
  verb.add_option("--first-element", raw.flags.first_element, "id of the first element (default 1)");
  verb.add_option("--first-property", raw.flags.first_property, "id of the first property (default 1)");
}

void add_debug(CLI::App& verb, RawOptions& raw) {
  verb.add_option("--debug-svg", raw.outputs.debug_svg,
                  "picture of how CAD faces were grouped, and why: .svg");
}

void add_design_check(CLI::App& verb, RawOptions& raw) {
  verb.add_flag("--design-check", raw.design_check,
                "measure depth to width, wall angle, radii and distances; judge them by [design] of the\n"
                "settings");
}

void add_mesh(CLI::App& app, RawOptions& raw) {
  CLI::App& verb =
      *app.add_subcommand("mesh", "mesh a panel: recognised beads on purpose, the rest around them");
  add_common(verb, raw);
  verb.add_option("-o,--output", raw.outputs.deck, "mesh: " + deck_endings())->required();
  verb.add_option("--size", raw.flags.size, "element size, mm (default 5)");
  verb.add_option("--min-edge", raw.flags.min_edge, "minimum element length, mm (default: half the size)");
  verb.add_option("--preset", raw.flags.preset,
                  "crash (5 / 2.5 mm), nvh (10 / 4 mm), durability (5 / 1.5 mm)");
  verb.add_option("--chordal-deviation", raw.flags.chordal_deviation,
                  "edges off beads get shorter where their sagitta would pass it, mm (default: no limit)");
  verb.add_option("--criteria", raw.criteria, "limits from a criteria file to judge the mesh by; see check");
  add_controls(verb, raw);
  add_deck(verb, raw);
  verb.add_option("--report", raw.outputs.report, "report in 3-D: .html, or only a flat picture: .svg");
  add_debug(verb, raw);
  add_design_check(verb, raw);
  verb.add_option("--csv", raw.outputs.csv, "bead table as CSV; - for standard output");
}

void add_beads(CLI::App& app, RawOptions& raw) {
  CLI::App& verb = *app.add_subcommand("beads", "recognise the beads of a panel: their table");
  add_common(verb, raw);
  verb.add_option("--report", raw.outputs.report, "report: .html, the beads on the surface");
  add_debug(verb, raw);
  add_design_check(verb, raw);
  verb.add_option("--csv", raw.outputs.csv, "bead table as CSV; - for standard output");
}

void add_medial(CLI::App& app, RawOptions& raw) {
  CLI::App& verb = *app.add_subcommand("medial", "the medial object of faces or of a plane polygon");
  verb.add_option("INPUT", raw.input, "panel, or plane polygon: .wkt .poly")->required();
  verb.add_option("--face", raw.face, "number of the face, or all (default all)");
  verb.add_option("--json", raw.outputs.json, "medial object as JSON; - for standard output");
  verb.add_option("--svg", raw.outputs.svg, "picture: .svg");
  verb.add_flag("--feet", raw.feet, "show lines from the axis to its touching points in the picture");
  add_config(verb, raw);
  verb.add_option("--jobs", raw.flags.jobs, "threads (default: all cores)");
  add_unit(verb, raw);
}

void add_check(CLI::App& app, RawOptions& raw) {
  CLI::App& verb = *app.add_subcommand("check", "quality of a mesh file");
  verb.add_option("MESH", raw.input, "mesh: .bdf .nas .dat (Nastran)")->required();
  verb.add_option("--size", raw.flags.size, "element size it was made for, mm");
  verb.add_option("--min-edge", raw.flags.min_edge, "minimum element length, mm: shorter edges are counted");
  verb.add_option("--preset", raw.flags.preset, "limits of crash, nvh or durability");
  verb.add_option("--criteria", raw.criteria,
                  "limits from a criteria file: id, name, on, weight, ideal, good, warn,\n"
                  "fail, worst")
      ->excludes("--preset");
  verb.add_option("--save-criteria", raw.outputs.criteria, "the limits as a criteria file");
  verb.add_option("--repair", raw.outputs.repaired,
                  "the deck again, nodes moved so that fewer elements fail; needs limits");
  verb.add_option("--json", raw.outputs.json, "figures as JSON; - for standard output");
}

/// CLI11 takes an empty text for a value that was not given.
void refuse_empty_values(CLI::App& app) {
  for (CLI::App* verb : app.get_subcommands({}))
    for (CLI::Option* option : verb->get_options())
      option->check([](const std::string& text) { return text.empty() ? "is empty" : ""; });
}

Result<Index> face_number(const std::string& text) {
  if (text == "all") return 0;
  Index number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1)
    return fail("usage.face", fmt::format("'{}' is no face", text), "give a number from 1, or all");
  return number;
}

/// What CLI11 leaves as text.
Result<void> read_texts(const RawOptions& raw, SettingsLayer& flags) {
  if (!raw.method.empty()) {
    flags.controls.all.method = bead_method_of(raw.method);
    if (!flags.controls.all.method)
      return fail("usage.method", fmt::format("unknown method '{}'", raw.method), known_methods);
  }
  for (const std::string& text : raw.beads) {
    auto bead = single_bead_of(text);
    if (!bead) return tl::make_unexpected(bead.error());
    flags.controls.single.push_back(*bead);
  }
  for (const std::string& text : raw.local_sizes) {
    auto size = local_size_of(text);
    if (!size) return tl::make_unexpected(size.error());
    flags.local_sizes.push_back(*size);
  }
  for (const std::string& text : raw.kept_edges) {
    auto point = kept_edge_of(text);
    if (!point) return tl::make_unexpected(point.error());
    flags.kept_edges.push_back(*point);
  }
  return {};
}

Result<Settings> settings_of(Verb verb, const RawOptions& raw) {
  Settings settings;
  for (const std::string& name : raw.configs) {
    const auto layer = read_config(name);
    if (!layer) return tl::make_unexpected(layer.error());
    if (auto done = apply(*layer, settings); !done) return tl::make_unexpected(done.error());
  }
  SettingsLayer flags = raw.flags;
  if (auto done = read_texts(raw, flags); !done) return tl::make_unexpected(done.error());
  if (verb == Verb::check && flags.min_edge && !flags.size)
    flags.size = flags.min_edge;  // not a contradiction there
  if (auto done = apply(flags, settings); !done) return tl::make_unexpected(done.error());
  if (auto good = check(settings); !good) return tl::make_unexpected(good.error());
  return settings;
}

Result<Options> options_of(const CLI::App& app, const RawOptions& raw) {
  Options options;
  for (const auto& [name, verb] : {std::pair{"mesh", Verb::mesh}, std::pair{"beads", Verb::beads},
                                   std::pair{"medial", Verb::medial}, std::pair{"check", Verb::check},
                                   std::pair{"batch", Verb::batch}, std::pair{"options", Verb::options}})
    if (app.got_subcommand(name)) options.verb = verb;
  options.batch = raw.batch;
  if (options.verb == Verb::batch || options.verb == Verb::options) return options;
  options.input = raw.input;
  options.outputs = raw.outputs;
  options.feet = raw.feet;
  options.design_check = raw.design_check;
  options.timings = raw.timings;
  options.has_size = raw.flags.size.has_value();
  options.has_min_edge = raw.flags.min_edge.has_value();
  options.criteria = raw.criteria;
  options.preset = raw.flags.preset.value_or("");
  const auto face = face_number(raw.face);
  if (!face) return tl::make_unexpected(face.error());
  options.face = *face;
  auto settings = settings_of(options.verb, raw);
  if (!settings) return tl::make_unexpected(settings.error());
  options.settings = std::move(*settings);
  return options;
}

void describe(CLI::App& app, RawOptions& raw) {
  app.name("beadmesh");
  app.description("Meshes sheet-metal panels with their beads recognised and meshed on purpose.");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer(
      "Begin with: beadmesh mesh panel.step -o panel.bdf --report panel.html\n\n"
      "Exit status: 0 done; 1 done, but something fell short and is named; 2 wrong usage or unreadable "
      "input,\n"
      "nothing written; 3 internal error. 'beadmesh VERB --help' lists the options of a verb.");
  add_mesh(app, raw);
  add_beads(app, raw);
  add_medial(app, raw);
  add_check(app, raw);
  add_batch(app, raw.batch);
  app.add_subcommand("options", "this reference of all options")->group("");
  refuse_empty_values(app);
}

}  // namespace

std::string options_page() {
  CLI::App app;
  RawOptions raw;
  describe(app, raw);
  return page_of(app);
}

Result<std::optional<Options>> parse_command_line(int argc, const char* const* argv) {
  CLI::App app;
  RawOptions raw;
  describe(app, raw);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    app.exit(request, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& problem) {
    return usage_failure(app, argc, argv, problem);
  }
  auto options = options_of(app, raw);
  if (!options) return tl::make_unexpected(options.error());
  return std::optional<Options>(std::move(*options));
}

}  // namespace beadmesh::app
