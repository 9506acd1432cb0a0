// The generators' own turn: a case means what its numbers say, so near is enough.
#pragma once

#include <graze/scalar.hpp>

namespace graze::law {

// x -> q x conj(q) / |q|^2, every coordinate rounded by a few u |x|.
inline Vec3<double> turned(const Quaternion<double>& q, const Vec3<double>& x) {
  const Vec3<double> r(q.x, q.y, q.z);
  return x + 2 * (q.w * r.cross(x) + r.cross(r.cross(x))) / (q.w * q.w + r.squaredNorm());
}

}  // namespace graze::law
