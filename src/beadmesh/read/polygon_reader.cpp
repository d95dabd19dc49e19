#include "beadmesh/read/polygon_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beadmesh {
namespace {

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

// The number that is all of `text`.
template <class Number>
std::optional<Number> number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

// Words, numbers and punctuation of WKT, with the line they are on.
class WktParser {
 public:
  explicit WktParser(std::string_view text) : text_(text) {}

  Result<PlanarRegion> polygon() {
    if (lower_case(word()) != "polygon") return failure("POLYGON expected");
    skip_space();
    const std::string dimension = lower_case(word());
    if (dimension == "empty") return failure("the polygon is empty");
    if (!dimension.empty() && dimension != "z" && dimension != "m" && dimension != "zm")
      return failure("'(' expected after POLYGON");
    PlanarRegion region;
    if (!take('(')) return failure("'(' expected");
    do {
      auto points = ring();
      if (!points) return Failure(points.error());
      region.loops.push_back({std::move(*points), {}, {}});
    } while (take(','));
    if (!take(')')) return failure("',' or ')' expected after a ring");
    take(';');
    skip_space();
    if (at_ < text_.size()) return failure("text after the end of the polygon");
    return region;
  }

 private:
  Result<std::vector<Vec2>> ring() {
    std::vector<Vec2> points;
    if (!take('(')) return failure("'(' expected at the start of a ring");
    do {
      std::vector<double> coordinates;
      for (std::string_view text = word(); !text.empty(); text = word()) {
        const auto value = number<double>(text);
        if (!value) return failure("'" + std::string(text.substr(0, 40)) + "' is no number");
        coordinates.push_back(*value);
      }
      if (coordinates.size() < 2 || coordinates.size() > 4) return failure("a point needs two coordinates");
      points.push_back({coordinates[0], coordinates[1]});
    } while (take(','));
    if (!take(')')) return failure("',' or ')' expected after a point");
    if (points.size() > 1 && points.front() == points.back()) points.pop_back();
    return points;
  }

  void skip_space() {
    for (; at_ < text_.size() && is_space(text_[at_]); ++at_) line_ += text_[at_] == '\n';
  }
  bool take(char c) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string_view word() {
    skip_space();
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_space(text_[at_]) &&
           std::string_view("(),;").find(text_[at_]) == text_.npos)
      ++at_;
    return text_.substr(start, at_ - start);
  }
  Failure failure(std::string message) const {
    return fail("read.wkt.syntax", std::move(message), {}, "line " + std::to_string(line_));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

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
    const auto count = number<Index>(lines_[next_++].words[0]);
    if (!count || *count < 0) return failure(std::string("the number of ") + name + " expected");
    if (static_cast<std::size_t>(*count) > lines_.size() - next_) {
      next_ = lines_.size();
      return failure("the file ends before the " + std::to_string(*count) + " " + name +
                     " that are announced");
    }
    return *count;
  }
  template <class Number>
  std::optional<Number> word(const Line& line, std::size_t i) const {
    return i < line.words.size() ? number<Number>(line.words[i]) : std::nullopt;
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
};

Result<void> PolyParser::read_vertices() {
  const auto count = section("vertices");
  if (!count) return Failure(count.error());
  if (*count == 0) return failure("there are no vertices (those of a separate .node file are not read)");
  if (lines_[next_ - 1].words.size() > 1 && lines_[next_ - 1].words[1] != "2")
    return failure("the dimension must be 2");
  for (Index i = 0; i < *count; ++i) {
    const Line& line = lines_[next_++];
    const auto number = word<Index>(line, 0);
    const auto x = word<double>(line, 1), y = word<double>(line, 2);
    if (!number || !x || !y) return failure("a vertex must be: number x y");
    if (i == 0) first_number_ = *number;
    if ((first_number_ != 0 && first_number_ != 1) || *number != first_number_ + i)
      return failure("vertices must be numbered one after the other from 0 or 1");
    vertices_.push_back({{*x, *y}, {no_index, no_index}, line.number, false});
  }
  return {};
}

Result<void> PolyParser::read_segments() {
  const auto count = section("segments");
  if (!count) return Failure(count.error());
  for (Index i = 0; i < *count; ++i) {
    const Line& line = lines_[next_++];
    const auto a = word<Index>(line, 1), b = word<Index>(line, 2);
    if (!word<Index>(line, 0) || !a || !b) return failure("a segment must be: number vertex vertex");
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
    if (!word<Index>(line, 0) || !word<double>(line, 1) || !word<double>(line, 2))
      return failure("a hole must be: number x y");
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
    Index previous = no_index, v = static_cast<Index>(start);
    do {
      vertices_[v].visited = true;
      loop.points.push_back(vertices_[v].point);
      const auto& [first, second] = vertices_[v].neighbours;
      const Index next = first != previous ? first : second;
      previous = std::exchange(v, next);
    } while (v != static_cast<Index>(start));
  }
  return region;
}

Result<PlanarRegion> checked(Result<PlanarRegion> region) {
  return region ? checked_region(std::move(*region)) : std::move(region);
}

}  // namespace

Result<PlanarRegion> parse_wkt(std::string_view text) {
  return checked(WktParser(text).polygon());
}

Result<PlanarRegion> parse_poly(std::string_view text) {
  return checked(PolyParser(text).region());
}

Result<PlanarRegion> read_polygon(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  const auto failure = [&](const char* code, const char* message) {
    return fail(code, message, {}, path.string());
  };
  if (ending != ".wkt" && ending != ".poly")
    return failure("read.ending", "a plane polygon ends in .wkt or .poly");
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return failure("read.not_found", "there is no such file");
  if (std::filesystem::is_directory(path, error)) return failure("read.directory", "this is a directory");
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) return failure("read.unreadable", "the file cannot be read");
  if (std::all_of(text.begin(), text.end(), is_space)) return failure("read.empty", "the file is empty");
  auto region = ending == ".wkt" ? parse_wkt(text) : parse_poly(text);
  if (!region) {
    Diagnostic& diagnostic = region.error();
    diagnostic.entity =
        path.filename().string() + (diagnostic.entity.empty() ? "" : ", " + diagnostic.entity);
  }
  return region;
}

}  // namespace beadmesh
