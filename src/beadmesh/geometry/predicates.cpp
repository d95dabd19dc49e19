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

// Twice the digits of a double, rounded; each operation errs by less than 2^-100 of the magnitudes that go
// in.
Pair rounded_product(Pair a, Pair b) {
  const Pair p = two_product(a.high, split(a.high), b.high, split(b.high));
  return fast_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

Pair rounded_sum(Pair a, Pair b) {
  const Pair high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const Pair sum = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(sum.high, sum.low + low.low);
}

Pair rounded_difference(Pair a, Pair b) {
  return rounded_sum(a, {-b.high, -b.low});
}

// What rounding can do to a determinant with operations of the above kind, a dozen of which follow each
// other, as a part of the sum of the absolute values of its terms.
constexpr double rounding_of_pairs = 0x1p-94;

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

// The determinant of `incircle` in pairs; 0 where its sign is in doubt.
double incircle_of_pairs(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  struct Row {
    Pair x, y, lift;
  };
  const auto row = [&](Vec2 p) {
    const Pair x = two_sum(p.x, -d.x), y = two_sum(p.y, -d.y);
    return Row{x, y, rounded_sum(rounded_product(x, x), rounded_product(y, y))};
  };
  double magnitude = 0;
  const auto term = [&](const Row& lifted, const Row& p, const Row& q) {
    const Pair left = rounded_product(p.x, q.y), right = rounded_product(q.x, p.y);
    magnitude += lifted.lift.high * (std::abs(left.high) + std::abs(right.high));
    return rounded_product(lifted.lift, rounded_difference(left, right));
  };
  const Row ra = row(a), rb = row(b), rc = row(c);
  const Pair determinant = rounded_sum(rounded_sum(term(ra, rb, rc), term(rb, rc, ra)), term(rc, ra, rb));
  return std::abs(determinant.high) > rounding_of_pairs * magnitude ? determinant.high : 0;
}

}  // namespace

namespace exact {

double orient2d(Vec2 a, Vec2 b, Vec2 c) {
  const Pair left = rounded_product(two_sum(a.x, -c.x), two_sum(b.y, -c.y));
  const Pair right = rounded_product(two_sum(a.y, -c.y), two_sum(b.x, -c.x));
  const Pair determinant = rounded_difference(left, right);
  const double magnitude = std::abs(left.high) + std::abs(right.high);
  if (std::abs(determinant.high) > rounding_of_pairs * magnitude) return determinant.high;
  const auto acx = difference(a.x, c.x), acy = difference(a.y, c.y);
  const auto bcx = difference(b.x, c.x), bcy = difference(b.y, c.y);
  return (acx * bcy + -(acy * bcx)).estimate();
}

double incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (const double determinant = incircle_of_pairs(a, b, c, d)) return determinant;
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
