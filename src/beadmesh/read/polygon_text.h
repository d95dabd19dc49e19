// Inside the read room: words and numbers of the text formats of plane polygons.
#pragma once

#include <string>
#include <string_view>

#include "beadmesh/core/result.h"
#include "beadmesh/core/vector.h"

namespace beadmesh::read {

bool is_space(char c);
std::string lower_case(std::string_view text);
/// As it may stand in a message: at most 40 characters, what cannot be printed as '?'.
std::string quoted(std::string_view text);

/// The number that is all of `text` (a sign in front is allowed, also nan and inf), or what is wrong with it
/// in words.
tl::expected<double, std::string> coordinate(std::string_view text);
tl::expected<Index, std::string> whole_number(std::string_view text);

}  // namespace beadmesh::read
