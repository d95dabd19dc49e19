#include "beadmesh/read/stl_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "beadmesh/read/words.h"

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

Result<LooseFacets> parse_stl(const std::string& bytes, const std::string& name) {
  auto corners = is_binary(bytes) ? parse_binary(bytes, name) : parse_ascii(bytes, name);
  if (!corners) return Failure(corners.error());
  return LooseFacets{std::move(*corners), {}};
}

}  // namespace beadmesh
