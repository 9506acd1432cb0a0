// How exact a turn is (turn.hpp), per range of angle, against balls: the quaternion, a point that it turns,
// the matrix that a placed body has.
#include <gtest/gtest.h>

#include <graze/detail/rotating/moving_pair.hpp>

#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze {
inline namespace GRAZE_LINKAGE {
namespace detail {

// The error that turn.hpp claims for an angle: its function for that type, or else the bound in its header.
template <class T>
double claimed_turn_error(T angle) {
  if constexpr (requires { turn_error(angle); }) {
    return turn_error(angle);
  } else {
    return 0x1p-90;
  }
}

}  // namespace detail
}  // namespace GRAZE_LINKAGE
}  // namespace graze

namespace graze::test {
namespace {

using detail::TwoDoubles;
using detail::TwoDoubles3;
using oracle::WorkingPrecision;

constexpr double kU = kUnitRoundoff<double>;

Ball exactly(const TwoDoubles& x) { return Ball(x.hi) + Ball(x.lo); }
BallVec exactly(const TwoDoubles3& x) { return {exactly(x[0]), exactly(x[1]), exactly(x[2])}; }
Ball cosine(const Ball& x) {
  Ball out;
  arb_cos(out.get(), x.get(), oracle::WorkingPrecision::bits());
  return out;
}

// Axes of every kind that the hostile draw has, of magnitudes 1e-57 to 1e57, and t so that |w| t is the
// angle.
struct DrawnTurn {
  Vec3<double> w;
  double t, angle;

  DrawnTurn(HostileDraw& draw, double low, double high) : angle(draw.power(low, high)) {
    w = draw.plain().vector<double>(1);
    switch (draw.below(4)) {
      case 0:
        w = Vec3<double>::Unit(static_cast<int>(draw.below(3)));
        break;
      case 1:
        w = {1, draw.nudged(1.0), draw.chance(0.5) ? 0.0 : 0x1p-55};
        break;
      case 2:
        w = {1, draw.power(-60, -20), draw.power(-150, 0)};
        break;
      default:
        break;
    }
    w *= draw.chance(0.5) ? 1.0 : draw.power(-150, 150);
    t = angle / w.norm();
    // Near multiples of a quarter turn little is left of the angle.
    if (draw.chance(0.3)) {
      const double quarter = 0x1.921fb54442d18p+0;
      t = std::max(1.0, std::floor(angle / quarter)) * quarter / w.norm();
      t = draw.nudged(t);
    }
    angle = w.norm() * t;
  }
};

void check_turns(const std::string& range, double low, double high, std::uint64_t seed) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(seed);
  Tally quaternion("Turn, " + range), point("Turn of a point, " + range),
      rounded_angle("rounded_sine_cosine, over u, " + range),
      rotation("TurnedRotation, an entry over 7 u, " + range);
  for (int i = 0; i < rounds(500); ++i) {
    const DrawnTurn drawn(draw, low, high);
    if (!(drawn.angle <= detail::kMostTurn)) continue;
    const auto with = [&] {
      std::ostringstream out;
      out << std::hexfloat << "  w " << describe(drawn.w) << " t " << drawn.t << "\n";
      return out.str();
    };
    const double claimed = detail::claimed_turn_error(drawn.angle);
    const detail::Turn turn = detail::TurnsAbout(drawn.w).at(drawn.t);
    const BallVec w(drawn.w);
    const Ball rate = norm(w), half = rate * Ball(drawn.t) / Ball(2);
    const Ball c = cosine(half);
    const BallVec s = (sine(half) / rate) * w;
    const BallVec off = exactly(turn.v) - s;
    quaternion.add(claimed, max(abs(exactly(turn.w) - c), norm(off)), with);

    const BallRotation truth(Ball(drawn.t) * w);
    const Vec3<double> x = draw.plain().vector<double>(1) * draw.power(-100, 100);
    const BallVec turned = truth.apply(BallVec(x));
    point.add(claimed, norm(exactly(turn(detail::exactly(x))) - turned) / norm(BallVec(x)), with);

    const detail::TurnsAbout turns(drawn.w);
    if (!turns.turns()) continue;
    const Ball angle = Ball(2) * half;
    const auto [sine_now, cosine_now] = detail::rounded_sine_cosine(turns.angle(drawn.t));
    rounded_angle.add(kU + claimed,
                      max(abs(Ball(sine_now) - sine(angle)), abs(Ball(cosine_now) - cosine(angle))), with);

    const Quaternion<double> q = draw.plain().turn<double>();
    const Mat3<double> matrix = detail::TurnedRotation(turns, detail::scaled_near_one(q)).at(turns, drawn.t);
    const BallRotation start(q);
    Ball most;
    for (int k = 0; k < 3; ++k) {
      const BallVec column = truth.apply(start.apply(BallVec(Vec3<double>(Vec3<double>::Unit(k)))));
      const BallVec away = BallVec(Vec3<double>(matrix.col(k))) - column;
      most = max(most, max(abs(away.x), max(abs(away.y), abs(away.z))));
    }
    rotation.add(7 * kU + claimed, most, with);
  }
  for (Tally* one : {&quaternion, &point, &rounded_angle, &rotation}) one->finish(200);
}

TEST(TurnBounds, OfLessThanARadian) { check_turns("below 1 radian", -60, 0, 31); }
TEST(TurnBounds, OfUpTo2To10Radians) { check_turns("2^0 to 2^10 radians", 0, 10, 32); }
TEST(TurnBounds, OfUpTo2To20Radians) { check_turns("2^10 to 2^20 radians", 10, 20, 33); }
TEST(TurnBounds, OfUpTo2To25Radians) { check_turns("2^20 to 2^25 radians", 20, 25, 34); }
TEST(TurnBounds, OfUpTo2To30Radians) { check_turns("2^25 to 2^30 radians", 25, 30, 35); }

// cso.hpp counts 11 u for each entry of the matrix that a body is placed with.
TEST(TurnBounds, AMatrixThatABodyIsPlacedWith) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(36);
  Tally entries("TurningSide::at, an entry over 11 u"), inverse("to_start after to_own, over 24 u");
  for (int i = 0; i < rounds(800); ++i) {
    const HostileScene scene = draw.scene();
    if (scene.a.rotation == Vec3<double>::Zero()) continue;
    const double t = draw.time(scene);
    const auto with = [&] { return describe(scene, Vec3<double>::Zero(), t); };
    detail::MovingPair pair(scene.a, scene.b, 0.0);
    pair.place(t);
    const BallRotation start(scene.a.body.orientation), turn(Ball(t) * BallVec(scene.a.rotation));
    Ball most;
    for (int k = 0; k < 3; ++k) {
      const Vec3<double> e = Vec3<double>::Unit(k);
      const BallVec off = BallVec(pair.to_world(AxisFrame::a, e)) - turn.apply(start.apply(BallVec(e)));
      most = max(most, max(abs(off.x), max(abs(off.y), abs(off.z))));
    }
    entries.add(11 * kU, most, with);
    // The axis at the start that a proof names is turned to where the pair has it, within 24 u each way.
    const Vec3<double> n = unit(draw.plain().vector<double>(1));
    const Vec3<double> named = pair.to_start(AxisFrame::a, pair.to_own(AxisFrame::a, n));
    inverse.add(48 * kU, norm(turn.apply(BallVec(named)) - BallVec(n)), with);
  }
  entries.finish(400);
  inverse.finish(400);
}

}  // namespace
}  // namespace graze::test
