// Answers worked out by hand, and the exact oracle where both speak.
#include "oracles/truth/closed_form.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracles/truth/linear_truth.hpp"
#include "tests/oracles/truth/curved_pairs.hpp"

namespace graze::oracle {
namespace {

using Vec = Vec3<double>;

// A point from (x, y, z) along the displacement, against a shape at the origin.
corpus::Case ray(Shape<double> shape, const Vec& from, const Vec& along) {
  corpus::Case problem;
  problem.a.shape = std::move(shape);
  problem.b.shape = Point<double>{};
  problem.b.position = from;
  problem.b.displacement = along;
  return problem;
}

std::string exact_time(const corpus::Case& problem) {
  const auto form = ClosedForm::of(problem);
  if (!form) return "no closed form";
  if (form->outcome() == Outcome::miss) return "miss";
  return form->toi_exact();
}

TEST(ClosedForm, RayMeetsAnEllipsoidOnItsAxisAndBesideIt) {
  const Ellipsoid<double> e{Vec(1, 2, 4)};
  EXPECT_EQ(exact_time(ray(e, Vec(3, 0, 0), Vec(-4, 0, 0))), "1/2");
  EXPECT_EQ(exact_time(ray(e, Vec(3, 2, 0), Vec(-4, 0, 0))), "3/4") << "a graze at the pole is a contact";
  EXPECT_EQ(exact_time(ray(e, Vec(3, std::nextafter(2, 3), 0), Vec(-4, 0, 0))), "miss");
  const auto beside = ClosedForm::of(ray(e, Vec(3, 1, 0), Vec(-4, 0, 0)));  // x = sqrt(3)/2
  EXPECT_EQ(beside->toi_exact(), "");
  EXPECT_NEAR(beside->toi_lower(), (3 - std::sqrt(0.75)) / 4, 1e-15);
  EXPECT_EQ(beside->toi_upper(), std::nextafter(beside->toi_lower(), 1));
  EXPECT_EQ(beside->compare(beside->toi_lower()), -1);
  EXPECT_EQ(beside->compare(beside->toi_upper()), 1);
}

TEST(ClosedForm, RayMeetsACylinderOnItsSideItsCapAndItsRim) {
  const Cylinder<double> c{2, 3};
  EXPECT_EQ(exact_time(ray(c, Vec(6, 0, 1), Vec(-8, 0, 0))), "1/2");
  EXPECT_EQ(exact_time(ray(c, Vec(1, 1, 5), Vec(0, 0, -4))), "1/2");
  EXPECT_EQ(exact_time(ray(c, Vec(2, 0, 5), Vec(0, 0, -4))), "1/2") << "down along a generator";
  EXPECT_EQ(exact_time(ray(c, Vec(4, 0, 5), Vec(-4, 0, -4))), "1/2") << "across the rim";
  EXPECT_EQ(exact_time(ray(c, Vec(6, 0, 3), Vec(-8, 0, 0))), "1/2") << "sliding along the cap";
  EXPECT_EQ(exact_time(ray(c, Vec(6, 0, 3.0000000000000004), Vec(-8, 0, 0))), "miss");
  EXPECT_EQ(exact_time(ray(c, Vec(1, 1, 3), Vec(0, 0, 1))), "0");
}

TEST(ClosedForm, RayMeetsAConeAtItsApexOnItsSideAndOnItsBase) {
  const Cone<double> c{2, 2};  // apex (0, 0, 2), x^2 + y^2 = ((2 - z) / 2)^2
  EXPECT_EQ(exact_time(ray(c, Vec(0, 0, 4), Vec(0, 0, -4))), "1/2") << "the apex from above";
  EXPECT_EQ(exact_time(ray(c, Vec(-1, 0, 4), Vec(2, 0, -4))), "1/2") << "the apex, then along a generator";
  EXPECT_EQ(exact_time(ray(c, Vec(-2, 0, 2), Vec(4, 0, 0))), "1/2") << "a graze at the apex";
  EXPECT_EQ(exact_time(ray(c, Vec(5, 0, 0), Vec(-8, 0, 0))), "1/2");
  EXPECT_EQ(exact_time(ray(c, Vec(0.5, 0, -4), Vec(0, 0, 4))), "1/2");
  EXPECT_EQ(exact_time(ray(c, Vec(-5, 0, 4), Vec(10, 0, 0))), "miss") << "the mirror cone above is not there";
}

TEST(ClosedForm, RayMeetsADiskInItsPlane) {
  for (const Shape<double>& disk :
       {Shape<double>(Cone<double>{2, 0}), Shape<double>(Cylinder<double>{2, 0})}) {
    EXPECT_EQ(exact_time(ray(disk, Vec(6, 0, 0), Vec(-8, 0, 0))), "1/2");
    EXPECT_EQ(exact_time(ray(disk, Vec(2, -4, 0), Vec(0, 8, 0))), "1/2") << "a tangent";
    EXPECT_EQ(exact_time(ray(disk, Vec(1, 1, 4), Vec(0, 0, -8))), "1/2");
    EXPECT_EQ(exact_time(ray(disk, Vec(6, 0, 1), Vec(-8, 0, 0))), "miss");
    EXPECT_EQ(exact_time(ray(disk, Vec(1, 0, 0), Vec(-8, 0, 0))), "0");
  }
}

TEST(ClosedForm, BallMeetsABoxOnAFaceAnEdgeAndACorner) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.shape = Sphere<double>{1};
  problem.b.position = Vec(4, 0, 0);
  problem.b.displacement = Vec(-4, 0, 0);
  EXPECT_EQ(exact_time(problem), "1/2");
  problem.b.position = Vec(4, 1.8, 0);  // 0.8 beside the edge: x = 1 + 0.6
  const auto edge = ClosedForm::of(problem);
  EXPECT_NEAR(edge->toi_lower(), 0.6, 1e-15);
  problem.b.position = Vec(4, 2, 0);
  EXPECT_EQ(exact_time(problem), "3/4") << "touching the rounded edge";
  problem.b.position = Vec(4, 2, 1.0000000000000002);
  EXPECT_EQ(exact_time(problem), "miss") << "just beside the corner's ball";
}

TEST(ClosedForm, RefusesWhatIsNoQuadratic) {
  corpus::Case problem = ray(Ellipsoid<double>{Vec(1, 2, 4)}, Vec(9, 0, 0), Vec(-9, 0, 0));
  problem.target_distance = 1;
  EXPECT_FALSE(ClosedForm::of(problem)) << "an offset ellipsoid has degree 8";
  problem.target_distance = 0;
  problem.b.shape = Sphere<double>{1};
  EXPECT_FALSE(ClosedForm::of(problem));
  problem.b.shape = Box<double>{Vec(1, 1, 1)};
  EXPECT_FALSE(ClosedForm::of(problem));
}

// Points, spheres and boxes are the exact oracle's too: not a bit may differ.
TEST(ClosedForm, EqualsTheExactOracle) {
  CurvedPairs pairs(0x5eed);
  const std::array<std::array<Kind, 2>, 4> kinds = {{{Kind::sphere, Kind::sphere},
                                                     {Kind::box, Kind::sphere},
                                                     {Kind::point, Kind::box},
                                                     {Kind::sphere, Kind::point}}};
  std::array<int, 5> seen = {};
  for (int round = 0; round < 800; ++round) {
    const auto& kind = kinds[static_cast<std::size_t>(round) % kinds.size()];
    corpus::Case problem = pairs.pair(kind[0], kind[1]);
    if (pairs.random.once_in(4)) problem.target_distance = pairs.extent();
    const auto form = ClosedForm::of(problem);
    ASSERT_TRUE(form);
    const LinearTruth truth(problem);
    ASSERT_EQ(form->outcome(), truth.outcome()) << round;
    EXPECT_EQ(form->toi_lower(), truth.toi_lower()) << round;
    EXPECT_EQ(form->toi_upper(), truth.toi_upper()) << round;
    EXPECT_EQ(form->toi_exact(), truth.toi_exact()) << round;
    ++seen[static_cast<std::size_t>(form->outcome())];
  }
  for (const Outcome o : {Outcome::initially_overlapping, Outcome::hit, Outcome::miss}) {
    EXPECT_GT(seen[static_cast<std::size_t>(o)], 50);
  }
}

}  // namespace
}  // namespace graze::oracle
