// make_report_page ALONG OUT.html [recognised]: the report of a synthetic panel with ALONG elements over its
// length, for the tests in a browser; `recognised` leaves the mesh out.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string_view>

#include "beadmesh/report/panel_html.h"
#include "report/synthetic_panel.h"

int main(int argc, char** argv) {
  const int along = argc > 2 ? std::atoi(argv[1]) : 0;
  if (along < 30) {
    std::cerr << "usage: make_report_page ALONG OUT.html [recognised]\n";
    return 2;
  }
  auto [panel, mesh] = beadmesh::test::synthetic_panel(along);
  if (argc > 3 && std::string_view(argv[3]) == "recognised") {
    mesh.mesh = {};
    mesh.meshing.clear();
    mesh.quality = {};
  }
  std::ofstream out(argv[2], std::ios::binary);
  out << beadmesh::panel_html(panel, mesh,
                              {panel.input, {{"size", "5 mm"}}, 2.5, beadmesh::criteria_of_sizes(5, 2.5)});
  return out ? 0 : 1;
}
