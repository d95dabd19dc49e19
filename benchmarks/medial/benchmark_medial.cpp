// Times the medial object and what it can be compared with, on the same segments in the same run. Writes one
// JSON object a line; table.py makes the tables of the docs from them.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "candidates.h"
#include "domains.h"
#include "measurement.h"
#include "same_accuracy.h"

namespace beadmesh::bench {
namespace {

constexpr double generic_angle = 0.3;

struct Settings {
  std::vector<int> sizes{1'000, 10'000, 100'000, 1'000'000};
  double seconds = 3;  // a candidate is repeated until it has used this much
  int most_runs = 30;
  unsigned child_limit = 120;
  bool accuracy = true;
};

struct Entry {
  Candidate candidate;
  Run run;
  double best = std::numeric_limits<double>::infinity(), spent = 0;
  int runs = 0;
  std::string result{};
};

void repeat_interleaved(std::vector<Entry>& entries, const Settings& settings) {
  for (bool again = true; again;) {
    again = false;
    for (Entry& entry : entries) {
      if (entry.candidate.may_crash) continue;
      if (entry.runs >= settings.most_runs || (entry.runs >= 2 && entry.spent > settings.seconds)) continue;
      const double start = thread_seconds();
      entry.result = entry.run();
      const double seconds = thread_seconds() - start;
      entry.best = std::min(entry.best, seconds);
      entry.spent += seconds;
      ++entry.runs;
      again = true;
    }
  }
}

void write(const std::string& domain, int segments, double angle, const Entry& entry,
           const std::optional<ChildReport>& child) {
  const double seconds = entry.candidate.may_crash && child ? child->seconds : entry.best;
  std::printf("{\"domain\": \"%s\", \"segments\": %d, \"angle\": %g, \"candidate\": \"%s\", ", domain.c_str(),
              segments, angle, entry.candidate.name.c_str());
  if (!child && entry.candidate.may_crash)
    std::printf("\"failed\": true}\n");
  else
    std::printf(
        "\"seconds\": %.9g, \"runs\": %d, \"peak_bytes\": %.0f, \"resident_bytes\": %.0f, "
        "\"result\": \"%s\"}\n",
        seconds, std::max(entry.runs, 1), child ? child->peak_bytes : -1.0,
        child ? child->resident_bytes : -1.0, entry.result.c_str());
  std::fflush(stdout);
}

void compare(const Domain& domain, int segments, double angle, const Settings& settings) {
  const PlanarRegion region = cut(domain, segments, angle);
  std::vector<Candidate> candidates = our_candidates();
  for (const Candidate& candidate : boost_candidates()) candidates.push_back(candidate);
#ifdef BEADMESH_HAVE_CGAL
  for (const Candidate& candidate : cgal_candidates()) candidates.push_back(candidate);
#endif
  std::vector<Entry> entries;
  for (const Candidate& candidate : candidates)
    if (segments <= candidate.most_segments)
      entries.push_back({.candidate = candidate, .run = candidate.prepare(region)});
  repeat_interleaved(entries, settings);
  for (const Entry& entry : entries)
    write(domain.name, segments, angle, entry, run_in_child(entry.run, settings.child_limit));
}

int run(const Settings& settings) {
  for (const int segments : settings.sizes)
    for (const Domain& domain : {i_bead(), gasket(), comb()})
      for (const double angle : {0.0, generic_angle}) compare(domain, segments, angle, settings);
  if (settings.accuracy) compare_accuracy(settings.seconds);
  return 0;
}

}  // namespace
}  // namespace beadmesh::bench

int main(int count, char** words) {
  beadmesh::bench::Settings settings;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string word = words[i];
    if (word ==
        "--size") {  // one size, without the comparison at the same accuracy; 0: that comparison alone
      settings.sizes = {std::atoi(words[i + 1])};
      settings.accuracy = settings.sizes[0] == 0;
      if (settings.accuracy) settings.sizes.clear();
    }
    if (word == "--seconds") settings.seconds = std::atof(words[i + 1]);
  }
  try {
    return beadmesh::bench::run(settings);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_medial: %s\n", error.what());
    return 1;
  }
}
