// Along an axis that moves, no gap is farther below its chord than bend_of_supports() says (support_bend.hpp). The
// reference is supports in balls.
#include <gtest/gtest.h>

#include <graze/detail/rotating/support_bend.hpp>

#include "oracles/curved/ball_motion.hpp"
#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using detail::MovingPair;
using oracle::BallMotion;
using oracle::WorkingPrecision;

constexpr AxisFrame kFrames[] = {AxisFrame::world, AxisFrame::a, AxisFrame::b};

// Two boxes that rotate about a corner of A, which is on a side of B.
HostileScene hinge(Draw& draw) {
  HostileScene scene;
  const Vec3<double> a(draw.between(0.5, 2), draw.between(0.5, 2), draw.between(0.5, 2)),
      b(draw.between(0.5, 2), draw.between(0.5, 2), draw.between(0.5, 2));
  scene.a = {
      .body = {.shape = Box<double>{a}, .position = a}, .rotation = draw.vector<double>(3), .pivot = -a};
  const double side = draw.between(-b[0], b[0]);
  scene.b = {.body = {.shape = Box<double>{b}, .position = {-side, 0, -b[2]}},
             .rotation = draw.bits() % 2 == 0 ? Vec3<double>(Vec3<double>::Zero()) : draw.vector<double>(3),
             .pivot = {side, 0, b[2]}};
  return scene;
}

TEST(SupportBendBounds, NoGapAlongAMovingAxisIsFartherBelowItsChord) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(76);
  Draw& plain = draw.plain();
  int count = 0, wrong = 0, hinges = 0, less_than_points = 0;
  std::string failures;
  for (int i = 0; i < rounds(3000); ++i) {
    const bool hinged = draw.chance(0.4);
    const HostileScene scene = hinged ? hinge(plain) : draw.scene();
    MovingPair pair(scene.a, scene.b, scene.target);
    const AxisFrame frame = kFrames[plain.bits() % 3];
    const double fast = std::max({pair.mobility_a().rate, pair.mobility_b().rate, 1 / scene.t_end});
    const double t_0 = scene.t_end * plain.between(0, 0.5),
                 h = std::min(std::pow(10, -plain.between(0, 7)) / fast, scene.t_end / 2), t_1 = t_0 + h;
    const Vec3<double> n_0 =
                           hinged
                               ? graze::unit(Vec3<double>(plain.vector<double>(0.3) - Vec3<double>::UnitZ()))
                               : draw.direction(scene),
                       n_1 = graze::unit(Vec3<double>(n_0 + plain.vector<double>(h * fast)));
    const Vec3<double> contact = hinged ? Vec3<double>(Vec3<double>::Zero()) : plain.vector<double>(1);
    Counters counters;
    const double k = bend_of_supports(pair, frame, n_0, t_0, n_1, t_1, contact, counters);
    if (!(k < kInfinity<double>) || !(t_0 < t_1)) continue;
    const double error = pair.frame_error(frame);
    pair.place(t_0);
    const double s_0 = pair.gap(n_0, counters) - error;
    pair.place(t_1);
    const double s_1 = pair.gap(n_1, counters) - error;
    const Vec3<double>& reference = scene.a.body.position;
    const BallMotion a(scene.a.body, {scene.a.rotation, scene.a.pivot}, reference);
    const BallMotion b(scene.b.body, {scene.b.rotation, scene.b.pivot}, reference);
    const auto own_of = [&](const BallMotion::Pose& pose, const Vec3<double>& n) {
      return pose.turn_back(BallVec(n));
    };
    const Ball begin(t_0), end(t_1);
    // The axis at t = 0 in the frame's axes: at both ends, as it is there.
    const BallVec start = frame == AxisFrame::a   ? own_of(a.at(begin), n_0)
                          : frame == AxisFrame::b ? own_of(b.at(begin), n_0)
                                                  : BallVec(n_0),
                  stop = frame == AxisFrame::a   ? own_of(a.at(end), n_1)
                         : frame == AxisFrame::b ? own_of(b.at(end), n_1)
                                                 : BallVec(n_1);
    ++count;
    hinges += hinged ? 1 : 0;
    less_than_points +=
        hinged && k < pair.bend_between(frame, n_0, t_0, n_1, t_1, scene.t_end) * h * h / 16 ? 1 : 0;
    for (const double part : {0.0, 0.125, 0.25, 0.5, plain.between(0, 1), 0.875, 1.0}) {
      const Ball tau(part), t = begin + tau * (end - begin);
      const BallMotion::Pose of_a = a.at(t), of_b = b.at(t);
      const BallVec m = start + tau * (stop - start);
      const BallVec n = frame == AxisFrame::a ? of_a.turn(m) : frame == AxisFrame::b ? of_b.turn(m) : m;
      const Ball gap = (-(of_a.support(n).reach + of_b.support(-n).reach) - Ball(scene.target)) *
                       two_to(-pair.cso().length_exponent());
      const Ball least =
          Ball(s_0) + tau * (Ball(s_1) - Ball(s_0)) - Ball(4) * tau * (Ball(1) - tau) * Ball(k);
      if (!certainly_less(gap, least)) continue;
      if (++wrong <= 3) {
        std::ostringstream out;
        out << "  frame " << static_cast<int>(frame) << " part " << part << " h " << h << " gap "
            << gap.mid_double() << " bound " << least.mid_double() << " k " << k << "\n";
        failures += out.str() + describe(scene, n_0, t_0);
      }
    }
  }
  std::printf("bend_of_supports: %d axes, %d of hinges, %d of these with less than the points' bound\n",
              count, hinges, less_than_points);
  EXPECT_EQ(wrong, 0) << failures;
  EXPECT_GE(count, rounds(1500));
  EXPECT_GE(less_than_points, hinges / 10);
}

}  // namespace
}  // namespace graze::test
