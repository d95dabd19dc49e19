// Internal to the module: long work that Ctrl-C ends.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <type_traits>

#include "arrays.h"

namespace beadmesh::python {

/// Runs work(context) on a thread of its own, without the lock of the interpreter, and looks for signals
/// meanwhile: Python handles them between its own steps only. A handler that raises (KeyboardInterrupt)
/// cancels the work; its exception goes on once the work has ended. In a thread that is not Python's main one
/// no signal arrives.
template <class Work>
std::invoke_result_t<Work, const Context&> interruptible(int jobs, Work work) {
  std::atomic<bool> cancelled = false;
  Context context;
  context.jobs = jobs;
  context.cancelled = &cancelled;
  auto result = std::async(std::launch::async, [&] { return work(context); });
  for (bool ready = false; !ready;) {
    {
      const py::gil_scoped_release released;
      ready = result.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
    }
    if (ready || PyErr_CheckSignals() == 0) continue;
    cancelled = true;
    const py::error_already_set interrupt;
    {
      const py::gil_scoped_release released;
      result.wait();
    }
    throw interrupt;
  }
  return result.get();
}

}  // namespace beadmesh::python
