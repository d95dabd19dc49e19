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

/// Tries mesh_bead with fewer and fewer of the counts that are asked for.
class Attempts {
 public:
  Attempts(const FaceStudy& study, const MedialObject& medial, BeadKind kind,
           const BeadMesherOptions& options)
      : study_(study), medial_(medial), kind_(kind), options_(options) {
    if (kind == BeadKind::annular) options_.control.clamp_rows.reset();
    if (options_.control.method != BeadMethod::ridge) asked_ = asked_counts(options_.control);
  }

  Result<BeadMesh> run() {
    if (auto mesh = best_obedient()) return std::move(*mesh);
    auto mesh = attempt(0, options_.control.method);
    if (mesh) note_refusals(*mesh, 0);
    return mesh;
  }

 private:
  /// Blocks with as many of the counts as possible, at least one.
  std::optional<BeadMesh> best_obedient() {
    reasons_.resize(size_t(1) << asked_.size());
    for (const unsigned set : sets_to_try(asked_.size())) {
      auto mesh = attempt(set, BeadMethod::blocks);
      if (mesh) {
        note_refusals(*mesh, set);
        return std::move(*mesh);
      }
      reasons_[set] = mesh.error().message;
    }
    return std::nullopt;
  }

  Result<BeadMesh> attempt(unsigned set, std::optional<BeadMethod> method) const {
    BeadMesherOptions trial = options_;
    trial.control.method = method;
    for (size_t i = 0; i < asked_.size(); ++i)
      if (!(set >> i & 1)) (trial.control.*asked_[i].member).reset();
    return mesh_bead(study_, medial_, kind_, trial);
  }

  /// The reason against a count is what failed first when it was tried with those that are kept.
  void note_refusals(BeadMesh& mesh, unsigned kept) const {
    for (size_t i = 0; i < asked_.size(); ++i)
      if (!(kept >> i & 1))
        mesh.refusals.push_back(std::string(asked_[i].name) + " " +
                                std::to_string(*(options_.control.*asked_[i].member)) +
                                " not possible: " + first_of(reasons_[kept | 1u << i]));
  }

  static std::string first_of(const std::string& reasons) { return reasons.substr(0, reasons.find(';')); }

  const FaceStudy& study_;
  const MedialObject& medial_;
  BeadKind kind_;
  BeadMesherOptions options_;
  std::vector<Count> asked_;
  std::vector<std::string> reasons_;  ///< by set: why it failed
};

}  // namespace

Result<BeadMesh> mesh_bead_as_asked(const FaceStudy& study, const MedialObject& medial, BeadKind kind,
                                    const BeadMesherOptions& options) {
  return Attempts(study, medial, kind, options).run();
}

}  // namespace beadmesh
