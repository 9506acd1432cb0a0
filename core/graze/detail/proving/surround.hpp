// Is the origin in C? Four exactly named points around it (named_point.hpp).
#pragma once

#include <graze/detail/proving/certified_portal.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Four of six points, for the proof. The hull of the six holds the origin, and so does the hull of the four.
struct Surrounding {
  bool found = false;
  std::array<NamedPoint, 4> p;
};

// Volumes det(w_i, w_j, w_k): with m the largest coordinate, e the error of each, each of the six products of
// three is within 3 e m^2 (1 + ...), and 2^-94 m^3 are rounded.
// `strictly`: the origin is inside of their hull, not on its border.
template <Scalar S>
bool surrounds(const NamedPoints<S>& points, const std::array<const NamedPoint*, 4>& p, bool strictly) {
  const double error = points.error();
  double most = 0;
  for (const NamedPoint* one : p) most = std::max(most, rounded_once(one->w).cwiseAbs().maxCoeff());
  const double predicate_error = fl(32 * error * most * most) + fl(0x1p-92 * most * most * most);
  int side = 0;
  std::array<int, 4> sign;
  for (std::size_t i = 0; i < 4; ++i) {
    const TwoDoubles3 &a = p[(i + 1) % 4]->w, &b = p[(i + 2) % 4]->w, &c = p[(i + 3) % 4]->w;
    TwoDoubles volume;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
      volume = volume + a[j] * (b[k] * c[l] + -(b[l] * c[k]));
    }
    const double v = (i % 2 == 0 ? 1 : -1) * (volume.hi + volume.lo);
    sign[i] = v > 2 * predicate_error ? 1 : v < -2 * predicate_error ? -1 : 0;
    if (sign[i] * side < 0) return false;
    if (sign[i] != 0) side = sign[i];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (sign[i] != 0) continue;
    const NamedPoint &a = *p[(i + 1) % 4], &b = *p[(i + 2) % 4], &c = *p[(i + 3) % 4];
    if (!a.named || !b.named || !c.named) return false;
    const exact::Dyadic v = exact::dot(points.exactly(a), exact::cross(points.exactly(b), points.exactly(c)));
    const int its = (i % 2 == 0 ? 1 : -1) * v.sign();
    if (!v.valid() || its * side < 0 || (strictly && its == 0)) return false;
    if (its != 0) side = its;
  }
  return side != 0;
}

// Four of the corners of two portals. A line through the origin enters C by one and leaves by the other.
template <Scalar S>
Surrounding surrounding(const NamedPoints<S>& points, const ProvedPortal& in, const ProvedPortal& out,
                        bool strictly = false) {
  std::array<const NamedPoint*, 6> all;
  for (std::size_t i = 0; i < 3; ++i) {
    all[i] = &in.p[i].point;
    all[3 + i] = &out.p[i].point;
  }
  Surrounding result;
  for (std::size_t skip = 0; skip < 6; ++skip) {
    for (std::size_t also = skip + 1; also < 6; ++also) {
      std::array<const NamedPoint*, 4> four;
      std::size_t n = 0;
      for (std::size_t i = 0; i < 6; ++i) {
        if (i != skip && i != also) four[n++] = all[i];
      }
      if (!surrounds(points, four, strictly)) continue;
      result.found = true;
      for (std::size_t i = 0; i < 4; ++i) result.p[i] = *four[i];
      return result;
    }
  }
  return result;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
