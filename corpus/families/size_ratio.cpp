// size_ratio: a body of size about 4 dropped on one 10^k times as large, anywhere over its top. Hardness: k.
// The supports of C are 10^k larger than the gap, so a direction off by u loses k digits of the time.
#include <cmath>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

// A plate, a prism or a ball with its top at z = 0. `reach` is its half width.
Capped large_body(Draw& draw, double reach) {
  Random& random = draw.random;
  const double depth = draw.snap(reach * random.uniform(0.25, 1) + 1);
  switch (random.below(4)) {
    case 0:
      return {Sphere<double>{reach}, -reach};
    case 1: {
      // The square -reach..reach on top, and a smaller polygon below.
      std::vector<Vec3<double>> list = {
          {reach, reach, 0}, {-reach, reach, 0}, {-reach, -reach, 0}, {reach, -reach, 0}};
      const int vertices = random.integer(5, 24);
      while (static_cast<int>(list.size()) < vertices) {
        const double x = draw.coordinate(reach), y = draw.coordinate(reach);
        list.emplace_back(x, y, -depth);
      }
      return {Hull<double>(std::span<const Vec3<double>>(list)), 0};
    }
    default:
      return {Box<double>{Vec3<double>(reach, reach, depth)}, -depth};
  }
}

void fill_size_ratio(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  const double reach = draw.snap(random.uniform(2, 4) * power_of_ten(static_cast<int>(hardness)));
  const Capped large = large_body(draw, reach);
  problem.a.shape = large.shape;
  problem.a.position = Vec3<double>(0, 0, 0 + large.lift);
  problem.b.shape = draw.shape(kReach, random.integer(4, 24));
  problem.b.orientation = draw.pose();

  // Over the whole top, now and then beside it. Over a ball, near its pole, in place of a flat top.
  const bool ball = std::holds_alternative<Sphere<double>>(large.shape);
  const double spread = ball ? std::sqrt(reach) : 1.1 * reach;
  const double x = draw.coordinate(spread), y = draw.coordinate(spread);
  const double height = draw.snap(bounding_radius(problem.b.shape) + random.uniform(0.5, 8) + 1);
  problem.b.position = Vec3<double>(x, y, height);
  // Down, often aslant, and one time in six not far enough.
  const double fall = random.once_in(6) ? 0.25 : random.uniform(1, 2);
  Vec3<double> v(0, 0, draw.snap(-2 * height * fall));
  if (random.once_in(2)) {
    v[0] = draw.coordinate(16);
    v[1] = draw.coordinate(16);
  }
  set_motion(draw, problem, v);
  if (random.once_in(16)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  if (draw.coordinates == Coordinates::integers || random.once_in(2)) {
    turn_exactly(draw, problem);
  } else {
    turn_rounded(draw, problem);
  }
  maybe_swap(draw, problem);
}

constexpr double kSizeRatioLevels[] = {0, 1, 2, 3, 4, 5, 6};

}  // namespace

const Family family::size_ratio{
    .name = "size_ratio",
    .sentence = "A small body falls anywhere on a large one.",
    .hardness_meaning = "k: the large body is 10^k times as large",
    .levels = kSizeRatioLevels,
    .fill = fill_size_ratio,
    .picture = {3, 4},
};

}  // namespace graze::corpus
