// The positions of a rotating body's points in ball arithmetic, from the definitions alone
// (rotating_body.hpp, shape.hpp): no bound of core or of the oracles is used.
//
// Notation   c = position + R(orientation) pivot;   x(t) = R(t w) r + c + t v,  r = R(orientation) (x -
// pivot). The core of a shape is the shape without its ball (shape.hpp). For a curved core some of its points
// are sampled, so a maximum over the samples is a lower bound of the maximum over the core.
#pragma once

#include <graze/detail/numeric/dyadic.hpp>
#include <graze/detail/shapes/shape_tree.hpp>
#include <vector>

#include "oracles/curved/ball_rotation.hpp"
#include "tests/bounds/hostile.hpp"

namespace graze::test {

using oracle::Ball;
using oracle::BallRotation;
using oracle::BallVec;

// Holds 1e60 beside 1e-60 with their squares, and 2^-100 of the least of them.
inline constexpr long kTruthBits = 1024;
// For quotients of such numbers by the square of a step of 2^-200.
inline constexpr long kDifferenceBits = 2048;

inline Ball positive_part(const Ball& x) { return oracle::not_below_zero(x); }
inline Ball two_to(int k) { return oracle::power_of_two(k); }
inline Ball exactly(detail::exact::Dyadic x) {
  Ball out;
  while (x.sign() != 0) {
    const double leading = x.leading();
    const int order = x.order();
    out += Ball(leading) * two_to(order);
    x = x - detail::exact::Dyadic(leading).times_power_of_two(order);
  }
  return out;
}
inline BallVec zero_vector() { return BallVec(Vec3<double>::Zero()); }
inline Ball sine(const Ball& x) {
  Ball out;
  arb_sin(out.get(), x.get(), oracle::WorkingPrecision::bits());
  return out;
}
inline Ball pi() {
  Ball out;
  arb_const_pi(out.get(), oracle::WorkingPrecision::bits());
  return out;
}
inline BallVec unit_of(const BallVec& x) { return (Ball(1) / norm(x)) * x; }

// Directions to take points of curved surfaces along.
inline std::vector<BallVec> some_directions() {
  std::vector<BallVec> out;
  for (const Vec3<double>& d :
       {Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0), Vec3<double>(0, 0, 1), Vec3<double>(1, 1, 0),
        Vec3<double>(1, 0, 1), Vec3<double>(-3, 4, 5), Vec3<double>(1, -2, 2)}) {
    out.push_back(unit_of(BallVec(d)));
    out.push_back(-out.back());
  }
  return out;
}

inline Ball radius_of(const Shape<double>& shape) {
  const auto least = [](const auto& parts) {
    Ball out = radius_of(parts[0]->shape);
    for (const auto& part : parts) out = min(out, radius_of(part->shape));
    return out;
  };
  const auto total = [](const auto& parts) {
    Ball out;
    for (const auto& part : parts) out += radius_of(part->shape);
    return out;
  };
  return std::visit(
      detail::Overloaded{[](const Sphere<double>& s) { return Ball(s.radius); },
                         [](const Capsule<double>& s) { return Ball(s.radius); },
                         [](const Posed<double>& s) { return radius_of(s.shape->shape); },
                         [](const Rounded<double>& s) { return radius_of(s.shape->shape) + Ball(s.radius); },
                         [&](const Sum<double>& s) { return total(s.shapes); },
                         [&](const HullOf<double>& s) { return least(s.shapes); },
                         [](const auto&) { return Ball(0); }},
      shape);
}

// Points of the shape less a ball of radius `less`, which is at most radius_of(shape).
class CorePoints {
 public:
  using Points = std::vector<BallVec>;

  [[nodiscard]] static Points of(const Shape<double>& shape) { return CorePoints{}(shape, radius_of(shape)); }

 private:
  Points operator()(const Shape<double>& shape, const Ball& less) const {
    return std::visit([&](const auto& s) { return points(s, less); }, shape);
  }
  [[nodiscard]] Points with_ball(const Points& centers, const Ball& radius) const {
    if (!radius.is_positive()) return centers;
    Points out;
    for (const BallVec& c : centers) {
      for (const BallVec& d : directions_) out.push_back(c + radius * d);
    }
    return out;
  }
  static Points some(std::initializer_list<Vec3<double>> list) {
    Points out;
    for (const Vec3<double>& x : list) out.emplace_back(x);
    return out;
  }

  Points points(const Point<double>&, const Ball&) const { return {zero_vector()}; }
  Points points(const Sphere<double>& s, const Ball& less) const {
    return with_ball({zero_vector()}, Ball(s.radius) - less);
  }
  Points points(const Capsule<double>& s, const Ball& less) const {
    return with_ball(some({{0, 0, -s.half_height}, {0, 0, s.half_height}}), Ball(s.radius) - less);
  }
  Points points(const Segment<double>& s, const Ball&) const { return some({s.a, s.b}); }
  Points points(const Triangle<double>& s, const Ball&) const { return some({s.a, s.b, s.c}); }
  Points points(const Box<double>& s, const Ball&) const {
    Points out;
    for (unsigned k = 0; k < 8; ++k) {
      Vec3<double> x = s.half_extents;
      for (int i = 0; i < 3; ++i) {
        if ((k >> i & 1u) != 0) x[i] = -x[i];
      }
      out.emplace_back(x);
    }
    return out;
  }
  Points points(const Hull<double>& s, const Ball&) const {
    Points out;
    for (const Vec3<double>& x : s.vertices()) out.emplace_back(x);
    return out;
  }
  Points points(const Ellipsoid<double>& s, const Ball&) const {
    Points out;
    const BallVec r(s.radii);
    for (const BallVec& d : directions_) {
      const BallVec scaled{r.x * d.x, r.y * d.y, r.z * d.z};
      if (!norm(scaled).is_positive()) continue;
      const BallVec e = unit_of(scaled);
      out.push_back({r.x * e.x, r.y * e.y, r.z * e.z});
    }
    if (out.empty()) out.push_back(zero_vector());
    return out;
  }
  [[nodiscard]] static Points rim(double radius, double z) {
    Points out;
    const Ball diagonal = Ball(radius) * sqrt(Ball(0.5));
    for (const double x : {-1.0, 0.0, 1.0}) {
      for (const double y : {-1.0, 0.0, 1.0}) {
        if (x == 0 && y == 0) continue;
        const Ball r = x != 0 && y != 0 ? diagonal : Ball(radius);
        out.push_back({Ball(x) * r, Ball(y) * r, Ball(z)});
      }
    }
    return out;
  }
  Points points(const Cylinder<double>& s, const Ball&) const {
    Points out = rim(s.radius, s.half_height), below = rim(s.radius, -s.half_height);
    out.insert(out.end(), below.begin(), below.end());
    return out;
  }
  Points points(const Cone<double>& s, const Ball&) const {
    Points out = rim(s.radius, -s.half_height);
    out.emplace_back(Vec3<double>(0, 0, s.half_height));
    return out;
  }
  Points points(const Posed<double>& s, const Ball& less) const {
    const BallRotation turn(s.orientation);
    Points out = (*this)(s.shape->shape, less);
    for (BallVec& x : out) x = turn.apply(x) + BallVec(s.position);
    return out;
  }
  Points points(const Rounded<double>& s, const Ball& less) const {
    const Ball more = less - Ball(s.radius);
    if (more.is_nonnegative()) return (*this)(s.shape->shape, more);
    return with_ball((*this)(s.shape->shape, Ball(0)), -more);
  }
  Points points(const Sum<double>& s, const Ball& less) const {
    Points out = {zero_vector()};
    Ball rest = less;
    for (const auto& part : s.shapes) {
      const Ball own = min(rest, radius_of(part->shape));
      rest -= own;
      Points sums;
      for (const BallVec& x : out) {
        for (const BallVec& y : (*this)(part->shape, own)) sums.push_back(x + y);
      }
      out = std::move(sums);
    }
    return out;
  }
  Points points(const HullOf<double>& s, const Ball& less) const {
    Points out;
    for (const auto& part : s.shapes) {
      const Points own = (*this)(part->shape, less);
      out.insert(out.end(), own.begin(), own.end());
    }
    return out;
  }

  std::vector<BallVec> directions_ = some_directions();
};

// A rotating body: its pivot, its arms, and their positions at any time. `pivot` is in the body's own frame.
// For a body that does not rotate, any point will do.
struct TrueBody {
  TrueBody(const RotatingBody<double>& given, const Vec3<double>& own_pivot)
      : orientation(given.body.orientation),
        w(given.rotation),
        v(given.body.displacement),
        pivot(BallVec(given.body.position) + orientation.apply(BallVec(own_pivot))),
        turns(given.rotation != Vec3<double>::Zero()),
        rate(norm(w)) {
    for (const BallVec& x : CorePoints::of(given.body.shape)) {
      arms.push_back(orientation.apply(x - BallVec(own_pivot)));
    }
  }
  explicit TrueBody(const RotatingBody<double>& given) : TrueBody(given, given.pivot) {}

  [[nodiscard]] BallRotation turn(const Ball& t) const { return BallRotation(t * w); }
  [[nodiscard]] BallVec pivot_at(const Ball& t) const { return pivot + t * v; }
  [[nodiscard]] BallVec place(const BallVec& arm, const Ball& t) const {
    return turn(t).apply(arm) + pivot_at(t);
  }
  // Greatest over the arms.
  [[nodiscard]] Ball reach() const {
    Ball out;
    for (const BallVec& arm : arms) out = max(out, norm(arm));
    return out;
  }
  [[nodiscard]] Ball rho() const {
    Ball out;
    for (const BallVec& arm : arms) out = max(out, norm(cross(w, arm)) / rate);
    return out;
  }
  [[nodiscard]] Ball high() const {
    Ball out = dot(w, arms[0]) / rate;
    for (const BallVec& arm : arms) out = max(out, dot(w, arm) / rate);
    return out;
  }
  [[nodiscard]] Ball low() const {
    Ball out = dot(w, arms[0]) / rate;
    for (const BallVec& arm : arms) out = min(out, dot(w, arm) / rate);
    return out;
  }
  // How far a point at distance 1 from the axis gets within time t: 2 sin(min(|w| t, pi) / 2).
  [[nodiscard]] Ball chord(double t) const { return Ball(2) * sine(min(rate * Ball(t), pi()) / Ball(2)); }

  BallRotation orientation;
  BallVec w, v, pivot;
  bool turns;
  Ball rate;
  std::vector<BallVec> arms;
};

}  // namespace graze::test
