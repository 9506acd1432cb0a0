// Every written case reads back to the same bits.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "corpus/format/case_io.hpp"
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
  expect.clearance = 0x1p-1074;
  expect.path_depth = 0.1;
  expect.scale = 1e23;
  problem.expect = expect;
  return problem;
}

TEST(RoundTrip, OfEveryField) { expect_round_trip(every_field()); }

TEST(RoundTrip, OnlyWhatTheFirstSchemaCannotSayIsWrittenInTheSecond) {
  Case problem = every_field();
  EXPECT_NE(write_case(problem).find(R"("graze.case/2")"), std::string::npos);
  problem.expect->clearance.reset();
  problem.expect->path_depth.reset();
  EXPECT_NE(write_case(problem).find(R"("graze.case/2")"), std::string::npos);
  problem.expect->scale.reset();
  EXPECT_NE(write_case(problem).find(R"("graze.case/1")"), std::string::npos);
  expect_round_trip(problem);
}

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

// Shapes with a number of its own in every field.
std::vector<Shape<double>> every_shape() {
  const Vec3<double> a(0.1, -0.0, 5e-324), b(2, 1e300, -1.0 / 3), c(-7, 0, 11);
  const Quaternion<double> turn{0.5, -0.0, 3, 1e-9};
  std::vector<Shape<double>> all = {Point<double>{},
                                    Segment<double>{a, b},
                                    Triangle<double>{a, b, c},
                                    Sphere<double>{0.1},
                                    Capsule<double>{0.2, 0.3},
                                    Box<double>{{0.1, 0.2, 0}},
                                    Ellipsoid<double>{{1, 0.2, 3}},
                                    Cylinder<double>{0.4, 0.5},
                                    Cone<double>{0.6, 0.7},
                                    Hull<double>{a, b, c}};
  const Shape<double> leaf = all[2];
  all.push_back(posed<double>(leaf, b, turn));
  all.push_back(rounded<double>(leaf, 0.8));
  all.push_back(sum<double>(leaf, all[10]));
  all.push_back(hull_of<double>(all[12], all[11]));
  return all;
}

TEST(RoundTrip, OfEveryShape) {
  std::set<std::size_t> kinds;
  for (const Shape<double>& shape : every_shape()) {
    Case problem;
    problem.id = "test/shape";
    problem.a.shape = shape;
    problem.b.shape = swept<double>(shape, Vec3<double>(1, 2, 3));
    expect_round_trip(problem);
    kinds.insert(shape.index());
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Shape<double>::Kinds>);
}

TEST(SameCase, TellsEveryShapeFromEveryOther) {
  const std::vector<Shape<double>> shapes = every_shape();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      Case l, r;
      l.a.shape = shapes[i];
      r.a.shape = every_shape()[j];
      EXPECT_EQ(same_case(l, r), i == j) << i << " " << j;
    }
  }
}

// Each shape, and one that differs from it in a single number, part, or sign of zero.
TEST(SameCase, NoticesEveryNumberOfAShape) {
  const Vec3<double> o = Vec3<double>::Zero(), x(1, 0, 0);
  const Shape<double> point = Point<double>{}, ball = Sphere<double>{1};
  const std::pair<Shape<double>, Shape<double>> pairs[] = {
      {Segment<double>{o, x}, Segment<double>{x, x}},
      {Segment<double>{o, o}, Segment<double>{o, Vec3<double>(0, -0.0, 0)}},
      {Triangle<double>{o, o, o}, Triangle<double>{o, o, x}},
      {Triangle<double>{o, o, o}, Triangle<double>{o, x, o}},
      {Capsule<double>{1, 2}, Capsule<double>{1, 3}},
      {Capsule<double>{1, 2}, Cylinder<double>{1, 2}},
      {Cylinder<double>{1, 2}, Cylinder<double>{2, 2}},
      {Cone<double>{1, 2}, Cone<double>{1, 1}},
      {Ellipsoid<double>{{1, 2, 3}}, Ellipsoid<double>{{1, 2, 4}}},
      {rounded<double>(point, 1), rounded<double>(point, 2)},
      {rounded<double>(point, 1), rounded<double>(ball, 1)},
      {posed<double>(point, o, {}), posed<double>(point, x, {})},
      {posed<double>(point, o, {}), posed<double>(point, o, {1, 0, 0, 1})},
      {posed<double>(point, o, {}), posed<double>(ball, o, {})},
      {sum<double>(point, ball), sum<double>(ball, point)},
      {sum<double>(point, ball), hull_of<double>(point, ball)},
      {Sum<double>{{share(point)}}, Sum<double>{{share(point), share(point)}}},
      {Sum<double>{{share(point)}}, Sum<double>{{nullptr}}},
  };
  for (const auto& [one, other] : pairs) {
    Case l, r;
    l.a.shape = one;
    r.a.shape = other;
    EXPECT_TRUE(same_case(l, l));
    EXPECT_FALSE(same_case(l, r)) << write_case(l) << "\n" << write_case(r);
    EXPECT_NE(write_case(l), write_case(r));
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
      [](Case& c) { c.expect->clearance = 0; },
      [](Case& c) { c.expect->path_depth.reset(); },
      [](Case& c) { c.expect->scale = 1; },
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
