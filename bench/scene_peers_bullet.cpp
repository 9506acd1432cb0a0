// Bullet, in float: btDbvtBroadphase over temporal boxes. Pairs that do not rotate use btSubsimplexConvexCast, rotating
// ones btContinuousConvexCollision. No cast of Bullet's takes a start in contact, so btGjkPairDetector with EPA is run
// at the start.
#include <btBulletCollisionCommon.h>

#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "bench/scene_peers.hpp"

namespace graze::bench {
namespace {

btVector3 vector_of(const Vec3<double>& x) { return {btScalar(x[0]), btScalar(x[1]), btScalar(x[2])}; }

std::unique_ptr<btConvexShape> shape_of(const Shape<double>& shape) {
  std::unique_ptr<btConvexShape> out;
  if (const auto* box = std::get_if<Box<double>>(&shape)) {
    out = std::make_unique<btBoxShape>(vector_of(box->half_extents));
  } else if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) {
    out = std::make_unique<btSphereShape>(btScalar(sphere->radius));
  } else if (const auto* capsule = std::get_if<Capsule<double>>(&shape)) {
    out = std::make_unique<btCapsuleShapeZ>(btScalar(capsule->radius), btScalar(2 * capsule->half_height));
  } else if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape)) {
    out = std::make_unique<btCylinderShapeZ>(
        vector_of({cylinder->radius, cylinder->radius, cylinder->half_height}));
  } else {
    return nullptr;
  }
  out->setMargin(0);
  return out;
}

// As Bullet moves a body: its origin along a line, its axes about one.
struct Moving {
  std::unique_ptr<btConvexShape> shape;
  btTransform from, to;
  btVector3 linear, angular;
  int group, mask;
  bool turns;
};

class BulletScene final : public PeerScene {
 public:
  explicit BulletScene(double t_max) : t_max_(t_max) {}

  [[nodiscard]] bool add(const scene::Member& member) {
    const RotatingBody<double>& body = member.body;
    if (!is_common(body, t_max_)) return false;
    Moving moving;
    moving.shape = shape_of(body.body.shape);
    if (!moving.shape) return false;
    const Quaternion<double>& q = body.body.orientation;
    btQuaternion turn{btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w)};
    turn.normalize();
    moving.from = btTransform(turn, vector_of(body.body.position));
    moving.linear = vector_of(body.body.displacement * t_max_);
    const Vec3<double> rotation = seen_rotation(body);
    moving.angular = vector_of(rotation * t_max_);
    moving.turns = rotation != Vec3<double>::Zero();
    btTransform to;
    if (moving.turns) {
      btTransformUtil::integrateTransform(moving.from, moving.linear, moving.angular, 1, to);
    } else {
      to = btTransform(turn, moving.from.getOrigin() + moving.linear);
    }
    moving.to = to;
    moving.group = static_cast<int>(member.filter.group);
    moving.mask = static_cast<int>(member.filter.mask);
    bodies_.push_back(std::move(moving));
    return true;
  }

  [[nodiscard]] PeerAnswer run() const override {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase phase;
    std::vector<btBroadphaseProxy*> proxies;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      const Moving& body = bodies_[k];
      btVector3 low, high;
      body.shape->calculateTemporalAabb(body.from, body.linear, body.angular, 1, low, high);
      // NOLINTNEXTLINE(performance-no-int-to-ptr): Bullet hands it back, as its users' own pointers
      proxies.push_back(phase.createProxy(low, high, body.shape->getShapeType(), reinterpret_cast<void*>(k),
                                          body.group, body.mask, &dispatcher));
    }
    phase.calculateOverlappingPairs(&dispatcher);
    const btBroadphasePairArray& found = phase.getOverlappingPairCache()->getOverlappingPairArray();
    PeerAnswer out;
    for (int i = 0; i < found.size(); ++i) {
      auto a = static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(found[i].m_pProxy0->m_clientObject));
      auto b = static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(found[i].m_pProxy1->m_clientObject));
      if (a > b) std::swap(a, b);
      ++out.pairs;
      if (const double time = cast(bodies_[a], bodies_[b]); time >= 0)
        out.contacts.push_back({a, b, time * t_max_});
    }
    for (btBroadphaseProxy* proxy : proxies) phase.destroyProxy(proxy, &dispatcher);
    return out;
  }

 private:
  // A share of the step, or below 0.
  static double cast(const Moving& a, const Moving& b) {
    if (is_in_contact(a, b)) return 0;
    if (a.linear == b.linear && !a.turns && !b.turns) return -1;
    btVoronoiSimplexSolver solver;
    btGjkEpaPenetrationDepthSolver depth;
    btConvexCast::CastResult result;
    bool contact = false;
    if (a.turns || b.turns) {
      btContinuousConvexCollision caster(a.shape.get(), b.shape.get(), &solver, &depth);
      contact = caster.calcTimeOfImpact(a.from, a.to, b.from, b.to, result);
    } else {
      btSubsimplexConvexCast caster(a.shape.get(), b.shape.get(), &solver);
      contact = caster.calcTimeOfImpact(a.from, a.to, b.from, b.to, result);
    }
    return contact && result.m_fraction <= 1 ? double(result.m_fraction) : -1;
  }
  static bool is_in_contact(const Moving& a, const Moving& b) {
    btVoronoiSimplexSolver solver;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(a.shape.get(), b.shape.get(), &solver, &depth);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = a.from;
    input.m_transformB = b.from;
    btPointCollector found;
    detector.getClosestPoints(input, found, nullptr);
    return found.m_hasResult && found.m_distance <= 0;
  }

  double t_max_;
  std::vector<Moving> bodies_;
};

}  // namespace

std::unique_ptr<PeerScene> bullet_scene(const scene::Scene& scene, double t_max) {
  auto out = std::make_unique<BulletScene>(t_max);
  for (const scene::Member& member : scene.bodies) {
    if (!out->add(member)) return nullptr;
  }
  return out;
}

}  // namespace graze::bench
