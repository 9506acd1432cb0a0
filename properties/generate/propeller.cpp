#include "properties/generate/propeller.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "corpus/families/draw.hpp"
#include "corpus/support_value.hpp"
#include "properties/generate/meeting.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;
using corpus::Spin;

namespace {

// In the body's own frame.
Vec3<double> own(const Body<double>& body, const Vec3<double>& n) {
  const Quaternion<double>& q = body.orientation;
  return corpus::rotate({q.w, -q.x, -q.y, -q.z}, n);
}

}  // namespace

void place_propeller(Random& random, bool a_turns, Case& problem, double horizon) {
  Body<double>&moving = a_turns ? problem.a : problem.b, &other = a_turns ? problem.b : problem.a;
  const Spin& spin = a_turns ? problem.spin_a : problem.spin_b;
  if (spin.rotation.isZero(0)) return;  // rounded away
  const Vec3<double> axis = spin.rotation / spin.rotation.norm();
  const Vec3<double> n = own(moving, axis);
  const double gap = std::scalbn(1.0, random.integer(-3, 2)),
               height = corpus::support_value(moving.shape, n) - n.dot(spin.pivot) + gap +
                        corpus::support_value(other.shape, own(other, -axis));
  // On the axis, or where a point passes, or a quarter of a turn before or after that, or between.
  const Vec3<double> arm =
                         corpus::rotate(moving.orientation, draw_feature(random, moving.shape) - spin.pivot),
                     across = axis.cross(arm), out = random.once_in(2) ? across : across.cross(axis);
  other.position = moving.position + corpus::rotate(moving.orientation, spin.pivot) + height * axis;
  if (random.once_in(2)) other.position += random.integer(-4, 4) / 4.0 * out;
  constexpr std::array kNearer = {0.0, 1.0, 2.0, 4.0, 8.0};  // over the gap, at the horizon
  other.displacement = moving.displacement - kNearer[random.below(kNearer.size())] * gap / horizon * axis;
}

}  // namespace graze::law
