// Bodies as they stand at t. R(w t) x about the pivot, as in rotating_body.hpp: by quaternions, in doubles.
#include <graze/scene/memory.hpp>

#include <Eigen/Geometry>

namespace graze::scene {

Scene at_time(const Scene& scene, double t) {
  Scene out = scene;
  for (Member& member : out.bodies) {
    Body<double>& body = member.body.body;
    const Vec3<double> way = t * body.displacement;
    if (member.body.rotation == Vec3<double>::Zero()) {
      if (way != Vec3<double>::Zero()) body.position += way;
      continue;
    }
    const double angle = t * member.body.rotation.norm();
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, member.body.rotation.normalized()));
    const Eigen::Quaterniond before =
        Eigen::Quaterniond(body.orientation.w, body.orientation.x, body.orientation.y, body.orientation.z)
            .normalized();
    const Eigen::Quaterniond after = (turn * before).normalized();
    const Vec3<double>& pivot = member.body.pivot;
    body.position += before * pivot - after * pivot + way;
    body.orientation = {after.w(), after.x(), after.y(), after.z()};
  }
  return out;
}

}  // namespace graze::scene
