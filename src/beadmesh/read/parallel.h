// Inside the read room: the same work for many faces, on several threads.
#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>

#include "beadmesh/core/context.h"

namespace beadmesh {

/// Calls work(0) ... work(count - 1), each writing only its own result, on context.jobs threads.
template <class Work>
void for_each_index(std::size_t count, const Context& context, const Work& work) {
  tbb::task_arena arena(context.jobs > 0 ? context.jobs : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, work); });
}

}  // namespace beadmesh
