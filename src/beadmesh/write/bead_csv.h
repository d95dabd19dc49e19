// The bead table for spreadsheets.
#pragma once

#include <string>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// A head line and a line per bead (RFC 4180, line feeds only): id, kind, shape, faces (1-based, joined by
/// blanks), x, y, z of a crest point, loops, length, width, height, aspect_ratio, junctions, ends,
/// medial_edges. Lengths in mm.
std::string bead_csv(const Panel& panel, const BeadTable& table);

}  // namespace beadmesh
