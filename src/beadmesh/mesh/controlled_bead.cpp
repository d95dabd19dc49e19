#include "beadmesh/mesh/controlled_bead.h"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

namespace beadmesh {
namespace {

/// A number of elements that may be asked for.
struct Count {
  std::optional<int> BeadMeshControl::*member;
  const char* name;
};

/// The first is given up last.
constexpr Count counts[] = {{&BeadMeshControl::elements_across, "elements across"},
                            {&BeadMeshControl::elements_along, "elements along"},
                            {&BeadMeshControl::clamp_rows, "clamp rows"}};

std::vector<Count> asked_counts(const BeadMeshControl& control) {
  std::vector<Count> asked;
  for (const Count& count : counts)
    if (control.*count.member) asked.push_back(count);
  return asked;
}

/// Sets of counts as bits, the largest sets first; among equals those that keep the first counts.
std::vector<unsigned> sets_to_try(size_t asked) {
  std::vector<unsigned> sets;
  for (unsigned set = 1; set < 1u << asked; ++set) sets.push_back(set);
  std::stable_sort(sets.begin(), sets.end(),
                   [](unsigned a, unsigned b) { return std::popcount(a) > std::popcount(b); });
  return sets;
}

void add_notes(BeadMesh& mesh, const std::vector<Count>& asked, const BeadMeshControl& control, unsigned kept,
               const std::string& reason) {
  for (size_t i = 0; i < asked.size(); ++i)
    if (!(kept >> i & 1))
      mesh.notes.push_back(std::to_string(*(control.*asked[i].member)) + " " + asked[i].name +
                           " not possible: " + reason);
}

}  // namespace

Result<BeadMesh> mesh_bead_as_asked(const FaceStudy& study, const MedialObject& medial, BeadKind kind,
                                    const BeadMesherOptions& options) {
  BeadMeshControl control = options.control;
  if (kind == BeadKind::annular) control.clamp_rows.reset();
  const std::vector<Count> asked = asked_counts(control);
  BeadMesherOptions trial = options;
  std::string reason = "ridge insertion has no counts";
  if (control.method != BeadMethod::ridge) {
    for (const unsigned set : sets_to_try(asked.size())) {
      trial.control = control;
      trial.control.method = BeadMethod::blocks;
      for (size_t i = 0; i < asked.size(); ++i)
        if (!(set >> i & 1)) (trial.control.*asked[i].member).reset();
      auto mesh = mesh_bead(study, medial, kind, trial);
      if (std::popcount(set) == int(asked.size()) && !mesh) reason = mesh.error().message;
      if (!mesh) continue;
      add_notes(*mesh, asked, control, set, reason);
      return mesh;
    }
  }
  trial.control = {};
  trial.control.method = control.method;
  auto mesh = mesh_bead(study, medial, kind, trial);
  if (mesh) add_notes(*mesh, asked, control, 0, reason);
  return mesh;
}

}  // namespace beadmesh
