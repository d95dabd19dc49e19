// The verb `batch`: panels in, a folder of results and a summary out.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <ostream>
#include <thread>

#include "batch/batch_options.h"
#include "batch/batch_summary.h"
#include "beadmesh/write/whole_files.h"
#include "progress.h"
#include "verbs.h"

namespace beadmesh::app {
namespace {

namespace fs = std::filesystem;

BatchPlan plan_of(const BatchOptions& o, std::vector<BatchPanel> panels) {
  return {BatchFolder(fs::absolute(o.out).lexically_normal()),
          std::move(panels),
          o.deck,
          o.report,
          o.jobs,
          o.threads,
          o.limits,
          o.force};
}

/// A bar on a terminal, a line for each panel elsewhere.
class BatchProgress {
 public:
  explicit BatchProgress(size_t panels) : panels_(panels) {}

  void report(const PanelState& state, bool skipped) {
    ++done_;
    const bool on_terminal = ::isatty(STDERR_FILENO) != 0;
    if (!on_terminal)
      fmt::print(stderr, "[{}/{}] {}: {}{}\n", done_, panels_, state.name, name_of(state.outcome),
                 skipped ? " before" : fmt::format(" in {:.1f} s", state.cost.seconds));
    else if (context_.progress)
      context_.progress(fmt::format("{} of {} panels", done_, panels_), double(done_) / double(panels_));
    skipped_ += skipped;
  }

  size_t skipped() const { return skipped_; }
  void clear() { bar_.clear(); }

 private:
  size_t panels_, done_ = 0, skipped_ = 0;
  ProgressBar bar_;
  Context context_ = bar_.context(0);
};

Result<void> write_summary(const BatchPlan& plan, const std::vector<PanelState>& states,
                           const std::string& title) {
  WholeFiles files;
  for (const auto& [name, text] :
       {std::pair{"batch.json", batch_json(states)}, std::pair{"batch.csv", batch_csv(states)},
        std::pair{"batch.html", batch_html(states, title)}, std::pair{"times.csv", times_csv(states)}}) {
    const std::string& content = text;
    auto added = files.add(plan.folder.file(name), [&](std::ostream& out) { out << content; });
    if (!added) return added;
  }
  return files.commit();
}

/// Says what became of the panels; a summary that cannot be written is a shortfall that is named.
int conclude(const BatchPlan& plan, const std::vector<PanelState>& states, const BatchOptions& options) {
  fmt::print("{}", batch_text(states));
  const std::string title = "Batch " + options.manifest.filename().string();
  const auto written = write_summary(plan, states, title);
  if (written)
    fmt::print("wrote {}\n", (options.out / "batch.html").string());
  else
    fmt::print(stderr, "{}\n", to_line(written.error()));
  return written && totals_of(states).all_well() ? done : fell_short;
}

Result<std::string> own_path() {
  std::error_code error;
  const fs::path path = fs::read_symlink("/proc/self/exe", error);
  if (error) return fail("batch.process", "the path of this program is not known: " + error.message());
  return path.string();
}

Result<int> write_slurm(const BatchPlan& plan, const BatchOptions& options) {
  const auto program = own_path();
  if (!program) return tl::make_unexpected(program.error());
  if (auto put = write_slurm_scripts(plan, options.slurm_options, *program); !put)
    return tl::make_unexpected(put.error());
  const std::string array = plan.folder.file("slurm/array.sh").string();
  const std::string collect = plan.folder.file("slurm/collect.sh").string();
  fmt::print("{} panels in {} tasks\nwrote {}, {}\n", plan.panels.size(),
             task_count(plan, options.slurm_options), array, collect);
  if (!options.submit) {
    fmt::print("submit them: sbatch --dependency=afterany:$(sbatch --parsable {}) {}\n", array, collect);
    return done;
  }
  const auto jobs = submit(plan);
  if (!jobs) return tl::make_unexpected(jobs.error());
  fmt::print("submitted job {}, and {} for the summary\n", jobs->front(), jobs->back());
  return done;
}

Result<int> run_task(BatchPlan plan, const BatchOptions& options) {
  const int tasks = options.tasks ? options.tasks : static_cast<int>(plan.panels.size());
  if (options.task > tasks)
    return fail("usage.task", fmt::format("there is no task {} of {}", options.task, tasks));
  plan.panels = panels_of_task(plan.panels, options.task, tasks);
  BatchProgress progress(plan.panels.size());
  const auto states =
      run_panels(plan, [&](const PanelState& state, bool skipped) { progress.report(state, skipped); });
  progress.clear();
  fmt::print("{}", batch_text(states));
  return totals_of(states).all_well() ? done : fell_short;
}

int run_all(const BatchPlan& plan, const BatchOptions& options) {
  BatchProgress progress(plan.panels.size());
  const auto states =
      run_panels(plan, [&](const PanelState& state, bool skipped) { progress.report(state, skipped); });
  progress.clear();
  if (progress.skipped()) fmt::print("{} were done before\n", progress.skipped());
  return conclude(plan, states, options);
}

/// A limit that this build cannot keep is named, and the panels run without it.
void warn_of_limits(const BatchOptions& options) {
  if (options.limits.memory_mb <= 0 || memory_can_be_limited()) return;
  fmt::print(
      stderr,
      "warning batch.memory: a build with a sanitizer cannot limit memory; panels run without a limit\n");
}

}  // namespace

Result<int> run_batch(const BatchOptions& options) {
  if (auto good = check(options); !good) return tl::make_unexpected(good.error());
  warn_of_limits(options);
  auto panels = read_manifest(options.manifest, options.common, options.out);
  if (!panels) return tl::make_unexpected(panels.error());
  const BatchPlan plan = plan_of(options, std::move(*panels));
  if (auto made = plan.folder.make(); !made) return tl::make_unexpected(made.error());
  const bool alone = !options.task && !options.collect;
  if (auto locked = plan.folder.lock(alone); !locked) return tl::make_unexpected(locked.error());
  if (options.collect) return conclude(plan, collect_states(plan), options);
  if (options.task) return run_task(plan, options);
  plan.folder.remove_leftovers();
  if (auto put = plan.folder.write_manifest(plan.panels); !put) return tl::make_unexpected(put.error());
  return options.slurm ? write_slurm(plan, options) : Result<int>(run_all(plan, options));
}

}  // namespace beadmesh::app
