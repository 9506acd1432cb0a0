// far_own_frame_turning: bodies that lie 2^k out in their own frames, rotating and at rest. Positions bring
// them back, and the pivots are out there with them. Hardness: k.
//
// Half of them are any shapes that meet. The others are rods that come tip to tip. A rod turns about a point
// of its own through the line to the other rod, which rests on that line or comes through it at the same
// time. The tips pass at, or reach to, a few units in the last place of 2^k or a part of one, at least 2^-35.
// This is the accuracy of a body's reach when the size of its frame is ignored. Near that point, balls about
// the pivots are as close as the rods. Tips and pivots are the differences of doubles that far out, so the
// drawn values are exact to the rounding of a position, u 2^k.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/far_own_frame.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

// A rod from base to tip. A solid one is as thick along y and z. Two rods that are not solid lie in one
// plane, and meet without a depth.
Shape<double> rod(Draw& draw, const Vec3<double>& base, const Vec3<double>& tip, double thick, bool solid) {
  Random& random = draw.random;
  const Vec3<double> along(tip[0] - base[0], 0, 0);
  const Vec3<double> middle((base[0] + tip[0]) / 2, tip[1], tip[2]);
  switch (solid ? 3 + random.below(3) : random.below(3)) {
    case 0:
      return Segment<double>{base, tip};
    case 1:
      return Triangle<double>{base, tip, Vec3<double>(base[0], base[1] + thick, base[2])};
    case 2:
      return swept<double>(translated<double>(Point<double>{}, base), along);
    case 3:
      return hull_of<double>(translated<double>(Point<double>{}, base),
                             translated<double>(Box<double>{Vec3<double>(0, thick, thick)}, tip));
    case 4:
      return translated<double>(Box<double>{Vec3<double>(std::abs(along[0]) / 2, thick, thick)}, middle);
    default: {
      std::vector<Vec3<double>> list;
      for (const double x : {base[0], tip[0]}) {
        for (const double y : {-thick, thick}) {
          for (const double z : {-thick, thick}) list.emplace_back(x, tip[1] + y, tip[2] + z);
        }
      }
      return Hull<double>(std::span<const Vec3<double>>(list));
    }
  }
}

// A rod on the line through `pivot` along x, its tip at `side` times the returned reach from it, once turned
// about z by the turn that is still to come.
double place_rod(Draw& draw, Body<double>& body, Spin& spin, const Vec3<double>& offset, double side,
                 int exponent, bool solid) {
  Random& random = draw.random;
  const double length = random.uniform(1, 4), behind = random.uniform(-0.9, 0.9) * length;
  // Wide enough that a position's rounding does not make tips pass side by side. Thin enough that the ball
  // about a rod is larger than the rod by at most a unit in the last place, thick^2 / length.
  const int widest = std::clamp((exponent - 56) / 2, -20, -6);
  const double thick =
      std::scalbn(1.0, random.integer(std::min(widest, std::max(-30, exponent - 48)), widest));
  const Vec3<double> tip(offset[0] + side * length, offset[1], offset[2]),
      base(offset[0] - side * behind, offset[1], offset[2]);
  body.shape = rod(draw, base, tip, thick, solid);
  spin.pivot = offset;
  return side * (tip[0] - offset[0]);
}

void tip_to_tip(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double size = power_of_two(static_cast<int>(hardness));
  const int which = random.integer(0, 3);  // A, both, or, in half of them, B
  const auto offset = [&] {
    Vec3<double> out = far_offset(draw, size);
    if (!random.once_in(4)) out[0] = size * random.uniform(0.5, 1);  // along the rods
    return out;
  };
  const Vec3<double> out_a = which < 2 ? offset() : Vec3<double>::Zero();
  const Vec3<double> out_b = which != 0 ? offset() : Vec3<double>::Zero();
  const int exponent = static_cast<int>(hardness);
  const int solid = random.integer(0, 2);  // A, B, or both
  const double reach_a = place_rod(draw, problem.a, problem.spin_a, out_a, 1, exponent, solid != 1),
               reach_b = place_rod(draw, problem.b, problem.spin_b, out_b, -1, exponent, solid != 0);
  // From an eighth of a unit in the last place of 2^k to two of them. The middle of two vertices out there
  // loses half of a unit.
  const double fine = std::max(0x1p-35, power_of_two(exponent - 52 + random.integer(-4, 0)));
  const double gap = random.once_in(3) ? fine : -fine;

  // A comes through the line at this time, or leaves it at t = 0.
  const double t = meeting_time(draw) / 2;
  const bool later = !random.once_in(5);
  const auto come = [&](Body<double>& body, Spin& spin) {
    Quaternion<double> turn;
    turn.w = random.integer(1, 4);
    const int sine = random.integer(1, 4);
    turn.z = random.once_in(2) ? sine : -sine;
    const Vec3<double> rotation = rotation_vector(turn, 0);
    spin.rotation[2] = rotation[2] / t;
    if (later) body.orientation = {turn.w, 0, 0, -turn.z};
  };
  come(problem.a, problem.spin_a);
  if (!later && random.once_in(2)) problem.spin_a.rotation[2] /= 1024;
  // B rotates too, or it rests. Its pivot then has no meaning, wherever it is.
  if (random.once_in(3)) {
    come(problem.b, problem.spin_b);
  } else {
    if (random.once_in(2)) problem.spin_b.pivot = random.once_in(2) ? Vec3<double>::Zero() : draw.vector(8);
  }
  const Vec3<double> a = rotate(problem.a.orientation, out_a), b = rotate(problem.b.orientation, out_b);
  for (int i = 0; i < 3; ++i) {
    problem.a.position[i] = 0 - a[i];
    problem.b.position[i] = 0 - b[i];
  }
  // B's tip is exactly at the origin if B rests. A's tip has every digit of the gap if A is not far out.
  problem.a.position[0] = (0 - a[0]) - (reach_a + gap);
  problem.b.position[0] = reach_b - b[0];
}

void any_two(Draw& draw, double hardness, Case& problem, Coordinates kind) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  const double size = power_of_two(static_cast<int>(hardness));
  draw.coordinates = kind;
  problem.a.shape = any_shape(draw, kReach);
  problem.b.shape = any_shape(draw, kReach);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  for (Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    if (random.once_in(2)) spin->pivot = draw.vector(kReach);
  }
  Meeting meeting;
  meeting.t = meeting_time(draw);
  if (!random.once_in(3)) meeting.turn_a = some_turn(draw);
  if (meeting.turn_a.is_identity() || !random.once_in(3)) meeting.turn_b = some_turn(draw);
  const bool still = random.once_in(3);
  const Vec3<double> v = draw.vector(16);
  set_motion(draw, problem, still ? Vec3<double>::Zero() : v);
  draw.coordinates = Coordinates::doubles;  // a float has no digit left of 4 at 2^26
  const int which = random.integer(0, 3);
  if (which != 1) push_out(problem.a, problem.spin_a, far_offset(draw, size));
  if (which != 0) push_out(problem.b, problem.spin_b, far_offset(draw, size));
  meet(draw, problem, meeting, random.once_in(2) ? 0.25 : kReach);
}

void fill_far_own_frame_turning(Draw& draw, double hardness, Case& problem) {
  const Coordinates kind = draw.coordinates;
  draw.coordinates = Coordinates::doubles;
  if (draw.random.once_in(2)) {
    tip_to_tip(draw, hardness, problem);
    turn_exactly(draw, problem);
  } else {
    any_two(draw, hardness, problem, kind);
  }
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kFarOwnFrameTurningLevels[] = {10, 13, 16, 19, 22, 25, 28, 31, 34, 37, 40};

}  // namespace

const Family family::far_own_frame_turning{
    .name = "far_own_frame_turning",
    .sentence = "Rotating bodies that lie far out in their own frames meet near the origin.",
    .hardness_meaning = "k: they are about 2^k out, for shapes of size 4",
    .levels = kFarOwnFrameTurningLevels,
    .fill = fill_far_own_frame_turning,
    .rotating = true,
    .picture = {22, 1},
};

}  // namespace graze::corpus
