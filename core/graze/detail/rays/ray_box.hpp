// A ray against a box, |x_i| <= h_i: where it enters the last of the three slabs, if it has left none before.
//
// Every answer but `open` is that of the true shapes, up to rounding of t. With e = predicate_error (ray.hpp), each coordinate of a
// point near the box is known within e. So a plane x_i = +-h_i is crossed within late_i = 1.01 e / |w_i| of the time that
// is computed, where |w_i| > 2^-40 |w|_1: w_i is within 24 u |w|_2 of itself. Both bounds of the last entry and of
// the first exit are then known.
#pragma once

#include <graze/detail/rays/ray.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// A ray that runs nearly along a face, |w_i| <= 2^-40 |w|_1. At the time when it enters slab i the other coordinates are
// known within
//   slack = 1.01 e |w|_1 / |w_i|.
// A coordinate that does not change at all, of a box that is not rotated, is exact. Then w_i = 0 is a difference of
// equal numbers, and o_i - h_i > e proves that the ray stays outside.
[[gnu::noinline]] inline void clip_level_ray(const Triple& h, const Ray& ray, bool turned, RayHit& out) {
  using Kind = RayHit::Kind;
  const double e = ray.predicate_error, all = sum(magnitude(ray.w));
  double enter = -kInfinity<double>, exit = kInfinity<double>, late_in = 0, late_out = 0;
  int axis = -1;
  for (int i = 0; i < 3; ++i) {
    const double w = ray.w[i], outside = std::abs(ray.o[i]) - h[i];
    if (!(std::abs(w) > 0x1p-40 * all)) {
      if (w == 0 && !turned && outside > e) {
        out.kind = Kind::miss;
        return;
      }
      continue;
    }
    const double far = std::copysign(h[i], w), late = 1.01 * e / std::abs(w);
    const double in = (-far - ray.o[i]) / w, leave = (far - ray.o[i]) / w;
    if (in > enter) {
      enter = in;
      late_in = late;
      axis = i;
    }
    if (leave < exit) {
      exit = leave;
      late_out = late;
    }
  }
  if (axis < 0) return;
  if (enter - exit > late_in + late_out || exit < -late_out || enter - late_in > ray.t_max) {
    out.kind = Kind::miss;
    return;
  }
  const double slack = late_in * all;
  std::array<double, 3> x, n{};
  for (int i = 0; i < 3; ++i) {
    x[std::size_t(i)] = ray.o[i] + fl(enter * ray.w[i]);
    if (i != axis && !(h[i] - std::abs(x[std::size_t(i)]) > slack)) return;
  }
  if (!(enter > late_in && enter + late_in < ray.t_max)) return;
  out.kind = Kind::hit;
  out.t = enter;
  n[std::size_t(axis)] = std::copysign(1.0, -ray.w[axis]);
  x[std::size_t(axis)] = std::copysign(h[axis], -ray.w[axis]);
  out.n = {n[0], n[1], n[2]};
  out.x = {x[0], x[1], x[2]};
}

[[gnu::always_inline]] inline void clip_box(const Triple& h, const Ray& ray, bool turned, RayHit& out) {
  using Kind = RayHit::Kind;
  const Triple &o = ray.o, &w = ray.w;
  const Triple speed = magnitude(w), out_of = magnitude(o) - h;
  const double all = sum(speed);
  if (greater(greater(out_of.x, out_of.y), out_of.z) < -ray.predicate_error && ray.t_max > 0 && all > 0) {
    out.kind = Kind::start;
    return;
  }
  if (!(lesser(lesser(speed.x, speed.y), speed.z) > 0x1p-40 * all && ray.t_max > 0)) {
    if (all > 0 && ray.t_max > 0) clip_level_ray(h, ray, turned, out);
    return;
  }
  // In units of its speed the box is c +- d along each axis.
  const Triple one{1 / w.x, 1 / w.y, 1 / w.z}, per = magnitude(one);
  const Triple c = -scaled_by_axis(o, one), d = scaled_by_axis(h, per);
  const Triple in = c - d, leave = c + d, late = (1.01 * ray.predicate_error) * per;
  const Triple in_low = in - late, in_high = in + late, out_low = leave - late, out_high = leave + late;
  const double enter_low = greater(greater(in_low.x, in_low.y), in_low.z),
               enter_high = greater(greater(in_high.x, in_high.y), in_high.z),
               exit_low = lesser(lesser(out_low.x, out_low.y), out_low.z),
               exit_high = lesser(lesser(out_high.x, out_high.y), out_high.z);
  if (enter_low > exit_high || exit_high < 0 || enter_low > ray.t_max) {
    out.kind = Kind::miss;
    return;
  }
  if (!(enter_high < exit_low && enter_low > 0 && enter_high < ray.t_max)) return;
  const double t = greater(greater(in.x, in.y), in.z);
  out.kind = Kind::hit;
  out.t = t;
  // By number (ray.hpp). For an edge either face will do.
  const bool is_x = t == in.x, is_y = !is_x && t == in.y, is_z = !is_x && !is_y;
  const double x = std::copysign(1.0, -w.x), y = std::copysign(1.0, -w.y), z = std::copysign(1.0, -w.z);
  out.n.x = is_x ? x : 0;
  out.n.y = is_y ? y : 0;
  out.n.z = is_z ? z : 0;
  out.x.x = is_x ? x * h.x : o.x + fl(t * w.x);
  out.x.y = is_y ? y * h.y : o.y + fl(t * w.y);
  out.x.z = is_z ? z * h.z : o.z + fl(t * w.z);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
