// The exact cast of a point at an ellipsoid, a cylinder or a cone: ties that are known by hand, thin solids beside the
// segments and points that they are, and closed forms in rational numbers. Every proof is checked, and refused with an end
// moved.
#include <gtest/gtest.h>

#include <cmath>
#include <graze/cast.hpp>

#include "corpus/format/case_io.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/truth/closed_form.hpp"
#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

// Each component of a normal is within 2 u of itself (exact_answer.hpp), and norm() rounds by 2 u.
constexpr double kLength = 4 * kUnitRoundoff<double>;

Body<double> point(const V& at, const V& way) {
  return {.shape = Point<double>{}, .position = at, .displacement = way};
}
CastOptions<double> everything(double t_max = 1) {
  CastOptions<double> options;
  options.tier = Tier::exact;
  options.request = Request::everything;
  options.t_max = t_max;
  return options;
}
corpus::Case question(const Body<double>& a, const Body<double>& b, double t_max) {
  corpus::Case out;
  out.a = a;
  out.b = b;
  out.t_max = t_max;
  return out;
}

// The proof holds, and says no more than the truth: with either end moved, or as the other verdict, it is refused.
void expect_proof(const corpus::Case& problem, const CastResult<double>& r) {
  ASSERT_TRUE(r.proof) << corpus::write_case(problem);
  const auto accepted = [&](double lower, double upper) {
    Proof claim = *r.proof;
    claim.toi_lower = lower;
    claim.toi_upper = upper;
    return oracle::check_proof(problem, claim).accepted();
  };
  const double lower = r.proof->toi_lower, upper = r.proof->toi_upper, never = kInfinity<double>;
  EXPECT_TRUE(accepted(lower, upper)) << corpus::write_case(problem);
  if (r.outcome == Outcome::miss) {
    EXPECT_EQ(lower, never);
    EXPECT_FALSE(accepted(0, std::min(problem.t_max, 1e300)));
    return;
  }
  EXPECT_FALSE(accepted(never, never)) << corpus::write_case(problem);
  if (r.outcome != Outcome::hit) return;
  EXPECT_FALSE(accepted(lower == upper ? std::nextafter(upper, never) : upper, upper));
  EXPECT_FALSE(accepted(lower, lower == upper ? std::nextafter(lower, 0.0) : lower));
}

struct Known {
  const char* what;
  Shape<double> shape;
  V from, way;
  double t;  // infinite: a miss. 0: contact at the start
  V normal;  // if it is the only one
  bool leaves = false;
};

TEST(SolidRay, DecidesTiesThatAreKnownByHand) {
  const double never = kInfinity<double>, more = std::nextafter(1.0, 2.0);
  const Ellipsoid<double> egg{{1, 2, 4}};
  const Cylinder<double> can{5, 2};
  const Cone<double> hat{2, 2};  // apex (0, 0, 2), x^2 + y^2 = ((2 - z) / 2)^2
  const Known all[] = {
      {"a tangent at the pole", egg, {3, 2, 0}, {-4, 0, 0}, 0.75, {0, 1, 0}},
      {"a tangent past the pole", egg, {3, 2 * more, 0}, {-4, 0, 0}, never, {}},
      {"a start on the surface, inward", egg, {1, 0, 0}, {-1, 0, 0}, 0, {}},
      {"the same, along it", egg, {1, 0, 0}, {0, 1, 0}, 0, {}, true},
      {"the same, at rest", egg, {1, 0, 0}, {0, 0, 0}, 0, {}, true},
      {"at rest inside", egg, {0.5, 0, 0}, {0, 0, 0}, 0, {}},
      {"a side", can, {-9, 4, 1}, {12, 0, 0}, 0.5, {-0.6, 0.8, 0}},
      {"a tangent of the side", can, {3, 5, -1}, {-6, 0, 2}, 0.5, {0, 1, 0}},
      {"a tangent of the side, higher than the rim", can, {3, 5, 1}, {-6, 0, 4}, never, {}},
      {"the rim from above", can, {5, 0, 4}, {0, 0, -4}, 0.5, {0, 0, 1}},
      {"the rim across", can, {7, 0, 4}, {-4, 0, -4}, 0.5, {}},
      {"along the cap", can, {7, 0, 2}, {-4, 0, 0}, 0.5, {1, 0, 0}},
      {"above the cap", can, {7, 0, 2 * more}, {-4, 0, 0}, never, {}},
      {"on the cap, along it", can, {0, 0, 2}, {1, 0, 0}, 0, {}, true},
      {"on the rim, inward", can, {5, 0, 2}, {-1, 0, -1}, 0, {}},
      {"the apex from above", hat, {0, 0, 4}, {0, 0, -4}, 0.5, {}},
      {"the apex, level", hat, {1, 0, 2}, {-2, 0, 0}, 0.5, {}},
      {"past the apex, level", hat, {1, 0, 2 * more}, {-2, 0, 0}, never, {}},
      {"along a generator, upward to the apex and on", hat, {3, 0, -4}, {-2, 0, 4}, 0.5, {}},
      {"the base from below", hat, {1, 0, -4}, {0, 0, 4}, 0.5, {0, 0, -1}},
      {"the upper half of the double cone", hat, {1, 0, 5}, {0, 1, 0}, never, {}},
      {"from the upper half into the lower",
       hat,
       {0, 0.5, 5},
       {0, 0, -8},
       0.5,
       {0, 2 / std::sqrt(5.0), 1 / std::sqrt(5.0)}},
      {"on the apex, down the axis", hat, {0, 0, 2}, {0, 0, -1}, 0, {}},
      {"on the apex, along the side", hat, {0, 0, 2}, {1, 0, -2}, 0, {}, true},
      {"on the apex, upward", hat, {0, 0, 2}, {0, 0, 1}, 0, {}, true},
  };
  for (const Known& known : all) {
    const Body<double> solid{.shape = known.shape};
    for (const bool swapped : {false, true}) {
      const Body<double> ray = point(known.from, known.way), &a = swapped ? ray : solid,
                         &b = swapped ? solid : ray;
      CastOptions<double> options = everything();
      const CastResult<double> r = cast(a, b, options);
      expect_proof(question(a, b, 1), r);
      if (known.t == 0) {
        EXPECT_EQ(r.outcome, Outcome::initially_overlapping) << known.what;
        options.start_policy = StartPolicy::pass_over;
        const CastResult<double> over = cast(a, b, options);
        EXPECT_EQ(over.passed_over, known.leaves) << known.what;
        EXPECT_EQ(over.outcome, known.leaves ? Outcome::miss : Outcome::initially_overlapping) << known.what;
        corpus::Case passing = question(a, b, 1);
        passing.start_policy = StartPolicy::pass_over;
        EXPECT_EQ(oracle::ClosedForm::of(passing)->outcome(), over.outcome) << known.what;
        continue;
      }
      EXPECT_EQ(r.outcome, known.t < never ? Outcome::hit : Outcome::miss) << known.what;
      EXPECT_EQ(r.toi_lower, known.t) << known.what;
      EXPECT_EQ(r.toi_upper, known.t) << known.what;
      if (!(known.t < never)) continue;
      const V n = swapped ? V(-r.normal) : r.normal, at = known.from + known.t * known.way;
      EXPECT_NEAR(n.norm(), 1, kLength) << known.what;
      EXPECT_LE(n.dot(known.way), 0) << known.what;
      if (known.normal.norm() > 0) {
        EXPECT_LE((n - known.normal).norm(), 3e-16) << known.what;
      }
      EXPECT_LE((r.point_a - at).norm() + (r.point_b - at).norm(), 1e-15) << known.what;
      // At t_max itself, and one double before it.
      EXPECT_EQ(cast(a, b, everything(known.t)).outcome, Outcome::hit) << known.what;
      EXPECT_EQ(cast(a, b, everything(std::nextafter(known.t, 0.0))).outcome, Outcome::miss) << known.what;
    }
  }
}

// What has no thickness is met where the same set by another name is.
TEST(SolidRay, KnowsSolidsWithoutThickness) {
  const Segment<double> rod{{0, 0, -2}, {0, 0, 2}};
  const struct {
    Shape<double> thin, same;
  } pairs[] = {
      {Cylinder<double>{0, 2}, rod},
      {Cone<double>{0, 2}, rod},
      {Ellipsoid<double>{{0, 0, 2}}, rod},
      {Ellipsoid<double>{{2, 0, 0}}, Segment<double>{{-2, 0, 0}, {2, 0, 0}}},
      {Ellipsoid<double>{{0, 0, 0}}, Point<double>{}},
      {Cone<double>{2, 0}, Cylinder<double>{2, 0}},
      {Ellipsoid<double>{{2, 2, 0}}, Cylinder<double>{2, 0}},
  };
  Draw draw(5);
  int hits = 0;
  for (const auto& [thin, same] : pairs) {
    for (int k = 0; k < 400; ++k) {
      const auto integer = [&](int size) { return std::floor(draw.between(-size, size + 1)); };
      const V at(integer(2), integer(2), integer(2)), from = 2 * V(integer(2), integer(2), integer(2)),
                                                      way = 2 * (at - from);
      const Body<double> a{.shape = thin}, b{.shape = same}, ray = point(from, way);
      const CastResult<double> one = cast(a, ray, everything()), other = cast(b, ray, everything());
      EXPECT_EQ(one.outcome, other.outcome)
          << thin.index() << " " << from.transpose() << " to " << at.transpose();
      EXPECT_EQ(one.toi_lower, other.toi_lower);
      EXPECT_EQ(one.toi_upper, other.toi_upper);
      expect_proof(question(a, ray, 1), one);
      if (one.outcome != Outcome::hit) continue;
      ++hits;
      EXPECT_NEAR(one.normal.norm(), 1, kLength);
      EXPECT_LE(one.normal.dot(way), 0);
    }
  }
  EXPECT_GE(hits, 100);
}

template <class S>
Body<S> narrow(const Body<double>& body) {
  Body<S> out;
  const auto vec = [](const V& x) { return Vec3<S>(x.template cast<S>()); };
  if (const auto* e = std::get_if<Ellipsoid<double>>(&body.shape)) out.shape = Ellipsoid<S>{vec(e->radii)};
  if (const auto* c = std::get_if<Cylinder<double>>(&body.shape))
    out.shape = Cylinder<S>{S(c->radius), S(c->half_height)};
  if (const auto* c = std::get_if<Cone<double>>(&body.shape))
    out.shape = Cone<S>{S(c->radius), S(c->half_height)};
  out.position = vec(body.position);
  out.displacement = vec(body.displacement);
  const Quaternion<double>& q = body.orientation;
  out.orientation = {S(q.w), S(q.x), S(q.y), S(q.z)};
  return out;
}
Shape<double> draw_solid(Draw& draw, bool grid) {
  const auto size = [&] { return grid ? std::floor(draw.between(1, 6)) : std::exp2(draw.between(-4, 4)); };
  switch (static_cast<int>(draw.between(0, 3))) {
    case 0:
      return Ellipsoid<double>{{size(), size(), size()}};
    case 1:
      return Cylinder<double>{size(), size()};
    default:
      return Cone<double>{size(), size()};
  }
}

// On a grid, where ties are common, and off it. At the origin, and a million lengths out.
TEST(SolidRay, IsWhatTheClosedFormSaysToTheLastBit) {
  Draw draw(11);
  int hits = 0, starts = 0, rational = 0, near_ties = 0;
  for (int k = 0; k < 6000; ++k) {
    const bool grid = k % 2 == 0;
    const auto number = [&](double size) {
      return grid ? std::floor(draw.between(-size, size + 1)) : draw.between(-size, size);
    };
    const V far = k % 8 < 2 ? V(number(1e6), number(1e6), number(1e6)) : V(0, 0, 0);
    Body<double> solid{.shape = draw_solid(draw, grid)};
    solid.position = far + V(number(6), number(6), number(6));
    solid.displacement = V(number(4), number(4), number(4));
    if (k % 3 > 0) solid.orientation = {number(3) + 4, number(3), number(3), number(3)};
    const V aim = solid.position + V(number(4), number(4), number(4)),
            from = far + V(number(9), number(9), number(9));
    const Body<double> ray = point(from, solid.displacement + 2 * (aim - from));
    const auto ask = [&]<class S>(S) {
      const Body<S> s = narrow<S>(solid), p = narrow<S>(ray);
      Body<double> wide_s = solid, wide_p = ray;
      // As S has them.
      wide_s.position = s.position.template cast<double>();
      wide_s.displacement = s.displacement.template cast<double>();
      wide_s.orientation = {s.orientation.w, s.orientation.x, s.orientation.y, s.orientation.z};
      std::visit(
          [&]<class T>(T& shape) {
            if constexpr (requires { shape.radii; }) {
              shape.radii = shape.radii.template cast<S>().template cast<double>();
            } else if constexpr (requires { shape.half_height; }) {
              shape.radius = S(shape.radius);
              shape.half_height = S(shape.half_height);
            }
          },
          wide_s.shape);
      wide_p.position = p.position.template cast<double>();
      wide_p.displacement = p.displacement.template cast<double>();
      const corpus::Case problem = question(wide_s, wide_p, 1);
      const auto truth = oracle::ClosedForm::of(problem);
      ASSERT_TRUE(truth);
      CastOptions<S> options;
      options.tier = Tier::exact;
      options.request = Request::everything;
      const CastResult<S> r = cast(s, p, options);
      ASSERT_EQ(r.outcome, truth->outcome()) << corpus::write_case(problem);
      near_ties += r.counters.exact_decisions > 0;
      starts += r.outcome == Outcome::initially_overlapping;
      if constexpr (std::same_as<S, double>) expect_proof(problem, r);
      if (r.outcome != Outcome::hit) return;
      ++hits;
      const S lower = static_cast<S>(truth->toi_lower()), upper = static_cast<S>(truth->toi_upper());
      EXPECT_EQ(r.toi_lower,
                double(lower) > truth->toi_lower() ? std::nextafter(lower, -kInfinity<S>) : lower);
      EXPECT_EQ(r.toi_upper,
                double(upper) < truth->toi_upper() ? std::nextafter(upper, kInfinity<S>) : upper);
      rational += r.toi_lower == r.toi_upper;
    };
    ask(double{});
    ask(float{});
  }
  EXPECT_GE(hits, 1500);
  EXPECT_GE(starts, 200);
  EXPECT_GE(rational, 20);
  EXPECT_GE(near_ties, 20);
  EXPECT_LE(near_ties, 3000);
}

// The numbers of the answer leave the range of doubles in between, or nearly.
TEST(SolidRay, SpansTheRangeOfNumbers) {
  for (const double size : {1e-58, 1e-30, 1e30, 1e58}) {
    for (const double speed : {1e-56, 1.0, 1e58}) {
      const Body<double> solid{.shape = Ellipsoid<double>{{size, size / 2, size}},
                               .orientation = {1, 2, 3, 4}};
      const Body<double> ray = point({3 * size, 0, 0}, {-speed, speed / 64, 0});
      const corpus::Case problem = question(solid, ray, kInfinity<double>);
      const auto truth = oracle::ClosedForm::of(problem);
      const CastResult<double> r = cast(solid, ray, everything(kInfinity<double>));
      ASSERT_EQ(r.outcome, truth->outcome()) << size << " " << speed;
      EXPECT_EQ(r.toi_lower, truth->toi_lower());
      EXPECT_EQ(r.toi_upper, truth->toi_upper());
      expect_proof(problem, r);
    }
  }
}

}  // namespace
}  // namespace graze
