// Tests the claims of cso.hpp about its support points: their distance from the points that they stand for,
// how far they are below the greatest, and the errors of their heights. The claims are compared with balls,
// in double and in float, with quick and with accurate rotation. The draw includes combinators far out and
// rotated back, curved leaves, and hulls far out.
#include <gtest/gtest.h>

#include <graze/detail/pairs/cso.hpp>

#include "oracles/curved/ball_motion.hpp"
#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using oracle::BallMotion;
using oracle::WorkingPrecision;

// A body at t = 0 and the radius of its ball.
struct Standing {
  BallMotion motion;
  Ball radius;
  bool curved;

  Standing(const Body<double>& body, const Vec3<double>& reference)
      : motion(body, {}, reference),
        radius(radius_of(body.shape)),
        curved(detail::is_curved<double>(body.shape)) {}

  // max n.x over the core
  [[nodiscard]] Ball height(const BallVec& n) const {
    return motion.support(n, Ball(0)).reach - radius * norm(n);
  }
  [[nodiscard]] BallVec vertex(std::uint32_t k) const {
    return motion.at(Ball(0)).place(motion.named({.vertex = k}));
  }
};

template <Scalar S>
void check_cso(const std::string& name, detail::Turning turning, std::uint64_t seed) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(seed);
  Tally point("Cso::point_error, " + name), inside("Cso::point_error, of the set, " + name),
      choice("Cso::choice_error, " + name), reach("Cso::reach_error, " + name),
      extent("Cso::extent, " + name);
  for (int i = 0; i < rounds(600); ++i) {
    const HostileScene scene = draw.scene();
    // Beyond the range of floats the bounds are those of double.
    if (sizeof(S) == 4 && scene.is(Hostile::mixed_magnitudes)) continue;
    const Body<double>&a = scene.a.body, &b = scene.b.body;
    const detail::Cso<S> cso(a, b, 0.0, turning);
    const Ball unit = two_to(-cso.length_exponent());
    const Standing of_a(a, a.position), of_b(b, a.position);
    for (int k = 0; k < 3; ++k) {
      // For half of the directions, two vertices of A tie to within rounding.
      const std::uint64_t count = detail::vertex_count<double>(a.shape);
      Vec3<double> chosen = draw.direction(scene);
      if (!of_a.curved && count > 1 && draw.chance(0.5)) {
        const auto any = [&] { return of_a.vertex(static_cast<std::uint32_t>(draw.below(count))); };
        const BallVec edge = any() - any();
        const BallVec across = cross(edge, BallVec(chosen));
        if (norm(across).is_positive()) chosen = graze::unit(unit_of(across).mid_double());
      }
      const Vec3<S> n = chosen.template cast<S>();
      const BallVec along(n.template cast<double>());
      const auto with = [&] { return describe(scene, n.template cast<double>(), 0); };
      const detail::CsoPoint<S> found = cso.support(n);
      const BallVec w(found.w.template cast<double>());
      const Ball length = norm(along), highest = unit * (of_a.height(along) + of_b.height(-along));
      reach.add(cso.reach_error(), abs(dot(along, w) - highest) / length, with);
      extent.add(cso.extent() * (1 + 8 * kUnitRoundoff<S>)+cso.point_error(), norm(w), with);
      // A point of C is below C's height in every direction.
      const Vec3<double> m = draw.direction(scene);
      const BallVec other(m);
      const Ball above = dot(other, w) - unit * (of_a.height(other) + of_b.height(-other));
      inside.add(double(cso.point_error()) * 0x1.bb67ae8584cabp+0, positive_part(above / norm(other)), with);
      if (of_a.curved || of_b.curved) continue;
      const BallVec truth = unit * (of_a.vertex(found.vertex_a) - of_b.vertex(found.vertex_b)),
                    off = w - truth;
      point.add(cso.point_error(), max(abs(off.x), max(abs(off.y), abs(off.z))), with);
      choice.add(cso.choice_error(), (highest - dot(along, truth)) / length, with);
    }
  }
  point.finish(300);
  inside.finish(100);
  choice.finish(20);
  reach.finish(500);
  extent.finish(500);
}

TEST(CsoBounds, SupportPointsInDouble) { check_cso<double>("double", detail::Turning::quick, 51); }
TEST(CsoBounds, SupportPointsInDoubleAccuratelyTurned) {
  check_cso<double>("double, accurate", detail::Turning::accurate, 52);
}
TEST(CsoBounds, SupportPointsInFloat) { check_cso<float>("float", detail::Turning::quick, 53); }

}  // namespace
}  // namespace graze::test
