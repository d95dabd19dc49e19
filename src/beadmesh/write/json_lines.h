// Private to this room: JSON values with sensible digits, laid out one item a line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "beadmesh/core/diagnostic.h"
#include "beadmesh/core/vector.h"
#include "beadmesh/mesh/element_quality.h"

namespace beadmesh::json {

using Value = nlohmann::ordered_json;

/// Rounded to 1e-6, so that files stay short; 0 for -0, null where it is no number.
Value number(double value);
Value point(Vec2 p);
Value point(Vec3 p);
Value polyline(const std::vector<Vec3>& points);
Value diagnostic(const Diagnostic& diagnostic);
Value diagnostics(const std::vector<Diagnostic>& all);
Value quality(const QualitySummary& summary);

/// Text of a value on one line; what is not UTF-8 is replaced.
std::string text_of(const Value& value);
/// Text of an object: a line for each of its values, and for each item of arrays of objects. Ends in a line
/// break; text that is not UTF-8 is replaced.
std::string lines_of(const Value& object);

}  // namespace beadmesh::json
