// mesh_panel PANEL: reads and meshes it by the installed libraries.
#include <beadmesh/pipeline.h>
#include <beadmesh/read/panel_reader.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  auto panel = beadmesh::read_panel(argv[1]);
  if (!panel) {
    std::printf("%s\n", beadmesh::to_line(panel.error()).c_str());
    return 1;
  }
  const auto composed = beadmesh::compose_faces(std::move(*panel));
  const auto mesh = beadmesh::mesh_panel(composed, {});
  if (!mesh) return 1;
  std::printf("%zu beads, %d quads\n", mesh->table.beads.size(), mesh->quality.quads);
}
