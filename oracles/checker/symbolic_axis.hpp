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

// n.v, and whether it is negative.
template <class N>
struct Approach {
  N value;
  Answer negative;
};

// n = +-(v x f) is across v by construction, which no bound on a rounding error could tell.
[[nodiscard]] inline bool across_motion(const Proof& proof) {
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

// n of two leaves.
template <class N>
[[nodiscard]] Triple<N> axis_vector(const Solid& a, const Solid& b, const Pair<N>& pair, const Proof& proof) {
  if (!proof.symbolic) return triple<N>(proof.axis);
  const auto in_world = [&pair](EdgeFrame frame, const Triple<N>& x) {
    return frame == EdgeFrame::of_a ? pair.a.apply(x) : frame == EdgeFrame::of_b ? pair.b.apply(x) : x;
  };
  const Edge<N> first = edge_of(a, b, pair, proof.factor[0]), second = edge_of(a, b, pair, proof.factor[1]);
  const Triple<N> n = first.frame == second.frame
                          ? in_world(first.frame, cross(first.along, second.along))
                          : cross(in_world(first.frame, first.along), in_world(second.frame, second.along));
  return proof.axis_sign < 0 ? -n : n;
}

}  // namespace graze::oracle
