// The claims of a proof about a point and an ellipsoid, a cylinder or a cone, where the proof names no axis or no portal.
//
// In the solid's own axes the path is x(s) = o + s w, all numbers rational: a rotation is divided by |q|^2. The solid is
// the part of some slabs |x_i - m_i| <= h_i in which a quadratic g is at most 0. A radius of 0 is a slab of its own.
//
//   ellipsoid   g = sum (x_i / r_i)^2 - 1
//   cylinder    g = x^2 + y^2 - r^2              |z| <= h
//   cone        g = (2 h)^2 (x^2 + y^2) - r^2 (h - z)^2, the same slab
//
// The times of contact are an interval. So some time of [0, s] is in contact iff, over the part of it in the slabs, g is
// at most 0 at either end or at its least value. TOI >= t iff no time of [0, t] is in contact, or t is the first that is: g
// or a slab refuses the times before.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "corpus/case.hpp"
#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

class RayClaim {
 public:
  // Nothing for any other pair, and with a target distance.
  [[nodiscard]] static std::optional<RayClaim> of(const corpus::Case& problem) {
    const auto is_point = [](const Body<double>& body) {
      return std::holds_alternative<Point<double>>(body.shape);
    };
    if (problem.target_distance > 0 || is_point(problem.a) == is_point(problem.b)) return {};
    RayClaim claim;
    const bool point_is_a = is_point(problem.a);
    if (!claim.take_shape((point_is_a ? problem.b : problem.a).shape)) return {};
    claim.take_path(point_is_a ? problem.b : problem.a, point_is_a ? problem.a : problem.b);
    return claim;
  }

  // Is some time of [0, end] in contact? `end` may be infinite.
  [[nodiscard]] bool touches_by(double end) const {
    const std::optional<Span> span = within_slabs(end);
    if (!span) return false;
    if (sgn(g(span->from)) <= 0) return true;
    if (span->to && sgn(g(*span->to)) <= 0) return true;
    if (sgn(a_) <= 0) return false;
    const Rational least = -b_ / a_;
    return least > span->from && (!span->to || least < *span->to) && sgn(g(least)) <= 0;
  }
  // Is no time of [0, t) in contact?
  [[nodiscard]] bool is_free_before(double t) const {
    if (!touches_by(t)) return true;
    const Rational time(t);
    const std::optional<Span> span = within_slabs(t);
    if (!span->to || *span->to != time || sgn(g(time)) > 0) return false;
    if (span->from == time) return true;
    const int slope = sgn(a_ * time + b_);
    return sgn(g(time)) == 0 && (slope < 0 || (slope == 0 && sgn(a_) > 0));
  }

 private:
  struct Slab {
    std::size_t axis;
    Rational half;
  };
  struct Span {
    Rational from;
    std::optional<Rational> to;
  };

  // Of a g that is the sum of square_[i] (x_i - shift_[i])^2, less limit_.
  bool take_shape(const Shape<double>& shape) {
    if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&shape)) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Rational r(ellipsoid->radii[static_cast<int>(i)]);
        if (sgn(r) == 0) {
          slabs_.push_back({i, r});
        } else {
          square_[i] = 1 / (r * r);
        }
      }
      limit_ = 1;
      return true;
    }
    double radius = 0, half_height = 0;
    const auto* cone = std::get_if<Cone<double>>(&shape);
    if (cone != nullptr) {
      std::tie(radius, half_height) = std::pair(cone->radius, cone->half_height);
    } else if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape)) {
      std::tie(radius, half_height) = std::pair(cylinder->radius, cylinder->half_height);
    } else {
      return false;
    }
    const Rational r(radius), h(half_height);
    slabs_.push_back({2, h});
    if (sgn(r) == 0) {
      slabs_.push_back({0, r});
      slabs_.push_back({1, r});
    } else if (cone != nullptr && sgn(h) > 0) {
      square_ = {4 * h * h, 4 * h * h, -r * r};
      shift_ = h;
    } else {
      square_ = {1, 1, 0};
      limit_ = r * r;
    }
    return true;
  }

  void take_path(const Body<double>& solid, const Body<double>& point) {
    const auto into_solid = [&](const Vec3<double>& to, const Vec3<double>& from) {
      RationalPoint d;
      for (int i = 0; i < 3; ++i) d[static_cast<std::size_t>(i)] = Rational(to[i]) - Rational(from[i]);
      return turned_back(solid.orientation, d);
    };
    o_ = into_solid(point.position, solid.position);
    w_ = into_solid(point.displacement, solid.displacement);
    RationalPoint from = o_;
    from[2] -= shift_;
    for (std::size_t i = 0; i < 3; ++i) {
      a_ += square_[i] * w_[i] * w_[i];
      b_ += square_[i] * from[i] * w_[i];
      c_ += square_[i] * from[i] * from[i];
    }
    c_ -= limit_;
  }
  // R^T x: the columns of R are the rotated axes.
  [[nodiscard]] static RationalPoint turned_back(const Quaternion<double>& q, const RationalPoint& x) {
    const Rational w(q.w), i(q.x), j(q.y), k(q.z), size = w * w + i * i + j * j + k * k;
    const RationalPoint columns[3] = {
        {w * w + i * i - j * j - k * k, 2 * (i * j + w * k), 2 * (i * k - w * j)},
        {2 * (i * j - w * k), w * w - i * i + j * j - k * k, 2 * (j * k + w * i)},
        {2 * (i * k + w * j), 2 * (j * k - w * i), w * w - i * i - j * j + k * k}};
    RationalPoint out;
    for (std::size_t n = 0; n < 3; ++n)
      out[n] = (columns[n][0] * x[0] + columns[n][1] * x[1] + columns[n][2] * x[2]) / size;
    return out;
  }

  [[nodiscard]] Rational g(const Rational& s) const { return (a_ * s + 2 * b_) * s + c_; }
  // The part of [0, end] in every slab.
  [[nodiscard]] std::optional<Span> within_slabs(double end) const {
    Span span;
    if (end < kInfinity<double>) span.to = Rational(end);
    for (const Slab& slab : slabs_) {
      const Rational &x = o_[slab.axis], &rate = w_[slab.axis];
      if (sgn(rate) == 0) {
        if (abs(x) > slab.half) return {};
        continue;
      }
      const Rational half = sgn(rate) > 0 ? slab.half : Rational(-slab.half);
      const Rational from = (-half - x) / rate, to = (half - x) / rate;
      if (from > span.from) span.from = from;
      if (!span.to || to < *span.to) span.to = to;
    }
    if (span.to && *span.to < span.from) return {};
    return span;
  }

  RationalPoint square_, o_, w_;
  Rational limit_, shift_, a_, b_, c_;
  std::vector<Slab> slabs_;
};

}  // namespace graze::oracle
