#include "beadmesh/write/json_lines.h"

#include <cmath>

namespace beadmesh::json {
namespace {

bool is_list_of_objects(const Value& value) {
  return value.is_array() && !value.empty() && value.front().is_object();
}

std::string list_text(const Value& list) {
  std::string text = "[";
  for (size_t i = 0; i < list.size(); ++i) text += (i ? ",\n    " : "\n    ") + text_of(list[i]);
  return text + "\n  ]";
}

}  // namespace

std::string text_of(const Value& value) {
  return value.dump(-1, ' ', false, Value::error_handler_t::replace);
}

Value number(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (std::abs(value) > 1e9) return value;
  const double rounded = std::round(value * 1e6) / 1e6;
  return rounded == 0 ? 0.0 : rounded;
}

Value point(Vec2 p) {
  return {number(p.x), number(p.y)};
}
Value point(Vec3 p) {
  return {number(p.x), number(p.y), number(p.z)};
}

Value polyline(const std::vector<Vec3>& points) {
  Value list = Value::array();
  for (const Vec3& p : points) list.push_back(point(p));
  return list;
}

Value diagnostic(const Diagnostic& diagnostic) {
  return {{"code", diagnostic.code},
          {"severity", std::string(name_of(diagnostic.severity))},
          {"face", diagnostic.face == no_index ? Value(nullptr) : Value(diagnostic.face)},
          {"entity", diagnostic.entity},
          {"message", diagnostic.message},
          {"hint", diagnostic.hint}};
}

Value diagnostics(const std::vector<Diagnostic>& all) {
  Value list = Value::array();
  for (const Diagnostic& one : all) list.push_back(diagnostic(one));
  return list;
}

Value quality(const QualitySummary& summary) {
  return {{"scaled_jacobian_min", number(summary.scaled_jacobian_min)},
          {"scaled_jacobian_mean", number(summary.scaled_jacobian_mean)},
          {"edge_min", number(summary.edge_min)},
          {"edge_max", number(summary.edge_max)},
          {"warpage_max", number(summary.warpage_max)},
          {"warped_over_15", summary.warped_over_15},
          {"inverted", summary.inverted},
          {"edges_below_min", summary.edges_below_min},
          {"irregular", summary.irregular}};
}

std::string lines_of(const Value& object) {
  std::string text = "{";
  bool first = true;
  for (const auto& [key, value] : object.items()) {
    text += first ? "\n  " : ",\n  ";
    text += text_of(Value(key)) + ": " + (is_list_of_objects(value) ? list_text(value) : text_of(value));
    first = false;
  }
  return text + "\n}\n";
}

}  // namespace beadmesh::json
