#include <fmt/format.h>

#include <cstdio>
#include <ostream>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/read/nastran_reader.h"
#include "beadmesh/write/quality_json.h"
#include "outputs.h"
#include "summary.h"
#include "verbs.h"

namespace beadmesh::app {

Result<int> run_check(const Options& options) {
  const auto deck = read_nastran(options.input);
  if (!deck) return tl::make_unexpected(deck.error());
  const double size = options.has_size ? options.settings.sizes.size : 0;
  const double min_edge = options.has_min_edge ? options.settings.sizes.min_edge : 0;
  const QualitySummary quality = summarise(deck->points, deck->elements, min_edge);

  const std::string name = options.input.filename().string();
  Outputs outputs;
  outputs.add(options.outputs.json,
              [&](std::ostream& out) { out << quality_json(name, quality, size, min_edge); });
  if (auto put = outputs.put(); !put) return tl::make_unexpected(put.error());
  if (!outputs.uses_stdout()) fmt::print("{}\n{}", name, quality_summary(quality));
  const std::vector<Diagnostic> short_of = shortfalls(quality, min_edge);
  print_diagnostics(short_of);
  return short_of.empty() ? done : fell_short;
}

}  // namespace beadmesh::app
