// Where a moving origin meets a facet of C: time, normal and weights from one set of corners, each formed once.
//
//   c(lambda) = c_0 + lambda_1 e + lambda_2 f     is in the facet's plane, whatever lambda_1 and lambda_2 are;
//   t - s     = N.(c(lambda) - s v) / N.v         for every s, N = e x f exactly.
//
// Plain doubles find s and lambda, so that g = c(lambda) - s v is nearly 0; they need not be right. Only g is formed in
// pairs of doubles, with one rotation a body. It is as small as s and lambda are good, so that N and v may be rounded in
// the quotient: n.g / n.v tells t - s far below a unit in the last place of s. What it does not tell is left to
// facet.hpp. The same lambda are the weights of the contact, and g says whether the two bodies' points are one.
//
// For two bodies that are no combinators, a path and a facet of three corners.
//
// Errors, internal length, per component; u in double; X, Y the largest coordinates of A's and B's corners:
//   e, f   25 u S,  S = |steps of A|_1 + |steps of B|_1 bounds |e|_2: each step rounds once, its rotation is within
//          21 u (prepared_pair.hpp), their difference rounds once;
//   n      2 * 25 sqrt(3) u S_e S_f, 3 u S_e S_f for the product, and what is left of second order: 100 u S_e S_f;
//   g      2^-90 (X + Y + |p_A - p_B| + |s v|):  a body's point within 2^-95 X (two products with 2^-97 of at most 2 X
//          lambda, lambda <= 1, and sums), its rotation within 2^-96 |q|^2 X and its rows within 2^-99 |q|^2 each, three
//          of them: 2^-93 X; the quotient by |q|^2 within 2^-97; three sums of what is so large, 2^-100 each.
#pragma once

#include <graze/exact/answer.hpp>

namespace graze::inline GRAZE_LINKAGE::exact {

// x s, within 2^-97 of the product of their sizes (pair.hpp).
inline Pair times(const Pair& x, double s) {
  const Pair p = product(x.hi, s);
  return {p.hi, p.lo + x.lo * s};
}
// x / w, w > 0; within 2^-97 of x's size over w, as its first guess, with the reciprocal rounded, is within 2^-48.
inline Pair quotient(const Pair& x, const Pair& w, double reciprocal) {
  const double q = x.hi * reciprocal;
  const Pair p = product(q, w.hi);
  return {q, (((x.hi - p.hi) - p.lo) + (x.lo - q * w.lo)) * reciprocal};
}
inline Pair3 operator-(const Pair3& x, const Pair3& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }
inline Pair3 turned_by(const FineTurn& turn, const Pair3& x) {
  return {dot(turn.row[0], x), dot(turn.row[1], x), dot(turn.row[2], x)};
}
inline Vec3<double> rounded(const Pair3& x) { return {rounded(x[0]), rounded(x[1]), rounded(x[2])}; }

template <Scalar S>
class Meeting {
 public:
  // All of which live as long. The facet has n.v > 0.
  Meeting(const GuidedPair<S>& pair, const Scene<S>& scene, const Facet& facet, const Term& v)
      : pair_(pair), scene_(scene), facet_(facet), v_(v) {
    const bool takes = scene.is_of_two_leaves() && facet.size == 3 && v.kind == Term::Kind::motion;
    known_ = takes && guess() && correct();
  }

  // The quotient n.c_0 / n.v between its neighbouring doubles.
  [[nodiscard]] TimeBracket time() const {
    TimeBracket out;
    return known_ && round(out) ? out : round_time(scene_, facet_, v_);
  }

  // e x f over its length, each component within 2 u.
  [[nodiscard]] Vec3<double> normal() const {
    Vec3<double> n;
    return known_ && find_normal(n) ? over_length(n) : unit_normal(scene_, facet_);
  }

  // The weights of the corners where the origin is: of doubles if the bodies' points are then within 8 u of their
  // reaches of each other.
  [[nodiscard]] std::array<double, 3> weights() const {
    const double most = 8 * kUnitRoundoff<double> * (pair_.a().reach() + pair_.b().reach());
    const Triple apart = g_ - delta_ * pair_.direction();
    if (known_ && largest(apart) <= most)
      return {std::max(1 - lambda_[0] - lambda_[1], 0.0), lambda_[0], lambda_[1]};
    return facet_weights(scene_, facet_, v_);
  }

  // What tests hold to the truth: t, internal unit, is within error of s + delta.
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] double s() const { return s_; }
  [[nodiscard]] double delta() const { return delta_; }
  [[nodiscard]] double error() const { return error_; }

 private:
  static constexpr double kU = kUnitRoundoff<double>;

  // s, lambda, n and n.r in doubles.
  bool guess() {
    const Guide<S>&a = pair_.a(), &b = pair_.b();
    const auto& c = facet_.corner;
    const Triple x = a.own(c[0].a), y = b.own(c[0].b);
    const auto edge = [&](std::size_t i, double& size) {
      // Nothing to turn where a body has one corner.
      Triple out{0, 0, 0};
      size = 0;
      if (c[i].a != c[0].a) {
        const Triple step = a.own(c[i].a) - x;
        size += sum(magnitude(step));
        out = a.to_world(step);
      }
      if (c[i].b != c[0].b) {
        const Triple step = b.own(c[i].b) - y;
        size += sum(magnitude(step));
        out = out - b.to_world(step);
      }
      return out;
    };
    double size_e = 0, size_f = 0;
    const Triple e = edge(1, size_e), f = edge(2, size_f),
                 c0 = a.to_world(x) - (b.to_world(y) + pair_.offset());
    const Triple& r = pair_.direction();
    n_ = cross(e, f);
    along_ = dot(n_, r);
    n_error_ = 100 * kU * size_e * size_f + kUnderflow;
    // r is within u of v, and three products and sums round.
    along_error_ = (n_error_ + 6 * kU * largest(n_)) * sum(magnitude(r));
    if (!(along_ > 4 * along_error_)) return false;
    s_ = dot(n_, c0) / along_;
    const auto weight = [](double l) { return std::clamp(l, 0.0, 1.0); };
    lambda_ = {weight(dot(c0, cross(r, f)) / along_), weight(dot(c0, cross(e, r)) / along_)};
    return std::abs(s_) > 0x1p-500 && std::abs(s_) < 0x1p500;
  }

  // The corners' point of a body at those weights, in world axes about the body's position; its size.
  Pair3 point(bool of_b, double& size) const {
    const Leaf<S>& leaf = scene_.leaves()[of_b];
    std::array<std::uint32_t, 3> k;
    for (std::size_t i = 0; i < 3; ++i) k[i] = of_b ? facet_.corner[i].b : facet_.corner[i].a;
    const Vec3<double> x0 = scene_.at(leaf, k[0]);
    size = x0.cwiseAbs().maxCoeff();
    Pair3 x = {Pair{x0[0], 0}, Pair{x0[1], 0}, Pair{x0[2], 0}};
    for (std::size_t i = 1; i < 3; ++i) {
      if (k[i] == k[0]) continue;
      const Vec3<double> xi = scene_.at(leaf, k[i]);
      size = std::max(size, xi.cwiseAbs().maxCoeff());
      for (std::size_t j = 0; j < 3; ++j) {
        const int axis = static_cast<int>(j);
        x[j] = x[j] + times(difference(xi[axis], x0[axis]), lambda_[i - 1]);
      }
    }
    if (!leaf.turned) return x;
    const FineTurn& turn = scene_.turn(of_b);
    const Pair3 out = turned_by(turn, x);
    const double reciprocal = 1 / rounded(turn.weight);
    return {quotient(out[0], turn.weight, reciprocal), quotient(out[1], turn.weight, reciprocal),
            quotient(out[2], turn.weight, reciprocal)};
  }

  // g, and with it delta and its error.
  bool correct() {
    double size_a = 0, size_b = 0;
    const Pair3 a = point(false, size_a), b = point(true, size_b), apart = scene_.apart(),
                v = scene_.motion();
    const auto difference = [&](std::size_t i) {
      return rounded(((a[i] - b[i]) + apart[i]) - times(v[i], s_));
    };
    g_ = {difference(0), difference(1), difference(2)};
    const Triple shift{apart[0].hi, apart[1].hi, apart[2].hi}, path{v[0].hi, v[1].hi, v[2].hi};
    const double size = size_a + size_b + largest(shift) + std::abs(s_) * largest(path);
    const double g_error = 0x1p-90 * size, n = largest(n_);
    delta_ = dot(n_, g_) / along_;
    // Of n.g: n's error, the sum's rounding and g's, of three components each.
    const double error = (n_error_ + 6 * kU * n) * sum(magnitude(g_)) + 3.1 * (n + n_error_) * g_error;
    error_ =
        1.1 * (error + std::abs(delta_) * along_error_) / (along_ - along_error_) + 2 * kU * std::abs(delta_);
    return error_ < kInfinity<double>;
  }

  // False where s + delta does not tell.
  bool round(TimeBracket& out) const {
    const int exponent = scene_.length_exponent() - scene_.speed_exponent();
    if (std::abs(exponent) >= 500 || !(std::abs(delta_) < 0x1p-10 * std::abs(s_))) return false;
    // s and near are within a factor of 2: their difference is exact, and what remains of delta rounds once.
    const double near = s_ + delta_, rest = delta_ - (near - s_), error = error_ + 2 * kU * std::abs(rest);
    const double t = near * power_of_two(exponent);  // exact
    if (std::abs(rest) > error) {
      const double other = rest > 0 ? next_up(near) : next_down(near);
      if (!(std::abs(rest) + error < std::abs(other - near))) return false;
      const double t_other = other * power_of_two(exponent);
      out = rest > 0 ? TimeBracket{t, t_other} : TimeBracket{t_other, t};
      return true;
    }
    // A multiple of 2^grid, so 0 if it is below that.
    const int grid = scene_.grid_of_rest(facet_.f1, facet_.f2, Term::point(facet_.c0), v_, near);
    if (grid <= -900 ||
        !(1.1 * (std::abs(rest) + error) * (along_ + along_error_) < power_of_two(std::min(grid, 0))))
      return false;
    out = {t, t};
    return true;
  }

  // e x f up to a factor > 0, each component within 2^-57 of the largest before it is rounded; false where it is not
  // that easily had.
  bool find_normal(Vec3<double>& n) const {
    const auto& c = facet_.corner;
    const bool a1 = c[1].a != c[0].a, a2 = c[2].a != c[0].a, b1 = c[1].b != c[0].b, b2 = c[2].b != c[0].b;
    double size = 0;
    Pair3 fine;
    if (const bool of_a = !b1 && !b2, of_b = !a1 && !a2; of_a || of_b || scene_.turned_alike()) {
      // In the bodies' own axes, and turned once.
      double size_e = 0, size_f = 0;
      const Pair3 e = step(c[0], c[1], size_e), f = step(c[0], c[2], size_f);
      fine = cross(e, f);
      size = size_e * size_f;
      const Leaf<S>& leaf = scene_.leaves()[of_b];
      if (leaf.turned) {
        fine = turned_by(scene_.turn(of_b), fine);
        size *= 2 * scene_.turn(of_b).weight.hi;
      }
    } else {
      // An edge of either: the multiples of them in e and f are 0 or 1.
      const bool edge_a = !(a1 && a2) || c[1].a == c[2].a, edge_b = !(b1 && b2) || c[1].b == c[2].b;
      const int sign = int(b1 && a2) - int(a1 && b2);
      if (!edge_a || !edge_b || sign == 0) return false;
      double size_a = 0, size_b = 0;
      const std::size_t i = a1 ? 1 : 2, j = b1 ? 1 : 2;
      const Pair3 along_a = turned_step(false, c[0].a, c[i].a, size_a),
                  along_b = turned_step(true, c[0].b, c[j].b, size_b);
      fine = sign > 0 ? cross(along_a, along_b) : cross(along_b, along_a);
      size = size_a * size_b;
    }
    n = rounded(fine);
    return size > Scene<S>::kLeastSize && size < Scene<S>::kMostSize &&
           n.cwiseAbs().maxCoeff() > 0x1p-30 * size;
  }
  // From one corner of C to another, nothing turned.
  Pair3 step(const Vertex& from, const Vertex& to, double& size) const {
    double size_a = 0, size_b = 0;
    if (from.b == to.b) return own_step(false, from.a, to.a, size);
    const Pair3 a = own_step(false, from.a, to.a, size_a), b = own_step(true, from.b, to.b, size_b);
    size = size_a + size_b;
    return a - b;
  }
  Pair3 own_step(bool of_b, std::uint32_t from, std::uint32_t to, double& size) const {
    const Leaf<S>& leaf = scene_.leaves()[of_b];
    Pair3 out = {Pair{0, 0}, Pair{0, 0}, Pair{0, 0}};
    size = 0;
    if (from == to) return out;
    const Vec3<double> x = scene_.at(leaf, from), y = scene_.at(leaf, to);
    for (int i = 0; i < 3; ++i) {
      Pair& d = out[static_cast<std::size_t>(i)];
      d = difference(y[i], x[i]);
      size = std::max(size, std::abs(d.hi));
    }
    return out;
  }
  Pair3 turned_step(bool of_b, std::uint32_t from, std::uint32_t to, double& size) const {
    const Pair3 out = own_step(of_b, from, to, size);
    if (!scene_.leaves()[of_b].turned) return out;
    const FineTurn& turn = scene_.turn(of_b);
    size *= 2 * turn.weight.hi;
    return turned_by(turn, out);
  }

  const GuidedPair<S>& pair_;
  const Scene<S>& scene_;
  const Facet& facet_;
  const Term& v_;
  bool known_ = false;
  Triple n_{}, g_{};
  double s_ = 0, along_ = 0, n_error_ = 0, along_error_ = 0, delta_ = 0, error_ = 0;
  std::array<double, 2> lambda_{};
};

}  // namespace graze::inline GRAZE_LINKAGE::exact
