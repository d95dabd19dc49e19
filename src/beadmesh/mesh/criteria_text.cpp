#include "beadmesh/mesh/criteria_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

namespace beadmesh {
namespace {

constexpr size_t numbers_of_row = 7;  ///< on, weight, ideal, good, warn, fail, worst

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  size_t at = 0;
  while (true) {
    at = line.find_first_not_of(" \t\r,;", at);
    if (at == std::string_view::npos) return words;
    const size_t end = std::min(line.find_first_of(" \t\r,;", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
}

std::optional<double> number_of(std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<QualityMeasure> measure_of(const std::string& name) {
  if (name == "min size") return QualityMeasure::min_length;
  if (name == "max size") return QualityMeasure::max_length;
  for (int m = 0; m < measure_count; ++m)
    if (name == name_of(static_cast<QualityMeasure>(m))) return static_cast<QualityMeasure>(m);
  return std::nullopt;
}

struct Row {
  std::string name;  ///< lower case, words one blank apart
  std::vector<double> numbers;
};

/// Number of the row, name, then numbers to the end; none where it is not so.
std::optional<Row> row_of(const std::vector<std::string_view>& words) {
  if (words.size() < 3 || !number_of(words[0])) return std::nullopt;
  Row row;
  size_t at = 1;
  for (; at < words.size() && !number_of(words[at]); ++at) {
    if (!row.name.empty()) row.name += ' ';
    for (const char c : words[at]) row.name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (; at < words.size(); ++at) {
    const auto number = number_of(words[at]);
    if (!number) return std::nullopt;
    row.numbers.push_back(*number);
  }
  if (row.name.empty()) return std::nullopt;
  return row;
}

bool is_ordered(const Criterion& c) {
  const std::array<double, 5> limits = {c.ideal, c.good, c.warn, c.fail, c.worst};
  return std::is_sorted(limits.begin(), limits.end()) || std::is_sorted(limits.rbegin(), limits.rend());
}

}  // namespace

Result<CriteriaText> parse_criteria(std::string_view text) {
  CriteriaText out;
  for (Criterion& criterion : out.criteria.of) criterion.on = false;
  int line_number = 0, rows = 0;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line_number;
    const auto words = words_of(line);
    if (words.empty() || words[0].front() == '#') continue;
    const auto row = row_of(words);
    if (!row)
      return fail("criteria.row", fmt::format("line {} is no row of a criteria table", line_number),
                  "number, name, on, weight, ideal, good, warn, fail, worst");
    if (row->name.starts_with("penalty")) continue;
    const auto measure = measure_of(row->name);
    if (!measure) {
      out.ignored.push_back(row->name);
      continue;
    }
    const std::vector<double>& n = row->numbers;
    if (n.size() != numbers_of_row)
      return fail("criteria.row",
                  fmt::format("line {}: '{}' has {} numbers", line_number, row->name, n.size()),
                  "on, weight, ideal, good, warn, fail, worst");
    const Criterion criterion{n[0] != 0, n[1], n[2], n[3], n[4], n[5], n[6]};
    if (!is_ordered(criterion))
      return fail("criteria.order",
                  fmt::format("line {}: limits of '{}' neither rise nor fall", line_number, row->name),
                  "ideal, good, warn, fail, worst in this order");
    out.criteria[*measure] = criterion;
    ++rows;
  }
  if (rows == 0) return fail("criteria.empty", "no criterion found", "a table as written by --save-criteria");
  return out;
}

std::string criteria_text(const QualityCriteria& criteria) {
  std::string text = fmt::format("#{:>2} {:<16} {:>3} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "id",
                                 "criterion", "on", "weight", "ideal", "good", "warn", "fail", "worst");
  for (int m = 0; m < measure_count; ++m) {
    const Criterion& c = criteria.of[m];
    text += fmt::format("{:>3} {:<16} {:>3} {:>7.6g} {:>9.6g} {:>9.6g} {:>9.6g} {:>9.6g} {:>9.6g}\n", m + 1,
                        name_of(static_cast<QualityMeasure>(m)), int(c.on), c.weight, c.ideal, c.good, c.warn,
                        c.fail, c.worst);
  }
  return text;
}

}  // namespace beadmesh
