// What a writer wrote reads back to the same bits.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "corpus/case_io.hpp"
#include "corpus/random.hpp"

namespace graze::corpus {
namespace {

void expect_round_trip(const Case& problem) {
  for (const std::string& text : {write_case(problem), write_case_pretty(problem)}) {
    const ReadResult result = read_text(text, "round trip", false);
    ASSERT_TRUE(result.ok()) << result.errors[0].text() << "\n" << text;
    EXPECT_TRUE(same_case(result.cases[0], problem)) << text << "\n" << write_case(result.cases[0]);
    EXPECT_EQ(write_case(result.cases[0]), write_case(problem));
  }
  EXPECT_EQ(write_case(problem).find('\n'), std::string::npos);
}

Case every_field() {
  Case problem;
  problem.id = "test/every-field";
  problem.family = "test";
  problem.hardness = -0.0;
  problem.comment = "quotes \" and \\ and\nlines, \xc3\xa9";
  problem.source = "https://example.org/?a=1&b=\"2\"";
  problem.flags = {"One", "Two"};
  problem.a.shape =
      Hull<double>{Vec3<double>(0, -0.0, 1), Vec3<double>(0x1p-1074, 1.7976931348623157e308, 1.0 / 3)};
  problem.a.position = Vec3<double>(-0.0, 0, 0);
  problem.a.orientation = {0, -0.0, 1, 0x1p-1022};
  problem.b.shape = Box<double>{Vec3<double>(0, 1, 2)};
  problem.b.displacement = Vec3<double>(1e22, 1e23, -1e-7);
  problem.spin_a.rotation = Vec3<double>(0, 0, 3);
  problem.spin_b.pivot = Vec3<double>(1, 0, 0);
  problem.t_max = kInfinity<double>;
  problem.target_distance = 0.1;
  problem.start_policy = StartPolicy::pass_over;
  problem.query = Query::penetration_along;
  problem.direction = Vec3<double>(0, 0, -1);
  Expect expect;
  expect.by = "closed form";
  expect.outcome = Outcome::initially_overlapping;
  expect.toi_lower = 0.1;
  expect.toi_upper = 0.2;
  expect.toi_exact = "3/20";
  expect.t_in = -kInfinity<double>;
  expect.t_out = kInfinity<double>;
  expect.distance = 0;
  expect.depth = 5e-324;
  expect.normal = Vec3<double>(0, -1, 0);
  problem.expect = expect;
  return problem;
}

TEST(RoundTrip, OfEveryField) { expect_round_trip(every_field()); }

TEST(RoundTrip, OfRandomBits) {
  Random random(1);
  const auto finite = [&] {
    double x = 0;
    do {
      x = std::bit_cast<double>(random.bits());
    } while (!std::isfinite(x));
    return x;
  };
  for (int i = 0; i < 2000; ++i) {
    Case problem;
    problem.id = "test/bits";
    problem.a.shape = Sphere<double>{std::abs(finite())};
    problem.b.shape = Hull<double>{Vec3<double>(finite(), finite(), finite())};
    problem.a.position = Vec3<double>(finite(), finite(), finite());
    problem.b.orientation = {finite(), finite(), finite(), finite()};
    problem.t_max = std::abs(finite());
    expect_round_trip(problem);
  }
}

// The comparison that the tests above rest on notices one changed bit anywhere.
TEST(SameCase, NoticesEveryChange) {
  const Case original = every_field();
  EXPECT_TRUE(same_case(original, every_field()));
  const std::vector<void (*)(Case&)> changes = {
      [](Case& c) { c.id += "x"; },
      [](Case& c) { c.family += "x"; },
      [](Case& c) { c.hardness = 0.0; },
      [](Case& c) { c.comment += "x"; },
      [](Case& c) { c.source += "x"; },
      [](Case& c) { c.flags.pop_back(); },
      [](Case& c) { c.a.shape = Point<double>{}; },
      [](Case& c) { c.a.shape = Hull<double>{Vec3<double>(0, -0.0, 1)}; },
      [](Case& c) { c.b.shape = Box<double>{Vec3<double>(-0.0, 1, 2)}; },
      [](Case& c) { c.a.position[0] = 0; },
      [](Case& c) { c.a.orientation.x = 0; },
      [](Case& c) { c.b.displacement[1] = std::nextafter(1e23, 0); },
      [](Case& c) { c.spin_a.rotation[2] = 4; },
      [](Case& c) { c.spin_b.pivot[2] = 4; },
      [](Case& c) { c.t_max = 1; },
      [](Case& c) { c.target_distance = 0; },
      [](Case& c) { c.start_policy = StartPolicy::report; },
      [](Case& c) { c.query = Query::penetration; },
      [](Case& c) { c.direction[0] = -0.0; },
      [](Case& c) { c.expect.reset(); },
      [](Case& c) { c.expect->by = "x"; },
      [](Case& c) { c.expect->outcome = Outcome::hit; },
      [](Case& c) { c.expect->toi_lower = 0; },
      [](Case& c) { c.expect->toi_upper = 1; },
      [](Case& c) { c.expect->toi_exact = "1"; },
      [](Case& c) { c.expect->t_in.reset(); },
      [](Case& c) { c.expect->t_out = 0; },
      [](Case& c) { c.expect->distance = -0.0; },
      [](Case& c) { c.expect->depth = 0; },
      [](Case& c) { c.expect->normal.reset(); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Case changed = every_field();
    changes[i](changed);
    EXPECT_FALSE(same_case(original, changed)) << "change " << i;
    // Whatever differs is written differently as well, so no field is dropped by the writer.
    EXPECT_NE(write_case(original), write_case(changed)) << "change " << i;
  }
}

}  // namespace
}  // namespace graze::corpus
