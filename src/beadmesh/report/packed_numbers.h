// Internal to the room: numbers made small enough to lie in a page of text: differences, byte planes, zlib,
// base64.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace beadmesh {

/// What is packed: the numbers themselves, or each less the one a row before (small where neighbours are
/// alike).
enum class Packing { plain, differences };

/// Rows of `stride` whole numbers as text of letters, digits, '+', '/', '=': zigzag code, then column by
/// column byte by byte from the lowest on, compressed by zlib. `bytes` of each number are kept.
struct PackedNumbers {
  std::size_t rows = 0;
  int stride = 1, bytes = 1;
  Packing packing = Packing::plain;
  std::string text;
};

/// The size of `values` is a multiple of `stride`. Numbers and their differences wrap at 32 bits.
PackedNumbers packed(const std::vector<std::int32_t>& values, int stride = 1,
                     Packing packing = Packing::plain);

/// Inverse, for tests; empty where the text is no such text.
std::vector<std::int32_t> unpacked(const PackedNumbers& numbers);

/// Compressed by zlib, as base64.
std::string packed_text(const std::string& text);

std::string base64(std::string_view bytes);

}  // namespace beadmesh
