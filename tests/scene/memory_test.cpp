// The entries that a memory keeps from step to step, and a memory of an unrelated scene. The law
// (scene_law.cpp) tests the rest.
#include <gtest/gtest.h>
#include <graze/scene/memory.hpp>

#include "properties/scenes/generate.hpp"
#include "properties/scenes/law.hpp"

namespace graze::scene {
namespace {

Member box(std::string name, const Vec3<double>& position,
           const Vec3<double>& displacement = Vec3<double>::Zero()) {
  Member out;
  out.name = std::move(name);
  out.body.body = {.shape = Box<double>{{0.5, 0.5, 0.5}}, .position = position, .displacement = displacement};
  return out;
}

TEST(Memory, BodiesThatRestAsTheyDidAreNotCastAgain) {
  Scene scene{{box("a", {0, 0, 0}), box("b", {1, 0, 0}), box("c", {0.5, 1.0000000001, 0})}, {}};
  Options options;
  options.tier = Tier::exact;
  Memory memory;
  EXPECT_EQ(run(scene, options, memory).counts.simulated(), 3u);
  const Report again = run(scene, options, memory);
  EXPECT_EQ(again.counts.kept, 3u);
  EXPECT_EQ(again.counts.simulated(), 0u);
  ASSERT_EQ(again.events.size(), 1u);
  EXPECT_EQ(again.events[0].b, 1u);

  scene.bodies[1].body.body.position[0] = std::nextafter(1.0, 2.0);
  const Report moved = run(scene, options, memory);
  EXPECT_EQ(moved.counts.kept, 1u);  // a and c
  EXPECT_TRUE(moved.events.empty());
}

TEST(Memory, AMissIsKnownByItsAxisAndAContactByItsPoints) {
  // One slides along a corner of the still one. The third is in it, and moves with it.
  Scene scene{{box("still", {0, 0, 0}), box("past", {-0.75, 1.1, 0}, {0, 0, 0.05}),
               box("in", {-0.7, 1.2, 0.2}, {0, 0, 0.06})},
              {}};
  scene.bodies[0].body.body.orientation = {0.92387953251128674, 0, 0,
                                           0.38268343236508978};  // an eighth of a turn
  Options options;
  options.tier = Tier::certified;
  options.t_max = 0.125;
  Memory memory;
  EXPECT_EQ(run(scene, options, memory).counts.simulated(), 3u);
  std::uint64_t casts = 0;
  for (int step = 1; step < 10; ++step) {
    scene = at_time(scene, options.t_max);
    const Report report = run(scene, options, memory);
    casts += report.counts.simulated();
    ASSERT_EQ(report.events.size(), 1u);
    EXPECT_EQ(report.events[0].outcome, Outcome::initially_overlapping);
    EXPECT_GT(report.counters.supports, 0);
  }
  EXPECT_EQ(casts, 0u);
}

TEST(Memory, ATurnThatNobodySeesPartsAsIfThereWereNone) {
  // A capsule spins about its axis beside a box, as near as a tenth of its length, and a ball about its centre.
  Scene scene{{box("still", {0, 0, 0}), box("capsule", {0.75, 0, 0}, {0, 0, 0.05}),
               box("ball", {-0.75, 0, 0}, {0, 0.1, 0})},
              {}};
  scene.bodies[1].body.body.shape = Capsule<double>{0.2, 1};
  scene.bodies[1].body.rotation = {0, 0, 300};
  scene.bodies[2].body.body.shape = Sphere<double>{0.2};
  scene.bodies[2].body.rotation = {100, 200, 300};
  Options options;
  options.economies = options.economies.without(Economy::bounds);
  options.t_max = 0.125;  // 37 radians a step
  Memory memory;
  EXPECT_TRUE(run(scene, options, memory).events.empty());
  for (int step = 1; step < 10; ++step) {
    scene = at_time(scene, options.t_max);
    const Report report = run(scene, options, memory);
    EXPECT_EQ(report.counts.simulated(), 0u);
    EXPECT_EQ(report.counts.parted, 3u);
    EXPECT_TRUE(report.events.empty());
  }
}

TEST(Memory, ABodyThatTurnsMuchIsInContactByItsPoints) {
  // A bar spins about its long axis, a pivot at its far end, in a box that it goes through.
  Scene scene{{box("still", {0, 0, 0}), box("bar", {0.07, 0.03, 0.25})}, {}};
  scene.bodies[1].body.body.shape = Box<double>{{0.1, 0.1, 2}};
  scene.bodies[1].body.pivot = {0, 0, -2};
  scene.bodies[1].body.rotation = {0, 0, 100};
  Options options;
  options.t_max = 0.125;
  Memory memory;
  EXPECT_EQ(run(scene, options, memory).counts.simulated(), 1u);
  for (int step = 1; step < 10; ++step) {
    scene = at_time(scene, options.t_max);
    const Report report = run(scene, options, memory);
    EXPECT_EQ(report.counts.held, 1u);
    ASSERT_EQ(report.events.size(), 1u);
    EXPECT_EQ(report.events[0].outcome, Outcome::initially_overlapping);
  }
}

TEST(Memory, IsTheSameInAnyNumberOfThreadsAndAfterAnInterruption) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const law::RandomScene drawn = law::random_scene(seed);
    Options options = drawn.options;
    Memory one, four;
    for (int step = 0; step < 3; ++step) {
      const Scene now = at_time(drawn.scene, 0.1 * step);
      options.threads = 1;
      const Report single = run(now, options, one);
      options.threads = 4;
      options.progress = [](std::uint64_t done, std::uint64_t) { return done > 0; };
      if (step == 1) {
        EXPECT_NE(run(now, options, four).status, Status::invalid);  // stops at once
      }
      options.progress = {};
      const Report many = run(now, options, four);
      ASSERT_EQ(single.events.size(), many.events.size()) << "scene " << seed;
      for (std::size_t k = 0; k < many.events.size(); ++k) {
        EXPECT_EQ(single.events[k].toi_lower, many.events[k].toi_lower);
        EXPECT_EQ(single.events[k].a, many.events[k].a);
        EXPECT_EQ(single.events[k].b, many.events[k].b);
      }
      if (step == 0) {
        EXPECT_EQ(one.pairs(), four.pairs()) << "scene " << seed;
        EXPECT_EQ(single.counters.supports, many.counters.supports);
      }
    }
  }
}

TEST(Memory, OfLargerBodiesThanTheSceneHasIsHarmless) {
  Scene large;
  for (int k = 0; k < 40; ++k) large.bodies.push_back(box("", {0.4 * k, 0, 0}, {0, 0.1 * k, 0}));
  Memory memory;
  EXPECT_TRUE(run(large, {}, memory).wrong.empty());
  EXPECT_GT(memory.pairs(), 20u);
  EXPECT_GT(memory.bytes(), 40 * memory.pairs());
  Scene small{{box("a", {0, 0, 0}), box("b", {0.5, 0, 0})}, {}};
  small.bodies[1].body.body.shape = Point<double>{};
  const Report report = run(small, {}, memory);
  ASSERT_EQ(report.events.size(), 1u);
  EXPECT_LE(memory.pairs(), 1u);
}

TEST(AtTime, ABodyTurnsAboutItsPivotAndGoesItsWay) {
  Scene scene{{box("a", {1, 2, 3})}, {}};
  RotatingBody<double>& body = scene.bodies[0].body;
  body.body.displacement = {4, 0, 0};
  body.body.orientation = {2, 0, 0, 0};
  body.rotation = {0, 0, std::acos(-1.0)};
  body.pivot = {1, 0, 0};
  const Body<double> later = at_time(scene, 0.5).bodies[0].body.body;
  // A quarter of a turn about (2, 2, 3), which has gone on by 2.
  EXPECT_NEAR((later.position - Vec3<double>(4, 1, 3)).norm(), 0, 1e-14);
  EXPECT_NEAR(later.orientation.w, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(later.orientation.z, std::sqrt(0.5), 1e-15);
  const Scene still{{box("b", {0.1, 0.2, 0.3})}, {}};
  EXPECT_EQ(at_time(still, 0.7).bodies[0].body.body.position, still.bodies[0].body.body.position);
}

}  // namespace
}  // namespace graze::scene
