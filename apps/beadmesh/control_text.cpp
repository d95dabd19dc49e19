#include "control_text.h"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace beadmesh::app {
namespace {

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

template <class Number>
bool read_number(std::string_view text, std::optional<Number>& number) {
  return read_number(text, number.emplace());
}

std::vector<std::string_view> pieces_of(std::string_view text, char between) {
  std::vector<std::string_view> pieces;
  for (size_t from = 0; from <= text.size();) {
    const size_t to = std::min(text.find(between, from), text.size());
    pieces.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return pieces;
}

bool read_point(std::string_view text, Vec3& point) {
  const auto parts = pieces_of(text, ':');
  return parts.size() == 3 && read_number(parts[0], point.x) && read_number(parts[1], point.y) &&
         read_number(parts[2], point.z);
}

/// A key of "key=value,key=value"; read: false where the value is of the wrong type.
struct Key {
  const char* name;
  std::function<bool(std::string_view)> read;
};

/// Returns the keys that were given.
Result<std::set<std::string_view>> read_keys(const std::string& text, const std::vector<Key>& keys,
                                             const char* code) {
  std::set<std::string_view> given;
  for (const std::string_view piece : pieces_of(text, ',')) {
    const size_t equals = piece.find('=');
    const std::string_view name = piece.substr(0, equals);
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return name == k.name; });
    if (equals == std::string_view::npos || key == keys.end()) {
      std::string names;
      for (const Key& one : keys) names += (names.empty() ? "" : ", ") + std::string(one.name);
      return fail(code, fmt::format("'{}' in '{}' is no key=value that is known", piece, text),
                  "keys: " + names);
    }
    if (!given.insert(key->name).second)
      return fail(code, fmt::format("'{}' is given twice in '{}'", name, text));
    if (!key->read(piece.substr(equals + 1)))
      return fail(code, fmt::format("'{}' in '{}' has a wrong value", piece, text));
  }
  return given;
}

}  // namespace

Result<std::pair<BeadSelection, BeadMeshControl>> single_bead_of(const std::string& text) {
  BeadSelection selection;
  BeadMeshControl control;
  const auto given = read_keys(
      text,
      {{"id", [&](auto value) { return read_number(value, selection.id) && selection.id > 0; }},
       {"at", [&](auto value) { return read_point(value, selection.point); }},
       {"size", [&](auto value) { return read_number(value, control.size); }},
       {"min-edge", [&](auto value) { return read_number(value, control.min_edge); }},
       {"across", [&](auto value) { return read_number(value, control.elements_across); }},
       {"along", [&](auto value) { return read_number(value, control.elements_along); }},
       {"rows", [&](auto value) { return read_number(value, control.clamp_rows); }},
       {"method",
        [&](auto value) { return (control.method = bead_method_of(std::string(value))).has_value(); }}},
      "usage.bead");
  if (!given) return tl::make_unexpected(given.error());
  if (given->contains("id") == given->contains("at"))
    return fail("usage.bead", fmt::format("'{}' must say which bead", text), "by id=N or at=X:Y:Z");
  return std::pair{selection, control};
}

Result<LocalSize> local_size_of(const std::string& text) {
  LocalSize local;
  const auto given = read_keys(text,
                               {{"at", [&](auto value) { return read_point(value, local.point); }},
                                {"radius", [&](auto value) { return read_number(value, local.radius); }},
                                {"size", [&](auto value) { return read_number(value, local.size); }}},
                               "usage.local_size");
  if (!given) return tl::make_unexpected(given.error());
  if (given->size() != 3)
    return fail("usage.local_size", fmt::format("'{}' must have at, radius and size", text));
  return local;
}

Result<Vec3> kept_edge_of(const std::string& text) {
  Vec3 point;
  if (!read_point(text, point))
    return fail("usage.keep_edge", fmt::format("'{}' is no point", text), "x:y:z, as in 10:20:5");
  return point;
}

}  // namespace beadmesh::app
