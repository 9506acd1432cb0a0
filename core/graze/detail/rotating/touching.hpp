// Proves contact at t = 0 if the origin is on the boundary of C, so that no ball about it lies in C.
//
// At t = 0 no body has rotated yet, so a named point (proving/named_point.hpp) is an exact number. It is decided
// exactly whether the hull of up to four of them holds the origin, its boundary included.
#pragma once

#include <algorithm>
#include <graze/detail/proving/named_point.hpp>
#include <graze/detail/rotating/moving_pair.hpp>
#include <graze/detail/search/exact/exact_body.hpp>
#include <graze/proof.hpp>
#include <graze/rotating_proof.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Is the origin in the hull of c_0 .. c_(size-1), points of any positive weights? Also false if a number outgrew
// Dyadic, and for three points on a line.
inline bool holds_origin(const std::array<exact::Dyadic3, 4>& c, int size) {
  using exact::Dyadic, exact::Dyadic3;
  bool valid = true;
  const auto sign = [&](const Dyadic& x) {
    valid = valid && x.valid();
    return valid ? x.sign() : 0;
  };
  const auto is_zero = [&](const Dyadic3& x) {
    return sign(x[0]) == 0 && sign(x[1]) == 0 && sign(x[2]) == 0;
  };
  const auto holds = [&] {
    switch (size) {
      case 1:
        return is_zero(c[0]);
      case 2:
        return is_zero(cross(c[0], c[1])) && sign(dot(c[0], c[1])) <= 0;
      case 3: {
        // In the plane of the three, the rotations from each to the next have one sense.
        const Dyadic3 l = cross(c[1], c[2]), m = cross(c[2], c[0]), n = cross(c[0], c[1]);
        if (sign(dot(c[0], l)) != 0 || (is_zero(l) && is_zero(m) && is_zero(n))) return false;
        return sign(dot(l, m)) >= 0 && sign(dot(m, n)) >= 0 && sign(dot(n, l)) >= 0;
      }
      case 4: {
        const int signs[4] = {sign(dot(c[1], cross(c[2], c[3]))), sign(dot(c[0], cross(c[3], c[2]))),
                              sign(dot(c[0], cross(c[1], c[3]))), sign(dot(c[0], cross(c[2], c[1])))};
        const auto [least, most] = std::minmax_element(signs, signs + 4);
        return *least != *most ? *least == 0 || *most == 0 : *least != 0;
      }
      default:
        return false;
    }
  };
  return holds() && valid;
}

// Turns the pairs of a simplex that is closest at t = 0 into a proof of contact then. False if they do not prove
// contact. The pair is placed at 0.
template <Scalar S>
bool touches(const MovingPair& pair, const Body<S>& a, const Body<S>& b, const Simplex<double>& closest,
             RotatingProof& proof) {
  const Cso<double>& cso = pair.cso();
  const Vec3<double> none = Vec3<double>::Zero();
  std::array<exact::Dyadic3, 4> c;
  for (std::size_t i = 0; i < static_cast<std::size_t>(closest.size); ++i) {
    const CsoPoint<double>& p = closest.point[i];
    SupportPair& named = proof.contact[i];
    if (!name_feature(a, cso.side_a(), p.vertex_a, p.n, none, 0.0, named.a) ||
        !name_feature(b, cso.side_b(), p.vertex_b, Vec3<double>(-p.n), none, 0.0, named.b))
      return false;
    exact::Exact w = exact_point(a, named.a);
    w.add(exact_point(b, named.b), true);
    c[i] = w.x;
  }
  if (!holds_origin(c, closest.size)) return false;
  proof.toi_upper = 0;
  proof.contact_size = closest.size;
  std::copy(closest.lambda.begin(), closest.lambda.end(), proof.weight.begin());
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
