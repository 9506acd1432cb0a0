// touching: a gap of exactly 0, or of a few units in the last place of 1, at the start, either sign.
// Hardness: minus the number of units (2^-23 with floats, 2^-52 else), so that 0, touching, is the hardest.
//
// Frame: the plane of contact is z = 1, and B's position is 1 + gap along z, exact. The motion approaches,
// leaves, slides or is zero. The scene is turned by a rotation of the cube, and bodies about z: the gap stays
// exact.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

void fill_touching(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  const double unit = draw.coordinates == Coordinates::floats ? 0x1p-23 : 0x1p-52;
  const double size = -hardness * unit;
  const double gap = random.once_in(2) ? size : 0 - size;

  const Capped a = draw.capped(kReach), b = draw.capped_below(kReach);
  problem.a.shape = a.shape;
  problem.b.shape = b.shape;
  if (random.once_in(3)) problem.a.orientation = draw.pose_about_z();
  if (random.once_in(3)) problem.b.orientation = draw.pose_about_z();
  problem.a.position = Vec3<double>(0, 0, 1 + (a.lift - b.lift));
  problem.b.position = Vec3<double>(0, 0, 1 + gap);
  // On a box's face the contact may be anywhere.
  if (const auto* box = std::get_if<Box<double>>(&a.shape);
      box != nullptr && problem.a.orientation.is_identity()) {
    problem.b.position[0] = draw.on_grid(box->half_extents[0]);
    problem.b.position[1] = draw.on_grid(box->half_extents[1]);
  }

  Vec3<double> v(draw.on_grid(8), 0, 0);
  v[1] = draw.on_grid(8);
  switch (random.below(6)) {
    case 0:
      break;  // slides
    case 1:
      v = Vec3<double>::Zero();
      break;  // rests
    case 2:
      v[2] = draw.positive_on_grid(8);
      break;  // leaves
    default:
      v[2] = 0 - draw.positive_on_grid(8);
      break;
  }
  set_motion(draw, problem, v);
  vary_time_scale(draw, problem);
  turn_exactly(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kTouchingLevels[] = {-1024, -64, -8, -4, -2, -1, 0};

}  // namespace

const Family family::touching{
    .name = "touching",
    .sentence = "Bodies that start in touch, or within a few units in the last place of it.",
    .hardness_meaning =
        "-n: the gap is n units in the last place of 1 (2^-23 or 2^-52), either sign; 0 touches",
    .levels = kTouchingLevels,
    .fill = fill_touching,
    .picture = {-8, 4},
};

}  // namespace graze::corpus
