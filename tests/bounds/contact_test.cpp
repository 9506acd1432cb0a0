// Tests the quantities that proofs of contact rest on against balls (contact.hpp, crossing.hpp, whole_turns.hpp):
// - the distance of a support point from the point that its feature names,
// - volumes and depths of tetrahedra,
// - a passage through a triangle,
// - the set that a body sweeps in whole turns.
#include <gtest/gtest.h>

#include <graze/detail/rotating/crossing.hpp>
#include <graze/detail/rotating/whole_turns.hpp>

#include "oracles/curved/ball_motion.hpp"
#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/describe.hpp"
#include "tests/bounds/true_mobility.hpp"

namespace graze::test {
namespace {

using detail::MovingPair;
using oracle::BallMotion;
using oracle::WorkingPrecision;

constexpr double kU = kUnitRoundoff<double>;

struct Moving {
  BallMotion a, b;
  Ball radius_a, radius_b, unit;

  Moving(const HostileScene& scene, const MovingPair& pair)
      : a(scene.a.body, {scene.a.rotation, scene.a.pivot}, scene.a.body.position),
        b(scene.b.body, {scene.b.rotation, scene.b.pivot}, scene.a.body.position),
        radius_a(radius_of(scene.a.body.shape)),
        radius_b(radius_of(scene.b.body.shape)),
        unit(two_to(-pair.cso().length_exponent())) {}
  // max n.w over C's core, internal.
  [[nodiscard]] Ball height(const BallVec& n, double t) const {
    const Ball radii = (radius_a + radius_b) * norm(n);
    return unit * (a.support(n, Ball(t)).reach + b.support(-n, Ball(t)).reach - radii);
  }
};

TEST(ContactBounds, ASupportPointIsWhereItsFeatureSays) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(81);
  Tally named("contact_error, of a vertex"), inside("contact_error, of the set");
  for (int i = 0; i < rounds(700); ++i) {
    const HostileScene scene = draw.scene();
    MovingPair pair(scene.a, scene.b, scene.target);
    const Moving truth(scene, pair);
    for (int k = 0; k < 3; ++k) {
      const double t = draw.time(scene);
      const Vec3<double> n = draw.direction(scene);
      const auto with = [&] { return describe(scene, n, t); };
      pair.place(t);
      const detail::CsoPoint<double> p = pair.cso().support(n);
      const double e = detail::contact_error(pair);
      const BallVec w(p.w), m(draw.direction(scene));
      inside.add(e, positive_part((dot(m, w) - truth.height(m, t)) / norm(m)), with);
      if (pair.cso().curved()) continue;
      const auto at = [&](const BallMotion& body, std::uint32_t vertex) {
        return body.at(Ball(t)).place(body.named({.vertex = vertex}));
      };
      named.add(e, norm(w - truth.unit * (at(truth.a, p.vertex_a) - at(truth.b, p.vertex_b))), with);
    }
  }
  named.finish(300);
  inside.finish(100);
}

// --- tetrahedra

Ball volume(const BallVec& a, const BallVec& b, const BallVec& c) { return dot(a, cross(b, c)); }

TEST(ContactBounds, VolumesAndDepthsOfTetrahedra) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(82);
  Tally determinants("determinant, over 2^-96 |a| |b| |c|"), depth("1 / depth_inside");
  int inside = 0, refused = 0;
  for (int i = 0; i < rounds(5000); ++i) {
    // Slivers, flat ones, corners of many sizes, the origin near a face or in it.
    std::array<Vec3<double>, 4> w;
    const double far = draw.chance(0.3) ? draw.power(0, 30) : 1,
                 flat = draw.chance(0.5) ? draw.power(-50, 0) : 1;
    for (Vec3<double>& x : w) {
      x = draw.plain().vector<double>(1);
      x[2] *= flat;
      x *= draw.chance(0.3) ? far : 1;
    }
    if (draw.chance(0.7)) {
      // The last vertex lies opposite the others, so the origin is inside up to rounding.
      const Vec3<double> sum = w[0] * draw.power(-20, 0) + w[1] + w[2] * draw.power(-4, 4);
      w[3] = -sum * draw.power(-10, 2);
      if (draw.chance(0.3)) w[3] = draw.nudged(w[3]);
    }
    if (draw.chance(0.1)) w[1] = draw.nudged(w[0]);
    const auto with = [&] {
      return "  " + describe(w[0]) + describe(w[1]) + describe(w[2]) + describe(w[3]) + "\n";
    };
    const BallVec a(w[0]), b(w[1]), c(w[2]), d(w[3]);
    const Ball product = norm(a) * norm(b) * norm(c);
    if (product.is_positive()) {
      determinants.add(0x1p-96 + kU * std::abs((volume(a, b, c) / product).mid_double()),
                       abs(Ball(detail::determinant(w[0], w[1], w[2])) - volume(a, b, c)) / product, with);
    }
    const double seen = detail::depth_inside(w);
    if (!(seen > 0)) {
      ++refused;
      continue;
    }
    ++inside;
    // The least distance from a face. The origin is inside if all volumes with it have one sign.
    const std::array<BallVec, 4> p = {a, b, c, d};
    Ball least(kInfinity<double>);
    int positive = 0, negative = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const BallVec &x = p[(k + 1) % 4], &y = p[(k + 2) % 4], &z = p[(k + 3) % 4];
      const Ball v = Ball(k % 2 == 0 ? 1 : -1) * volume(x, y, z);
      positive += v.is_positive();
      negative += v.is_negative();
      least = min(least, abs(v) / norm(cross(y - x, z - x)));
    }
    EXPECT_TRUE(positive == 4 || negative == 4) << with();
    depth.add(1 / seen, Ball(1) / least, with);
  }
  determinants.finish(1000);
  depth.finish(500);
  EXPECT_GT(inside, 500);
  EXPECT_GT(refused, 500);
}

// --- passages

// A point flies through a triangle that rotates, by a little or by much, about a pivot near or far. At a
// claimed passage, the true height of the origin over the true triangle changes its sign. Along the
// normal at the start, the origin stays inside at every sampled time.
TEST(ContactBounds, APassageIsOne) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(83);
  int passages = 0, wrong = 0;
  std::string failures;
  for (int i = 0; i < rounds(3000); ++i) {
    HostileScene scene;
    const auto point = [&](double size) { return draw.plain().vector<double>(size); };
    scene.a.body.shape = Triangle<double>{point(1), point(1), point(1)};
    scene.a.body.orientation = draw.plain().turn<double>();
    scene.a.rotation = point(4) * (draw.chance(0.3) ? draw.power(-20, 0) : 1);
    if (draw.chance(0.4)) scene.a.pivot = unit(point(1)) * draw.power(0, 30);
    scene.b.rotation = draw.chance(0.3) ? scene.a.rotation : point(2);
    scene.b.body.displacement = point(4);
    if (draw.chance(0.3)) scene.b.pivot = unit(point(1)) * draw.power(0, 30);
    scene.b.body.shape = Point<double>{};
    // At `then` the point is near the plane, at a point of it inside the triangle or not.
    const double then = draw.plain().between(0.2, 0.8), dt = draw.power(-30, -1);
    const TrueBody a(scene.a), b(scene.b);
    std::array<double, 3> l{};
    double sum = 0;
    for (double& x : l) sum += x = draw.plain().between(-0.1, 1);
    BallVec target = zero_vector();
    for (std::size_t k = 0; k < 3; ++k) target = target + Ball(l[k] / sum) * a.place(a.arms[k], Ball(then));
    scene.b.body.position = (target - b.place(b.arms[0], Ball(then))).mid_double();
    const double t_1 = then - dt * draw.plain().between(0, 0.2),
                 t_2 = then + dt * draw.plain().between(-0.05, 0.2);
    if (!(t_1 < t_2)) continue;
    MovingPair pair(scene.a, scene.b, 0.0);
    detail::Simplex<double> triangle;
    for (std::uint32_t k = 0; k < 3; ++k) {
      detail::CsoPoint<double> p;
      p.vertex_a = k;
      triangle.add(p);
    }
    if (!detail::crosses(pair, triangle, t_1, t_2)) continue;
    ++passages;
    const TrueBody other(scene.b);
    const auto corners = [&](const Ball& t) {
      std::array<BallVec, 3> out;
      for (std::size_t k = 0; k < 3; ++k) out[k] = a.place(a.arms[k], t) - other.place(other.arms[0], t);
      return out;
    };
    const auto first = corners(Ball(t_1)), last = corners(Ball(t_2));
    const BallVec n = cross(first[1] - first[0], first[2] - first[0]);
    bool holds = (volume(first[0], first[1], first[2]) * volume(last[0], last[1], last[2])).is_negative();
    for (int k = 0; k <= 8; ++k) {
      const auto now = corners(Ball(t_1) + Ball(k / 8.0) * (Ball(t_2) - Ball(t_1)));
      for (std::size_t e = 0; e < 3; ++e)
        holds = holds && dot(n, cross(now[e], now[(e + 1) % 3])).is_positive();
    }
    if (!holds && ++wrong <= 3) {
      std::ostringstream out;
      out << std::hexfloat << "  from " << t_1 << " to " << t_2 << "\n";
      failures += out.str() + describe(scene);
    }
  }
  std::printf("passages: %d\n", passages);
  EXPECT_EQ(wrong, 0) << failures;
  EXPECT_GE(passages, rounds(150));
}

// --- whole turns

TEST(WholeTurnBounds, TheCylinderHoldsTheBodyAtAllItsAngles) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(84);
  Tally error("swept_error, of the cylinder's gap"), bend("swept_bend");
  int narrower = 0;
  std::string failures;
  for (int i = 0; i < rounds(700); ++i) {
    const HostileScene scene = draw.scene();
    MovingPair pair(scene.a, scene.b, scene.target);
    const Moving truth(scene, pair);
    const TrueBody a(scene.a, pair.pivot_a()), b(scene.b);
    const detail::WholeTurns whole{a.turns && draw.chance(0.7), b.turns && draw.chance(0.7)};
    if (!whole.any()) continue;
    const TrueMobility of_a(a, scene.a, pair.pivot_a(), truth.unit),
        of_b(b, scene.b, scene.b.pivot, truth.unit);
    Counters counters;
    for (int k = 0; k < 3; ++k) {
      const double t = draw.time(scene);
      const Vec3<double> n = draw.direction(scene);
      const BallVec along(n);
      const auto with = [&] {
        return describe(scene, n, t) + (whole.a ? "  A" : "  ") + (whole.b ? "B\n" : "\n");
      };
      pair.place(t);
      const double seen = detail::swept_gap(pair, whole, n, counters), e = detail::swept_error(pair);
      // The cylinder with the numbers that the pair has, about the true position of the pivot.
      const auto cylinder = [&](const detail::Mobility& m, const BallVec& axis, const BallVec& d) {
        const Ball sine = dot(d, axis);
        return max(sine * Ball(m.high), sine * Ball(m.low)) + norm(cross(d, axis)) * Ball(m.rho);
      };
      // And of the points, at the angle where each is highest.
      const auto points = [&](const TrueBody& body, const BallVec& d) {
        const BallVec axis = unit_of(body.w);
        Ball most(-kInfinity<double>);
        for (const BallVec& arm : body.arms) {
          most = max(most, dot(d, axis) * dot(axis, arm) + norm(cross(d, axis)) * norm(cross(axis, arm)));
        }
        return truth.unit * most;
      };
      const auto gap = [&](bool of_points) {
        const auto height = [&](const TrueBody& body, const detail::Mobility& m, const BallMotion& motion,
                                const Ball& radius, const BallVec& d, bool swept) {
          const BallVec path = body.pivot_at(Ball(t)) - BallVec(scene.a.body.position);
          if (!swept) return truth.unit * (motion.support(d, Ball(t)).reach - radius * norm(d));
          const Ball own = of_points ? points(body, d) : cylinder(m, unit_of(body.w), d);
          return own + truth.unit * dot(d, path);
        };
        return -(height(a, pair.mobility_a(), truth.a, truth.radius_a, along, whole.a) +
                 height(b, pair.mobility_b(), truth.b, truth.radius_b, -along, whole.b)) -
               truth.unit * (truth.radius_a + truth.radius_b + Ball(scene.target)) * norm(along);
      };
      error.add(e, abs(Ball(seen) + Ball(e) - gap(false)), with);
      if (certainly_less(gap(true), Ball(seen)) && ++narrower <= 3) failures += with();
      bend.add(
          detail::swept_bend(pair, whole, n),
          (whole.a ? Ball(0) : of_a.acceleration(along)) + (whole.b ? Ball(0) : of_b.acceleration(along)),
          with);
    }
  }
  error.finish(500);
  bend.finish(200);
  EXPECT_EQ(narrower, 0) << failures;
}

}  // namespace
}  // namespace graze::test
