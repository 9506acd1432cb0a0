// Where a moving origin meets a facet of C: time, normal and weights from one set of corners, each formed once.
//
//   c(lambda) = c_0 + at_.lambda1 e + at_.lambda2 f     is in the facet's plane, whatever at_.lambda1 and at_.lambda2 are;
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
template <bool kFused>
PairOf<kFused> times(const PairOf<kFused>& x, double s) {
  const PairOf<kFused> p = product<kFused>(x.hi, s);
  return {p.hi, p.lo + x.lo * s};
}
// x / w, w > 0; within 2^-97 of x's size over w, as its first guess, with the reciprocal rounded, is within 2^-48.
template <bool kFused>
PairOf<kFused> over(const PairOf<kFused>& x, const PairOf<kFused>& w, double reciprocal) {
  const double q = x.hi * reciprocal;
  const PairOf<kFused> p = product<kFused>(q, w.hi);
  return {q, (((x.hi - p.hi) - p.lo) + (x.lo - q * w.lo)) * reciprocal};
}
template <bool kFused>
Pair3Of<kFused> turned_by(const FineTurn& turn, const Pair3Of<kFused>& x) {
  return pairs_as<kFused>(turn.turned<kFused>(pairs_as<false>(x)));
}
template <bool kFused>
Vec3<double> rounded(const Pair3Of<kFused>& x) {
  return {rounded(x[0]), rounded(x[1]), rounded(x[2])};
}

template <Scalar S>
class Meeting {
 public:
  // All of which live as long. The facet has n.v > 0.
  Meeting(const GuidedPair<S>& pair, const Scene<S>& scene, const Facet& facet, const Term& v)
      : pair_(pair), scene_(scene), facet_(facet), v_(v) {
    const bool takes = scene.is_of_two_leaves() && facet.size == 3 && v.kind == Term::Kind::motion;
    fused_ = fuses();
    known_ = takes && guess() && (fused_ ? correct<true>() : correct<false>());
  }

  // The quotient n.c_0 / n.v between its neighbouring doubles.
  [[nodiscard]] TimeBracket time() const {
    TimeBracket out;
    return known_ && round(out) ? out : round_time(scene_, facet_, v_);
  }

  // e x f over its length, each component within 2 u.
  [[nodiscard]] Vec3<double> normal() const {
    Vec3<double> n;
    return known_ && (fused_ ? find_normal<true>(n) : find_normal<false>(n)) ? over_length(n)
                                                                             : unit_normal(scene_, facet_);
  }

  // Of one body, the point where the origin is at time t, caller's unit of it; world coordinates.
  [[nodiscard]] Vec3<double> witness(const Body<S>& body, bool of_a, double t) {
    const Guide<S>& guide = of_a ? pair_.a() : pair_.b();
    if (!has_weights_) find_weights();
    if (!known_) return facet_point(body, guide, scene_.length_exponent(), facet_, weight_, of_a, t);
    const Part& part = part_[!of_a];
    Triple own = guide.own(of_a ? facet_.corner[0].a : facet_.corner[0].b);
    for (std::size_t i = 0; i < 2; ++i) {
      if (part.moves[i]) own = own + weight_[i + 1] * part.rounded_step(i);
    }
    const Triple shift = guide.placed_center() + t * triple(body.displacement);
    return (shift + power_of_two(scene_.length_exponent()) * guide.to_world(own)).vector();
  }

  // What tests hold to the truth. Internal units; t is within `error` of s + delta, each component of g within g_error.
  struct Quotient {
    double s = 0, delta = 0, error = 0;
    std::array<double, 2> lambda{};
    Triple g{0, 0, 0};
    double g_error = 0;
  };
  // Where plain doubles know that the plane is not along the path.
  [[nodiscard]] const Quotient* quotient() const { return known_ ? &at_ : nullptr; }

 private:
  static constexpr double kU = kUnitRoundoff<double>;

  // What one body has in the corners: its vertex in c_0 and the steps from there, exactly, in its own axes.
  struct Part {
    Vec3<double> x0;  // as given
    std::array<Pair3, 2> step;
    std::array<bool, 2> moves;
    double size;  // of the coordinates

    [[nodiscard]] bool is_still() const { return !moves[0] && !moves[1]; }
    [[nodiscard]] Triple rounded_step(std::size_t i) const {
      return {step[i][0].hi, step[i][1].hi, step[i][2].hi};
    }
  };
  void gather(bool of_b) {
    const Leaf<S>& leaf = scene_.leaves()[of_b];
    Part& out = part_[of_b];
    const auto vertex = [&](std::size_t i) { return of_b ? facet_.corner[i].b : facet_.corner[i].a; };
    const std::uint32_t first = vertex(0);
    out.x0 = scene_.at(leaf, first);
    out.size = out.x0.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < 2; ++i) {
      out.moves[i] = vertex(i + 1) != first;
      if (!out.moves[i]) continue;
      const Vec3<double> x = scene_.at(leaf, vertex(i + 1));
      out.size = std::max(out.size, x.cwiseAbs().maxCoeff());
      out.step[i] = {difference(x[0], out.x0[0]), difference(x[1], out.x0[1]), difference(x[2], out.x0[2])};
    }
  }

  // Of doubles if the bodies' points are then within 8 u of the pair's extent of each other, as what they are added up
  // from rounds.
  void find_weights() {
    has_weights_ = true;
    if (known_) {
      const double most = 8 * kU * pair_.extent();
      if (largest(at_.g - at_.delta * pair_.direction()) <= most) {
        weight_ = {1 - at_.lambda[0] - at_.lambda[1], at_.lambda[0], at_.lambda[1]};
        return;
      }
    }
    weight_ = facet_weights(scene_, facet_, v_);
  }

  // s, lambda, n and n.r in doubles.
  bool guess() {
    gather(false);
    gather(true);
    const Guide<S>&a = pair_.a(), &b = pair_.b();
    const auto edge = [&](std::size_t i, double& size) {
      Triple out{0, 0, 0};
      size = 0;
      if (part_[0].moves[i]) {
        const Triple step = part_[0].rounded_step(i);
        size += sum(magnitude(step));
        out = a.to_world(step);
      }
      if (part_[1].moves[i]) {
        const Triple step = part_[1].rounded_step(i);
        size += sum(magnitude(step));
        out = out - b.to_world(step);
      }
      return out;
    };
    double size_e = 0, size_f = 0;
    const Vertex& first = facet_.corner[0];
    const Triple e = edge(0, size_e), f = edge(1, size_f),
                 c0 = a.at(first.a) - (b.at(first.b) + pair_.offset());
    const Triple& r = pair_.direction();
    n_ = cross(e, f);
    along_ = dot(n_, r);
    n_error_ = 100 * kU * size_e * size_f + kUnderflow;
    // r is within u of v, and three products and sums round.
    along_error_ = (n_error_ + 6 * kU * largest(n_)) * sum(magnitude(r));
    if (!(along_ > 4 * along_error_)) return false;
    const double one = 1 / along_;
    at_.s = dot(n_, c0) * one;
    const auto weight = [](double l) { return std::clamp(l, 0.0, 1.0); };
    at_.lambda = {weight(dot(c0, cross(r, f)) * one), weight(dot(c0, cross(e, r)) * one)};
    return std::abs(at_.s) > 0x1p-500 && std::abs(at_.s) < 0x1p500;
  }

  // The corners' point of a body at those weights, in world axes about the body's position.
  template <bool kFused>
  [[gnu::flatten]] Pair3Of<kFused> point(bool of_b) const {
    using P = PairOf<kFused>;
    const Part& part = part_[of_b];
    Pair3Of<kFused> x = {P{part.x0[0], 0}, P{part.x0[1], 0}, P{part.x0[2], 0}};
    for (std::size_t i = 0; i < 2; ++i) {
      if (!part.moves[i]) continue;
      for (std::size_t j = 0; j < 3; ++j)
        x[j] = x[j] + times(pair_as<kFused>(part.step[i][j]), at_.lambda[i]);
    }
    if (!scene_.leaves()[of_b].turned) return x;
    const FineTurn& turn = scene_.turn(of_b);
    const Pair3Of<kFused> out = turned_by(turn, x);
    const P weight = pair_as<kFused>(turn.weight);
    const double reciprocal = 1 / rounded(weight);
    return {over(out[0], weight, reciprocal), over(out[1], weight, reciprocal),
            over(out[2], weight, reciprocal)};
  }

  // g, and with it delta and its error.
  template <bool kFused>
  [[gnu::flatten]] bool correct() {
    const Pair3Of<kFused> a = point<kFused>(false), b = point<kFused>(true),
                          apart = pairs_as<kFused>(scene_.apart()), v = pairs_as<kFused>(scene_.motion());
    const auto difference = [&](std::size_t i) {
      return rounded(((a[i] - b[i]) + apart[i]) - times(v[i], at_.s));
    };
    at_.g = {difference(0), difference(1), difference(2)};
    const Triple shift{apart[0].hi, apart[1].hi, apart[2].hi}, path{v[0].hi, v[1].hi, v[2].hi};
    const double size = part_[0].size + part_[1].size + largest(shift) + std::abs(at_.s) * largest(path);
    const double n = largest(n_);
    at_.g_error = 0x1p-90 * size;
    at_.delta = dot(n_, at_.g) / along_;
    // Of n.g: n's error, the sum's rounding and g's, of three components each.
    const double error = (n_error_ + 6 * kU * n) * sum(magnitude(at_.g)) + 3.1 * (n + n_error_) * at_.g_error;
    at_.error = 1.1 * (error + std::abs(at_.delta) * along_error_) / (along_ - along_error_) +
                2 * kU * std::abs(at_.delta);
    return at_.error < kInfinity<double>;
  }

  // False where s + delta does not tell.
  bool round(TimeBracket& out) const {
    const int exponent = scene_.length_exponent() - scene_.speed_exponent();
    if (std::abs(exponent) >= 500 || !(std::abs(at_.delta) < 0x1p-10 * std::abs(at_.s))) return false;
    // s and near are within a factor of 2: their difference is exact, and what remains of delta rounds once.
    const double near = at_.s + at_.delta, rest = at_.delta - (near - at_.s),
                 error = at_.error + 2 * kU * std::abs(rest);
    const double t = near * power_of_two(exponent);  // exact
    if (std::abs(rest) > error) {
      const bool up = rest > 0;
      const double other = up ? next_up(near) : next_down(near);
      if (!(std::abs(rest) + error < std::abs(other - near))) return false;
      const double t_other = other * power_of_two(exponent);
      out = up ? TimeBracket{t, t_other} : TimeBracket{t_other, t};
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
  template <bool kFused>
  [[gnu::flatten]] bool find_normal(Vec3<double>& n) const {
    const Part &a = part_[0], &b = part_[1];
    double size = 0;
    Pair3Of<kFused> fine;
    if (const bool of_b = a.is_still(); of_b || b.is_still() || scene_.turned_alike()) {
      // In the bodies' own axes, and turned once.
      double size_e = 0, size_f = 0;
      const Pair3Of<kFused> e = pairs_as<kFused>(edge(0, size_e)), f = pairs_as<kFused>(edge(1, size_f));
      fine = cross(e, f);
      size = size_e * size_f;
      if (scene_.leaves()[of_b].turned) {
        const FineTurn& turn = scene_.turn(of_b);
        fine = turned_by(turn, fine);
        size *= 2 * turn.weight.hi;
      }
    } else {
      // An edge of either: the multiples of them in e and f are 0 or 1.
      const auto& c = facet_.corner;
      const bool edge_a = !(a.moves[0] && a.moves[1]) || c[1].a == c[2].a,
                 edge_b = !(b.moves[0] && b.moves[1]) || c[1].b == c[2].b;
      const int sign = int(b.moves[0] && a.moves[1]) - int(a.moves[0] && b.moves[1]);
      if (!edge_a || !edge_b || sign == 0) return false;
      double size_a = 0, size_b = 0;
      const Pair3Of<kFused> along_a = turned_step<kFused>(false, size_a),
                            along_b = turned_step<kFused>(true, size_b);
      fine = sign > 0 ? cross(along_a, along_b) : cross(along_b, along_a);
      size = size_a * size_b;
    }
    n = rounded(fine);
    return size > Scene<S>::kLeastSize && size < Scene<S>::kMostSize &&
           n.cwiseAbs().maxCoeff() > 0x1p-30 * size;
  }
  static double size_of(const Pair3& x) {
    return std::max({std::abs(x[0].hi), std::abs(x[1].hi), std::abs(x[2].hi)});
  }
  // e or f where nothing turns, or all as one.
  Pair3 edge(std::size_t i, double& size) const {
    const Part &a = part_[0], &b = part_[1];
    size = (a.moves[i] ? size_of(a.step[i]) : 0) + (b.moves[i] ? size_of(b.step[i]) : 0);
    if (!b.moves[i]) return a.step[i];
    const Pair3 back = {-b.step[i][0], -b.step[i][1], -b.step[i][2]};
    if (!a.moves[i]) return back;
    return {a.step[i][0] + back[0], a.step[i][1] + back[1], a.step[i][2] + back[2]};
  }
  // The first step that there is.
  template <bool kFused>
  Pair3Of<kFused> turned_step(bool of_b, double& size) const {
    const Pair3& step = part_[of_b].step[part_[of_b].moves[0] ? 0 : 1];
    size = size_of(step);
    if (!scene_.leaves()[of_b].turned) return pairs_as<kFused>(step);
    const FineTurn& turn = scene_.turn(of_b);
    size *= 2 * turn.weight.hi;
    return turned_by(turn, pairs_as<kFused>(step));
  }

  const GuidedPair<S>& pair_;
  const Scene<S>& scene_;
  const Facet& facet_;
  const Term& v_;
  bool known_ = false, has_weights_ = false, fused_ = false;
  Quotient at_;
  Triple n_{};
  double along_ = 0, n_error_ = 0, along_error_ = 0;
  std::array<double, 3> weight_{};
  std::array<Part, 2> part_;  // where known_
};

}  // namespace graze::inline GRAZE_LINKAGE::exact
