// Rays by the direct clips: against closed forms, and against the searches that answered them before.
//
// The searches are still there: the exact tier walks where a proof is requested, the certified tier searches under
// pass_over, which changes nothing for a start that is apart.
#include <gtest/gtest.h>

#include <graze/cast.hpp>
#include <graze/distance.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

constexpr double kU = kUnitRoundoff<double>;

Body<double> ray(const V& origin, const V& displacement) {
  return {.shape = Point<double>{}, .position = origin, .displacement = displacement};
}
CastResult<double> cast_by(Tier tier, const Body<double>& a, const Body<double>& b,
                           CastOptions<double> options = {}) {
  options.tier = tier;
  return cast(a, b, options);
}

// q x conj(q), the length times |q|^2: exact for small integers.
V turned(const Quaternion<double>& q, const V& x) {
  const V u(q.x, q.y, q.z);
  const auto cross = [](const V& a, const V& b) {
    return V(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  };
  return (q.w * q.w - u.dot(u)) * x + 2 * u.dot(x) * u + 2 * q.w * cross(u, x);
}

struct Known {
  Shape<double> shape;  // its lengths times |q|^2
  V from, to;           // own frame
  double t;             // infinite: a miss
  V normal;
};

// Each ray lies in a grid, so that the whole answer is rational. Every length is times s = |q|^2.
std::vector<Known> known_rays(double s) {
  const double never = kInfinity<double>;
  return {
      {Sphere<double>{5 * s}, {-12, 3, 0}, {4, 3, 0}, 0.5, {-0.8, 0.6, 0}},
      {Sphere<double>{5 * s}, {-12, 6, 0}, {4, 6, 0}, never, {}},
      {Capsule<double>{5 * s, 8 * s}, {-12, 3, 2}, {4, 3, 2}, 0.5, {-0.8, 0.6, 0}},
      {Capsule<double>{5 * s, 8 * s}, {-12, 0, 11}, {4, 0, 11}, 0.5, {-0.8, 0, 0.6}},
      {Capsule<double>{5 * s, 8 * s}, {3, 0, -20}, {3, 0, -4}, 0.5, {0.6, 0, -0.8}},
      {Capsule<double>{5 * s, 8 * s}, {-12, 0, 14}, {4, 0, 14}, never, {}},
      {Cylinder<double>{5 * s, 8 * s}, {-12, 3, 2}, {4, 3, 2}, 0.5, {-0.8, 0.6, 0}},
      {Cylinder<double>{5 * s, 8 * s}, {1, 2, 24}, {1, 2, -8}, 0.5, {0, 0, 1}},
      {Cylinder<double>{5 * s, 8 * s}, {-8, 0, 16}, {8, 0, 0}, 0.5, {0, 0, 1}},
      {Cylinder<double>{5 * s, 8 * s}, {-12, 0, 9}, {12, 0, 9}, never, {}},
      {Cylinder<double>{5 * s, 8 * s}, {-8, 0, 22}, {8, 0, 6}, never, {}},
      // Slope 1/2: at z = 0 the circle of radius 4.
      {Cone<double>{8 * s, 8 * s}, {-12, 0, 0}, {4, 0, 0}, 0.5, {-2, 0, 1}},
      {Cone<double>{8 * s, 8 * s}, {3, 0, -24}, {3, 0, 8}, 0.5, {0, 0, -1}},
      {Cone<double>{8 * s, 8 * s}, {-4, 0, 24}, {4, 0, 24}, never, {}},  // the upper half of the double cone
      {Cone<double>{8 * s, 8 * s}, {-4, 0, 20}, {4, 0, 12}, never, {}},
      {Cone<double>{8 * s, 8 * s}, {-20, 0, -9}, {20, 0, -9}, never, {}},
      {Ellipsoid<double>{{10 * s, 5 * s, 20 * s}}, {-14, 3, 0}, {-2, 3, 0}, 0.5, {-8, 12, 0}},
      {Ellipsoid<double>{{10 * s, 5 * s, 20 * s}}, {-24, 6, 0}, {8, 6, 0}, never, {}},
      {Box<double>{{4 * s, 5 * s, 6 * s}}, {-12, 3, 2}, {4, 3, 2}, 0.5, {-1, 0, 0}},
      {Box<double>{{4 * s, 5 * s, 6 * s}}, {1, 2, 22}, {3, -1, -10}, 0.5, {0, 0, 1}},
      {Box<double>{{4 * s, 5 * s, 6 * s}}, {-12, 6, 2}, {4, 6, 2}, never, {}},
      {Triangle<double>{{0, 0, 0}, {8 * s, 0, 0}, {0, 8 * s, 0}}, {1, 2, 4}, {3, 2, -4}, 0.5, {0, 0, 1}},
      {Triangle<double>{{0, 0, 0}, {8 * s, 0, 0}, {0, 8 * s, 0}}, {5, 5, 4}, {5, 5, -4}, never, {}},
  };
}

TEST(Rays, AreWhatClosedFormsSay) {
  const Quaternion<double> poses[] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 2, 0}, {2, -1, 3, 1}, {0, 1, 1, 1}};
  for (const Quaternion<double>& q : poses) {
    const double s = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    for (const V& place : {V(0, 0, 0), V(512, -1024, 37)}) {
      for (const Known& known : known_rays(s)) {
        const Body<double> body{.shape = known.shape, .position = place, .orientation = q};
        const V from = turned(q, known.from), way = turned(q, known.to - known.from);
        const V normal = known.normal.squaredNorm() > 0 ? unit(turned(q, known.normal)) : known.normal;
        for (const Tier tier : {Tier::standard, Tier::certified, Tier::exact}) {
          for (const bool swapped : {false, true}) {
            const Body<double> point = ray(place + from, way);
            const CastResult<double> r = swapped ? cast_by(tier, point, body) : cast_by(tier, body, point);
            const double scale = from.norm() + 40 * s + place.norm();
            if (!(known.t < kInfinity<double>)) {
              EXPECT_EQ(r.outcome, Outcome::miss) << known.shape.index();
              continue;
            }
            ASSERT_EQ(r.outcome, Outcome::hit) << known.shape.index() << " " << known.from.transpose();
            const double slack = tier == Tier::standard ? 64 * kU * scale / way.norm() : 0;
            EXPECT_LE(r.toi_lower, known.t + slack);
            EXPECT_GE(r.toi_upper, known.t - slack);
            EXPECT_LE((r.toi_upper - r.toi_lower) * way.norm(), 1e-12 * scale);
            EXPECT_LE((r.normal - (swapped ? V(-normal) : normal)).norm(), 1e-10);
            const V at = place + from + known.t * way;
            EXPECT_LE((r.point_a - at).norm(), 1e-10 * scale);
            EXPECT_LE((r.point_b - at).norm(), 1e-10 * scale);
          }
        }
      }
    }
  }
}

// At t_max and one double before it, from a start inside, and from one on the surface.
TEST(Rays, EndWhereTheyEnd) {
  const Body<double> ball{.shape = Sphere<double>{1}};
  const Body<double> box{.shape = Box<double>{{1, 1, 1}}};
  for (const Body<double>& body : {ball, box}) {
    for (const Tier tier : {Tier::standard, Tier::certified}) {
      CastOptions<double> options;
      options.t_max = 0.5 - 1e-9;
      EXPECT_EQ(cast_by(tier, body, ray({-3, 0, 0}, {4, 0, 0}), options).outcome, Outcome::miss);
      options.t_max = 0.5 + 1e-9;
      EXPECT_EQ(cast_by(tier, body, ray({-3, 0, 0}, {4, 0, 0}), options).outcome, Outcome::hit);
      EXPECT_EQ(cast_by(tier, body, ray({0.5, 0, 0}, {4, 0, 0})).outcome, Outcome::initially_overlapping);
      EXPECT_EQ(cast_by(tier, body, ray({3, 0, 0}, {4, 0, 0})).outcome, Outcome::miss);
      EXPECT_EQ(cast_by(tier, body, ray({0.5, 0, 0}, {0, 0, 0})).outcome, Outcome::initially_overlapping);
    }
  }
  CastOptions<double> options;
  options.t_max = 0.5;
  EXPECT_EQ(cast_by(Tier::exact, box, ray({-3, 0, 0}, {4, 0, 0}), options).outcome, Outcome::hit);
  options.t_max = std::nextafter(0.5, 0.0);
  EXPECT_EQ(cast_by(Tier::exact, box, ray({-3, 0, 0}, {4, 0, 0}), options).outcome, Outcome::miss);
  EXPECT_EQ(cast_by(Tier::exact, box, ray({1, 0, 0}, {4, 0, 0})).outcome, Outcome::initially_overlapping);
}

// A ball of 2 with a target distance of 1 is one of 3, and its witness is on the ball.
TEST(Rays, KeepATargetDistance) {
  CastOptions<double> options;
  options.target_distance = 1;
  const CastResult<double> r =
      cast(Body<double>{.shape = Sphere<double>{2}}, ray({-5, 0, 0}, {4, 0, 0}), options);
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_DOUBLE_EQ(r.toi_lower, 0.5);
  EXPECT_LE((r.point_a - V(-2, 0, 0)).norm(), 1e-15);
  EXPECT_LE((r.point_b - V(-3, 0, 0)).norm(), 1e-15);
}

// The target of a random ray is anything about the body, a corner, an edge or a point of a face. The start is
// near, far or on the surface, and the direction is along an axis or arbitrary.
struct Shot {
  Body<double> body, point;
};
template <class Make>
Shot shot(Draw& draw, const Make& make) {
  const V h(draw.between(0.25, 2), draw.between(0.25, 2), draw.between(0.25, 2));
  Shot out{{.shape = make(draw, h)}, {.shape = Point<double>{}}};
  const bool grid = draw.bits() % 2 == 0;
  Quaternion<double>& q = out.body.orientation;
  if (draw.bits() % 3 == 0) q = draw.turn<double>();
  if (draw.bits() % 4 == 0) q = {1, double(int(draw.bits() % 3)) - 1, 2, 0};
  if (draw.bits() % 2 == 0) out.body.position = (draw.bits() % 4 == 0 ? 1e6 : 4) * draw.vector<double>(1);
  if (draw.bits() % 4 == 0) out.body.displacement = draw.vector<double>(2);
  V aim;
  for (int i = 0; i < 3; ++i) {
    constexpr double kPlaces[] = {-1, 0, 1, 0.5, 1.25};
    aim[i] = h[i] * (grid ? kPlaces[draw.bits() % 5] : draw.between(-1.25, 1.25));
  }
  if (draw.bits() % 3 == 0) aim *= 1 + std::exp2(-draw.between(0, 60));
  V way = draw.vector<double>(4);
  for (int i = 0; i < 3; ++i) {
    if (draw.bits() % 4 == 0) way[i] = 0;
  }
  constexpr double kBacks[] = {0, 0.25, 0.5, 1, 1.5, 20, -0.5};
  const double back = kBacks[draw.bits() % 7], norm = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  out.point.position = out.body.position + turned(q, aim - back * way) / norm;
  out.point.displacement = out.body.displacement + turned(q, way) / norm;
  if (draw.bits() % 8 == 0) std::swap(out.body, out.point);
  return out;
}

// With a proof the tier walks. Everything that the tier promises is the same, to the bit.
TEST(Rays, OfTheExactTierAreThoseOfItsWalk) {
  Draw draw{1};
  int outcomes[5] = {}, direct = 0;
  for (int i = 0; i < 60000; ++i) {
    const Shot s = shot(draw, [](Draw& d, const V& h) -> Shape<double> {
      if (d.bits() % 3 == 0) {
        return Triangle<double>{
            {-h[0], -h[1], -h[2]}, {h[0], -h[1], d.bits() % 2 ? h[2] : -h[2]}, {0, h[1], h[2]}};
      }
      return Box<double>{d.bits() % 16 == 0 ? V(h[0], 0, h[2]) : h};
    });
    CastOptions<double> options;
    options.tier = Tier::exact;
    if (draw.bits() % 4 == 0) options.t_max = kInfinity<double>;
    const CastResult<double> r = cast(s.body, s.point, options);
    options.request = Request::everything;
    const CastResult<double> walk = cast(s.body, s.point, options);
    ASSERT_EQ(r.outcome, walk.outcome) << i;
    if (r.outcome == Outcome::hit || r.outcome == Outcome::miss) {
      ASSERT_EQ(r.toi_lower, walk.toi_lower) << i;
      ASSERT_EQ(r.toi_upper, walk.toi_upper) << i;
    }
    ++outcomes[int(r.outcome)];
    if (r.counters.supports == 0) {
      ++direct;
      // The facet is known, so the normal is.
      ASSERT_LE((r.normal - walk.normal).norm(), 16 * kU) << i;
    }
    ASSERT_LE((r.point_a - walk.point_a).norm(),
              1e-12 * (1 + s.point.position.norm() + s.body.position.norm()))
        << i;
  }
  EXPECT_GT(outcomes[int(Outcome::hit)], 10000);
  EXPECT_GT(outcomes[int(Outcome::miss)], 10000);
  EXPECT_GT(outcomes[int(Outcome::initially_overlapping)], 2000);
  EXPECT_GT(direct, 30000);
}

// The standard tier and the certified one, and the certified tier's search under pass_over.
TEST(Rays, OfSolidsMeetTheSearches) {
  Draw draw{2};
  int hits = 0, misses = 0, starts = 0, ties = 0;
  for (int i = 0; i < 20000; ++i) {
    const Shot s = shot(draw, [](Draw& d, const V& h) -> Shape<double> {
      switch (d.bits() % 5) {
        case 0:
          return Sphere<double>{h[0]};
        case 1:
          return Capsule<double>{h[0], h[2]};
        case 2:
          return Cylinder<double>{h[0], h[2]};
        case 3:
          return Cone<double>{h[0], h[2]};
        default:
          return Ellipsoid<double>{h};
      }
    });
    CastOptions<double> options;
    if (draw.bits() % 4 == 0) options.t_max = kInfinity<double>;
    const double speed = (s.point.displacement - s.body.displacement).norm();
    const double scale = (s.point.position - s.body.position).norm() + 8;
    const CastResult<double> quick = cast_by(Tier::standard, s.body, s.point, options);
    const CastResult<double> sure = cast_by(Tier::certified, s.body, s.point, options);
    if (sure.outcome == Outcome::not_converged) continue;
    if (quick.outcome != sure.outcome) {
      // A tie: the standard tier is on the other side by no more than its limit. The search says the same of its own.
      ASSERT_NE(quick.outcome, Outcome::not_converged) << i;
      if (sure.outcome == Outcome::hit) {
        // Or it starts beside the surface, and meets it later.
        ASSERT_TRUE(sure.toi_lower * speed < 256 * kU * scale || quick.outcome == Outcome::miss ||
                    distance(s.body, s.point).lower < 256 * kU * scale)
            << i;
      }
      ++ties;
      continue;
    }
    hits += sure.outcome == Outcome::hit;
    misses += sure.outcome == Outcome::miss;
    starts += sure.outcome == Outcome::initially_overlapping;
    if (sure.outcome != Outcome::hit) continue;
    ASSERT_LE(sure.toi_lower, sure.toi_upper);
    // At a flat angle a depth within the limit is a longer way.
    const double flat = std::max(-sure.normal.dot(s.point.displacement - s.body.displacement) / speed *
                                     (s.body.shape.index() == 0 ? -1 : 1),
                                 1e-6);
    ASSERT_LE(std::abs(quick.toi_lower - sure.toi_lower) * speed * flat * flat, 1e-11 * scale) << i;
    options.start_policy = StartPolicy::pass_over;
    const CastResult<double> search = cast_by(Tier::certified, s.body, s.point, options);
    if (search.outcome != Outcome::hit) continue;
    ASSERT_LE(sure.toi_lower, search.toi_upper) << i;
    ASSERT_LE(search.toi_lower, sure.toi_upper) << i;
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(misses, 3000);
  EXPECT_GT(starts, 500);
  EXPECT_LT(ties, 400);
}

}  // namespace
}  // namespace graze
