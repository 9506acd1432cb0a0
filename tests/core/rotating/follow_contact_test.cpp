// The start policy pass_over with a visible rotation: what becomes of a contact that is there at the start.
#include <gtest/gtest.h>

#include <cmath>
#include <graze/detail/numeric/offset.hpp>
#include <graze/detail/shapes/shape_tree.hpp>
#include <graze/rotating_cast.hpp>

namespace graze {
namespace {

// The most supports that a cast needs (docs/reference/guarantees.md).
constexpr int kMostSupports = 1024;

// Lengths in metres. A floor whose top is z = 0, and a crate that stands on it, unless turned by `tilt` and moved.
template <class S>
struct Scene {
  using V = Vec3<S>;
  RotatingBody<S> floor{.body = {.shape = Box<S>{V(8, 8, 1)}, .position = V(0, 0, -1)}};
  RotatingBody<S> crate{
      .body = {.shape = Box<S>{V(S(0.5), S(0.25), S(0.125))}, .position = V(0, 0, S(0.125))}};

  void move(const V& by) {
    floor.body.position += by;
    crate.body.position += by;
  }
  // By the integer quaternion q, whose rotation has rational entries.
  void tilt(const Quaternion<S>& q) {
    const Mat3<double> turn = detail::rotation_matrix(detail::as_double(q));
    const auto turned = [&](V& x) { x = (turn * x.template cast<double>()).template cast<S>(); };
    for (RotatingBody<S>* body : {&floor, &crate}) {
      turned(body->body.position);
      turned(body->body.displacement);
      turned(body->rotation);
      body->body.orientation = q;
    }
  }
  [[nodiscard]] RotatingResult<S> cast_in(Tier tier, S tolerance = 0) const {
    RotatingOptions<S> options;
    options.tier = tier;
    options.start_policy = StartPolicy::pass_over;
    options.tolerance = tolerance;
    RotatingResult<S> out = cast(floor, crate, options);
    EXPECT_LE(out.counters.supports, kMostSupports);
    return out;
  }
};

template <class S>
void expect_passed_over(const RotatingResult<S>& found) {
  EXPECT_EQ(found.outcome, Outcome::miss);
  EXPECT_TRUE(found.passed_over);
}

// Between the two times, and with what a hit has.
template <class S>
void expect_hit(const RotatingResult<S>& found, double earliest, double latest) {
  ASSERT_EQ(found.outcome, Outcome::hit);
  EXPECT_FALSE(found.passed_over);
  EXPECT_GE(double(found.toi_upper), earliest);
  EXPECT_LE(double(found.toi_lower), latest);
  EXPECT_LE(found.toi_lower, found.toi_upper);
  EXPECT_NEAR(double(found.normal.norm()), 1, 1e-6);
  EXPECT_LE(double((found.point_a - found.point_b).norm()), 1e-5);
}

template <class S>
class FollowContact : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(FollowContact, Scalars);

constexpr Tier kTiers[] = {Tier::standard, Tier::certified};

TYPED_TEST(FollowContact, ABoxThatRestsAndYawsIsAMiss) {
  using S = TypeParam;
  for (const S angle : {S(0.01), S(2), S(500)}) {
    Scene<S> scene;
    scene.crate.rotation = {0, 0, angle};
    for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier));
    scene.crate.body.displacement = {1, 0, 0};
    for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier));
    scene.move({1000, -500, 250});
    for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier));
  }
}

// In a tilted frame the numbers of the scene are rounded: in float the start may be apart by as much, which tier certified
// must not take for contact.
TYPED_TEST(FollowContact, SoDoesOneInATiltedFrame) {
  using S = TypeParam;
  for (const Quaternion<S>& q :
       {Quaternion<S>{1, 2, 2, 4}, Quaternion<S>{3, -1, 2, 1}, Quaternion<S>{2, 1, 0, 0}}) {
    Scene<S> scene;
    scene.crate.rotation = {0, 0, 2};
    scene.crate.body.displacement = {1, S(0.5), 0};
    scene.tilt(q);
    expect_passed_over(scene.cast_in(Tier::standard));
  }
}

TYPED_TEST(FollowContact, ABoxThatTipsIntoTheFloorIsAHitAtOnce) {
  using S = TypeParam;
  for (const bool tilted : {false, true}) {
    Scene<S> scene;
    scene.crate.rotation = {0, 1, 0};
    if (tilted) scene.tilt({1, 2, 2, 4});
    const RotatingResult<S> found = scene.cast_in(Tier::standard);
    // The far corner goes down by 1/2 a unit of t. kappa u scale is 23 metres times 4,096 u, in float 64 u.
    const double deep = 23 * (sizeof(S) == 4 ? 64 * 0x1p-24 : 4096 * 0x1p-53);
    expect_hit(found, 0, 2.1 * deep);
    EXPECT_GT(found.toi_upper, 0);
  }
}

// About an edge on the floor the crate lifts off with all its other points. It lands on its end after a
// quarter of a rotation less the angle of the diagonal. Here it has landed on the adjacent face when the
// edge's other face is down.
TYPED_TEST(FollowContact, ABoxThatTipsAboutItsEdgeIsAHitWhereTheNextFaceLands) {
  using S = TypeParam;
  const double quarter = std::acos(-1.0) / 2;
  for (const bool tilted : {false, true}) {
    Scene<S> scene;
    scene.crate.pivot = {S(0.5), 0, S(-0.125)};
    scene.crate.rotation = {0, S(1.5), 0};
    Scene<S> on = scene;
    on.crate.rotation = {0, 3, 0};
    if (tilted) {
      scene.tilt({1, 2, 2, 4});
      on.tilt({1, 2, 2, 4});
    }
    expect_passed_over(scene.cast_in(Tier::standard));
    const double rounding = sizeof(S) == 4 ? 4e-4 : 1e-6;
    expect_hit(on.cast_in(Tier::standard), quarter / 3 - rounding, quarter / 3 + rounding);
  }
}

TYPED_TEST(FollowContact, ABoxThatLiftsAndLandsIsAHitWhereItLands) {
  using S = TypeParam;
  // It rises by v t and its corner, at (1/2, 1/8) of its middle, falls: the gap is v t + 1/8 - 1/2 sin w t - 1/8 cos w t.
  Scene<S> scene;
  scene.crate.body.displacement = {0, 0, S(0.75)};
  scene.crate.rotation = {0, S(1.25), 0};
  scene.crate.body.shape = Ellipsoid<S>{{S(0.5), S(0.25), S(0.125)}};
  const auto gap = [](double t) {
    return 0.125 + 0.75 * t - std::hypot(0.5 * std::sin(1.25 * t), 0.125 * std::cos(1.25 * t));
  };
  // It keeps off with this speed. A slower one comes back down.
  ASSERT_GT(gap(1), 0);
  for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier));
  scene.crate.body.displacement = {0, 0, S(0.25)};
  const auto lower = [](double t) {
    return 0.125 + 0.25 * t - std::hypot(0.5 * std::sin(1.25 * t), 0.125 * std::cos(1.25 * t));
  };
  double up = 0.01, down = 1;
  ASSERT_GT(lower(up), 0);
  ASSERT_LT(lower(down), 0);
  for (int i = 0; i < 60; ++i) (lower((up + down) / 2) > 0 ? up : down) = (up + down) / 2;
  for (const Tier tier : kTiers) {
    const RotatingResult<S> found = scene.cast_in(tier);
    expect_hit(found, up - 1e-8, up + (sizeof(S) == 4 ? 1e-4 : 1e-8));
    EXPECT_GT(double(found.toi_lower), up - (sizeof(S) == 4 ? 1e-3 : 1e-6));
  }
}

// The crate rotates about an axis within the table, so it rises on its right and comes down on its left.
// Lifted a little, it starts apart and does the same.
TYPED_TEST(FollowContact, ABoxThatLeavesIsAHitWhereItMeetsTheBodyAgain) {
  using S = TypeParam;
  Scene<S> scene;
  scene.floor.body.shape = Box<S>{Vec3<S>(1, 8, 1)};
  scene.crate.body.shape = Box<S>{{S(0.0625), S(0.25), S(0.125)}};
  scene.crate.body.position[0] = S(0.875);
  scene.crate.pivot = {S(-0.875), 0, S(-0.625)};
  scene.crate.rotation = {0, -3, 0};
  Scene<S> lifted = scene;
  const S height = sizeof(S) == 4 ? S(0x1p-12) : S(0x1p-30);
  lifted.crate.body.position[2] += height;
  lifted.crate.pivot[2] -= height;
  for (const Tier tier : kTiers) {
    const RotatingResult<S> apart = cast(lifted.floor, lifted.crate, RotatingOptions<S>{.tier = tier});
    ASSERT_EQ(apart.outcome, Outcome::hit);
    ASSERT_GT(double(apart.toi_lower), 0.25);
    expect_hit(scene.cast_in(tier), double(apart.toi_lower) - double(height),
               double(apart.toi_upper) + double(height));
  }
}

// Over the edge and on.
TYPED_TEST(FollowContact, ABoxThatSlidesOffTheFloorIsAMiss) {
  using S = TypeParam;
  Scene<S> scene;
  scene.crate.rotation = {0, 0, 2};
  scene.crate.body.displacement = {20, 0, 0};
  for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier));
}

TYPED_TEST(FollowContact, WheelsThatRollAndBodiesThatSpinOnTheirTipsAreMisses) {
  using S = TypeParam;
  Scene<S> scene;
  scene.crate.body = {.shape = Cylinder<S>{S(0.5), S(0.25)},
                      .position = {0, 0, S(0.5)},
                      .orientation = {1, 1, 0, 0},
                      .displacement = {1, 0, 0}};
  scene.crate.rotation = {0, 2, 0};
  expect_passed_over(scene.cast_in(Tier::standard));
  // Its turn about the floor's normal tilts it with a rotation vector that stands still: it gets deeper, of second order.
  scene.crate.rotation = {0, 2, S(0.25)};
  expect_hit(scene.cast_in(Tier::standard), 0, sizeof(S) == 4 ? 0.05 : 1e-4);
  scene.crate.body = {.shape = Ellipsoid<S>{{S(0.5), S(0.25), S(0.125)}}, .position = {0, 0, S(0.125)}};
  scene.crate.rotation = {0, 0, 5};
  for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier));
}

TYPED_TEST(FollowContact, TurnsOfBothBodiesAddUp) {
  using S = TypeParam;
  Scene<S> scene;
  scene.floor.rotation = {0, 0, 1};
  scene.crate.rotation = {0, 0, -2};
  for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier));
  // The crate tips about its edge while the floor turns beneath it.
  scene.crate.pivot = {S(0.5), 0, S(-0.125)};
  scene.crate.rotation = {0, 1, 0};
  for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier));
}

TYPED_TEST(FollowContact, ADeepStartIsReportedAndOneApartIsCast) {
  using S = TypeParam;
  Scene<S> scene;
  scene.crate.rotation = {0, 0, 2};
  scene.crate.body.position[2] = S(0.1);
  for (const Tier tier : kTiers) EXPECT_EQ(scene.cast_in(tier).outcome, Outcome::initially_overlapping);
  scene.crate.body.position[2] = S(0.25);
  for (const Tier tier : kTiers) {
    const RotatingResult<S> above = scene.cast_in(tier);
    EXPECT_EQ(above.outcome, Outcome::miss);
    EXPECT_FALSE(above.passed_over);
  }
  scene.crate.body.displacement = {0, 0, -1};
  for (const Tier tier : kTiers) expect_hit(scene.cast_in(tier), 0.125 - 1e-7, 0.125 + 1e-7);
}

// A depth of a few roundings is followed, and is no hit.
TYPED_TEST(FollowContact, ADepthWithinRoundingIsFollowed) {
  using S = TypeParam;
  for (const int times : {1, 4, 16}) {
    Scene<S> scene;
    scene.crate.body.position[2] -= S(times) * 4 * kUnitRoundoff<S>;
    scene.crate.rotation = {0, 0, 2};
    expect_passed_over(scene.cast_in(Tier::standard));
  }
}

TYPED_TEST(FollowContact, AToleranceChangesNoVerdict) {
  using S = TypeParam;
  for (const S tolerance : {S(1e-6), S(1e-4), S(1e-3)}) {
    Scene<S> scene;
    scene.crate.rotation = {0, 0, 2};
    for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier, tolerance));
    scene.crate.rotation = {0, 1, 0};
    for (const Tier tier : kTiers) EXPECT_EQ(scene.cast_in(tier, tolerance).outcome, Outcome::hit);
    scene.crate.pivot = {S(0.5), 0, S(-0.125)};
    for (const Tier tier : kTiers) expect_passed_over(scene.cast_in(tier, tolerance));
  }
}

// Whatever the plan spares, and by either method that follows.
TEST(FollowContactPlan, EconomiesAndMethodsChangeNoVerdict) {
  Scene<double> yaws, tips, rolls;
  yaws.crate.rotation = {0, 0, 2};
  tips.crate.rotation = {0, 1, 0};
  rolls.crate.body = {.shape = Sphere<double>{0.5}, .position = {0, 0, 0.5}, .displacement = {1, 0, 0}};
  rolls.crate.rotation = {0, 2, 0};
  for (const Scene<double>* scene : {&yaws, &tips, &rolls}) {
    for (const auto& economies : {Economies{}, Economies::none()}) {
      for (const auto method :
           {std::optional<RotatingMethod>(), std::optional(RotatingMethod::bilateral_advancement),
            std::optional(RotatingMethod::conservative_advancement)}) {
        RotatingOptions<double> options;
        options.start_policy = StartPolicy::pass_over;
        options.economies = economies;
        options.method = method;
        const auto found = cast(scene->floor, scene->crate, options);
        EXPECT_EQ(found.outcome, scene == &tips ? Outcome::hit : Outcome::miss);
        EXPECT_EQ(found.passed_over, scene != &tips);
      }
    }
  }
}

// A budget that ends the search leaves it open, from a time up to which nothing got deeper.
TEST(FollowContactPlan, ABudgetLeavesTheAnswerOpen) {
  Scene<double> scene;
  scene.crate.pivot = {0.5, 0, -0.125};
  scene.crate.rotation = {0, 3, 0};
  const double lands = std::acos(-1.0) / 6;
  for (int budget = 1; budget < 400; budget += 7) {
    RotatingOptions<double> options;
    options.start_policy = StartPolicy::pass_over;
    options.max_iterations = budget;
    const auto found = cast(scene.floor, scene.crate, options);
    EXPECT_TRUE(found.outcome == Outcome::not_converged || found.outcome == Outcome::hit);
    EXPECT_LE(found.toi_lower, lands + 1e-9);
    EXPECT_GE(found.toi_upper, lands - 1e-9);
  }
}

}  // namespace
}  // namespace graze
