// A batch as a job array of Slurm.
#pragma once

#include <string>
#include <vector>

#include "batch/batch_run.h"

namespace beadmesh::app {

struct SlurmOptions {
  int most_tasks = 1000;           ///< default 1000: tasks of the array; more panels share tasks
  std::vector<std::string> lines;  ///< further options of sbatch, as "--partition=short"
};

/// Tasks of the array.
int task_count(const BatchPlan& plan, const SlurmOptions& options);

/// The panels of task `task` of `tasks`, both from 1: every tasks-th.
std::vector<BatchPanel> panels_of_task(const std::vector<BatchPanel>& panels, int task, int tasks);

/// Writes slurm/array.sh and slurm/collect.sh into the folder of the batch, which must hold its batch.toml.
/// `program` is the path of this program. Fails with write.*.
Result<void> write_slurm_scripts(const BatchPlan& plan, const SlurmOptions& options,
                                 const std::string& program);

/// Gives both to sbatch, the second to begin when the first has ended; the numbers of the jobs. Fails with
/// slurm.*.
Result<std::vector<std::string>> submit(const BatchPlan& plan);

}  // namespace beadmesh::app
