// The axis of a proof over any of the checker's arithmetics: n up to a positive factor, which no claim
// depends on.
//
// A factor between support pairs is (a_to - b_to) - (a_from - b_from) = R_A x + o - R_B y. Here x is the
// difference of the two vertices in A's frame, y likewise in B's, and o that of the offsets. The positions
// cancel before they are rounded. If only one body's vertex changes, its weight is dropped. A rotation goes
// through a cross product, (M x1) x (M x2) = w M (x1 x2) for M = w R, so two such edges of one body are
// crossed in its frame.
//
// Every n is an axis, so a factor's points may lie anywhere. They only have to be named.
//
// A nearest axis is t v - c_0 = z less its foot on the directions e and g from c_0: z, (e.e) z - (z.e) e, or (z.N) N
// with N = e x g. Its directions are factors.
#pragma once

#include <graze/proof.hpp>

#include "oracles/checker/posed_exact.hpp"

namespace graze::oracle {

template <class N>
[[nodiscard]] Answer is_zero(const Triple<N>& n) {
  Answer zero = Answer::yes;
  for (const N* x : {&n.x, &n.y, &n.z}) {
    const Sign s = sign(*x);
    zero = both(zero, s == Sign::unknown ? Answer::unknown : s == Sign::zero ? Answer::yes : Answer::no);
  }
  return zero;
}

[[nodiscard]] inline bool is_nearest(const Proof& proof) {
  return proof.has_axis && proof.symbolic && proof.nearest.size > 0;
}
// Is the axis tilted by an infinitesimal?
[[nodiscard]] inline bool is_tilted(const Proof& proof) { return is_nearest(proof) && proof.then; }

// The factors of a cross product, or the directions of a nearest axis. There is room for the one of a tilted axis.
struct Factors {
  std::array<AxisFactor, 3> at;
  std::size_t size = 0;
};
[[nodiscard]] inline Factors factors_of(const Proof& proof) {
  Factors out;
  if (!is_nearest(proof)) {
    if (proof.has_axis && proof.symbolic) out = {{proof.factor[0], proof.factor[1]}, 2};
    return out;
  }
  const NearestAxis& nearest = proof.nearest;
  for (std::size_t i = 1; i < static_cast<std::size_t>(nearest.size); ++i) {
    AxisFactor& step = out.at[out.size++];
    step.kind = AxisFactor::Kind::difference;
    step.from = nearest.pair[0];
    step.to = nearest.pair[i];
  }
  if (nearest.motion) out.at[out.size++].kind = AxisFactor::Kind::motion;
  return out;
}

// A nearest axis. along() is its only direction, and across() the cross product of two.
template <class N, class Along, class Across>
[[nodiscard]] Triple<N> less_foot(const Triple<N>& z, std::size_t directions, const Along& along,
                                  const Across& across) {
  if (directions == 0) return z;
  if (directions == 2) {
    const Triple<N> n = across();
    return scaled(dot(z, n), n);
  }
  const Triple<N> e = along();
  return scaled(dot(e, e), z) - scaled(dot(z, e), e);
}

// n + e n_2 for a tilted axis (Dual), otherwise n. second() is the factor of n_2.
template <class N, class Second>
[[nodiscard]] Triple<N> tilted(const Proof& proof, const Triple<N>& n, const Triple<N>& velocity,
                               const Second& second) {
  if constexpr (requires { N::infinitesimal(); }) {
    const bool back = proof.factor[0].kind == AxisFactor::Kind::motion;
    return n + scaled(N::infinitesimal(), back ? -velocity : cross(n, second()));
  } else {
    return n;
  }
}

// n.v, and whether it is negative.
template <class N>
struct Approach {
  N value;
  Answer negative;
};

// An axis with v among its factors is across v by construction, which no bound on a rounding error could tell.
[[nodiscard]] inline bool across_motion(const Proof& proof) {
  if (is_nearest(proof)) return proof.nearest.motion && !proof.then;
  return proof.symbolic && (proof.factor[0].kind == AxisFactor::Kind::motion ||
                            proof.factor[1].kind == AxisFactor::Kind::motion);
}
template <class N>
[[nodiscard]] Approach<N> approach_along(const Proof& proof, const Triple<N>& n, const Triple<N>& velocity) {
  if (across_motion(proof)) return {N(0), Answer::no};
  const N value = dot(n, velocity);
  return {value, is_negative(sign(value))};
}

// o of a factor between support pairs.
[[nodiscard]] inline bool has_offset(const AxisFactor& factor) {
  return factor.from.a.offset != factor.to.a.offset || factor.from.b.offset != factor.to.b.offset;
}
template <class N>
[[nodiscard]] Triple<N> offset_difference(const AxisFactor& factor) {
  return difference<N>(factor.to.a.offset, factor.from.a.offset) -
         difference<N>(factor.to.b.offset, factor.from.b.offset);
}

// A factor up to a positive one, in the frame where it is simplest. M maps the factors of the bodies.
enum class EdgeFrame { world, of_a, of_b };

template <class N>
struct Edge {
  Triple<N> along;
  EdgeFrame frame = EdgeFrame::world;
};

template <class N>
[[nodiscard]] Edge<N> edge_of(const Solid& a, const Solid& b, const Pair<N>& pair, const AxisFactor& factor) {
  if (factor.kind == AxisFactor::Kind::given) return {triple<N>(factor.given)};
  if (factor.kind == AxisFactor::Kind::motion) return {pair.velocity};
  const auto edge = [](const Solid& body, const Feature& from, const Feature& to) {
    return difference<N>(body.core.vertex(to.vertex), body.core.vertex(from.vertex));
  };
  const bool moves_a = factor.from.a.vertex != factor.to.a.vertex;
  const bool moves_b = factor.from.b.vertex != factor.to.b.vertex;
  const bool offset = has_offset(factor);
  if (!moves_b && !offset) return {edge(a, factor.from.a, factor.to.a), EdgeFrame::of_a};
  if (!moves_a && !offset) return {edge(b, factor.to.b, factor.from.b), EdgeFrame::of_b};

  Triple<N> sum{N(0), N(0), N(0)};
  if (offset) sum = pair.weigh(offset_difference<N>(factor));
  if (moves_a) {
    const Triple<N> x = pair.a.apply(edge(a, factor.from.a, factor.to.a));
    sum = sum + (pair.b.rotated ? scaled(pair.b.weight, x) : x);
  }
  if (moves_b) {
    const Triple<N> y = pair.b.apply(edge(b, factor.from.b, factor.to.b));
    sum = sum - (pair.a.rotated ? scaled(pair.a.weight, y) : y);
  }
  return {sum};
}

template <class N>
[[nodiscard]] Triple<N> in_world(const Pair<N>& pair, EdgeFrame frame, const Triple<N>& x) {
  return frame == EdgeFrame::of_a ? pair.a.apply(x) : frame == EdgeFrame::of_b ? pair.b.apply(x) : x;
}
template <class N>
[[nodiscard]] Triple<N> factor_in_world(const Solid& a, const Solid& b, const Pair<N>& pair,
                                        const AxisFactor& factor) {
  const Edge<N> e = edge_of(a, b, pair, factor);
  return in_world(pair, e.frame, e.along);
}

// n of two leaves, not tilted.
template <class N>
[[nodiscard]] Triple<N> axis_vector(const Solid& a, const Solid& b, const Pair<N>& pair, const Proof& proof) {
  if (!proof.symbolic) return triple<N>(proof.axis);
  const Factors factors = factors_of(proof);
  const auto along = [&] { return factor_in_world(a, b, pair, factors.at[0]); };
  const auto across = [&] {
    const Edge<N> first = edge_of(a, b, pair, factors.at[0]), second = edge_of(a, b, pair, factors.at[1]);
    return first.frame == second.frame
               ? in_world(pair, first.frame, cross(first.along, second.along))
               : cross(in_world(pair, first.frame, first.along), in_world(pair, second.frame, second.along));
  };
  if (is_nearest(proof)) {
    const SupportPair& s = proof.nearest.pair[0];
    const Triple<N> path = pair.weigh(scaled(N(proof.nearest.time), pair.velocity));
    return less_foot(path - difference_point(pair, a, b, s.a, s.b), factors.size, along, across);
  }
  const Triple<N> n = across();
  return proof.axis_sign < 0 ? -n : n;
}

}  // namespace graze::oracle
