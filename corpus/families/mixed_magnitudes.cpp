// mixed_magnitudes: coordinates of very different size within one case, in sums and nested poses. Hardness:
// k, exponents of 10 go from -k to k.
//
// Each coordinate is 0, or 1, 1.5 or any digits times its own power of ten. Orientations are integers, or
// lean from one by such a number. Half of the motions lead B's origin exactly through A's, where position and
// displacement are each other's negatives, as for a body that flies home. Others are of any size.
//
// Difficulties: intermediate squares and products of values in range, scales taken from the largest number
// where the least decides, and supports that tie in every digit except those that were rounded away.
#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

// 10^-60 .. 10^60 is the domain (validate.hpp).
constexpr int kGreatestExponent = 59;
constexpr double kLeast = 1.0001e-60;

double digits(Random& random) {
  switch (random.below(3)) {
    case 0:
      return 1;
    case 1:
      return 1.5;
    default:
      return random.uniform(1, 2);
  }
}

double number(Random& random, int k) {
  if (random.once_in(4)) return 0;
  const double size = digits(random) * power_of_ten(random.integer(-k, k));
  return random.once_in(2) ? size : -size;
}

Vec3<double> triple(Random& random, int k) {
  Vec3<double> out;
  for (int i = 0; i < 3; ++i) out[i] = number(random, k);
  return out;
}

Quaternion<double> pose(Draw& draw, int k) {
  Quaternion<double> q = draw.pose();
  if (!draw.random.once_in(3)) return q;
  for (double* x : {&q.w, &q.x, &q.y, &q.z}) {
    if (draw.random.once_in(2)) continue;
    // A unit in the last place, or a little number where there was none.
    if (*x == 0) {
      *x = digits(draw.random) * power_of_ten(-draw.random.integer(1, k));
    } else {
      *x *= draw.random.once_in(2) ? 1 + 0x1p-52 : 1 - 0x1p-53;
    }
  }
  return q;
}

Shape<double> leaf(Draw& draw, int k) {
  Random& random = draw.random;
  const Vec3<double> a = triple(random, k), b = triple(random, k), c = triple(random, k);
  switch (random.below(8)) {
    case 0:
      return Point<double>{};
    case 1:
      return Box<double>{Vec3<double>(std::abs(a[0]), std::abs(a[1]), std::abs(a[2]))};
    case 2:
    case 3:
      return Segment<double>{a, b};
    case 4: {
      std::vector<Vec3<double>> list = {a, b, c};
      const int vertices = random.integer(4, 8);
      while (static_cast<int>(list.size()) < vertices) list.push_back(triple(random, k));
      return Hull<double>(std::span<const Vec3<double>>(list));
    }
    case 5:
      if (random.once_in(2)) return Sphere<double>{std::abs(a[0])};
      return Capsule<double>{std::abs(a[0]), std::abs(a[1])};
    default:
      return Triangle<double>{a, b, c};
  }
}

Shape<double> tree(Draw& draw, int k, int depth) {
  Random& random = draw.random;
  if (depth == 0) return leaf(draw, k);
  Shape<double> first = tree(draw, k, depth - 1);
  switch (random.below(5)) {
    case 0: {
      const Vec3<double> position = triple(random, k);
      return posed<double>(std::move(first), position, pose(draw, k));
    }
    case 1:
      return swept<double>(std::move(first), triple(random, k));
    case 2:
      return hull_of<double>(std::move(first), leaf(draw, k));
    default: {
      Shape<double> second = tree(draw, k, random.integer(0, depth - 1));
      return sum<double>(std::move(first), std::move(second));
    }
  }
}

void fill_mixed_magnitudes(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const int k = std::min(static_cast<int>(hardness), kGreatestExponent);
  problem.a.shape = tree(draw, k, random.integer(0, 2));
  problem.b.shape = tree(draw, k, random.integer(0, 2));
  problem.a.orientation = pose(draw, k);
  problem.b.orientation = random.once_in(2) ? Quaternion<double>{} : pose(draw, k);
  if (random.once_in(2)) problem.a.position = triple(random, k);
  problem.b.position = triple(random, k);
  if (random.once_in(2)) {
    // Home, or past it, or half of the way.
    constexpr double kWays[] = {1, 1, 1, 2, 0.5};
    const double way = kWays[random.below(std::size(kWays))];
    for (int i = 0; i < 3; ++i) {
      const double there = 0 - way * (problem.b.position[i] - problem.a.position[i]);
      problem.b.displacement[i] = std::abs(there) < kLeast ? 0 : there;
    }
  } else {
    problem.b.displacement = triple(random, k);
    if (random.once_in(4)) problem.a.displacement = triple(random, k);
  }
  draw_horizon(random, problem);
  maybe_swap(draw, problem);
}

constexpr double kMixedMagnitudesLevels[] = {1, 2, 3, 5, 8, 12, 16, 20, 30, 40, 50, 59};

}  // namespace

const Family family::mixed_magnitudes{
    .name = "mixed_magnitudes",
    .sentence = "Sums and nested poses of coordinates of very different size.",
    .hardness_meaning = "k: coordinates are 0, or 10^-k to 10^k in size, each by itself",
    .levels = kMixedMagnitudesLevels,
    .fill = fill_mixed_magnitudes,
    .picture = {1, 1},
};

}  // namespace graze::corpus
