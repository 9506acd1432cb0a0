// A ray against a solid that is given by its own formulas. It decides, and leaves open what rounding decides.
//
// A solid G has these members:
//   reach()        bounds |x| over G.
//   enter(p, w)    where the line {p + t w} enters G, |p| <= 2 reach: t and an outward normal n there, not proved.
//                  If the line misses G, an axis n that separates them.
//   support(n)     h(n) = max n.x over G, within 8 u |n| reach.
//   contains(x, e) only if G holds the ball of radius e about x, up to 8 u reach.
//   nearest(x)     a point of G near x, and x itself if G holds it, within 4 u reach.
// Every result of enter() is verified. With e = predicate_error (ray.hpp), n of length 1:
//   miss   n.x(t) > h(n) + e over [0, t_max], which is linear in t, or over the part of it where |x(t)| <= reach.
//   hit    |x(t) - nearest(x(t))| <= e / 4, n.x(t) >= h(n) - e / 4 and n.w < 0: t is neither early nor late by more.
//          n.o > h(n) + e: it does not start in contact.
// In tier standard the limit is 64 u scale, where |d|_1 <= sqrt(3) scale and reach <= scale / 2. Then
// e / 4 <= 36 u scale, and x itself errs by less than 42 u scale / 2.
#pragma once

#include <graze/detail/rays/ray.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct RayEntry {
  bool missed = false;
  double t = 0;
  Triple n{0, 0, 0};
};

template <class Solid>
class SolidClip {
 public:
  SolidClip(const Solid& solid, const Ray& ray) : solid_(solid), ray_(ray) {}

  void run(RayHit& out) const {
    using Kind = RayHit::Kind;
    const Triple &o = ray_.o, &w = ray_.w;
    const double ww = dot(w, w), reach = solid_.reach();
    if (!(ww > 0) || !(ray_.t_max > 0)) return;
    if (solid_.contains(o, ray_.predicate_error)) {
      out.kind = Kind::start;
      return;
    }
    // From the point of the line that is nearest to the centre, where coordinates are no larger than the solid.
    const double t0 = -dot(o, w) / ww, farthest = reach + 2 * ray_.predicate_error;
    const Triple p = ray_.at(t0);
    if (dot(p, p) > farthest * farthest) {
      out.kind = Kind::miss;  // p.w is 0 up to the predicate_error
      return;
    }
    const RayEntry entry = solid_.enter(p, w);
    out.n = (1 / square_root(dot(entry.n, entry.n))) * entry.n;
    if (entry.missed) {
      const double along = std::abs(dot(out.n, w)) * (reach + ray_.predicate_error) / square_root(ww);
      if (above(out.n, p) > along) out.kind = Kind::miss;
      return;
    }
    out.t = t0 + entry.t;
    if (!(out.t > 0)) {
      if (is_behind(p)) out.kind = Kind::miss;
      return;
    }
    if (!(dot(out.n, w) < 0)) return;
    const double h = solid_.support(out.n);
    if (!(dot(out.n, o) > h + ray_.predicate_error)) return;
    if (out.t > ray_.t_max) {
      if (above(out.n, ray_.at(ray_.t_max)) > 0) out.kind = Kind::miss;
      return;
    }
    const Triple x = ray_.at(out.t);
    out.x = solid_.nearest(x);
    const Triple off = x - out.x;
    const double allowed = ray_.predicate_error / 4;
    if (dot(off, off) <= allowed * allowed && dot(out.n, x) >= h - allowed) out.kind = Kind::hit;
  }

 private:
  // n.x - h(n) - e, n of length 1.
  [[nodiscard]] double above(const Triple& n, const Triple& x) const {
    return dot(n, x) - (solid_.support(n) + ray_.predicate_error);
  }
  // Does the axis where the line leaves the solid say so?
  [[nodiscard, gnu::noinline]] bool is_behind(const Triple& p) const {
    const RayEntry exit = solid_.enter(p, -ray_.w);
    const Triple n = (1 / square_root(dot(exit.n, exit.n))) * exit.n;
    return !exit.missed && dot(n, ray_.w) >= 0 && above(n, ray_.o) > 0;
  }

  const Solid& solid_;
  const Ray& ray_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
