// make_example_outline NAME OUT.wkt|OUT.step: writes a face with many openings, for the medial object.
#include <iostream>

#include "examples/example_outlines.h"

int main(int argc, char** argv) {
  using namespace beadmesh::examples;
  const auto outline = argc == 3 ? example_outline(argv[1]) : std::nullopt;
  if (!outline) {
    std::cerr << "make_example_outline NAME OUT.wkt|OUT.step\n  NAME:";
    for (const std::string& name : outline_names()) std::cerr << " " << name;
    std::cerr << "\n";
    return 2;
  }
  if (write_outline(*outline, argv[2])) return 0;
  std::cerr << "cannot write " << argv[2] << "\n";
  return 2;
}
