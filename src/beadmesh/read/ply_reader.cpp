#include "beadmesh/read/ply_reader.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "beadmesh/read/polygon_cutting.h"
#include "beadmesh/read/words.h"

namespace beadmesh {
namespace {

enum class Encoding { ascii, little, big };

/// Number of bytes and what they mean; nothing where the name is unknown.
struct NumberType {
  int size = 0;
  bool is_real = false, is_signed = true;
};

std::optional<NumberType> type_named(std::string_view name) {
  static const std::map<std::string_view, NumberType> types{{"char", {1}},
                                                            {"int8", {1}},
                                                            {"uchar", {1, false, false}},
                                                            {"uint8", {1, false, false}},
                                                            {"short", {2}},
                                                            {"int16", {2}},
                                                            {"ushort", {2, false, false}},
                                                            {"uint16", {2, false, false}},
                                                            {"int", {4}},
                                                            {"int32", {4}},
                                                            {"uint", {4, false, false}},
                                                            {"uint32", {4, false, false}},
                                                            {"float", {4, true}},
                                                            {"float32", {4, true}},
                                                            {"double", {8, true}},
                                                            {"float64", {8, true}}};
  const auto found = types.find(name);
  return found == types.end() ? std::nullopt : std::optional<NumberType>(found->second);
}

struct Property {
  std::string name;
  NumberType type;
  std::optional<NumberType> count;  ///< of a list: what its length is written as
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

/// Numbers of the body, one after the other.
class Body {
 public:
  Body(std::string_view bytes, Encoding encoding) : bytes_(bytes), words_(bytes), encoding_(encoding) {}

  std::optional<double> next(NumberType type) {
    if (encoding_ == Encoding::ascii) return words_.number();
    if (bytes_.size() - at_ < std::size_t(type.size)) return {};
    char raw[8] = {};
    std::memcpy(raw, bytes_.data() + at_, type.size);
    at_ += type.size;
    if ((encoding_ == Encoding::little) != (std::endian::native == std::endian::little))
      std::reverse(raw, raw + type.size);
    return value_of(raw, type);
  }

 private:
  template <class T>
  static double as(const char* raw) {
    T value;
    std::memcpy(&value, raw, sizeof value);
    return double(value);
  }

  static double value_of(const char* raw, NumberType type) {
    if (type.is_real) return type.size == 4 ? as<float>(raw) : as<double>(raw);
    switch (type.size) {
      case 1:
        return type.is_signed ? as<std::int8_t>(raw) : as<std::uint8_t>(raw);
      case 2:
        return type.is_signed ? as<std::int16_t>(raw) : as<std::uint16_t>(raw);
      default:
        return type.is_signed ? as<std::int32_t>(raw) : as<std::uint32_t>(raw);
    }
  }

  std::string_view bytes_;
  Words words_;
  Encoding encoding_;
  std::size_t at_ = 0;
};

class PlyParser {
 public:
  PlyParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  Result<LooseFacets> run() {
    if (const auto header = read_header(); !header) return Failure(header.error());
    Body body(bytes_.substr(at_), encoding_);
    for (const Element& element : elements_)
      for (std::uint64_t row = 0; row < element.count; ++row)
        if (const auto read = read_row(element, row, body); !read) return Failure(read.error());
    return std::move(facets_);
  }

 private:
  Failure unreadable(const std::string& what) const {
    return fail("read.unreadable", what, "export the file again", name_);
  }

  bool next_line(std::string_view& line) {
    if (at_ >= bytes_.size()) return false;
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    line = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return true;
  }

  Result<void> read_header() {
    std::string_view line;
    if (!next_line(line) || line != "ply") return unreadable("the file is not a readable PLY file");
    bool has_format = false;
    while (next_line(line)) {
      Words words(line);
      const std::string_view what = words.next();
      if (what == "end_header") return has_format ? check_header() : unreadable("its header names no format");
      bool good = true;
      if (what == "format") good = has_format = take_format(words.next());
      if (what == "element") good = take_element(words);
      if (what == "property") good = take_property(words);
      if (!good) return unreadable("its header has the line '" + std::string(line.substr(0, 60)) + "'");
    }
    return fail("read.truncated", "the file ends within its header", "export the file again", name_);
  }

  bool take_format(std::string_view word) {
    if (word == "ascii")
      encoding_ = Encoding::ascii;
    else if (word == "binary_little_endian")
      encoding_ = Encoding::little;
    else if (word == "binary_big_endian")
      encoding_ = Encoding::big;
    else
      return false;
    return true;
  }

  bool take_element(Words& words) {
    Element element;
    element.name = std::string(words.next());
    const auto count = words.number();
    if (!count || !(*count >= 0) || *count > 2e9 || *count != double(std::uint64_t(*count))) return false;
    element.count = std::uint64_t(*count);
    elements_.push_back(std::move(element));
    return true;
  }

  bool take_property(Words& words) {
    if (elements_.empty()) return false;
    Property property;
    std::string_view word = words.next();
    if (word == "list") {
      property.count = type_named(words.next());
      if (!property.count || property.count->is_real) return false;
      word = words.next();
    }
    const auto type = type_named(word);
    if (!type) return false;
    property.type = *type;
    property.name = std::string(words.next());
    elements_.back().properties.push_back(std::move(property));
    return true;
  }

  /// Rows without a property would cost no bytes: an element of them may have any count.
  Result<void> check_header() {
    for (const Element& element : elements_)
      if (element.count > 0 && element.properties.empty())
        return unreadable("its element " + element.name + " has no property");
    return {};
  }

  Result<void> read_row(const Element& element, std::uint64_t row, Body& body) {
    const auto truncated = [&]() {
      return fail("read.truncated",
                  "the file ends (or has no number) at " + element.name + " " + std::to_string(row + 1) +
                      " of " + std::to_string(element.count),
                  "export the file again", name_);
    };
    Vec3 point;
    std::vector<Index> polygon;
    for (const Property& property : element.properties) {
      std::uint64_t count = 1;
      if (property.count) {
        const auto given = body.next(*property.count);
        if (!given) return truncated();
        if (!(*given >= 0 && *given < 1e9))
          return unreadable(element.name + " " + std::to_string(row + 1) +
                            " has a list of a length that cannot be");
        count = std::uint64_t(*given);
      }
      for (std::uint64_t k = 0; k < count; ++k) {
        const auto value = body.next(property.type);
        if (!value) return truncated();
        if (property.name == "x") point.x = *value;
        if (property.name == "y") point.y = *value;
        if (property.name == "z") point.z = *value;
        if (!property.name.starts_with("vertex_ind")) continue;
        if (!(*value >= 0) || *value >= double(points_.size()) || element.name != "face")
          return unreadable(element.name + " " + std::to_string(row + 1) + " has a vertex that is not there");
        polygon.push_back(Index(*value));
      }
    }
    if (element.name == "vertex") points_.push_back(point);
    if (polygon.size() >= 3) cut_polygon(points_, polygon, facets_);
    return {};
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
  Encoding encoding_ = Encoding::ascii;
  std::vector<Element> elements_;
  std::vector<Vec3> points_;
  LooseFacets facets_;
};

}  // namespace

Result<LooseFacets> parse_ply(const std::string& bytes, const std::string& name) {
  return PlyParser(bytes, name).run();
}

}  // namespace beadmesh
