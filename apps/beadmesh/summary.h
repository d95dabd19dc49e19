// What a verb says at its end: a few lines for people, and what fell short.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/bead/design_check.h"
#include "beadmesh/flatten/cut_open.h"
#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/panel/panel.h"
#include "beadmesh/write/quality_json.h"

namespace beadmesh::app {

/// "panel.step: 17 faces, 13 beads (6 I, 5 generic, 2 annular)" and the bead table; with `meshing` how each
/// was meshed.
std::string bead_summary(const Panel& panel, const BeadTable& table,
                         const std::vector<BeadMeshing>& meshing = {});
/// The table of the design check; empty where nothing was measured.
std::string design_summary(const std::vector<BeadDesign>& designs);
/// Counts, quality and edges, a line each.
std::string quality_summary(const QualitySummary& quality);
/// A line per criterion of the whole mesh, then one per part and one per bead that has failing elements.
std::string criteria_summary(const JudgedMesh& judged);
/// What fails in the whole mesh, on one line.
std::string failing_summary(const JudgedMesh& judged);
/// What failed before and after a repair, by criterion, on one line.
std::string repair_summary(const RepairFacts& facts, const JudgedMesh& after);
/// A line per face: loops, vertices by type, edges, length, thickness; `images`: which faces were cut open
/// (none for a plane polygon).
std::string medial_summary(const std::string& input, const std::vector<FaceMedial>& faces,
                           const std::vector<PlaneImage>& images = {});

/// What a user must know of a run that is done: beads meshed by the fall-back, inverted elements, edges below
/// `min_edge`. Empty where nothing fell short.
std::vector<Diagnostic> shortfalls(const PanelMesh& mesh, double min_edge);
std::vector<Diagnostic> shortfalls(const QualitySummary& quality, double min_edge);
std::vector<Diagnostic> shortfalls(const JudgedMesh& judged);

/// Notes and warnings on standard error, one a line; true where one is an error.
bool print_diagnostics(const std::vector<Diagnostic>& diagnostics);

}  // namespace beadmesh::app
