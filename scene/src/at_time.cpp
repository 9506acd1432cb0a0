// Bodies as they stand at t. R(w t) x about the pivot, as in rotating_body.hpp: by quaternions, in doubles.
#include <graze/detail/rotating/turn.hpp>
#include <graze/scene/memory.hpp>

namespace graze::scene {
namespace {

using detail::fl;

// l r, of length 1.
Quaternion<double> product(const Quaternion<double>& l, const Quaternion<double>& r) {
  const double w = fl(l.w * r.w) - fl(l.x * r.x) - fl(l.y * r.y) - fl(l.z * r.z),
               x = fl(l.w * r.x) + fl(l.x * r.w) + fl(l.y * r.z) - fl(l.z * r.y),
               y = fl(l.w * r.y) + fl(l.y * r.w) + fl(l.z * r.x) - fl(l.x * r.z),
               z = fl(l.w * r.z) + fl(l.z * r.w) + fl(l.x * r.y) - fl(l.y * r.x),
               length = detail::square_root(fl(w * w) + fl(x * x) + fl(y * y) + fl(z * z));
  return {w / length, x / length, y / length, z / length};
}
Vec3<double> rotated(const Quaternion<double>& q, const Vec3<double>& x) {
  return detail::operator*(detail::rotation_matrix(q), x);
}

}  // namespace

Scene at_time(const Scene& scene, double t) {
  Scene out = scene;
  for (Member& member : out.bodies) {
    Body<double>& body = member.body.body;
    const Vec3<double> way = detail::operator*(t, body.displacement);
    if (member.body.rotation == Vec3<double>::Zero()) {
      if (way != Vec3<double>::Zero()) body.position += way;
      continue;
    }
    const detail::Turn turn = detail::TurnsAbout(member.body.rotation).at(t);
    const Quaternion<double> before = product({}, body.orientation),
                             after = product({turn.w.hi, turn.v[0].hi, turn.v[1].hi, turn.v[2].hi}, before);
    const Vec3<double>& pivot = member.body.pivot;
    body.position += rotated(before, pivot) - rotated(after, pivot) + way;
    body.orientation = after;
  }
  return out;
}

}  // namespace graze::scene
