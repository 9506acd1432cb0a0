// Random linear cases for the tests and the benchmark of the proof checker. One draw a statement (or in a
// braced list), so that the order, and with it every bit, is the same for every compiler.
#pragma once

#include <algorithm>
#include <vector>

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::test {

enum class Numbers { integers, floats, doubles };
enum class Pose { identity, quarter_turns, rotated };

struct Draw {
  corpus::Random random;

  explicit Draw(std::uint64_t seed) : random(seed) {}

  double number(Numbers kind, double reach) {
    const double x = random.uniform(-reach, reach);
    switch (kind) {
      case Numbers::integers:
        return std::nearbyint(x);
      case Numbers::floats:
        return static_cast<double>(static_cast<float>(x));
      case Numbers::doubles:
        return x;
    }
    return x;
  }
  Vec3<double> vector(Numbers kind, double reach) {
    return {number(kind, reach), number(kind, reach), number(kind, reach)};
  }
  Quaternion<double> orientation(Pose pose) {
    const auto sign = [this] { return static_cast<double>(random.integer(-1, 1)); };
    switch (pose) {
      case Pose::identity:
        return {random.unit() + 0.5, 0, 0, 0};
      case Pose::quarter_turns: {
        const Quaternion<double> q{sign(), sign(), sign(), sign()};
        return q.w == 0 && q.is_identity() ? Quaternion<double>{1, 1, 0, 0} : q;
      }
      case Pose::rotated:
        return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
    }
    return {};
  }
  Hull<double> hull(Numbers kind, int fewest, int most) {
    std::vector<Vec3<double>> vertices(static_cast<std::size_t>(random.integer(fewest, most)));
    for (Vec3<double>& x : vertices) x = vector(kind, 4);
    return Hull<double>(vertices);
  }
  Shape<double> shape(Numbers kind) {
    switch (random.below(6)) {
      case 0:
        return Point<double>{};
      case 1:
        return Sphere<double>{std::abs(number(kind, 3))};
      case 2:
        return Box<double>{vector(kind, 4).cwiseAbs()};
      default:
        return hull(kind, 4, 32);
    }
  }
};

// Two bodies some way apart, B on its way to A.
inline corpus::Case approaching(Draw& draw, Numbers kind, Pose pose, Shape<double> a, Shape<double> b) {
  corpus::Case c;
  c.a.shape = std::move(a);
  c.b.shape = std::move(b);
  const double spread = draw.random.once_in(3) ? 1000 : 5;
  const Vec3<double> far = draw.vector(kind, spread);
  Vec3<double> way = draw.vector(Numbers::doubles, 1);
  way /= way.stableNorm();
  const double gap = draw.random.uniform(4, 20);
  const auto as_drawn = [kind](const Vec3<double>& x) -> Vec3<double> {
    if (kind == Numbers::integers) return x.array().rint();
    return kind == Numbers::floats ? Vec3<double>(x.cast<float>().cast<double>()) : x;
  };
  c.a.position = far;
  c.b.position = as_drawn(far + gap * way);
  c.a.orientation = draw.orientation(pose);
  c.b.orientation = draw.orientation(pose);
  c.a.displacement = draw.vector(kind, 2);
  const double overshoot = draw.random.uniform(0.8, 2);
  const Vec3<double> aside = draw.vector(kind, 2);
  c.b.displacement = as_drawn(c.a.displacement - gap * overshoot * way + aside);
  c.t_max = draw.random.once_in(3) ? kInfinity<double> : draw.random.uniform(0.5, 2);
  return c;
}

inline corpus::Case approaching(Draw& draw, Numbers kind, Pose pose, Shape<double> a) {
  Shape<double> b = draw.shape(kind);
  return approaching(draw, kind, pose, std::move(a), std::move(b));
}
inline corpus::Case approaching(Draw& draw, Numbers kind, Pose pose) {
  return approaching(draw, kind, pose, draw.shape(kind));
}

}  // namespace graze::test
