// The answers of a scene, its refusals, and the work that it leaves undone.
#include <gtest/gtest.h>
#include <graze/cast_all.hpp>
#include <graze/scene.hpp>

#include <bit>
#include <limits>

#include "corpus/random.hpp"
#include "properties/scenes/generate.hpp"

namespace graze::scene {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Member box(std::string name, const Vec3<double>& position,
           const Vec3<double>& displacement = Vec3<double>::Zero()) {
  Member out;
  out.name = std::move(name);
  out.body.body = {.shape = Box<double>{{0.5, 0.5, 0.5}}, .position = position, .displacement = displacement};
  return out;
}

std::vector<std::string> pairs_of(const Scene& scene, const Report& report) {
  std::vector<std::string> out;
  for (const Event& event : report.events) {
    out.push_back(scene.bodies[event.a].name + " " + scene.bodies[event.b].name);
  }
  return out;
}

TEST(Scene, EventsComeInTheOrderOfTimeAndOfNamesAtOneTime) {
  // Two reach the wall at t = 1/2, one at 1/4.
  const Scene scene{{box("wall", {0, 0, 0}), box("z", {3, 0, 0}, {-4, 0, 0}), box("b", {0, 3, 0}, {0, -4, 0}),
                     box("early", {0, 0, 3}, {0, 0, -8})},
                    {}};
  Options options;
  options.t_max = 0.5;
  const Report report = run(scene, options);
  ASSERT_EQ(report.status, Status::complete) << report.wrong;
  EXPECT_EQ(pairs_of(scene, report).front(), "wall early");
  EXPECT_EQ(report.events.front().toi_lower, 0.25);
  const std::vector<std::string> all = pairs_of(scene, report);
  const auto place = [&](const char* pair) { return std::find(all.begin(), all.end(), pair) - all.begin(); };
  EXPECT_LT(place("wall b"), place("wall z"));  // though z has the lower index
  EXPECT_LT(place("wall z"), static_cast<std::ptrdiff_t>(all.size()));
}

TEST(Scene, WhatIsAskedBoundsWhatIsStarted) {
  Scene scene;
  scene.bodies.push_back(box("wall", {0, 0, 0}));
  for (int k = 0; k < 50; ++k) {
    scene.bodies.push_back(box("body " + std::to_string(k), {2.0 + 2 * k, 0, 0}, {-120, 0, 0}));
  }
  Options options;
  options.ask = Ask::first;
  const Report first = run(scene, options);
  ASSERT_EQ(first.events.size(), 1u);
  EXPECT_EQ(pairs_of(scene, first)[0], "wall body 0");
  EXPECT_GT(first.counts.moot, 20u);
  options.ask = Ask::pair;
  EXPECT_EQ(run(scene, options).events.size(), 50u);
  options.ask = Ask::verdict;
  EXPECT_FALSE(run(scene, options).events.empty());
  options.ask = Ask::first;
  options.economies = options.economies.without(Economy::horizon);
  const Report all = run(scene, options);
  EXPECT_EQ(all.counts.moot, 0u);
  EXPECT_EQ(pairs_of(scene, all), pairs_of(scene, first));
}

TEST(Scene, BodiesOnADiagonalDoNotMeetAllThatTheBoxesOfTheirWaysHold) {
  // Bodies that fly one after the other along a diagonal: boxes at rest about their ways would meet n^2 / 2
  // times, moving ones never.
  Scene scene;
  for (int k = 0; k < 300; ++k) {
    const double at = 4.0 * k;
    scene.bodies.push_back(box("", {at, at, at}, {500, 500, 500}));
  }
  const Planned planned = plan(scene, {});
  ASSERT_TRUE(planned.wrong.empty()) << planned.wrong;
  EXPECT_EQ(planned.pairs.size(), 0u);
  EXPECT_EQ(planned.counts.never_meet, 300u * 299 / 2);
}

TEST(Scene, TwoAtRestThatTouchHaveOneStaticOverlap) {
  const Scene scene{{box("a", {0, 0, 0}), box("b", {1, 0, 0}), box("c", {5, 0, 0})}, {}};
  Options options;
  options.tier = Tier::exact;
  const Report report = run(scene, options);
  ASSERT_EQ(report.events.size(), 1u);
  EXPECT_EQ(report.events[0].outcome, Outcome::initially_overlapping);
  EXPECT_EQ(report.counts.effects[1], 1u);
  EXPECT_EQ(report.counts.apart, 2u);
}

// One ball is at the target distance from the floor. Another slides in at that distance, and touches it at 7/16.
TEST(Scene, BallsAtATargetDistanceAreDecidedExactly) {
  Scene scene{{box("floor", {0, 0, 0}), box("ball", {0, 0, 1.25}), box("other", {0, 3, 1.25}, {0, -4, 0})},
              {}};
  for (const std::size_t k : {1u, 2u}) scene.bodies[k].body.body.shape = Sphere<double>{0.5};
  Options options;
  options.tier = Tier::exact;
  options.target_distance = 0.25;
  const Report report = run(scene, options);
  ASSERT_EQ(report.status, Status::complete) << report.wrong;
  ASSERT_EQ(report.events.size(), 3u);
  EXPECT_EQ(report.events[0].outcome, Outcome::initially_overlapping);
  for (const auto& [k, time] : {std::pair(1, 0.4375), std::pair(2, 0.625)}) {
    EXPECT_EQ(report.events[std::size_t(k)].outcome, Outcome::hit);
    EXPECT_EQ(report.events[std::size_t(k)].toi_lower, time);
    EXPECT_EQ(report.events[std::size_t(k)].toi_upper, time);
  }
}

TEST(Scene, ARaySeesTheFirstBodyOrAllOfThem) {
  Scene scene{{box("far", {9, 0, 0}), box("near", {3, 0, 0}, {0, 0, 100}), box("aside", {3, 8, 0})}, {}};
  scene.probes.push_back(ray("first", {0, 0, 0}, {1, 0, 0}));
  scene.probes.push_back(ray("all", {0, 0, 0}, {2, 0, 0}));
  scene.probes[1].first_only = false;
  scene.probes.push_back(ray("away", {0, 0, 0}, {-1, 0, 0}));
  const Report report = run(scene, {});
  ASSERT_EQ(report.probe_events.size(), 3u);
  EXPECT_EQ(report.probe_events[0].b, 1u);  // as it stands at t = 0
  EXPECT_NEAR(report.probe_events[0].toi_lower, 2.5, 1e-12);
  EXPECT_NEAR(report.probe_events[1].toi_lower, 1.25, 1e-12);
  EXPECT_EQ(report.probe_events[2].b, 0u);
}

// A probe that has not moved since the last step asks what it overlaps. It spoils no other answer.
TEST(Scene, AProbeAtRestIsAnsweredByWhatItOverlapsAtItsStart) {
  Scene scene{{box("inside", {0, 0, 0}), box("beside", {3, 0, 0}, {-9, 0, 0})}, {}};
  const double forever = kInfinity<double>;
  const auto at = [&](std::string name, Shape<double> shape, const Vec3<double>& position, double t_max) {
    Probe probe = ray(std::move(name), position, {0, 0, 0}, t_max);
    probe.body.body.shape = std::move(shape);
    scene.probes.push_back(std::move(probe));
  };
  at("a ray inside", Point<double>{}, {0.25, 0, 0}, forever);
  at("a ray on a face", Point<double>{}, {0.5, 0, 0}, forever);
  at("a ray outside", Point<double>{}, {1.5, 0, 0}, forever);
  at("a cast that touches both", Box<double>{{1, 1, 1}}, {1.5, 0, 0}, 1);
  at("a cast outside", Box<double>{{0.25, 1, 1}}, {1.5, 0, 0}, forever);
  at("no time", Point<double>{}, {0, 0, 0}, 0);
  scene.probes[3].first_only = false;
  scene.probes.push_back(ray("one that moves", {-2, 0, 0}, {1, 0, 0}));
  for (const Tier tier : {Tier::standard, Tier::certified, Tier::exact}) {
    for (const bool by_bounds : {true, false}) {
      Options options;
      options.tier = tier;
      if (!by_bounds) options.economies = options.economies.without(Economy::bounds);
      const Report report = run(scene, options);
      ASSERT_EQ(report.status, Status::complete) << report.wrong;
      std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
      for (const Event& event : report.probe_events) {
        found.emplace_back(event.a, event.b);
        if (event.a == 6) continue;
        EXPECT_EQ(event.outcome, Outcome::initially_overlapping);
        EXPECT_EQ(event.effects, Effects::at_rest);
        EXPECT_EQ(event.toi_lower, 0);
        EXPECT_EQ(event.toi_upper, 0);
      }
      const std::vector<std::pair<std::uint32_t, std::uint32_t>> expected = {{0, 0}, {1, 0}, {3, 1},
                                                                             {3, 0}, {5, 0}, {6, 0}};
      EXPECT_EQ(found, expected) << to_text(tier);
      EXPECT_EQ(report.probe_events.back().outcome, Outcome::hit);
    }
  }
}

// Two bodies that the exact tier knows, each by itself, and whose numbers together outgrow its room.
TEST(Scene, APairThatTheExactTierRefusesStaysOpen) {
  corpus::Random random(232);
  int refused = 0;
  for (int round = 0; round < 20; ++round) {
    Shape<double> nested = Box<double>{{1, 0.5, 0.25}};
    for (int level = 0; level < 13; ++level) {
      const auto number = [&] { return random.uniform(-1, 1); };
      const Vec3<double> by(number() / 8, number() / 8, number() / 8);
      nested = posed<double>(std::move(nested), by, {number(), number(), number(), number()});
    }
    Scene scene{{box("a", {0, 0, 0}), box("b", {0, 0, 0}, {1, 0, 0})}, {}};
    for (Member& member : scene.bodies) member.body.body.shape = nested;
    Options options;
    options.tier = Tier::exact;
    options.t_max = 2;
    const CastResult<double> alone = graze::cast(scene.bodies[0].body.body, scene.bodies[1].body.body,
                                                 {.tier = Tier::exact, .t_max = options.t_max});
    const Report report = run(scene, options);
    ASSERT_EQ(report.status, Status::complete) << report.wrong;
    ASSERT_EQ(report.events.size(), 1u);
    if (alone.outcome != Outcome::invalid_input) continue;
    ++refused;
    EXPECT_EQ(report.events[0].outcome, Outcome::not_converged);
    EXPECT_EQ(report.events[0].toi_lower, 0);
    EXPECT_EQ(report.events[0].toi_upper, 2);
  }
  EXPECT_GT(refused, 0);
}

struct Refused {
  const char* what;
  void (*spoil)(Scene&, Options&);
  const char* said;
};

TEST(Scene, ABadSceneIsRefusedInALineThatNamesTheBodyAndTheField) {
  const Refused cases[] = {
      {"a body named twice", [](Scene& s, Options&) { s.bodies[1].name = "one"; },
       "\"one\"; each needs its own"},
      {"NaN", [](Scene& s, Options&) { s.bodies[1].body.body.position[2] = kNan; },
       "body \"two\": position[2] is NaN or infinite"},
      {"a negative extent",
       [](Scene& s, Options&) {
         s.bodies[0].body.body.shape = Box<double>{{1, -1, 1}};
       },
       "body \"one\": shape.half_extents[1] is negative"},
      {"no orientation",
       [](Scene& s, Options&) {
         s.bodies[0].body.body.orientation = {0, 0, 0, 0};
       },
       "body \"one\": orientation is (0, 0, 0, 0)"},
      {"a rotation without bound", [](Scene& s, Options&) { s.bodies[0].body.rotation[0] = 1e12; },
       "body \"one\": rotation is a turn of more than 2^30 radians"},
      {"NaN in a rotation", [](Scene& s, Options&) { s.bodies[0].body.rotation[1] = kNan; },
       "body \"one\": rotation[1] is NaN"},
      {"two rays of one name",
       [](Scene& s, Options&) {
         s.probes.assign(2, ray("sight", {0, 0, 0}, {1, 0, 0}));
       },
       "have the same name, \"sight\""},
      {"a step without an end", [](Scene&, Options& o) { o.t_max = kInfinity<double>; }, "t_max of the step"},
      {"a negative target", [](Scene&, Options& o) { o.target_distance = -1; },
       "target_distance is negative"},
      {"a tolerance that is none", [](Scene&, Options& o) { o.tolerance = kNan; }, "tolerance is negative"},
      {"exact of a cylinder",
       [](Scene& s, Options& o) {
         o.tier = Tier::exact;
         s.bodies[0].body.body.shape = Cylinder<double>{1, 1};
       },
       "body \"one\": shape is curved"},
      {"exact of a turn",
       [](Scene& s, Options& o) {
         o.tier = Tier::exact;
         s.bodies[0].body.rotation[0] = 1;
       },
       "body \"one\": rotates"},
  };
  for (const Refused& one : cases) {
    Scene scene{{box("one", {0, 0, 0}), box("two", {4, 0, 0}, {-4, 0, 0})}, {}};
    Options options;
    EXPECT_EQ(why_invalid(scene, options), "");
    one.spoil(scene, options);
    const Report report = run(scene, options);
    EXPECT_EQ(report.status, Status::invalid) << one.what;
    EXPECT_NE(report.wrong.find(one.said), std::string::npos) << one.what << ": " << report.wrong;
    EXPECT_EQ(report.wrong.find('\n'), std::string::npos);
    EXPECT_EQ(plan(scene, options).wrong, report.wrong);
  }
}

TEST(Scene, AllBodiesInOneSpotAreOverTheBudgetAtOnce) {
  Scene scene;
  scene.bodies.assign(100'000, box("", {1, 2, 3}, {1, 0, 0}));
  for (const unsigned threads : {1u, 3u}) {
    Options options;
    options.threads = threads;
    options.most_pairs = 1'000'000;
    const Report report = run(scene, options);
    EXPECT_EQ(report.status, Status::over_budget);
    EXPECT_NE(report.wrong.find("more than 1000000 pairs"), std::string::npos) << report.wrong;
    EXPECT_TRUE(report.events.empty());
  }
}

TEST(Scene, AnInterruptedRunTellsWhatItKnows) {
  Scene scene;
  scene.bodies.push_back(box("wall", {0, 0, 0}));
  std::get<Box<double>>(scene.bodies[0].body.body.shape).half_extents = {0.5, 4000, 4000};
  for (int k = 0; k < 4000; ++k) scene.bodies.push_back(box("", {4, 1.5 * k, 0}, {-6, 0, 0}));
  Options options;
  int calls = 0;
  options.progress = [&](std::uint64_t done, std::uint64_t total) {
    EXPECT_LE(done, total);
    return ++calls < 3;
  };
  const Report report = run(scene, options);
  EXPECT_EQ(report.status, Status::interrupted);
  EXPECT_GT(report.events.size(), 0u);
  EXPECT_GT(report.counts.unfinished, 0u);
  options.progress = {};
  EXPECT_EQ(report.events.size() + report.counts.unfinished, run(scene, options).events.size());
}

bool same(double l, double r) { return std::bit_cast<std::uint64_t>(l) == std::bit_cast<std::uint64_t>(r); }
bool same(const Vec3<double>& l, const Vec3<double>& r) {
  return same(l[0], r[0]) && same(l[1], r[1]) && same(l[2], r[2]);
}
bool same(const Event& l, const Event& r) {
  return l.a == r.a && l.b == r.b && l.outcome == r.outcome && same(l.toi_lower, r.toi_lower) &&
         same(l.toi_upper, r.toi_upper) && same(l.distance, r.distance) && l.effects == r.effects &&
         l.reasons == r.reasons && same(l.normal, r.normal) && same(l.point_a, r.point_a) &&
         same(l.point_b, r.point_b);
}
bool same(const std::vector<Event>& l, const std::vector<Event>& r) {
  return std::equal(l.begin(), l.end(), r.begin(), r.end(),
                    [](const Event& x, const Event& y) { return same(x, y); });
}

TEST(Scene, TheSameBitsInAnyNumberOfThreads) {
  std::size_t events = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    law::RandomScene drawn = law::random_scene(seed);
    // Many copies of it, so that there is more than one part.
    Scene many;
    for (int k = 0; k < 12; ++k) {
      for (Member member : drawn.scene.bodies) {
        member.name += "/" + std::to_string(k);
        member.body.body.position += Vec3<double>(2.5 * k, 0, 0);
        many.bodies.push_back(std::move(member));
      }
    }
    many.probes = drawn.scene.probes;
    drawn.options.ask = static_cast<Ask>(seed % kAsks);
    const Report one = run(many, drawn.options);
    drawn.options.threads = 3;
    const Report three = run(many, drawn.options);
    EXPECT_EQ(one.wrong, three.wrong);
    EXPECT_TRUE(same(one.events, three.events)) << "scene " << seed;
    EXPECT_TRUE(same(one.probe_events, three.probe_events)) << "scene " << seed;
    EXPECT_EQ(one.counts, three.counts) << to_text(one.counts) << to_text(three.counts);
    events += one.events.size();
  }
  EXPECT_GT(events, 500u);
}

TEST(Scene, ThePlanIsWhatIsRun) {
  std::uint64_t simulated = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    law::RandomScene drawn = law::random_scene(seed);
    drawn.options.ask = Ask::pair;
    Report report = run(drawn.scene, drawn.options);
    Planned planned = plan(drawn.scene, drawn.options);
    ASSERT_EQ(planned.wrong, report.wrong);
    report.counts.probe_casts = report.counts.probe_moot = 0;
    EXPECT_EQ(planned.counts, report.counts) << "scene " << seed << "\n"
                                             << to_text(planned.counts) << to_text(report.counts);
    EXPECT_EQ(planned.pairs.size(), planned.counts.simulated());
    simulated += planned.pairs.size();
  }
  EXPECT_GT(simulated, 500u);
}

// But for the counters, and for the method that a miss by bounds did without.
void expect_same(const CastResult<double>& l, const CastResult<double>& r) {
  EXPECT_EQ(l.outcome, r.outcome);
  EXPECT_EQ(l.invalid, r.invalid);
  EXPECT_EQ(std::isnan(l.toi_lower), std::isnan(r.toi_lower));
  const bool times = same(l.toi_lower, r.toi_lower) && same(l.toi_upper, r.toi_upper);
  EXPECT_TRUE(times || std::isnan(l.toi_lower));
  EXPECT_TRUE(same(l.distance, r.distance));
  if (l.outcome == Outcome::hit) {
    EXPECT_TRUE(same(l.normal, r.normal) && same(l.point_a, r.point_a) && same(l.point_b, r.point_b));
    EXPECT_EQ(l.method, r.method);
  }
  EXPECT_EQ(l.passed_over, r.passed_over);
}

TEST(CastAll, AnswersAreThoseOfSingleCasts) {
  int outcomes[5] = {};
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const law::RandomScene drawn = law::random_scene(seed);
    std::vector<Body<double>> bodies;
    for (const Member& member : drawn.scene.bodies) bodies.push_back(member.body.body);
    bodies.push_back({.shape = Sphere<double>{-1}});  // each is answered by itself, the bad one too
    CastOptions<double> options;
    options.tier = drawn.options.tier;
    options.t_max = seed % 5 == 0 ? kInfinity<double> : drawn.options.t_max;
    options.target_distance = drawn.options.target_distance;
    std::vector<Question> questions;
    for (const Body<double>& a : bodies) {
      for (const Body<double>& b : bodies) questions.push_back({&a, &b});
    }
    for (const unsigned threads : {1u, 2u}) {
      std::vector<CastResult<double>> answers(questions.size()), against(bodies.size());
      cast_all(questions, answers, options, threads);
      for (std::size_t k = 0; k < questions.size(); ++k) {
        const CastResult<double> single = graze::cast(*questions[k].a, *questions[k].b, options);
        expect_same(answers[k], single);
        ++outcomes[static_cast<int>(single.outcome)];
      }
      cast_all(bodies[0], bodies, against, options, threads);
      for (std::size_t k = 0; k < bodies.size(); ++k)
        expect_same(against[k], graze::cast(bodies[0], bodies[k], options));
      std::vector<RayQuestion> rays;
      for (const Body<double>& body : bodies) rays.push_back({body.position, body.displacement});
      cast_rays(bodies[0], rays, against, options, threads);
      for (std::size_t k = 0; k < rays.size(); ++k) {
        const Body<double> point{
            .shape = Point<double>{}, .position = rays[k].origin, .displacement = rays[k].displacement};
        expect_same(against[k], graze::cast(bodies[0], point, options));
      }
    }
  }
  EXPECT_GT(outcomes[static_cast<int>(Outcome::hit)], 100);
  EXPECT_GT(outcomes[static_cast<int>(Outcome::miss)], 100);
  EXPECT_GT(outcomes[static_cast<int>(Outcome::initially_overlapping)], 100);
  EXPECT_GT(outcomes[static_cast<int>(Outcome::invalid_input)], 100);
}

// Rays that pass a face, an edge or a corner of the body's bounds by a little or by nothing, near and from far.
TEST(CastAll, RaysThatGrazeTheBoundsAreAnsweredAsSingleCastsAre) {
  corpus::Random random(8);
  int spared = 0, answered = 0, hits = 0;
  for (int round = 0; round < 400; ++round) {
    Body<double> body{.shape = Box<double>{{1, 2, 0.5}}};
    if (round % 4 == 1) body.shape = Sphere<double>{1};
    if (round % 4 == 2) body.shape = Capsule<double>{0.5, 0.5};
    const double far = random.once_in(3) ? std::ldexp(1, random.integer(0, 40)) : 1;
    body.position = far * Vec3<double>(random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2));
    if (random.once_in(3)) body.displacement = {1, 0, random.uniform(-1, 1)};
    CastOptions<double> options;
    if (random.once_in(2)) options.tier = Tier::exact;
    if (random.once_in(4)) options.tier = Tier::certified;
    if (random.once_in(4)) options.target_distance = 0.25;
    options.t_max = random.once_in(2) ? kInfinity<double> : random.integer(0, 4);
    std::vector<RayQuestion> rays;
    for (int k = 0; k < 40; ++k) {
      // To a point on the box about the body, moved outward by 2^-60 to 1 of its size, or by nothing.
      const Vec3<double> half(1, round % 4 == 0 ? 2 : 1, 1);
      Vec3<double> aim = half.cwiseProduct(
          Vec3<double>(random.integer(-1, 1), random.integer(-1, 1), random.integer(-1, 1)));
      if (random.once_in(2)) aim *= 1 + std::ldexp(1, random.integer(-60, 0));
      Vec3<double> way(random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2));
      if (random.once_in(2)) way += Vec3<double>(random.uniform(-1, 1), random.uniform(-1, 1), 0);
      if (random.once_in(8)) way *= std::ldexp(1, random.integer(-30, 30));
      const double back = random.once_in(4) ? 0 : random.integer(-1, 4);
      rays.push_back({body.position + aim - back * way, way});
    }
    rays.push_back({{kNan, 0, 0}, {1, 0, 0}});
    rays.push_back({{9, 0, 0}, {0, 1e70, 0}});
    rays.push_back({{9e9, 0, 0}, {0, 0, 0}});
    std::vector<CastResult<double>> answers(rays.size());
    cast_rays(body, rays, answers, options);
    std::vector<RayAnswer> slim(rays.size());
    cast_rays(body, rays, std::span<RayAnswer>(slim), options);
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const Body<double> point{
          .shape = Point<double>{}, .position = rays[k].origin, .displacement = rays[k].displacement};
      const CastResult<double> single = graze::cast(body, point, options);
      expect_same(answers[k], single);
      EXPECT_EQ(slim[k].outcome, single.outcome);
      EXPECT_TRUE(same(slim[k].toi_lower, single.toi_lower) && same(slim[k].toi_upper, single.toi_upper));
      EXPECT_TRUE(same(slim[k].normal, single.normal) && same(slim[k].point, single.point_a));
      hits += single.outcome == Outcome::hit;
      (answers[k].outcome == Outcome::miss && answers[k].counters.supports == 0 ? spared : answered) += 1;
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(spared, 3000);
  EXPECT_GT(answered, 3000);
}

TEST(CastAll, TurningBodiesToo) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const law::RandomScene drawn = law::random_scene(seed);
    std::vector<RotatingQuestion> questions;
    for (const Member& member : drawn.scene.bodies)
      questions.push_back({&drawn.scene.bodies[0].body, &member.body});
    std::vector<RotatingResult<double>> answers(questions.size());
    cast_all(questions, answers, {}, 2);
    for (std::size_t k = 0; k < questions.size(); ++k) {
      const RotatingResult<double> single = graze::cast(*questions[k].a, *questions[k].b);
      EXPECT_EQ(answers[k].outcome, single.outcome);
      EXPECT_TRUE(same(answers[k].toi_lower, single.toi_lower) &&
                  same(answers[k].toi_upper, single.toi_upper));
      EXPECT_TRUE(same(answers[k].normal, single.normal));
    }
  }
}

TEST(CastAll, WritesNoMoreThanThereIsRoomFor) {
  const Body<double> ball{.shape = Sphere<double>{1}};
  const std::vector<Question> questions(5, Question{&ball, &ball});
  std::vector<CastResult<double>> answers(8);
  cast_all(questions, std::span(answers).first(3), {});
  EXPECT_EQ(answers[2].outcome, Outcome::initially_overlapping);
  EXPECT_EQ(answers[3].outcome, Outcome::invalid_input);
}

}  // namespace
}  // namespace graze::scene
