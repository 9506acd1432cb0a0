// equal_distances: a polytope with many faces, edges or corners at one distance, and a small body in the
// middle of them. Hardness: k, about 2^k corners.
//
// The polytopes are pyramids, double pyramids, prisms and frusta over a regular polygon, whose sides are
// equally near to every point of the axis. Others are hulls of points of one sphere, half of them with -x for
// every x. The other body is a point, a ball, a segment along the axis, a small box or a smaller copy. It is
// on the axis, within the tip, in the middle or on its way there. Its offset from there is 0 or 10^-j, j
// drawn.
//
// This breaks a search for the face of least depth that must open nearly all of them, however large its
// storage is. It also breaks a stopping test that waits for one face to be nearer than the rest.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/standing.hpp"

namespace graze::corpus {
namespace {

constexpr int kMostCornersOfCopy = 48;  // the exact oracle forms all differences

struct RoundPolytope {
  std::vector<Vec3<double>> corners;
  double tip = 0;  // z of its top on the axis
};

RoundPolytope round_polytope(Draw& draw, int doublings) {
  Random& random = draw.random;
  const double radius = draw.real(random.uniform(1, 4)), height = draw.real(random.uniform(0.5, 4));
  const int first = random.integer(3, 5);
  // first * 2^d corners, about 2^k.
  const std::vector<Point2> ring = regular_polygon(first, std::max(0, doublings - 2));
  RoundPolytope out{.corners = {}, .tip = height};
  const auto add_ring = [&](double r, double z) {
    for (const Point2& x : ring) out.corners.emplace_back(draw.real(r * x[0]), draw.real(r * x[1]), z);
  };
  switch (random.below(6)) {
    case 0:
      add_ring(radius, 0);
      out.corners.emplace_back(0, 0, height);
      break;
    case 1:
      add_ring(radius, 0);
      out.corners.emplace_back(0, 0, height);
      out.corners.emplace_back(0, 0, -height);
      break;
    case 2:
      add_ring(radius, height);
      add_ring(radius, -height);
      break;
    case 3:
      add_ring(radius, -height);
      add_ring(draw.real(radius / 2), height);
      break;
    default: {
      const bool symmetric = random.once_in(2);
      const int count = 1 << doublings;
      for (const Vec3<double>& x : sphere_points(symmetric ? count / 2 : count)) {
        const Vec3<double> y = draw.real(Vec3<double>(radius * x));
        out.corners.push_back(y);
        if (symmetric) out.corners.emplace_back(0 - y[0], 0 - y[1], 0 - y[2]);
      }
      out.tip = radius;
      break;
    }
  }
  for (std::size_t k = out.corners.size(); k > 1; --k)
    std::swap(out.corners[k - 1], out.corners[random.below(k)]);
  return out;
}

Shape<double> small_body(Draw& draw, const RoundPolytope& around) {
  Random& random = draw.random;
  const double size = draw.real(random.uniform(0.0625, 0.5));
  switch (random.below(6)) {
    case 0:
    case 1:
      return Point<double>{};
    case 2:
      return Sphere<double>{size};
    case 3:
      return Segment<double>{Vec3<double>(0, 0, -size), Vec3<double>(0, 0, size)};
    case 4:
      if (around.corners.size() <= kMostCornersOfCopy) {
        std::vector<Vec3<double>> list;
        for (const Vec3<double>& x : around.corners) list.push_back(0.25 * x);
        return Hull<double>(std::span<const Vec3<double>>(list));
      }
      [[fallthrough]];
    default:
      return Box<double>{Vec3<double>(size, size, random.once_in(2) ? size : 2 * size)};
  }
}

void fill_equal_distances(Draw& draw, double hardness, Case& problem) {
  constexpr int kLastOffset = 16;
  Random& random = draw.random;
  const RoundPolytope around = round_polytope(draw, static_cast<int>(hardness));
  problem.a.shape = Hull<double>(std::span<const Vec3<double>>(around.corners));
  problem.b.shape = small_body(draw, around);
  if (random.once_in(4)) problem.b.orientation = draw.cube_rotation();

  const int j = random.integer(2, 2 * kLastOffset);
  const double off = j > kLastOffset ? 0 : 4 * power_of_ten(-j);
  Vec3<double> meeting = Vec3<double>::Zero();
  for (int i = 0; i < 2; ++i) meeting[i] = off * random.integer(-1, 1);
  // In the middle, within the tip, or just out of it.
  constexpr double kHeights[] = {0, 0, 0.5, 0.9, 1, 1.25};
  meeting[2] = kHeights[random.below(std::size(kHeights))] * around.tip;
  Vec3<double> v(0, 0, random.once_in(2) ? 32 : -32);
  if (random.once_in(4)) v = Vec3<double>(0, random.once_in(2) ? 32 : -32, 0);
  double t0 = 0.5;
  switch (random.below(8)) {
    case 0:
      t0 = 0;
      break;
    case 1:
      t0 = -0.5;
      break;
    case 2:
      meeting[0] += 16;  // past it
      break;
    default:
      break;
  }
  for (int i = 0; i < 3; ++i) problem.b.position[i] = draw.real(0 + (meeting[i] - t0 * v[i]));
  set_motion(draw, problem, v);
  if (random.once_in(16)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  turn_either_way(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kEqualDistancesLevels[] = {3, 4, 5, 6, 7, 8};

}  // namespace

const Family family::equal_distances{
    .name = "equal_distances",
    .sentence = "A small body amid many faces, edges or corners that are equally near.",
    .hardness_meaning = "k: the polytope has about 2^k corners",
    .levels = kEqualDistancesLevels,
    .fill = fill_equal_distances,
    .picture = {5, 3},
};

}  // namespace graze::corpus
