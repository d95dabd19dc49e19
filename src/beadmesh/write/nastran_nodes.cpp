#include "beadmesh/write/nastran_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <vector>

namespace beadmesh {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The first field, in capitals and without its star, empty where the line continues a card; the data fields
/// of the line are appended.
std::string split(std::string_view line, std::vector<std::string_view>& fields) {
  line = line.substr(0, line.find('$'));
  const size_t comma = line.find(',');
  const std::string_view head = trimmed(line.substr(0, std::min<size_t>(comma, 8)));
  const bool large = head.find('*') != std::string_view::npos;
  for (size_t k = 0, at = comma; k < (large ? 4 : 8); ++k) {
    if (comma == std::string_view::npos) {
      const size_t width = large ? 16 : 8, from = 8 + width * k;
      fields.push_back(from < line.size() ? trimmed(line.substr(from, width)) : std::string_view{});
      continue;
    }
    const size_t next = at == std::string_view::npos ? at : line.find(',', at + 1);
    fields.push_back(at == std::string_view::npos ? std::string_view{}
                                                  : trimmed(line.substr(at + 1, next - at - 1)));
    at = next;
  }
  const bool continues = !head.empty() && (head.front() == '*' || head.front() == '+');
  std::string name(continues ? head.substr(0, 0) : head.substr(0, head.find_first_of("* ")));
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

/// A length in 16 columns with a decimal point.
std::string coordinate(double value) {
  const double size = std::abs(value);
  return fmt::format(fmt::runtime(size < 1e5   ? "{:.8f}"
                                  : size < 1e7 ? "{:.6f}"
                                               : "{:.8e}"),
                     size < 5e-9 ? 0.0 : value);
}

/// Fields: id, cp, x, y, z, cd, ps, seid.
std::string card(const std::vector<std::string_view>& fields, Vec3 place) {
  const auto field = [&](size_t k) { return k < fields.size() ? fields[k] : std::string_view{}; };
  return fmt::format("GRID*   {:>16}{:>16}{:>16}{:>16}*\n*       {:>16}{:>16}{:>16}{:>16}\n", field(0),
                     field(1), coordinate(place.x), coordinate(place.y), coordinate(place.z), field(5),
                     field(6), field(7));
}

/// One line after the other, with the line break.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}
  bool at_end() const { return at_ >= text_.size(); }
  std::string_view peek() const {
    const size_t end = text_.find('\n', at_);
    return text_.substr(at_, end == std::string_view::npos ? end : end + 1 - at_);
  }
  std::string_view next() {
    const std::string_view line = peek();
    at_ += line.size();
    return line;
  }

 private:
  std::string_view text_;
  size_t at_ = 0;
};

bool is_comment(std::string_view line) {
  return trimmed(line.substr(0, line.find('$'))).empty();
}

/// Takes the rest of the card off the lines. Comments inside it go to `out`; those that follow it are
/// returned.
std::string take_continuations(Lines& lines, std::vector<std::string_view>& fields, std::string& out) {
  std::string comments;
  while (!lines.at_end()) {
    const std::string_view line = lines.peek();
    std::vector<std::string_view> more;
    if (is_comment(line)) {
      comments += line;
    } else if (split(line, more).empty()) {
      fields.insert(fields.end(), more.begin(), more.end());
      out += comments;
      comments.clear();
    } else {
      break;
    }
    lines.next();
  }
  return comments;
}

}  // namespace

std::string with_moved_nodes(std::string_view deck, const std::map<Index, Vec3>& places) {
  std::string out;
  out.reserve(deck.size());
  Lines lines(deck);
  while (!lines.at_end()) {
    const std::string_view line = lines.next();
    std::vector<std::string_view> fields;
    Index id = 0;
    if (split(line, fields) == "GRID")
      std::from_chars(fields[0].data(), fields[0].data() + fields[0].size(), id);
    const auto place = places.find(id);
    if (id == 0 || place == places.end()) {
      out += line;
      continue;
    }
    const std::string comments = take_continuations(lines, fields, out);
    out += card(fields, place->second) + comments;
  }
  return out;
}

}  // namespace beadmesh
