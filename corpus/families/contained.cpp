// contained: centrally symmetric bodies, one within the other, or on its way to the other's middle, or gone.
// Hardness: k, the offset of their centres is 10^-k of a size of 4 along each axis, and 0 above 16. C is
// symmetric about the point with that offset, at t = 0 or somewhere on the line of motion. Support heights
// along n and -n differ by at most the offset, so every axis of least penetration has a twin.
//
// Exact: A's centre is the origin, and B's coordinates at the meeting are exactly the offset (rounded to
// float with floats and integers). A path to the middle starts on a grid multiple of v and is rounded once.
// Difficulties: the origin at the middle of the start simplex, a zero first direction, twin axes of depth.
#include <cmath>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

constexpr int kLastOffset = 16;

// {x, -x, ...}: symmetric about the origin, exactly.
Shape<double> symmetric_hull(Draw& draw, double reach) {
  std::vector<Vec3<double>> list;
  const int pairs = draw.random.integer(3, 8);
  for (int k = 0; k < pairs; ++k) {
    const double x = draw.positive_on_grid(reach), y = draw.on_grid(reach), z = draw.on_grid(reach);
    list.emplace_back(x, y, z);
    list.emplace_back(-x, 0 - y, 0 - z);
  }
  return Hull<double>(std::span<const Vec3<double>>(list));
}

Shape<double> symmetric_shape(Draw& draw, double reach) {
  switch (draw.random.below(8)) {
    case 0:
      return Sphere<double>{draw.positive_on_grid(reach)};
    case 1:
    case 2:
    case 3: {
      const double x = draw.positive_on_grid(reach), y = draw.positive_on_grid(reach);
      return Box<double>{Vec3<double>(x, y, draw.positive_on_grid(reach))};
    }
    default:
      return symmetric_hull(draw, reach);
  }
}

// The same, 2^-shift as large: exact.
Shape<double> shrunk(const Shape<double>& shape, int shift) {
  const double factor = std::scalbn(1.0, -shift);
  if (const auto* sphere = std::get_if<Sphere<double>>(&shape))
    return Sphere<double>{factor * sphere->radius};
  if (const auto* box = std::get_if<Box<double>>(&shape)) return Box<double>{factor * box->half_extents};
  std::vector<Vec3<double>> list;
  for (const Vec3<double>& x : std::get<Hull<double>>(shape).vertices()) list.push_back(factor * x);
  return Hull<double>(std::span<const Vec3<double>>(list));
}

void fill_contained(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const int k = static_cast<int>(hardness);
  const double size = k > kLastOffset ? 0 : 4 * power_of_ten(-k);
  const double off = draw.real(size);

  problem.a.shape = symmetric_shape(draw, 4);
  // A copy, a smaller copy, or something else, down to a point.
  switch (random.below(6)) {
    case 0:
      problem.b.shape = problem.a.shape;
      break;
    case 1:
    case 2:
      problem.b.shape = shrunk(problem.a.shape, random.integer(1, 8));
      break;
    case 3:
      problem.b.shape = Point<double>{};
      break;
    default:
      problem.b.shape = symmetric_shape(draw, random.once_in(2) ? 1 : 4);
      break;
  }
  if (random.once_in(4)) problem.a.orientation = draw.pose();
  if (random.once_in(4)) problem.b.orientation = draw.pose();

  Vec3<double> meeting = Vec3<double>::Zero();
  for (int i = 0; i < 3; ++i) meeting[i] = 0 + off * random.integer(-1, 1);  // no -0
  if (meeting == Vec3<double>::Zero()) meeting[random.integer(0, 2)] = off;
  Vec3<double> v;
  for (int i = 0; i < 3; ++i) v[i] = draw.on_grid(16);
  v[random.integer(0, 2)] = random.once_in(2) ? 64 : -64;
  if (random.once_in(3)) v = Vec3<double>(0, 0, v[2] < 0 ? -64 : 64);
  // The body starts contained half of the time, comes to the middle at a quarter or a half, or has left it.
  double t0 = 0;
  if (!random.once_in(2)) {
    constexpr double kMeetings[] = {0.25, 0.5, 0.5, -0.25, -0.5};
    t0 = kMeetings[random.below(std::size(kMeetings))];
  } else if (random.once_in(6)) {
    v = Vec3<double>::Zero();
  }
  for (int i = 0; i < 3; ++i) problem.b.position[i] = 0 + (meeting[i] - t0 * v[i]);
  problem.b.position = draw.real(problem.b.position);
  set_motion(draw, problem, v);
  if (random.once_in(2)) problem.start_policy = StartPolicy::pass_over;
  if (random.once_in(8)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  turn_either_way(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kContainedLevels[] = {1, 2, 4, 6, 8, 10, 12, 14, 16, 17};  // 17: none at all

}  // namespace

const Family family::contained{
    .name = "contained",
    .sentence = "One body within the other, or on its way to the other's middle.",
    .hardness_meaning = "k: the centres are 10^-k of a size of 4 apart along an axis; 17 is concentric",
    .levels = kContainedLevels,
    .fill = fill_contained,
    .picture = {2, 5},
};

}  // namespace graze::corpus
