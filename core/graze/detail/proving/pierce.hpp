// Decides exactly whether and where the line {t v} pierces a triangle of CSO points, for unrotated polytopes.
//
//   c_i = (x_a + p_a) - (x_b + p_b), exact.   w_i = det(c_j, c_k, v), cyclic: the weights of the point
//   pierced. The line pierces iff all w_i >= 0 or all <= 0, not all zero.   t = det(c_0, c_1, c_2) / sum w_i.
#pragma once

#include <graze/detail/numeric/expansion.hpp>
#include <graze/detail/pairs/side.hpp>
#include <graze/proof.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// The vertex of a body's core as given. Only for shapes that are neither combinators nor curved.
template <Scalar S>
Vec3<double> given_vertex(const Body<S>& body, std::uint32_t k) {
  const auto wide = [](const Vec3<S>& x) -> Vec3<double> { return x.template cast<double>(); };
  return std::visit(Overloaded{[&](const Segment<S>& s) { return wide(k == 0 ? s.a : s.b); },
                               [&](const Triangle<S>& s) {
                                 return wide(k == 0 ? s.a : k == 1 ? s.b : s.c);
                               },
                               [&](const Capsule<S>& s) {
                                 return Vec3<double>(0, 0,
                                                     k == 0 ? -double(s.half_height) : double(s.half_height));
                               },
                               [&](const Box<S>& s) { return box_vertex(wide(s.half_extents), k); },
                               [&](const Hull<S>& s) { return wide(s.vertex(k)); },
                               [](const auto&) -> Vec3<double> { return Vec3<double>::Zero(); }},
                    body.shape);
}

// Is the core a polytope whose vertices given_vertex knows?
template <Scalar S>
bool is_plain(const Shape<S>& shape) {
  return std::visit(
      Overloaded{[](const Ellipsoid<S>&) { return false; }, [](const Cylinder<S>&) { return false; },
                 [](const Cone<S>&) { return false; }, [](const Posed<S>&) { return false; },
                 [](const Rounded<S>&) { return false; }, [](const Sum<S>&) { return false; },
                 [](const HullOf<S>&) { return false; }, [](const auto&) { return true; }},
      shape);
}

// A sum of the given doubles, scaled by 2^-exponent. Products of three such numbers stay within the range of
// expansions while each is 0 or in [2^-280, 2^280]. `in_range` is set if all were.
inline Expansion scaled_sum(std::initializer_list<double> terms, int exponent, bool& in_range) {
  Expansion out;
  for (const double term : terms) {
    const double x = std::ldexp(term, -exponent);
    in_range = in_range && (term == 0 || (std::abs(x) >= 0x1p-280 && std::abs(x) <= 0x1p280));
    out.grow(x);
  }
  return out;
}

struct Pierced {
  bool pierced = false;  // proved: the line meets the triangle at one t, and 0 <= t <= t_max
  double t_upper = 0;    // not below t, and within 32 u of it relatively
};

// length_exponent, speed_exponent: the powers of two near the pair's scale and speed.
template <Scalar S>
Pierced pierce(const Body<S>& a, const Body<S>& b, const std::array<SupportPair, 4>& portal, double t_max,
               int length_exponent, int speed_exponent) {
  if (!a.orientation.is_identity() || !b.orientation.is_identity()) return {};
  bool in_range = true;
  std::array<Expansion3, 3> c;
  Expansion3 v;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t k = static_cast<std::size_t>(axis);
    for (std::size_t i = 0; i < 3; ++i) {
      c[i][k] = scaled_sum({given_vertex(a, portal[i].a.vertex)[axis], double(a.position[axis]),
                            -given_vertex(b, portal[i].b.vertex)[axis], -double(b.position[axis])},
                           length_exponent, in_range);
    }
    v[k] =
        scaled_sum({double(b.displacement[axis]), -double(a.displacement[axis])}, speed_exponent, in_range);
  }
  if (!in_range) return {};
  int sign = 0;
  Expansion sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Expansion w = determinant(v, c[(i + 1) % 3], c[(i + 2) % 3]);
    if (w.sign() * sign < 0) return {};
    if (w.sign() != 0) sign = w.sign();
    sum.add(w);
  }
  const Expansion height = determinant(c[0], c[1], c[2]);
  if (sign == 0 || !sum.valid() || !height.valid() || height.sign() * sign < 0) return {};
  const int exponent = length_exponent - speed_exponent;
  double t = std::ldexp(height.estimate() / sum.estimate(), exponent);
  t += 16 * kUnitRoundoff<double> * t;
  if (!(t < t_max)) {
    // t <= t_max exactly?  height / sum <= t_max 2^-exponent
    const double end = std::ldexp(t_max, -exponent);
    if (!(end >= 0x1p-280 && end <= 0x1p280)) return {};
    Expansion beyond = height;
    beyond.add(sum, -end);
    if (!beyond.valid() || beyond.sign() * sign > 0) return {};
    t = t_max;
  }
  return {true, t};
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
