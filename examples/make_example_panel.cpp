// make_example_panel NAME OUT.step [TRUTH.json]: writes an example panel and what is true of it, or one of
// the broken inputs that tests use.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "examples/example_panels.h"
#include "examples/step_file.h"
#include "examples/truth.h"

namespace {

using namespace beadmesh::examples;

struct BrokenInput {
  std::string name;
  bool (*write)(const std::filesystem::path&);
};
const std::vector<BrokenInput> broken_inputs{
    {"bow-tie", write_bow_tie}, {"figure-of-eight", write_figure_of_eight}, {"no-faces", write_lone_edge}};

int usage() {
  std::cerr << "make_example_panel NAME OUT.step [TRUTH.json]\n  NAME:";
  for (const std::string& name : example_names()) std::cerr << " " << name;
  for (const BrokenInput& input : broken_inputs) std::cerr << " " << input.name;
  std::cerr << "\n";
  return 2;
}

int cannot_write(const char* path) {
  std::cerr << "cannot write " << path << "\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) return usage();
  const std::string name = argv[1];
  for (const BrokenInput& input : broken_inputs)
    if (input.name == name) return input.write(argv[2]) ? 0 : cannot_write(argv[2]);
  const std::optional<PanelDesign> design = example_panel(name);
  if (!design) return usage();
  if (!write_panel(*design, argv[2])) return cannot_write(argv[2]);
  if (argc == 4 && !(std::ofstream(argv[3]) << truth_json(*design) << std::flush))
    return cannot_write(argv[3]);
  return 0;
}
