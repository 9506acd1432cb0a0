#include "corpus/families/draw.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/families/placing.hpp"
#include "corpus/support_value.hpp"

namespace graze::corpus {
namespace {

// A capped hull's other vertices stay below the cap by at least this multiple (length, sizes are about 4).
constexpr double kBelowCap = 0.25;

Shape<double> negated(const Shape<double>& shape) {
  const Hull<double>* hull = std::get_if<Hull<double>>(&shape);
  if (hull == nullptr) return shape;  // of those that capped() draws, the others are symmetric
  std::vector<Vec3<double>> vertices(hull->vertices().begin(), hull->vertices().end());
  for (Vec3<double>& v : vertices) v = Vec3<double>(0 - v[0], 0 - v[1], 0 - v[2]);
  return Hull<double>(std::span<const Vec3<double>>(vertices));
}

Shape<double> rotated(const Quaternion<double>& cube, const Shape<double>& shape) {
  if (const auto* box = std::get_if<Box<double>>(&shape)) {
    const Vec3<double> half = rotate(cube, box->half_extents);
    return Box<double>{Vec3<double>(std::abs(half[0]), std::abs(half[1]), std::abs(half[2]))};
  }
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    std::vector<Vec3<double>> vertices(hull->vertices().begin(), hull->vertices().end());
    for (Vec3<double>& v : vertices) v = rotate(cube, v);
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  }
  return shape;
}

// Those that rotated() turns, or that no rotation changes.
bool turns_exactly(const Shape<double>& shape) {
  return std::holds_alternative<Box<double>>(shape) || std::holds_alternative<Hull<double>>(shape) ||
         std::holds_alternative<Sphere<double>>(shape) || std::holds_alternative<Point<double>>(shape);
}

void turn_body(const Quaternion<double>& q, bool into_shape, Body<double>& body, Spin& spin) {
  if (into_shape && body.orientation.is_identity() && turns_exactly(body.shape)) {
    body.shape = rotated(q, body.shape);
    spin.pivot = rotate(q, spin.pivot);
  } else {
    body.orientation = multiply(q, body.orientation);
  }
  body.position = rotate(q, body.position);
  body.displacement = rotate(q, body.displacement);
  spin.rotation = rotate(q, spin.rotation);
}

}  // namespace

Vec3<double> rotate(const Quaternion<double>& q, const Vec3<double>& x) {
  const double n = ((q.w * q.w + q.x * q.x) + q.y * q.y) + q.z * q.z;
  const double m[3][3] = {{(q.w * q.w + q.x * q.x) - (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z),
                           2 * (q.x * q.z + q.w * q.y)},
                          {2 * (q.x * q.y + q.w * q.z), (q.w * q.w + q.y * q.y) - (q.x * q.x + q.z * q.z),
                           2 * (q.y * q.z - q.w * q.x)},
                          {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x),
                           (q.w * q.w + q.z * q.z) - (q.x * q.x + q.y * q.y)}};
  Vec3<double> y;
  // 0 + turns a -0 into 0.
  for (int i = 0; i < 3; ++i) y[i] = 0 + ((m[i][0] * x[0] + m[i][1] * x[1]) + m[i][2] * x[2]) / n;
  return y;
}

Quaternion<double> multiply(const Quaternion<double>& l, const Quaternion<double>& r) {
  return {
      ((l.w * r.w - l.x * r.x) - l.y * r.y) - l.z * r.z, ((l.w * r.x + l.x * r.w) + l.y * r.z) - l.z * r.y,
      ((l.w * r.y - l.x * r.z) + l.y * r.w) + l.z * r.x, ((l.w * r.z + l.x * r.y) - l.y * r.x) + l.z * r.w};
}

double bounding_radius(const Shape<double>& shape) {
  const auto norm = [](const Vec3<double>& v) {
    return std::sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]);
  };
  double radius = 0;
  if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) {
    radius = sphere->radius;
  } else if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    for (const Vec3<double>& v : hull->vertices()) radius = std::max(radius, norm(v));
  } else {
    const Bounds box = bounds(shape);
    radius = norm(box.high.cwiseMax(-box.low));
  }
  return radius * (1 + 8 * kUnitRoundoff<double>);
}

double round_to_float(double x) {
  const double c = x * (0x1p29 + 1);
  return c - (c - x);
}

double power_of_ten(int k) {
  double power = 1;
  for (int i = 0; i < std::abs(k); ++i) power *= 10;
  return k < 0 ? 1 / power : power;
}

Draw::Draw(std::uint64_t seed) : random(seed), coordinates(static_cast<Coordinates>(random.below(3))) {}

double Draw::snap(double x) const {
  switch (coordinates) {
    case Coordinates::floats:
      return round_to_float(x);
    case Coordinates::doubles:
      return x;
    case Coordinates::integers:
      return 0 + std::floor(x + 0.5);
  }
  return x;
}

Vec3<double> Draw::snap(const Vec3<double>& x) const { return {snap(x[0]), snap(x[1]), snap(x[2])}; }

double Draw::coordinate(double reach) { return snap(random.uniform(-reach, reach)); }

Vec3<double> Draw::vector(double reach) {
  const double x = coordinate(reach), y = coordinate(reach), z = coordinate(reach);
  return {x, y, z};
}

double Draw::grid_step() const {
  switch (coordinates) {
    case Coordinates::floats:
      return 0x1p-10;
    case Coordinates::doubles:
      return 0x1p-30;
    case Coordinates::integers:
      return 1;
  }
  return 1;
}

double Draw::on_grid(double reach) {
  const double steps = std::floor(reach / grid_step());
  return (static_cast<double>(random.below(static_cast<std::uint64_t>(2 * steps) + 1)) - steps) * grid_step();
}

double Draw::real(double x) const { return coordinates == Coordinates::doubles ? x : round_to_float(x); }

Vec3<double> Draw::real(const Vec3<double>& x) const { return {real(x[0]), real(x[1]), real(x[2])}; }

double Draw::positive_on_grid(double reach) {
  const double steps = std::floor(reach / grid_step());
  return static_cast<double>(random.below(static_cast<std::uint64_t>(steps)) + 1) * grid_step();
}

Shape<double> Draw::hull(double reach, int vertices) {
  std::vector<Vec3<double>> list(static_cast<std::size_t>(vertices));
  for (Vec3<double>& v : list) v = vector(reach);
  return Hull<double>(std::span<const Vec3<double>>(list));
}

Shape<double> Draw::shape(double reach, int vertices) {
  switch (random.below(8)) {
    case 0:
      return Point<double>{};
    case 1:
      return Sphere<double>{std::abs(coordinate(reach))};
    case 2:
    case 3: {
      const Vec3<double> half = vector(reach);
      return Box<double>{Vec3<double>(std::abs(half[0]), std::abs(half[1]), std::abs(half[2]))};
    }
    default:
      return hull(reach, vertices);
  }
}

double Draw::thin_extent(double reach, int thinness) {
  if (random.once_in(12)) return 0;
  const double full = random.uniform(0.5, reach);
  double size = full;
  switch (random.below(3)) {
    case 0:
      break;
    case 1:
      size = full * power_of_ten(-thinness);
      break;
    default:
      size = full * power_of_ten(-random.integer(0, thinness));
      break;
  }
  // Integers would round the thin ones away.
  return coordinates == Coordinates::doubles ? size : round_to_float(size);
}

Vec3<double> Draw::thin_extents(double reach, int thinness) {
  const double x = thin_extent(reach, thinness), y = thin_extent(reach, thinness);
  return {x, y, thin_extent(reach, thinness)};
}

Shape<double> Draw::thin_hull(double reach, int thinness, int vertices) {
  const int axis = random.integer(0, 2);
  const double factor = random.once_in(2) ? power_of_ten(-thinness) : 1;
  std::vector<Vec3<double>> list(static_cast<std::size_t>(vertices));
  for (Vec3<double>& v : list) {
    v = vector(reach);
    const double thin = v[axis] * factor;
    v[axis] = coordinates == Coordinates::doubles ? thin : round_to_float(thin);
  }
  if (vertices == 2) return Segment<double>{list[0], list[1]};
  if (vertices == 3) return Triangle<double>{list[0], list[1], list[2]};
  return Hull<double>(std::span<const Vec3<double>>(list));
}

Shape<double> Draw::smooth_leaf(double reach, int thinness) {
  const auto two = [&] {
    const double radius = thin_extent(reach, thinness);
    return std::pair(radius, thin_extent(reach, thinness));
  };
  switch (random.below(6)) {
    case 0:
      return thin_hull(reach, thinness, 2);
    case 1:
      return Sphere<double>{thin_extent(reach, thinness)};
    case 2: {
      const auto [radius, half_height] = two();
      return Capsule<double>{radius, half_height};
    }
    case 3:
      return Ellipsoid<double>{thin_extents(reach, thinness)};
    case 4: {
      const auto [radius, half_height] = two();
      return Cylinder<double>{radius, half_height};
    }
    default: {
      const auto [radius, half_height] = two();
      return Cone<double>{radius, half_height};
    }
  }
}

Shape<double> Draw::leaf(double reach, int thinness) {
  switch (random.below(10)) {
    case 0:
      return Point<double>{};
    case 1:
      return thin_hull(reach, thinness, 3);
    case 2:
      return Box<double>{thin_extents(reach, thinness)};
    case 3:
      return thin_hull(reach, thinness, random.integer(4, 8));
    default:
      return smooth_leaf(reach, thinness);
  }
}

Quaternion<double> Draw::pose() {
  if (random.once_in(2)) return {};
  Quaternion<double> q;
  do {
    q.w = random.integer(-3, 3);
    q.x = random.integer(-3, 3);
    q.y = random.integer(-3, 3);
    q.z = random.integer(-3, 3);
  } while (q.w == 0 && q.is_identity());
  return q;
}

Quaternion<double> Draw::turned_pose() {
  Quaternion<double> q;
  do {
    q = pose();
  } while (q.is_identity());
  return q;
}

Quaternion<double> Draw::pose_about_z() {
  Quaternion<double> q;
  q.w = random.integer(1, 5);
  q.z = random.integer(-5, 5);
  return q;
}

Quaternion<double> Draw::cube_rotation() {
  // |q|^2 of 1, 2 or 4: with 3, the rotation is one of 120 degrees about no diagonal of the cube's.
  Quaternion<double> q;
  double n = 0;
  do {
    q.w = random.integer(-1, 1);
    q.x = random.integer(-1, 1);
    q.y = random.integer(-1, 1);
    q.z = random.integer(-1, 1);
    n = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  } while (n == 0 || n == 3);
  return q;
}

Shape<double> Draw::capped_hull(double reach, double lift) {
  std::vector<Vec3<double>> list;
  const double a = positive_on_grid(reach), b = on_grid(reach);
  switch (random.below(3)) {
    case 0:
      list = {Vec3<double>(0, 0, 0)};
      break;
    case 1:
      list = {Vec3<double>(a, b, 0), Vec3<double>(-a, -b, 0)};
      break;
    default: {
      // A parallelogram about the origin: (a, b) and a vector to its left.
      const double c = -positive_on_grid(reach), d = positive_on_grid(reach);
      list = {Vec3<double>(a, std::abs(b), 0), Vec3<double>(c, d, 0), Vec3<double>(-a, -std::abs(b), 0),
              Vec3<double>(-c, -d, 0)};
      break;
    }
  }
  const int vertices = random.integer(4, 24);
  while (static_cast<int>(list.size()) < vertices) {
    const double x = on_grid(reach), y = on_grid(reach);
    const double below = std::max(positive_on_grid(2 * reach), std::max(kBelowCap, grid_step()));
    list.emplace_back(x, y, -below);
  }
  // Any order: no method may lean on the top feature being first.
  for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[random.below(k)]);
  for (Vec3<double>& v : list) v = Vec3<double>(0 + v[0], 0 + v[1], 0 + (v[2] - lift));
  return Hull<double>(std::span<const Vec3<double>>(list));
}

Capped Draw::capped(double reach) {
  switch (random.below(8)) {
    case 0:
      return {Point<double>{}, 0};
    case 1: {
      const double radius = positive_on_grid(reach);
      return {Sphere<double>{radius}, -radius};
    }
    case 2:
    case 3: {
      const double x = positive_on_grid(reach), y = positive_on_grid(reach), z = positive_on_grid(reach);
      return {Box<double>{Vec3<double>(x, y, z)}, -z};
    }
    default: {
      const double lift = on_grid(reach);
      return {capped_hull(reach, lift), lift};
    }
  }
}

Capped Draw::capped_below(double reach) {
  const Capped above = capped(reach);
  return {negated(above.shape), 0 - above.lift};
}

Shape<double> nested_shape(Draw& draw, int depth) {
  constexpr double kReach = 2;
  constexpr int kThinness = 2;
  Random& random = draw.random;
  if (depth == 0) return draw.leaf(kReach, random.once_in(4) ? kThinness : 0);
  Shape<double> child = nested_shape(draw, depth - 1);
  switch (random.below(5)) {
    case 0: {
      Shape<double> other = draw.smooth_leaf(kReach, 0);
      if (random.once_in(2)) std::swap(child, other);
      return sum<double>(std::move(child), std::move(other));
    }
    case 1:
      return swept<double>(std::move(child), draw.vector(kReach));
    case 2: {
      Shape<double> leaf = draw.leaf(kReach, 0);
      Shape<double> other = translated<double>(std::move(leaf), draw.vector(kReach));
      if (random.once_in(2)) std::swap(child, other);
      return hull_of<double>(std::move(child), std::move(other));
    }
    case 3:
      return rounded<double>(std::move(child), draw.snap(random.uniform(0, kReach)));
    default: {
      const Vec3<double> position = draw.vector(kReach);
      return posed<double>(std::move(child), position, draw.pose());
    }
  }
}

Vec3<double> middle_or_side(Random& random, const Shape<double>& shape) {
  const Bounds box = bounds(shape);
  Vec3<double> x;
  for (int i = 0; i < 3; ++i) x[i] = (box.low[i] + box.high[i]) / 2;
  if (!random.once_in(4)) {
    const int side = random.integer(0, 2);
    x[side] = random.once_in(2) ? box.low[side] : box.high[side];
  }
  return x;
}

void aim(Draw& draw, Case& problem, double miss) {
  Random& random = draw.random;
  Vec3<double> v = draw.vector(16);
  const int axis = random.integer(0, 2);
  const double along = draw.snap(random.uniform(8, 24));
  v[axis] = random.once_in(2) ? along : -along;
  constexpr double kTimes[] = {0, 0.25, 0.5, 0.5, 0.75, 1, 2};
  const double t = kTimes[random.below(std::size(kTimes))];
  const Vec3<double> a = rotate(problem.a.orientation, middle_or_side(random, problem.a.shape));
  const Vec3<double> b = rotate(problem.b.orientation, middle_or_side(random, problem.b.shape));
  for (int i = 0; i < 3; ++i) {
    const double beside = random.uniform(-miss, miss);
    const double x = ((problem.a.position[i] + (a[i] - b[i])) - t * v[i]) + beside;
    problem.b.position[i] = draw.coordinates == Coordinates::doubles ? x : round_to_float(x);
  }
  set_motion(draw, problem, v);
  draw_horizon(random, problem);
}

void set_motion(Draw& draw, Case& problem, const Vec3<double>& v) {
  const Vec3<double> shared = draw.random.once_in(4) ? draw.vector(8) : Vec3<double>::Zero();
  const Vec3<double> sum(v[0] + shared[0], v[1] + shared[1], v[2] + shared[2]);
  const bool exact = sum[0] - shared[0] == v[0] && sum[1] - shared[1] == v[1] && sum[2] - shared[2] == v[2] &&
                     draw.snap(sum) == sum;
  problem.a.displacement = exact ? shared : Vec3<double>::Zero();
  problem.b.displacement = exact ? sum : v;
}

void approach(Draw& draw, Case& problem) {
  Random& random = draw.random;
  problem.a.position = draw.vector(8);

  Vec3<double> start = draw.vector(6);
  if (random.once_in(10)) {
    // Near enough to be in contact at the start, or nearly.
  } else {
    const int axis = random.integer(0, 2);
    const double away = draw.snap(random.uniform(8, 24));
    start[axis] = random.once_in(2) ? away : -away;
  }
  // Aimed at a point near A's middle. The start is far enough off to miss now and then, and not always far
  // enough to arrive.
  const Vec3<double> target = draw.vector(5);
  const double reach = random.uniform(0.5, 2);
  Vec3<double> position, v;
  for (int i = 0; i < 3; ++i) {
    position[i] = draw.snap(problem.a.position[i] + start[i]);
    v[i] = draw.snap((target[i] - start[i]) * reach);
  }
  problem.b.position = position;
  set_motion(draw, problem, v);
  switch (random.below(16)) {
    case 0:
      problem.t_max = kInfinity<double>;
      break;
    case 1:
      problem.t_max = 0.5;
      break;
    case 2:
      problem.t_max = 2;
      break;
    case 3:
      problem.t_max = 100;
      break;
    default:
      break;
  }
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

void vary_time_scale(Draw& draw, Case& problem) {
  if (!draw.random.once_in(4)) return;
  const int exponent = draw.random.integer(-8, 8);
  for (Vec3<double>* velocity : {&problem.a.displacement, &problem.b.displacement, &problem.spin_a.rotation,
                                 &problem.spin_b.rotation}) {
    for (int i = 0; i < 3; ++i) (*velocity)[i] = std::scalbn((*velocity)[i], exponent);
  }
  problem.t_max = std::scalbn(problem.t_max, -exponent);
}

void turn_exactly(Draw& draw, Case& problem) {
  const Quaternion<double> q = draw.cube_rotation();
  const bool into_shape = draw.random.once_in(2);
  turn_body(q, into_shape, problem.a, problem.spin_a);
  turn_body(q, into_shape, problem.b, problem.spin_b);
}

void turn_rounded(Draw& draw, Case& problem) {
  const Quaternion<double> q = draw.turned_pose();
  const auto turn = [&](Body<double>& body, Spin& spin) {
    turn_body(q, false, body, spin);
    if (draw.coordinates != Coordinates::floats) return;
    body.position = draw.snap(body.position);
    body.displacement = draw.snap(body.displacement);
    spin.rotation = draw.snap(spin.rotation);
  };
  turn(problem.a, problem.spin_a);
  turn(problem.b, problem.spin_b);
}

void turn_either_way(Draw& draw, Case& problem) {
  if (draw.coordinates == Coordinates::doubles && draw.random.once_in(2)) {
    turn_rounded(draw, problem);
  } else {
    turn_exactly(draw, problem);
  }
}

void maybe_swap(Draw& draw, Case& problem) {
  if (!draw.random.once_in(2)) return;
  std::swap(problem.a, problem.b);
  std::swap(problem.spin_a, problem.spin_b);
}

}  // namespace graze::corpus
