// min over unit n of h(n), for the core C of two primitives of which one at least is curved. penetration() calls it for
// points, segments, spheres, capsules, boxes, ellipsoids, cylinders and cones whose cores overlap.
// Units: internal (cso.hpp).   Frame: world axes.
//
//   h(n) = c.n + sum |m_k n| + sum half_i |a_i.n| + sum max(apex, base):   c the offset of the centres, m_k n the radii of
//   an ellipsoid or a disc times n's own coordinates, a_i and half_i the segments of boxes, cylinders and capsules.
//
// h is smooth but on the seams, where two pieces of it meet: the great circles n.a_i = 0, and the circle of latitude where
// a cone's apex and base are equally far. So the least h is one of
//   a corner   where two seams cross, or at the pole of a disc;
//   a circle   least along a seam;
//   a sphere   least of a smooth piece, which takes curvature in both directions.
// The corners are evaluated. Circles and sphere are cut into cells of latitude and azimuth, and a cell is done with where
//   a support point w of its middle shows h >= upper - gap: h(n) >= w.n;
//   no piece has a minimum in it: an interval of a first derivative is without 0, or one of a second is below 0;
//   second derivatives bound the piece from below by upper - gap, about a point that Newton finds.
// What is equally near along a whole circle is no trouble: the azimuth of the cells is about the axis that the pair is nearest
// to symmetric about, and derivatives by it are formed from the differences that break the symmetry, so they vanish with it.
//
// Guarantee: lower <= min h <= upper = h(n), up to `Cso::rounding` and the slacks below; upper - lower <= gap unless the
// budget ends.   Intervals are not rounded outwards: each is compared with a slack above its rounding.
#pragma once

#include <algorithm>
#include <array>
#include <graze/result.hpp>
#include <graze/support/cso.hpp>

namespace graze::inline GRAZE_LINKAGE {

namespace detail {

// The numbers between lo and hi. Rounding is left to the slack of whoever compares.
struct Interval {
  double lo = 0, hi = 0;
  Interval() = default;
  Interval(double x) : lo(x), hi(x) {}  // NOLINT: a number is one
  Interval(double l, double h) : lo(l), hi(h) {}
};
inline Interval operator+(Interval x, Interval y) { return {x.lo + y.lo, x.hi + y.hi}; }
inline Interval operator-(Interval x, Interval y) { return {x.lo - y.hi, x.hi - y.lo}; }
inline Interval operator-(Interval x) { return {-x.hi, -x.lo}; }
inline Interval operator*(double s, Interval x) {
  return s >= 0 ? Interval{s * x.lo, s * x.hi} : Interval{s * x.hi, s * x.lo};
}
inline Interval operator*(Interval x, Interval y) {
  const double a = x.lo * y.lo, b = x.lo * y.hi, c = x.hi * y.lo, d = x.hi * y.hi;
  return {std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d))};
}
inline Interval square(Interval x) {
  const double a = x.lo * x.lo, b = x.hi * x.hi;
  return {x.lo <= 0 && x.hi >= 0 ? 0 : std::min(a, b), std::max(a, b)};
}
inline double square(double x) { return x * x; }
inline double largest(Interval x) { return std::max(-x.lo, x.hi); }
inline Interval clipped(Interval x, double lo, double hi) {
  return {std::min(std::max(x.lo, lo), hi), std::max(std::min(x.hi, hi), lo)};
}

// First and second derivatives by the latitude t and the azimuth p, T: a number or an interval.
template <class T>
struct Slopes {
  T t{0}, p{0}, tt{0}, tp{0}, pp{0};
  Slopes& operator+=(const Slopes& o) {
    t = t + o.t;
    p = p + o.p;
    tt = tt + o.tt;
    tp = tp + o.tp;
    pp = pp + o.pp;
    return *this;
  }
};
// (cos, sin) of the latitude, (cos, sin) of the azimuth.
template <class T>
struct Place {
  T c, s, x, y;
};

}  // namespace detail

// Support evaluations: what takes more is seldom, and left to the other search.
inline constexpr int kMostRoundDepthSupports = 2048;

class RoundDepth {
 public:
  using Vec = Vec3<double>;
  using Interval = detail::Interval;

  template <Scalar Given>
  [[nodiscard]] bool set(const Cso<double>& cso, const Shape<Given>& a, const Shape<Given>& b) {
    center_ = -cso.offset();
    scale_ = cso.scale();
    return add(cso.side_a(), a, 1) && add(cso.side_b(), b, -1) && norm_count_ > 0;
  }

  void run(double gap, int budget, Counters& counters) {
    gap_ = gap;
    budget_ = budget;
    counters_ = &counters;
    upper_ = kInfinity<double>;
    lower_ = kInfinity<double>;
    corners();
    for (int i = 0; i < seam_count_; ++i) search_circle(i);
    if (may_have_smooth_minimum()) search_sphere();
    lower_ = std::min(lower_, upper_);
    polish();
  }
  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }
  [[nodiscard]] const Vec& normal() const { return n_; }
  // Points of the cores about the bodies' centres, internal units, world axes.
  [[nodiscard]] std::array<Vec, 2> points() const {
    struct Part {
      Vec x = Vec::Zero(), along = Vec::Zero();  // x + k along, k in [0, 1], where it is free
      int side = 1;
    };
    std::array<Part, 10> part;
    std::size_t count = 0;
    const auto rim = [&](const Norm& o) -> Vec {
      const Vec y = o.m * n_;
      const double f = y.norm();
      return f > 0 ? Vec(o.m.transpose() * (y / f)) : Vec(Vec::Zero());
    };
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      Part& p = part[count++];
      p.side = s.side;
      const double u = s.a.dot(n_);
      const bool is_free = i == free_[0] || i == free_[1] || (!s.cone && std::abs(u) <= 4 * kU);
      const Vec top = s.half * s.a;
      Vec low = -top;
      bool above = u >= 0;
      if (s.cone) {
        const Norm& o = norms_[std::size_t(norm_of(i))];
        low += rim(o);
        above = top.dot(n_) >= low.dot(n_);
      }
      p.x = above && !is_free ? top : low;
      if (is_free) p.along = top - low;
    }
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      if (o.seam >= 0) continue;
      part[count].x = i == free_disc_ ? Vec(Vec::Zero()) : rim(o);
      part[count++].side = o.side;
    }
    Vec rest = center_;
    for (std::size_t i = 0; i < count; ++i) rest += part[i].x;
    rest -= rest.dot(n_) * n_;
    // What is free takes the sum onto n: one after the other, as two that meet at an angle need a few rounds.
    std::array<double, 10> k{};
    for (int round = 0; round < 64; ++round) {
      double moved = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const Vec e = part[i].along - part[i].along.dot(n_) * n_;
        const double length_sq = e.squaredNorm();
        if (!(length_sq > 0)) continue;
        const double to = std::clamp(k[i] - rest.dot(e) / length_sq, 0.0, 1.0);
        rest += (to - k[i]) * e;
        moved = std::max(moved, std::abs(to - k[i]));
        k[i] = to;
      }
      if (moved <= 1e-16) break;
    }
    for (std::size_t i = 0; i < count; ++i) part[i].x += k[i] * part[i].along;
    if (free_disc_ >= 0) {
      const Norm& o = norms_[std::size_t(free_disc_)];
      // least <= every radius of the disc
      const double length = rest.norm();
      Vec y = -rest;
      if (length > o.least) y *= o.least / length;
      part[count].x = y;
      part[count++].side = o.side;
    }
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

 private:
  // |m n|
  struct Norm {
    Mat3<double> m = Mat3<double>::Zero();
    double most = 0, least = 0;  // radii; least: of the two of a flat one
    bool flat = false;
    Vec pole = Vec::Zero();
    int seam = -1;  // of a cone: present on its base's side
    int side = 1;
  };
  // Where two pieces of h meet: h has half |n.a| (level 0), or a cone's two pieces at n.a = level.
  struct Seam {
    Vec a = Vec::Zero();
    double half = 0, level = 0, across = 1;  // across: sqrt(1 - level^2)
    bool cone = false;
    int side = 1;
  };
  // A norm's form in a chart.
  struct Form {
    double p33 = 0, m = 0, d = 0, p12 = 0, p13 = 0, p23 = 0, most = 0;
    bool axial = false;  // a disc about the chart's axis
  };
  struct Chart {
    Vec e1, e2, a;
    std::array<Form, 2> form;
    std::array<Vec, 8> seam;  // in the chart's axes
    Vec center;
    int owner = -1;
    [[nodiscard]] Vec own(const Vec& x) const { return {e1.dot(x), e2.dot(x), a.dot(x)}; }
    [[nodiscard]] Vec at(const detail::Place<double>& z) const {
      return z.c * (z.x * e1 + z.y * e2) + z.s * a;
    }
  };
  struct Cell {
    double c0, s0, c1, s1, x0, y0, x1, y1;  // unit vectors of the ends
    double a, b;                            // half widths
    double bound = 0, h = 0, rho = 0;
    detail::Place<double> mid{};
  };

  static constexpr double kU = kUnitRoundoff<double>;

  template <Scalar Given>
  bool add(const detail::Side<double>& side, const Shape<Given>& shape, int sign) {
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
      const double length = e.norm();
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
      const double slant = std::hypot(h[0], 2 * h[2]);
      s.level = h[0] / slant;
      s.across = 2 * h[2] / slant;
      s.side = sign;
      return true;
    }
    if (std::holds_alternative<Ellipsoid<Given>>(shape)) {
      std::array<int, 3> by = {0, 1, 2};
      std::sort(by.begin(), by.end(), [&](int i, int j) { return h[i] > h[j]; });
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

  // h(n), and the support point.
  double value(const Vec& n, Vec* support = nullptr, int without = -1) const {
    double h = center_.dot(n);
    Vec w = center_;
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      if (o.seam >= 0 || i == without) continue;
      const Vec y = o.m * n;
      const double f = y.norm();
      h += f;
      if (support && f > 0) w += o.m.transpose() * (y / f);
    }
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      const double u = s.a.dot(n);
      if (!s.cone) {
        h += s.half * std::abs(u);
        if (support) w += (u >= 0 ? s.half : -s.half) * s.a;
        continue;
      }
      const Norm& o = norms_[std::size_t(norm_of(i))];
      const Vec y = o.m * n;
      const double f = y.norm(), apex = s.half * u, base = f - s.half * u;
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

  // A value of h, and what of the support point is free there: seams, or the disc of a norm.
  double offer(const Vec& n, int first = -1, int second = -1, int disc = -1) {
    ++counters_->supports;
    --budget_;
    const double h = value(n);
    if (h < upper_) {
      upper_ = h;
      n_ = n;
      free_ = {first, second};
      free_disc_ = disc;
    }
    return h;
  }

  void corners() {
    for (int i = 0; i < norm_count_; ++i) {
      Norm& o = norms_[std::size_t(i)];
      if (!o.flat) continue;
      for (const double sign : {1.0, -1.0}) {
        const Vec n = sign * o.pole;
        Vec w;
        const double h = offer(n, -1, -1, i);
        value(n, &w, i);
        // What is free at the pole goes against the rest: any point of a seam's segment bounds h from below.
        for (int k = 0; k < seam_count_; ++k) {
          const Seam& s = seams_[std::size_t(k)];
          const double u = s.a.dot(n);
          if (s.cone || !(std::abs(u) <= 4 * kU)) continue;
          const double along = (w - w.dot(n) * n).dot(s.a);
          w -= (u >= 0 ? std::clamp(along, 0.0, 2 * s.half) : std::clamp(along, -2 * s.half, 0.0)) * s.a;
        }
        // Within this angle of the pole no h is below that of the pole: h(n') >= w.n' + least |n' x pole|.
        const double spare = o.least - (w - w.dot(n) * n).norm();
        const bool present = o.seam < 0 || n.dot(seams_[std::size_t(o.seam)].a) < 0;
        caps_[std::size_t(cap_count_++)] = {n, present && spare > 0 && h > 0 ? 2 * std::atan(spare / h) : 0.0,
                                            h};
      }
    }
    for (int i = 0; i < seam_count_; ++i) {
      for (int j = i + 1; j < seam_count_; ++j) {
        const Seam &s = seams_[std::size_t(i)], &o = seams_[std::size_t(j)];
        const Vec e = s.a.cross(o.a);
        const double sin_sq = e.squaredNorm(), cosine = s.a.dot(o.a);
        if (!(sin_sq > 0)) continue;
        const double alpha = (s.level - o.level * cosine) / sin_sq,
                     beta = (o.level - s.level * cosine) / sin_sq;
        const Vec in = alpha * s.a + beta * o.a;
        const double rest = (1 - in.squaredNorm()) / sin_sq;
        if (!(rest >= 0)) continue;
        const double g = std::sqrt(rest);
        for (const double sign : {1.0, -1.0}) offer(unit(Vec(in + sign * g * e)), i, j);
      }
    }
  }

  // A smooth piece of h has a minimum inside only where C is curved in both directions.
  [[nodiscard]] bool may_have_smooth_minimum() const {
    bool round = norm_count_ == 2;
    for (int i = 0; i < norm_count_; ++i) round = round || !norms_[std::size_t(i)].flat;
    return round;
  }

  [[nodiscard]] Chart chart(const Vec& axis) const {
    Chart out;
    out.a = axis;
    const Vec m = axis.cwiseAbs();
    const Vec other = m[0] <= m[1] && m[0] <= m[2] ? Vec(Vec::UnitX())
                      : m[1] <= m[2]               ? Vec(Vec::UnitY())
                                                   : Vec(Vec::UnitZ());
    out.e1 = unit(Vec(axis.cross(other)));
    out.e2 = axis.cross(out.e1);
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      Form& f = out.form[std::size_t(i)];
      const Vec x = o.m * out.e1, y = o.m * out.e2, z = o.m * out.a;
      f.p33 = z.squaredNorm();
      f.m = (x.squaredNorm() + y.squaredNorm()) / 2;
      f.d = (x + y).dot(x - y) / 2;
      f.p12 = x.dot(y);
      f.p13 = x.dot(z);
      f.p23 = y.dot(z);
      f.most = o.most;
      f.axial = o.flat && o.pole.cross(axis).squaredNorm() <= 16 * kU * kU && o.least == o.most;
    }
    for (int i = 0; i < seam_count_; ++i) out.seam[std::size_t(i)] = out.own(seams_[std::size_t(i)].a);
    out.center = out.own(center_);
    return out;
  }
  // How far from symmetric about an axis.
  [[nodiscard]] double skew(const Vec& axis) const {
    const Chart c = chart(axis);
    double out = std::hypot(c.center[0], c.center[1]);
    for (int i = 0; i < norm_count_; ++i) {
      const Form& f = c.form[std::size_t(i)];
      out += (std::abs(f.d) + std::abs(f.p12) + std::abs(f.p13) + std::abs(f.p23)) / f.most;
    }
    return out;
  }

  template <class T>
  static void add_linear(const Vec& b, const detail::Place<T>& z, detail::Slopes<T>& out) {
    const T l = b[0] * z.x + b[1] * z.y, l_p = b[1] * z.x - b[0] * z.y;
    const T g = z.c * l + b[2] * z.s;
    out.t = out.t + (b[2] * z.c - z.s * l);
    out.p = out.p + z.c * l_p;
    out.tt = out.tt - g;
    out.tp = out.tp - z.s * l_p;
    out.pp = out.pp - z.c * l;
  }
  template <class T>
  static T height(const Vec& b, const detail::Place<T>& z) {
    return z.c * (b[0] * z.x + b[1] * z.y) + b[2] * z.s;
  }

  // value: of the norm, > 0.
  template <class T>
  static detail::Slopes<T> slopes_of(const Form& f, const detail::Place<T>& z, const T& value,
                                     const T& inverse) {
    using detail::square;
    detail::Slopes<T> out;
    if (f.axial) {
      out.t = -(f.most * z.s);
      out.tt = -(f.most * z.c);
      return out;
    }
    const T sin2p = 2 * (z.x * z.y), cos2p = T(1) - 2 * square(z.y);
    const T B = f.d * cos2p + f.p12 * sin2p, B_p = 2 * (f.p12 * cos2p - f.d * sin2p);
    const T L = f.p13 * z.x + f.p23 * z.y, L_p = f.p23 * z.x - f.p13 * z.y;
    const T sin2 = 2 * (z.s * z.c), cos2 = T(1) - 2 * square(z.s), cc = square(z.c);
    const T rest = T(f.p33 - f.m) - B;
    (void)value;
    const T half = 0.5 * inverse;
    out.t = half * (sin2 * rest + 2 * (cos2 * L));
    out.p = half * (cc * B_p + sin2 * L_p);
    out.tt = inverse * ((cos2 * rest - 2 * (sin2 * L)) - square(out.t));
    out.tp = inverse * ((cos2 * L_p - 0.5 * (sin2 * B_p)) - out.t * out.p);
    out.pp = inverse * (-(2 * (cc * B)) - 0.5 * (sin2 * L) - square(out.p));
    return out;
  }

  // Which pieces of h there are: bit i: above seam i (n.a > level).
  using Piece = unsigned;
  [[nodiscard]] Vec linear_part(const Chart& c, Piece piece) const {
    Vec out = c.center;
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      if (i == c.owner && !s.cone) continue;
      out += (piece >> i & 1 ? s.half : -s.half) * c.seam[std::size_t(i)];
    }
    return out;
  }
  [[nodiscard]] bool has_norm(int i, Piece piece) const {
    const int seam = norms_[std::size_t(i)].seam;
    return seam < 0 || !(piece >> seam & 1);
  }
  // At a point.
  double piece_value(const Chart& c, Piece piece, const Vec& b, const detail::Place<double>& z,
                     detail::Slopes<double>& slopes) const {
    double h = height(b, z);
    slopes = {};
    add_linear(b, z, slopes);
    const Vec n = c.at(z);
    for (int i = 0; i < norm_count_; ++i) {
      if (!has_norm(i, piece)) continue;
      const double f = (norms_[std::size_t(i)].m * n).norm();
      h += f;
      if (f > 0) slopes += slopes_of<double>(c.form[std::size_t(i)], z, f, 1 / f);
    }
    return h;
  }

  static detail::Place<double> turned(const detail::Place<double>& z, double t, double p) {
    const double ct = std::cos(t), st = std::sin(t), cp = std::cos(p), sp = std::sin(p);
    return {z.c * ct - z.s * st, z.s * ct + z.c * st, z.x * cp - z.y * sp, z.y * cp + z.x * sp};
  }

  // The least that b x + h/2 x^2 can be for |x - at| <= half, given as lo <= x <= hi.
  static double least_of(double b, double h, double lo, double hi) {
    const auto q = [&](double x) { return x * (b + 0.5 * h * x); };
    double out = std::min(q(lo), q(hi));
    if (h > 0) {
      const double x = std::clamp(-b / h, lo, hi);
      out = std::min(out, q(x));
    }
    return out;
  }

  // The middle of a cell, and what a support there says of all of it. False: it is done with.
  bool look(const Chart& c, Cell& box) {
    detail::Place<double>& mid = box.mid;
    mid = {box.c0 + box.c1, box.s0 + box.s1, box.x0 + box.x1, box.y0 + box.y1};
    const double k = 1 / std::sqrt(mid.c * mid.c + mid.s * mid.s),
                 l = 1 / std::sqrt(mid.x * mid.x + mid.y * mid.y);
    mid.c *= k;
    mid.s *= k;
    mid.x *= l;
    mid.y *= l;
    const Vec n = c.at(mid);
    Vec w;
    ++counters_->supports;
    --budget_;
    const double h = box.h = value(n, &w);
    if (h < upper_) {
      upper_ = h;
      n_ = n;
      free_ = {c.owner, -1};
      free_disc_ = -1;
    }
    // No farther from the middle than rho.
    box.rho = box.a + std::max(std::max(box.c0, box.c1), mid.c) * box.b;
    const double across = std::sqrt(std::max(0.0, w.squaredNorm() - h * h));
    // Of w.n, over angles below a right one.
    if (box.rho < 1.5) {
      const double bound = (h >= 0 ? h * std::cos(box.rho) : h) - across * std::sin(box.rho);
      box.bound = std::max(box.bound, bound);
    }
    if (!(box.bound >= upper_ - gap_)) return true;
    lower_ = std::min(lower_, box.bound);
    return false;
  }

  // Is this box done with? Else which way to cut it: 0 by latitude, 1 by azimuth.
  bool settled(const Chart& c, Cell& box, int& way) {
    using namespace detail;
    const bool line = c.owner >= 0;
    const Place<double>& mid = box.mid;
    const double rho = box.rho;
    const Vec n = c.at(mid);
    for (int i = 0; i < cap_count_; ++i) {
      const Cap& cap = caps_[std::size_t(i)];
      if (!(cap.angle > rho)) continue;
      const double chord = (n - cap.n).norm();  // <= angle
      if (chord < 1.9 && 2 * std::asin(chord / 2) + rho < cap.angle) return true;
    }
    const Place<Interval> z =
        line ? Place<Interval>{box.c0, box.s0, between(box.x0, box.x1), between(box.y0, box.y1)}
             : Place<Interval>{between(box.c0, box.c1), between(box.s0, box.s1), between(box.x0, box.x1),
                               between(box.y0, box.y1)};
    const double slack = 8 * kU * scale_;
    // The norms.
    std::array<Slopes<Interval>, 2> norm;
    for (int i = 0; i < norm_count_; ++i) {
      const Form& f = c.form[std::size_t(i)];
      const double at = (norms_[std::size_t(i)].m * n).norm(), far = f.most * rho;
      Interval value{at - far, at + far};
      Slopes<Interval>& s = norm[std::size_t(i)];
      if (f.axial) {
        s = slopes_of<Interval>(f, z, value, 1);
        continue;
      }
      // by the form
      const Interval sin2p = 2 * (z.x * z.y), cos2p = Interval(1) - 2 * square(z.y);
      const Interval q = f.p33 * square(z.s) + square(z.c) * (Interval(f.m) + (f.d * cos2p + f.p12 * sin2p)) +
                         2 * ((z.s * z.c) * (f.p13 * z.x + f.p23 * z.y));
      const double doubt = 16 * kU * f.most * f.most;
      value.lo = std::max(value.lo, std::sqrt(std::max(q.lo - doubt, 0.0)));
      value.hi = std::min(value.hi, std::sqrt(q.hi + doubt));
      const double top = f.most, c_top = std::max(std::abs(z.c.lo), std::abs(z.c.hi));
      if (value.lo > 64 * kU * top) {
        const Interval inverse{1 / value.hi, 1 / value.lo};
        s = slopes_of<Interval>(f, z, value, inverse);
        const double more = doubt / value.lo;
        const double twice = (doubt + 3 * top * more) / value.lo;
        s.t = s.t + Interval{-more, more};
        s.p = s.p + Interval{-more * c_top, more * c_top};
        s.tt = s.tt + Interval{-twice, twice};
        s.tp = s.tp + Interval{-twice * c_top, twice * c_top};
        s.pp = s.pp + Interval{-twice * c_top, twice * c_top};
        s.t = clipped(s.t, -top, top);
        s.p = clipped(s.p, -top * c_top, top * c_top);
        s.tt.lo = std::max(s.tt.lo, -value.hi);
        s.pp.lo = std::max(s.pp.lo, -top * c_top);
      } else {
        constexpr double inf = 0x1p60;  // as good as infinite beside the scale, and its square is a number
        s.t = {-top, top};
        s.p = {-top * c_top, top * c_top};
        s.tt = {-value.hi, inf};
        s.tp = {-inf, inf};
        s.pp = {-top * c_top, inf};
      }
    }
    // Which seams run through the box?
    Piece sure = 0;
    std::array<int, 8> open{};
    int open_count = 0;
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      if (i == c.owner) {
        sure |= 1u << i;
        continue;
      }
      Interval u = height(c.seam[std::size_t(i)], z);
      const double at = s.a.dot(n);
      u.lo = std::max(u.lo, at - rho);
      u.hi = std::min(u.hi, at + rho);
      if (u.lo > s.level) {
        sure |= 1u << i;
      } else if (!(u.hi < s.level)) {
        open[std::size_t(open_count++)] = i;
      }
    }
    bool all = true;
    double score_t = 0, score_p = 0, worst = kInfinity<double>;
    for (unsigned choice = 0; choice < 1u << open_count; ++choice) {
      Piece piece = sure;
      for (int k = 0; k < open_count; ++k) {
        if (choice >> k & 1) piece |= 1u << open[std::size_t(k)];
      }
      const Vec b = linear_part(c, piece);
      Slopes<Interval> s;
      add_linear(b, z, s);
      for (int i = 0; i < norm_count_; ++i) {
        if (has_norm(i, piece)) s += norm[std::size_t(i)];
      }
      if (s.p.lo > slack || s.p.hi < -slack || s.pp.hi < -slack) continue;
      if (!line && (s.t.lo > slack || s.t.hi < -slack || s.tt.hi < -slack)) continue;
      Slopes<double> g;
      double f = piece_value(c, piece, b, mid, g);
      // Along the slope in the middle, by how much it can change to there.
      {
        const double tt = largest(s.tt) * box.a, tp = largest(s.tp), pp = largest(s.pp) * box.b;
        const double off_t = tt + tp * box.b, off_p = tp * box.a + pp;
        if (line ? std::abs(g.p) - pp > slack
                 : std::abs(g.t) - off_t > slack || std::abs(g.p) - off_p > slack ||
                       g.t * g.t + g.p * g.p - std::abs(g.t) * off_t - std::abs(g.p) * off_p >
                           slack * (std::abs(g.t) + std::abs(g.p)))
          continue;
      }
      // What the piece is at least, by its second derivatives about a point that is nearly its least.
      double t = 0, p = 0;
      Place<double> at = mid;
      for (int round = 0; round < 4; ++round) {
        double dt = 0, dp = 0;
        if (!newton_step(g, line, slack, dt, dp)) break;
        const double to_t = std::clamp(t + dt, -box.a, box.a), to_p = std::clamp(p + dp, -box.b, box.b);
        if (std::abs(to_t - t) + std::abs(to_p - p) <= 1e-9 * (box.a + box.b)) break;
        const Place<double> next = turned(mid, to_t, to_p);
        Slopes<double> g_next;
        const double f_next = piece_value(c, piece, b, next, g_next);
        if (!(f_next <= f + slack)) break;
        t = to_t;
        p = to_p;
        at = next;
        g = g_next;
        f = f_next;
      }
      if (t != 0 || p != 0) offer(unit(c.at(at)), c.owner);
      double bound;
      const double lo_p = -box.b - p, hi_p = box.b - p, lo_t = -box.a - t, hi_t = box.a - t;
      if (line) {
        bound = f + least_of(g.p, s.pp.lo, lo_p, hi_p);
      } else {
        const double cross = largest(s.tp);
        double h_t = s.tt.lo, h_p = s.pp.lo;
        // h_t/2 dt^2 - cross |dt dp| >= -cross^2 / (2 h_t) dp^2
        double lost = 0;
        if (cross > 0) {
          if (h_t > 0 && h_t * h_p >= cross * cross) {
            const double part = h_p > 0 ? cross * std::sqrt(h_t / h_p) : 0;
            h_p -= h_p > 0 ? cross * std::sqrt(h_p / h_t) : 0;
            h_t -= part;
          } else {
            lost = cross * std::max(-lo_t, hi_t) * std::max(-lo_p, hi_p);
            // or at the cost of h_p
            if (h_t > 0) {
              const double h2 = h_p - 2 * cross * cross / h_t;
              const double one = least_of(g.t, h_t / 2, lo_t, hi_t) + least_of(g.p, h2, lo_p, hi_p);
              const double two = least_of(g.t, h_t, lo_t, hi_t) + least_of(g.p, h_p, lo_p, hi_p) - lost;
              lost = 0;
              h_t = h_p = 0;
              bound = f + std::max(one, two);
              goto have;
            }
          }
        }
        bound = f + least_of(g.t, h_t, lo_t, hi_t) + least_of(g.p, h_p, lo_p, hi_p) - lost;
      have:;
      }
      if (bound >= upper_ - gap_) {
        lower_ = std::min(lower_, bound);
        continue;
      }
      all = false;
      worst = bound < worst ? bound : worst;
      score_t = std::max(score_t, line ? 0 : std::min((s.t.hi - s.t.lo) * box.a, 2 * scale_ * box.a));
      score_p = std::max(score_p, std::min((s.p.hi - s.p.lo) * box.b, 2 * scale_ * box.b));
    }
    way = line || score_p > score_t ? 1 : 0;
    if (!all && worst > box.bound) box.bound = std::max(box.bound, std::min(worst, upper_));
    return all;
  }
  static Interval between(double x, double y) { return {std::min(x, y), std::max(x, y)}; }

  void search(const Chart& c, std::array<Cell, 8>& first, int count) {
    std::array<Cell, 128> stack;
    std::size_t size = 0;
    for (int i = 0; i < count; ++i) {
      if (look(c, first[std::size_t(i)])) stack[size++] = first[std::size_t(i)];
    }
    std::sort(stack.begin(), stack.begin() + long(size),
              [](const Cell& l, const Cell& r) { return l.h > r.h; });
    while (size > 0) {
      Cell box = stack[--size];
      if (box.bound >= upper_ - gap_) {
        lower_ = std::min(lower_, box.bound);
        continue;
      }
      int way = 0;
      if (budget_ <= 0 || size + 2 > stack.size() || std::max(box.a, box.b) < 1e-12) {
        lower_ = std::min(lower_, box.bound);
        continue;
      }
      if (settled(c, box, way)) continue;
      Cell low = box, high = box;
      if (way == 0) {
        low.c1 = high.c0 = box.mid.c;
        low.s1 = high.s0 = box.mid.s;
        low.a = high.a = box.a / 2;
      } else {
        low.x1 = high.x0 = box.mid.x;
        low.y1 = high.y0 = box.mid.y;
        low.b = high.b = box.b / 2;
      }
      const bool has_low = look(c, low), has_high = look(c, high);
      if (has_low && has_high && low.h < high.h) std::swap(low, high);
      if (has_low && has_high) {
        stack[size++] = low;
        stack[size++] = high;
      } else if (has_low || has_high) {
        stack[size++] = has_low ? low : high;
      }
    }
  }

  static constexpr double kQuarter = 0.78539816339744831;  // pi / 4
  void search_circle(int seam) {
    const Seam& s = seams_[std::size_t(seam)];
    Chart c = chart(s.a);
    c.owner = seam;
    std::array<Cell, 8> first;
    for (int i = 0; i < 4; ++i) first[std::size_t(i)] = quadrant(i, s.across, s.level, s.across, s.level, 0);
    search(c, first, 4);
  }
  static Cell quadrant(int i, double c0, double s0, double c1, double s1, double a) {
    constexpr std::array<double, 5> x = {1, 0, -1, 0, 1}, y = {0, 1, 0, -1, 0};
    const auto k = std::size_t(i);
    return {c0, s0, c1, s1, x[k], y[k], x[k + 1], y[k + 1], a, kQuarter, -kInfinity<double>, 0, 0, {}};
  }
  void search_sphere() {
    // About the axis about which the pair is nearest to symmetric.
    Vec axis = Vec::UnitZ();
    double least = kInfinity<double>;
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      for (int k = 0; k < 3; ++k) {
        Vec a = o.m.row(k).transpose();
        if (o.flat && !(a.norm() > 0)) a = o.pole;
        if (!(a.norm() > 0)) continue;
        a = unit(a);
        if (const double one = skew(a); one < least) {
          least = one;
          axis = a;
        }
      }
    }
    const Chart c = chart(axis);
    std::array<Cell, 8> first;
    for (int i = 0; i < 4; ++i) {
      first[std::size_t(2 * i)] = quadrant(i, 0, -1, 1, 0, kQuarter);
      first[std::size_t(2 * i + 1)] = quadrant(i, 1, 0, 0, 1, kQuarter);
    }
    search(c, first, 8);
  }

  // h tells n to the root of the rounding only: on, while the slope falls.
  void polish() {
    if (free_[1] >= 0 || free_disc_ >= 0) return;
    const bool line = free_[0] >= 0;
    const Vec m = n_.cwiseAbs();
    Chart c = chart(line ? seams_[std::size_t(free_[0])].a
                         : unit(Vec(n_.cross(m[0] <= m[1] && m[0] <= m[2] ? Vec(Vec::UnitX())
                                             : m[1] <= m[2]               ? Vec(Vec::UnitY())
                                                                          : Vec(Vec::UnitZ())))));
    if (line) c.owner = free_[0];
    const Vec own = c.own(n_);
    detail::Place<double> z{std::hypot(own[0], own[1]), own[2], 1, 0};
    if (!(z.c > 0)) return;
    z.x = own[0] / z.c;
    z.y = own[1] / z.c;
    Piece piece = 0;
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      if (i == c.owner || s.a.dot(n_) > s.level) piece |= 1u << i;
    }
    const Vec b = linear_part(c, piece);
    detail::Slopes<double> g;
    piece_value(c, piece, b, z, g);
    const double slack = 8 * kU * scale_;
    for (int round = 0; round < 4; ++round) {
      double dt = 0, dp = 0;
      if (!newton_step(g, line, slack, dt, dp)) return;
      const detail::Place<double> next = turned(z, dt, dp);
      detail::Slopes<double> then;
      piece_value(c, piece, b, next, then);
      const auto size = [&](const detail::Slopes<double>& s) {
        return (line ? 0 : std::abs(s.t)) + std::abs(s.p);
      };
      const Vec n = unit(c.at(next));
      const double h = value(n);
      ++counters_->supports;
      if (!(size(then) < size(g)) || !(h <= upper_ + slack)) return;
      n_ = n;
      upper_ = h;
      z = next;
      g = then;
    }
  }
  // Towards where the slopes vanish, along what bends up. False: nothing does.
  static bool newton_step(const detail::Slopes<double>& g, bool line, double slack, double& dt, double& dp) {
    const double det = g.tt * g.pp - g.tp * g.tp;
    const bool t_up = g.tt > slack && !line, p_up = g.pp > slack;
    if (t_up && p_up && det > 1e-9 * g.tt * g.pp) {
      dt = (g.tp * g.p - g.pp * g.t) / det;
      dp = (g.tp * g.t - g.tt * g.p) / det;
    } else if (t_up) {
      dt = -g.t / g.tt;
    } else if (p_up) {
      dp = -g.p / g.pp;
    } else {
      return false;
    }
    return true;
  }

  struct Cap {
    Vec n;
    double angle, h;
  };
  Vec center_ = Vec::Zero(), n_ = Vec::Zero();
  double scale_ = 1, gap_ = 0, lower_ = 0, upper_ = 0;
  std::array<Vec, 2> middle_ = {Vec(Vec::Zero()), Vec(Vec::Zero())};
  int budget_ = 0, norm_count_ = 0, seam_count_ = 0, cap_count_ = 0, free_disc_ = -1;
  std::array<int, 2> free_ = {-1, -1};
  std::array<Norm, 2> norms_;
  std::array<Seam, 8> seams_;
  std::array<Cap, 4> caps_;
  Counters* counters_ = nullptr;
};

}  // namespace graze::inline GRAZE_LINKAGE
