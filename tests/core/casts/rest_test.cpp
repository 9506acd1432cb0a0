// Bodies at rest in the certified tier. A ball, a capsule, a rounded box, a cylinder, a cone or an ellipsoid
// lies on a plane face, placed so that they touch exactly, and one unit in the last place on either side.
//
// The scene is made of integers and then rotated by an integer quaternion q, with all lengths times |q|^2, so
// that every number is a double (or float) and every tie stays exact. The expected verdict is known by
// construction.
#include <gtest/gtest.h>

#include <cmath>
#include <graze/cast.hpp>
#include <graze/detail/search/exact/exact_start.hpp>
#include <graze/distance.hpp>
#include <string>

#include "tests/shared/generate.hpp"

namespace {

using namespace graze;
using test::Draw;
using Q = Quaternion<double>;
using V = Vec3<double>;

Q product(const Q& a, const Q& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
// q p q', of length |q|^2 |p|.
V turned(const Q& q, const V& p) {
  const Q out = product(product(q, {0, p[0], p[1], p[2]}), {q.w, -q.x, -q.y, -q.z});
  return {out.x, out.y, out.z};
}

enum class Motion { none, slides, leaves, enters };

template <Scalar S>
struct Scene {
  Body<S> floor, body;
  std::string name;
  int ulps = 0;  // of the size that touches: below 0 apart, above 0 in contact
  Motion motion = Motion::none;
  S target_distance = 0;
};

template <Scalar S>
class RestingScenes {
 public:
  explicit RestingScenes(std::uint64_t seed) : draw_{seed} {}

  Scene<S> next() {
    Scene<S> out;
    q_ = integer(3) == 0 ? Q{} : Q{offset(3), offset(3), offset(3), offset(3)};
    size_ = q_.w * q_.w + q_.x * q_.x + q_.y * q_.y + q_.z * q_.z;
    if (size_ == 0) return next();
    const double wide = 5 + integer(15);
    out.floor = placed(floor(wide), V(0, 0, 0), {});
    out.ulps = integer(2) - 1;
    const auto touching = [&](double x) -> S {
      const S exact = scaled(x);
      return out.ulps == 0 ? exact : std::nextafter(exact, out.ulps > 0 ? kInfinity<S> : S(0));
    };
    const double r = 1 + integer(5), h = 1 + integer(5), x = 0.25 * wide * offset(1),
                 y = 0.25 * wide * offset(1);
    static constexpr Q kYaw[] = {{1, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, -1}};
    static constexpr Q kLie[] = {{1, 1, 0, 0}, {1, -1, 0, 0}, {1, 0, 1, 0}};
    const Q flip{0, 1, 0, 0}, yaw = kYaw[integer(3)], lie = product(yaw, kLie[integer(2)]);
    double height = h;
    Q own = yaw;
    Shape<S> shape;
    switch (integer(8)) {
      case 0:
        out.name = "ball";
        shape = Sphere<S>{touching(r)};
        height = r;
        break;
      case 1:
        out.name = "capsule";
        shape = Capsule<S>{touching(r), scaled(h)};
        own = lie;
        height = r;
        break;
      case 2:
        out.name = "rounded box";
        shape = rounded<S>(Box<S>{point(1, 2, h)}, touching(r));
        height = r + h;
        break;
      case 3:
        out.name = "standing cylinder";
        shape = Cylinder<S>{scaled(r), touching(h)};
        break;
      case 4:
        out.name = "lying cylinder";
        shape = Cylinder<S>{touching(r), scaled(h)};
        own = product(lie, kYaw[integer(3)]);
        height = r;
        break;
      case 5:
        out.name = "standing cone";
        shape = Cone<S>{scaled(r), touching(h)};
        break;
      case 6:
        out.name = "cone on its tip";
        shape = Cone<S>{scaled(r), touching(h)};
        own = product(yaw, flip);
        break;
      case 7:
        out.name = "ellipsoid";
        shape = Ellipsoid<S>{Vec3<S>(scaled(1 + integer(4)), scaled(1 + integer(4)), touching(h))};
        break;
      default:
        out.name = "cylinder at a distance";
        shape = Cylinder<S>{scaled(r), touching(h)};
        out.target_distance = scaled(1);
        height = h + 1;
    }
    out.body = placed(shape, V(x, y, height), own);
    out.motion = static_cast<Motion>(integer(3));
    const V v = out.motion == Motion::none     ? V(0, 0, 0)
                : out.motion == Motion::slides ? V(1, offset(2), 0)
                : out.motion == Motion::leaves ? V(offset(1), 0, 1)
                                               : V(offset(2), offset(2), -1);
    out.body.displacement = turned(q_, v).template cast<S>();
    return out;
  }

 private:
  int integer(int most) { return static_cast<int>(draw_.bits() % static_cast<std::uint64_t>(most + 1)); }
  double offset(int most) { return integer(2 * most) - most; }
  S scaled(double x) const { return static_cast<S>(x * size_); }
  Vec3<S> point(double x, double y, double z) const { return Vec3<S>(scaled(x), scaled(y), scaled(z)); }
  // With its upper face in the plane z = 0.
  Shape<S> floor(double wide) {
    switch (integer(2)) {
      case 0:
        return translated<S>(Box<S>{point(wide, wide, 2)}, point(0, 0, -2));
      case 1:
        return Triangle<S>{point(-2 * wide, -wide, 0), point(2 * wide, -wide, 0), point(0, 2 * wide, 0)};
      default:
        return Hull<S>{point(-wide, -wide, 0), point(wide, -wide, 0), point(2 * wide, wide, 0),
                       point(0, 2 * wide, 0),  point(-wide, wide, 0), point(0, 0, -3)};
    }
  }
  Body<S> placed(const Shape<S>& shape, const V& at, const Q& own) const {
    const Q q = product(q_, own);
    return {.shape = shape,
            .position = turned(q_, at).template cast<S>(),
            .orientation = {S(q.w), S(q.x), S(q.y), S(q.z)}};
  }

  Draw draw_;
  Q q_;
  double size_ = 1;
};

template <Scalar S>
void judge_resting(std::uint64_t seed, StartPolicy policy) {
  RestingScenes<S> scenes(seed);
  int contacts = 0, misses = 0, hits = 0;
  for (int i = 0; i < 1500; ++i) {
    const Scene<S> scene = scenes.next();
    const bool swapped = i % 2 != 0;
    CastOptions<S> options{.tier = Tier::certified, .target_distance = scene.target_distance};
    options.start_policy = policy;
    if (i % 3 == 0) options.request = Request::everything;
    const auto result = cast(swapped ? scene.body : scene.floor, swapped ? scene.floor : scene.body, options);
    const bool enters = scene.motion == Motion::enters;
    // Deep: past touching, or the bodies themselves are apart and the target distance does not count for leaving.
    const bool deep = scene.ulps > 0 && !(scene.target_distance > 0);
    const Outcome expected = scene.ulps < 0 ? enters ? Outcome::hit : Outcome::miss
                             : policy == StartPolicy::report || deep || enters
                                 ? Outcome::initially_overlapping
                                 : Outcome::miss;
    EXPECT_EQ(result.outcome, expected) << scene.name << ", ulps " << scene.ulps << ", case " << i;
    EXPECT_EQ(result.toi_upper == 0, expected == Outcome::initially_overlapping);
    EXPECT_EQ(result.passed_over, scene.ulps >= 0 && expected == Outcome::miss)
        << scene.name << ", case " << i;
    contacts += expected == Outcome::initially_overlapping;
    misses += expected == Outcome::miss;
    hits += expected == Outcome::hit;
  }
  EXPECT_GT(contacts, 200);
  EXPECT_GT(misses, 200);
  EXPECT_GT(hits, 50);
}

TEST(CertifiedRest, ATouchIsContactAndAUnitInTheLastPlaceDecides) {
  judge_resting<double>(1, StartPolicy::report);
  judge_resting<float>(2, StartPolicy::report);
}
TEST(CertifiedRest, ATouchThatSlidesOrLeavesIsPassedOver) {
  judge_resting<double>(3, StartPolicy::pass_over);
  judge_resting<float>(4, StartPolicy::pass_over);
}

// Round bodies on edges and corners, side by side and stacked: 3-4-5 and 2-3-6 placements.
TEST(CertifiedRest, EdgesCornersAndPairsOfRoundBodies) {
  const Body<double> box{.shape = Box<double>{{8, 8, 1}}, .position = {0, 0, -1}};
  const Body<double> cylinder{.shape = Cylinder<double>{0.5, 1}};
  const Body<double> ellipsoid{.shape = Ellipsoid<double>{{0.5, 1, 2}}};
  const auto at = [](const Shape<double>& shape, const V& position, const Q& q = {}) {
    return Body<double>{.shape = shape, .position = position, .orientation = q};
  };
  const std::pair<Body<double>, Body<double>> touching[] = {
      {box, at(Sphere<double>{5}, {11, 1, 4})},
      {box, at(Sphere<double>{7}, {10, 11, 6})},
      {box, at(Cylinder<double>{5, 1}, {11, 0, 4}, {1, 1, 0, 0})},
      {box, at(Cylinder<double>{0.5, 1}, {0, 8.75, 0.5}, {1, 1, 0, 0})},  // half of it over the face
      {box, at(Cylinder<double>{0.5, 1}, {8.25, 0, 1})},                  // its middle past the edge
      {box, at(Cylinder<double>{0.5, 1}, {8.5, 0, 1})},                   // its rim on the edge
      {box, at(Cylinder<double>{5, 5}, {0, 0, 7}, {3, 1, 0, 0})},         // on a point of its rim
      {cylinder, at(Cylinder<double>{1, 1}, {1.25, 0, 2})},
      {cylinder, at(Cylinder<double>{1, 1}, {1.5, 0, 0.5})},
      {cylinder, at(Cylinder<double>{1, 1}, {0, 1.5, 0}, {1, 0, 1, 0})},
      {at(Cylinder<double>{5, 1}, {0, 0, 0}), at(Sphere<double>{5}, {8, 0, 5})},
      {at(Cone<double>{6, 4}, {0, 0, 0}), at(Sphere<double>{5}, {7, 0, 3})},
      {ellipsoid, at(Sphere<double>{1}, {0, 0, 3})},
      {ellipsoid, at(Ellipsoid<double>{{1, 3, 1}}, {0, 4, 0})},
  };
  int number = 0;
  for (const auto& [a, b] : touching) {
    ++number;
    EXPECT_EQ(cast(a, b, {.tier = Tier::certified}).outcome, Outcome::initially_overlapping) << number;
    EXPECT_EQ(cast(b, a, {.tier = Tier::certified}).outcome, Outcome::initially_overlapping) << number;
    // Away along the motion by one unit in the last place, which the sums of doubles may take for the same place.
    Body<double> away = b;
    for (int i = 0; i < 3; ++i) {
      if (b.position[i] != 0) away.position[i] = std::nextafter(b.position[i], 100 * b.position[i]);
    }
    const Outcome apart = cast(a, away, {.tier = Tier::certified}).outcome;
    EXPECT_TRUE(apart == Outcome::miss || apart == Outcome::not_converged) << number << ' ' << to_text(apart);
  }
}

// Report: a cylinder falls past the edge of a box at a clearance of 9e-16, and the lower end was 0, where they are 1 apart.
TEST(CertifiedOpen, ATieOnTheWayIsNearContactAtItsLowerEnd) {
  const Body<double> box{.shape = Box<double>{{1, 1, 0.5}}};
  int open = 0;
  for (const double past : {0.0, 0x1p-52, 0x1p-50, -0x1p-50, 0x1p-46}) {
    for (const Q& q : {Q{}, Q{1, 1, 0, 0}, Q{3, 0, 0, 1}}) {
      const Body<double> cylinder{.shape = Cylinder<double>{0.5, 0.5},
                                  .position = {1.5 + past, 0.25, 2},
                                  .orientation = q,
                                  .displacement = {0, 0, -2.5}};
      const auto result = cast(box, cylinder, {.tier = Tier::certified});
      if (result.outcome != Outcome::not_converged) continue;
      ++open;
      Body<double> then = cylinder;
      then.position += result.toi_lower * cylinder.displacement;
      EXPECT_LE(distance(box, then).lower, 4e-12) << past;
      EXPECT_LE(result.distance, 4e-12) << past;
      EXPECT_NEAR(result.normal.norm(), 1, 1e-15) << past;
      EXPECT_LE((result.point_a - result.point_b).norm(), 1e-11) << past;
      EXPECT_NEAR(result.point_a[0], 1, 1e-11) << past;
    }
  }
  EXPECT_GT(open, 3);
}

// ---- the arithmetic ----

TEST(ExactStart, RootsAreRoundedUpAndExactOnSquares) {
  Draw draw{5};
  for (int i = 0; i < 2000; ++i) {
    detail::exact::Dyadic root(draw.between(0.5, 1) *
                               std::ldexp(1.0, static_cast<int>(draw.bits() % 200) - 100));
    for (int k = static_cast<int>(draw.bits() % 4); k > 0; --k)
      root = root * detail::exact::Dyadic(draw.between(0.5, 1));
    const detail::exact::Dyadic square = root * root;
    EXPECT_EQ((detail::root_up(square) - root).sign(), 0) << i;
    const detail::exact::Dyadic other =
        square + detail::exact::Dyadic(1).times_power_of_two(square.order() - 150);
    const detail::exact::Dyadic above = detail::root_up(other), less = above - above.times_power_of_two(-249);
    EXPECT_GE((above * above - other).sign(), 0) << i;
    EXPECT_LT((less * less - other).sign(), 0) << i;
  }
}

// Roots of squares: the sum is rational, and so is its sign.
TEST(ExactStart, TheSignOfASumOfRootsIsExact) {
  Draw draw{6};
  int zeros = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto any = [&] { return static_cast<double>(draw.bits() % 8); };
    const double x = any(), y = any(), z = any(), whole = -any() - any() - any();
    const auto square = [](double root) { return detail::exact::Dyadic(root) * detail::exact::Dyadic(root); };
    bool valid = true;
    const double sum = x + y + z + whole;
    zeros += sum == 0;
    EXPECT_EQ(detail::sign_of_root_sum(detail::exact::Dyadic(whole), square(x), square(y), square(z), valid),
              (sum > 0) - (sum < 0));
    // sqrt(2) x + sqrt(8) y against sqrt(2) z: by a root of one square more.
    const auto twice = [&](double root) { return detail::exact::Dyadic(2) * square(root); };
    const double irrational = std::sqrt(2.0) * (x + 2 * y) + whole;
    if (std::abs(irrational) > 1e-9) {
      EXPECT_EQ(detail::sign_of_root_sum(detail::exact::Dyadic(whole), twice(x), twice(2 * y), valid),
                irrational > 0 ? 1 : -1);
    }
    EXPECT_TRUE(valid);
  }
  EXPECT_GT(zeros, 100);
}

}  // namespace
