// far_from_origin: a random pair moved away from the origin by 10^k along some axes. Hardness: k. Offsets are
// in the positions. With full doubles, one time in three, they are in the vertices of the hulls instead.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

void fill_far_from_origin(Draw& draw, double hardness, Case& problem) {
  constexpr double kVertices = 8;
  family::random.fill(draw, kVertices, problem);
  Random& random = draw.random;
  const double distance = power_of_ten(static_cast<int>(hardness));
  Vec3<double> offset;
  do {
    for (int i = 0; i < 3; ++i) {
      offset[i] = random.once_in(2) ? draw.snap(distance * random.uniform(0.5, 1)) : 0;
      if (random.once_in(2)) offset[i] = 0 - offset[i];
    }
  } while (offset == Vec3<double>::Zero());

  const bool in_vertices = draw.coordinates == Coordinates::doubles && random.once_in(3);
  for (Body<double>* body : {&problem.a, &problem.b}) {
    const auto* hull = std::get_if<Hull<double>>(&body->shape);
    if (in_vertices && hull != nullptr) {
      std::vector<Vec3<double>> moved;
      for (const Vec3<double>& v : hull->vertices()) {
        moved.emplace_back(v[0] + offset[0], v[1] + offset[1], v[2] + offset[2]);
      }
      body->shape = Hull<double>(std::span<const Vec3<double>>(moved));
      body->orientation = {};
    } else {
      for (int i = 0; i < 3; ++i) body->position[i] = draw.snap(body->position[i] + offset[i]);
    }
  }
}

constexpr double kFarFromOriginLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};

}  // namespace

const Family family::far_from_origin{
    .name = "far_from_origin",
    .sentence = "A random pair far from the origin.",
    .hardness_meaning = "k: the offset is about 10^k, for shapes of size 4",
    .levels = kFarFromOriginLevels,
    .fill = fill_far_from_origin,
    .picture = {6, 6},
};

}  // namespace graze::corpus
