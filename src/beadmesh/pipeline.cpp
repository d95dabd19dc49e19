#include "beadmesh/pipeline.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>

#include "beadmesh/bead/face_study.h"
#include "beadmesh/bead/joined_sheets.h"
#include "beadmesh/mesh/panel_mesher.h"

namespace beadmesh {
namespace {

/// What one face came to; written by one thread each.
struct FaceOutcome {
  std::unique_ptr<FaceStudy> study;
  std::unique_ptr<MedialObject> medial;
  std::optional<Bead> bead;
  std::string reason;                    ///< why it is no bead
  std::optional<Diagnostic> diagnostic;  ///< what went wrong on the way
};

Diagnostic at_face(Diagnostic diagnostic, const Panel& panel, Index face, Severity severity) {
  diagnostic.face = panel.faces[face].number;
  diagnostic.severity = severity;
  return diagnostic;
}

/// Sections 3.1 to 4.1 for one face: flatten, medial object, bead rule.
FaceOutcome study_one(const Panel& panel, Index face, const BeadOptions& options) {
  FaceOutcome out;
  auto study = study_faces(panel, {face});
  if (!study) {
    out.reason = "cannot be laid flat: " + study.error().message;
    out.diagnostic = at_face(study.error(), panel, face, Severity::error);
    return out;
  }
  out.study = std::move(*study);
  if (panel.is_facetted && !(panel.faces[face].confidence > 0)) {
    out.reason = "it is no feature of a sheet around it";
    return out;
  }
  if (const auto boundary = check_boundary(*out.study, options); !boundary) {
    out.reason = boundary.error().message;
    return out;
  }
  auto medial = medial_object_of_bead(out.study->region);
  if (!medial) {
    out.reason = "no medial object: " + medial.error().message;
    out.diagnostic = at_face(medial.error(), panel, face, Severity::warning);
    return out;
  }
  out.medial = std::make_unique<MedialObject>(std::move(*medial));
  auto bead = recognise(*out.study, *out.medial, options);
  if (bead) {
    out.bead = std::move(*bead);
    out.bead->confidence = panel.faces[face].confidence;
  } else {
    out.reason = bead.error().message;
  }
  return out;
}

/// "12.5"
std::string text_of(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// "12 %" of the stretch 1.12.
std::string percent(double stretch) {
  return std::to_string(std::lround(100 * (stretch - 1))) + " %";
}

FaceMedial lifted(const FaceStudy& study, const MedialObject& medial, Index number) {
  FaceMedial out;
  out.face = number;
  out.region = study.region;
  out.object = medial;
  for (const MedialVertex& vertex : medial.vertices) {
    out.vertex_points.push_back(study.lift(vertex.point));
    out.vertex_feet.emplace_back();
    for (const Foot& foot : vertex.touching_points) out.vertex_feet.back().push_back(study.lift(foot.point));
  }
  for (const MedialEdge& edge : medial.edges) {
    out.edge_points.emplace_back();
    out.edge_feet.emplace_back();
    for (const MedialPoint& p : edge.points) {
      out.edge_points.back().push_back(study.lift(p.point));
      out.edge_feet.back().push_back({study.lift(p.feet[0].point), study.lift(p.feet[1].point)});
    }
  }
  return out;
}

struct OpenedMedial {
  FaceMedial medial;
  PlaneImage image;
};

Result<OpenedMedial> opened_medial(const Panel& panel, Index face) {
  auto study = study_opened_face(panel, face);
  if (!study) {
    Diagnostic problem = at_face(study.error(), panel, face, Severity::error);
    if (problem.hint.empty() || problem.code == "flatten.not_a_disc")
      problem.hint = "split the face into simpler ones";
    return tl::unexpected(std::move(problem));
  }
  const FaceStudy& s = **study;
  const auto medial = medial_object(s.region);
  if (!medial) {
    Diagnostic problem = at_face(medial.error(), panel, face, Severity::error);
    if (problem.hint.empty()) problem.hint = "split the face, or repair its boundary";
    return tl::unexpected(std::move(problem));
  }
  return OpenedMedial{lifted(s, *medial, panel.faces[face].number),
                      {s.flat.distortion, cut_length(s), s.cut_sides}};
}

/// A plane image stretched by more than this in the mean no longer shows the thicknesses of the face.
constexpr double telling_stretch = 1.1;

std::optional<Diagnostic> distortion_warning(const PlaneImage& image, Index number) {
  const Distortion& d = image.distortion;
  if (d.mean_stretch <= telling_stretch) return std::nullopt;
  return Diagnostic{"flatten.distorted",
                    Severity::warning,
                    number,
                    "",
                    "the plane image is stretched by " + percent(d.mean_stretch) + " in the mean, by " +
                        percent(d.max_stretch) + " at most: thicknesses are those of the plane",
                    "split the face for truer ones"};
}

/// Ladders of up to five windows. The paper's rule lets no bead have more than two loops, but what is shaped
/// like one is meshed like one.
constexpr int most_loops_meshed = 6;

std::string too_many_loops(const FaceOutcome& face, int most) {
  return "it has " + std::to_string(face.study->region.loops.size()) + " loops, a bead has at most " +
         std::to_string(most);
}

/// All faces in parallel; the table in the order of the faces. Beads with more than `listed_loops` loops are
/// not listed.
StudiedPanel study_panel(const Panel& panel, const BeadOptions& options, int listed_loops,
                         const Context& context) {
  std::vector<FaceOutcome> outcomes(panel.faces.size());
  std::atomic<int> done = 0;
  context.report("recognise", 0);
  tbb::parallel_for(size_t(0), outcomes.size(), [&](size_t f) {
    if (!context.is_cancelled()) outcomes[f] = study_one(panel, Index(f), options);
    context.report("recognise", double(++done) / double(outcomes.size()));
  });
  StudiedPanel studied;
  studied.table.diagnostics = panel.diagnostics;
  Index listed = 0;
  for (size_t f = 0; f < outcomes.size(); ++f) {
    FaceOutcome& face = outcomes[f];
    const Index number = panel.faces[f].number;
    const bool is_listed = face.bead && face.bead->loops <= listed_loops;
    if (face.bead) {
      face.bead->listed = is_listed;
      if (is_listed) face.bead->id = ++listed;
      studied.table.medials.push_back(lifted(*face.study, *face.medial, number));
      studied.table.beads.push_back(std::move(*face.bead));
    }
    if (face.study && int(face.study->region.loops.size()) > listed_loops)
      face.reason = too_many_loops(face, listed_loops);
    if (!is_listed)
      for (const Index of_input : input_numbers(panel, {Index(f)}))
        studied.table.faces_not_beads.push_back({of_input, face.reason});
    if (face.diagnostic) studied.table.diagnostics.push_back(*face.diagnostic);
    studied.studies.push_back(std::move(face.study));
    studied.medials.push_back(std::move(face.medial));
  }
  return studied;
}

/// Limits the threads of everything below while it lives.
class JobLimit {
 public:
  explicit JobLimit(int jobs) {
    if (jobs > 0) control_.emplace(tbb::global_control::max_allowed_parallelism, size_t(jobs));
  }

 private:
  std::optional<tbb::global_control> control_;
};

std::map<Index, Index> faces_by_number(const Panel& panel) {
  std::map<Index, Index> faces;
  for (Index f = 0; f < Index(panel.faces.size()); ++f) faces[panel.faces[f].number] = f;
  return faces;
}

void note_sheets(const std::vector<std::vector<Index>>& sheets, std::vector<GroupDecision>& decisions) {
  for (const std::vector<Index>& faces : sheets)
    decisions.push_back({faces, GroupVerdict::sheet, "neither turn nor bend at the edges between its faces"});
}

}  // namespace

Panel compose_faces(Panel panel, const BeadOptions& options, const Context& context,
                    const std::vector<Vec3>& kept, std::vector<GroupDecision>* decisions) {
  if (panel.is_facetted) return panel;
  constexpr double reach = 1;
  const JobLimit limit(context.jobs);
  CompositeOptions composite;
  composite.bead = options;
  JoinedSheetOptions joined;
  std::vector<Vec3> missed;
  joined.kept_edges = edges_at(panel, kept, reach, missed);
  for (const Vec3 p : missed)
    panel.diagnostics.push_back(
        {"control.keep_edge", Severity::warning, no_index, "",
         "no edge to keep at (" + text_of(p.x) + ", " + text_of(p.y) + ", " + text_of(p.z) + ")",
         "give a point within 1 mm of an edge"});
  context.report("compose", 0);
  const auto sheets = joined_sheets(panel, joined, context);
  if (decisions) note_sheets(sheets, *decisions);
  const std::map<Index, Index> input_faces = faces_by_number(panel);
  panel = with_merged_faces(std::move(panel), sheets);
  context.report("compose", 0.3);
  std::vector<std::vector<Index>> features;
  for (GroupDecision& group : group_decisions(panel, composite, context)) {
    if (group.verdict != GroupVerdict::left) features.push_back(group.faces);
    if (!decisions) continue;
    std::vector<Index> of_input;
    for (const Index number : input_numbers(panel, group.faces)) of_input.push_back(input_faces.at(number));
    group.faces = std::move(of_input);
    decisions->push_back(std::move(group));
  }
  return with_merged_faces(std::move(panel), features);
}

BeadTable recognise_beads(const Panel& panel, const BeadOptions& options, const Context& context) {
  const JobLimit limit(context.jobs);
  return study_panel(panel, options, options.max_loops, context).table;
}

std::vector<BeadDesign> design_of_beads(const Panel& panel, const BeadTable& table, const Context& context) {
  const JobLimit limit(context.jobs);
  std::vector<const Bead*> listed;
  for (const Bead& bead : table.beads)
    if (bead.listed) listed.push_back(&bead);
  std::vector<BeadDesign> designs(listed.size());
  std::atomic<int> done = 0;
  tbb::parallel_for(size_t(0), listed.size(), [&](size_t i) {
    designs[i].id = listed[i]->id;
    const auto study = study_faces(panel, listed[i]->faces);
    const auto medial = study ? medial_object_of_bead((*study)->region) : tl::unexpected(study.error());
    if (medial) designs[i].sections = measure_sections(**study, *medial);
    context.report("design check", double(++done) / double(listed.size()));
  });
  const std::vector<BeadDistances> distances = bead_distances(panel, table);
  for (size_t i = 0; i < designs.size(); ++i) designs[i].distances = distances[i];
  return designs;
}

Result<PanelMesh> mesh_panel(const Panel& panel, const MeshSizes& sizes, const BeadOptions& options,
                             const Context& context) {
  const JobLimit limit(context.jobs);
  BeadOptions meshed = options;
  meshed.max_loops = std::max(options.max_loops, most_loops_meshed);
  const StudiedPanel studied = study_panel(panel, meshed, options.max_loops, context);
  return mesh_studied_panel(panel, studied,
                            {sizes.size, sizes.min_edge, sizes.thickness, sizes.beads, sizes.local,
                             sizes.washers, sizes.chordal_deviation, sizes.criteria},
                            context);
}

Result<FaceMedial> medial_of_face(const Panel& panel, Index face) {
  auto opened = opened_medial(panel, face);
  if (!opened) return tl::unexpected(opened.error());
  return std::move(opened->medial);
}

PanelMedials medials_of_faces(const Panel& panel, const std::vector<Index>& faces, const Context& context) {
  const JobLimit limit(context.jobs);
  std::vector<std::optional<Result<OpenedMedial>>> outcomes(faces.size());
  std::atomic<size_t> done = 0;
  tbb::parallel_for(tbb::blocked_range<size_t>(0, faces.size(), 1),
                    [&](const tbb::blocked_range<size_t>& range) {
                      for (size_t i = range.begin(); i < range.end(); ++i) {
                        if (!context.is_cancelled()) outcomes[i] = opened_medial(panel, faces[i]);
                        context.report("medial objects", double(++done) / double(faces.size()));
                      }
                    });
  PanelMedials all;
  for (size_t i = 0; i < faces.size(); ++i) {
    if (!outcomes[i]) continue;
    Result<OpenedMedial>& outcome = *outcomes[i];
    if (!outcome) {
      all.diagnostics.push_back(outcome.error());
      continue;
    }
    if (auto warning = distortion_warning(outcome->image, outcome->medial.face))
      all.diagnostics.push_back(std::move(*warning));
    all.faces.push_back(std::move(outcome->medial));
    all.images.push_back(std::move(outcome->image));
  }
  return all;
}

}  // namespace beadmesh
