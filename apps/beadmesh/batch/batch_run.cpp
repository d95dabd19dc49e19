#include "batch/batch_run.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <deque>
#include <thread>
#include <utility>

#include "batch/word_list.h"
#include "verbs.h"

namespace beadmesh::app {
namespace {

namespace fs = std::filesystem;

constexpr int most_attempts = 2;
constexpr int tick_ms = 50;

volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int) {
  interrupted = 1;
}

/// The two signals are heard as long as this lives.
class Interrupts {
 public:
  Interrupts() {
    interrupted = 0;
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    ::sigaction(SIGINT, &action, &old_[0]);
    ::sigaction(SIGTERM, &action, &old_[1]);
  }
  ~Interrupts() {
    ::sigaction(SIGINT, &old_[0], nullptr);
    ::sigaction(SIGTERM, &old_[1], nullptr);
  }
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

 private:
  struct sigaction old_[2]{};
};

bool is_from_outside(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP || signal == SIGQUIT;
}

/// The first line of the output that begins so; empty where none does.
std::string line_with(const std::string& output, std::string_view start) {
  for (size_t at = 0; at < output.size();) {
    const size_t end = std::min(output.find('\n', at), output.size());
    if (output.compare(at, start.size(), start) == 0) return output.substr(at, end - at);
    at = end + 1;
  }
  return "";
}

std::string first_reason(const std::string& output) {
  const std::string error = line_with(output, "error ");
  return error.empty() ? line_with(output, "warning ") : error;
}

Outcome outcome_of(const WorkerEnd& end) {
  if (end.timed_out && end.signal == SIGKILL) return Outcome::timed_out;
  if (end.signal) return is_from_outside(end.signal) ? Outcome::killed : Outcome::crashed;
  if (!line_with(end.output, "error internal.memory").empty()) return Outcome::out_of_memory;
  switch (end.exit_status) {
    case done:
      return Outcome::done;
    case fell_short:
      return Outcome::fell_short;
    case refused:
      return line_with(end.output, "error write.").empty() ? Outcome::refused : Outcome::not_written;
    default:
      return Outcome::crashed;
  }
}

std::string message_of(const WorkerEnd& end, Outcome outcome, const WorkerLimits& limits) {
  if (outcome == Outcome::timed_out)
    return fmt::format("error batch.timeout: not done after {:g} s", limits.seconds);
  if (end.signal)
    return fmt::format("error batch.signal: the worker was ended by signal {} ({})", end.signal,
                       ::strsignal(end.signal));
  if (outcome == Outcome::done) return "";
  const std::string reason = first_reason(end.output);
  return reason.empty() ? fmt::format("error batch.exit: exit status {}", end.exit_status) : reason;
}

/// A panel that is being worked on.
struct Running {
  size_t panel;
  fs::path work;
  Worker worker;
};

class BatchRun {
 public:
  BatchRun(const BatchPlan& plan, const PanelCallback& callback) : plan_(plan), callback_(callback) {
    for (const BatchPanel& panel : plan.panels) {
      PanelState& state = states_.emplace_back();
      state.name = panel.name, state.input = panel.input.string();
    }
  }

  std::vector<PanelState> run() {
    const Interrupts listening;
    std::deque<size_t> waiting = largest_first();
    const size_t at_once = plan_.jobs > 0 ? plan_.jobs : std::max(1u, std::thread::hardware_concurrency());
    while (!interrupted && (!waiting.empty() || !running_.empty())) {
      while (running_.size() < at_once && !waiting.empty() && !interrupted) {
        const size_t panel = waiting.front();
        waiting.pop_front();
        begin(panel);
      }
      wait();
      for (const size_t again : take_ended()) waiting.push_back(again);
    }
    for (Running& one : running_) drop(one);
    if (interrupted) look_up_the_rest();
    return std::move(states_);
  }

 private:
  /// Long panels that begin last would leave cores idle at the end.
  std::deque<size_t> largest_first() const {
    std::vector<std::pair<std::uintmax_t, size_t>> sizes;
    for (size_t i = 0; i < plan_.panels.size(); ++i) {
      std::error_code error;
      const auto size = fs::file_size(plan_.panels[i].input, error);
      sizes.emplace_back(error ? 0 : size, i);
    }
    std::stable_sort(sizes.begin(), sizes.end(), [](auto& a, auto& b) { return a.first > b.first; });
    std::deque<size_t> order;
    for (const auto& [size, panel] : sizes) order.push_back(panel);
    return order;
  }

  void begin(size_t panel) {
    PanelState& state = states_[panel];
    state.fingerprint = fingerprint_of(plan_.panels[panel], plan_.kinds());
    if (!plan_.force && !state.cost.attempts) {
      auto old = plan_.folder.valid_state(state.name, state.fingerprint);
      if (old && has_results(old->outcome)) {
        state = std::move(*old);
        callback_(state, true);
        return;
      }
    }
    auto work = plan_.folder.work_folder(state.name);
    if (!work) return give_up(state, Outcome::not_written, work.error());
    auto worker = Worker::start(mesh_words(plan_, plan_.panels[panel], *work), plan_.limits);
    if (!worker) {
      std::error_code ignored;
      fs::remove_all(*work, ignored);
      return give_up(state, Outcome::crashed, worker.error());
    }
    running_.push_back({panel, std::move(*work), std::move(*worker)});
  }

  void give_up(PanelState& state, Outcome outcome, const Diagnostic& reason) {
    state.outcome = outcome;
    state.message = to_line(reason);
    state.files.clear();
    callback_(state, false);
  }

  void wait() const {
    std::vector<pollfd> descriptors;
    for (const Running& one : running_)
      if (one.worker.descriptor() >= 0) descriptors.push_back({one.worker.descriptor(), POLLIN, 0});
    // A worker that has closed its output is about to end: look again soon.
    const int most = descriptors.size() < running_.size() ? 2 : tick_ms;
    if (!running_.empty()) ::poll(descriptors.data(), descriptors.size(), most);
  }

  /// Panels that need another try.
  std::vector<size_t> take_ended() {
    std::vector<size_t> again;
    for (size_t i = 0; i < running_.size();) {
      if (!running_[i].worker.poll()) {
        ++i;
        continue;
      }
      const Running ended = std::move(running_[i]);
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      if (!finish(ended)) again.push_back(ended.panel);
    }
    return again;
  }

  /// False where the panel gets another try.
  bool finish(const Running& ended) {
    const WorkerEnd& end = ended.worker.end();
    const BatchPanel& panel = plan_.panels[ended.panel];
    PanelState& state = states_[ended.panel];
    state.outcome = outcome_of(end);
    state.exit_status = end.exit_status, state.signal = end.signal;
    state.message = message_of(end, state.outcome, plan_.limits);
    state.cost = {state.cost.attempts + 1, end.seconds, end.cpu_seconds, end.peak_mb};
    if (state.outcome == Outcome::killed && state.cost.attempts < most_attempts) {
      std::error_code ignored;
      fs::remove_all(ended.work, ignored);
      return false;
    }
    state.figures = figures_of(ended.work / (panel.name + ".json")).value_or(PanelFigures{});
    const std::string log =
        shell_line(mesh_words(plan_, panel, plan_.folder.of_panel(panel.name))) + "\n" + end.output;
    if (auto put = plan_.folder.put(ended.work, state, log); !put)
      give_up(state, Outcome::not_written, put.error());
    else
      callback_(state, false);
    return true;
  }

  void drop(Running& one) {
    one.worker.kill();
    { const Worker ended = std::move(one.worker); }  // waits for it
    states_[one.panel].outcome = Outcome::not_run;
    std::error_code ignored;
    fs::remove_all(one.work, ignored);
  }

  /// After an interrupt: what an earlier run has left of the panels that were not reached.
  void look_up_the_rest() {
    for (size_t i = 0; i < states_.size(); ++i) {
      if (states_[i].outcome != Outcome::not_run) continue;
      auto old = plan_.folder.valid_state(states_[i].name, fingerprint_of(plan_.panels[i], plan_.kinds()));
      if (old) states_[i] = std::move(*old);
    }
  }

  const BatchPlan& plan_;
  const PanelCallback& callback_;
  std::vector<PanelState> states_;
  std::vector<Running> running_;
};

}  // namespace

std::vector<PanelState> run_panels(const BatchPlan& plan, const PanelCallback& callback) {
  return BatchRun(plan, callback).run();
}

std::vector<PanelState> collect_states(const BatchPlan& plan) {
  std::vector<PanelState> states;
  for (const BatchPanel& panel : plan.panels) {
    auto state = plan.folder.valid_state(panel.name, fingerprint_of(panel, plan.kinds()));
    if (!state) {
      state.emplace();
      state->name = panel.name, state->input = panel.input.string();
    }
    states.push_back(std::move(*state));
  }
  return states;
}

std::vector<std::string> mesh_words(const BatchPlan& plan, const BatchPanel& panel, const fs::path& into) {
  const auto file = [&](const std::string& ending) { return (into / (panel.name + "." + ending)).string(); };
  std::vector<std::string> words{"beadmesh", "mesh", panel.input.string(), "-o", file(plan.deck)};
  for (const auto& [flag, ending] : {std::pair{"--json", "json"}, std::pair{"--csv", "csv"}})
    words.insert(words.end(), {flag, file(ending)});
  if (plan.report != "none") words.insert(words.end(), {"--report", file(plan.report)});
  words.insert(words.end(), {"--jobs", std::to_string(plan.threads)});
  for (const std::string& text : panel.settings)
    words.insert(words.end(), {"--config", plan.folder.settings_file(text).string()});
  words.insert(words.end(), panel.options.begin(), panel.options.end());
  return words;
}

}  // namespace beadmesh::app
