// On which side of a triangle does a point lie?   sign det[b - a, c - a, d - a], exactly.
//
// Points of a prepared set: every coordinate 0 or in [2^-280, 2). Differences are then multiples of 2^-332,
// and the products of three multiples of 2^-996: nothing underflows, flushed or not.
//
// There are three stages. P is the permanent, the sum of the magnitudes of the six products of three.
//   double           |error| <= (7 + 56 u) u P       [Shewchuk 1997, orient3d, bound A]
//   two doubles      |error| <= 2^-96 P              six operations of 2^-100 each on a product's way
//   expansions       exact.
// All coordinates are multiples of a grid step g, so a determinant is a multiple of g^3. If its magnitude is
// less than g^3 it is 0, which decides lattices and numbers of few bits without an expansion.
#pragma once

#include <algorithm>
#include <graze/detail/numeric/expansion.hpp>
#include <vector>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

inline constexpr double kLeastCoordinate = 0x1p-280, kCoordinateBound = 2;

class PointSet {
 public:
  // Points outside the range above make the set invalid, and no sign may be computed.
  explicit PointSet(std::vector<Vec3<double>> points) : points_(std::move(points)) {
    int step = 0;  // exponent of the grid step
    for (const Vec3<double>& p : points_) {
      for (int i = 0; i < 3; ++i) {
        const double magnitude = std::abs(p[i]);
        if (magnitude == 0) continue;
        if (!(magnitude >= kLeastCoordinate && magnitude < kCoordinateBound)) valid_ = false;
        if (valid_) step = std::min(step, trailing_exponent(magnitude));
      }
    }
    least_ = std::ldexp(1.0, 3 * step);
  }

  [[nodiscard]] bool valid() const { return valid_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] const Vec3<double>& operator[](std::size_t i) const { return points_[i]; }

  // +1 if d lies on the side from which a, b, c turn anticlockwise, 0 if the four are coplanar.
  [[nodiscard]] int orientation(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    return orientation(points_[a], points_[b], points_[c], points_[d]);
  }
  // Three collinear points, or fewer distinct ones.
  [[nodiscard]] bool collinear(std::size_t a, std::size_t b, std::size_t c) const;

 private:
  // The exponent of the last bit of x that is set.
  static int trailing_exponent(double x) {
    int exponent = std::ilogb(x);
    double rest = std::ldexp(x, -exponent);
    for (rest -= 1; rest != 0; rest -= std::floor(rest)) {
      rest *= 2;
      --exponent;
    }
    return exponent;
  }
  [[nodiscard]] int orientation(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
                                const Vec3<double>& d) const;
  [[nodiscard]] static int sign(double x) { return (x > 0) - (x < 0); }

  std::vector<Vec3<double>> points_;
  double least_ = 1;  // g^3
  bool valid_ = true;
};

inline int PointSet::orientation(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
                                 const Vec3<double>& d) const {
  const Vec3<double> p = b - a, q = c - a, r = d - a;
  double value = 0, permanent = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double qr = q[j] * r[k], rq = q[k] * r[j];
    value += fl(p[i] * (qr - rq));
    permanent += fl(std::abs(p[i]) * (std::abs(qr) + std::abs(rq)));
  }
  const double error = 8 * kUnitRoundoff<double> * permanent;
  if (std::abs(value) > error || permanent == 0) return sign(value);
  if (std::abs(value) + 2 * error < least_) return 0;

  TwoDoubles x[3], y[3], z[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = two_sum(b[i], -a[i]);
    y[i] = two_sum(c[i], -a[i]);
    z[i] = two_sum(d[i], -a[i]);
  }
  TwoDoubles sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum = sum + x[i] * (y[j] * z[k] + -(y[k] * z[j]));
  }
  const double fine = sum.hi, fine_error = 0x1p-96 * permanent;
  if (std::abs(fine) > 2 * fine_error) return sign(fine);
  if (std::abs(fine) + 2 * fine_error < least_) return 0;

  Expansion3 column[3];
  for (int i = 0; i < 3; ++i) {
    const std::size_t s = static_cast<std::size_t>(i);
    const TwoDoubles* const differences[3] = {x, y, z};
    for (std::size_t m = 0; m < 3; ++m) {
      column[m][s] = Expansion(differences[m][i].lo);
      column[m][s].grow(differences[m][i].hi);
    }
  }
  return determinant(column[0], column[1], column[2]).sign();
}

inline bool PointSet::collinear(std::size_t a, std::size_t b, std::size_t c) const {
  Expansion3 p, q;
  for (int i = 0; i < 3; ++i) {
    const std::size_t s = static_cast<std::size_t>(i);
    p[s] = Expansion(points_[b][i]);
    p[s].grow(-points_[a][i]);
    q[s] = Expansion(points_[c][i]);
    q[s].grow(-points_[a][i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    Expansion minor;
    minor.add_product(p[i], q[j]);
    minor.add_product(p[j], q[i], -1);
    if (minor.sign() != 0) return false;
  }
  return true;
}

// sign n . (a - b), exactly, for |a_i|, |b_i| <= 4 that are multiples of 2^-460, and n whose components are 0
// or within a factor 2^1000 of the largest. First n is scaled to 2^600, so that products are multiples of
// 2^-1021 at most 2^604. Two doubles are tried first. Products and sums are each within 2^-100 relatively,
// with four of them on a way. A part of a product that falls below the range of doubles costs less than
// 2^-1000 besides. An overflow makes a NaN, which decides nothing.
inline int height_sign(const Vec3<double>& n, const Vec3<double>& a, const Vec3<double>& b) {
  TwoDoubles sum;
  double magnitude = 0;
  bool tie = true;  // each product has a factor 0
  for (int i = 0; i < 3; ++i) {
    if (n[i] == 0 || a[i] == b[i]) continue;
    tie = false;
    const TwoDoubles product = two_sum(a[i], -b[i]) * TwoDoubles{n[i], 0};
    sum = sum + product;
    magnitude += std::abs(product.hi);
  }
  if (tie) return 0;
  const double error = 0x1p-97 * magnitude + 0x1p-1000;
  if (sum.hi > error) return 1;
  if (sum.hi < -error) return -1;

  const double largest = n.cwiseAbs().maxCoeff();
  if (!(largest > 0 && largest <= std::numeric_limits<double>::max())) return 0;
  const int shift = 600 - std::ilogb(largest);
  std::array<double, 12> term;
  int size = 0;
  // Zeros are left out: an expansion has none.
  const auto grow = [&](double x) {
    int kept = 0;
    for (int i = 0; i < size; ++i) {
      const TwoDoubles s = two_sum(x, term[static_cast<std::size_t>(i)]);
      if (s.lo != 0) term[static_cast<std::size_t>(kept++)] = s.lo;
      x = s.hi;
    }
    if (x != 0) term[static_cast<std::size_t>(kept++)] = x;
    size = kept;
  };
  for (int i = 0; i < 3; ++i) {
    const TwoDoubles difference = two_sum(a[i], -b[i]);
    if (n[i] == 0 || difference.hi == 0) continue;
    const double factor = std::ldexp(n[i], shift);
    for (const double part : {difference.lo, difference.hi}) {
      const TwoDoubles p = two_product(part, factor);
      if (p.lo != 0) grow(p.lo);
      if (p.hi != 0) grow(p.hi);
    }
  }
  if (size == 0) return 0;
  return term[static_cast<std::size_t>(size - 1)] > 0 ? 1 : -1;
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
