#include "batch/batch_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "beadmesh/write/deck.h"

namespace beadmesh::app {
namespace {

void add_common_settings(CLI::App& verb, CommonSettings& common) {
  verb.add_option("--config", common.configs, "settings for all panels from a TOML file; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--preset", common.layer.preset, "for all panels: crash, nvh or durability");
  verb.add_option("--size", common.layer.size, "for all panels: element size, mm");
  verb.add_option("--min-edge", common.layer.min_edge, "for all panels: minimum element length, mm");
  verb.add_option("--thickness", common.layer.thickness, "for all panels: sheet thickness, mm");
  verb.add_option("--unit", common.layer.unit, "for all panels: unit of inputs that carry none");
}

void add_workers(CLI::App& verb, BatchOptions& o) {
  verb.add_option("--jobs", o.jobs, "panels at a time, each a process (default: number of cores)");
  verb.add_option("--threads", o.threads, "threads for each panel (default 1)");
  verb.add_option("--timeout", o.limits.seconds, "seconds that a panel may take; 0: no limit (default 3600)");
  verb.add_option("--memory", o.limits.memory_mb,
                  "memory that a panel may take, MB; 0: no limit (default 0)");
  verb.add_flag("--force", o.force, "do again what is done");
}

void add_slurm(CLI::App& verb, BatchOptions& o) {
  verb.add_flag("--slurm", o.slurm, "run nothing; write the scripts of a Slurm job array");
  verb.add_flag("--submit", o.submit, "with --slurm: give them to sbatch");
  verb.add_option("--slurm-option", o.slurm_options.lines,
                  "a further option of sbatch, as --slurm-option=--partition=short; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--max-tasks", o.slurm_options.most_tasks,
                  "tasks of the array; more panels share tasks (default 1000)");
  verb.add_option("--task", o.task, "run only the panels of this task, write no summary");
  verb.add_option("--tasks", o.tasks, "number of tasks (default: a task a panel)");
  verb.add_flag("--collect", o.collect, "run nothing; write the summary of what is done");
}

Result<void> check_number(const char* code, const char* what, double value, double low, double high) {
  if (std::isfinite(value) && value >= low && value <= high) return {};
  return fail(code, fmt::format("the {} is {}", what, value),
              fmt::format("it must be at least {} and at most {}", low, high));
}

}  // namespace

void add_batch(CLI::App& app, BatchOptions& o) {
  o.limits.seconds = 3600;
  CLI::App& verb = *app.add_subcommand("batch", "mesh many panels, each in a process of its own");
  verb.add_option(
          "MANIFEST", o.manifest,
          "a folder with panels; a list, a path a line and options of mesh behind it; or a TOML file\n"
          "with [defaults] and a [[panel]] each")
      ->required();
  verb.add_option("--out", o.out, "folder for the results; what is done there already is not done again")
      ->required();
  verb.add_option("--deck", o.deck, "format of the decks, by its ending (default bdf)");
  verb.add_option("--report", o.report, "html, svg or none (default html)");
  add_workers(verb, o);
  add_common_settings(verb, o.common);
  add_slurm(verb, o);
}

Result<void> check(const BatchOptions& o) {
  if (o.deck.find_first_of("./\\") != std::string::npos)
    return fail("usage.deck", "'" + o.deck + "' is no ending", "give it without a point: bdf");
  if (auto known = check_deck_ending("deck." + o.deck); !known) return known;
  if (o.report != "html" && o.report != "svg" && o.report != "none")
    return fail("usage.report", "'" + o.report + "' is no kind of report", "known: html, svg, none");
  if (o.submit && !o.slurm) return fail("usage.submit", "--submit goes with --slurm");
  if (o.slurm + o.collect + (o.task != 0) > 1)
    return fail("usage.batch", "--slurm, --task and --collect exclude each other");
  if (o.tasks && !o.task) return fail("usage.task", "--tasks goes with --task");
  if (o.task && o.tasks && o.task > o.tasks)
    return fail("usage.task", fmt::format("there is no task {} of {}", o.task, o.tasks));
  for (const std::string& line : o.slurm_options.lines)
    if (line.rfind("-", 0) != 0 || line.find('\n') != std::string::npos)
      return fail("usage.slurm_option", "'" + line + "' is no option of sbatch", "as --partition=short");
  const auto& [seconds, memory] = o.limits;
  if (auto good = check_number("usage.timeout", "time limit (s)", seconds, 0, 1e7); !good) return good;
  if (auto good = check_number("usage.memory", "memory limit (MB)", memory, 0, 1e8); !good) return good;
  if (auto good = check_number("usage.jobs", "number of jobs", o.jobs, 0, 1024); !good) return good;
  if (auto good = check_number("usage.threads", "number of threads", o.threads, 1, 1024); !good) return good;
  if (auto good = check_number("usage.task", "task", o.task, 0, 1e6); !good) return good;
  if (auto good = check_number("usage.task", "number of tasks", o.tasks, 0, 1e6); !good) return good;
  return check_number("usage.max_tasks", "most tasks", o.slurm_options.most_tasks, 1, 1e6);
}

}  // namespace beadmesh::app
