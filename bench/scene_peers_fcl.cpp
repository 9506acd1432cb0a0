// FCL, in double: DynamicAABBTreeCollisionManager over boxes about the bodies' paths (its managers of continuous
// objects are interfaces without an implementation). Its callback uses continuousCollide by conservative advancement,
// or collide for two bodies at rest.
#include <fcl/fcl.h>
#include <Eigen/Geometry>

#include "bench/scene_peers.hpp"

namespace graze::bench {
namespace {

std::shared_ptr<fcl::CollisionGeometryd> shape_of(const Shape<double>& shape) {
  if (const auto* box = std::get_if<Box<double>>(&shape))
    return std::make_shared<fcl::Boxd>(2 * box->half_extents);
  if (const auto* sphere = std::get_if<Sphere<double>>(&shape))
    return std::make_shared<fcl::Sphered>(sphere->radius);
  if (const auto* capsule = std::get_if<Capsule<double>>(&shape))
    return std::make_shared<fcl::Capsuled>(capsule->radius, 2 * capsule->half_height);
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape))
    return std::make_shared<fcl::Cylinderd>(cylinder->radius, 2 * cylinder->half_height);
  return nullptr;
}

struct Moving {
  std::shared_ptr<fcl::CollisionGeometryd> shape;
  fcl::Transform3d from, to;
  scene::Filter filter;
  bool moves = false, turns = false;
  fcl::AABBd way;
};

// Data for the manager's callback.
struct Found {
  const std::vector<Moving>& bodies;
  PeerAnswer answer;
};

double cast(const Moving& a, const Moving& b) {
  if (!a.moves && !b.moves) {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(a.shape.get(), a.from, b.shape.get(), b.from, request, result) > 0 ? 0 : -1;
  }
  fcl::ContinuousCollisionRequestd request;
  request.ccd_motion_type = a.turns || b.turns ? fcl::CCDM_LINEAR : fcl::CCDM_TRANS;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResultd result;
  fcl::continuousCollide(a.shape.get(), a.from, a.to, b.shape.get(), b.from, b.to, request, result);
  return result.is_collide ? result.time_of_contact : -1;
}

bool look(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* data) {
  Found& found = *static_cast<Found*>(data);
  const auto index = [&](fcl::CollisionObjectd* object) {
    return static_cast<std::uint32_t>(static_cast<const Moving*>(object->getUserData()) -
                                      found.bodies.data());
  };
  const std::uint32_t a = std::min(index(one), index(other)), b = std::max(index(one), index(other));
  if (!found.bodies[a].filter.meets(found.bodies[b].filter)) return false;
  ++found.answer.pairs;
  if (const double time = cast(found.bodies[a], found.bodies[b]); time >= 0)
    found.answer.contacts.push_back({a, b, time});
  return false;
}

class FclScene final : public PeerScene {
 public:
  explicit FclScene(double t_max) : t_max_(t_max) {}

  [[nodiscard]] bool add(const scene::Member& member) {
    const RotatingBody<double>& body = member.body;
    if (!is_common(body, t_max_)) return false;
    Moving moving;
    moving.shape = shape_of(body.body.shape);
    if (!moving.shape) return false;
    moving.shape->computeLocalAABB();
    const Quaternion<double>& q = body.body.orientation;
    const Eigen::Quaterniond turn = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
    const Vec3<double> rotation = seen_rotation(body);
    moving.turns = rotation != Vec3<double>::Zero();
    moving.moves = moving.turns || body.body.displacement != Vec3<double>::Zero();
    moving.from = moving.to = fcl::Transform3d::Identity();
    moving.from.linear() = moving.to.linear() = turn.toRotationMatrix();
    moving.from.translation() = body.body.position;
    moving.to.translation() = body.body.position + t_max_ * body.body.displacement;
    if (moving.turns) {
      const Eigen::AngleAxisd more(t_max_ * rotation.norm(), rotation.normalized());
      moving.to.linear() = (more * turn).toRotationMatrix();
    }
    moving.filter = member.filter;
    bodies_.push_back(std::move(moving));
    return true;
  }

  [[nodiscard]] PeerAnswer run() const override {
    std::vector<fcl::CollisionObjectd> objects;
    objects.reserve(bodies_.size());
    for (const Moving& body : bodies_) {
      // A rotating body is within its ball about the origin, which it rotates about.
      const fcl::CollisionGeometryd& shape = *body.shape;
      const Eigen::Vector3d ball = Eigen::Vector3d::Constant(shape.aabb_radius + shape.aabb_center.norm());
      fcl::AABBd way;
      for (const fcl::Transform3d& at : {body.from, body.to}) {
        const fcl::CollisionObjectd posed(body.shape, at);
        way += body.turns ? fcl::AABBd(at.translation() - ball, at.translation() + ball) : posed.getAABB();
      }
      fcl::Transform3d middle = fcl::Transform3d::Identity();
      middle.translation() = way.center();
      objects.emplace_back(std::make_shared<fcl::Boxd>(way.max_ - way.min_), middle);
      objects.back().setUserData(const_cast<Moving*>(&body));
    }
    fcl::DynamicAABBTreeCollisionManagerd manager;
    std::vector<fcl::CollisionObjectd*> all;
    for (fcl::CollisionObjectd& object : objects) all.push_back(&object);
    manager.registerObjects(all);
    manager.setup();
    Found found{bodies_, {}};
    manager.collide(&found, look);
    for (PeerContact& contact : found.answer.contacts) contact.time *= t_max_;
    return std::move(found.answer);
  }

 private:
  double t_max_;
  std::vector<Moving> bodies_;
};

}  // namespace

std::unique_ptr<PeerScene> fcl_scene(const scene::Scene& scene, double t_max) {
  auto out = std::make_unique<FclScene>(t_max);
  for (const scene::Member& member : scene.bodies) {
    if (!out->add(member)) return nullptr;
  }
  return out;
}

}  // namespace graze::bench
