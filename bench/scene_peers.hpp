// Whole scenes as third-party engines answer them: their broad phase over the bodies' swept boxes, and their cast of
// every pair that it finds.
#pragma once

#include <Eigen/Geometry>
#include <graze/scene.hpp>

#include <memory>

namespace graze::bench {

struct PeerContact {
  std::uint32_t a = 0, b = 0;  // a < b
  double time = 0;
};

struct PeerAnswer {
  std::size_t pairs = 0;  // that the broad phase passes to the casts
  std::vector<PeerContact> contacts;
};

// A scene in the other engine's terms. Data that its users keep from step to step (shapes, transforms) is made once.
class PeerScene {
 public:
  PeerScene() = default;
  PeerScene(const PeerScene&) = delete;
  PeerScene& operator=(const PeerScene&) = delete;
  virtual ~PeerScene() = default;
  // Bounds, broad phase and casts, all anew.
  [[nodiscard]] virtual PeerAnswer run() const = 0;
};

// Returns nothing if the other engine has no such shape or motion: a combinator, a segment, a rotation of pi or more
// about a point that is not the body's origin.
[[nodiscard]] std::unique_ptr<PeerScene> bullet_scene(const scene::Scene& scene, double t_max);
[[nodiscard]] std::unique_ptr<PeerScene> fcl_scene(const scene::Scene& scene, double t_max);

// The visible part of a body's rotation. A solid of revolution about its axis has none.
[[nodiscard]] inline Vec3<double> seen_rotation(const RotatingBody<double>& body) {
  const bool revolves = std::holds_alternative<Sphere<double>>(body.body.shape) ||
                        std::holds_alternative<Capsule<double>>(body.body.shape) ||
                        std::holds_alternative<Cylinder<double>>(body.body.shape);
  const Quaternion<double>& q = body.body.orientation;
  const Vec3<double> axis = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized() * Vec3<double>::UnitZ();
  const bool about_axis = body.rotation.cross(axis).norm() <= 1e-12 * body.rotation.norm();
  return revolves && about_axis && body.pivot == Vec3<double>::Zero() ? Vec3<double>(Vec3<double>::Zero())
                                                                      : body.rotation;
}
[[nodiscard]] inline bool is_common(const RotatingBody<double>& body, double t_max) {
  return seen_rotation(body) == Vec3<double>::Zero() ||
         (body.pivot == Vec3<double>::Zero() && body.rotation.norm() * t_max < 3.14);
}

}  // namespace graze::bench
