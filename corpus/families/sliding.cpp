// sliding: bodies that start in touch exactly, and slide off, along, or into each other. Hardness: k, the
// normal n of the plane of contact has |n.v| = 10^-k of the largest component of v (k > 16: exactly 0). Both
// policies for starts occur.
//
// Exact, as in `touching`: the plane of contact is z = 1, its sides are the bodies' features there, n = z,
// and v's z-component is unrounded. A rotation of the cube keeps all that.
//
// Difficulty: the sign of n.v decides between a contact and a start that is passed over. It is below the
// rounding of any normal that was not computed exactly.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

constexpr int kLastTilt = 16;

void fill_sliding(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  const Capped a = draw.capped(kReach), b = draw.capped_below(kReach);
  problem.a.shape = a.shape;
  problem.b.shape = b.shape;
  if (random.once_in(3)) problem.a.orientation = draw.pose_about_z();
  if (random.once_in(3)) problem.b.orientation = draw.pose_about_z();
  problem.a.position = Vec3<double>(0, 0, 1 + (a.lift - b.lift));
  problem.b.position = Vec3<double>(0, 0, 1);
  // On a box's face the contact may be anywhere, its edges and corners included.
  if (const auto* box = std::get_if<Box<double>>(&a.shape);
      box != nullptr && problem.a.orientation.is_identity()) {
    for (int i = 0; i < 2; ++i) {
      const double half = box->half_extents[i];
      problem.b.position[i] = random.once_in(4) ? (random.once_in(2) ? half : -half) : draw.on_grid(half);
    }
  }

  // The largest component is a power of two, so that its tilt is 10^-k as this kind of coordinate has it.
  const double speed = static_cast<double>(1 << random.integer(0, 5));
  const int k = static_cast<int>(hardness), axis = random.integer(0, 1);
  Vec3<double> v = Vec3<double>::Zero();
  v[axis] = random.once_in(2) ? speed : -speed;
  if (random.once_in(2)) v[1 - axis] = draw.on_grid(speed);
  const double tilt = k > kLastTilt ? 0 : speed * draw.real(power_of_ten(-k));
  v[2] = random.once_in(2) ? tilt : 0 - tilt;
  problem.a.displacement = Vec3<double>::Zero();
  problem.b.displacement = v;
  if (random.once_in(4)) {
    // A moves instead of B.
    problem.a.displacement = Vec3<double>(0 - v[0], 0 - v[1], 0 - v[2]);
    problem.b.displacement = Vec3<double>::Zero();
  }
  if (random.once_in(2)) problem.start_policy = StartPolicy::pass_over;
  if (random.once_in(8)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  turn_exactly(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kSlidingLevels[] = {0, 1, 2, 4, 6, 8, 10, 12, 14, 16, 17};

}  // namespace

const Family family::sliding{
    .name = "sliding",
    .sentence = "Bodies in touch that slide off, along, or into each other.",
    .hardness_meaning = "k: |n.v| is 10^-k of the largest component of v; 17 is exactly along the face",
    .levels = kSlidingLevels,
    .fill = fill_sliding,
    .picture = {2, 3},
};

}  // namespace graze::corpus
