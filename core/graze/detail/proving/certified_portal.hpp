// Finds a portal that holds the line {s r} beyond predicate_error: three exactly named points of C (named_point.hpp).
// Every decision about them is correct.
//
// Oblique coordinates of a point w, c the largest component of r, (a, b, c) cyclic:
//   x = w_a - (r_a / r_c) w_c,   y = w_b - (r_b / r_c) w_c,   z = w_c / r_c.
// The line is then x = y = 0 and z is its parameter s. Let l_i = x_j y_k - y_j x_k, cyclic. If no l_i has the
// wrong sign, the line pierces the triangle at s = sum l_i z_i / sum l_i. This proves s_in <= s.
//
// Discovery is GJK in the plane, refinement MPR (portal.hpp). The difference is that every decision is correct. On
// aligned shapes the line often passes through an edge or a corner within the resolution of sums of two doubles. The
// sign is then decided exactly. If the name of a point is too long for that, the point is tilted instead: another
// direction within 1e-7, or a small move inwards, gives another point of C nearby.
//
// Error of x, y, z: w within `error` per coordinate, |r_a / r_c| <= 1, |r_c| >= 1/2, quotients 2^-97: within e = 4
// error.
//
// Error of l_i, with m_j and m_k the largest coordinates in it: 2 e (m_j + m_k) + 2 e^2 + 2^-95 m_j m_k =: d_i.
//
// Error of s: sum l_i x_i = sum l_i y_i = 0, so any k x + m y may be subtracted from the z_i. Heights are taken about
// a corner, with k and m the slope of the longest edge. The first part is the sum of |z_i - z - k (x_i - x) - m (y_i
// - y)| times the error of l_i / L, L = sum l_i > 16 D, D = sum d_i. The error of l_i / L is at most (d_i + D l_i /
// L) / (L - D). The second part is the errors of the corner's own height and of the others' remainders, 3 e (1 + |k|
// + |m|) in all.
#pragma once

#include <algorithm>

#include <graze/detail/numeric/sine_cosine.hpp>
#include <graze/detail/proving/named_point.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct ProvedPoint {
  NamedPoint point;
  TwoDoubles x, y, z;
  Vec3<double> n = Vec3<double>::Zero();  // world, unit: farthest along it, about
};

struct ProvedPortal {
  bool found = false;  // the line pierces the triangle
  std::array<ProvedPoint, 3> p;
  std::array<double, 3> lambda{};
  double least = -kInfinity<double>, upper = kInfinity<double>;  // bounds of its s
  Vec3<double> n = Vec3<double>::Zero();       // world, unit: the triangle's normal, n.r < 0
  double beyond = kInfinity<double>;           // C's extent beyond the triangle along n, about
  Vec3<double> across = Vec3<double>::Zero();  // not found: a direction across the line that may separate
};

template <Scalar S>
class ProvedView {
 public:
  // r = to - from, times a power of two.
  ProvedView(const NamedPoints<S>& points, const TwoDoubles3& r, const Vec3<double>& from,
             const Vec3<double>& to)
      : points_(points), r_(r), from_(from), to_(to) {
    for (std::size_t i = 1; i < 3; ++i) {
      if (std::abs(r[i].hi) > std::abs(r[c_].hi)) c_ = i;
    }
    a_ = (c_ + 1) % 3;
    b_ = (c_ + 2) % 3;
    rho_a_ = r[a_] / r[c_];
    rho_b_ = r[b_] / r[c_];
    error_ = 4 * points.error();
  }

  // The s of the portal, refined to within `gap` of C's surface (internal length). `first`: the start of the search.
  // `enough`: a portal at an s that is no later suffices without refinement.
  [[nodiscard]] ProvedPortal enter(const Portal<double>& first, double gap,
                                   double enough = -kInfinity<double>) const {
    ProvedPortal out;
    if (first.size == 3) {
      std::array<ProvedPoint, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        const CsoPoint<double>& c = first.p[i].c;
        const Vec3<double> e = c.n != Vec3<double>::Zero() ? c.n : c.e;
        const Vec3<double> n =
            e == Vec3<double>::Zero() ? Vec3<double>(Vec3<double>::UnitX()) : Vec3<double>(unit(e));
        p[i] = placed(points_.named(c, n), n);
      }
      static_cast<void>(take(out, p));
    }
    if (!out.found) discover(out);
    if (out.found) refine(out, gap, enough);
    return out;
  }

  // Do points of C surround the line, seen along it? The candidates are the corners of two portals, at the line's
  // entry into C and at its exit, and others, searched beyond the two that leave the widest gap. The part of the line
  // between the portals is then inside of C, if any part is.
  [[nodiscard]] bool is_surrounded(const ProvedPortal& in, const ProvedPortal& out) const {
    Corners corner;
    std::size_t size = 0;
    for (const ProvedPortal* portal : {&in, &out}) {
      for (const ProvedPoint& p : portal->p) corner[size++] = p;
    }
    for (int step = 0; step < kGapSteps; ++step) {
      if (surrounds_line(corner, size)) return true;
      for (const int turn : {1, -1}) {
        const ProvedPoint* last = nullptr;
        for (std::size_t i = 0; i < size; ++i) {
          const bool far = last == nullptr || norm(across(corner[i])) > norm(across(*last));
          if (far && !has_next(corner[i], corner, size, turn)) last = &corner[i];
        }
        if (last == nullptr) continue;
        const Vec3<double> q = across(*last);
        corner[size++] = along(world(-turn * q[1], turn * q[0], 0));
      }
    }
    return surrounds_line(corner, size);
  }

 private:
  static constexpr int kSteps = 96;  // of discovery, and of refinement: 20 are typical
  static constexpr int kAsideSteps = 8;
  static constexpr int kGapSteps = 4;
  using Corners = std::array<ProvedPoint, 6 + 2 * kGapSteps>;
  // Radians, the middle one first. A tilt moves a curved point inwards by its square, a flat end by the tilt itself.
  static constexpr std::array<double, 3> kTiltSizes = {1e-9, 1e-12, 1e-7};
  static constexpr int kTilts = 8;  // directions of a tilt

  static double value(const TwoDoubles& x) { return x.hi + x.lo; }

  [[nodiscard]] ProvedPoint along(const Vec3<double>& n) const { return placed(points_.along(n), n); }
  [[nodiscard]] ProvedPoint placed(NamedPoint point, const Vec3<double>& n) const {
    ProvedPoint out;
    out.n = n;
    out.x = point.w[a_] + -(rho_a_ * point.w[c_]);
    out.y = point.w[b_] + -(rho_b_ * point.w[c_]);
    out.z = point.w[c_] / r_[c_];
    out.point = std::move(point);
    return out;
  }
  // The gradient of f_x x + f_y y + f_z z in the world.
  [[nodiscard]] Vec3<double> world(double f_x, double f_y, double f_z) const {
    Vec3<double> out;
    out[static_cast<int>(a_)] = f_x;
    out[static_cast<int>(b_)] = f_y;
    out[static_cast<int>(c_)] = f_z / value(r_[c_]) - fl(f_x * value(rho_a_)) - fl(f_y * value(rho_b_));
    return out;
  }

  // x_j y_k - y_j x_k. Twice the error that the formula gives: sizes and the bound itself are rounded.
  struct Area {
    TwoDoubles l;
    double error;
    [[nodiscard]] int sign() const { return value(l) > error ? 1 : value(l) < -error ? -1 : 0; }
  };
  [[nodiscard]] Area area(const ProvedPoint& j, const ProvedPoint& k) const {
    const double size_j = std::max(std::abs(j.x.hi), std::abs(j.y.hi));
    const double size_k = std::max(std::abs(k.x.hi), std::abs(k.y.hi));
    return {j.x * k.y + -(j.y * k.x), 2 * (fl(2 * error_ * (size_j + size_k)) + fl(2 * error_ * error_) +
                                           fl(0x1p-95 * size_j * size_k))};
  }

  static Vec3<double> across(const ProvedPoint& p) { return {value(p.x), value(p.y), 0}; }
  // Is one of the corners less than half a turn ahead, beyond predicate_error, seen along the line?
  [[nodiscard]] bool has_next(const ProvedPoint& p, const Corners& corner, std::size_t size, int turn) const {
    return std::any_of(corner.begin(), corner.begin() + static_cast<std::ptrdiff_t>(size),
                       [&](const ProvedPoint& next) { return turn * area(p, next).sign() > 0; });
  }
  // Is there no half-plane that holds the corners? Corners without a next one are removed. The corners of a
  // half-plane are removed one by one, the last first.
  [[nodiscard]] bool surrounds_line(Corners corner, std::size_t size) const {
    for (std::size_t i = 0; i < size;) {
      const bool stays = has_next(corner[i], corner, size, 1);
      if (!stays) corner[i] = corner[--size];
      i = stays ? i + 1 : 0;
    }
    return size > 0;
  }

  struct Weights {
    bool holds = false;  // the line, in the triangle or on its border
    std::array<TwoDoubles, 3> l;
    std::array<double, 3> error;  // of each
    TwoDoubles sum;
    double errors = 0;  // of the sum
  };
  // The sign of l = det(r, j, k) about the cyclic order of a, b, c, or 2 if it cannot be computed.
  [[nodiscard]] int exact_sign(const ProvedPoint& j, const ProvedPoint& k) const {
    if (!j.point.named || !k.point.named) return 2;
    const exact::Dyadic3 r = exact::Exact::of(to_, from_).x;
    const exact::Dyadic value =
        exact::dot(r, exact::cross(points_.exactly(j.point), points_.exactly(k.point)));
    if (!value.valid()) return 2;
    // det(r, j, k) = r_c (x_j y_k - y_j x_k)
    return r[c_].sign() * value.sign();
  }
  [[nodiscard]] Weights weights(const std::array<ProvedPoint, 3>& p) const {
    Weights out;
    std::array<int, 3> sign;
    int side = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Area opposite = area(p[(i + 1) % 3], p[(i + 2) % 3]);
      out.l[i] = opposite.l;
      out.error[i] = opposite.error;
      out.errors += opposite.error;
      sign[i] = opposite.sign();
      if (sign[i] * side < 0) return out;
      if (sign[i] != 0) side = sign[i];
      out.sum = out.sum + out.l[i];
    }
    if (!(std::abs(value(out.sum)) > 16 * out.errors)) return out;
    for (std::size_t i = 0; i < 3; ++i) {
      if (sign[i] != 0) continue;
      const int s = exact_sign(p[(i + 1) % 3], p[(i + 2) % 3]);
      if (s == 2 || s * side < 0) return out;
    }
    out.holds = true;
    return out;
  }
  // The portal becomes p if p holds the line, and lies no higher.
  [[nodiscard]] bool take(ProvedPortal& portal, const std::array<ProvedPoint, 3>& p) const {
    const Weights w = weights(p);
    if (!w.holds) return false;
    // Heights relative to the corner nearest to the line, less the slope along the longest edge. For a sliver the
    // remainder is almost 0, so that its weights, which are rounding, do not matter.
    const auto off = [&](std::size_t i) { return std::max(std::abs(p[i].x.hi), std::abs(p[i].y.hi)); };
    std::size_t nearest = 0, longest = 0;
    std::array<Vec3<double>, 3> edge;
    for (std::size_t i = 0; i < 3; ++i) {
      const ProvedPoint &from = p[i], &to = p[(i + 1) % 3];
      edge[i] = {value(to.x + -from.x), value(to.y + -from.y), value(to.z + -from.z)};
      if (off(i) < off(nearest)) nearest = i;
      if (squared_norm(edge[i].head<2>()) > squared_norm(edge[longest].head<2>())) longest = i;
    }
    const Vec3<double>& along = edge[longest];
    const double length_sq = squared_norm(along.head<2>()), steep = length_sq > 0 ? along[2] / length_sq : 0;
    const TwoDoubles slope_x{steep * along[0], 0}, slope_y{steep * along[1], 0};
    const ProvedPoint& by = p[nearest];
    const double total = std::abs(value(w.sum));
    TwoDoubles above;
    double predicate_error = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == nearest) continue;
      const TwoDoubles left = (p[i].z + -by.z) + -(slope_x * (p[i].x + -by.x) + slope_y * (p[i].y + -by.y));
      above = above + w.l[i] * left;
      const double share = std::abs(value(w.l[i])) / total;
      predicate_error += fl(2 * (w.error[i] + fl(w.errors * share)) / total * std::abs(value(left)));
    }
    const double at = value((by.z + -(slope_x * by.x + slope_y * by.y)) + above / w.sum);
    predicate_error += fl(4 * error_ * (1 + std::abs(slope_x.hi) + std::abs(slope_y.hi))) +
                       0x1p-92 * std::abs(along[2]) + 2 * kUnitRoundoff<double> * std::abs(at);
    const double upper = at + 2 * predicate_error;
    // If the line passes an edge that stays, the height stays the same, too. The steps are counted.
    if (portal.found && !(upper <= portal.upper + 4 * predicate_error)) return false;
    portal.found = true;
    portal.upper = upper;
    portal.least = at - 2 * predicate_error;
    portal.p = p;
    for (std::size_t i = 0; i < 3; ++i) portal.lambda[i] = value(w.l[i] / w.sum);
    return true;
  }

  [[nodiscard]] Vec3<double> normal_of(const std::array<ProvedPoint, 3>& p) const {
    std::array<Vec3<double>, 3> edge;
    for (std::size_t i = 0; i < 3; ++i) {
      const ProvedPoint &from = p[i], &to = p[(i + 1) % 3];
      edge[i] = {value(to.x + -from.x), value(to.y + -from.y), value(to.z + -from.z)};
    }
    // The two shorter edges know it best.
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (squared_norm(edge[i]) > squared_norm(edge[longest])) longest = i;
    }
    const Vec3<double> f = cross(edge[(longest + 1) % 3], edge[(longest + 2) % 3]);
    return unit(world(f[2] > 0 ? -f[0] : f[0], f[2] > 0 ? -f[1] : f[1], f[2] > 0 ? -f[2] : f[2]));
  }
  // A direction between the normals of the two corners that the line passes between. Used for corners on one line,
  // whose plane is rounding. Zero if all are on one side.
  [[nodiscard]] Vec3<double> normal_between(const std::array<ProvedPoint, 3>& p) const {
    Vec3<double> edge = Vec3<double>::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3<double> e = across(p[(i + 1) % 3]) - across(p[i]);
      if (squared_norm(e) > squared_norm(edge)) edge = e;
    }
    const ProvedPoint *before = nullptr, *after = nullptr;
    for (const ProvedPoint& c : p) {
      const double at = dot(edge, across(c));
      if (at <= 0 && (before == nullptr || at > dot(edge, across(*before)))) before = &c;
      if (at > 0 && (after == nullptr || at < dot(edge, across(*after)))) after = &c;
    }
    if (before == nullptr || after == nullptr) return Vec3<double>::Zero();
    return unit(Vec3<double>(unit(before->n) + unit(after->n)));
  }
  // Calls try_one with a point along n, then with others near it, until it returns true.
  template <class Try>
  bool with_tilts(const Vec3<double>& n, const Try& try_one) const {
    if (try_one(along(n), false)) return true;
    const Frame<double> frame(n);
    for (const double tilt : kTiltSizes) {
      for (int k = 0; k < kTilts; ++k) {
        // Not aligned with any symmetry.
        const double angle = 0.3 + fl(k * 0.785398);
        const SineCosine<double> at = rounded_sine_cosine(angle);
        const Vec3<double> t = at.cosine * frame.e1 + at.sine * frame.e2;
        if (try_one(along(n + tilt * t), true)) return true;
      }
    }
    for (const double drawn : {0x1p-48, 0x1p-45, 0x1p-42}) {
      if (try_one(placed(points_.along(n, drawn), n), true)) return true;
    }
    return false;
  }

  [[nodiscard]] bool take_any(ProvedPortal& portal, const std::array<ProvedPoint, 5>& p) const {
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (std::size_t j = i + 1; j < p.size(); ++j) {
        for (std::size_t k = j + 1; k < p.size(); ++k) {
          if (take(portal, {p[i], p[j], p[k]})) return true;
        }
      }
    }
    return false;
  }
  void discover(ProvedPortal& portal) const {
    std::array<ProvedPoint, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const SineCosine<double> at = rounded_sine_cosine(0.3 + fl(2.1 * static_cast<double>(i)));
      p[i] = along(world(at.cosine, at.sine, 0));
    }
    for (int step = 0; step < kSteps; ++step) {
      if (take(portal, p)) return;
      // Counter-clockwise order. Then the edge with the line farthest outside.
      const TwoDoubles x_1 = p[1].x + -p[0].x, y_1 = p[1].y + -p[0].y, x_2 = p[2].x + -p[0].x,
                       y_2 = p[2].y + -p[0].y;
      if (value(x_1 * y_2 + -(y_1 * x_2)) < 0) std::swap(p[1], p[2]);
      std::size_t worst = 0;
      double least = kInfinity<double>;
      Vec3<double> n = Vec3<double>::Zero();
      for (std::size_t i = 0; i < 3; ++i) {
        const ProvedPoint &j = p[(i + 1) % 3], &k = p[(i + 2) % 3];
        const double e_x = value(k.x + -j.x), e_y = value(k.y + -j.y), length = hypotenuse(e_x, e_y);
        if (!(length > 0)) continue;
        if (const double inside = value(j.x * k.y + -(j.y * k.x)) / length; inside < least) {
          least = inside;
          worst = i;
          n = Vec3<double>(e_y / length, -e_x / length, 0);
        }
      }
      if (!(least < kInfinity<double>)) return;
      const Vec3<double> outward = unit(world(n[0], n[1], 0));
      if (!(least < -2 * error_)) {
        // The line is on the edge within the error bound, or all points are on one line.
        with_tilts(outward, [&](const ProvedPoint& w, bool) {
          return take_any(portal, {p[0], p[1], p[2], w, along(-outward)});
        });
        return;
      }
      const ProvedPoint &j = p[(worst + 1) % 3], &k = p[(worst + 2) % 3];
      const ProvedPoint w = along(outward);
      portal.across = outward;
      if (!(fl(n[0] * value(w.x)) + fl(n[1] * value(w.y)) > 0)) return;
      p = {w, j, k};
    }
  }

  // The portal moves to a lower one with a corner along n. `aside`: to one that is not lower. False if enough(w)
  // returns true for the point along n, so that no move is needed.
  template <class Enough>
  [[nodiscard]] bool go_along(const Vec3<double>& n, ProvedPortal& portal, ProvedPortal& aside,
                              const Enough& enough) const {
    if (!(n.cwiseAbs().maxCoeff() > 0)) return false;
    const std::array<ProvedPoint, 3> p = portal.p;
    bool stop = false;
    const bool moved = with_tilts(n, [&](const ProvedPoint& w, bool tilted) {
      stop = stop || (!tilted && enough(w));
      if (stop) return true;
      const double lower = portal.upper - kUnitRoundoff<double> * std::abs(portal.upper) - 0x1p-80;
      for (const std::array<ProvedPoint, 3>& next :
           {std::array<ProvedPoint, 3>{w, p[1], p[2]}, std::array<ProvedPoint, 3>{p[0], w, p[2]},
            std::array<ProvedPoint, 3>{p[0], p[1], w}}) {
        ProvedPortal taken = portal;
        if (!take(taken, next)) continue;
        if (taken.upper < lower) {
          portal = taken;
          return true;
        }
        if (!aside.found) aside = taken;
      }
      return false;
    });
    return moved && !stop;
  }
  // If the line passes an edge or a corner of the portal exactly, a new corner may leave the height unchanged, and
  // the iteration would never end. Other corners near it are tried first. If no corner lowers the portal, a step
  // aside is taken.
  void refine(ProvedPortal& portal, double gap, double enough) const {
    for (int step = 0, aside_steps = 0; step < kSteps; ++step) {
      const std::array<ProvedPoint, 3> p = portal.p;
      const Vec3<double> n = normal_of(p);
      if (!(n.cwiseAbs().maxCoeff() > 0)) return;
      portal.n = n;
      if (portal.upper <= enough) return;
      portal.beyond = 0;
      ProvedPortal aside;
      const bool moved = go_along(n, portal, aside, [&](const ProvedPoint& w) {
        portal.beyond = dot(n, rounded_once(w.point.w + -p[0].point.w));
        return !(portal.beyond > gap);
      });
      if (moved) continue;
      if (!(portal.beyond > gap)) return;
      if (go_along(normal_between(p), portal, aside, [](const ProvedPoint&) { return false; })) continue;
      if (!aside.found || ++aside_steps > kAsideSteps) return;
      portal = aside;
    }
  }

  const NamedPoints<S>& points_;
  TwoDoubles3 r_;
  Vec3<double> from_, to_;
  std::size_t a_ = 0, b_ = 0, c_ = 0;
  TwoDoubles rho_a_, rho_b_;
  double error_ = 0;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
