// rods_and_round: a rod or a plate, very long beside the round body that it meets. Hardness: k, it is 10^k
// times as long as that.
//
// The rod is a box, a triangle, a segment or a capsule, one or two of its extents 10^k, the others about 1.
// The round body is an ellipsoid, a cone or a cylinder of size 1. They meet anywhere along the rod, near an
// end or at one.
//
// This breaks the weights of a portal whose corners are 10^k apart, because the last weight is a difference.
// A point of contact that is their sum is off its body by as much as the weights differ from a sum of 1.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

Shape<double> round_body(Draw& draw) {
  Random& random = draw.random;
  Vec3<double> r;
  for (int i = 0; i < 3; ++i) r[i] = draw.real(random.uniform(0.1, 1));
  switch (random.below(4)) {
    case 0:
      return Cone<double>{r[0], r[1]};
    case 1:
      return Cylinder<double>{r[0], r[1]};
    default:
      return Ellipsoid<double>{r};
  }
}

void fill_rods_and_round(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double aspect = power_of_ten(static_cast<int>(hardness));
  Vec3<double> half;
  for (int i = 0; i < 3; ++i) half[i] = draw.real(random.uniform(0.1, 1));
  half[0] = draw.real(aspect * random.uniform(0.5, 2));
  if (random.once_in(3)) half[1] = draw.real(aspect * random.uniform(0.5, 2));

  problem.a.shape = round_body(draw);
  problem.a.orientation = draw.pose();
  switch (random.below(8)) {
    case 0:
      problem.b.shape = Segment<double>{Vec3<double>(-half[0], 0, 0), Vec3<double>(half[0], 0, 0)};
      break;
    case 1:
      problem.b.shape = Triangle<double>{Vec3<double>(-half[0], -half[1], 0), Vec3<double>(half[0], 0, 0),
                                         Vec3<double>(-half[0], half[1], half[2])};
      break;
    case 2:
      problem.b.shape = Capsule<double>{half[2], half[0]};
      break;
    case 3:  // two round bodies
      problem.b.shape = Cylinder<double>{half[2], half[0]};
      break;
    default:
      problem.b.shape = Box<double>{half};
      break;
  }
  problem.b.orientation = draw.pose();
  // Along the rod: at an end, near one, or anywhere.
  constexpr double kPlaces[] = {1, 1, 0.99, 0.5, 0};
  Vec3<double> place;
  for (int i = 0; i < 3; ++i) place[i] = random.uniform(-1, 1) * half[i];
  const double along = kPlaces[random.below(std::size(kPlaces))] * half[0];
  const bool upright = std::holds_alternative<Capsule<double>>(problem.b.shape) ||
                       std::holds_alternative<Cylinder<double>>(problem.b.shape);
  if (upright) {
    place = Vec3<double>(half[2], 0, along);
  } else {
    place[0] = along;
  }
  if (random.once_in(2)) place = Vec3<double>(0 - place[0], 0 - place[1], 0 - place[2]);
  Vec3<double> v = draw.vector(8);
  v[random.integer(0, 2)] = random.once_in(2) ? 12 : -12;
  Vec3<double> beside;
  for (int i = 0; i < 3; ++i) beside[i] = random.uniform(-1, 1);
  const double t = meeting_time(random);
  meet(draw, problem, Vec3<double>::Zero(), rotate(problem.b.orientation, place), beside, v, t);
  draw_horizon(random, problem);
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kRodsAndRoundLevels[] = {0, 1, 2, 3, 4, 5, 6};

}  // namespace

const Family family::rods_and_round{
    .name = "rods_and_round",
    .sentence = "A long rod or plate against an ellipsoid, a cone or a cylinder.",
    .hardness_meaning = "k: the rod is about 10^k long, beside round bodies of size 1",
    .levels = kRodsAndRoundLevels,
    .fill = fill_rods_and_round,
    .picture = {1, 5},
};

}  // namespace graze::corpus
