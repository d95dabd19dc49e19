#include "beadmesh/read/obj_reader.h"

#include <optional>
#include <string_view>
#include <vector>

#include "beadmesh/read/polygon_cutting.h"
#include "beadmesh/read/words.h"

namespace beadmesh {
namespace {

/// "7", "7/1", "7//3", "-1": a vertex counted from 1, or back from the last. Row of it, or no_index.
Index row_of(std::string_view word, std::size_t count) {
  const std::string_view number = word.substr(0, word.find('/'));
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || end != number.data() + number.size()) return no_index;
  const std::int64_t row = value > 0 ? value - 1 : value + std::int64_t(count);
  return value == 0 || row < 0 || row >= std::int64_t(count) ? no_index : Index(row);
}

class ObjParser {
 public:
  ObjParser(const std::string& bytes, const std::string& name) : text_(bytes), name_(name) {}

  Result<LooseFacets> run() {
    if (text_.find('\0') != std::string_view::npos)
      return fail("read.unreadable", "the file is not a text file", {}, name_);
    for (std::string line; next_line(line);) {
      Words words(line);
      const std::string_view what = words.next();
      const bool good = what == "v" ? take_vertex(words) : what == "f" ? take_face(words) : true;
      if (!good)
        return fail("read.unreadable", "line " + std::to_string(line_) + ": " + problem_,
                    "export the file again", name_);
    }
    return std::move(facets_);
  }

 private:
  /// A line that ends in a backslash goes on in the next.
  bool next_line(std::string& line) {
    if (at_ >= text_.size()) return false;
    line.clear();
    for (bool more = true; more && at_ < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      line += text_.substr(at_, end - at_);
      at_ = end + 1;
      ++line_;
      if (!line.empty() && line.back() == '\r') line.pop_back();
      more = !line.empty() && line.back() == '\\';
      if (more) line.back() = ' ';
    }
    line.resize(std::min(line.find('#'), line.size()));
    return true;
  }

  bool take_vertex(Words& words) {
    const auto x = words.number(), y = words.number(), z = words.number();
    problem_ = "a vertex that is no point";
    if (!x || !y || !z) return false;
    points_.push_back({*x, *y, *z});
    return true;
  }

  bool take_face(Words& words) {
    std::vector<Index> polygon;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      polygon.push_back(row_of(word, points_.size()));
      problem_ = "the face has a vertex that is not there";
      if (polygon.back() == no_index) return false;
    }
    problem_ = "the face has fewer than three vertices";
    if (polygon.size() < 3) return false;
    cut_polygon(points_, polygon, facets_);
    return true;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 0;
  const char* problem_ = "";
  std::vector<Vec3> points_;
  LooseFacets facets_;
};

}  // namespace

Result<LooseFacets> parse_obj(const std::string& bytes, const std::string& name) {
  return ObjParser(bytes, name).run();
}

}  // namespace beadmesh
