// The medial object of a rectangle, and a deck of one element: what the core gives without OpenCASCADE.
#include <beadmesh/medial/medial_object.h>
#include <beadmesh/read/polygon_reader.h>
#include <beadmesh/write/deck.h>

#include <cstdio>

int main() {
  const auto region = beadmesh::parse_wkt("POLYGON((0 0, 40 0, 40 10, 0 10))");
  if (!region) return 1;
  const auto medial = beadmesh::medial_object(*region);
  if (!medial) return 2;
  double length = 0;
  for (const beadmesh::MedialEdge& edge : medial->edges) length += edge.length;
  beadmesh::ShellMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.parts = {{1, "sheet", 1}};
  mesh.elements = {{{0, 1, 2, 3}, 0, 1, 0}};
  if (!beadmesh::write_deck(mesh, "one.k")) return 3;
  const auto unknown = beadmesh::check_deck_ending("one.xyz");
  std::printf("%zu edges, %.3f long; %s\n", medial->edges.size(), length, unknown.error().code.c_str());
}
