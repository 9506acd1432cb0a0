// First and second derivatives of a sum's support function in spherical coordinates, of numbers or of intervals.
//
// h is smooth but on the seams, where two pieces of it meet. A chart has an axis: n = cos t (cos p e1 + sin p e2) + sin t a, t
// the latitude and p the azimuth. By the azimuth, derivatives are formed from the differences that break the symmetry about
// the axis, so they vanish with it.
#pragma once

#include <graze/detail/numeric/interval.hpp>
#include <graze/detail/search/smooth/round_sum.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

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

class RoundSlopes : public RoundSum {
 protected:
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
    [[nodiscard]] Vec own(const Vec& x) const { return {dot(e1, x), dot(e2, x), dot(a, x)}; }
    [[nodiscard]] Vec at(const Place<double>& z) const { return z.c * (z.x * e1 + z.y * e2) + z.s * a; }
  };

  // A unit vector at a right angle.
  static Vec across(const Vec& axis) {
    const Vec m = axis.cwiseAbs();
    const Vec other = m[0] <= m[1] && m[0] <= m[2] ? Vec(Vec::UnitX())
                      : m[1] <= m[2]               ? Vec(Vec::UnitY())
                                                   : Vec(Vec::UnitZ());
    return unit(Vec(cross(axis, other)));
  }
  [[nodiscard]] Chart chart(const Vec& axis) const {
    Chart out;
    out.a = axis;
    out.e1 = across(axis);
    out.e2 = cross(axis, out.e1);
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      Form& f = out.form[std::size_t(i)];
      const Vec x = o.m * out.e1, y = o.m * out.e2, z = o.m * out.a;
      f.p33 = squared_norm(z);
      f.m = (squared_norm(x) + squared_norm(y)) / 2;
      f.d = dot(x + y, x - y) / 2;
      f.p12 = dot(x, y);
      f.p13 = dot(x, z);
      f.p23 = dot(y, z);
      f.most = o.most;
      f.axial = o.flat && squared_norm(cross(o.pole, axis)) <= 16 * kU * kU && o.least == o.most;
    }
    for (int i = 0; i < seam_count_; ++i) out.seam[std::size_t(i)] = out.own(seams_[std::size_t(i)].a);
    out.center = out.own(center_);
    return out;
  }
  // How far from symmetric about an axis.
  [[nodiscard]] double skew(const Vec& axis) const {
    const Chart c = chart(axis);
    double out = hypotenuse(c.center[0], c.center[1]);
    for (int i = 0; i < norm_count_; ++i) {
      const Form& f = c.form[std::size_t(i)];
      out += (std::abs(f.d) + std::abs(f.p12) + std::abs(f.p13) + std::abs(f.p23)) / f.most;
    }
    return out;
  }

  template <class T>
  static void add_linear(const Vec& b, const Place<T>& z, Slopes<T>& out) {
    const T l = fl(b[0] * z.x) + fl(b[1] * z.y), l_p = fl(b[1] * z.x) - fl(b[0] * z.y);
    const T g = fl(z.c * l) + fl(b[2] * z.s);
    out.t = out.t + (fl(b[2] * z.c) - fl(z.s * l));
    out.p = out.p + fl(z.c * l_p);
    out.tt = out.tt - g;
    out.tp = out.tp - fl(z.s * l_p);
    out.pp = out.pp - fl(z.c * l);
  }
  template <class T>
  static T height(const Vec& b, const Place<T>& z) {
    return fl(z.c * (fl(b[0] * z.x) + fl(b[1] * z.y))) + fl(b[2] * z.s);
  }

  // inverse: of the norm's value, which is above 0.
  template <class T>
  static Slopes<T> slopes_of(const Form& f, const Place<T>& z, const T& inverse) {
    Slopes<T> out;
    if (f.axial) {
      out.t = -(f.most * z.s);
      out.tt = -(f.most * z.c);
      return out;
    }
    const T sin2p = 2 * (z.x * z.y), cos2p = T(1) - 2 * square(z.y);
    const T B = fl(f.d * cos2p) + fl(f.p12 * sin2p), B_p = 2 * (fl(f.p12 * cos2p) - fl(f.d * sin2p));
    const T L = fl(f.p13 * z.x) + fl(f.p23 * z.y), L_p = fl(f.p23 * z.x) - fl(f.p13 * z.y);
    const T sin2 = 2 * (z.s * z.c), cos2 = T(1) - 2 * square(z.s), cc = square(z.c);
    const T rest = T(f.p33 - f.m) - B;
    const T half = 0.5 * inverse;
    out.t = half * (fl(sin2 * rest) + 2 * (cos2 * L));
    out.p = half * (fl(cc * B_p) + fl(sin2 * L_p));
    out.tt = inverse * ((fl(cos2 * rest) - 2 * (sin2 * L)) - square(out.t));
    out.tp = inverse * ((fl(cos2 * L_p) - 0.5 * (sin2 * B_p)) - fl(out.t * out.p));
    out.pp = inverse * (-(2 * (cc * B)) - 0.5 * (sin2 * L) - square(out.p));
    return out;
  }

  // The pieces of h: bit i means above seam i (n.a > level).
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
  double piece_value(const Chart& c, Piece piece, const Vec& b, const Place<double>& z,
                     Slopes<double>& slopes) const {
    double h = height(b, z);
    slopes = {};
    add_linear(b, z, slopes);
    const Vec n = c.at(z);
    for (int i = 0; i < norm_count_; ++i) {
      if (!has_norm(i, piece)) continue;
      const double f = norm(norms_[std::size_t(i)].m * n);
      h += f;
      if (f > 0) slopes += slopes_of<double>(c.form[std::size_t(i)], z, 1 / f);
    }
    return h;
  }

  static Place<double> turned(const Place<double>& z, double t, double p) {
    const auto [st, ct] = rounded_sine_cosine(t);
    const auto [sp, cp] = rounded_sine_cosine(p);
    return {fl(z.c * ct) - fl(z.s * st), fl(z.s * ct) + fl(z.c * st), fl(z.x * cp) - fl(z.y * sp),
            fl(z.y * cp) + fl(z.x * sp)};
  }

  // h, with the slopes of the piece that it is there.
  double value_at(const Chart& c, const Place<double>& z, Slopes<double>& slopes) const {
    const Vec n = c.at(z);
    Piece piece = 0;
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      if (i == c.owner || dot(s.a, n) > s.level) piece |= 1u << i;
    }
    return piece_value(c, piece, linear_part(c, piece), z, slopes);
  }
  // A limit of the quotient of a Hessian's determinant over the product of its diagonal. Below it a step along each
  // direction alone is safer.
  static constexpr double kSingular = 1e-9;
  // Towards where the slopes vanish, along what bends up. False: nothing does.
  static bool newton_step(const Slopes<double>& g, bool line, double slack, double& dt, double& dp) {
    const double det = fl(g.tt * g.pp) - fl(g.tp * g.tp);
    const bool t_up = g.tt > slack && !line, p_up = g.pp > slack;
    if (t_up && p_up && det > kSingular * g.tt * g.pp) {
      dt = (fl(g.tp * g.p) - fl(g.pp * g.t)) / det;
      dp = (fl(g.tp * g.t) - fl(g.tt * g.p)) / det;
    } else if (t_up) {
      dt = -g.t / g.tt;
    } else if (p_up) {
      dp = -g.p / g.pp;
    } else {
      return false;
    }
    return true;
  }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
