// A ray against a solid that is given by its own formulas. It decides, and leaves open what rounding decides.
//
// A solid G has
//   reach()        bounds |x| over G;
//   enter(p, w)    where the line {p + t w} enters G, |p| <= 2 reach: t and an outward normal n there, not proved;
//                  or, of a line that misses G, an axis n that separates them;
//   support(n)     h(n) = max n.x over G, within 8 u |n| reach;
//   contains(x, e) only if G holds the ball of radius e about x, up to 8 u reach;
//   nearest(x)     a point of G near x, and x itself if G holds it, within 4 u reach.
// Nothing that enter() says is believed. With e = doubt (ray.hpp):
//   miss   n.x(t) > h(n) + e |n| over [0, t_max], which is linear in t, or over the part of it where |x(t)| <= reach;
//   hit    |x(t) - nearest(x(t))| <= e / 4, n.x(t) >= h(n) - e |n| / 4 and n.w < 0: t is neither early nor late by more;
//          n.o > h(n) + e |n|: it does not start in contact.
// In tier standard the limit is 64 u scale, where |d|_1 <= sqrt(3) scale and reach <= scale / 2: e / 4 <= 36 u scale, and
// what x itself is off by is below 42 u scale / 2.
#pragma once

#include <graze/rays/ray.hpp>

namespace graze::inline GRAZE_LINKAGE::detail {

struct RayEntry {
  bool missed = false;
  double t = 0;
  Triple n{0, 0, 0};
};

template <class Solid>
class SolidClip {
 public:
  SolidClip(const Solid& solid, const Ray& ray) : solid_(solid), ray_(ray) {}

  [[nodiscard]] RayHit run() const {
    using Kind = RayHit::Kind;
    const Triple &o = ray_.o, &w = ray_.w;
    const double ww = dot(w, w), reach = solid_.reach();
    RayHit out;
    if (!(ww > 0) || !(ray_.t_max > 0)) return out;
    if (solid_.contains(o, ray_.doubt)) {
      out.kind = Kind::start;
      return out;
    }
    // From the point of the line that is nearest to the centre, where coordinates are no larger than the solid.
    const double t0 = -dot(o, w) / ww;
    const Triple p = ray_.at(t0);
    const double beyond = std::sqrt(dot(p, p));
    if (beyond > reach + 2 * ray_.doubt) {
      // |p + s w| >= |p| up to the doubt, p.w being nearly 0.
      out.kind = Kind::miss;
      return out;
    }
    RayEntry entry = solid_.enter(p, w);
    if (entry.missed) {
      const double length = std::sqrt(dot(entry.n, entry.n));
      const double along = std::abs(dot(entry.n, w)) * (reach + ray_.doubt) / std::sqrt(ww);
      if (dot(entry.n, p) - along > solid_.support(entry.n) + ray_.doubt * length) out.kind = Kind::miss;
      return out;
    }
    out.t = t0 + entry.t;
    out.n = entry.n;
    if (!(out.t > 0)) {
      // The body is behind the start, if an axis at the line's other end says so.
      const RayEntry exit = solid_.enter(p, -w);
      if (!exit.missed && dot(exit.n, w) >= 0 && above(exit.n, o) > 0) out.kind = Kind::miss;
      return out;
    }
    if (!(above(out.n, o) > 0 && dot(out.n, w) < 0)) return out;
    if (out.t > ray_.t_max) {
      if (above(out.n, ray_.at(ray_.t_max)) > 0) out.kind = Kind::miss;
      return out;
    }
    if (is_contact(out)) out.kind = Kind::hit;
    return out;
  }

 private:
  // n.x - h(n) - e |n|.
  [[nodiscard]] double above(const Triple& n, const Triple& x) const {
    return dot(n, x) - (solid_.support(n) + ray_.doubt * std::sqrt(dot(n, n)));
  }
  [[nodiscard]] bool is_contact(RayHit& hit) const {
    const Triple x = ray_.at(hit.t);
    hit.x = solid_.nearest(x);
    const Triple off = x - hit.x;
    const double allowed = ray_.doubt / 4;
    return dot(off, off) <= allowed * allowed &&
           dot(hit.n, x) >= solid_.support(hit.n) - allowed * std::sqrt(dot(hit.n, hit.n));
  }

  const Solid& solid_;
  const Ray& ray_;
};

}  // namespace graze::inline GRAZE_LINKAGE::detail
