// Every shape's support function against the definition of its set. The value h(n) comes from a formula that
// shares nothing with the code. The point is inside the set (m.x <= h(m) for many m) and greatest along n
// (n.x = h(n): then n is in the normal cone at x).
#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <graze/detail/pairs/cso.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using Wide = Eigen::Matrix<long double, 3, 1>;

template <Scalar S>
Wide wide(const Vec3<S>& x) {
  return x.template cast<long double>();
}

template <Scalar S>
Wide turn(const Quaternion<S>& q, const Wide& x, bool back) {
  const long double sign = back ? -1 : 1;
  const Wide u = sign * Wide(q.x, q.y, q.z);
  const long double w = q.w, norm = w * w + u.squaredNorm();
  return (x * (w * w - u.squaredNorm()) + 2 * u * u.dot(x) + 2 * w * u.cross(x)) / norm;
}

// h(n) with the ball.
template <Scalar S>
long double reach(const Shape<S>& shape, const Wide& n) {
  const auto most = [&](std::initializer_list<Vec3<S>> points) {
    long double out = -kInfinity<double>;
    for (const auto& x : points) out = std::max(out, wide(x).dot(n));
    return out;
  };
  const long double across = std::hypot(n[0], n[1]);
  return std::visit(
      detail::Overloaded{
          [](const Point<S>&) { return 0.0L; },
          [&](const Segment<S>& s) {
            return most({s.a, s.b});
          },
          [&](const Triangle<S>& s) {
            return most({s.a, s.b, s.c});
          },
          [&](const Sphere<S>& s) { return s.radius * n.norm(); },
          [&](const Capsule<S>& s) { return s.radius * n.norm() + s.half_height * std::abs(n[2]); },
          [&](const Box<S>& s) { return wide(s.half_extents).dot(n.cwiseAbs()); },
          [&](const Ellipsoid<S>& s) { return wide(s.radii).cwiseProduct(n).norm(); },
          [&](const Cylinder<S>& s) { return s.radius * across + s.half_height * std::abs(n[2]); },
          [&](const Cone<S>& s) {
            return std::max<long double>(s.half_height * n[2], s.radius * across - s.half_height * n[2]);
          },
          [&](const Hull<S>& s) {
            long double out = -kInfinity<double>;
            for (const auto& x : s.vertices()) out = std::max(out, wide(x).dot(n));
            return out;
          },
          [&](const Posed<S>& s) {
            return wide(s.position).dot(n) + reach<S>(s.shape->shape, turn(s.orientation, n, true));
          },
          [&](const Rounded<S>& s) { return reach<S>(s.shape->shape, n) + s.radius * n.norm(); },
          [&](const Sum<S>& s) {
            long double out = 0;
            for (const auto& part : s.shapes) out += reach<S>(part->shape, n);
            return out;
          },
          [&](const HullOf<S>& s) {
            long double out = -kInfinity<double>;
            for (const auto& part : s.shapes) out = std::max(out, reach<S>(part->shape, n));
            return out;
          }},
      shape);
}

template <Scalar S>
std::vector<Shape<S>> shapes() {
  const Quaternion<S> q{1, -2, 3, 5};
  const Shape<S> cone = Cone<S>{S(0.75), 2}, ball = Sphere<S>{S(0.5)};
  std::vector<Shape<S>> out = {
      Point<S>{},
      Segment<S>{{S(0.25), 1, 2}, {-1, S(0.5), 3}},
      Segment<S>{{1, 2, 3}, {1, 2, 3}},
      Triangle<S>{{0, 1, 2}, {3, S(-0.5), 1}, {1, 1, -2}},
      Sphere<S>{S(1.25)},
      Capsule<S>{S(0.5), 2},
      Capsule<S>{0, 1},
      Box<S>{{1, 2, S(0.125)}},
      Ellipsoid<S>{{1, 2, 3}},
      Ellipsoid<S>{{S(1e-6), 1, 1}},
      Ellipsoid<S>{{0, 1, 2}},
      Ellipsoid<S>{{0, 0, 1}},
      Cylinder<S>{1, S(0.25)},
      Cylinder<S>{1, 0},
      Cylinder<S>{0, 2},
      cone,
      Cone<S>{2, 0},
      Hull<S>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {S(0.1), S(0.1), S(0.1)}},
      posed<S>(cone, {1, -2, 3}, q),
      translated<S>(ball, {1024, 0, 0}),
      rounded<S>(cone, S(0.25)),
      swept<S>(Box<S>{{1, 1, 1}}, {2, S(0.5), 0}),
      sum<S>(cone, posed<S>(Ellipsoid<S>{{1, S(0.5), S(0.25)}}, {0, 0, 1}, q)),
      hull_of<S>(ball, translated<S>(Sphere<S>{2}, {3, 0, 0})),
      hull_of<S>(rounded<S>(Box<S>{{1, 1, 1}}, S(0.5)), posed<S>(Cylinder<S>{1, 1}, {0, 0, 4}, q)),
      posed<S>(
          rounded<S>(hull_of<S>(cone, sum<S>(ball, Triangle<S>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})), S(0.125)),
          {5, 5, 5}, {2, 1, 0, 0}),
  };
  return out;
}

template <class S>
class Support : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Support, Scalars);

TYPED_TEST(Support, IsInTheShapeAndGreatest) {
  using S = TypeParam;
  Draw draw{71};
  std::vector<Vec3<S>> directions;
  for (int i = 0; i < 3; ++i) {
    for (const S sign : {S(1), S(-1)}) directions.push_back(sign * Vec3<S>::Unit(i));
  }
  for (int i = 0; i < 300; ++i) directions.push_back(draw.vector<S>(1));
  directions.push_back(Vec3<S>(S(1e-20), 0, 1));
  directions.push_back(Vec3<S>(1, S(1e-12), S(-1e-12)));
  std::size_t index = 0;
  for (const Shape<S>& shape : shapes<S>()) {
    SCOPED_TRACE(index++);
    // A against a point at the origin: C = A.
    for (const bool rotated : {false, true}) {
      Body<S> a{.shape = shape}, b;
      if (rotated) a.orientation = draw.turn<S>();
      const detail::Cso<S> cso(a, b);
      // The ball's part rounds four times.
      const long double bound = cso.to_length(S(2) * cso.reach_error() + 4 * kUnitRoundoff<S> * cso.radius());
      EXPECT_LT(bound, 1500 * kUnitRoundoff<S> * 16);
      for (const Vec3<S>& n : directions) {
        const Vec3<S> e = unit(n);
        const detail::CsoPoint<S> p = cso.rounded_support(e);
        const Wide x = wide(Vec3<S>(p.w)) * std::ldexp(1.0L, cso.length_exponent());
        const auto h = [&](const Wide& m) { return reach<S>(shape, turn(a.orientation, m, true)); };
        EXPECT_LE(std::abs(x.dot(wide(e)) - h(wide(e))), bound) << e.transpose();
        for (std::size_t k = 0; k < directions.size(); k += 7) {
          const Wide m = wide(unit(directions[k]));
          EXPECT_LE(x.dot(m), h(m) + bound) << e.transpose() << " seen along " << m.transpose();
        }
        // The same point again, by its name.
        const auto again = cso.side_a().support(cso.side_a(), cso.side_a().to_own(p.n), &p.vertex_a);
        EXPECT_EQ(again.x, cso.side_a().support(cso.side_a(), cso.side_a().to_own(e), nullptr).x);
      }
    }
  }
}

// For a leaf that is a polytope, the support is never a bit below the greatest of its vertices, tied or not.
TYPED_TEST(Support, OfSmallPolytopesIsTheFirstOfTheGreatest) {
  using S = TypeParam;
  const std::array<Vec3<S>, 3> tie = {Vec3<S>(0, 0, 1), Vec3<S>(0, 0, 1), Vec3<S>(0, 0, -1)};
  EXPECT_EQ(detail::first_greatest<S>(tie, Vec3<S>(0, 0, 1)), 0u);
  EXPECT_EQ(detail::first_greatest<S>(tie, Vec3<S>(1, 0, 0)), 0u);
  EXPECT_EQ(detail::first_greatest<S>(tie, Vec3<S>(0, 0, -1)), 2u);
}

TEST(Combinators, OffsetsThatCancelCostNothing) {
  // A unit cone carried 2^40 out, and its body as far back.
  const double far = 0x1p40;
  const Shape<double> cone = Cone<double>{1, 1};
  const Body<double> plain{.shape = cone};
  const Body<double> carried{.shape = translated<double>(cone, {far, -far, far}),
                             .position = {-far, far, -far}};
  const Body<double> point{};
  const detail::Cso<double> near(plain, point), back(carried, point);
  Draw draw{72};
  for (int round = 0; round < 100; ++round) {
    const Vec3<double> n = unit(draw.vector<double>(1));
    EXPECT_NEAR(near.to_length(n.dot(near.support(n).w)), back.to_length(n.dot(back.support(n).w)), 1e-14);
  }
  EXPECT_EQ(near.scale(), back.scale());
}

TEST(Combinators, VertexNamesAreThoseOfTheParts) {
  const Shape<double> shape =
      hull_of<double>(sum<double>(Box<double>{{1, 1, 1}}, Segment<double>{{0, 0, 0}, {0, 0, 9}}),
                      translated<double>(Point<double>{}, {7, 0, 0}));
  EXPECT_EQ(detail::vertex_count(shape), 17u);
  detail::TreeWalk<double> up(Vec3<double>(0.1, 0.1, 1).normalized());
  EXPECT_EQ(up(shape, {}).vertex, 15u);  // corner 7, end 1: 7 * 2 + 1
  detail::TreeWalk<double> right(Vec3<double>(1, 0, 0));
  EXPECT_EQ(right(shape, {}).vertex, 16u);
}

}  // namespace
}  // namespace graze
