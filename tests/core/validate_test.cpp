#include <gtest/gtest.h>
#include <xmmintrin.h>
#include <graze/detail/shapes/validation.hpp>

#include <cfenv>
#include <graze/cast.hpp>

namespace graze {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Invalid refused(const Body<double>& a, const Body<double>& b = {}, const CastOptions<double>& options = {}) {
  const auto r = cast(a, b, options);
  EXPECT_EQ(r.outcome == Outcome::invalid_input, r.invalid != Invalid::none);
  if (r.outcome == Outcome::invalid_input) {
    EXPECT_TRUE(std::isnan(r.toi_lower));
    EXPECT_EQ(r.counters.supports, 0);
  }
  return r.invalid;
}

TEST(Validate, EachBadShapeHasItsReason) {
  EXPECT_EQ(refused({.shape = Sphere<double>{-1}}), Invalid::negative_extent);
  EXPECT_EQ(refused({.shape = Sphere<double>{kNan}}), Invalid::not_finite);
  EXPECT_EQ(refused({.shape = Box<double>{{1, -1e-9, 1}}}), Invalid::negative_extent);
  EXPECT_EQ(refused({.shape = Box<double>{{1, kInfinity<double>, 1}}}), Invalid::not_finite);
  EXPECT_EQ(refused({.shape = Hull<double>()}), Invalid::empty_hull);
  EXPECT_EQ(refused({.shape = Hull<double>(std::span<const Vec3<double>>())}), Invalid::empty_hull);
  EXPECT_EQ(refused({.shape = Hull<double>{{0, 0, 0}, {kNan, 0, 0}}}), Invalid::not_finite);
  EXPECT_EQ(refused({.shape = Hull<double>{{0, 0, 0}, {1e61, 0, 0}}}), Invalid::out_of_range);
  EXPECT_EQ(refused({.shape = Hull<double>{{0, 0, 0}, {1e-61, 1, 0}}}), Invalid::out_of_range);
}

TEST(Validate, ZeroExtentsAreShapes) {
  EXPECT_EQ(refused({.shape = Sphere<double>{0}}), Invalid::none);
  EXPECT_EQ(refused({.shape = Box<double>{{0, 0, 0}}}), Invalid::none);
  EXPECT_EQ(refused({.shape = Hull<double>{{1, 2, 3}}}), Invalid::none);
}

// The check by bits lets pass whatever is ordinary, and nothing that the check in words refuses.
TEST(Validate, TheShortCheckLetsPassOnlyWhatTheLongOneDoes) {
  using Make = Shape<double> (*)(double, double, double);
  const Make shapes[] = {
      [](double x, double, double) -> Shape<double> { return Sphere<double>{x}; },
      [](double x, double y, double) -> Shape<double> {
        return Capsule<double>{x, y};
      },
      [](double x, double y, double) -> Shape<double> {
        return Cylinder<double>{x, y};
      },
      [](double x, double y, double) -> Shape<double> {
        return Cone<double>{x, y};
      },
      [](double x, double y, double z) -> Shape<double> {
        return Box<double>{{x, y, z}};
      },
      [](double x, double y, double z) -> Shape<double> {
        return Ellipsoid<double>{{x, y, z}};
      },
      [](double x, double y, double z) -> Shape<double> {
        return Segment<double>{{x, y, z}, {1, 2, 3}};
      },
      [](double x, double y, double z) -> Shape<double> {
        return Triangle<double>{{1, 2, 3}, {3, 2, 1}, {x, y, z}};
      },
  };
  const double values[] = {0, -0.0, 1, -1, 1e-60, 1e60, 1e-61, 1e61, 0x1p-1074, kInfinity<double>, kNan};
  int parts = 0, passed = 0, refused_ones = 0;
  for (const Make make : shapes) {
    EXPECT_TRUE(detail::is_common(Body<double>{.shape = make(1, 0, 3)}));
    for (const double x : values) {
      for (int at = 0; at < 3; ++at) {
        const Body<double> body{.shape = make(at == 0 ? x : 1, at == 1 ? x : 1, at == 2 ? x : 1)};
        const bool valid = detail::check_shape(body.shape, 0, parts) == Invalid::none;
        EXPECT_FALSE(detail::is_common(body) && !valid) << body.shape.index() << " " << x << " " << at;
        ++(valid ? passed : refused_ones);
      }
    }
  }
  EXPECT_GT(passed, 50);
  EXPECT_GT(refused_ones, 50);
}

TEST(Validate, PoseAndMotion) {
  const Body<double> good{.shape = Sphere<double>{1}};
  for (int i = 0; i < 3; ++i) {
    for (const double bad : {kNan, kInfinity<double>, -kInfinity<double>}) {
      Body<double> body = good;
      body.position[i] = bad;
      EXPECT_EQ(refused(good, body), Invalid::not_finite);
      body = good;
      body.displacement[i] = bad;
      EXPECT_EQ(refused(body, good), Invalid::not_finite);
    }
    Body<double> far = good;
    far.position[i] = 1.1e60;
    EXPECT_EQ(refused(far, good), Invalid::out_of_range);
    far.position[i] = 1e-61;
    EXPECT_EQ(refused(far, good), Invalid::out_of_range);
  }
  Body<double> body = good;
  body.orientation = {0, 0, 0, 0};
  EXPECT_EQ(refused(body), Invalid::zero_quaternion);
  body.orientation = {0, kNan, 0, 0};
  EXPECT_EQ(refused(body), Invalid::not_finite);
  body.orientation = {-3, 0, 0, 0};
  EXPECT_EQ(refused(body), Invalid::none);
}

TEST(Validate, Options) {
  CastOptions<double> options;
  for (const double bad : {-1.0, kNan}) {
    options = {};
    options.t_max = bad;
    EXPECT_EQ(refused({}, {}, options), Invalid::bad_horizon);
    options = {};
    options.target_distance = bad;
    EXPECT_EQ(refused({}, {}, options), Invalid::bad_target);
    options = {};
    options.tolerance = bad;
    EXPECT_EQ(refused({}, {}, options), Invalid::bad_tolerance);
  }
  options = {};
  options.max_iterations = 0;
  EXPECT_EQ(refused({}, {}, options), Invalid::bad_tolerance);
  options = {};
  options.t_max = kInfinity<double>;
  EXPECT_EQ(refused({}, {}, options), Invalid::none);
}

TEST(Validate, EveryFiniteFloatIsInRange) {
  const Body<float> a{.shape = Box<float>{Vec3<float>::Constant(std::numeric_limits<float>::max())}};
  const Body<float> b{.shape = Sphere<float>{std::numeric_limits<float>::denorm_min()},
                      .position = Vec3<float>::Constant(-std::numeric_limits<float>::max()),
                      .displacement = Vec3<float>::Constant(std::numeric_limits<float>::denorm_min())};
  EXPECT_EQ(cast(a, b).outcome, Outcome::initially_overlapping);
  EXPECT_EQ(cast(b, a).outcome, Outcome::initially_overlapping);
}

// 1e-60 to 1e60: the same scene at both ends answers as in the middle.
TEST(Validate, EndsOfTheRangeAnswer) {
  for (const double unit : {1e-59, 1.0, 1e58}) {
    for (const Method method : {Method::conservative_advancement, Method::gjk_ray_cast, Method::mpr_sweep}) {
      const Body<double> a{.shape = Box<double>{{unit, unit, unit}}};
      const Body<double> b{.shape = Hull<double>{{0, 0, 0}, {unit, 0, 0}, {0, unit, 0}, {0, 0, unit}},
                           .position = {5 * unit, 0.25 * unit, 0.25 * unit},
                           .displacement = {-8 * unit, 0, 0}};
      CastOptions<double> options;
      options.method = method;
      options.request = Request::everything;
      const auto r = cast(a, b, options);
      ASSERT_EQ(r.outcome, Outcome::hit) << unit;
      EXPECT_NEAR(r.toi_lower, 0.5, 1e-14) << unit;
      EXPECT_LE(r.proof->toi_lower, 0.5 + 1e-15) << unit;
      EXPECT_GT(r.proof->toi_lower, 0.499) << unit;
    }
  }
}

TEST(Validate, CombinatorsAreCheckedToTheLeaves) {
  const auto of = [](Shape<double> shape) { return refused({.shape = std::move(shape)}, {}); };
  const Shape<double> ball = Sphere<double>{1};
  EXPECT_EQ(of(Posed<double>{}), Invalid::missing_part);
  EXPECT_EQ(of(Rounded<double>{nullptr, 1}), Invalid::missing_part);
  EXPECT_EQ(of(Sum<double>{}), Invalid::missing_part);
  EXPECT_EQ(of(HullOf<double>{{share<double>(ball), nullptr}}), Invalid::missing_part);
  EXPECT_EQ(of(rounded<double>(ball, -1)), Invalid::negative_extent);
  EXPECT_EQ(of(sum<double>(ball, Hull<double>())), Invalid::empty_hull);
  EXPECT_EQ(of(posed<double>(ball, {0, 0, 0}, {0, 0, 0, 0})), Invalid::zero_quaternion);
  EXPECT_EQ(of(translated<double>(ball, {0, std::nan(""), 0})), Invalid::not_finite);
  EXPECT_EQ(of(hull_of<double>(ball, Cone<double>{1, -1})), Invalid::negative_extent);
  EXPECT_EQ(of(Ellipsoid<double>{{1, -1, 1}}), Invalid::negative_extent);
  EXPECT_EQ(of(Capsule<double>{1, kInfinity<double>}), Invalid::not_finite);

  Shape<double> nest = ball;
  for (int k = 0; k < detail::kMaxNesting; ++k) nest = rounded<double>(nest, 1);
  EXPECT_EQ(of(nest), Invalid::none);
  EXPECT_EQ(of(rounded<double>(nest, 1)), Invalid::too_complex);
  // Shared parts count each time: 2^12 leaves, and half as many again above them.
  Shape<double> doubled = ball;
  for (int k = 0; k < 12; ++k) {
    const SharedShape<double> part = share<double>(doubled);
    doubled = HullOf<double>{{part, part}};
  }
  EXPECT_EQ(of(doubled), Invalid::too_complex);
  Shape<double> product = Box<double>{{1, 1, 1}};
  for (int k = 0; k < 10; ++k) product = sum<double>(product, Box<double>{{1, 1, 1}});
  EXPECT_EQ(of(product), Invalid::too_complex);  // 8^11 > 2^32
}

TEST(Validate, AnotherRoundingModeIsRefused) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const Invalid reason = refused({}, {});
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(reason, Invalid::rounding_mode) << mode;
  }
  EXPECT_EQ(refused({}, {}), Invalid::none);
}

#if defined(__x86_64__)
// When denormals are taken for zero, a denormal float would be another number than the given one.
TEST(Validate, FlushedSubnormalsAreRefused) {
  const float tiny = std::numeric_limits<float>::denorm_min();
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);  // flush to zero, denormals are zero
  const Body<float> small{.shape = Sphere<float>{tiny}}, moved{.position = {0, tiny, 0}},
      hull{.shape = Hull<float>{{0, 0, 0}, {1, 0, tiny}}}, plain{.shape = Sphere<float>{1}};
  const Invalid reasons[] = {cast(small, plain).invalid, cast(plain, moved).invalid,
                             cast(hull, plain).invalid, cast(plain, plain).invalid};
  _mm_setcsr(before);
  EXPECT_EQ(reasons[0], Invalid::out_of_range);
  EXPECT_EQ(reasons[1], Invalid::out_of_range);
  EXPECT_EQ(reasons[2], Invalid::out_of_range);
  EXPECT_EQ(reasons[3], Invalid::none);
  EXPECT_EQ(cast(small, plain).invalid, Invalid::none);
}
#endif

}  // namespace
}  // namespace graze
