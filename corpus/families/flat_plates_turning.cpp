// flat_plates_turning: a point or a small body is shot through a rotating plate without thickness. Hardness:
// k, the body is 10^-k in size, and from 17 on a point.
//
// The plate is a box, a disk, an ellipse, a triangle or a hull in one plane. It turns by a fraction of a
// radian or by a few. The other body spins at any speed. They come together at a drawn time, at a point of
// the plate or beside it. Before and after the moment of contact the bodies are apart. There is no depth, so
// only a crossing can show contact.
//
// This breaks a proof of contact by an overlap, and a march that stops before the plate and gives neither
// answer.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

Shape<double> flat_plate(Draw& draw) {
  Random& random = draw.random;
  const double x = draw.real(random.uniform(0.5, 4)), y = draw.real(random.uniform(0.5, 4));
  switch (random.below(6)) {
    case 0:
      return Triangle<double>{Vec3<double>(-x, -y, 0), Vec3<double>(x, -y, 0), Vec3<double>(-x, y, 0)};
    case 1:
      return Cylinder<double>{x, 0};
    case 2:
      return Ellipsoid<double>{Vec3<double>(x, y, 0)};
    case 3: {
      std::vector<Vec3<double>> list;
      const int corners = random.integer(4, 8);
      for (int i = 0; i < corners; ++i) {
        const double u = draw.real(random.uniform(-x, x));
        list.emplace_back(u, draw.real(random.uniform(-y, y)), 0);
      }
      return Hull<double>(std::span<const Vec3<double>>(list));
    }
    default:
      return Box<double>{Vec3<double>(x, y, 0)};
  }
}

Shape<double> bullet(Draw& draw, int k) {
  constexpr int kLastSize = 16;
  if (k > kLastSize) return Point<double>{};
  const double size = draw.real(power_of_ten(-k) * draw.random.uniform(0.5, 1));
  switch (draw.random.below(4)) {
    case 0:
      return Sphere<double>{size};
    case 1:
      return Segment<double>{Vec3<double>::Zero(), Vec3<double>(size, 0, 0)};
    default:
      return Box<double>{Vec3<double>(size, size / 2, size / 4)};
  }
}

// By about 2^-j radians.
Quaternion<double> slight_turn(Draw& draw) {
  Quaternion<double> q = some_turn(draw);
  q.w = power_of_two(draw.random.integer(2, 14));
  return q;
}

void fill_flat_plates_turning(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  problem.a.shape = flat_plate(draw);
  problem.b.shape = bullet(draw, static_cast<int>(hardness));
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  for (int i = 0; i < 3; ++i) problem.a.position[i] = draw.coordinate(1);
  if (random.once_in(3)) problem.spin_a.pivot = draw.vector(4);
  Meeting meeting;
  meeting.t = meeting_time(draw);
  meeting.turn_a = random.once_in(2) ? slight_turn(draw) : some_turn(draw);
  if (random.once_in(2)) {
    meeting.turn_b = some_turn(draw);
    meeting.turns_b = random.integer(0, 2);
  }
  Vec3<double> v = draw.vector(4);
  v[random.integer(0, 2)] = random.once_in(2) ? 8 : -8;
  set_motion(draw, problem, v);
  meet(draw, problem, meeting, random.once_in(3) ? 0 : 1);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kFlatPlatesTurningLevels[] = {1, 2, 4, 6, 8, 12, 16, 17};  // 17: a point

}  // namespace

const Family family::flat_plates_turning{
    .name = "flat_plates_turning",
    .sentence = "A point or a small body is shot through a rotating plate that has no thickness.",
    .hardness_meaning = "k: the small body is 10^-k in size; 17 is a point",
    .levels = kFlatPlatesTurningLevels,
    .fill = fill_flat_plates_turning,
    .rotating = true,
    .picture = {1, 3},
};

}  // namespace graze::corpus
