#include "beadmesh/read/wkt_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "beadmesh/read/curve_rings.h"
#include "beadmesh/read/polygon_text.h"

namespace beadmesh::read {
namespace {

constexpr std::array dimensions{"z", "m", "zm"};

bool is_dimension(const std::string& word) {
  return std::find(dimensions.begin(), dimensions.end(), word) != dimensions.end();
}

// Words, numbers and punctuation of WKT, with the line they are on.
class WktParser {
 public:
  explicit WktParser(std::string_view text) : text_(text) {}

  Result<PlanarRegion> region() {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // byte order mark of UTF-8
    if (auto done = skip_reference_system(); !done) return Failure(done.error());
    const std::string_view found = word();
    const std::string kind = keyword(found);
    if (kind != "polygon" && kind != "curvepolygon" && kind != "multipolygon")
      return failure(found.empty() ? "POLYGON expected" : "POLYGON expected, not " + quoted(found));
    if (is_next("empty")) return failure("the polygon is empty");
    Result<PlanarRegion> region = kind == "multipolygon"   ? only_polygon()
                                  : kind == "curvepolygon" ? curve_polygon()
                                                           : polygon();
    if (!region) return region;
    take(';');
    skip_space();
    if (at_ < text_.size())
      return failure("text after the end of the polygon; a file holds one polygon", word());
    return region;
  }

 private:
  // "SRID=4326;", as PostGIS writes it.
  Result<void> skip_reference_system() {
    const std::size_t start = at_;
    if (!lower_case(word()).starts_with("srid="))
      at_ = start, line_ = 1;
    else if (!take(';'))
      return failure("';' expected after SRID");
    return {};
  }

  Result<PlanarRegion> only_polygon();
  Result<PlanarRegion> polygon();
  Result<PlanarRegion> curve_polygon();
  Result<Ring> curve_ring();
  Result<void> add_piece(Ring& ring, bool arcs);
  Result<std::vector<Vec2>> points();
  Result<Vec2> point();
  Result<void> start_loop();

  // The word in small letters without the letters Z and M; they may also follow it as a word of their own.
  std::string keyword(std::string_view written);
  bool is_next(const char* expected);
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
  Failure failure(std::string message, std::string_view found = {}) const {
    if (!found.empty()) message += ": " + quoted(found);
    return fail("read.wkt.syntax", std::move(message), {}, fmt::format("line {}", line_));
  }
  Failure point_failure(const std::string& message) const {
    return failure(fmt::format("point {} of loop {}: {}", point_, loop_, message));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int loop_ = 0, point_ = 0;     // the last ones that were begun, from 1
  std::size_t coordinates_ = 0;  // of every point; 0: not known yet
};

std::string WktParser::keyword(std::string_view written) {
  std::string name = lower_case(written);
  const auto names = [&](const char* kind) { return name.starts_with(kind); };
  std::string dimension;
  for (const char* kind :
       {"polygon", "curvepolygon", "multipolygon", "circularstring", "compoundcurve", "linestring"})
    if (names(kind) && is_dimension(name.substr(std::string_view(kind).size()))) {
      dimension = name.substr(std::string_view(kind).size());
      name = kind;
    }
  if (dimension.empty()) {
    const std::size_t start = at_;
    const int line = line_;
    dimension = lower_case(word());
    if (!is_dimension(dimension)) at_ = start, line_ = line, dimension.clear();
  }
  if (!dimension.empty() && coordinates_ == 0) coordinates_ = 2 + dimension.size();
  return name;
}

bool WktParser::is_next(const char* expected) {
  const std::size_t start = at_;
  const int line = line_;
  if (lower_case(word()) == expected) return true;
  at_ = start, line_ = line;
  return false;
}

Result<PlanarRegion> WktParser::only_polygon() {
  if (!take('(')) return failure("'(' expected after MULTIPOLYGON");
  Result<PlanarRegion> region = polygon();
  if (!region) return region;
  if (take(',')) return failure("a MULTIPOLYGON of several polygons; a file holds one polygon");
  if (!take(')')) return failure("')' expected after the polygon");
  return region;
}

Result<PlanarRegion> WktParser::polygon() {
  if (!take('(')) return failure("'(' expected after POLYGON");
  PlanarRegion region;
  do {
    if (auto done = start_loop(); !done) return Failure(done.error());
    auto ring = points();
    if (!ring) return Failure(ring.error());
    if (ring->size() > 1 && ring->front() == ring->back()) ring->pop_back();
    region.loops.push_back({std::move(*ring), {}, {}, {}});
  } while (take(','));
  if (!take(')')) return failure("',' or ')' expected after a loop");
  return checked_region(std::move(region));
}

Result<PlanarRegion> WktParser::curve_polygon() {
  if (!take('(')) return failure("'(' expected after CURVEPOLYGON");
  std::vector<Ring> rings;
  do {
    if (auto done = start_loop(); !done) return Failure(done.error());
    auto ring = curve_ring();
    if (!ring) return Failure(ring.error());
    rings.push_back(std::move(*ring));
  } while (take(','));
  if (!take(')')) return failure("',' or ')' expected after a loop");
  return region_of_rings(rings);
}

Result<void> WktParser::start_loop() {
  ++loop_;
  point_ = 0;
  if (is_next("empty")) return failure(fmt::format("loop {} is empty", loop_));
  return {};
}

// A list of points, CIRCULARSTRING, or COMPOUNDCURVE of both.
Result<Ring> WktParser::curve_ring() {
  const std::string_view written = word();
  const std::string kind = keyword(written);
  Ring ring;
  if (kind == "compoundcurve") {
    if (!take('(')) return failure("'(' expected after COMPOUNDCURVE");
    do {
      const std::string_view part = word();
      const std::string part_kind = keyword(part);
      if (!part.empty() && part_kind != "circularstring" && part_kind != "linestring")
        return failure("CIRCULARSTRING, LINESTRING or '(' expected, not " + quoted(part));
      if (auto done = add_piece(ring, part_kind == "circularstring"); !done) return Failure(done.error());
    } while (take(','));
    if (!take(')')) return failure("',' or ')' expected after a part of COMPOUNDCURVE");
  } else if (written.empty() || kind == "circularstring" || kind == "linestring") {
    if (auto done = add_piece(ring, kind == "circularstring"); !done) return Failure(done.error());
  } else {
    return failure("CIRCULARSTRING, COMPOUNDCURVE or '(' expected, not " + quoted(written));
  }
  if (ring.front().start != ring.back().end)
    return failure(fmt::format("loop {} is open: its last point, point {}, is not its first", loop_, point_));
  return ring;
}

// Points are counted as they are written, also those that close a part and open the next one.
Result<void> WktParser::add_piece(Ring& ring, bool arcs) {
  const int before = point_;
  const auto found = points();
  if (!found) return Failure(found.error());
  const std::vector<Vec2>& p = *found;
  if (!ring.empty() && p.front() != ring.back().end)
    return failure(fmt::format("point {} of loop {} starts a part, but the part before ends elsewhere",
                               before + 1, loop_));
  if (arcs && (p.size() < 3 || p.size() % 2 == 0))
    return failure(
        fmt::format("loop {}: a CIRCULARSTRING needs 3, 5, 7, ... points, not {}", loop_, p.size()));
  if (p.size() < 2) return failure(fmt::format("loop {}: a line needs two points", loop_));
  const std::size_t step = arcs ? 2 : 1;
  for (std::size_t i = 0; i + step < p.size(); i += step) {
    RingPiece piece{p[i], p[i + 1], p[i + step], arcs, before + static_cast<int>(i) + 1};
    ring.push_back(piece);
  }
  return {};
}

Result<std::vector<Vec2>> WktParser::points() {
  std::vector<Vec2> result;
  if (!take('(')) return failure(fmt::format("'(' expected at the start of loop {}", loop_));
  do {
    ++point_;
    const auto p = point();
    if (!p) return Failure(p.error());
    result.push_back(*p);
  } while (take(','));
  if (!take(')')) return failure(fmt::format("',' or ')' expected after point {} of loop {}", point_, loop_));
  return result;
}

Result<Vec2> WktParser::point() {
  std::array<double, 4> values{};
  std::size_t count = 0;
  for (std::string_view text = word(); !text.empty(); text = word()) {
    const auto value = coordinate(text);
    if (!value) return point_failure(value.error());
    if (count == values.size()) return point_failure("more than four coordinates");
    values[count++] = *value;
  }
  if (count < 2) return point_failure("two coordinates expected");
  if (coordinates_ == 0) coordinates_ = count;
  if (count != coordinates_)
    return point_failure(
        fmt::format("{} coordinates, but {} are announced or before it", count, coordinates_));
  return Vec2{values[0], values[1]};
}

}  // namespace

Result<PlanarRegion> wkt_region(std::string_view text) {
  return WktParser(text).region();
}

}  // namespace beadmesh::read
