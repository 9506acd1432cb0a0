// Computes the rotation by a rotation vector w over time t: the quaternion (cos(|w| t/2), sin(|w| t/2) w/|w|), as
// sums of two doubles.
//
// Error: turn_error, 2^-90 and 2^-98 of the angle, up to kMostTurn radians. Nothing here uses libm, so
// the bits are the same everywhere.
#pragma once

#include <graze/detail/numeric/pair.hpp>
#include <graze/detail/numeric/sine_cosine.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Beyond, one unit in the last place of t would be many turns for a body of any size.
inline constexpr double kMostTurn = 0x1p30;

// Error bound of a rotated point's position, relative to its distance from the pivot. A wrong angle moves a point by
// as much. The angle is within 2^-102 of itself: |w|^2 is three exact products and two sums (2^-103.4), its root a
// Newton step (2^-104), and the product with t adds 2^-103.7. 2^-98 leaves room. The reduced angle is within 2^-104
// more. The series, the doublings and the rotation of a point add up to 2^-90.
[[nodiscard]] constexpr double turn_error(double angle) { return 0x1p-90 + 0x1p-98 * angle; }

// sqrt(x), x > 0, within 2^-100: one step of Newton's on the double's root.
inline TwoDoubles root(TwoDoubles x) {
  const double first = square_root(x.hi);
  if (!(first > 0)) return {};
  const TwoDoubles rest = x + -two_product(first, first);
  return two_sum(first, rest.hi / (2 * first));
}

// A unit quaternion w + (x, y, z), as sums of two doubles.
struct Turn {
  TwoDoubles w{1, 0};
  TwoDoubles3 v{};

  [[nodiscard]] TwoDoubles3 operator()(const TwoDoubles3& x) const {
    const TwoDoubles3 once = cross(v, x), twice = cross(v, once);
    TwoDoubles3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      const TwoDoubles moved = w * once[i] + twice[i];
      out[i] = x[i] + TwoDoubles{2 * moved.hi, 2 * moved.lo};
    }
    return out;
  }

 private:
  static TwoDoubles3 cross(const TwoDoubles3& l, const TwoDoubles3& r) {
    TwoDoubles3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      out[i] = l[j] * r[k] + -(l[k] * r[j]);
    }
    return out;
  }
};

// Turns about a fixed axis, prepared once: w of any magnitude in the door's range, 0 too.
class TurnsAbout {
 public:
  explicit TurnsAbout(const Vec3<double>& w) {
    const double most = w.cwiseAbs().maxCoeff();
    if (!(most > 0)) return;
    const int k = exponent_of(most);
    TwoDoubles square;
    for (int i = 0; i < 3; ++i) {
      const double x = w[i] * power_of_two(-k);
      square = square + two_product(x, x);
    }
    const TwoDoubles length = root(square);
    for (std::size_t i = 0; i < 3; ++i) {
      axis_[i] = TwoDoubles{w[static_cast<int>(i)] * power_of_two(-k), 0} / length;
    }
    half_ = {length.hi * power_of_two(k - 1), length.lo * power_of_two(k - 1)};
  }
  [[nodiscard]] bool turns() const { return half_.hi > 0; }
  [[nodiscard]] Turn at(double t) const {
    if (!turns()) return {};
    const SineCosine<TwoDoubles> angle = sine_cosine(half_ * TwoDoubles{t, 0});
    return {angle.cosine, {angle.sine * axis_[0], angle.sine * axis_[1], angle.sine * axis_[2]}};
  }
  // |w| t, and w / |w|, within 2^-100 of themselves. Requires w != 0.
  [[nodiscard]] TwoDoubles angle(double t) const {
    return TwoDoubles{2 * half_.hi, 2 * half_.lo} * TwoDoubles{t, 0};
  }
  [[nodiscard]] const TwoDoubles3& axis() const { return axis_; }

 private:
  TwoDoubles half_{};  // |w| / 2
  TwoDoubles3 axis_{};
};

// R(w t) R(q) for many t, in doubles. A rotation leaves the part of a column of R(q) along its axis a, and rotates
// the rest:
//   along + cos |w| t across + sin |w| t aside,   along = a a^T R(q), across = R(q) - along, aside = a x R(q).
// Each entry is within 7 u. The three matrices are made in pairs and rounded once. In an entry across^2 + aside^2 <=
// 1, so the roundings of both and of the products add up to u each (Cauchy). Sine and cosine add sqrt(2) u. The
// roundings of the inner sum, of `along` and of the outer sum add u each: 6.42 u.
class TurnedRotation {
 public:
  TurnedRotation() = default;
  TurnedRotation(const TurnsAbout& turns, const Quaternion<double>& q) {
    fuses() ? prepare<true>(turns, q) : prepare<false>(turns, q);
  }
  // R(q), each entry within 0.6 u.
  [[nodiscard]] const Mat3<double>& start() const { return start_; }
  // turns: the rotation that this object was made for.
  [[nodiscard]] Mat3<double> at(const TurnsAbout& turns, double t) const {
    const SineCosine<double> angle = rounded_sine_cosine(turns.angle(t));
    return along_ + (angle.cosine * across_ + angle.sine * aside_);
  }

 private:
  template <bool kFused>
  [[gnu::flatten]] void prepare(const TurnsAbout& turns, const Quaternion<double>& q) {
    using Pair = exact::PairOf<kFused>;
    using Pair3 = exact::Pair3Of<kFused>;
    const auto product = [](double a, double b) { return exact::product<kFused>(a, b); };
    const auto scaled = [](const Pair3& x, const Pair& by) { return Pair3{x[0] * by, x[1] * by, x[2] * by}; };
    const Pair ww = product(q.w, q.w), xx = product(q.x, q.x), yy = product(q.y, q.y), zz = product(q.z, q.z),
               norm = (ww + xx) + (yy + zz);
    const TwoDoubles inverse = TwoDoubles{1, 0} / two_sum(norm.hi, norm.lo);
    const Pair over{inverse.hi, inverse.lo}, twice_over{2 * over.hi, 2 * over.lo};
    const auto mixed = [&](double a, double b, double c, double d) {
      return (product(a, b) + product(c, d)) * twice_over;
    };
    const std::array<Pair3, 3> column = {
        Pair3{((ww + xx) - (yy + zz)) * over, mixed(q.x, q.y, q.w, q.z), mixed(q.x, q.z, -q.w, q.y)},
        Pair3{mixed(q.x, q.y, -q.w, q.z), ((ww + yy) - (xx + zz)) * over, mixed(q.y, q.z, q.w, q.x)},
        Pair3{mixed(q.x, q.z, q.w, q.y), mixed(q.y, q.z, -q.w, q.x), ((ww + zz) - (xx + yy)) * over}};
    Pair3 axis;
    for (std::size_t i = 0; i < 3; ++i) axis[i] = {turns.axis()[i].hi, turns.axis()[i].lo};
    for (std::size_t j = 0; j < 3; ++j) {
      const Pair3 lasting = scaled(axis, exact::dot(axis, column[j])), turned = exact::cross(axis, column[j]);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto r = static_cast<int>(i), c = static_cast<int>(j);
        start_(r, c) = exact::rounded(column[j][i]);
        along_(r, c) = exact::rounded(lasting[i]);
        across_(r, c) = exact::rounded(column[j][i] - lasting[i]);
        aside_(r, c) = exact::rounded(turned[i]);
      }
    }
  }

  Mat3<double> start_ = Mat3<double>::Identity();
  Mat3<double> along_ = Mat3<double>::Zero(), across_ = Mat3<double>::Zero(), aside_ = Mat3<double>::Zero();
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
