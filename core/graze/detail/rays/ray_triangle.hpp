// A ray against a triangle: where it meets the plane, if that is to the left of the three edges seen along the ray.
//
// c_i are the corners seen from the start, V_i = det(w, c_j, c_k) and N = e x f of the edges from c_0. The ray's line
// passes through the triangle iff the V_i have one sign, and then meets it at t = N.c_0 / N.w, N.w = V_0 + V_1 + V_2.
//
// Every answer but `open` is that of the true shapes. With e = predicate_error (ray.hpp), which is over the corners
// as well, each c_i is within e per component and w within 24 u |w|_1. A determinant of three such vectors, of at
// most the sizes C and |w|_1, is within
//   12 |w|_1 C e + 24 u |w|_1 6 C^2 + 12 u |w|_1 C^2,   below 16 |w|_1 C e, as e >= 64 u C.
// N.c_0 is within 16 C^2 e. C is the largest |c_i|_1. A corner is formed as the sum of the start's offset and its
// place in the body. So a triangle far out in its own frame, beyond 4 times its own size, is left open.
#pragma once

#include <graze/detail/rays/ray.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// own: the corners, the body's axes. ray.predicate_error is over |o|_1 and the farthest corner's distance.
inline void clip_triangle(const std::array<Triple, 3>& own, const Ray& ray, RayHit& out) {
  using Kind = RayHit::Kind;
  const Triple& w = ray.w;
  const double all = sum(magnitude(w));
  if (!(all > 0 && ray.t_max > 0)) return;
  const std::array<Triple, 3> c = {own[0] - ray.o, own[1] - ray.o, own[2] - ray.o};
  const Triple m0 = cross(c[1], c[2]), m1 = cross(c[2], c[0]), m2 = cross(c[0], c[1]);
  const double v0 = dot(w, m0), v1 = dot(w, m1), v2 = dot(w, m2);
  const double size = greater(greater(sum(magnitude(c[0])), sum(magnitude(c[1]))), sum(magnitude(c[2])));
  const double predicate_error = 16 * all * size * ray.predicate_error;
  const double low = lesser(lesser(v0, v1), v2), high = greater(greater(v0, v1), v2);
  if (!(predicate_error < kInfinity<double>)) return;
  if (low < -predicate_error && high > predicate_error) {
    out.kind = Kind::miss;
    return;
  }
  if (!(low > predicate_error || high < -predicate_error)) return;
  const Triple N = cross(own[1] - own[0], own[2] - own[0]);
  const double height = dot(N, c[0]), rate = v0 + v1 + v2,
               height_doubt = 16 * size * size * ray.predicate_error;
  if (!(std::abs(height) > height_doubt)) return;
  if ((height > 0) != (rate > 0)) {
    out.kind = Kind::miss;  // behind the start
    return;
  }
  out.t = height / rate;
  const double late =
      1.01 * (height_doubt + fl(out.t * 3 * predicate_error)) / (std::abs(rate) - fl(3 * predicate_error));
  if (!(std::abs(rate) > 4 * predicate_error)) return;
  if (out.t - late > ray.t_max) {
    out.kind = Kind::miss;
  } else if (out.t + late < ray.t_max) {
    out.kind = Kind::hit;
    out.n = ((rate > 0 ? -1 : 1) / square_root(dot(N, N))) * N;
    const double one = 1 / rate;
    out.x = (v0 * one) * own[0] + ((v1 * one) * own[1] + (v2 * one) * own[2]);
  }
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
