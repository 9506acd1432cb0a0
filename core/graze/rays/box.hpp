// A ray against a box, |x_i| <= h_i: where it enters the last of the three slabs, if it has left none before.
//
// Every answer but `open` is that of the true shapes. With e = doubt (ray.hpp), each coordinate of a point near the box is
// known within e, so a plane x_i = +-h_i is crossed within e (1 + 2^-8) / |w_i| of the time that is computed, where
// |w_i| > 2^-40 |w|_1: w_i is within 24 u |w|_2 of itself. At that time the other coordinates are known within
//   slack = 1.01 e |w|_1 / |w_i|.
// A coordinate that does not change at all, of a box that does not turn, is exact: w_i = 0 is a difference of equal
// numbers, and o_i - h_i > e says that the ray stays outside.
#pragma once

#include <graze/rays/ray.hpp>

namespace graze::inline GRAZE_LINKAGE::detail {

[[nodiscard]] inline RayHit clip_box(const Triple& h, const Ray& ray, bool turned) {
  using Kind = RayHit::Kind;
  RayHit out;
  const Triple &o = ray.o, &w = ray.w;
  const double e = ray.doubt, all = sum(magnitude(w));
  const Triple out_of = magnitude(o) - h;  // how far the start is outside of each slab
  const double outside = greater(greater(out_of.x, out_of.y), out_of.z);
  if (!(all > 0 && all < kInfinity<double> && ray.t_max > 0)) return out;
  if (outside <= -e) {
    if (outside < -e) out.kind = Kind::start;
    return out;
  }
  const Triple one{1 / w.x, 1 / w.y, 1 / w.z};
  const auto plane = [](double half, double speed) { return std::copysign(half, speed); };
  const Triple far{plane(h.x, w.x), plane(h.y, w.y), plane(h.z, w.z)};
  const auto times = [](const Triple& a, const Triple& b) { return Triple{a.x * b.x, a.y * b.y, a.z * b.z}; };
  // A NaN, of a ray that runs in a plane of the box, fails every test below.
  const Triple in = times(-far - o, one), leave = times(far - o, one);
  const double enter = greater(greater(in.x, in.y), in.z), exit = lesser(lesser(leave.x, leave.y), leave.z);
  const Triple late = 1.01 * e * magnitude(one);  // of the crossings of either plane of a slab
  const int i = in.x == enter ? 0 : in.y == enter ? 1 : 2, j = leave.x == exit ? 0 : leave.y == exit ? 1 : 2;
  const auto is_steep = [&](int axis) { return std::abs(w[axis]) > 0x1p-40 * all; };
  if (enter <= exit && is_steep(i)) {
    const double slack = late[i] * all;
    const Triple at = ray.at(enter), inside = h - magnitude(at);
    const bool known = (i == 0 || inside.x > slack) && (i == 1 || inside.y > slack) && (i == 2 || inside.z > slack);
    if (known && enter > late[i]) {
      if (enter - late[i] > ray.t_max) {
        out.kind = Kind::miss;
      } else if (enter + late[i] < ray.t_max) {
        out.kind = Kind::hit;
        out.t = enter;
        out.x = {i == 0 ? -far.x : at.x, i == 1 ? -far.y : at.y, i == 2 ? -far.z : at.z};
        out.n = {i == 0 ? std::copysign(1.0, -w.x) : 0, i == 1 ? std::copysign(1.0, -w.y) : 0,
                 i == 2 ? std::copysign(1.0, -w.z) : 0};
      }
      return out;
    }
  }
  const bool passes = enter - exit > late[i] + late[j] && is_steep(i) && is_steep(j);
  const bool behind = exit < -late[j] && is_steep(j), beyond = enter - late[i] > ray.t_max && is_steep(i);
  // From a start outside of a slab that the ray does not move towards.
  const bool away = !turned && ((w.x == 0 && out_of.x > e) || (w.y == 0 && out_of.y > e) || (w.z == 0 && out_of.z > e));
  if (passes || behind || beyond || away) out.kind = Kind::miss;
  return out;
}

}  // namespace graze::inline GRAZE_LINKAGE::detail
