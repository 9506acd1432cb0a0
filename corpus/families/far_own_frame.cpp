// far_own_frame: two bodies, one of them or both 10^k out in their own frames, meet near the origin.
// Hardness: k. The offset does not appear in the world: positions cancel it, up to the rounding of a number
// of that size. `far_from_origin` has the offset in the world, and both bodies there. This breaks code that
// rotates a vertex before subtracting, code that measures a body from the origin of its frame, and a rounding
// bound that uses the size of the body only.
#include "corpus/families/far_own_frame.hpp"

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {

Vec3<double> far_offset(Draw& draw, double size) {
  Random& random = draw.random;
  Vec3<double> out;
  do {
    for (int i = 0; i < 3; ++i) {
      out[i] = random.once_in(2) ? size * random.uniform(0.5, 1) : 0;
      if (random.once_in(2)) out[i] = 0 - out[i];
    }
  } while (out == Vec3<double>::Zero());
  return out;
}

void push_out(Body<double>& body, Spin& spin, const Vec3<double>& offset) {
  const auto moved = [&](const Vec3<double>& x) {
    return Vec3<double>(x[0] + offset[0], x[1] + offset[1], x[2] + offset[2]);
  };
  if (const auto* hull = std::get_if<Hull<double>>(&body.shape)) {
    std::vector<Vec3<double>> list;
    for (const Vec3<double>& v : hull->vertices()) list.push_back(moved(v));
    body.shape = Hull<double>(std::span<const Vec3<double>>(list));
  } else if (const auto* segment = std::get_if<Segment<double>>(&body.shape)) {
    body.shape = Segment<double>{moved(segment->a), moved(segment->b)};
  } else if (const auto* triangle = std::get_if<Triangle<double>>(&body.shape)) {
    body.shape = Triangle<double>{moved(triangle->a), moved(triangle->b), moved(triangle->c)};
  } else {
    body.shape = translated<double>(std::move(body.shape), offset);
  }
  spin.pivot = moved(spin.pivot);
  const Vec3<double> out = rotate(body.orientation, offset);
  for (int i = 0; i < 3; ++i) body.position[i] = 0 + (body.position[i] - out[i]);
}

namespace {

void fill_far_own_frame(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  problem.a.shape = random.once_in(3) ? draw.leaf(kReach, 0) : draw.shape(kReach, random.integer(4, 12));
  problem.b.shape = random.once_in(3) ? draw.leaf(kReach, 0) : draw.shape(kReach, random.integer(4, 12));
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  // A float has no digit left of a body that is 2^24 sizes out.
  draw.coordinates = Coordinates::doubles;
  const double size = power_of_ten(static_cast<int>(hardness));
  const int which = random.integer(0, 3);  // A, B, or both in half of them
  Spin none;
  if (which != 1) push_out(problem.a, none, far_offset(draw, size));
  if (which != 0) push_out(problem.b, none, far_offset(draw, size));
  aim(draw, problem, random.once_in(2) ? 0.25 : kReach);
  maybe_swap(draw, problem);
}

constexpr double kFarOwnFrameLevels[] = {2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

}  // namespace

const Family family::far_own_frame{
    .name = "far_own_frame",
    .sentence = "A random pair, near the origin, of bodies that lie far out in their own frames.",
    .hardness_meaning = "k: they are about 10^k out, for shapes of size 4",
    .levels = kFarOwnFrameLevels,
    .fill = fill_far_own_frame,
    .picture = {6, 1},
};

}  // namespace graze::corpus
