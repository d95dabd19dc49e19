// Private to this room: text that grows by formatted pieces.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>

namespace beadmesh::drawing {

/// What the pictures of this room are built on.
class SvgText {
 protected:
  template <class... Values>
  void put(fmt::format_string<Values...> format, const Values&... values) {
    fmt::vformat_to(std::back_inserter(out_), format, fmt::make_format_args(values...));
  }
  void put_text(std::string_view text) { out_.append(text); }
  std::string written() const { return fmt::to_string(out_); }

 private:
  fmt::memory_buffer out_;
};

}  // namespace beadmesh::drawing
