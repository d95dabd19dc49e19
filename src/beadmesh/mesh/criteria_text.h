// Criteria as text: the table that pre-processors read and write (.criteria files).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/mesh/quality_criteria.h"

namespace beadmesh {

struct CriteriaText {
  QualityCriteria criteria;          ///< measures without a row are off
  std::vector<std::string> ignored;  ///< names of rows that are not known here
};

/// One row per measure: number, name, on (0 or 1), weight, ideal, good, warn, fail, worst, separated by
/// blanks. Rows are known by name; "min size" and "max size" are other names of the lengths. Comments begin
/// with #; the row of penalties is passed over. Fails with criteria.row (its line), criteria.order (limits
/// that neither rise nor fall) and criteria.empty.
Result<CriteriaText> parse_criteria(std::string_view text);

/// The same table; parse_criteria gives the same criteria back.
std::string criteria_text(const QualityCriteria& criteria);

}  // namespace beadmesh
