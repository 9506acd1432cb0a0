// Computes min over unit n of h(n), for the core C of two primitives, at least one of them curved. It serves
// penetration() for points, segments, spheres, capsules, boxes, ellipsoids, cylinders and cones whose cores overlap.
// Units: internal (cso.hpp).   Frame: world axes.
//
// h (round_sum.hpp) is smooth except on the seams, where two pieces of it meet. These are the great circles n.a_i =
// 0, and the circle of latitude where a cone's apex and base are equally far. So the least h is one of
//   a corner   where two seams cross, or at the pole of a disc,
//   a circle   least along a seam,
//   a sphere   least of a smooth piece, which takes curvature in both directions.
// The corners are evaluated. Circles and sphere are cut into cells of latitude and azimuth. A cell is done in three
// cases:
//   - A support point w of its middle shows h >= upper - gap, as h(n) >= w.n.
//   - No piece has a minimum in it: an interval of a first derivative is without 0, or one of a second is below 0.
//   - Second derivatives bound the piece from below by upper - gap, about a point that Newton finds.
// The cells are not needed if the balls that touch the two bodies at the contact from inside are together as large as
// the contact is deep (inner_ball.hpp). Each new least h is tested for this, and the test settles most contacts after
// a few steps of Newton's method. Directions that are equally near along a whole circle are no trouble. The azimuth
// of the cells is about the axis about which the pair is nearest to symmetric. Derivatives by the azimuth vanish with
// the terms that break the symmetry (round_slopes.hpp).
//
// Guarantee: lower <= min h <= upper = h(n), up to `Cso::rounding` and the slacks below. upper - lower <= gap, or
// `close` by the balls, unless the budget ends.   Intervals are not rounded outwards: each is compared with a slack
// above its rounding.
#pragma once

#include <graze/detail/search/smooth/round_slopes.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Support evaluations: what takes more is seldom, and left to the other search.
inline constexpr int kMostRoundDepthSupports = 2048;

class RoundDepth : public RoundSlopes {
 public:
  // `close`: upper - lower of an answer that is proved without a search, at least 32 u scale.
  void run(double gap, double close, int budget, Counters& counters) {
    gap_ = gap;
    close_ = close;
    budget_ = budget;
    counters_ = &counters;
    best_ = {};
    lower_ = kInfinity<double>;
    corners();
    descend();
    if (is_enclosed()) return;
    for (int i = 0; i < seam_count_ && !enclosed_; ++i) search_circle(i);
    if (!enclosed_ && may_have_smooth_minimum()) search_sphere();
    if (enclosed_) return;
    lower_ = std::min(lower_, best_.h);
    polish();
  }
  // The same where the origin is outside of C, n the direction to it, nearly: h is minus the distance, and has no other minimum.
  // False: the points found are farther from the origin than `close` more than that.
  bool approach(const Vec& n, double close, Counters& counters) {
    counters_ = &counters;
    best_ = {};
    offer(n);
    const auto is_close = [&] {
      polish_along_seams();
      lower_ = -norm(difference());
      return best_.h - lower_ <= close;
    };
    if (is_close()) return true;
    corners();
    return is_close();
  }
  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return best_.h; }
  [[nodiscard]] const Vec& normal() const { return best_.n; }
  [[nodiscard]] std::array<Vec, 2> points() const { return RoundSum::points(best_); }
  // The difference of points().
  [[nodiscard]] Vec difference() const { return RoundSum::difference(points()); }

 private:
  struct Cell {
    double c0, s0, c1, s1, x0, y0, x1, y1;  // unit vectors of the ends
    double a, b;                            // half widths
    double bound = 0, h = 0, rho = 0;
    Place<double> mid{};
  };
  struct Cap {
    Vec n;
    double half_tangent, h;  // of half the angle
  };

  // A first guess of the least h: from where the contact is the shortest way out of one of the bodies, to a minimum near by, which
  // may lie along a seam.
  void descend() {
    if (center_ != Vec::Zero()) offer(unit(Vec(-center_)));
    for (int i = 0; i < norm_count_; ++i) {
      const Norm& o = norms_[std::size_t(i)];
      if (o.flat) continue;
      Eigen::Index least = 0;
      for (Eigen::Index row = 1; row < 3; ++row) {
        if (squared_norm(o.m.row(row)) < squared_norm(o.m.row(least))) least = row;
      }
      const Vec n = unit(Vec(o.m.row(least).transpose()));
      offer(n);
      offer(Vec(-n));
    }
    polish_along_seams();
  }
  void polish_along_seams() {
    polish();
    for (int i = 0; i < seam_count_; ++i) {
      const Seam& s = seams_[std::size_t(i)];
      const Vec around = best_.n - dot(s.a, best_.n) * s.a;
      if (squared_norm(around) > 0x1p-40) offer(unit(Vec(s.level * s.a + s.across * unit(around))), i);
    }
    polish();
  }
  // Do balls in the bodies prove that no direction is less deep than the best so far? Asked once of each.
  bool is_enclosed() {
    if (enclosed_ || !(best_.h < asked_)) return enclosed_;
    polish();
    asked_ = best_.h;
    const double proved = depth_by_balls(best_);
    if (!(proved >= best_.h - close_)) return false;
    lower_ = std::min(proved, best_.h);
    return enclosed_ = true;
  }

  // A value of h, and what of the support point is free there: seams, or the disc of a norm.
  double offer(const Vec& n, int first = -1, int second = -1, int disc = -1) {
    ++counters_->supports;
    --budget_;
    const double h = value(n);
    take({.n = n, .h = h, .seams = {first, second}, .disc = disc});
    return h;
  }
  // If two are equal up to rounding, this is the one with more freedom: beside a seam the support point is at an end
  // of its free segment.
  void take(const Contact& found) {
    const double slack = 8 * kU * scale_;
    const int more = found.freedom() - best_.freedom();
    if (found.h < best_.h - (more < 0 ? slack : 0) || (more > 0 && found.h <= best_.h + slack)) best_ = found;
  }

  void corners() {
    for (int i = 0; i < norm_count_; ++i) {
      Norm& o = norms_[std::size_t(i)];
      if (!o.flat) continue;
      for (const double sign : {1.0, -1.0}) {
        const Vec n = sign * o.pole;
        const bool present = o.seam < 0 || dot(n, seams_[std::size_t(o.seam)].a) < 0;
        Vec w;
        const double h = offer(n, -1, -1, present ? i : -1);
        value(n, &w, i);
        // At the pole the free part counts against the rest: any point of a seam's segment bounds h from below.
        for (int k = 0; k < seam_count_; ++k) {
          const Seam& s = seams_[std::size_t(k)];
          const double u = dot(s.a, n);
          if (s.cone || !(std::abs(u) <= 4 * kU)) continue;
          const double along = dot(w - dot(w, n) * n, s.a);
          w -= (u >= 0 ? std::clamp(along, 0.0, 2 * s.half) : std::clamp(along, -2 * s.half, 0.0)) * s.a;
        }
        // Within this angle of the pole no h is below that of the pole: h(n') >= w.n' + least |n' x pole|.
        const double spare = o.least - norm(w - dot(w, n) * n);
        caps_[std::size_t(cap_count_++)] = {n, present && spare > 0 && h > 0 ? spare / h : 0.0, h};
      }
    }
    for (int i = 0; i < seam_count_; ++i) {
      for (int j = i + 1; j < seam_count_; ++j) {
        const Seam &s = seams_[std::size_t(i)], &o = seams_[std::size_t(j)];
        const Vec e = cross(s.a, o.a);
        const double sin_sq = squared_norm(e), cosine = dot(s.a, o.a);
        if (!(sin_sq > 0)) continue;
        const double alpha = (s.level - fl(o.level * cosine)) / sin_sq,
                     beta = (o.level - fl(s.level * cosine)) / sin_sq;
        const Vec in = alpha * s.a + beta * o.a;
        const double rest = (1 - squared_norm(in)) / sin_sq;
        if (!(rest >= 0)) continue;
        const double g = square_root(rest);
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

  // The least that b x + h/2 x^2 can be for |x - at| <= half, given as lo <= x <= hi.
  static double least_of(double b, double h, double lo, double hi) {
    const auto q = [&](double x) { return x * (b + fl(0.5 * h * x)); };
    double out = std::min(q(lo), q(hi));
    if (h > 0) {
      const double x = std::clamp(-b / h, lo, hi);
      out = std::min(out, q(x));
    }
    return out;
  }

  // The middle of a cell, and what a support there says of all of it. False: it is done with.
  bool look(const Chart& c, Cell& box) {
    Place<double>& mid = box.mid;
    mid = {box.c0 + box.c1, box.s0 + box.s1, box.x0 + box.x1, box.y0 + box.y1};
    const double k = 1 / square_root(fl(mid.c * mid.c) + fl(mid.s * mid.s)),
                 l = 1 / square_root(fl(mid.x * mid.x) + fl(mid.y * mid.y));
    mid.c *= k;
    mid.s *= k;
    mid.x *= l;
    mid.y *= l;
    const Vec n = c.at(mid);
    Vec w;
    ++counters_->supports;
    --budget_;
    const double h = box.h = value(n, &w);
    take({.n = n, .h = h, .seams = {c.owner, -1}});
    // No farther from the middle than rho.
    box.rho = box.a + fl(std::max(std::max(box.c0, box.c1), mid.c) * box.b);
    const double across = square_root(std::max(0.0, squared_norm(w) - fl(h * h)));
    // The range of w.n, over angles below a right one.
    if (box.rho < 1.5) {
      const SineCosine<double> at = rounded_sine_cosine(box.rho);
      const double bound = (h >= 0 ? h * at.cosine : h) - fl(across * at.sine);
      box.bound = std::max(box.bound, bound);
    }
    if (!(box.bound >= best_.h - gap_)) return true;
    lower_ = std::min(lower_, box.bound);
    return false;
  }

  // Is this box done with? Else which way to cut it: 0 by latitude, 1 by azimuth.
  bool settled(const Chart& c, Cell& box, int& way) {
    const bool line = c.owner >= 0;
    const Place<double>& mid = box.mid;
    const double rho = box.rho;
    const SineCosine<double> turn = rounded_sine_cosine(rho);
    const Vec n = c.at(mid);
    for (int i = 0; i < cap_count_; ++i) {
      const Cap& cap = caps_[std::size_t(i)];
      if (!(cap.half_tangent > 0 && rho < 3)) continue;
      const double chord = norm(n - cap.n);  // <= angle
      if (!(chord < 1.9)) continue;
      // The angle of the chord and rho add up to less than the cap's: by the tangents of their halves.
      const double half = chord / square_root(4 - fl(chord * chord)), more = turn.sine / (1 + turn.cosine);
      if (half + more < cap.half_tangent * (1 - fl(half * more))) return true;
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
      const double at = detail::norm(norms_[std::size_t(i)].m * n), far = f.most * rho;
      Interval value{at - far, at + far};
      Slopes<Interval>& s = norm[std::size_t(i)];
      if (f.axial) {
        s = slopes_of<Interval>(f, z, 1);
        continue;
      }
      // by the form
      const Interval sin2p = 2 * (z.x * z.y), cos2p = Interval(1) - 2 * square(z.y);
      const Interval q = fl(f.p33 * square(z.s)) +
                         fl(square(z.c) * (Interval(f.m) + (fl(f.d * cos2p) + fl(f.p12 * sin2p)))) +
                         2 * ((z.s * z.c) * (fl(f.p13 * z.x) + fl(f.p23 * z.y)));
      const double predicate_error = 16 * kU * f.most * f.most;
      value.lo = std::max(value.lo, square_root(std::max(q.lo - predicate_error, 0.0)));
      value.hi = std::min(value.hi, square_root(q.hi + predicate_error));
      const double top = f.most, c_top = std::max(std::abs(z.c.lo), std::abs(z.c.hi));
      if (value.lo > 64 * kU * top) {
        const Interval inverse{1 / value.hi, 1 / value.lo};
        s = slopes_of<Interval>(f, z, inverse);
        const double more = predicate_error / value.lo;
        const double twice = (predicate_error + fl(3 * top * more)) / value.lo;
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
    // Finds the seams that run through the box.
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
      const double at = dot(s.a, n);
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
        const double off_t = tt + fl(tp * box.b), off_p = fl(tp * box.a) + pp;
        if (line ? std::abs(g.p) - pp > slack
                 : std::abs(g.t) - off_t > slack || std::abs(g.p) - off_p > slack ||
                       fl(g.t * g.t) + fl(g.p * g.p) - fl(std::abs(g.t) * off_t) - fl(std::abs(g.p) * off_p) >
                           slack * (std::abs(g.t) + std::abs(g.p)))
          continue;
      }
      // A lower bound of the piece from its second derivatives about a point that is nearly its least.
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
        const double mixed = largest(s.tp);
        double h_t = s.tt.lo, h_p = s.pp.lo;
        // h_t/2 dt^2 - mixed |dt dp| >= -mixed^2 / (2 h_t) dp^2
        double lost = 0;
        if (mixed > 0) {
          if (h_t > 0 && h_t * h_p >= mixed * mixed) {
            const double part = h_p > 0 ? mixed * square_root(h_t / h_p) : 0;
            h_p -= h_p > 0 ? mixed * square_root(h_p / h_t) : 0;
            h_t -= part;
          } else {
            lost = mixed * std::max(-lo_t, hi_t) * std::max(-lo_p, hi_p);
            // or at the cost of h_p
            if (h_t > 0) {
              const double h2 = h_p - 2 * mixed * mixed / h_t;
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
      if (bound >= best_.h - gap_) {
        lower_ = std::min(lower_, bound);
        continue;
      }
      all = false;
      worst = bound < worst ? bound : worst;
      score_t = std::max(score_t, line ? 0 : std::min((s.t.hi - s.t.lo) * box.a, 2 * scale_ * box.a));
      score_p = std::max(score_p, std::min((s.p.hi - s.p.lo) * box.b, 2 * scale_ * box.b));
    }
    way = line || score_p > score_t ? 1 : 0;
    if (!all && worst > box.bound) box.bound = std::max(box.bound, std::min(worst, best_.h));
    return all;
  }
  static Interval between(double x, double y) { return {std::min(x, y), std::max(x, y)}; }

  void search(const Chart& c, std::array<Cell, 8>& first, int count) {
    std::array<Cell, 128> stack;
    std::size_t size = 0;
    for (int i = 0; i < count; ++i) {
      if (look(c, first[std::size_t(i)])) stack[size++] = first[std::size_t(i)];
    }
    std::stable_sort(stack.begin(), stack.begin() + long(size),
                     [](const Cell& l, const Cell& r) { return l.h > r.h; });
    while (size > 0 && !is_enclosed()) {
      Cell box = stack[--size];
      if (box.bound >= best_.h - gap_) {
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
        if (o.flat && !(norm(a) > 0)) a = o.pole;
        if (!(norm(a) > 0)) continue;
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

  // Newton's method from the best so far: while h falls, and as h tells n to the root of the rounding only, while the slope does.
  void polish() {
    if (best_.seams[1] >= 0 || best_.disc >= 0 || best_.h == polished_) return;
    const bool line = best_.seams[0] >= 0;
    Chart c = chart(line ? seams_[std::size_t(best_.seams[0])].a : across(best_.n));
    if (line) c.owner = best_.seams[0];
    const Vec own = c.own(best_.n);
    Place<double> z{hypotenuse(own[0], own[1]), own[2], 1, 0};
    if (!(z.c > 0)) return;
    z.x = own[0] / z.c;
    z.y = own[1] / z.c;
    const double slack = 8 * kU * scale_;
    const auto size = [&](const Slopes<double>& s) { return (line ? 0 : std::abs(s.t)) + std::abs(s.p); };
    Slopes<double> g;
    value_at(c, z, g);
    const auto step = [&] {
      double dt = 0, dp = 0;
      if (!newton_step(g, line, slack, dt, dp)) return false;
      for (int half = 0; half < kPolishHalves; ++half, dt /= 2, dp /= 2) {
        const Place<double> next = turned(z, dt, dp);
        Slopes<double> then;
        const double h = value_at(c, next, then);
        ++counters_->supports;
        --budget_;
        if (h > best_.h + slack) continue;
        if (!(h < best_.h - slack) && !(size(then) < size(g))) return false;
        const Vec n = c.at(next);
        best_.n = n / norm(n);
        best_.h = h;
        z = next;
        g = then;
        return true;
      }
      return false;
    };
    for (int round = 0; round < kPolishRounds && step(); ++round) {
    }
    best_.h = polished_ = value(best_.n);
  }
  static constexpr int kPolishRounds = 12, kPolishHalves = 3;

  double gap_ = 0, close_ = 0, lower_ = 0, asked_ = kInfinity<double>, polished_ = kInfinity<double>;
  bool enclosed_ = false;
  Contact best_;
  int budget_ = 0, cap_count_ = 0;
  std::array<Cap, 4> caps_;
  Counters* counters_ = nullptr;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
