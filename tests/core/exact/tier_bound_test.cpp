// The bounds of the pairs of doubles, measured: a vector's coordinates and a determinant, against the same in
// exact numbers, where rounding is worst (full mantissas, turned bodies, nested poses, what cancels).
#include <gtest/gtest.h>

#include <graze/exact/scene.hpp>

#include "tests/shared/generate.hpp"

namespace graze::exact {
namespace {

using test::Draw;

// |x| as a double, within a unit in the last place; below the range of doubles: 0.
double magnitude_of(const Dyadic& x) {
  return x.sign() == 0 ? 0 : std::ldexp(std::abs(x.leading()), std::max(x.order(), -2000));
}
Dyadic exactly(const Pair& x) { return Dyadic(x.hi) + Dyadic(x.lo); }

Shape<double> nested(Draw& draw, int levels) {
  Shape<double> shape = draw.hull<double>(6, 1);
  for (int i = 0; i < levels; ++i) {
    shape =
        posed<double>(std::move(shape), draw.vector<double>(i % 2 == 0 ? 4 : 0x1p-20), draw.turn<double>());
  }
  return shape;
}

struct Worst {
  double coordinate = 0, determinant = 0;  // over the size, or the product of the sizes
  int judged = 0;
};

Worst measure(int rounds, int levels, bool turned) {
  Draw draw{static_cast<std::uint64_t>(77 + levels)};
  Worst worst;
  for (int round = 0; round < rounds; ++round) {
    Body<double> a, b;
    a.shape = nested(draw, levels);
    b.shape = nested(draw, levels);
    if (turned) {
      a.orientation = draw.turn<double>();
      b.orientation = draw.turn<double>();
    }
    a.position = draw.vector<double>(round % 3 == 0 ? 1000 : 1);
    // Far away and back again: what is added cancels.
    b.position = round % 3 == 0 ? Vec3<double>(a.position + draw.vector<double>(1)) : draw.vector<double>(1);
    a.displacement = draw.vector<double>(1);
    b.displacement = draw.vector<double>(1);
    const Scene<double> scene(a, b, 0, 0);
    const auto vertex = [&] {
      const auto one = [&] { return static_cast<std::uint32_t>(draw.bits() % 6); };
      const std::uint32_t of_a = one(), of_b = one();
      return Vertex{of_a, of_b};
    };
    const Vertex c = vertex(), d = vertex(), e = vertex();
    const Term terms[] = {Term::point(c), Term::difference(c, d), Term::difference(c, e), Term::motion()};
    Fine fine[4];
    Exact exact[4];
    for (std::size_t i = 0; i < 4; ++i) {
      fine[i] = scene.fine(terms[i]);
      exact[i] = scene.exact(terms[i]);
      if (!(fine[i].size > 0)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Dyadic difference = exactly(fine[i].x[k]) - exact[i].x[k];
        if (!difference.valid()) continue;
        const double error = magnitude_of(difference);
        worst.coordinate = std::max(worst.coordinate, error / fine[i].size);
      }
    }
    for (std::size_t last : {0u, 3u}) {
      const Fine &x = fine[last], &y = fine[1], &z = fine[2];
      const double size = x.size * y.size * z.size;
      if (!(size > 0)) continue;
      const Dyadic value = exactly(dot(x.x, cross(y.x, z.x)));
      const Dyadic truth = dot(exact[last].x, cross(exact[1].x, exact[2].x));
      // Nested deeper than exact numbers reach: such a case is refused.
      const Dyadic difference = value - truth;
      if (!difference.valid()) continue;
      ++worst.judged;
      worst.determinant = std::max(worst.determinant, magnitude_of(difference) / size);
    }
  }
  return worst;
}

// A filter decides nothing wrongly as long as this holds. Measured: at most 2^-102 and 2^-104, so the bounds
// give away 10 and 17 bits.
TEST(FineBound, HoldsForEveryNesting) {
  for (const bool turned : {false, true}) {
    for (const int levels : {0, 1, 2, 4, 8}) {
      SCOPED_TRACE(std::to_string(levels) + (turned ? " levels in turned bodies" : " levels"));
      const Worst worst = measure(2000, levels, turned);
      EXPECT_LE(worst.coordinate, 0x1p-92);
      EXPECT_LE(worst.determinant, Scene<double>::kFineError);
      if (levels <= 4) {
        EXPECT_GT(worst.judged, 2000);
        EXPECT_GT(worst.determinant, 0x1p-118);  // pairs do round here
      }
    }
  }
}

}  // namespace
}  // namespace graze::exact
