// make_example_panel: writes an example panel and what is true of it, or one of the broken inputs that tests
// use.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "examples/example_panels.h"
#include "examples/filleted_panel.h"
#include "examples/kernel_panel.h"
#include "examples/shape_catalogue.h"
#include "examples/shape_panels.h"
#include "examples/step_file.h"
#include "examples/truth.h"

namespace {

using namespace beadmesh::examples;

struct FileMaker {
  std::string name;
  bool (*write)(const std::filesystem::path&);
};
const std::vector<FileMaker> file_makers{{"filleted", write_filleted_panel},
                                         {"bow-tie", write_bow_tie},
                                         {"figure-of-eight", write_figure_of_eight},
                                         {"no-faces", write_lone_edge}};

const std::map<std::string, BaseKind> base_kinds{{"flat", BaseKind::flat},
                                                 {"cylinder", BaseKind::cylinder},
                                                 {"double", BaseKind::double_curved},
                                                 {"saddle", BaseKind::saddle}};

struct Request {
  std::string name, step, truth, base;
  ShapePanelOptions shapes;
  RandomPanelOptions random;
  bool walls = false, kernel = false;
};

std::string names() {
  std::string all;
  for (const std::string& name : example_names()) all += " " + name;
  for (const FileMaker& input : file_makers) all += " " + input.name;
  return all + " shapes random";
}

std::string shape_names() {
  std::string all;
  for (const CatalogueShape& shape : shape_catalogue()) all += (all.empty() ? "" : ", ") + shape.name;
  return all;
}

void add_options(CLI::App& app, Request& request) {
  app.add_option("name", request.name, "what to make:" + names())->required();
  app.add_option("step", request.step, "STEP file to write")->required();
  app.add_option("truth", request.truth, "JSON of what is true of it");
  app.add_option("--width", request.shapes.width, "shapes: width of every bead, mm (16)")
      ->check(CLI::Range(1.0, 500.0));
  app.add_option("--height", request.shapes.height, "shapes: height, mm, negative downwards (5)");
  app.add_option("--base", request.base, "shapes (flat), random (by chance): flat, cylinder, double, saddle")
      ->check(CLI::IsMember(base_kinds));
  app.add_option("--radius", request.shapes.radius, "shapes: of the base, mm (1.6 times the sheet)")
      ->check(CLI::PositiveNumber);
  app.add_option("--only", request.shapes.only, "shapes: " + shape_names())->delimiter(',');
  app.add_option("--beads", request.random.beads, "random: how many (20)")->check(CLI::Range(0, 1000));
  app.add_option("--length", request.random.length, "random: of the sheet, mm (by chance)")
      ->check(CLI::Range(80.0, 10000.0));
  app.add_option("--breadth", request.random.width, "random: of the sheet, mm (by chance)")
      ->check(CLI::Range(80.0, 10000.0));
  app.add_flag("--walls", request.walls,
               "beads of many faces: root fillets, walls and top fillets by chance");
  app.add_flag("--kernel", request.kernel,
               "flat, with vertical walls and fillets of the CAD kernel, radii by chance");
  app.add_option("--seed", request.random.seed, "shapes: turns and stretches (0: none); random: the mix (1)");
}

std::optional<PanelDesign> bare_design(Request& request) {
  if (request.name == "random") {
    if (!request.base.empty()) request.random.base = base_kinds.at(request.base);
    return random_panel(request.random);
  }
  if (request.name != "shapes") return example_panel(request.name);
  if (!request.base.empty()) request.shapes.base = base_kinds.at(request.base);
  return shapes_panel(request.shapes);
}

std::optional<PanelDesign> design_of(Request& request) {
  std::optional<PanelDesign> design = bare_design(request);
  if (design && request.kernel)
    prepare_for_kernel(*design, request.random.seed);
  else if (design && request.walls)
    add_walls(*design, request.random.seed);
  return design;
}

int cannot_write(const std::string& path) {
  std::cerr << "cannot write " << path << "\n";
  return 2;
}

int run(Request& request) {
  for (const FileMaker& input : file_makers)
    if (input.name == request.name) return input.write(request.step) ? 0 : cannot_write(request.step);
  const std::optional<PanelDesign> design = design_of(request);
  if (!design) {
    std::cerr << "no such panel or shape; panels:" << names() << "; shapes: " << shape_names() << "\n";
    return 2;
  }
  if (!(request.kernel ? write_kernel_panel : write_panel)(*design, request.step))
    return cannot_write(request.step);
  if (!request.truth.empty() && !(std::ofstream(request.truth) << truth_json(*design) << std::flush))
    return cannot_write(request.truth);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Writes an example panel and what is true of it."};
  Request request;
  add_options(app, request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (app.count("--seed") > 0) request.shapes.seed = request.random.seed;
  return run(request);
}
