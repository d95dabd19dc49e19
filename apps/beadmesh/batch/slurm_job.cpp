#include "batch/slurm_job.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "batch/word_list.h"
#include "beadmesh/write/whole_files.h"

namespace beadmesh::app {
namespace {

namespace fs = std::filesystem;

/// Minutes that a task may take: all its panels to their time limit, and time to start.
int task_minutes(const BatchPlan& plan, int tasks) {
  const double panels = std::ceil(static_cast<double>(plan.panels.size()) / tasks);
  return static_cast<int>(std::ceil(panels * plan.limits.seconds / 60)) + 5;
}

std::vector<std::string> common_words(const BatchPlan& plan, const std::string& program) {
  return {program,
          "batch",
          plan.folder.file("batch.toml").string(),
          "--out",
          plan.folder.file("").parent_path().string(),
          "--deck",
          plan.deck,
          "--report",
          plan.report};
}

std::vector<std::string> task_words(const BatchPlan& plan, const std::string& program, int tasks) {
  std::vector<std::string> words = common_words(plan, program);
  words.insert(words.end(),
               {"--tasks", std::to_string(tasks), "--jobs", "1", "--threads", std::to_string(plan.threads),
                "--timeout", fmt::format("{}", plan.limits.seconds), "--memory",
                fmt::format("{}", plan.limits.memory_mb)});
  if (plan.force) words.push_back("--force");
  return words;
}

std::string directives(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "#SBATCH " + line + "\n";
  return text;
}

std::string array_script(const BatchPlan& plan, const SlurmOptions& options, const std::string& program) {
  const int tasks = task_count(plan, options);
  std::string text = "#!/bin/sh\n#SBATCH --job-name=beadmesh\n";
  text += fmt::format("#SBATCH --array=1-{}\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task={}\n", tasks,
                      std::max(1, plan.threads));
  text += fmt::format("#SBATCH --output=\"{}\"\n", plan.folder.file("slurm/task_%a.txt").string());
  if (plan.limits.seconds > 0) text += fmt::format("#SBATCH --time={}\n", task_minutes(plan, tasks));
  if (plan.limits.memory_mb > 0)
    text += fmt::format("#SBATCH --mem={}M\n", static_cast<long>(std::ceil(plan.limits.memory_mb)) + 256);
  text += directives(options.lines);
  return text + fmt::format("exec {} --task \"$SLURM_ARRAY_TASK_ID\"\n",
                            shell_line(task_words(plan, program, tasks)));
}

std::string collect_script(const BatchPlan& plan, const SlurmOptions& options, const std::string& program) {
  std::vector<std::string> words = common_words(plan, program);
  words.push_back("--collect");
  return fmt::format(
      "#!/bin/sh\n#SBATCH --job-name=beadmesh-summary\n#SBATCH --ntasks=1\n"
      "#SBATCH --output=\"{}\"\n{}exec {}\n",
      plan.folder.file("slurm/summary.txt").string(), directives(options.lines), shell_line(words));
}

/// What the command prints on standard output. Fails where it cannot be run, or fails.
Result<std::string> output_of(const std::vector<std::string>& words) {
  std::FILE* pipe = ::popen(shell_line(words).c_str(), "r");
  if (!pipe) return fail("slurm.sbatch", "sbatch cannot be run");
  std::string text;
  char buffer[4096];
  while (const size_t count = std::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, count);
  const int status = ::pclose(pipe);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    return fail("slurm.sbatch", "there is no sbatch on this machine", "submit the scripts where Slurm is");
  if (status != 0) return fail("slurm.sbatch", "sbatch refused the job", "its message is above");
  return text.substr(0, text.find_first_of(";\n"));  // --parsable: number;cluster
}

}  // namespace

int task_count(const BatchPlan& plan, const SlurmOptions& options) {
  return std::clamp(static_cast<int>(plan.panels.size()), 1, std::max(1, options.most_tasks));
}

std::vector<BatchPanel> panels_of_task(const std::vector<BatchPanel>& panels, int task, int tasks) {
  std::vector<BatchPanel> chosen;
  for (size_t i = static_cast<size_t>(task) - 1; i < panels.size(); i += static_cast<size_t>(tasks))
    chosen.push_back(panels[i]);
  return chosen;
}

Result<void> write_slurm_scripts(const BatchPlan& plan, const SlurmOptions& options,
                                 const std::string& program) {
  const fs::path folder = plan.folder.file("slurm");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return fail("write.folder", "the folder cannot be made: " + error.message(), "", folder.string());
  WholeFiles files;
  for (const auto& [name, text] : {std::pair{"array.sh", array_script(plan, options, program)},
                                   std::pair{"collect.sh", collect_script(plan, options, program)}}) {
    const std::string& script = text;
    if (auto put = files.add(folder / name, [&](std::ostream& out) { out << script; }); !put) return put;
  }
  return files.commit();
}

Result<std::vector<std::string>> submit(const BatchPlan& plan) {
  auto array = output_of({"sbatch", "--parsable", plan.folder.file("slurm/array.sh").string()});
  if (!array) return tl::make_unexpected(array.error());
  auto collect = output_of({"sbatch", "--parsable", "--dependency=afterany:" + *array,
                            plan.folder.file("slurm/collect.sh").string()});
  if (!collect) return tl::make_unexpected(collect.error());
  return std::vector<std::string>{*array, *collect};
}

}  // namespace beadmesh::app
