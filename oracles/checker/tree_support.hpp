// The claim that an axis proves about shapes of any kind: h(n) by recursion over the parts, with square
// roots. The arithmetics are doubles with an error bound (Filtered), double-doubles (Extended) if there are
// no roots, and balls of growing precision (Ball).
//
//   leaf       max over vertices x of n.x, + radius |n|         posed     p.n + h_child(R^T n)
//   ellipsoid  sqrt(sum (r_i n_i)^2)                            rounded   h_child + radius |n|
//   cylinder   r |n_xy| + h |n_z|                               sum       the children's sum
//   cone       max(h n_z, r |n_xy| - h n_z)                     hull_of   the children's maximum
// R = M / w as in posed_exact.hpp. h is homogeneous, so h(R^T n) = h(M^T n) / w. No number is divided, and a
// value comes as a fraction with a weight > 0. |n| is taken once, at the root. Below a pose it is w |n|.
//
// Termination of the balls: a tie h(n) = t n.v of a case makes sum of c_i sqrt(q_i) a rational, with rational
// c_i > 0 and rational q_i. Then every root in it is itself rational, because a sum of positive roots of
// rationals is rational only if each of them is. Being the root of an m 2^e, it is an m 2^e. Enough bits
// compute it without error, and the ball is the point 0. For any other number, enough bits distinguish it
// from 0. The code tries up to 4,096, then 4,096 for the roots with exact sums and products.
#pragma once

#include "oracles/arithmetic/ball.hpp"
#include "oracles/arithmetic/double_double.hpp"
#include "oracles/arithmetic/filtered.hpp"
#include "oracles/checker/axis_claim.hpp"
#include "oracles/checker/part_tree.hpp"

namespace graze::oracle {

inline constexpr long kFirstBits = 128, kMostBits = 4096;

// The root of a number known not to be negative.
[[nodiscard]] inline Ball root(Ball x) {
  arb_sqrtpos(x.get(), x.get(), std::min(WorkingPrecision::bits(), kMostBits));
  return x;
}
[[nodiscard]] inline Sign sign(const Ball& x) {
  if (x.is_positive()) return Sign::positive;
  if (x.is_negative()) return Sign::negative;
  return x.is_zero() ? Sign::zero : Sign::unknown;
}

// A double-double has no root here: a number of unbounded error, which tells no sign.
[[nodiscard]] inline Extended root(const Extended&) {
  const Extended largest(std::numeric_limits<double>::max());
  return largest * largest;
}

// value / weight, weight > 0.
template <class N>
struct Fraction {
  N value = N(0);
  bool weighted = false;  // weight differs from 1
  N weight = N(1);
};

template <class N>
[[nodiscard]] N weigh(const Fraction<N>& by, const N& x) {
  return by.weighted ? by.weight * x : x;
}
template <class N>
[[nodiscard]] Fraction<N> over_product(N value, const Fraction<N>& l, const Fraction<N>& r) {
  if (!l.weighted && !r.weighted) return {std::move(value)};
  return {std::move(value), true, weigh(l, r.weight)};
}
template <class N>
[[nodiscard]] Fraction<N> operator+(const Fraction<N>& l, const Fraction<N>& r) {
  return over_product<N>(weigh(r, l.value) + weigh(l, r.value), l, r);
}
template <class N>
[[nodiscard]] Fraction<N> max(const Fraction<N>& l, const Fraction<N>& r) {
  return over_product<N>(max(weigh(r, l.value), weigh(l, r.value)), l, r);
}
// x / w. A number that already has a rounding error is divided at once.
template <class N>
[[nodiscard]] Fraction<N> divided(const Fraction<N>& x, const N& w) {
  if constexpr (std::is_same_v<N, Filtered>) return {x.value / w};
  return {x.value, true, weigh(x, w)};
}

// The root of a number that has roots. An exact number has none, and is asked only about cores without curved parts.
template <class N>
[[nodiscard]] N root_if_any(const N& x) {
  if constexpr (requires { root(x); }) return root(x);
  return N(0);
}

template <class N>
class TreeSupport {
 public:
  TreeSupport(const PartTree& tree, std::vector<Scan>& scans) : tree_(tree), scans_(scans) {}

  // h(n) of the body about its position, with length = |n|.
  [[nodiscard]] Fraction<N> operator()(const Triple<N>& n, const N& length) const { return at(0, n, length); }

 private:
  [[nodiscard]] Fraction<N> at(std::size_t i, const Triple<N>& n, const N& length) const {
    const Part& part = tree_[i];
    const Vec3<double>& e = part.extents;
    switch (part.kind) {
      case PartKind::leaf: {
        const N core = support(part.leaf.core, n, scans_[i]);
        return {part.leaf.radius > 0 ? core + length * part.leaf.radius : core};
      }
      case PartKind::ellipsoid: {
        const N x = n.x * e.x(), y = n.y * e.y(), z = n.z * e.z();
        return {root_if_any(x * x + y * y + z * z)};
      }
      case PartKind::cylinder:
        return {across(n) * e.x() + abs(n.z) * e.y()};
      case PartKind::cone: {
        const N apex = n.z * e.y();
        return {max(apex, across(n) * e.x() - apex)};
      }
      case PartKind::posed: {
        Fraction<N> h = child_of_pose(part, n, length);
        if (part.position.isZero(0)) return h;
        return h + Fraction<N>{dot(n, part.position)};
      }
      case PartKind::rounded: {
        Fraction<N> h = at(part.first_child, n, length);
        if (part.leaf.radius > 0) h.value = h.value + weigh(h, length * part.leaf.radius);
        return h;
      }
      case PartKind::sum:
      case PartKind::hull_of:
        break;
    }
    Fraction<N> h = at(part.first_child, n, length);
    for (std::size_t k = tree_[part.first_child].next; k != Part::kNone; k = tree_[k].next) {
      const Fraction<N> more = at(k, n, length);
      h = part.kind == PartKind::sum ? h + more : max(h, more);
    }
    return h;
  }

  [[nodiscard]] Fraction<N> child_of_pose(const Part& part, const Triple<N>& n, const N& length) const {
    if (!part.rotated) return at(part.first_child, n, length);
    const Frame<N> frame(true, part.q);
    return divided(at(part.first_child, frame.into_body(n), frame.weight * length), frame.weight);
  }
  [[nodiscard]] static N across(const Triple<N>& n) { return root_if_any(n.x * n.x + n.y * n.y); }

  const PartTree& tree_;
  std::vector<Scan>& scans_;
};

// The two bodies of a case as trees.
struct TreePair {
  const PartTree& a;
  const PartTree& b;
  const Body<double>& body_a;
  const Body<double>& body_b;

  // Does h(n) take roots, without a target distance?
  [[nodiscard]] bool has_roots() const {
    for (const PartTree* tree : {&a, &b})
      for (std::size_t i = 0; i < tree->size(); ++i)
        if ((*tree)[i].is_curved() || (*tree)[i].leaf.radius > 0) return true;
    return false;
  }
};

struct TreeScans {
  std::vector<Scan> a, b;
  explicit TreeScans(const TreePair& pair) : a(pair.a.size()), b(pair.b.size()) {}
};

// h(n) of A - B + ball(m), for |n| = length. With length 0 it is that of the cores.
template <class N>
[[nodiscard]] Fraction<N> tree_support(const TreePair& pair, const Triple<N>& n, const N& length,
                                       double target_distance, TreeScans& scans) {
  const Fraction<N> core =
      TreeSupport<N>(pair.a, scans.a)(n, length) + TreeSupport<N>(pair.b, scans.b)(-n, length);
  const N offset = dot(n, difference<N>(pair.body_a.position, pair.body_b.position));
  return core + Fraction<N>{target_distance > 0 ? offset + length * target_distance : offset};
}

}  // namespace graze::oracle
