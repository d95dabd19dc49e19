#include "beadmesh/read/cad_raw_loops.h"

#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>
#include <vector>

#include "beadmesh/read/cad_edges.h"
#include "beadmesh/read/face_boundary.h"

namespace beadmesh {
namespace {

bool can_be_judged(const CadFace& face) {
  // Before mending, a loop on a closed surface may lack its seam: its picture in the parameters proves
  // nothing.
  return !face.broken && !face.loops.empty() && !face.surface->IsUClosed() && !face.surface->IsVClosed() &&
         !face.surface->IsUPeriodic() && !face.surface->IsVPeriodic();
}

bool has_jump(const FaceNodes& nodes) {
  for (const std::vector<NodeRun>& loop : nodes.loops)
    for (const NodeRun& run : loop)
      if (run.edge == no_index) return true;
  return false;
}

class Watcher : public XSAlgo_AlgoContainer {
 public:
  explicit Watcher(std::optional<Diagnostic>& defect) : defect_(defect) {}

  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Standard_Real precision,
                            const Standard_Real max_tolerance, const Standard_CString resource,
                            const Standard_CString sequence, Handle(Standard_Transient) & info,
                            const Message_ProgressRange& progress,
                            const Standard_Boolean non_manifold) const override {
    look(shape);
    return XSAlgo_AlgoContainer::ProcessShape(shape, precision, max_tolerance, resource, sequence, info,
                                              progress, non_manifold);
  }

 private:
  void look(const TopoDS_Shape& shape) const {
    if (defect_) return;
    CadModel model;
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
      if (seen_.Add(at.Current())) model.faces.push_back(TopoDS::Face(at.Current()));
    try {
      defect_ = crossing_loop(model);
    } catch (const Standard_Failure&) {
      return;  // too broken to judge before mending; the mended face is looked at again
    }
    if (defect_) defect_->face += faces_before_;
    faces_before_ += static_cast<Index>(model.faces.size());
  }

  std::optional<Diagnostic>& defect_;
  mutable TopTools_MapOfShape seen_;
  mutable Index faces_before_ = 0;
};

}  // namespace

std::optional<Diagnostic> crossing_loop(const CadModel& model) {
  CadTopology topology = topology_of(model);
  sample_edges_by_curve(topology, 0.005);
  for (std::size_t f = 0; f < topology.faces.size(); ++f) {
    const CadFace& face = topology.faces[f];
    if (!can_be_judged(face)) continue;
    FaceNodes nodes;
    const Vec2 stretch = face_stretch(face);
    const auto polygons = boundary_nodes(topology, face, stretch, nodes);
    if (has_jump(nodes)) continue;
    std::vector<Vec2> stretched;
    for (const Vec2 uv : nodes.uv) stretched.push_back({uv.x * stretch.x, uv.y * stretch.y});
    if (const auto where = find_crossing(polygons, stretched, nodes.points))
      return crossing_defect(*where, static_cast<Index>(f) + 1);
  }
  return {};
}

RawLoopWatch::RawLoopWatch() {
  XSAlgo::SetAlgoContainer(new Watcher(defect_));
}

RawLoopWatch::~RawLoopWatch() {
  XSAlgo::SetAlgoContainer(new XSAlgo_AlgoContainer);
}

}  // namespace beadmesh
