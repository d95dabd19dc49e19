// A panel made by a formula, as large as one likes: for the tests of the report in a browser.
#pragma once

#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh::test {

struct SyntheticPanel {
  Panel panel;
  PanelMesh mesh;
};

/// A sheet of 300 by 200 mm with an I-bead, a T and a ring, each a face of its own; `along` elements over its
/// length, two thirds of that across. With crest lines, medial axes, split lines and one diagnostic.
SyntheticPanel synthetic_panel(int along);

}  // namespace beadmesh::test
