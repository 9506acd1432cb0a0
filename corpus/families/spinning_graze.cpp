// spinning_graze: a spinning body passes a plane, and the body that stands on it, with the feature that
// reaches furthest from the axis. Hardness: k, the distance is 2^-k. Above the feature this is a miss with
// that clearance, below it a hit with at most that depth.
//
// The side is known without evaluating sines. The spinning body lies within `reach` of its axis, a rational
// (a Pythagorean triple, a sum). The plane is reach + delta away from it, and the turn is long enough to pass
// the nearest point, wherever in time that is. Start poses are turns about the axis by integer quaternions,
// which keep the reach exactly. With floats and integers the scene is then turned by a rotation of the cube:
// clearance and depth stay exact. With full doubles it is turned by any integer quaternion, and the
// positions, the axis and the normal are rounded. Then delta is known to about 2^-47.
#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

void fill_spinning_graze(Draw& draw, double hardness, Case& problem) {
  const double size = power_of_two(-static_cast<int>(hardness));
  const double delta = draw.random.once_in(2) ? size : -size;
  spin_past(draw, problem, delta, 3.7, 9);
}

constexpr double kSpinningGrazeLevels[] = {4, 8, 12, 16, 20, 24, 28, 32, 36, 40};

}  // namespace

const Family family::spinning_graze{
    .name = "spinning_graze",
    .sentence = "A spinning corner just passes, or just meets, a face, an edge, a corner or a round body.",
    .hardness_meaning = "k: the clearance is 2^-k, or the depth at most that, for shapes of size 4 to 16",
    .levels = kSpinningGrazeLevels,
    .fill = fill_spinning_graze,
    .rotating = true,
    .picture = {12, 6},
};

}  // namespace graze::corpus
