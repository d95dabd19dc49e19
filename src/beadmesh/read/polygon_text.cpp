#include "beadmesh/read/polygon_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace beadmesh::read {
namespace {

template <class Number>
tl::expected<Number, std::string> number(std::string_view text) {
  const std::string_view all = text;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument)
    return tl::unexpected(quoted(all) + " is no number");
  if (error != std::errc{}) return tl::unexpected(quoted(all) + " is too large or too small");
  return value;
}

}  // namespace

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string quoted(std::string_view text) {
  std::string result(text.substr(0, 40));
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + result + (text.size() > 40 ? "...'" : "'");
}

tl::expected<double, std::string> coordinate(std::string_view text) {
  return number<double>(text);
}

tl::expected<Index, std::string> whole_number(std::string_view text) {
  return number<Index>(text);
}

}  // namespace beadmesh::read
