// The certified tier claims nothing, consistently, about a start that can neither be proved nor refuted.
// Another rare case is a target distance that is the whole scale.
#include <gtest/gtest.h>

#include <graze/cast.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

// Multiples of a quarter, so that many pairs touch.
class Lattice {
 public:
  explicit Lattice(Draw& draw) : draw_(draw) {}

  Body<double> body(double far) {
    Body<double> out{.shape = shape(), .position = vector(far), .displacement = vector(4)};
    return out;
  }

 private:
  double length() { return std::max(std::round(draw_.between(0.25, 1) * 4) / 4, 0.25); }
  V vector(double size) { return (draw_.vector<double>(size) * 2).array().round() / 2; }
  Shape<double> shape() {
    switch (draw_.bits() % 6) {
      case 0:
        return Sphere<double>{length()};
      case 1:
        return Cylinder<double>{length(), length()};
      case 2:
        return Cone<double>{length(), length()};
      case 3:
        return rounded<double>(Box<double>{{length(), length(), length()}}, length());
      case 4:
        return Ellipsoid<double>{{length(), length(), length()}};
      default:
        return hull_of<double>(Sphere<double>{length()},
                               translated<double>(Sphere<double>{length()}, vector(1)));
    }
  }
  Draw& draw_;
};

// Curved bodies that touch to the last bit, or by a target distance: whether they leave is open for some.
TEST(CertifiedRare, AnOpenStartIsNoVerdict) {
  Draw draw{241};
  Lattice lattice(draw);
  int open = 0, over = 0;
  for (int round = 0; round < 6000; ++round) {
    const Body<double> a = lattice.body(1), b = lattice.body(1.5);
    CastOptions<double> options{.tier = Tier::certified, .request = Request::everything};
    options.start_policy = StartPolicy::pass_over;
    if (round % 2) options.target_distance = 0.25;
    const auto r = cast(a, b, options);
    ASSERT_NE(r.outcome, Outcome::invalid_input);
    EXPECT_EQ(r.outcome == Outcome::initially_overlapping, r.toi_upper == 0) << round;
    if (r.outcome == Outcome::not_converged) {
      open += r.toi_lower == 0;
      EXPECT_LT(r.toi_lower, r.toi_upper) << round;
    }
    over += r.passed_over;
  }
  EXPECT_GT(open, 0);
  EXPECT_GT(over, 100);
}

// A cone slides away less than an ulp above the face on which it lay. No single axis in doubles proves that it misses.
TEST(CertifiedRare, AMissTakesTwoAxes) {
  const Body<double> a{.shape = Cone<double>{53.84095857943612, 12.741834333164661},
                       .position = {-155.18773739691824, -358.52762623876333, 501.54029722325504},
                       .orientation = {8, 4, 8, 14},
                       .displacement = {482.57136208847123, 781.3868139017786, -1223.2647818336675}};
  const Body<double> b{.shape = Box<double>{{85.35170483682305, 106.19389363564551, 20.842188798822463}},
                       .position = {14.712133269757032, 9.808088846504688, 11.034099952317774},
                       .orientation = {0, -3, -2, 2},
                       .displacement = {106.33296174839093, 43.565614156838805, -65.77251494028076}};
  EXPECT_EQ(cast_certified(a, b).outcome, Outcome::miss);
}

// A cone slides onto a face and off again, in its plane. The portal that proves contact has an upper end past the face.
TEST(CertifiedRare, AnUpperEndPastTheFaceIsNoHit) {
  const Body<double> a{.shape = Cone<double>{65.390625, 43.59375},
                       .position = {475.4765625, -31.857421875, 922.79296875},
                       .orientation = {-45, -17, -25, 11},
                       .displacement = {-993.375, 173.25, -1911.65625}};
  const Body<double> b{.shape = Box<double>{{195.1875, 221.958984375, 26.771484375}},
                       .position = {20.822265625, -11.8984375, -11.8984375},
                       .orientation = {-2, -1, 2, 3}};
  const auto r = cast_certified(a, b, {.t_max = kInfinity<double>});
  EXPECT_EQ(r.outcome, Outcome::not_converged);
  // The face begins at 709/2048. The cone's radius of curvature is about 18 there: a gap of the width, 1.01e-9, is met
  // sqrt(2 18 1.01e-9) / |v| = 8.8e-8 before.
  EXPECT_LE(r.toi_lower, 709.0 / 2048);
  EXPECT_GT(r.toi_lower, 709.0 / 2048 - 8.8e-8);
  EXPECT_LT(r.distance, 1e-9);
}

// A line of the cone's side slides onto the face of a rounded box. GJK alone ends 5e-11 from contact.
TEST(CertifiedRare, AnOpenAnswerIsWithinTheWidth) {
  const Body<double> a{.shape = Cone<double>{2.355029149912305, 1.5700194332748687},
                       .position = {5.3020726554095745, 40, 0.9420116599649191},
                       .orientation = {5, -8, 10, 4},
                       .displacement = {-10.604145310819149, -80, 0}};
  const Body<double> b{
      .shape = rounded<double>(Box<double>{{3.6934535121545196, 1.8992714053019881, 1.8658279683440924}},
                               2.5188741823658347),
      .position = {0, 0, -4.384702150709927}};
  const auto r = cast_certified(a, b);
  // The oracle's time. A gap of the width, 4e-11, is met sqrt(2 2.5 4e-11) / |v| = 1.8e-7 before, over the rounding of
  // radius 2.5, and the search ends nearer.
  EXPECT_LE(r.toi_lower, 0.44370992234223444);
  EXPECT_GT(r.toi_lower, 0.44370992234223444 - 1e-8);
  EXPECT_LE(r.distance, 40.08 * kLinearCertifiedWidth);
}

// Points as near as the domain has them, and target distances up to its end: cubes of their ratio would
// overflow.
TEST(CertifiedRare, ATargetDistanceFarBeyondTheBodiesIsContact) {
  for (const double margin : {1.0, 0x1p101, 0x1p150, 0x1p199}) {
    for (const double apart : {0x1p-199, 0x1p-192, 0x1p-100, 0x1p-10}) {
      const Body<double> a{.shape = Point<double>{}}, b{.shape = Point<double>{}, .position = {0, 0, apart}};
      const auto r = cast(a, b, {.tier = Tier::certified, .target_distance = margin});
      EXPECT_EQ(r.outcome, Outcome::initially_overlapping) << margin << " " << apart;
    }
  }
}

// Round and curved bodies in each other, at rest or not, whatever symmetry the line has: four points around
// the origin, or a portal at s <= 0 on either side. Nothing is refined without a request for it.
TEST(CertifiedRare, BodiesInEachOtherCostFewSupports) {
  const std::vector<Shape<double>> shapes = {
      Sphere<double>{1},        Capsule<double>{0.5, 1}, Ellipsoid<double>{{1, 0.5, 0.75}},
      Cylinder<double>{0.5, 1}, Cone<double>{1, 1},      rounded<double>(Box<double>{{0.5, 0.25, 1}}, 0.25)};
  for (const Shape<double>& shape : shapes) {
    for (const double apart : {0.0, 0.0625, 0.5}) {
      for (const V& v : {V(0, 0, 0), V(1, 0, 0), V(1, 2, 3)}) {
        const Body<double> a{.shape = shape};
        const Body<double> b{.shape = shape, .position = {apart, 0, 0}, .displacement = v};
        const auto r = cast_certified(a, b, CastOptions<double>{.tier = Tier::certified});
        EXPECT_EQ(r.outcome, Outcome::initially_overlapping) << shape.index() << ' ' << apart;
        EXPECT_LE(r.counters.supports, 200) << shape.index() << ' ' << apart << ' ' << v.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace graze
