// THE flow, in the order of the paper: read, compose, flatten, medial object, recognise, block, mesh.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/bead/composite_faces.h"
#include "beadmesh/bead/design_check.h"
#include "beadmesh/bead/recognition.h"
#include "beadmesh/core/context.h"
#include "beadmesh/core/result.h"
#include "beadmesh/flatten/cut_open.h"
#include "beadmesh/medial/face_medial.h"
#include "beadmesh/mesh/bead_control.h"
#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/mesh/quality_criteria.h"
#include "beadmesh/mesh/size_field.h"
#include "beadmesh/mesh/washers.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

struct MeshSizes {
  double size = 5;          ///< default 5 mm: target element length
  double min_edge = 2.5;    ///< default 2.5 mm: minimum element length, hard
  double thickness = 1;     ///< default 1 mm: shell thickness written into the properties
  BeadControls beads = {};  ///< what is asked of single beads and kinds
  std::vector<LocalSize> local = {};
  double chordal_deviation = 0;  ///< default 0, no limit, mm: sagitta of edges off beads
  WasherControl washers = {};    ///< what is asked of the mesh around holes
  /// Limits that the mesh is judged by; none: those of crash with the lengths above.
  std::optional<QualityCriteria> criteria = {};
};

/// Sheet that the CAD system has cut without need becomes one face (bead/joined_sheets.h), and so does each
/// bead that it has split into many (bead/composite_faces.h). First
/// stage after reading; what the others are given is its panel. Sheet is not joined over the edges nearest to
/// `kept` (points within 1 mm of an edge, so that polylines can be followed): rows of nodes follow them. A
/// point without an edge becomes a warning of the panel (control.keep_edge). All that was decided is added to
/// `decisions`, where given, with the faces of the panel that came in (report/grouping_svg.h draws it).
Panel compose_faces(Panel panel, const BeadOptions& options = {}, const Context& context = {},
                    const std::vector<Vec3>& kept = {}, std::vector<GroupDecision>* decisions = nullptr);

/// Sections 3 and 4.1: every face that is a bead, with its medial object. Never fails for a single face.
BeadTable recognise_beads(const Panel& panel, const BeadOptions& options = {}, const Context& context = {});

/// The design measures of each listed bead, in the order of the table; not judged yet (judge_design).
std::vector<BeadDesign> design_of_beads(const Panel& panel, const BeadTable& table,
                                        const Context& context = {});

/// Sections 4.2 to 5.3. Fails only where nothing could be meshed at all, or with control.*.
Result<PanelMesh> mesh_panel(const Panel& panel, const MeshSizes& sizes, const BeadOptions& options = {},
                             const Context& context = {});

/// Medial objects of faces of a panel, and how each face came into the plane.
struct PanelMedials {
  std::vector<FaceMedial> faces;   ///< of the faces that have one, in the order asked for
  std::vector<PlaneImage> images;  ///< of each: distortion, and where it was cut open
  /// An error for each face that has none; a warning where the plane image is so distorted that thicknesses
  /// are off.
  std::vector<Diagnostic> diagnostics;
};

/// The medial object of any face (index in Panel::faces): large, curved, closed. A face that closes around
/// itself (tube, cone, torus, ...) is cut open; the sides of the cut are boundary then.
Result<FaceMedial> medial_of_face(const Panel& panel, Index face);

/// Those of several faces (indices in Panel::faces), in parallel; never fails for a single face.
PanelMedials medials_of_faces(const Panel& panel, const std::vector<Index>& faces,
                              const Context& context = {});

}  // namespace beadmesh
