// needles: long thin bodies, length 10^k times the width, that meet near their ends. plates: flat ones, width
// 10^k times the thickness, that meet flat on flat, edge on edge and edge on flat, near their rims. Hardness:
// k. The larger extent is 4 times a power of ten between 1 and 10^k, so that the small one is at most 4.
//
// The path is as long as the body, or as short as the body is thin. In the second case both bodies reach far
// past the deciding part of the scene.
//
// Difficulties:
//   - supports of size L meet in a contact of size L 10^-k, so a direction that is off by u loses k digits,
//   - an interior point in the middle sees the contact at an angle of 10^-k (MPR),
//   - simplices are slivers,
//   - a tolerance relative to the size is larger than the thickness of the body.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

struct Sizes {
  double large = 0, small = 0;  // half extents (length)
};

// Integers are large enough to stay integers.
Sizes sizes(Draw& draw, int k) {
  Random& random = draw.random;
  const int up = draw.coordinates == Coordinates::integers ? k : random.integer(0, k);
  return {4 * power_of_ten(up), 4 * power_of_ten(up - k)};
}

// 1/2 to 1 times the extent. With integers it is at least 1.
double extent(Draw& draw, double full) {
  const double x = draw.snap(full * draw.random.uniform(0.5, 1));
  return draw.coordinates == Coordinates::integers ? std::max(x, 1.0) : x;
}

// Along x.
Shape<double> needle(Draw& draw, const Sizes& size) {
  Random& random = draw.random;
  const double length = draw.snap(size.large);
  switch (random.below(5)) {
    case 0:
    case 1: {
      const double y = extent(draw, size.small);
      return Box<double>{Vec3<double>(length, y, extent(draw, size.small))};
    }
    case 2: {
      const double y = extent(draw, size.small), x = draw.coordinate(length);
      const double z = extent(draw, size.small);
      return Triangle<double>{Vec3<double>(-length, -y, -z), Vec3<double>(length, -y, 0),
                              Vec3<double>(x, y, z)};
    }
    default: {
      const int vertices = random.integer(5, 16);
      std::vector<Vec3<double>> list;
      for (int n = 0; n < vertices; ++n) {
        const double x = n == 0 ? -length : n == 1 ? length : draw.coordinate(length);
        const double y = draw.coordinate(size.small);
        list.emplace_back(x, y, draw.coordinate(size.small));
      }
      return Hull<double>(std::span<const Vec3<double>>(list));
    }
  }
}

// In the plane of x and y.
Shape<double> plate(Draw& draw, const Sizes& size) {
  Random& random = draw.random;
  const double x = extent(draw, size.large), y = extent(draw, size.large), z = extent(draw, size.small);
  if (random.once_in(2)) return Box<double>{Vec3<double>(x, y, z)};
  std::vector<Vec3<double>> list = {{x, y, z}, {-x, y, z}, {-x, -y, -z}, {x, -y, -z}};
  const int vertices = random.integer(5, 16);
  while (static_cast<int>(list.size()) < vertices) {
    const double at_x = draw.coordinate(size.large), at_y = draw.coordinate(size.large);
    list.emplace_back(at_x, at_y, random.once_in(2) ? z : -z);
  }
  return Hull<double>(std::span<const Vec3<double>>(list));
}

Vec3<double> corner_of(Random& random, const Shape<double>& shape) {
  const std::vector<Vec3<double>> list = corners(shape);
  return list[random.below(list.size())];
}

// A corner, drawn inward by a third of its distance from the middle at most.
Vec3<double> far_out(Draw& draw, const Shape<double>& shape) {
  Vec3<double> x = corner_of(draw.random, shape);
  const double shrink = draw.random.once_in(2) ? 1 : draw.random.uniform(0.67, 1);
  for (int i = 0; i < 3; ++i) x[i] *= shrink;
  return x;
}

Vec3<double> any_vector(Draw& draw, double size) {
  Vec3<double> v;
  for (int i = 0; i < 3; ++i) v[i] = draw.coordinate(size);
  const int axis = draw.random.integer(0, 2);
  v[axis] = draw.random.once_in(2) ? extent(draw, size) : -extent(draw, size);
  return v;
}

// The offset is the small extent half of the time. Otherwise the points meet.
Vec3<double> beside(Random& random, double size) {
  Vec3<double> x = Vec3<double>::Zero();
  if (random.once_in(3)) return x;
  for (int i = 0; i < 3; ++i) x[i] = random.uniform(-2, 2) * size;
  return x;
}

Quaternion<double> any_pose(Draw& draw) {
  return draw.random.once_in(3) ? draw.cube_rotation() : draw.pose();
}

// A cube rotation of the scene turns the long axes away from x.
void finish(Draw& draw, Case& problem) {
  draw_horizon(draw.random, problem);
  vary_time_scale(draw, problem);
  if (draw.random.once_in(2)) turn_exactly(draw, problem);
  maybe_swap(draw, problem);
}

void fill_needles(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const Sizes size = sizes(draw, static_cast<int>(hardness));
  problem.a.shape = needle(draw, size);
  problem.b.shape = needle(draw, size);
  problem.a.orientation = draw.pose();
  problem.b.orientation = any_pose(draw);
  problem.a.position = draw.vector(size.large);
  const Vec3<double> v = any_vector(draw, random.once_in(2) ? 4 * size.large : 16 * size.small);
  const Vec3<double> a = rotate(problem.a.orientation, far_out(draw, problem.a.shape));
  const Vec3<double> b = rotate(problem.b.orientation, far_out(draw, problem.b.shape));
  const Vec3<double> off = beside(random, size.small);
  meet(draw, problem, a, b, off, v, meeting_time(random));
  finish(draw, problem);
}

void fill_plates(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const Sizes size = sizes(draw, static_cast<int>(hardness));
  problem.a.shape = plate(draw, size);
  problem.b.shape = plate(draw, size);
  problem.a.position = draw.vector(size.large);
  const double far = random.once_in(2) ? 4 * size.large : 16 * size.small;
  Vec3<double> v;
  for (int i = 0; i < 3; ++i) v[i] = random.once_in(2) ? 0 : draw.coordinate(size.small);
  switch (random.below(4)) {
    case 0:  // flat on flat
      v[2] = random.once_in(2) ? extent(draw, far) : -extent(draw, far);
      break;
    case 1:  // edge on edge, along the plates
    {
      const int axis = random.integer(0, 1);
      v[axis] = random.once_in(2) ? extent(draw, far) : -extent(draw, far);
    } break;
    case 2:  // edge on flat
      problem.b.orientation = {1, 1, 0, 0};
      v[2] = random.once_in(2) ? extent(draw, far) : -extent(draw, far);
      break;
    default:
      problem.a.orientation = draw.pose();
      problem.b.orientation = draw.pose();
      v = any_vector(draw, far);
      break;
  }
  const Vec3<double> a = rotate(problem.a.orientation, far_out(draw, problem.a.shape));
  const Vec3<double> b = rotate(problem.b.orientation, far_out(draw, problem.b.shape));
  const Vec3<double> off = beside(random, size.small);
  meet(draw, problem, a, b, off, v, meeting_time(random));
  finish(draw, problem);
}

constexpr double kNeedlesLevels[] = {0, 1, 2, 3, 4, 5, 6};

}  // namespace

const Family family::needles{
    .name = "needles",
    .sentence = "Long thin bodies that meet near their ends.",
    .hardness_meaning = "k: the length is 10^k times the width",
    .levels = kNeedlesLevels,
    .fill = fill_needles,
    .picture = {1, 2},
};

const Family family::plates{
    .name = "plates",
    .sentence = "Flat bodies that meet flat on flat, edge on edge or edge on flat, near their rims.",
    .hardness_meaning = "k: the width is 10^k times the thickness",
    .levels = kNeedlesLevels,
    .fill = fill_plates,
    .picture = {2, 1},
};

}  // namespace graze::corpus
