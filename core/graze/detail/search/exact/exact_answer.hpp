// Computes the rest of an exact cast's result besides the time: the normal, the witnesses, and the proof.
//
// Normal: -(f_1 x f_2) / |.|, each component within 2 u of the exact one. The cross product is within 2^-88 of its
// factors' sizes in pairs of doubles. It is formed exactly if it is smaller than 2^-30 of them, or if a point has
// more parts than pairs are proved for. Its direction is then within 2^-57, and the unit vector rounds by u and a
// little. Witnesses: the weights of the line's point in the facet are quotients of sides (walk.hpp), in pairs if
// those are accurate enough, otherwise exactly. Proof: only its times are rounded, outward (proof.hpp).
#pragma once

#include <graze/detail/search/exact/exact_nearest.hpp>
#include <graze/detail/search/exact/facet.hpp>
#include <graze/detail/search/exact/passage.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// Rounded once.
template <bool kFused>
double squared_length(const Vec3<double>& n) {
  const auto square = [&](int i) { return product<kFused>(n[i], n[i]); };
  return rounded((square(0) + square(1)) + square(2));
}
// n over its length, which is rounded once. 0 if a number outgrew its room.
template <bool kFused>
Vec3<double> over_length_as(Vec3<double> n) {
  const double most = n.cwiseAbs().maxCoeff();
  if (!(most > 0)) return Vec3<double>::Zero();
  n *= power_of_two(-exponent_of(most));
  return n / square_root(squared_length<kFused>(n));
}
inline Vec3<double> over_length(const Vec3<double>& n) {
  return fuses() ? over_length_as<true>(n) : over_length_as<false>(n);
}
inline Vec3<double> unit_of(const Dyadic3& n) { return over_length(detail::direction_of(n)); }

// f_1 x f_2 over its length.
template <Scalar S>
[[gnu::noinline]] Vec3<double> unit_normal(const Scene<S>& scene, const Facet& facet) {
  const Fine p = scene.fine(facet.f1), q = scene.fine(facet.f2);
  const double size = p.size * q.size;
  Vec3<double> n = Vec3<double>::Zero();
  if (scene.has_fine() && size > Scene<S>::kLeastSize && size < Scene<S>::kMostSize) {
    const Pair3 fine = cross(p.x, q.x);
    for (int i = 0; i < 3; ++i) n[i] = rounded(fine[static_cast<std::size_t>(i)]);
  }
  if (!(n.cwiseAbs().maxCoeff() > 0x1p-30 * size)) {
    scene.count_exact_decision();
    const Dyadic3 exact = cross(scene.exact(facet.f1).x, scene.exact(facet.f2).x);
    int order = std::numeric_limits<int>::min();
    for (const Dyadic& x : exact) {
      if (!x.valid()) scene.invalidate();
      if (x.sign() != 0) order = std::max(order, x.order());
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Dyadic& x = exact[i];
      n[static_cast<int>(i)] =
          x.sign() == 0 ? 0 : std::ldexp(x.leading(), std::max(x.order() - order, -1100));
    }
  }
  return over_length(n);
}

// For a triangle: det(v, c_1, c_2), det(v, c_2, c_0), det(v, c_0, c_1), all >= 0. For a segment, c_2 is the axis x of
// walk.hpp, f_2: det(v, c_1, f_2), det(v, f_2, c_0).
template <class V, class Value>
std::array<Value, 3> facet_sides(const Facet& facet, const V& motion, const std::array<V, 3>& c) {
  const auto side = [&](std::size_t i, std::size_t j) { return dot(motion.x, cross(c[i].x, c[j].x)); };
  return {side(1, 2), side(2, 0), facet.size == 3 ? side(0, 1) : Value{}};
}

// The weights, >= 0 with sum 1 and within 2^-52, of the line's point in the facet's corners.
template <Scalar S>
std::array<double, 3> facet_weights(const Scene<S>& scene, const Facet& facet, const Term& v) {
  GRAZE_ASSERT(facet.size >= 1 && facet.size <= 3);
  if (facet.size == 1) return {1, 0, 0};
  const auto corner = [&](std::size_t i) {
    return facet.size == 2 && i == 2 ? facet.f2 : Term::point(facet.corner[i]);
  };
  std::array<double, 3> weight{};
  double total = 0, size = 0;  // of the summands of the sides
  if (scene.has_fine()) {
    const Fine motion = scene.fine(v);
    const std::array<Fine, 3> c = {scene.fine(corner(0)), scene.fine(corner(1)), scene.fine(corner(2))};
    const auto sides = facet_sides<Fine, Pair>(facet, motion, c);
    for (std::size_t i = 0; i < 3; ++i) {
      weight[i] = std::max(rounded(sides[i]), 0.0);
      total += weight[i];
      size = std::max(size, motion.size * c[i].size * c[(i + 1) % 3].size);
    }
  }
  const bool in_range = size > Scene<S>::kLeastSize && size < Scene<S>::kMostSize;
  if (!(in_range && total > Scene<S>::kFineError * 0x1p53 * size)) {
    scene.count_exact_decision();
    const std::array<Exact, 3> c = {scene.exact(corner(0)), scene.exact(corner(1)), scene.exact(corner(2))};
    const auto sides = facet_sides<Exact, Dyadic>(facet, scene.exact(v), c);
    int order = std::numeric_limits<int>::min();
    for (const Dyadic& x : sides) {
      if (!x.valid()) scene.invalidate();
      if (x.sign() > 0) order = std::max(order, x.order());
    }
    total = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Dyadic& x = sides[i];
      weight[i] = x.sign() > 0 ? std::ldexp(x.leading(), std::max(x.order() - order, -1100)) : 0;
      total += weight[i];
    }
  }
  if (!(total > 0)) return {1, 0, 0};
  for (double& one : weight) one /= total;
  return weight;
}

// The facet's point of one body at time t, in world coordinates.
template <Scalar S>
Vec3<double> facet_point(const Body<S>& body, const PreparedCore<S>& core, int length_exponent,
                         const Facet& facet, const std::array<double, 3>& weight, bool of_a, double t) {
  Triple own{0, 0, 0};
  for (std::size_t i = 0; i < static_cast<std::size_t>(facet.size); ++i) {
    own = own + weight[i] * core.own(of_a ? facet.corner[i].a : facet.corner[i].b);
  }
  const Triple shift = core.placed_center() + t * triple(body.displacement);
  return (shift + power_of_two(length_exponent) * core.to_world(own)).vector();
}

inline SupportPair name(const Vertex& v) {
  SupportPair out;
  out.a.vertex = v.a;
  out.b.vertex = v.b;
  return out;
}

inline AxisFactor name(const Term& term) {
  AxisFactor out;
  switch (term.kind) {
    case Term::Kind::motion:
      out.kind = AxisFactor::Kind::motion;
      break;
    case Term::Kind::difference:
      out.kind = AxisFactor::Kind::difference;
      out.from = name(term.from);
      out.to = name(term.to);
      break;
    default:  // no other kind becomes an axis
      out.given = term.given_triple();
  }
  return out;
}

// toi: the bracket of a hit in doubles. A proof cannot express that a start in contact does not leave. Under
// pass_over it claims nothing then.
inline Proof prove(const Answer& answer, Outcome outcome, const TimeBracket& toi, StartPolicy policy) {
  Proof out;
  if (answer.passage == Passage::contact) {
    if (policy == StartPolicy::pass_over) return out;
    GRAZE_ASSERT(answer.hull_size >= 1 && answer.hull_size <= 4);
    out.toi_upper = 0;
    out.portal_size = answer.hull_size;
    for (std::size_t i = 0; i < static_cast<std::size_t>(answer.hull_size); ++i)
      out.portal[i] = name(answer.hull[i]);
    return out;
  }
  out.toi_lower = outcome == Outcome::hit ? toi.lower : kInfinity<double>;
  out.has_axis = out.symbolic = true;
  if (answer.passage == Passage::beside) {
    out.axis_sign = answer.miss.sign;
    out.factor = {name(answer.miss.f1), name(answer.miss.f2)};
    return out;
  }
  out.axis_sign = answer.passage == Passage::ahead ? -1 : 1;
  out.factor = {name(answer.facet.f1), name(answer.facet.f2)};
  if (outcome != Outcome::hit) return out;
  out.toi_upper = toi.upper;
  out.portal_size = answer.facet.size;
  for (std::size_t i = 0; i < static_cast<std::size_t>(answer.facet.size); ++i)
    out.portal[i] = name(answer.facet.corner[i]);
  return out;
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
