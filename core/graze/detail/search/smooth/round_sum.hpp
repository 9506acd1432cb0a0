// The core C of two primitives, one of which is curved at least, as a sum: its support function, its points, and the depth that
// balls inside of the bodies prove.
// Units: internal (cso.hpp).   Frame: world axes.
//
//   h(n) = c.n + sum |m_k n| + sum half_i |a_i.n| + sum max(apex, base)
//
// c is the offset of the centres. m_k n are the radii of an ellipsoid or a disc times n's own coordinates. a_i and
// half_i are the segments of boxes, cylinders and capsules.
#pragma once

#include <algorithm>
#include <array>
#include <graze/detail/numeric/sine_cosine.hpp>
#include <graze/detail/pairs/cso.hpp>
#include <graze/detail/search/smooth/inner_ball.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

class RoundSum {
 public:
  using Vec = Vec3<double>;

  // Points, segments, spheres, capsules, boxes, ellipsoids, cylinders and cones. False: another shape, or nothing is curved.
  template <Scalar Given>
  [[nodiscard]] bool set(const Cso<double>& cso, const Shape<Given>& a, const Shape<Given>& b) {
    center_ = offset_ = -cso.offset();
    scale_ = cso.scale();
    return add(cso.side_a(), a, 1) && add(cso.side_b(), b, -1) && norm_count_ > 0;
  }

 protected:
  static constexpr double kU = kUnitRoundoff<double>;
  // A value of h, and what of the support point is free along n: seams, or the disc of a norm.
  struct Contact {
    Vec n = Vec::Zero();
    double h = kInfinity<double>;
    std::array<int, 2> seams = {-1, -1};
    int disc = -1;
    [[nodiscard]] int freedom() const { return (seams[0] >= 0) + (seams[1] >= 0) + 2 * (disc >= 0); }
  };
  // |m n|
  struct Norm {
    Mat3<double> m = Mat3<double>::Zero();
    double most = 0, least = 0;  // largest and least radius, least: of the two of a flat one
    bool flat = false;
    Vec pole = Vec::Zero();
    int seam = -1;  // of a cone: present on its base's side
    int side = 1;
  };
  // A place at which two pieces of h meet: h has half |n.a| (level 0), or a cone's two pieces at n.a = level.
  struct Seam {
    Vec a = Vec::Zero();
    double half = 0, level = 0, across = 1;  // across: sqrt(1 - level^2)
    bool cone = false;
    int side = 1;
  };

  // h(n), and the support point.
  double value(const Vec& n, Vec* support = nullptr, int without = -1) const {
    double h = dot(center_, n);
    Vec w = center_;
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      if (o.seam >= 0 || i == without) continue;
      const Vec y = o.m * n;
      const double f = norm(y);
      h += f;
      if (support && f > 0) w += o.m.transpose() * (y / f);
    }
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      const double u = dot(s.a, n);
      if (!s.cone) {
        h += fl(s.half * std::abs(u));
        if (support) w += (u >= 0 ? s.half : -s.half) * s.a;
        continue;
      }
      const Norm& o = norms_[std::size_t(norm_of(i))];
      const Vec y = o.m * n;
      const double f = norm(y), apex = s.half * u, base = f - fl(s.half * u);
      h += std::max(apex, base);
      if (!support) continue;
      if (apex >= base) {
        w += s.half * s.a;
      } else {
        w -= s.half * s.a;
        if (f > 0 && norm_of(i) != without) w += o.m.transpose() * (y / f);
      }
    }
    if (support) *support = w;
    return h;
  }
  [[nodiscard]] int norm_of(int seam) const { return norms_[0].seam == seam ? 0 : 1; }

  static Vec rim(const Norm& o, const Vec& n) {
    const Vec y = o.m * n;
    const double f = norm(y);
    return f > 0 ? Vec(o.m.transpose() * (y / f)) : Vec(Vec::Zero());
  }
  // Is every point of it as far along n, up to the rounding of two axes and of n? For a cone, which has it at its
  // base, it holds if n ends the base.
  [[nodiscard]] bool is_disc_across(const Norm& o, const Vec& n) const {
    return o.flat && norm(o.m * n) <= 8 * kU * o.most &&
           (o.seam < 0 || dot(n, seams_[std::size_t(o.seam)].a) < 0);
  }
  // Points of discs across n that add up to x, which is across n as well. If their sum does not reach as far, the
  // points at its end towards x.
  static std::array<Vec, 2> shares(const std::array<const Norm*, 2>& disc, const Vec& x, const Vec& n) {
    std::array<Vec, 2> end = {Vec(Vec::Zero()), Vec(Vec::Zero())};
    const double length = norm(x);
    if (disc[0] == nullptr || !(length > 0)) return end;
    // The sum ends along u at end[0] + end[1]. The position of that end changes as u rotates, so halvings find the u
    // whose end is towards x. Circles end along u itself.
    const Vec e = x / length, f = cross(n, e);
    Vec from = -f, to = f, u = e;
    constexpr int kMostHalvings = 52;
    for (int i = 0; i < kMostHalvings; ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (disc[k] != nullptr) end[k] = rim(*disc[k], u);
      }
      const double aside = dot(f, end[0] + end[1]);
      if (std::abs(aside) <= 4 * kU * norm(end[0] + end[1])) break;
      (aside > 0 ? to : from) = u;
      u = unit(Vec(from + to));
    }
    const double part = std::min(1.0, length / norm(end[0] + end[1]));
    return {Vec(part * end[0]), Vec(part * end[1])};
  }

  // Points of the cores about the bodies' centres, internal units, world axes.
  [[nodiscard]] std::array<Vec, 2> points(const Contact& at) const {
    struct Part {
      Vec x = Vec::Zero(), along = Vec::Zero();  // x + k along, k in [0, 1], where it is free
      int side = 1;
    };
    std::array<Part, 10> part;
    std::size_t count = 0;
    std::array<const Norm*, 2> disc{};
    std::size_t disc_count = 0;
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      if (i == at.disc || is_disc_across(o, at.n)) disc[disc_count++] = &o;
    }
    const auto is_disc = [&](const Norm& o) { return &o == disc[0] || &o == disc[1]; };
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      Part& p = part[count++];
      p.side = s.side;
      const double u = dot(s.a, at.n);
      const bool is_free = i == at.seams[0] || i == at.seams[1] || std::abs(u - s.level) <= 4 * kU;
      const Vec top = s.half * s.a;
      Vec low = -top;
      bool above = u >= 0;
      if (s.cone) {
        const Norm& o = norms_[std::size_t(norm_of(i))];
        if (!is_disc(o)) low += rim(o, at.n);
        above = dot(top, at.n) >= dot(low, at.n);
      }
      p.x = above && !is_free ? top : low;
      if (is_free) p.along = top - low;
    }
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      if (o.seam >= 0) continue;
      part[count].x = is_disc(o) ? Vec(Vec::Zero()) : rim(o, at.n);
      part[count++].side = o.side;
    }
    Vec rest = center_;
    for (std::size_t i = 0; i < count; ++i) rest += part[i].x;
    rest -= dot(rest, at.n) * at.n;
    // The free part takes the sum onto n. Two that meet at an angle go at once if neither ends, others one after the
    // other.
    std::array<double, 10> k{};
    std::array<Vec, 10> across;
    std::array<std::size_t, 10> free{};
    std::size_t free_count = 0;
    for (std::size_t i = 0; i < count; ++i) {
      across[i] = part[i].along - dot(part[i].along, at.n) * at.n;
      if (across[i] != Vec::Zero()) free[free_count++] = i;
    }
    const auto move = [&](std::size_t i, double to) {
      rest += (to - k[i]) * across[i];
      k[i] = to;
    };
    if (free_count == 2) {
      const Vec &e = across[free[0]], &f = across[free[1]];
      const double ee = squared_norm(e), ef = dot(e, f), ff = squared_norm(f),
                   det = fl(ee * ff) - fl(ef * ef);
      const double one = (fl(ef * dot(rest, f)) - fl(ff * dot(rest, e))) / det,
                   other = (fl(ef * dot(rest, e)) - fl(ee * dot(rest, f))) / det;
      if (one >= 0 && one <= 1 && other >= 0 && other <= 1) {
        move(free[0], one);
        move(free[1], other);
      }
    }
    constexpr int kMostRounds = 64;
    constexpr double kStill = 1e-16;  // of a part's length: less than its rounding
    for (int round = 0; round < kMostRounds; ++round) {
      double moved = 0;
      for (std::size_t i = 0; i < free_count; ++i) {
        const std::size_t which = free[i];
        const double before = k[which];
        move(which, std::clamp(before - dot(rest, across[which]) / squared_norm(across[which]), 0.0, 1.0));
        moved = std::max(moved, std::abs(k[which] - before));
      }
      if (moved <= kStill) break;
    }
    for (std::size_t i = 0; i < count; ++i) part[i].x += k[i] * part[i].along;
    const std::array<Vec, 2> taken = shares(disc, Vec(-rest), at.n);
    for (std::size_t i = 0; i < disc_count; ++i) part[count++] = {.x = taken[i], .side = disc[i]->side};
    std::array<Vec, 2> out = {middle_[0], middle_[1]};
    for (std::size_t i = 0; i < count; ++i) {
      if (part[i].side > 0) {
        out[0] += part[i].x;
      } else {
        out[1] -= part[i].x;
      }
    }
    return out;
  }

  // The point of C that is a pair of points as above.
  [[nodiscard]] Vec difference(const std::array<Vec, 2>& x) const { return x[0] - x[1] + offset_; }

  // The depth is no less than this, where the contact is at `at`: of the balls in the bodies that touch it there.
  [[nodiscard]] double depth_by_balls(const Contact& at) const {
    const std::array<Vec, 2> x = points(at);
    double left = at.h, found = 0;
    Vec off = offset_;
    for (std::size_t i = 0; i < 2; ++i) {
      const double sign = i == 0 ? 1 : -1;
      const Vec own = axes_[i].transpose() * x[i], n = axes_[i].transpose() * (sign * at.n);
      const double r = std::min(inner_ball(core_[i], own, n), left);
      left -= r;
      found += r;
      off += sign * x[i] - r * at.n;
    }
    // The sum of the two balls is about `off`.
    return found - norm(off) - fl(kInnerBallRounding * scale_);
  }

  Vec center_ = Vec::Zero();
  double scale_ = 1;
  int norm_count_ = 0, seam_count_ = 0;
  std::array<Norm, 2> norms_;
  std::array<Seam, 8> seams_;

 private:
  template <Scalar Given>
  bool add(const Side<double>& side, const Shape<Given>& shape, int sign) {
    const auto axis = [&](int i) -> Vec {
      return side.rotated ? Vec(side.rotation.col(i)) : Vec(Vec::Unit(i));
    };
    const auto seam = [&](const Vec& a, double half) {
      if (!(half > 0)) return;
      Seam& s = seams_[std::size_t(seam_count_++)];
      s.a = a;
      s.half = half;
      s.side = sign;
    };
    const auto disc = [&](double radius) -> Norm& {
      Norm& o = norms_[std::size_t(norm_count_++)];
      o.m.row(0) = radius * axis(0).transpose();
      o.m.row(1) = radius * axis(1).transpose();
      o.most = o.least = radius;
      o.flat = true;
      o.pole = axis(2);
      o.side = sign;
      return o;
    };
    const auto& h = side.half;
    using Kind = SolidCore::Kind;
    const std::size_t which = sign > 0 ? 0 : 1;
    if (side.rotated) axes_[which] = side.rotation;
    // Without extent in some direction a shape has no inside, whatever its name.
    core_[which] = {!(h.minCoeff() > 0)                               ? Kind::flat
                    : std::holds_alternative<Box<Given>>(shape)       ? Kind::box
                    : std::holds_alternative<Ellipsoid<Given>>(shape) ? Kind::ellipsoid
                    : std::holds_alternative<Cylinder<Given>>(shape)  ? Kind::cylinder
                    : std::holds_alternative<Cone<Given>>(shape)      ? Kind::cone
                                                                      : Kind::flat,
                    h};
    if (std::holds_alternative<Point<Given>>(shape) || std::holds_alternative<Sphere<Given>>(shape))
      return true;
    if (std::holds_alternative<Capsule<Given>>(shape)) {
      seam(axis(2), h[2]);
      return true;
    }
    if (std::holds_alternative<Segment<Given>>(shape)) {
      const Vec e = side.to_world(Vec(0.5 * (side.few[1] - side.few[0]))),
                m = side.to_world(Vec(0.5 * (side.few[1] + side.few[0])));
      center_ += sign * m;
      middle_[sign > 0 ? 0 : 1] = m;
      const double length = norm(e);
      if (length > 0) seam(Vec(e / length), length);
      return true;
    }
    if (std::holds_alternative<Box<Given>>(shape)) {
      for (int i = 0; i < 3; ++i) seam(axis(i), h[i]);
      return true;
    }
    if (std::holds_alternative<Cylinder<Given>>(shape)) {
      seam(axis(2), h[2]);
      if (h[0] > 0) disc(h[0]);
      return true;
    }
    if (std::holds_alternative<Cone<Given>>(shape)) {
      if (!(h[0] > 0)) {
        seam(axis(2), h[2]);
        return true;
      }
      if (!(h[2] > 0)) {
        disc(h[0]);
        return true;
      }
      disc(h[0]).seam = seam_count_;
      Seam& s = seams_[std::size_t(seam_count_++)];
      s.a = sign * axis(2);
      s.half = h[2];
      s.cone = true;
      const double slant = hypotenuse(h[0], 2 * h[2]);
      s.level = h[0] / slant;
      s.across = 2 * h[2] / slant;
      s.side = sign;
      return true;
    }
    if (std::holds_alternative<Ellipsoid<Given>>(shape)) {
      std::array<int, 3> by = {0, 1, 2};
      std::stable_sort(by.begin(), by.end(), [&](int i, int j) { return h[i] > h[j]; });
      if (!(h[by[0]] > 0)) return true;
      if (!(h[by[1]] > 0)) {
        seam(axis(by[0]), h[by[0]]);
        return true;
      }
      Norm& o = norms_[std::size_t(norm_count_++)];
      for (int i = 0; i < 3; ++i) o.m.row(i) = h[i] * axis(i).transpose();
      o.most = h[by[0]];
      o.least = h[by[1]];
      o.side = sign;
      if (!(h[by[2]] > 0)) {
        o.flat = true;
        o.pole = axis(by[2]);
      }
      return true;
    }
    return false;
  }

  Vec offset_ = Vec::Zero();
  std::array<SolidCore, 2> core_;
  std::array<Mat3<double>, 2> axes_ = {Mat3<double>(Mat3<double>::Identity()),
                                       Mat3<double>(Mat3<double>::Identity())};
  std::array<Vec, 2> middle_ = {Vec(Vec::Zero()), Vec(Vec::Zero())};
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
