#include "properties/generate/tip_contact.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "corpus/families/draw.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/meeting.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;
using corpus::Spin;

namespace {

// In a plane across the axis, the handle first, or last, and thin beside its length.
Shape<double> whip(Random& random, int axis, const Vec3<double>& handle, const Vec3<double>& tip) {
  const Vec3<double> across = Vec3<double>::Unit(axis) * std::scalbn(1.0, -random.integer(2, 12)),
                     third = (random.once_in(2) ? tip : handle) + across;
  switch (random.below(8)) {
    case 0:
    case 1:
      return Segment<double>{handle, tip};
    case 2:
      return Segment<double>{tip, handle};
    case 3:
    case 4:
      return Triangle<double>{handle, third, tip};
    case 5:
      return Triangle<double>{tip, handle, third};
    default: {
      std::vector<Vec3<double>> vertices = {handle, tip};
      if (random.once_in(2)) vertices.insert(vertices.begin() + random.integer(0, 2), third);
      if (random.once_in(2)) vertices.insert(vertices.begin(), Vec3<double>((handle + tip) / 2 - across));
      if (random.once_in(2)) std::swap(vertices.front(), vertices.back());
      return Hull<double>(std::span<const Vec3<double>>(vertices));
    }
  }
}

// The point of the body at the meeting, less its position: the corner that is first in the way of something moving
// along n. A body without corners, and every second one, becomes a ball.
Vec3<double> front(Random& random, Body<double>& body, const Spin& spin, const Quaternion<double>& turn,
                   double t, const Vec3<double>& n) {
  constexpr std::size_t kMost = 64;
  const auto corners = exact_vertices(body.shape, kMost);
  if (!corners || corners->empty() || random.once_in(2)) {
    const double radius = random.integer(0, 3);
    body.shape = Sphere<double>{radius};
    return carried(body, spin, turn, t, Vec3<double>::Zero()) - radius * n;
  }
  Vec3<double> first = carried(body, spin, turn, t, corners->front());
  for (const Vec3<double>& corner : *corners) {
    const Vec3<double> x = carried(body, spin, turn, t, corner);
    if (n.dot(x) < n.dot(first)) first = x;
  }
  return first;
}

}  // namespace

Lash draw_lash(Random& random) {
  const bool is_a = random.once_in(2);
  return {is_a, random.integer(0, 2)};
}

Quaternion<double> draw_turn_of(const Lash& lash, Random& random) {
  Quaternion<double> q;
  q.w = random.integer(-2, 3);
  const int size = random.integer(1, 3);
  (lash.axis == 0 ? q.x : lash.axis == 1 ? q.y : q.z) = random.once_in(2) ? size : -size;
  return q;
}

void place_lash(Random& random, const Lash& lash, Case& problem, const Quaternion<double>& turn_a,
                const Quaternion<double>& turn_b, double t) {
  Body<double>&moving = lash.is_a ? problem.a : problem.b, &other = lash.is_a ? problem.b : problem.a;
  Spin &spin = lash.is_a ? problem.spin_a : problem.spin_b,
       &its = lash.is_a ? problem.spin_b : problem.spin_a;
  Vec3<double> handle = Vec3<double>::Zero();
  if (random.once_in(2)) {
    for (int i = 0; i < 3; ++i) handle[i] = random.integer(-4, 4);
  }
  const Vec3<double> along = Vec3<double>::Unit((lash.axis + random.integer(1, 2)) % 3);
  const Vec3<double> arm = random.integer(2, 24) * along, tip = handle + arm;
  moving.shape = whip(random, lash.axis, handle, tip);
  moving.orientation = random.once_in(2) ? Quaternion<double>{} : draw_turn_of(lash, random);
  spin.pivot = handle;
  if (!random.once_in(3)) moving.displacement = other.displacement;

  const Quaternion<double>&turn = lash.is_a ? turn_a : turn_b, &its_turn = lash.is_a ? turn_b : turn_a;
  const Vec3<double> path =
      corpus::rotate(turn, spin.rotation.cross(corpus::rotate(moving.orientation, arm)));
  const Vec3<double> ahead =
      path.isZero(0) ? Vec3<double>::Unit(lash.axis) : Vec3<double>(path / path.norm());
  moving.position =
      other.position + front(random, other, its, its_turn, t, ahead) - carried(moving, spin, turn, t, tip);
  if (random.once_in(4)) moving.position += draw_beside(random) * ahead;
}

}  // namespace graze::law
