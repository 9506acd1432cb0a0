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
