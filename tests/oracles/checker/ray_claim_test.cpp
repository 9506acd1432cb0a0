// Claims about a point and an ellipsoid, a cylinder or a cone without axis and portal, by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "oracles/checker/check_proof.hpp"

namespace graze::oracle {
namespace {

using Vec = Vec3<double>;
constexpr double kNever = kInfinity<double>;

corpus::Case ray(Shape<double> shape, const Vec& from, const Vec& along) {
  corpus::Case problem;
  problem.a.shape = std::move(shape);
  problem.b.shape = Point<double>{};
  problem.b.position = from;
  problem.b.displacement = along;
  return problem;
}
Refusal claim(const corpus::Case& problem, double lower, double upper) {
  Proof proof;
  proof.toi_lower = lower;
  proof.toi_upper = upper;
  return check_proof(problem, proof).refusal;
}
double after(double t) { return std::nextafter(t, kNever); }
double before(double t) { return std::nextafter(t, 0.0); }

TEST(RayClaim, HoldsUpToTheContactAndFromItOn) {
  const Ellipsoid<double> egg{Vec(1, 2, 4)};
  const Cylinder<double> can{2, 3};
  const Cone<double> hat{2, 2};
  const struct {
    corpus::Case problem;
    double t;
  } all[] = {
      {ray(egg, Vec(3, 0, 0), Vec(-4, 0, 0)), 0.5},
      {ray(egg, Vec(3, 2, 0), Vec(-4, 0, 0)), 0.75},  // a tangent
      {ray(can, Vec(6, 0, 1), Vec(-8, 0, 0)), 0.5},
      {ray(can, Vec(2, 0, 5), Vec(0, 0, -4)), 0.5},    // down along a generator
      {ray(can, Vec(4, 0, 5), Vec(-4, 0, -4)), 0.5},   // across the rim
      {ray(can, Vec(6, 0, 3), Vec(-8, 0, 0)), 0.5},    // along the cap
      {ray(hat, Vec(0, 0, 4), Vec(0, 0, -4)), 0.5},    // the apex
      {ray(hat, Vec(1, 0, 2), Vec(-2, 0, 0)), 0.5},    // the apex, level
      {ray(hat, Vec(0, 0.5, 5), Vec(0, 0, -8)), 0.5},  // through the upper half of the double cone
  };
  for (const auto& [problem, t] : all) {
    EXPECT_EQ(claim(problem, t, t), Refusal::none) << problem.b.position.transpose();
    EXPECT_EQ(claim(problem, 0, 1), Refusal::none);
    EXPECT_EQ(claim(problem, after(t), kNever), Refusal::lower_not_proved);
    EXPECT_EQ(claim(problem, 1, kNever), Refusal::lower_not_proved);
    EXPECT_EQ(claim(problem, 0, before(t)), Refusal::upper_not_proved);
    EXPECT_EQ(claim(problem, kNever, kNever), Refusal::miss_not_proved);
    corpus::Case ends = problem;
    ends.t_max = before(t);
    EXPECT_EQ(claim(ends, kNever, kNever), Refusal::none);
    EXPECT_EQ(claim(ends, t, kNever), Refusal::none) << "nothing touches, so nothing touches before t";
    EXPECT_EQ(claim(ends, 0, 1), Refusal::upper_not_proved) << "contact after the end does not count";
    ends.t_max = t;
    EXPECT_EQ(claim(ends, t, t), Refusal::none);
    EXPECT_EQ(claim(ends, kNever, kNever), Refusal::miss_not_proved);
    EXPECT_EQ(claim(ends, 1, kNever), Refusal::miss_not_proved) << "at the end there is contact";
  }
}

TEST(RayClaim, HoldsAtTheStartAndForAMiss) {
  const Cylinder<double> can{2, 3};
  EXPECT_EQ(claim(ray(can, Vec(2, 0, 3), Vec(1, 0, 0)), 0, 0), Refusal::none);
  EXPECT_EQ(claim(ray(can, Vec(2, 0, 3), Vec(1, 0, 0)), before(1e-300), kNever), Refusal::lower_not_proved);
  EXPECT_EQ(claim(ray(can, Vec(after(2), 0, 3), Vec(1, 0, 0)), 0, 0), Refusal::upper_not_proved);
  EXPECT_EQ(claim(ray(can, Vec(after(2), 0, 3), Vec(1, 0, 0)), kNever, kNever), Refusal::none);
  EXPECT_EQ(claim(ray(can, Vec(6, 0, after(3)), Vec(-8, 0, 0)), kNever, kNever), Refusal::none);
  corpus::Case endless = ray(Cone<double>{2, 2}, Vec(1, 0, 5), Vec(0, 1, 0));
  endless.t_max = kNever;
  EXPECT_EQ(claim(endless, kNever, kNever), Refusal::none) << "the upper half of the double cone";
}

// What has no thickness is its slabs.
TEST(RayClaim, KnowsSolidsWithoutThickness) {
  for (const Shape<double>& rod : {Shape<double>(Cylinder<double>{0, 2}), Shape<double>(Cone<double>{0, 2}),
                                   Shape<double>(Ellipsoid<double>{Vec(0, 0, 2)})}) {
    EXPECT_EQ(claim(ray(rod, Vec(2, 0, 1), Vec(-4, 0, 0)), 0.5, 0.5), Refusal::none);
    EXPECT_EQ(claim(ray(rod, Vec(2, 0, 2), Vec(-4, 0, 0)), 0.5, 0.5), Refusal::none);
    EXPECT_EQ(claim(ray(rod, Vec(2, 0, after(2)), Vec(-4, 0, 0)), kNever, kNever), Refusal::none);
    EXPECT_EQ(claim(ray(rod, Vec(2, 1e-60, 1), Vec(-4, 0, 0)), kNever, kNever), Refusal::none);
  }
}

// Other pairs need an axis and a portal as before.
TEST(RayClaim, IsForNoOtherPair) {
  corpus::Case problem = ray(Ellipsoid<double>{Vec(1, 2, 4)}, Vec(9, 0, 0), Vec(-16, 0, 0));
  EXPECT_EQ(claim(problem, 0.5, 0.5), Refusal::none);
  problem.target_distance = 1;
  EXPECT_EQ(claim(problem, 0.25, kNever), Refusal::axis_missing);
  EXPECT_EQ(claim(problem, 0, 1), Refusal::portal_missing);
  problem.target_distance = 0;
  problem.b.shape = Sphere<double>{1};
  EXPECT_EQ(claim(problem, 0.25, kNever), Refusal::axis_missing);
  problem = ray(Box<double>{Vec(1, 1, 1)}, Vec(9, 0, 0), Vec(-16, 0, 0));
  EXPECT_EQ(claim(problem, 0.5, kNever), Refusal::axis_missing);
  EXPECT_EQ(claim(problem, 0, 0.5), Refusal::portal_missing);
}

}  // namespace
}  // namespace graze::oracle
