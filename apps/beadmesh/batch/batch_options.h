// What the command line of `batch` says.
#pragma once

#include <filesystem>
#include <string>

#include "batch/batch_run.h"
#include "batch/manifest.h"
#include "batch/slurm_job.h"

namespace CLI {
class App;
}

namespace beadmesh::app {

struct BatchOptions {
  std::filesystem::path manifest, out;
  CommonSettings common;
  std::string deck = "bdf", report = "html";
  int jobs = 0, threads = 1;
  WorkerLimits limits;
  bool force = false, collect = false, slurm = false, submit = false;
  int task = 0;  ///< 0: all panels
  int tasks = 0;
  SlurmOptions slurm_options;
};

/// The verb and its options; `options` must outlive the parsing.
void add_batch(CLI::App& app, BatchOptions& options);

/// Fails with usage.*.
Result<void> check(const BatchOptions& options);

}  // namespace beadmesh::app
