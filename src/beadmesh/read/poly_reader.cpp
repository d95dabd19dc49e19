#include "beadmesh/read/poly_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "beadmesh/read/polygon_text.h"

namespace beadmesh::read {
namespace {

// The lines of a .poly file that say something, as words.
class PolyParser {
 public:
  explicit PolyParser(std::string_view text) {
    for (int number = 1; !text.empty(); ++number) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      add_line(text.substr(0, end), number);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  Result<PlanarRegion> region() {
    for (const auto step : {&PolyParser::read_vertices, &PolyParser::read_segments, &PolyParser::read_holes})
      if (auto done = (this->*step)(); !done) return Failure(done.error());
    return closed_loops();
  }

 private:
  struct Line {
    int number;
    std::vector<std::string_view> words;
  };
  struct Vertex {
    Vec2 point;
    std::array<Index, 2> neighbours{no_index, no_index};
    int line = 0;
    bool visited = false;
  };

  void add_line(std::string_view text, int number) {
    text = text.substr(0, text.find('#'));
    Line line{number, {}};
    for (std::size_t i = 0; i < text.size();) {
      if (is_space(text[i])) {
        ++i;
        continue;
      }
      const std::size_t start = i;
      while (i < text.size() && !is_space(text[i])) ++i;
      line.words.push_back(text.substr(start, i - start));
    }
    if (!line.words.empty()) lines_.push_back(std::move(line));
  }

  // The number of lines of a section, from its first line.
  Result<Index> section(const char* name) {
    if (next_ == lines_.size()) return failure(std::string("the section of ") + name + " is missing");
    const auto count = whole_number(lines_[next_++].words[0]);
    if (!count || *count < 0) return failure(std::string("the number of ") + name + " expected");
    if (static_cast<std::size_t>(*count) > lines_.size() - next_) {
      next_ = lines_.size();
      return failure("the file ends before the " + std::to_string(*count) + " " + name +
                     " that are announced");
    }
    return *count;
  }
  static std::optional<Index> index(const Line& line, std::size_t i) {
    const auto value = i < line.words.size() ? whole_number(line.words[i]) : tl::unexpected(std::string());
    return value ? std::optional(*value) : std::nullopt;
  }
  // Fails with what is wrong in words.
  static tl::expected<double, std::string> number(const Line& line, std::size_t i) {
    return i < line.words.size() ? coordinate(line.words[i]) : tl::unexpected(std::string());
  }

  Result<void> read_vertices();
  Result<void> read_segments();
  Result<void> read_holes();
  Result<void> connect(Index a, Index b);
  Result<PlanarRegion> closed_loops();
  /// About the line that was read last.
  Failure failure(std::string message, const char* code = "read.poly.syntax") const {
    const int line = next_ > 0 ? lines_[next_ - 1].number : 1;
    return fail(code, std::move(message), {}, "line " + std::to_string(line));
  }

  std::vector<Line> lines_;
  std::size_t next_ = 0;
  Index first_number_ = 0;  // of the vertices
  std::vector<Vertex> vertices_;
  std::vector<std::vector<Index>> numbers_;  // per loop: the vertices as the file numbers them
};

Result<void> PolyParser::read_vertices() {
  const auto count = section("vertices");
  if (!count) return Failure(count.error());
  if (*count == 0) return failure("there are no vertices (those of a separate .node file are not read)");
  if (lines_[next_ - 1].words.size() > 1 && lines_[next_ - 1].words[1] != "2")
    return failure("the dimension must be 2");
  for (Index i = 0; i < *count; ++i) {
    const Line& line = lines_[next_++];
    const auto place = index(line, 0);
    const auto x = number(line, 1), y = number(line, 2);
    for (const auto& value : {x, y})
      if (!value && !value.error().empty()) return failure(value.error());
    if (!place || !x || !y) return failure("a vertex must be: number x y");
    if (i == 0) first_number_ = *place;
    if ((first_number_ != 0 && first_number_ != 1) || *place != first_number_ + i)
      return failure("vertices must be numbered one after the other from 0 or 1");
    vertices_.push_back({{*x, *y}, {no_index, no_index}, line.number, false});
  }
  return {};
}

Result<void> PolyParser::read_segments() {
  const auto count = section("segments");
  if (!count) return Failure(count.error());
  if (*count == 0) return failure("there are no segments");
  for (Index i = 0; i < *count; ++i) {
    const Line& line = lines_[next_++];
    const auto a = index(line, 1), b = index(line, 2);
    if (!index(line, 0) || !a || !b) return failure("a segment must be: number vertex vertex");
    if (auto done = connect(*a, *b); !done) return done;
  }
  return {};
}

Result<void> PolyParser::connect(Index a, Index b) {
  for (const Index i : {a, b})
    if (i < first_number_ || i - first_number_ >= static_cast<Index>(vertices_.size()))
      return failure("there is no vertex " + std::to_string(i));
  if (a == b) return failure("the segment has the same vertex twice", "read.poly.loop");
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    auto& [first, second] = vertices_[from - first_number_].neighbours;
    if (second != no_index || first == to - first_number_)
      return failure("vertex " + std::to_string(from) +
                         (second != no_index ? " has more than two segments" : " has a segment twice"),
                     "read.poly.loop");
    (first == no_index ? first : second) = to - first_number_;
  }
  return {};
}

Result<void> PolyParser::read_holes() {
  const auto count = section("holes");
  if (!count) return Failure(count.error());
  for (Index i = 0; i < *count; ++i) {
    const Line& line = lines_[next_++];
    if (!index(line, 0) || !number(line, 1) || !number(line, 2)) return failure("a hole must be: number x y");
  }
  return {};
}

Result<PlanarRegion> PolyParser::closed_loops() {
  PlanarRegion region;
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const auto& [first, second] = vertices_[v].neighbours;
    if ((first == no_index) != (second == no_index))
      return fail("read.poly.loop", "vertex " + std::to_string(v + first_number_) + " has only one segment",
                  {}, "line " + std::to_string(vertices_[v].line));
  }
  for (std::size_t start = 0; start < vertices_.size(); ++start) {
    if (vertices_[start].visited || vertices_[start].neighbours[0] == no_index) continue;
    PlanarLoop& loop = region.loops.emplace_back();
    std::vector<Index>& numbers = numbers_.emplace_back();
    Index previous = no_index, v = static_cast<Index>(start);
    do {
      vertices_[v].visited = true;
      loop.points.push_back(vertices_[v].point);
      numbers.push_back(v + first_number_);
      const auto& [first, second] = vertices_[v].neighbours;
      const Index next = first != previous ? first : second;
      previous = std::exchange(v, next);
    } while (v != static_cast<Index>(start));
  }
  return checked_region(std::move(region), [this](std::size_t loop, std::size_t point) {
    return "vertex " + std::to_string(numbers_[loop][point]);
  });
}

}  // namespace

Result<PlanarRegion> poly_region(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark of UTF-8
  return PolyParser(text).region();
}

}  // namespace beadmesh::read
