// A placed pair: where its bodies are, what it says of gaps and of how they change, and what the plan rests
// on (moving_pair.hpp, make_plan.hpp, spheres.hpp), against balls.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <graze/detail/rotating/make_plan.hpp>

#include "oracles/curved/ball_motion.hpp"
#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/describe.hpp"
#include "tests/bounds/in_float.hpp"
#include "tests/bounds/true_mobility.hpp"

namespace graze::test {
namespace {

using detail::MovingPair;
using oracle::BallMotion;
using oracle::WorkingPrecision;

constexpr double kU = kUnitRoundoff<double>;

struct Pair {
  MovingPair pair;
  Ball unit;  // internal length of one world length
  TrueBody a, b;

  explicit Pair(const HostileScene& scene) : Pair(scene.a, scene.b, scene) {}
  explicit Pair(const FloatScene& given) : Pair(given.a, given.b, given.scene) {}

  template <Scalar S>
  Pair(const RotatingBody<S>& given_a, const RotatingBody<S>& given_b, const HostileScene& scene)
      : pair(given_a, given_b, scene.target),
        unit(two_to(-pair.cso().length_exponent())),
        // A body that does not rotate is measured from the point that the pair takes for its pivot.
        a(scene.a, pair.pivot_a()),
        b(scene.b) {}

  [[nodiscard]] BallVec pivots() const { return unit * (b.pivot - a.pivot); }
  [[nodiscard]] BallVec velocity() const { return unit * (b.v - a.v); }
};

template <class Visit>
void for_each_pair(std::uint64_t seed, int scenes, const Visit& visit, long bits = kTruthBits) {
  const WorkingPrecision precision(bits);
  HostileDraw draw(seed);
  for (int i = 0; i < scenes; ++i) {
    const HostileScene scene = draw.scene();
    const std::optional<FloatScene> narrow = i % 3 == 0 ? FloatScene::of(scene) : std::nullopt;
    if (narrow) {
      Pair pair(*narrow);
      visit(pair, narrow->scene, draw);
    } else {
      Pair pair(scene);
      visit(pair, scene, draw);
    }
  }
}

// --- where the bodies are

// From A's pivot to the centre of a side, which lies at `center` in its body's own frame.
BallVec center_at(const TrueBody& body, const RotatingBody<double>& given, const Vec3<double>& center,
                  const Ball& t) {
  const BallVec own = body.orientation.apply(BallVec(center) - BallVec(given.pivot));
  return body.turn(t).apply(own) +
         (BallVec(given.body.position) + body.orientation.apply(BallVec(given.pivot)) + t * body.v);
}

TEST(PairBounds, TheBodiesAreWhereTheyArePlaced) {
  Tally offset("offset_error, of the offset"), centers("offset_error, of the centres");
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(11);
  for (int i = 0; i < rounds(1500); ++i) {
    HostileScene scene = draw.scene();
    const double then = draw.time(scene);
    if (draw.chance(0.5)) {
      // The centres meet at that time, within the rounding of doubles: the offset is the remainder of the
      // arms.
      const Pair before(scene);
      const Ball t(then);
      const BallVec apart = center_at(before.a, scene.a, before.pair.cso().side_a().center, t) -
                            center_at(before.b, scene.b, before.pair.cso().side_b().center, t);
      scene.b.body.position += apart.mid_double();
      if (!(scene.b.body.position.cwiseAbs().maxCoeff() <= 1e60)) continue;
    }
    Pair seen(scene);
    MovingPair& pair = seen.pair;
    const Vec3<double>&c_a = pair.cso().side_a().center, &c_b = pair.cso().side_b().center;
    for (int k = 0; k < 3; ++k) {
      const double t = k == 0 ? 0 : k == 1 ? then : draw.time(scene);
      pair.place(t);
      const auto with = [&] { return describe(scene, Vec3<double>::Zero(), t); };
      const BallVec a = center_at(seen.a, scene.a, c_a, t), b = center_at(seen.b, scene.b, c_b, t);
      const BallVec path = seen.a.pivot_at(t);
      const auto far_off = [&](const Vec3<double>& placed, const BallVec& truth) {
        return norm(BallVec(placed) - seen.unit * truth);
      };
      offset.add(2 * kU * pair.cso().offset().norm() + pair.offset_error(),
                 far_off(pair.cso().offset(), b - a), with);
      // At the start no arm counts for the offset, but the arms of the centres count.
      if (t == 0) continue;
      centers.add(2 * kU * pair.center_a().norm() + pair.offset_error(), far_off(pair.center_a(), a - path),
                  with);
      centers.add(2 * kU * pair.center_b().norm() + pair.offset_error(), far_off(pair.center_b(), b - path),
                  with);
    }
  }
  offset.finish(500);
  centers.finish(500);
}

// --- gaps

// s(n, t), internal, over |n|.
Ball true_gap(const BallMotion& a, const BallMotion& b, const Pair& seen, const BallVec& n, double t,
              double target) {
  const Ball apart = a.support(n, t).reach + b.support(-n, t).reach;
  return seen.unit * (-apart / norm(n) - Ball(target));
}

TEST(PairBounds, NoGapIsWiderThanItIs) {
  Tally error("MovingPair::error, of gap(n)"), frame("MovingPair::frame_error, of a turned axis");
  for_each_pair(12, rounds(600), [&](Pair& seen, const HostileScene& scene, HostileDraw& draw) {
    const Vec3<double>& reference = scene.a.body.position;
    const BallMotion a(scene.a.body, {scene.a.rotation, scene.a.pivot}, reference);
    const BallMotion b(scene.b.body, {scene.b.rotation, scene.b.pivot}, reference);
    MovingPair& pair = seen.pair;
    Counters counters;
    for (int k = 0; k < 3; ++k) {
      const Vec3<double> n = draw.direction(scene);
      const double t = draw.time(scene);
      const auto with = [&] { return describe(scene, n, t); };
      pair.place(t);
      const Ball raw = Ball(pair.gap(n, counters)) + Ball(pair.error());
      error.add(pair.error(), abs(raw - true_gap(a, b, seen, BallVec(n), t, scene.target)), with);

      const AxisFrame of = draw.chance(0.5) ? AxisFrame::a : AxisFrame::b;
      const Vec3<double> own = pair.to_own(of, n), start = pair.to_start(of, own);
      const double later = draw.time(scene);
      pair.place(later);
      const Ball turned = Ball(pair.gap(pair.to_world(of, own), counters)) + Ball(pair.error());
      const BallVec axis = (of == AxisFrame::a ? seen.a : seen.b).turn(later).apply(BallVec(start));
      frame.add(pair.error() + pair.frame_error(of),
                positive_part(turned - true_gap(a, b, seen, axis, later, scene.target)), [&] {
                  return describe(scene, n, later) + (of == AxisFrame::a ? "  with A\n" : "  with B\n");
                });
    }
  });
  error.finish(500);
  frame.finish(200);
}

// --- how gaps change

// When both bodies rotate by the same w, the sum of both bodies' speeds has another bound: |n x w| times the
// largest distance of a difference of points from its axis.
Ball least_of(const Ball& each, const Ball& across, const std::optional<Ball>& common) {
  return common ? min(each, across * *common) : each;
}

TEST(PairBounds, NoGapClosesFaster) {
  Tally closing("MovingPair::closing"), bend("MovingPair::bend(n)"), top_bend("MovingPair::top_bend"),
      top_speed("MovingPair::top_speed");
  int common_turns = 0;
  for_each_pair(13, rounds(1200), [&](Pair& seen, const HostileScene& scene, HostileDraw& draw) {
    const TrueMobility a(seen.a, scene.a, seen.pair.pivot_a(), seen.unit),
        b(seen.b, scene.b, scene.b.pivot, seen.unit);
    std::optional<Ball> common;
    if (seen.a.turns && scene.a.rotation == scene.b.rotation) {
      ++common_turns;
      common = Ball(0);
      for (const BallVec& x : seen.a.arms) {
        for (const BallVec& y : seen.b.arms)
          common = max(*common, seen.unit * norm(cross(a.w(), y - x)) / a.rate());
      }
    }
    for (int k = 0; k < 4; ++k) {
      const Vec3<double> n = draw.direction(scene);
      const BallVec along(n);
      const auto with = [&] { return describe(scene, n, 0); };
      const Ball across = norm(cross(along, a.w()));
      closing.add(seen.pair.closing(n),
                  least_of(a.speed(along) + b.speed(along), across, common) - dot(along, seen.velocity()),
                  with);
      bend.add(seen.pair.bend(n),
               least_of(a.acceleration(along) + b.acceleration(along), a.rate() * across, common), with);
    }
    const auto with = [&] { return describe(scene); };
    top_bend.add(seen.pair.top_bend(),
                 least_of(a.top_acceleration() + b.top_acceleration(), a.rate() * a.rate(), common), with);
    top_speed.add(seen.pair.top_speed(),
                  least_of(a.top_speed() + b.top_speed(), a.rate(), common) + norm(seen.velocity()), with);
  });
  for (Tally* one : {&closing, &bend, &top_bend, &top_speed}) one->finish(500);
  EXPECT_GE(common_turns, rounds(20));
}

// Points of both bodies where they are: the slope of n.(x_B - x_A), and how it changes, by differences.
TEST(PairBounds, NoTwoPointsCloseFaster) {
  Tally closing("MovingPair::closing, of points"), bend("MovingPair::bend(n), of points"),
      common("MovingPair::bend(n), of points that turn alike");
  for_each_pair(
      17, rounds(800),
      [&](Pair& seen, HostileScene scene, HostileDraw& draw) {
        // Half of them rotate alike, as few do by chance.
        const bool alike = draw.chance(0.5) && seen.a.turns;
        if (alike) scene.b.rotation = scene.a.rotation;
        const Pair pair(scene);
        if (!(pair.a.turns && pair.b.turns)) return;
        const Vec3<double> n = draw.direction(scene);
        const BallVec along(n), &x = pair.a.arms[draw.below(pair.a.arms.size())],
                                &y = pair.b.arms[draw.below(pair.b.arms.size())];
        const auto height = [&](const Ball& t) {
          return dot(along,
                     pair.unit * (pair.b.turn(t).apply(y) - pair.a.turn(t).apply(x)) + t * pair.velocity());
        };
        const Ball d = two_to(-200), t(scene.t_end * draw.plain().between(0.01, 0.99));
        const auto with = [&] { return describe(scene, n, t.mid_double()); };
        const Ball before = height(t - d), now = height(t), after = height(t + d);
        // Skip solids of revolution: their bounds hold for the set, and their points may move faster.
        if (revolves(scene.a.body.shape) || revolves(scene.b.body.shape)) return;
        closing.add(pair.pair.closing(n), (before - after) / (d + d), with);
        (alike ? common : bend).add(pair.pair.bend(n), abs(after - Ball(2) * now + before) / (d * d), with);
      },
      kDifferenceBits);
  closing.finish(100);
  bend.finish(50);
  common.finish(50);
}

// How fast points of the one body move in the axes of the other, where the pair says so.
template <class P>
std::optional<double> relative_speed(const P& pair, AxisFrame of, double t_end) {
  if constexpr (requires { pair.relative_speed(of, t_end); }) {
    return pair.relative_speed(of, t_end);
  } else {
    return std::nullopt;
  }
}

// The header's formula, and the first and the second difference of n(t).x(t) for points of the other body.
TEST(PairBounds, NoGapAlongATurnedAxisBendsMore) {
  Tally formula("MovingPair::bend(frame)"), seen_bend("MovingPair::bend(frame), of points"),
      speeds("MovingPair::relative_speed, of points");
  bool says_speed = false;
  for_each_pair(
      14, rounds(600),
      [&](Pair& seen, const HostileScene& scene, HostileDraw& draw) {
        for (const AxisFrame of : {AxisFrame::a, AxisFrame::b}) {
          const bool with_a = of == AxisFrame::a;
          // The pivot that stands for a B at rest is not to be had.
          if (with_a && !seen.b.turns) continue;
          const TrueBody &with = with_a ? seen.a : seen.b, &other = with_a ? seen.b : seen.a;
          const BallVec c = with_a ? seen.pivots() : -seen.pivots(),
                        v = with_a ? seen.velocity() : -seen.velocity();
          const Vec3<double> n = draw.direction(scene);
          const auto inputs = [&] { return describe(scene, n, 0) + (with_a ? "  with A\n" : "  with B\n"); };
          const double bound = seen.pair.bend(of, n, scene.t_end);
          const BallVec along(n);
          formula.add(bound,
                      norm(other.w - with.w) * (with.rate + other.rate) * seen.unit * other.reach() +
                          norm(cross(with.w, along)) * (Ball(2) * norm(v) + norm(cross(with.w, c)) +
                                                        norm(cross(with.w, v)) * Ball(scene.t_end)),
                      inputs);
          const BallVec& arm = other.arms[draw.below(other.arms.size())];
          const auto place = [&](const Ball& t) {
            return with.turn(t).apply_inverse(seen.unit * other.turn(t).apply(arm) + c + t * v);
          };
          const auto height = [&](const Ball& t) { return dot(along, place(t)); };
          const Ball d = two_to(-200), t(scene.t_end * draw.plain().between(0.01, 0.99));
          const Ball bent = height(t + d) - Ball(2) * height(t) + height(t - d);
          seen_bend.add(bound, abs(bent) / (d * d), inputs);
          if (const auto speed = relative_speed(seen.pair, of, scene.t_end)) {
            says_speed = true;
            speeds.add(*speed, norm(place(t + d) - place(t - d)) / (d + d), inputs);
          }
        }
      },
      kDifferenceBits);
  formula.finish(300);
  seen_bend.finish(300);
  if (says_speed) speeds.finish(300);
}

// The second difference of n(t).(x_B - x_A) for points of both bodies, n moving evenly in the axes of the world or of a
// body from one direction to another.
TEST(PairBounds, NoGapAlongAnAxisThatMovesBendsMore) {
  Tally world("MovingPair::bend_between, of the world"), turned("MovingPair::bend_between, of a body"),
      change("MovingPair::axis_change");
  for_each_pair(
      18, rounds(600),
      [&](Pair& seen, const HostileScene& scene, HostileDraw& draw) {
        const double t_0 = draw.time(scene), t_1 = draw.time(scene);
        if (!(t_0 < t_1)) return;
        const Vec3<double> n_0 = draw.direction(scene), elsewhere = draw.direction(scene);
        const Ball h = Ball(t_1) - Ball(t_0), d = h * two_to(-100);
        const Ball t = Ball(t_0) + h * Ball(draw.plain().between(0.01, 0.99));
        for (const AxisFrame of : {AxisFrame::world, AxisFrame::a, AxisFrame::b}) {
          const bool in_world = of == AxisFrame::world, with_a = of == AxisFrame::a;
          const TrueBody &with = with_a ? seen.a : seen.b, &other = with_a ? seen.b : seen.a;
          // The pivot that stands for a B at rest is not to be had.
          if (in_world ? revolves(scene.a.body.shape) || revolves(scene.b.body.shape)
                       : !with.turns || (with_a && !seen.b.turns))
            continue;
          // Half of them rotate with the body, so that little except the rotation bends.
          Vec3<double> n_1 = elsewhere;
          if (!in_world && draw.chance(0.5)) {
            seen.pair.place(t_0);
            const Vec3<double> own = seen.pair.to_own(of, n_0);
            seen.pair.place(t_1);
            n_1 = seen.pair.to_world(of, own);
          }
          const auto inputs = [&] { return describe(scene, n_0, t_0) + describe(scene, n_1, t_1); };
          const auto in_frame = [&](const Vec3<double>& n, double at) {
            return in_world ? BallVec(n) : with.turn(Ball(at)).apply_inverse(BallVec(n));
          };
          const BallVec m_0 = in_frame(n_0, t_0), m_1 = in_frame(n_1, t_1);
          const double changed = seen.pair.axis_change(of, n_0, t_0, n_1, t_1);
          change.add(changed, norm(m_1 - m_0), inputs);
          const BallVec& x = seen.a.arms[draw.below(seen.a.arms.size())];
          const BallVec& y = seen.b.arms[draw.below(seen.b.arms.size())];
          const BallVec c = with_a ? seen.pivots() : -seen.pivots(),
                        v = with_a ? seen.velocity() : -seen.velocity();
          const auto height = [&](const Ball& at) {
            const BallVec m = m_0 + ((at - Ball(t_0)) / h) * (m_1 - m_0);
            if (in_world)
              return dot(m, seen.unit * (seen.b.turn(at).apply(y) - seen.a.turn(at).apply(x)) +
                                seen.pivots() + at * seen.velocity());
            // A point of the frame's own body adds what is linear in t.
            return dot(m, with.turn(at).apply_inverse(seen.unit * other.turn(at).apply(with_a ? y : x) + c +
                                                      at * v));
          };
          const Ball bent = height(t + d) - Ball(2) * height(t) + height(t - d);
          (in_world ? world : turned)
              .add(seen.pair.bend_between(of, n_0, t_0, n_1, t_1, scene.t_end), abs(bent) / (d * d), inputs);
        }
      },
      kDifferenceBits);
  world.finish(50);
  turned.finish(200);
  change.finish(300);
}

// --- the plan

// Bodies that rotate and move alike stand still relative to each other, except for the swing of the
// difference of their pivots.
TEST(PlanBounds, BodiesThatTurnAsOneSwingNoFarther) {
  Tally swing("swing_as_one");
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(15);
  for (int i = 0; i < rounds(3000); ++i) {
    HostileScene scene = draw.scene();
    if (scene.a.rotation == Vec3<double>::Zero()) continue;
    scene.b.rotation = scene.a.rotation;
    scene.b.body.displacement = scene.a.body.displacement;
    const Pair seen(scene);
    const BallVec c = seen.pivots();
    const Ball off = norm(cross(seen.a.w, c)) / seen.a.rate;
    swing.add(detail::swing_as_one(seen.pair, scene.t_end), seen.a.chord(scene.t_end) * off,
              [&] { return describe(scene); });
  }
  swing.finish(1000);
}

// Orients B so that its arm, at time t, points against A's: as near as the pivots allow the bodies to meet.
void turn_against(RotatingBody<double>& b, const Vec3<double>& arm_a_then, const Vec3<double>& arm_b_then,
                  const BallRotation& turn_b) {
  const auto eigen = [](const Mat3<double>& m) { return Eigen::Quaterniond(m).normalized(); };
  const Eigen::Quaterniond spun = eigen(turn_b.mid_double());
  const Eigen::Quaterniond start = eigen(detail::rotation_matrix(b.body.orientation));
  const auto onto = Eigen::Quaterniond::FromTwoVectors(arm_b_then, Vec3<double>(-arm_a_then));
  const Eigen::Quaterniond q = spun.conjugate() * onto * spun * start;
  b.body.orientation = {q.w(), q.x(), q.y(), q.z()};
}

const BallVec& longest(const std::vector<BallVec>& arms) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < arms.size(); ++i) {
    if (mid_less(norm(arms[best]), norm(arms[i]))) best = i;
  }
  return arms[best];
}

// B is put where its farthest point is at A's at some time t. Then the spheres meet, not later than t.
TEST(PlanBounds, SpheresMeetNoLaterThanTheBodies) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(16);
  int wrong = 0, met_late = 0, near = 0, moving = 0;
  std::string failures;
  for (int i = 0; i < rounds(3000); ++i) {
    HostileScene scene = draw.scene();
    const double t = draw.time(scene);
    const bool aligned = draw.chance(0.7);
    // A body that does not turn is bounded about a point of the pair's choice: the arms that count are its
    // own.
    const Vec3<double> pivot_a = MovingPair(scene.a, scene.b, 0.0).pivot_a();
    const Vec3<double> pivot_b = MovingPair(scene.b, scene.a, 0.0).pivot_a();
    const TrueBody a(scene.a, pivot_a);
    TrueBody b(scene.b, pivot_b);
    const BallVec arm_a = longest(a.arms);
    if (aligned) {
      turn_against(scene.b, a.turn(t).apply(arm_a).mid_double(),
                   b.turn(t).apply(longest(b.arms)).mid_double(), b.turn(t));
      b = TrueBody(scene.b, pivot_b);
    }
    const BallVec arm_b = longest(b.arms);
    scene.b.body.position += (a.place(arm_a, t) - b.place(arm_b, t)).mid_double();
    if (!(scene.b.body.position.cwiseAbs().maxCoeff() <= 1e60)) continue;
    b = TrueBody(scene.b, pivot_b);
    const MovingPair pair(scene.a, scene.b, scene.target);
    const Ball unit = two_to(-pair.cso().length_exponent());
    const Ball radii = radius_of(scene.a.body.shape) + radius_of(scene.b.body.shape) + Ball(scene.target);
    const Ball apart = norm(a.place(arm_a, t) - b.place(arm_b, t));
    const double more = std::max(0.0, (unit * (apart - radii)).high_double());
    const double t_end = draw.chance(0.3) ? kInfinity<double> : scene.t_end;
    const detail::SphereCast spheres = detail::cast_spheres(pair, t_end, more);
    near += !(pair.pivots().norm() <= 0.999 * (pair.mobility_a().reach + pair.mobility_b().reach));
    moving += spheres.meet && spheres.begin > 0;
    wrong += !spheres.meet;
    met_late += spheres.meet && !(spheres.begin <= t);
    if ((!spheres.meet || !(spheres.begin <= t)) && wrong + met_late <= 3) {
      std::ostringstream out;
      out << std::hexfloat << "meet " << spheres.meet << " begin " << spheres.begin << " more " << more
          << " t_end " << t_end << "\n";
      failures += out.str() + describe(scene, Vec3<double>::Zero(), t);
    }
  }
  std::printf("spheres: %d near, %d begin later than 0\n", near, moving);
  EXPECT_EQ(wrong, 0) << failures;
  EXPECT_EQ(met_late, 0) << failures;
  EXPECT_GT(near, rounds(300));
  EXPECT_GT(moving, rounds(100));
}

}  // namespace
}  // namespace graze::test
