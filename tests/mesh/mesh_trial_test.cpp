#include "beadmesh/mesh/mesh_trial.h"

#include <gtest/gtest.h>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

TEST(MeshTrial, RelaxesTheMiddleNodeAndPrefersTheRegularMesh) {
  NodeLoops loops;
  test::add_loop(loops, test::rectangle(2, 2, 2, 2));
  MeshDraft draft(loops, nullptr, 1);
  const MeshDraft::Mark mark = draft.mark();
  const Index middle = draft.add_node({1.4, 0.7});
  draft.add_element({0, 1, middle, 7});
  draft.add_element({1, 2, 3, middle});
  draft.add_element({middle, 3, 4, 5});
  draft.add_element({7, middle, 5, 6});
  const Judgement regular = relax_and_judge(draft, mark);
  EXPECT_NEAR(distance(draft.at(middle), {1, 1}), 0, 0.02);
  draft.take_back(mark);

  const Index other = draft.add_node({1, 1});
  draft.add_element({0, 1, 2, other});
  draft.add_element({2, 3, 4, other});
  draft.add_element({4, 5, 6, other});
  draft.add_element({6, 7, 0, other});
  const Judgement irregular = relax_and_judge(draft, mark);
  EXPECT_LT(regular.cost, irregular.cost);
  EXPECT_GT(regular.worst, irregular.worst);
  EXPECT_LT(regular.cost, 0.1);
}

}  // namespace
}  // namespace beadmesh
