#include "batch/sha256.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <vector>

namespace beadmesh::app {
namespace {

using Word = std::uint32_t;
constexpr size_t block_size = 64;

/// The first 32 bits of the fractional part of a root.
Word fraction_of(long double root) {
  return static_cast<Word>((root - std::floor(root)) * 4294967296.0L);
}

/// Square roots of the first 8 primes start the state, cube roots of the first 64 are the rounds' constants.
struct Constants {
  std::array<Word, 8> start{};
  std::array<Word, 64> round{};

  Constants() {
    size_t found = 0;
    for (int n = 2; found < round.size(); ++n) {
      bool prime = true;
      for (int d = 2; d * d <= n; ++d) prime &= n % d != 0;
      if (!prime) continue;
      if (found < start.size()) start[found] = fraction_of(std::sqrt(static_cast<long double>(n)));
      round[found++] = fraction_of(std::cbrt(static_cast<long double>(n)));
    }
  }
};

const Constants constants;

class Digest {
 public:
  void add(const char* bytes, size_t count) {
    length_ += count;
    for (size_t i = 0; i < count; ++i) {
      block_[filled_++] = static_cast<unsigned char>(bytes[i]);
      if (filled_ == block_size) mix();
    }
  }

  std::string finish() {
    const std::uint64_t bits = 8 * length_;
    const char one = '\x80', zero = 0;
    add(&one, 1);
    while (filled_ != block_size - 8) add(&zero, 1);
    for (int shift = 56; shift >= 0; shift -= 8) {
      const char byte = static_cast<char>(bits >> shift);
      add(&byte, 1);
    }
    std::string text;
    for (const Word word : state_) text += fmt::format("{:08x}", word);
    return text;
  }

 private:
  static Word mixed(Word x, int a, int b, int c) {
    return std::rotr(x, a) ^ std::rotr(x, b) ^ std::rotr(x, c);
  }

  /// One block into the state.
  void mix() {
    std::array<Word, 64> w{};
    for (size_t t = 0; t < 16; ++t)
      for (size_t k = 0; k < 4; ++k) w[t] = w[t] << 8 | block_[4 * t + k];
    for (size_t t = 16; t < 64; ++t) {
      const Word low = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ w[t - 15] >> 3;
      const Word high = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ w[t - 2] >> 10;
      w[t] = high + w[t - 7] + low + w[t - 16];
    }
    auto [a, b, c, d, e, f, g, h] = state_;
    for (size_t t = 0; t < 64; ++t) {
      const Word first = h + mixed(e, 6, 11, 25) + ((e & f) ^ (~e & g)) + constants.round[t] + w[t];
      const Word second = mixed(a, 2, 13, 22) + ((a & b) ^ (a & c) ^ (b & c));
      h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
    }
    const std::array<Word, 8> step{a, b, c, d, e, f, g, h};
    for (size_t i = 0; i < step.size(); ++i) state_[i] += step[i];
    filled_ = 0;
  }

  std::array<Word, 8> state_ = constants.start;
  std::array<unsigned char, block_size> block_{};
  size_t filled_ = 0;
  std::uint64_t length_ = 0;
};

}  // namespace

std::string sha256(std::string_view text) {
  Digest digest;
  digest.add(text.data(), text.size());
  return digest.finish();
}

std::optional<std::string> sha256_of_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::ifstream in(path, std::ios::binary);
  if (!in) return {};
  Digest digest;
  std::vector<char> buffer(1 << 16);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0)
    digest.add(buffer.data(), static_cast<size_t>(in.gcount()));
  if (in.bad()) return {};
  return digest.finish();
}

}  // namespace beadmesh::app
