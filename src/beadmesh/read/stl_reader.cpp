#include "beadmesh/read/stl_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "beadmesh/read/facet_skin.h"
#include "beadmesh/read/input_file.h"

namespace beadmesh {
namespace {

using Corners = std::array<Vec3, 3>;

constexpr std::size_t binary_header = 84, binary_facet = 50;

std::uint32_t count_in_header(const std::string& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= binary_header) std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

/// Binary files may begin with "solid", too: their length decides, and where it does not fit, the words.
bool is_binary(const std::string& bytes) {
  if (bytes.size() < binary_header) return false;
  if (bytes.size() == binary_header + binary_facet * static_cast<std::size_t>(count_in_header(bytes)))
    return true;
  return bytes.find('\0') != std::string::npos;
}

Result<std::vector<Corners>> parse_binary(const std::string& bytes, const std::string& name) {
  const std::size_t count = count_in_header(bytes);
  if (bytes.size() < binary_header + binary_facet * count)
    return fail("read.truncated",
                "the file holds " + std::to_string((bytes.size() - binary_header) / binary_facet) + " of " +
                    std::to_string(count) + " facets",
                "export the file again", name);
  std::vector<Corners> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    float x[9];
    std::memcpy(x, bytes.data() + binary_header + i * binary_facet + 12, sizeof x);
    for (int k = 0; k < 3; ++k) result[i][k] = {x[3 * k], x[3 * k + 1], x[3 * k + 2]};
  }
  return result;
}

class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  std::string_view next() {
    const auto is_space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }
  std::optional<double> number() {
    std::string_view word = next();
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return {};
    return value;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

Result<std::vector<Corners>> parse_ascii(const std::string& bytes, const std::string& name) {
  std::vector<Corners> result;
  std::vector<Vec3> corners;
  Words words(bytes);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "vertex") {
      const auto x = words.number(), y = words.number(), z = words.number();
      if (!x || !y || !z)
        return fail("read.unreadable",
                    "facet " + std::to_string(result.size() + 1) + " has a vertex that is no point", {},
                    name);
      corners.push_back({*x, *y, *z});
    } else if (word == "endfacet") {
      if (corners.size() != 3)
        return fail("read.unreadable", "facet " + std::to_string(result.size() + 1) + " is no triangle", {},
                    name);
      result.push_back({corners[0], corners[1], corners[2]});
      corners.clear();
    }
  }
  const bool ended = bytes.find("endsolid") != std::string::npos;
  if (result.empty() && !ended)
    return fail("read.unreadable", "the file is not a readable STL file", {}, name);
  if (!corners.empty() || !ended)
    return fail("read.truncated", "the file ends before endsolid", "export the file again", name);
  return result;
}

}  // namespace

Result<Panel> read_stl_panel(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string name = path.filename().string();
  const std::optional<double> factor = millimetres_per(options.unit);
  if (!factor)
    return fail("read.unit", "the unit '" + options.unit + "' is unknown", "use mm, cm, m, um, in or ft",
                name);
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  Result<std::vector<Corners>> facets =
      is_binary(bytes) ? parse_binary(bytes, name) : parse_ascii(bytes, name);
  if (!facets) return Failure(facets.error());
  for (Corners& corners : *facets)
    for (Vec3& p : corners) {
      p = p * *factor;
      if (!std::isfinite(p.x + p.y + p.z))
        return fail("read.unreadable", "a facet has a corner that is not finite", {}, name);
    }
  Panel panel = panel_of_facets(*facets, options.feature_angle);
  if (panel.faces.empty()) return fail("read.no_faces", "the file has no facets", {}, name);
  panel.input = name;
  panel.unit = options.unit;
  return panel;
}

}  // namespace beadmesh
