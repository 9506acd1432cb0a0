#include <gtest/gtest.h>

#include <graze/rotating_cast.hpp>

namespace graze {
namespace {

RotatingBody<double> box_at(const Vec3<double>& position,
                            const Vec3<double>& displacement = Vec3<double>::Zero(),
                            const Vec3<double>& rotation = Vec3<double>::Zero()) {
  return {.body = {.shape = Box<double>{{1, 1, 1}}, .position = position, .displacement = displacement},
          .rotation = rotation};
}

struct Expected {
  const char* name;
  RotatingBody<double> a, b;
  Effects effects;
  PlanReason reason;
};

std::vector<Expected> scenes() {
  const auto still = box_at({0, 0, 0});
  RotatingBody<double> ball{
      .body = {.shape = Sphere<double>{1}, .position = {3, 0, 0}, .displacement = {-2, 0, 0}},
      .rotation = {5, 6, 7}};
  RotatingBody<double> off_centre = ball;
  off_centre.pivot = {0.25, 0, 0};
  RotatingBody<double> wheel = ball;
  wheel.body.shape = Cylinder<double>{1, 0.25};
  wheel.rotation = {0, 0, 300};
  RotatingBody<double> slow = box_at({3, 0, 0}, {-2, 0, 0}, {0, 1e-7, 0});
  return {
      {"both at rest", still, box_at({3, 0, 0}), Effects::at_rest, PlanReason::nothing_moves},
      {"moving alike", box_at({0, 0, 0}, {1, 2, 3}), box_at({3, 0, 0}, {1, 2, 3}), Effects::at_rest,
       PlanReason::nothing_moves},
      {"sliding", still, box_at({3, 0, 0}, {-2, 0, 0}), Effects::linear, PlanReason::no_rotation},
      {"a ball about its centre", still, ball, Effects::linear, PlanReason::unseen_spin_b},
      {"a ball about another point", still, off_centre, Effects::rotating, PlanReason::rotation_b},
      {"a wheel about its axis", wheel, still, Effects::linear, PlanReason::unseen_spin_a},
      {"as one", box_at({0, 0, 0}, {1, 0, 0}, {0, 0, 9}), box_at({0, 0, 2.5}, {1, 0, 0}, {0, 0, 9}),
       Effects::at_rest, PlanReason::as_one},
      {"alike, but side by side", box_at({0, 0, 0}, {1, 0, 0}, {0, 0, 9}),
       box_at({2.5, 0, 0}, {1, 0, 0}, {0, 0, 9}), Effects::rotating, PlanReason::rotation_a},
      {"far apart", box_at({0, 0, 0}, {0, 0, 0}, {1, 2, 3}), box_at({9, 0, 0}, {-2, 0, 0}, {3, 2, 1}),
       Effects::nothing, PlanReason::bounds_never_meet},
      {"slow", still, slow, Effects::rotating, PlanReason::rotation_b},
      {"turning", still, box_at({3, 0, 0}, {-2, 0, 0}, {0, 1, 0}), Effects::rotating, PlanReason::rotation_b},
  };
}

RotatingOptions<double> asked() {
  RotatingOptions<double> out;
  out.tolerance = 1e-6;
  out.request = Request::verdict;
  return out;
}

TEST(Plan, SaysWhatItSparesAndWhy) {
  for (const Expected& scene : scenes()) {
    const Plan seen = plan(scene.a, scene.b, asked());
    EXPECT_EQ(seen.effects, scene.effects) << scene.name << ": " << to_text(seen.effects);
    EXPECT_TRUE(seen.has(scene.reason)) << scene.name;
    EXPECT_EQ(cast(scene.a, scene.b, asked()).plan.effects, scene.effects);
  }
}

// Counters: nothing was placed in time where nothing turns, and nothing at all was asked where bounds never
// meet.
TEST(Plan, RunsNoRotatingCodeWhereNothingTurns) {
  for (const Expected& scene : scenes()) {
    const auto r = cast(scene.a, scene.b, asked());
    if (scene.effects == Effects::rotating) {
      EXPECT_GT(r.counters.poses, 0) << scene.name;
    } else {
      EXPECT_EQ(r.counters.poses, 0) << scene.name;
    }
    if (scene.effects == Effects::nothing) {
      EXPECT_EQ(r.counters.supports, 0) << scene.name;
    }
  }
}

// Each economy alone off, and none at all: the same verdict, and brackets that meet.
TEST(Plan, ChangesNoVerdict) {
  for (const Expected& scene : scenes()) {
    const auto with_all = cast(scene.a, scene.b, asked());
    for (int without = 0; without < 5; ++without) {
      auto options = asked();
      options.economies.at_rest = without != 0 && without != 4;
      options.economies.unseen_spin = without != 1 && without != 4;
      options.economies.as_one = without != 2 && without != 4;
      options.economies.bounds = without != 3 && without != 4;
      const auto r = cast(scene.a, scene.b, options);
      ASSERT_EQ(r.outcome, with_all.outcome) << scene.name << " without " << without;
      if (r.outcome != Outcome::hit) continue;
      const double slack = 1e-11;  // standard brackets are true of shapes within the noise
      EXPECT_LE(r.toi_lower, with_all.toi_upper + slack) << scene.name;
      EXPECT_GE(r.toi_upper, with_all.toi_lower - slack) << scene.name;
    }
  }
}

// The certified tier omits only motion that is exactly zero.
TEST(Plan, CertifiedLeavesNoTurnAway) {
  auto options = asked();
  options.tier = Tier::certified;
  options.tolerance = 0;
  auto slow = box_at({3, 0, 0}, {-2, 0, 0}, {0, 1e-12, 0});
  const auto r = cast(box_at({0, 0, 0}), slow, options);
  EXPECT_EQ(r.plan.effects, Effects::rotating);
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_LE(r.toi_lower, 0.5);
  EXPECT_GE(r.toi_upper, 0.5 - 1e-12);
}

TEST(Plan, EveryReasonPrints) {
  for (int k = 0; k < kPlanReasons; ++k) EXPECT_FALSE(to_text(static_cast<PlanReason>(k)).empty());
  for (const Effects effects : {Effects::nothing, Effects::at_rest, Effects::linear, Effects::rotating})
    EXPECT_FALSE(to_text(effects).empty());
}

}  // namespace
}  // namespace graze
