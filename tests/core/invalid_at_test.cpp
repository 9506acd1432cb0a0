// invalid_input says where: which body, which number of it; and the same from every query.
#include <gtest/gtest.h>

#include <cfenv>
#include <graze/cast.hpp>
#include <graze/distance.hpp>
#include <graze/invalid_text.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <graze/rotating_cast.hpp>
#include <graze/swept_overlap.hpp>
#include <set>

namespace graze {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kHuge = 1e61;

struct Place {
  Invalid invalid;
  InvalidAt at;
};
template <class Result>
Place place(const Result& result) {
  return {result.invalid, result.invalid_at};
}

// Every query, asked of two bodies that stand still or fly, with nothing wrong in its options.
template <Scalar S>
std::vector<Place> ask_all(const Body<S>& a, const Body<S>& b) {
  std::vector<Place> out;
  for (const Tier tier : {Tier::standard, Tier::certified, Tier::exact})
    out.push_back(place(cast(a, b, {.tier = tier})));
  for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep})
    out.push_back(place(cast(a, b, {.method = method})));
  out.push_back(place(cast(RotatingBody<S>{a}, RotatingBody<S>{b})));
  out.push_back(place(cast(RotatingBody<S>{.body = a, .rotation = {1, 0, 0}}, RotatingBody<S>{b})));
  out.push_back(place(distance(a, b)));
  out.push_back(place(overlap_mpr(a, b)));
  out.push_back(place(overlap_gjk(a, b)));
  out.push_back(place(overlap_exact(a, b)));
  out.push_back(place(penetration(a, b)));
  out.push_back(place(penetration_along(a, b, Vec3<S>(1, 0, 0))));
  out.push_back(place(line(a, b)));
  out.push_back(place(line_exact(a, b)));
  for (const SweptMethod method : {SweptMethod::gjk, SweptMethod::mpr, SweptMethod::before_after})
    out.push_back(place(swept_overlap(a, b, {.method = method})));
  out.push_back(place(swept_overlap_exact(a, b)));
  return out;
}

// The body is refused as `bad` by every query, wherever it stands.
template <Scalar S>
void expect_place(const Body<S>& body, const std::string& text, InvalidField field, int part, int index) {
  SCOPED_TRACE(text);
  const Body<S> good{.shape = Box<S>{{1, 1, 1}}};
  for (const InvalidBody which : {InvalidBody::a, InvalidBody::b}) {
    const bool first = which == InvalidBody::a;
    const std::vector<Place> places = first ? ask_all(body, good) : ask_all(good, body);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const InvalidAt& at = places[k].at;
      EXPECT_NE(places[k].invalid, Invalid::none) << k;
      EXPECT_EQ(at.why, places[k].invalid) << k;
      EXPECT_EQ(at.body, which) << k;
      EXPECT_EQ(at.field, field) << k;
      EXPECT_EQ(at.part, part) << k;
      EXPECT_EQ(at.index, index) << k;
      EXPECT_EQ(to_text(at), (first ? "body a: " : "body b: ") + text) << k;
    }
  }
}
template <Scalar S = double>
void expect_shape(const std::type_identity_t<Shape<S>>& shape, const std::string& text, InvalidField field,
                  int part = 0, int index = -1) {
  expect_place<S>({.shape = shape}, text, field, part, index);
}

TEST(InvalidAt, EachNumberOfAShape) {
  using F = InvalidField;
  constexpr double inf = kInfinity<double>;
  expect_shape(Sphere<double>{-1}, "shape.radius is negative", F::radius);
  expect_shape(Sphere<double>{kNan}, "shape.radius is NaN or infinite", F::radius);
  expect_shape(Capsule<double>{1, inf}, "shape.half_height is NaN or infinite", F::half_height);
  expect_shape(Cylinder<double>{-1, -1}, "shape.radius is negative", F::radius);
  expect_shape(Cone<double>{1, -1}, "shape.half_height is negative", F::half_height);
  expect_shape(Box<double>{{1, -1e-9, 1}}, "shape.half_extents[1] is negative", F::half_extents, 0, 1);
  expect_shape(Box<double>{{-1, 1, kNan}}, "shape.half_extents[2] is NaN or infinite", F::half_extents, 0, 2);
  expect_shape(Ellipsoid<double>{{1, 1, kHuge}},
               "shape.radii[2] is neither 0 nor of a magnitude from 1e-60 to 1e60", F::radii, 0, 2);
  expect_shape(Segment<double>{{0, 0, 0}, {0, kNan, 0}}, "shape.vertex[1] is NaN or infinite", F::vertex, 0,
               1);
  expect_shape(Triangle<double>{{0, 0, 0}, {0, 1, 0}, {1e-61, 0, 0}},
               "shape.vertex[2] is neither 0 nor of a magnitude from 1e-60 to 1e60", F::vertex, 0, 2);
  expect_shape(Hull<double>(), "shape has no vertex", F::shape);
  expect_shape(Hull<double>{{0, 0, 0}, {1, 0, 0}, {0, 1e-61, 0}},
               "shape.vertex[2] is neither 0 nor of a magnitude from 1e-60 to 1e60", F::vertex, 0, 2);
  // A NaN is what the hull as a whole is refused for, though a huge number comes first.
  expect_shape(Hull<double>{{kHuge, 0, 0}, {1, 0, 0}, {0, 1, inf}}, "shape.vertex[2] is NaN or infinite",
               F::vertex, 0, 2);
  expect_shape<float>(Box<float>{{1, 1, -1}}, "shape.half_extents[2] is negative", F::half_extents, 0, 2);
}

TEST(InvalidAt, EachNumberOfAPart) {
  using F = InvalidField;
  const Shape<double> ball = Sphere<double>{1}, empty = Hull<double>();
  expect_shape(posed<double>(ball, {0, kNan, 0}, {}), "shape.position[1] is NaN or infinite", F::position, 0,
               1);
  expect_shape(posed<double>(ball, {0, 0, 0}, {0, 0, 0, 0}), "shape.orientation is (0, 0, 0, 0)",
               F::orientation);
  expect_shape(rounded<double>(ball, -1), "shape.radius is negative", F::radius);
  expect_shape(sum<double>(ball, empty), "part 2 of its shape has no vertex", F::shape, 2);
  expect_shape(hull_of<double>(Cone<double>{1, -1}, ball), "part 1 of its shape: half_height is negative",
               F::half_height, 1);
  // Each part before its own: 1 the sum, 2 and 3 its parts, 4 the pose, 5 the box in it.
  const Shape<double> crooked = translated<double>(Box<double>{{1, 1, -2}}, {0, 0, 0});
  expect_shape(hull_of<double>(sum<double>(ball, ball), crooked),
               "part 5 of its shape: half_extents[2] is negative", F::half_extents, 5, 2);
  expect_shape(Sum<double>{}, "shape has no parts", F::part);
  expect_shape(hull_of<double>(ball, Sum<double>{}), "part 2 of its shape has no parts", F::part, 2);
  expect_shape(Posed<double>{}, "part 1 of its shape is missing", F::shape, 1);
  expect_shape(HullOf<double>{{share<double>(ball), nullptr}}, "part 2 of its shape is missing", F::shape, 2);
}

TEST(InvalidAt, TooMuchOfACombinator) {
  const std::string many = " is nested deeper than 16, or has more than 4096 parts or 2^32 - 1 vertices";
  Shape<double> nest = Sphere<double>{1};
  for (int k = 0; k < 17; ++k) nest = rounded<double>(nest, 1);
  expect_shape(nest, "part 16 of its shape" + many, InvalidField::shape, 16);
  Shape<double> doubled = Sphere<double>{1};
  for (int k = 0; k < 12; ++k) {
    const SharedShape<double> part = share<double>(doubled);
    doubled = HullOf<double>{{part, part}};
  }
  expect_shape(doubled, "part 4097 of its shape" + many, InvalidField::shape, 4097);
  Shape<double> product = Box<double>{{1, 1, 1}};
  for (int k = 0; k < 10; ++k) product = sum<double>(product, Box<double>{{1, 1, 1}});
  expect_shape(product, "shape" + many, InvalidField::shape, 0);
}

TEST(InvalidAt, EachNumberOfABody) {
  using F = InvalidField;
  const Body<double> good{.shape = Sphere<double>{1}};
  for (int i = 0; i < 3; ++i) {
    const std::string which = "[" + std::to_string(i) + "]";
    Body<double> body = good;
    body.position[i] = kNan;
    expect_place(body, "position" + which + " is NaN or infinite", F::position, -1, i);
    body = good;
    body.displacement[i] = -kHuge;
    expect_place(body, "displacement" + which + " is neither 0 nor of a magnitude from 1e-60 to 1e60",
                 F::displacement, -1, i);
  }
  Body<double> body = good;
  body.orientation = {0, 0, 0, 0};
  expect_place(body, "orientation is (0, 0, 0, 0)", F::orientation, -1, -1);
  body.orientation = {0, kNan, 0, 0};
  expect_place(body, "orientation is NaN or infinite", F::orientation, -1, -1);
  // If there are several, the shape's is said first, as it is refused first.
  body.shape = Sphere<double>{-1};
  expect_place(body, "shape.radius is negative", F::radius, 0, -1);
}

TEST(InvalidAt, TheFirstBodyIsNamedWhereBothAreBad) {
  const Body<double> bad{.shape = Sphere<double>{-1}}, worse{.shape = Hull<double>()};
  for (const Place& one : ask_all(bad, worse)) EXPECT_EQ(to_text(one.at), "body a: shape.radius is negative");
}

TEST(InvalidAt, NothingWhereNothingIsWrong) {
  const Body<double> good{.shape = Box<double>{{1, 1, 1}}};
  for (const Place& one : ask_all(good, good)) {
    EXPECT_EQ(one.invalid, Invalid::none);
    EXPECT_EQ(one.at.why, Invalid::none);
    EXPECT_EQ(one.at.field, InvalidField::none);
    EXPECT_EQ(to_text(one.at), "");
  }
}

const Body<double> kBox{.shape = Box<double>{{1, 1, 1}}}, kBall{.shape = Sphere<double>{1}};

template <class Result>
void expect_option(const Result& result, Invalid why, const std::string& text) {
  EXPECT_EQ(result.invalid, why) << text;
  EXPECT_EQ(result.invalid_at.why, why) << text;
  EXPECT_EQ(result.invalid_at.body, InvalidBody::none) << text;
  EXPECT_EQ(to_text(result.invalid_at), text);
}

TEST(InvalidAt, EachOption) {
  const std::string horizon = "t_max is negative or NaN",
                    target = "target_distance is negative, NaN or out of range",
                    tolerance = "tolerance is negative, NaN or infinite",
                    budget = "max_iterations is below one";
  for (const Tier tier : {Tier::standard, Tier::certified, Tier::exact}) {
    expect_option(cast(kBox, kBox, {.tier = tier, .t_max = -1}), Invalid::bad_horizon, horizon);
    expect_option(cast(kBox, kBox, {.tier = tier, .target_distance = kNan}), Invalid::bad_target, target);
    expect_option(cast(kBox, kBox, {.tier = tier, .tolerance = -1}), Invalid::bad_tolerance, tolerance);
    expect_option(cast(kBox, kBox, {.tier = tier, .max_iterations = 0}), Invalid::bad_tolerance, budget);
  }
  const RotatingBody<double> box{kBox};
  expect_option(cast(box, box, {.t_max = kNan}), Invalid::bad_horizon, horizon);
  expect_option(cast(box, box, {.target_distance = -1}), Invalid::bad_target, target);
  expect_option(cast(box, box, {.tolerance = kNan}), Invalid::bad_tolerance, tolerance);
  expect_option(cast(box, box, {.max_iterations = 0}), Invalid::bad_tolerance, budget);
  expect_option(cast(box, box, {.time_steps = 0}), Invalid::bad_tolerance, "time_steps is below one");
  expect_option(distance(kBox, kBox, {.tolerance = -1}), Invalid::bad_tolerance, tolerance);
  expect_option(penetration(kBox, kBox, {.max_iterations = 0}), Invalid::bad_tolerance, budget);
  expect_option(line(kBox, kBox, {.target_distance = -1}), Invalid::bad_target, target);
  expect_option(line_exact(kBox, kBox, {.target_distance = -1}), Invalid::bad_target, target);
  expect_option(swept_overlap(kBox, kBox, {.t_max = -1}), Invalid::bad_horizon, horizon);
  expect_option(swept_overlap_exact(kBox, kBox, {.t_max = -1}), Invalid::bad_horizon, horizon);
  const auto along = [](double x, double y) { return penetration_along(kBox, kBox, Vec3<double>(x, y, 0)); };
  expect_option(along(0, kNan), Invalid::not_finite, "direction[1] is NaN or infinite");
  expect_option(along(0, 0), Invalid::out_of_range, "direction is zero");
  expect_option(along(kHuge, 0), Invalid::out_of_range,
                "direction[0] is neither 0 nor of a magnitude from 1e-60 to 1e60");
}

TEST(InvalidAt, WhatATurnAdds) {
  const auto first = [](const RotatingBody<double>& turning, const RotatingOptions<double>& options = {}) {
    return cast(turning, RotatingBody<double>{kBall}, options).invalid_at;
  };
  const auto second = [](const RotatingBody<double>& turning) {
    return cast(RotatingBody<double>{kBall}, turning).invalid_at;
  };
  RotatingBody<double> box{.body = kBox, .rotation = {1, 0, kNan}};
  EXPECT_EQ(to_text(first(box)), "body a: rotation[2] is NaN or infinite");
  EXPECT_EQ(to_text(second(box)), "body b: rotation[2] is NaN or infinite");
  box = {.body = kBox, .pivot = {kHuge, 0, 0}};
  EXPECT_EQ(to_text(second(box)), "body b: pivot[0] is neither 0 nor of a magnitude from 1e-60 to 1e60");
  box = {.body = kBox, .rotation = {0x1p31, 0, 0}};
  EXPECT_EQ(to_text(first(box)), "body a: rotation is a turn of more than 2^30 radians");
  EXPECT_EQ(to_text(second(box)), "body b: rotation is a turn of more than 2^30 radians");
  box.rotation = {1, 2, 3};
  EXPECT_EQ(to_text(first(box, {.t_max = kInfinity<double>})),
            "t_max is infinite, and a rotation can be seen");
  EXPECT_EQ(
      to_text(first(box, {.method = RotatingMethod::time_steps, .start_policy = StartPolicy::pass_over})),
      "start_policy is pass_over, a rotation can be seen, and what becomes of the contact at the start is "
      "not "
      "found by this method, or not proved");
  EXPECT_EQ(to_text(first(box, {.tier = Tier::exact})),
            "tier is exact, which knows no rotation that can be seen");
  EXPECT_EQ(to_text(first(box, {.method = RotatingMethod::time_steps, .t_max = kInfinity<double>})),
            "t_max is infinite, and a rotation can be seen");
}

TEST(InvalidAt, WhatTheExactTierDoesNotKnow) {
  const std::string curved = "shape is curved or a hull of shapes, which tier exact does not know";
  const Body<double> cone{.shape = Cone<double>{1, 1}};
  const CastOptions<double> exact{.tier = Tier::exact};
  EXPECT_EQ(to_text(cast(cone, kBox, exact).invalid_at), "body a: " + curved);
  EXPECT_EQ(to_text(cast(kBox, cone, exact).invalid_at), "body b: " + curved);
  EXPECT_EQ(to_text(line_exact(kBox, cone).invalid_at), "body b: " + curved);
  EXPECT_EQ(to_text(overlap_exact(cone, kBox).invalid_at), "body a: " + curved);
  // Rotating bodies whose motion is linear after all: the linear cast's reason is handed on.
  const RotatingBody<double> turned{cone}, box{kBox};
  EXPECT_EQ(to_text(cast(box, turned, {.tier = Tier::exact}).invalid_at), "body b: " + curved);
}

TEST(InvalidAt, TheMachine) {
  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  const std::vector<Place> places = ask_all(kBall, Body<double>{.shape = Sphere<double>{-1}});
  std::fesetround(FE_TONEAREST);
  for (const Place& one : places) EXPECT_EQ(to_text(one.at), "the machine does not round to nearest");
}

TEST(InvalidAt, EveryFieldHasWordsOfItsOwn) {
  std::set<std::string_view> seen;
  int fields = 0;
  for (; !to_text(static_cast<InvalidField>(fields)).empty(); ++fields)
    seen.insert(to_text(static_cast<InvalidField>(fields)));
  EXPECT_EQ(fields, static_cast<int>(InvalidField::direction) + 1);
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(fields));
  EXPECT_EQ(to_text(InvalidBody::none), "neither body");
}

}  // namespace
}  // namespace graze
