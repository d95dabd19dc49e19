#include "beadmesh/geometry/predicates.h"

#include <algorithm>
#include <utility>

namespace beadmesh {
namespace {

// An expansion is a sum of doubles of increasing magnitude whose bits do not overlap; it holds the exact
// value and the sign of its last term is the sign of the whole. Zeros are left out, 0 is the empty expansion.
template <int capacity>
struct Expansion {
  double term[capacity];
  int size = 0;

  void push(double t) {
    if (t != 0) term[size++] = t;
  }
  double estimate() const { return size ? term[size - 1] : 0; }
};

struct Pair {
  double high, low;
};

Pair two_sum(double a, double b) {
  const double sum = a + b, b_part = sum - a, a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

// |a| >= |b| or a == 0.
Pair fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// Halves of the significand (Veltkamp), each of at most 26 bits.
Pair split(double a) {
  const double big = a * 0x1.0000002p27;
  const double high = big - (big - a);
  return {high, a - high};
}

Pair two_product(double a, Pair a_halves, double b, Pair b_halves) {
  const double product = a * b;
  const double rest = ((product - a_halves.high * b_halves.high) - a_halves.low * b_halves.high) -
                      a_halves.high * b_halves.low;
  return {product, a_halves.low * b_halves.low - rest};
}

Expansion<2> difference(double a, double b) {
  const Pair d = two_sum(a, -b);
  Expansion<2> e;
  e.push(d.low);
  e.push(d.high);
  return e;
}

// Shewchuk's fast expansion sum: merge by magnitude, then carry upwards.
template <int m, int n>
Expansion<m + n> operator+(const Expansion<m>& e, const Expansion<n>& f) {
  Expansion<m + n> h;
  int i = 0, j = 0;
  const auto smallest = [&] {
    if (j == f.size || (i < e.size && std::abs(e.term[i]) <= std::abs(f.term[j]))) return e.term[i++];
    return f.term[j++];
  };
  const int count = e.size + f.size;
  if (count == 0) return h;
  double carry = smallest();
  for (int k = 1; k < count; ++k) {
    const Pair s = two_sum(carry, smallest());
    h.push(s.low);
    carry = s.high;
  }
  h.push(carry);
  return h;
}

template <int m>
Expansion<m> operator-(Expansion<m> e) {
  for (int i = 0; i < e.size; ++i) e.term[i] = -e.term[i];
  return e;
}

template <int m>
void scale(const Expansion<m>& e, double b, Expansion<2 * m>& h) {
  h.size = 0;
  if (e.size == 0) return;
  const Pair halves = split(b);
  Pair q = two_product(e.term[0], split(e.term[0]), b, halves);
  h.push(q.low);
  for (int i = 1; i < e.size; ++i) {
    const Pair p = two_product(e.term[i], split(e.term[i]), b, halves);
    const Pair s = two_sum(q.high, p.low);
    h.push(s.low);
    q = fast_two_sum(p.high, s.high);
    h.push(q.low);
  }
  h.push(q.high);
}

template <int m, int n>
Expansion<2 * m * n> operator*(const Expansion<m>& e, const Expansion<n>& f) {
  Expansion<2 * m * n> h;
  Expansion<2 * m> row;
  for (int j = 0; j < f.size; ++j) {
    scale(e, f.term[j], row);
    const auto sum = h + row;  // has at most 2 * m * (j + 1) terms
    h.size = sum.size;
    std::copy_n(sum.term, sum.size, h.term);
  }
  return h;
}

// Between the smaller and the larger of two collinear points' ends, ends excluded.
bool is_strictly_between(Vec2 p, Vec2 a, Vec2 b) {
  const auto key = [](Vec2 v) { return std::pair(v.x, v.y); };
  return std::min(key(a), key(b)) < key(p) && key(p) < std::max(key(a), key(b));
}

SegmentContact collinear_contact(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const bool same = (a == c && b == d) || (a == d && b == c);
  if (same || is_strictly_between(a, c, d) || is_strictly_between(b, c, d) || is_strictly_between(c, a, b) ||
      is_strictly_between(d, a, b))
    return SegmentContact::overlapping;
  const bool shared = a == c || a == d || b == c || b == d;
  if (!shared) return SegmentContact::none;
  return a == b || c == d ? SegmentContact::overlapping : SegmentContact::endpoint;
}

int sign(double v) {
  return (v > 0) - (v < 0);
}

}  // namespace

namespace exact {

double orient2d(Vec2 a, Vec2 b, Vec2 c) {
  const auto acx = difference(a.x, c.x), acy = difference(a.y, c.y);
  const auto bcx = difference(b.x, c.x), bcy = difference(b.y, c.y);
  return (acx * bcy + -(acy * bcx)).estimate();
}

double incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto adx = difference(a.x, d.x), ady = difference(a.y, d.y);
  const auto bdx = difference(b.x, d.x), bdy = difference(b.y, d.y);
  const auto cdx = difference(c.x, d.x), cdy = difference(c.y, d.y);
  const auto bc = bdx * cdy + -(cdx * bdy);
  const auto ca = cdx * ady + -(adx * cdy);
  const auto ab = adx * bdy + -(bdx * ady);
  const auto first = (adx * adx + ady * ady) * bc;
  const auto second = (bdx * bdx + bdy * bdy) * ca;
  const auto third = (cdx * cdx + cdy * cdy) * ab;
  return (first + second + third).estimate();
}

}  // namespace exact

bool is_in_exact_range(Vec2 p) {
  const auto fits = [](double c) {
    return c == 0 || (std::abs(c) >= least_coordinate && std::abs(c) <= greatest_coordinate);
  };
  return fits(p.x) && fits(p.y);
}

SegmentContact segment_contact(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const int sc = sign(orient2d(a, b, c)), sd = sign(orient2d(a, b, d));
  if (sc * sd > 0) return SegmentContact::none;
  const int sa = sign(orient2d(c, d, a)), sb = sign(orient2d(c, d, b));
  if (sa * sb > 0) return SegmentContact::none;
  if (sc == 0 && sd == 0 && sa == 0 && sb == 0) return collinear_contact(a, b, c, d);
  if (sa * sb < 0 && sc * sd < 0) return SegmentContact::crossing;
  const bool shared = a == c || a == d || b == c || b == d;
  return shared ? SegmentContact::endpoint : SegmentContact::touching;
}

}  // namespace beadmesh
