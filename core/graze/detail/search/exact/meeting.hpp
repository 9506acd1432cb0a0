// Computes where a moving origin meets a facet of C: time, normal and weights from one set of corners, each formed
// once.
//
//   c(lambda) = c_0 + at_.lambda1 e + at_.lambda2 f     is in the facet's plane for any at_.lambda1 and at_.lambda2
//   t - s     = N.(c(lambda) - s v) / N.v         for every s, N = e x f exactly.
//
// Plain doubles find s and lambda, so that g = c(lambda) - s v is nearly 0. They need not be exact. Only g is formed
// in pairs of doubles, with one rotation a body. It is as small as s and lambda are accurate, so that N and v may be
// rounded in the quotient. The quotient n.g / n.v gives t - s far below a unit in the last place of s. The remaining
// cases are left to facet.hpp. The same lambda are the weights of the contact, and g shows whether the two bodies'
// points coincide.
//
// Applies to two bodies that are no combinators, a path and a facet of three corners. Both bodies are processed at
// once, side by side. If only one body is rotated, the other is rotated by the identity, which rounds nothing.
//
// Errors, internal length, per component. u in double. X, Y bound the coordinates of A's and B's vertices:
//   e, f   25 u S,  S = |steps of A|_1 + |steps of B|_1 bounds |e|_2: each step rounds once, its rotation is within
//          21 u (prepared_pair.hpp), their difference rounds once.
//   n      2 * 25 sqrt(3) u S_e S_f, 3 u S_e S_f for the product, and the second-order terms: 100 u S_e S_f.
//   g      2^-90 (X + Y + |p_A - p_B| + |s v|).  A body's point is within 2^-95 X (two products with 2^-97 of at most
//          2 X lambda, lambda <= 1, and sums). Its rotation is within 2^-96 |q|^2 X and its rows within 2^-99 |q|^2
//          each, three of them: 2^-93 X. The quotient by |q|^2 is within 2^-97. Three sums of that size add 2^-100 each.
#pragma once

#include <graze/detail/search/exact/exact_answer.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// x s, within 2^-97 of the product of their sizes (pair.hpp).
template <bool kFused, class T>
PairOf<kFused, T> times(const PairOf<kFused, T>& x, T s) {
  const PairOf<kFused, T> p = product<kFused>(x.hi, s);
  return {p.hi, p.lo + fl(x.lo * s)};
}
// x / w, w > 0, within 2^-97 of x's size over w. Its first guess, with the reciprocal rounded, is within 2^-48.
template <bool kFused, class T>
PairOf<kFused, T> over(const PairOf<kFused, T>& x, const PairOf<kFused, T>& w, T reciprocal) {
  const T q = x.hi * reciprocal;
  const PairOf<kFused, T> p = product<kFused>(q, w.hi);
  return {q, (((x.hi - p.hi) - p.lo) + (x.lo - fl(q * w.lo))) * reciprocal};
}
// A vector of either body, side by side.
struct Both {
  TwoLanes x, y, z;

  [[nodiscard]] Triple of(std::size_t body) const { return {x[body], y[body], z[body]}; }
  friend Both operator+(const Both& p, const Both& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
  friend Both operator-(const Both& p, const Both& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
  friend Both operator*(double s, const Both& p) { return {fl(s * p.x), fl(s * p.y), fl(s * p.z)}; }
};
inline Both both(const Triple& a, const Triple& b) {
  return {TwoLanes{a.x, b.x}, TwoLanes{a.y, b.y}, TwoLanes{a.z, b.z}};
}
inline TwoLanes dot(const Both& p, const Both& q) { return fl(p.x * q.x) + fl(p.y * q.y) + fl(p.z * q.z); }
// The same in pairs: of one body.
template <bool kFused>
Pair3Of<kFused> of_one(const Pair3Of<kFused, TwoLanes>& x, std::size_t lane) {
  const auto at = [&](std::size_t i) { return PairOf<kFused>{x[i].hi[lane], x[i].lo[lane]}; };
  return {at(0), at(1), at(2)};
}
// x of one body, for either.
template <bool kFused>
Pair3Of<kFused, TwoLanes> twice(const Pair3Of<kFused>& x) {
  const auto at = [&](std::size_t i) {
    return PairOf<kFused, TwoLanes>{TwoLanes{x[i].hi, x[i].hi}, TwoLanes{x[i].lo, x[i].lo}};
  };
  return {at(0), at(1), at(2)};
}
template <bool kFused>
Vec3<double> rounded(const Pair3Of<kFused>& x) {
  return {rounded(x[0]), rounded(x[1]), rounded(x[2])};
}

template <Scalar S>
class Meeting {
 public:
  // All of which live as long. The facet has n.v > 0.
  Meeting(const PreparedPair<S>& pair, const Scene<S>& scene, const Facet& facet, const Term& v)
      : pair_(pair), scene_(scene), facet_(facet), v_(v) {
    const bool takes = scene.is_of_two_leaves() && facet.size == 3 && v.kind == Term::Kind::motion;
    fused_ = fuses();
    turned_ = takes && (scene.leaves()[0].turned || scene.leaves()[1].turned);
    known_ = takes && (fused_ ? find_fused() : find<false>());
  }

  // The quotient n.c_0 / n.v between its neighbouring doubles.
  [[nodiscard]] TimeBracket time() const {
    TimeBracket out;
    return known_ && round(out) ? out : round_time(scene_, facet_, v_);
  }

  // e x f over its length, each component within 2 u.
  [[nodiscard]] Vec3<double> normal() const { return fused_ ? fused_normal() : normal_as<false>(); }

  // The points of A and of B at the origin's position at time t, in the caller's unit of time and world coordinates.
  [[nodiscard]] std::array<Vec3<double>, 2> witnesses(double t) {
    if (!known_) return facet_points(t);
    const std::array<double, 2> weight = has_near_weights() ? at_.lambda : finer_weights();
    return fused_ ? fused_points(t, weight) : points_at(t, weight);
  }

  // Tests compare this with the exact values. Internal units. t is within `error` of s + delta, each component of g
  // within g_error.
  struct Quotient {
    double s = 0, delta = 0, error = 0;
    std::array<double, 2> lambda{};
    Triple g{0, 0, 0};
    double g_error = 0;
  };
  // The quotient, if plain doubles show that the plane is not parallel to the path.
  [[nodiscard]] const Quotient* quotient() const { return known_ ? &at_ : nullptr; }

 private:
  static constexpr double kU = kUnitRoundoff<double>;

  template <bool kFused>
  bool find() {
    return guess() && correct<kFused>();
  }
  GRAZE_FUSED bool find_fused() { return find<true>(); }
  template <bool kFused>
  [[nodiscard]] Vec3<double> normal_as() const {
    Vec3<double> n;
    return known_ && find_normal<kFused>(n) ? over_length_as<kFused>(n) : unit_normal(scene_, facet_);
  }
  GRAZE_FUSED [[nodiscard]] Vec3<double> fused_normal() const { return normal_as<true>(); }

  // By the weights of the corners but the first.
  [[nodiscard]] std::array<Vec3<double>, 2> points_at(double t, const std::array<double, 2>& weight) const {
    const PreparedCore<S>&a = pair_.a(), &b = pair_.b();
    const auto shift = [&](const PreparedCore<S>& of) {
      return of.placed_center() + t * triple(of.body().displacement);
    };
    const Both own = (own_ + weight[0] * high(0)) + weight[1] * high(1),
               out = both(shift(a), shift(b)) + power_of_two(scene_.length_exponent()) * to_world(own);
    return {out.of(0).vector(), out.of(1).vector()};
  }
  GRAZE_FUSED [[nodiscard]] std::array<Vec3<double>, 2> fused_points(
      double t, const std::array<double, 2>& weight) const {
    return points_at(t, weight);
  }
  // In pairs of doubles or exactly.
  [[nodiscard, gnu::noinline]] std::array<double, 2> finer_weights() const {
    const std::array<double, 3> weight = facet_weights(scene_, facet_, v_);
    return {weight[1], weight[2]};
  }
  [[nodiscard, gnu::noinline]] std::array<Vec3<double>, 2> facet_points(double t) const {
    const std::array<double, 3> weight = facet_weights(scene_, facet_, v_);
    const PreparedCore<S>&a = pair_.a(), &b = pair_.b();
    const int k = scene_.length_exponent();
    return {facet_point(a.body(), a, k, facet_, weight, true, t),
            facet_point(b.body(), b, k, facet_, weight, false, t)};
  }

  // Gathers the bodies' parts of the corners: their vertices in c_0 and the steps from there, exactly, in their own
  // axes.
  void gather() {
    const auto leaves = scene_.leaves();
    const auto at = [&](std::size_t i) {
      const Vertex& v = facet_.corner[i];
      return both(triple(scene_.at(leaves[0], v.a)), triple(scene_.at(leaves[1], v.b)));
    };
    x0_ = at(0);
    const Vertex& first = facet_.corner[0];
    for (std::size_t i = 0; i < 2; ++i) {
      const Both x = at(i + 1);
      step_[i] = {step(x.x, x0_.x), step(x.y, x0_.y), step(x.z, x0_.z)};
      moves_[0][i] = facet_.corner[i + 1].a != first.a;
      moves_[1][i] = facet_.corner[i + 1].b != first.b;
    }
    own_ = x0_ - scene_.unit() * both(pair_.a().center(), pair_.b().center());
    if (!turned_) return;
    const auto row = [](const PreparedCore<S>& of, std::size_t i) {
      return of.turned() ? of.row(i) : Triple{double(i == 0), double(i == 1), double(i == 2)};
    };
    for (std::size_t i = 0; i < 3; ++i) row_[i] = both(row(pair_.a(), i), row(pair_.b(), i));
  }
  static PairOf<false, TwoLanes> step(TwoLanes to, TwoLanes from) {
    const TwoDoublesOfTwo s = two_sum(to, -from);
    return {s.hi, s.lo};
  }
  // The steps, rounded.
  [[nodiscard]] Both high(std::size_t i) const { return {step_[i][0].hi, step_[i][1].hi, step_[i][2].hi}; }
  [[nodiscard]] bool is_still(std::size_t body) const { return !moves_[body][0] && !moves_[body][1]; }
  // As the bodies' own to_world: a row of the identity changes nothing.
  [[nodiscard]] Both to_world(const Both& x) const {
    if (!turned_) return x;
    return {dot(row_[0], x), dot(row_[1], x), dot(row_[2], x)};
  }

  // Are the bodies' points, by weights in doubles, within 8 u of the pair's extent of each other? That is the
  // rounding of their summands.
  [[nodiscard]] bool has_near_weights() const {
    return largest(at_.g - at_.delta * pair_.direction()) <= 8 * kU * pair_.extent();
  }

  // s, lambda, n and n.r in doubles.
  bool guess() {
    gather();
    const auto edge = [&](std::size_t i, double& size) {
      const Both own = high(i), out = to_world(own);
      size = sum(magnitude(own.of(0))) + sum(magnitude(own.of(1)));
      return out.of(0) - out.of(1);
    };
    double size_e = 0, size_f = 0;
    const Both first = to_world(own_);
    const Triple e = edge(0, size_e), f = edge(1, size_f), c0 = first.of(0) - (first.of(1) + pair_.offset());
    const Triple& r = pair_.direction();
    n_ = cross(e, f);
    along_ = dot(n_, r);
    n_error_ = fl(100 * kU * size_e * size_f) + kUnderflow;
    // r is within u of v, and three products and sums round.
    along_error_ = (n_error_ + fl(6 * kU * largest(n_))) * sum(magnitude(r));
    if (!(along_ > 4 * along_error_)) return false;
    const double one = 1 / along_;
    at_.s = dot(n_, c0) * one;
    const auto weight = [](double l) { return std::clamp(l, 0.0, 1.0); };
    at_.lambda = {weight(dot(c0, cross(r, f)) * one), weight(dot(c0, cross(e, r)) * one)};
    return std::abs(at_.s) > 0x1p-500 && std::abs(at_.s) < 0x1p500;
  }

  // The corners' points of both bodies at those weights, in world axes about the bodies' positions, side by side.
  template <bool kFused>
  Pair3Of<kFused, TwoLanes> points() {
    using P = PairOf<kFused, TwoLanes>;
    const auto at = [&](TwoLanes first, std::size_t j) {
      const TwoLanes l0 = {at_.lambda[0], at_.lambda[0]}, l1 = {at_.lambda[1], at_.lambda[1]};
      return (P{first, TwoLanes{0, 0}} + times(pair_as<kFused>(step_[0][j]), l0)) +
             times(pair_as<kFused>(step_[1][j]), l1);
    };
    const Pair3Of<kFused, TwoLanes> x = {at(x0_.x, 0), at(x0_.y, 1), at(x0_.z, 2)};
    if (!turned_) return x;
    const Quaternion<double>&p = scene_.leaves()[0].outer, &q = scene_.leaves()[1].outer;
    turn_.template form<kFused>(TwoLanes{p.w, q.w}, TwoLanes{p.x, q.x}, TwoLanes{p.y, q.y},
                                TwoLanes{p.z, q.z});
    const Pair3Of<kFused, TwoLanes> out = turn_.template of<kFused>(x);
    const P weight = pair_as<kFused>(turn_.weight);
    const TwoLanes reciprocal = 1.0 / (weight.hi + weight.lo);
    return {over(out[0], weight, reciprocal), over(out[1], weight, reciprocal),
            over(out[2], weight, reciprocal)};
  }

  // Bounds a body's coordinates in its own axes: those about its centre, as S rounded their middle and half.
  [[nodiscard]] double coordinates(const PreparedCore<S>& of) const {
    return fl(1.01 * of.size()) + fl(scene_.unit() * largest(of.center()));
  }

  // g, and with it delta and its error.
  template <bool kFused>
  bool correct() {
    const Pair3Of<kFused, TwoLanes> both = points<kFused>();
    const Pair3Of<kFused> a = of_one<kFused>(both, 0), b = of_one<kFused>(both, 1),
                          apart = pairs_as<kFused>(scene_.apart()), v = pairs_as<kFused>(scene_.motion());
    const auto difference = [&](std::size_t i) {
      return rounded(((a[i] - b[i]) + apart[i]) - times(v[i], at_.s));
    };
    at_.g = {difference(0), difference(1), difference(2)};
    const Triple shift{apart[0].hi, apart[1].hi, apart[2].hi}, path{v[0].hi, v[1].hi, v[2].hi};
    const double size = coordinates(pair_.a()) + coordinates(pair_.b()) + largest(shift) +
                        fl(std::abs(at_.s) * largest(path));
    const double n = largest(n_);
    at_.g_error = 0x1p-90 * size;
    at_.delta = dot(n_, at_.g) / along_;
    // Error of n.g: the error of n, the rounding of the sum and that of g, of three components each.
    const double error =
        fl((n_error_ + fl(6 * kU * n)) * sum(magnitude(at_.g))) + fl(3.1 * (n + n_error_) * at_.g_error);
    at_.error = 1.1 * (error + fl(std::abs(at_.delta) * along_error_)) / (along_ - along_error_) +
                2 * kU * std::abs(at_.delta);
    return at_.error < kInfinity<double>;
  }

  // False if s + delta does not decide.
  bool round(TimeBracket& out) const {
    const int exponent = scene_.length_exponent() - scene_.speed_exponent();
    if (std::abs(exponent) >= 500 || !(std::abs(at_.delta) < 0x1p-10 * std::abs(at_.s))) return false;
    // s and near are within a factor of 2: their difference is exact, and the remainder of delta rounds once.
    const double near = at_.s + at_.delta, rest = at_.delta - (near - at_.s),
                 error = at_.error + 2 * kU * std::abs(rest);
    const double t = near * power_of_two(exponent);  // exact
    if (std::abs(rest) > error) {
      const bool up = rest > 0;
      const double other = next(near, up);
      if (!(std::abs(rest) + error < std::abs(other - near))) return false;
      const double t_other = other * power_of_two(exponent);
      out = {lesser(t, t_other), greater(t, t_other)};
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

  // e x f up to a factor > 0, each component within 2^-57 of the largest before it is rounded. False if that accuracy
  // needs more work.
  template <bool kFused>
  bool find_normal(Vec3<double>& n) const {
    double size = 0;
    Pair3Of<kFused> fine;
    if (const bool of_b = is_still(0); of_b || is_still(1) || scene_.turned_alike()) {
      // In the bodies' own axes, and rotated once.
      double size_e = 0, size_f = 0;
      const Pair3Of<kFused> e = edge<kFused>(0, size_e), f = edge<kFused>(1, size_f);
      fine = cross(e, f);
      size = size_e * size_f;
      if (scene_.leaves()[of_b].turned) {
        fine = of_one<kFused>(turn_.template of<kFused>(twice<kFused>(fine)), of_b);
        size *= 2 * turn_.weight.hi[of_b];
      }
    } else {
      // An edge of either: the multiples of them in e and f are 0 or 1.
      const auto& c = facet_.corner;
      const bool edge_a = !(moves_[0][0] && moves_[0][1]) || c[1].a == c[2].a,
                 edge_b = !(moves_[1][0] && moves_[1][1]) || c[1].b == c[2].b;
      const int sign = int(moves_[1][0] && moves_[0][1]) - int(moves_[0][0] && moves_[1][1]);
      if (!edge_a || !edge_b || sign == 0) return false;
      // The first step that there is.
      const std::size_t i = moves_[0][0] ? 0 : 1, k = moves_[1][0] ? 0 : 1;
      Pair3Of<kFused, TwoLanes> along;
      for (std::size_t j = 0; j < 3; ++j) {
        const auto &a = step_[i][j], &b = step_[k][j];
        along[j] = {TwoLanes{a.hi[0], b.hi[1]}, TwoLanes{a.lo[0], b.lo[1]}};
      }
      size = largest(high(i).of(0)) * largest(high(k).of(1));
      if (turned_) {
        along = turn_.template of<kFused>(along);
        size *= (2 * turn_.weight.hi[0]) * (2 * turn_.weight.hi[1]);
      }
      const Pair3Of<kFused> along_a = of_one<kFused>(along, 0), along_b = of_one<kFused>(along, 1);
      fine = sign > 0 ? cross(along_a, along_b) : cross(along_b, along_a);
    }
    n = rounded(fine);
    return size > Scene<S>::kLeastSize && size < Scene<S>::kMostSize &&
           n.cwiseAbs().maxCoeff() > 0x1p-30 * size;
  }
  // e or f if no body is rotated, or both by one rotation.
  template <bool kFused>
  Pair3Of<kFused> edge(std::size_t i, double& size) const {
    const Both own = high(i);
    size = largest(own.of(0)) + largest(own.of(1));
    const Pair3Of<kFused, TwoLanes> step = pairs_as<kFused>(step_[i]);
    const Pair3Of<kFused> a = of_one<kFused>(step, 0), b = of_one<kFused>(step, 1);
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  const PreparedPair<S>& pair_;
  const Scene<S>& scene_;
  const Facet& facet_;
  const Term& v_;
  bool known_ = false, fused_ = false, turned_ = false;
  Quotient at_;
  Triple n_{};
  double along_ = 0, n_error_ = 0, along_error_ = 0;
  // For A and B, where known_: c_0's vertices as given and about the centres, and the steps from there, which are 0
  // for a body without a step. If turned_ is set, also the rotations in doubles and in pairs. They are the identity
  // for a body that is not rotated.
  Both x0_, own_;
  std::array<Pair3Of<false, TwoLanes>, 2> step_;
  std::array<std::array<bool, 2>, 2> moves_;
  std::array<Both, 3> row_;
  FineTurnOf<TwoLanes> turn_;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
