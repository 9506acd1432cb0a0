#include "corpus/families/turning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/support_value.hpp"

namespace graze::corpus {
namespace {

// atan x for x >= 0. The angle is halved three times by tan(a/2) = tan a / (1 + sqrt(1 + tan^2 a)), to 0.2 at
// most. The first omitted term is below 0.2^27 / 27, 2^-67.
double arc_tangent(double x) {
  for (int i = 0; i < 3; ++i) x = x / (1 + std::sqrt(1 + x * x));
  const double square = x * x;
  double series = 0;
  for (int k = 25; k >= 1; k -= 2) series = 1.0 / k - square * series;
  return 8 * (x * series);
}

Vec3<double> plus(const Vec3<double>& l, const Vec3<double>& r) {
  return {l[0] + r[0], l[1] + r[1], l[2] + r[2]};
}
Vec3<double> minus(const Vec3<double>& l, const Vec3<double>& r) {
  return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}
Vec3<double> times(double s, const Vec3<double>& x) { return {s * x[0], s * x[1], s * x[2]}; }

// The place of the body's point x at the meeting, less its position at t = 0.
Vec3<double> carried(const Body<double>& body, const Spin& spin, const Quaternion<double>& turn, double t,
                     const Vec3<double>& x) {
  const Vec3<double> pivot = rotate(body.orientation, spin.pivot);
  const Vec3<double> arm = minus(rotate(body.orientation, x), pivot);
  return plus(plus(rotate(turn, arm), pivot), times(t, body.displacement));
}

}  // namespace

double angle_of(const Quaternion<double>& q) {
  const double side = std::sqrt((q.x * q.x + q.y * q.y) + q.z * q.z);
  // Swapped above 45 degrees, so that no quotient is above 1.
  const double w = std::abs(q.w);
  const double half = side <= w ? arc_tangent(side / w) : kPi / 2 - arc_tangent(w / side);
  return 2 * (q.w < 0 ? kPi - half : half);
}

Vec3<double> rotation_vector(const Quaternion<double>& q, int turns) {
  if (q.is_identity()) return Vec3<double>::Zero();
  const double side = std::sqrt((q.x * q.x + q.y * q.y) + q.z * q.z);
  const double scale = (angle_of(q) + 2 * kPi * turns) / side;
  return {scale * q.x, scale * q.y, scale * q.z};
}

Vec3<double> direction(Draw& draw) {
  const Quaternion<double> turn = some_turn(draw);
  return rotate(turn, Vec3<double>(0, 0, draw.random.once_in(2) ? 1 : -1));
}

Quaternion<double> some_turn(Draw& draw) {
  Quaternion<double> q;
  do {
    q = draw.pose();
  } while (q.is_identity());
  return q;
}

Quaternion<double> turn_about_x(Draw& draw) {
  Quaternion<double> q;
  q.w = draw.random.integer(1, 5);
  q.x = draw.random.integer(-5, 5);
  return q;
}

Shape<double> any_shape(Draw& draw, double reach) {
  Random& random = draw.random;
  if (random.once_in(4)) return nested_shape(draw, random.integer(1, 2));
  if (random.once_in(3)) return draw.shape(reach, random.integer(4, 12));
  return draw.leaf(reach, random.once_in(4) ? 2 : 0);
}

void meet(Draw& draw, Case& problem, const Meeting& meeting, double miss) {
  Random& random = draw.random;
  const double t = meeting.t;
  const Vec3<double> rotation_a = rotation_vector(meeting.turn_a, meeting.turns_a),
                     rotation_b = rotation_vector(meeting.turn_b, meeting.turns_b);
  for (int i = 0; i < 3; ++i) {
    problem.spin_a.rotation[i] = draw.real(rotation_a[i] / t);
    problem.spin_b.rotation[i] = draw.real(rotation_b[i] / t);
  }
  const Vec3<double> a =
      carried(problem.a, problem.spin_a, meeting.turn_a, t, middle_or_side(random, problem.a.shape));
  const Vec3<double> b =
      carried(problem.b, problem.spin_b, meeting.turn_b, t, middle_or_side(random, problem.b.shape));
  for (int i = 0; i < 3; ++i) {
    const double beside = random.uniform(-miss, miss);
    problem.b.position[i] = draw.real((problem.a.position[i] + (a[i] - b[i])) + beside);
  }
}

double meeting_time(Draw& draw) {
  constexpr double kTimes[] = {0.25, 0.5, 0.5, 0.75, 1, 1.5};
  return kTimes[draw.random.below(std::size(kTimes))];
}

void vary_horizon(Draw& draw, Case& problem) {
  switch (draw.random.below(12)) {
    case 0:
      problem.t_max = 0.5;
      break;
    case 1:
      problem.t_max = 2;
      break;
    default:
      break;
  }
  vary_time_scale(draw, problem);
}

namespace {

// m^2 + n^2 = p^2.
struct Triple {
  double m, n, p;
};

// The legs and the hypotenuse of a right-angled triangle on the grid, the hypotenuse 2 .. 8, or 5 exactly.
Triple right_triangle(Draw& draw) {
  constexpr Triple kTriples[] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}};
  Random& random = draw.random;
  Triple out = kTriples[0];
  if (draw.coordinates != Coordinates::integers) {
    out = kTriples[random.below(std::size(kTriples))];
    const double steps = std::floor(6 / out.p / draw.grid_step());
    const double unit =
        std::ceil(2 / out.p / draw.grid_step()) * draw.grid_step() +
        static_cast<double>(random.below(static_cast<std::uint64_t>(steps))) * draw.grid_step();
    out = {unit * out.m, unit * out.n, unit * out.p};
  }
  if (random.once_in(2)) std::swap(out.m, out.n);
  return out;
}

// Within half the reach of the axis, except for one vertex.
Spinner spinning_hull(Draw& draw) {
  Random& random = draw.random;
  const Triple far = right_triangle(draw);
  std::vector<Vec3<double>> list;
  const double x = draw.on_grid(4);
  list.emplace_back(x, far.m, far.n);
  const int vertices = random.integer(4, 12);
  while (static_cast<int>(list.size()) < vertices) {
    const double u = draw.on_grid(4), v = draw.on_grid(far.p / 2), w = draw.on_grid(far.p / 2);
    list.emplace_back(u, v, w);
  }
  std::swap(list[0], list[random.below(list.size())]);
  return {Hull<double>(std::span<const Vec3<double>>(list)), far.p, Vec3<double>(x, far.m, far.n)};
}

Spinner plain_spinner(Draw& draw) {
  Random& random = draw.random;
  switch (random.below(10)) {
    case 0:
    case 1: {
      const Triple edge = right_triangle(draw);
      return {Box<double>{Vec3<double>(draw.positive_on_grid(4), edge.m, edge.n)}, edge.p,
              Vec3<double>(0, edge.m, edge.n)};
    }
    case 2: {
      const double length = 1 + draw.positive_on_grid(6);
      return {Segment<double>{Vec3<double>::Zero(), Vec3<double>(0, length, 0)}, length,
              Vec3<double>(0, length, 0)};
    }
    case 3: {
      const double radius = draw.positive_on_grid(2), half_height = draw.positive_on_grid(4);
      const double reach = radius + half_height;
      return {Capsule<double>{radius, half_height}, reach, Vec3<double>(0, 0, reach)};
    }
    case 4: {
      const Triple rim = right_triangle(draw);
      return {Cylinder<double>{rim.m, rim.n}, rim.p, Vec3<double>(0, rim.m, rim.n)};
    }
    case 5: {
      const Triple rim = right_triangle(draw);
      return {Cone<double>{rim.m, rim.n}, rim.p, Vec3<double>(0, rim.m, -rim.n)};
    }
    case 6: {
      const double reach = 2 + draw.positive_on_grid(4), x = draw.positive_on_grid(4);
      return {Ellipsoid<double>{Vec3<double>(x, draw.real(reach * random.uniform(0.1, 0.75)), reach)}, reach,
              Vec3<double>(0, 0, reach)};
    }
    case 7: {
      // A box and a ball: rounded, or their sum.
      const Triple edge = right_triangle(draw);
      const double radius = draw.positive_on_grid(2);
      Shape<double> box = Box<double>{Vec3<double>(draw.positive_on_grid(4), edge.m, edge.n)};
      Shape<double> shape = random.once_in(2) ? rounded<double>(std::move(box), radius)
                                              : sum<double>(std::move(box), Sphere<double>{radius});
      return {std::move(shape), edge.p + radius, Vec3<double>(0, edge.m, edge.n)};
    }
    case 8: {
      // A wedge: an edge along x, and a ball about the origin of half the reach at most.
      const double reach = 2 + draw.positive_on_grid(4), half = draw.positive_on_grid(4);
      return {hull_of<double>(Segment<double>{Vec3<double>(-half, reach, 0), Vec3<double>(half, reach, 0)},
                              Sphere<double>{draw.real(reach * random.uniform(0, 0.5))}),
              reach, Vec3<double>(0, reach, 0)};
    }
    default:
      return spinning_hull(draw);
  }
}

// A body that stands on the plane: its lowest feature holds the origin, on its own z axis. It covers the
// curved shapes that capped_below does not draw, and combinators.
Capped standing(Draw& draw) {
  Random& random = draw.random;
  const double radius = draw.positive_on_grid(4), height = draw.positive_on_grid(4);
  switch (random.below(8)) {
    case 0: {
      const double other = draw.positive_on_grid(4);
      return {Ellipsoid<double>{Vec3<double>(radius, other, height)}, height};
    }
    case 1:
      return {Capsule<double>{radius, height}, radius + height};
    case 2:  // lying: z to -y, exactly
      return {posed<double>(Capsule<double>{radius, height}, Vec3<double>::Zero(), {1, 1, 0, 0}), radius};
    case 3:
      return {Cylinder<double>{radius, height}, height};
    case 4:
      return {Cone<double>{radius, height}, height};
    case 5:  // on its apex: half a turn about x
      return {posed<double>(Cone<double>{radius, height}, Vec3<double>::Zero(), {0, 1, 0, 0}), height};
    case 6: {
      const Capped below = draw.capped_below(4);
      return {rounded<double>(below.shape, radius), below.lift + radius};
    }
    default: {
      const Capped below = draw.capped_below(4);
      return {sum<double>(below.shape, Segment<double>{Vec3<double>::Zero(), Vec3<double>(0, 0, height)}),
              below.lift};
    }
  }
}

}  // namespace

Spinner spinner(Draw& draw) {
  Spinner out = plain_spinner(draw);
  if (!draw.random.once_in(4)) return out;
  // The same, placed along the axis and turned about it within its body.
  const Vec3<double> place(draw.on_grid(4), 0, 0);
  const Quaternion<double> turn = turn_about_x(draw);
  out.feature = plus(rotate(turn, out.feature), place);
  out.shape = posed<double>(std::move(out.shape), place, turn);
  return out;
}

void spin_past(Draw& draw, Case& problem, double delta, double least_angle, double most_angle) {
  Random& random = draw.random;
  const Spinner turning = spinner(draw);
  const bool wide = random.once_in(4);
  Capped above;
  if (wide) {
    const double height = draw.positive_on_grid(4);
    above = {Box<double>{Vec3<double>(32, 32, height)}, height};
  } else {
    above = random.once_in(2) ? draw.capped_below(4) : standing(draw);
  }
  problem.a.shape = turning.shape;
  problem.b.shape = above.shape;
  if (random.once_in(3)) problem.b.orientation = draw.pose_about_z();

  // A start that is not yet near: nothing stands above 0.9 of the reach.
  for (int tries = 0; tries < 64; ++tries) {
    problem.a.orientation = turn_about_x(draw);
    if (bounds(problem.a.shape, problem.a.orientation).high[2] <= 0.9 * turning.reach) break;
  }
  const Vec3<double> feature = rotate(problem.a.orientation, turning.feature);
  // From there the shorter way to the top, half a turn at most.
  const double angle = draw.real(random.uniform(least_angle, most_angle));
  problem.spin_a.rotation = Vec3<double>(feature[1] >= 0 ? angle : -angle, 0, 0);
  // The pivot anywhere on the axis.
  if (random.once_in(2)) problem.spin_a.pivot = Vec3<double>(draw.on_grid(16), 0, 0);
  // A turn about the normal through the feature moves no height.
  if (random.once_in(3)) problem.spin_b.rotation = Vec3<double>(0, 0, draw.real(random.uniform(-4, 4)));

  problem.a.position = Vec3<double>(0 - turning.feature[0], 0, 0 - (turning.reach + above.lift));
  problem.b.position = Vec3<double>(0, 0, delta);
  Vec3<double> v = Vec3<double>::Zero();
  if (wide && random.once_in(2)) {
    v[0] = draw.on_grid(8);
    v[1] = draw.on_grid(8);
  }
  set_motion(draw, problem, v);
  vary_time_scale(draw, problem);
  if (draw.coordinates == Coordinates::doubles) {
    turn_rounded(draw, problem);
  } else {
    turn_exactly(draw, problem);
  }
  maybe_swap(draw, problem);
}

}  // namespace graze::corpus
