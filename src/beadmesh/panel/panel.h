// The faceted B-rep that flows through the pipeline: points, edges and faces that share them watertight.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadmesh/core/diagnostic.h"
#include "beadmesh/core/vector.h"
#include "beadmesh/panel/facets.h"

namespace beadmesh {

/// A point of a curve in space and its first two derivatives by the parameter.
struct SpaceCurvePoint {
  Vec3 point, velocity, acceleration;
};

/// The exact curve under an edge. Const calls are safe from several threads.
class CurveEvaluator {
 public:
  virtual ~CurveEvaluator() = default;
  virtual Vec3 point(double t) const = 0;
  virtual SpaceCurvePoint at(double t) const = 0;
};

/// An edge of the B-rep, facetted once for all faces around it.
struct PanelEdge {
  std::vector<Index> points;  ///< indices into Panel::points, at least 2; first == last for a closed edge
  std::vector<double> parameters;  ///< curve parameter of each point, monotone; empty without a curve
  std::shared_ptr<const CurveEvaluator> curve;  ///< null: the polyline is all there is
  std::vector<Index> faces;  ///< faces around it, one entry a use: 1 = free edge, 2 = inner, > 2 non-manifold
};

struct EdgeUse {
  Index edge = no_index;
  bool reversed = false;
};

struct PanelFace {
  std::vector<std::vector<EdgeUse>> loops;  ///< head to tail, face on the left; the outer loop first
  double confidence = 1;  ///< that it is what it seems: 1 from CAD, less where facets are coarse or noisy
  Facets facets;          ///< of this face alone: facets.loops[i] runs through the points of loops[i]
  Index number = 0;       ///< 1-based, in the order of the input file; of a composite face its first
  std::vector<Index> numbers;  ///< of a composite face those of all its faces, ascending; else empty
  std::string name;            ///< from the file; may be empty
  Index part = no_index;       ///< index in Panel::parts; no_index: the file knows of none
  double thickness = 0;        ///< mm, measured or from the file; 0: not known
};

/// A component of an assembly, or a part of a deck: a property of its own.
struct PanelPart {
  std::string name;                             ///< may be empty
  Index id = 0;                                 ///< property id in the file; 0: none
  std::optional<std::array<double, 3>> colour;  ///< red, green, blue in [0, 1]
};

/// All lengths in mm. Orientation of the faces is consistent across shared edges of each connected piece.
struct Panel {
  std::vector<Vec3> points;
  std::vector<PanelEdge> edges;
  std::vector<PanelFace> faces;
  std::vector<PanelPart> parts;         ///< in the file's order
  std::string input;                    ///< file name, for reports
  std::string unit = "mm";              ///< unit of the file; coordinates are converted to mm
  std::vector<Diagnostic> diagnostics;  ///< what the reader mended or left out
  bool is_facetted = false;  ///< from facets alone: the reader has cut it into sheet and features already
};

/// Joins the facets of connected faces into one piece (a composite face); its loops are those edges that have
/// only one side in `faces`. A seam of a closed face stays a pair of boundary stretches only in the face's
/// own facets.
Facets facets_of(const Panel& panel, const std::vector<Index>& faces);

/// The panel with each group of faces (indices, connected, no face in two) as one face, in the place of the
/// group's first; edges inside a group are gone. Faces without a group stay as they are. A group whose facets
/// do not join to one piece with loops along its edges is left apart.
Panel with_merged_faces(Panel panel, const std::vector<std::vector<Index>>& groups);

/// The panel without the points that no edge and no facet needs.
Panel without_unused_points(Panel panel);

/// Numbers of the input's faces that these faces (indices) are made of, ascending.
std::vector<Index> input_numbers(const Panel& panel, const std::vector<Index>& faces);

/// Faces of the input, those in composite faces counted one by one.
std::size_t input_face_count(const Panel& panel);

/// Checks every invariant stated above. Returns the violations, in words; empty where all hold.
std::vector<std::string> verify_panel(const Panel& panel);

/// Length of the diagonal of the bounding box, mm.
double diagonal(const Panel& panel);

}  // namespace beadmesh
