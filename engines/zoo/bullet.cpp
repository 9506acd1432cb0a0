// Bullet under the judge, as its users call it. Compiled once for each of its scalars (BT_USE_DOUBLE_PRECISION).
//
//   --call subsimplex   btSubsimplexConvexCast                             cast
//          gjk          btGjkConvexCast                                    cast
//          continuous   btContinuousConvexCollision                        cast, rotating_cast
//          pair         btGjkPairDetector with the EPA solver              overlap, distance, penetration
//          pair-mpr     btGjkPairDetector with the Minkowski solver        overlap, distance, penetration
//          ray          btCollisionWorld::rayTestSingle                    ray
//          ray-gjk      the same, with kF_UseGjkConvexCastRaytest          ray
//   --setting default          every shape rounded by the default margin, everything else as it comes
//             margin0          margin 0, everything else as it comes
//             tightest         of subsimplex alone: as default, but it stops later
//             margin0-tightest of subsimplex alone: as margin0, but it stops later
//
// Bullet promises no tolerance anywhere, so none is declared. It documents
// - that a margin of 0 "might introduce problems" (user manual, "Collision margin"): the results of margin0 lie beyond
//   that
// - the size of moving objects, 0.05 to 10 units (its wiki, "Scaling The World"; user manual, "Avoid very small and very
//   large collision shapes"): `lengths`
// - that btSubsimplexConvexCast does not take starts in contact (btSubSimplexConvexCast.h, "Precondition"), and no cast
//   has a way to report one: `starts` false
// - that the rotation per step is below pi/4 (ANGULAR_MOTION_THRESHOLD of LinearMath/btTransformUtil.h): `most_turn`
// A cast ends at a distance by design: 0.001 in btGjkConvexCast and btContinuousConvexCollision, the root of
// m_subSimplexCastEpsilon in btSubsimplexConvexCast: `early`.
//
// Bullet's normals point from B to A, and its fractions run from 0 to 1 over the motion. Its margin rounds a hull and a
// cone outward. Boxes and cylinders are built from their outer extents, and the margin shrinks them inward. For a
// sphere and a capsule the margin is the radius. Here each shape is built such that its core, before rounding, is the
// shape of the question. The casts that use the whole support (subsimplex, rays) see a box with its corners, not
// rounded, so the box is a hull for them.
#include <btBulletCollisionCommon.h>

#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btMinkowskiPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <graze_adapter.hpp>

#include <memory>

#include "engines/zoo/arguments.hpp"

namespace graze::zoo {
namespace {

using namespace adapter;

#ifdef BT_USE_DOUBLE_PRECISION
constexpr Scalar kScalar = Scalar::float64;
#else
constexpr Scalar kScalar = Scalar::float32;
#endif

constexpr double kStop = 0.001;  // `radius` of btGjkConvexCast.cpp and btContinuousConvexCollision.cpp

btVector3 bullet(const Vector& x) { return {btScalar(x[0]), btScalar(x[1]), btScalar(x[2])}; }
btQuaternion bullet(const Quaternion& q) {
  return {btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w)};
}
btTransform bullet(const Pose& pose) { return btTransform(bullet(pose.orientation), bullet(pose.position)); }
Vector plain(const btVector3& x) { return {x.x(), x.y(), x.z()}; }

std::shared_ptr<btConvexShape> shape_of(const Shape& shape, double margin) {
  std::shared_ptr<btConvexShape> out;
  const auto m = btScalar(margin);
  const auto radius = btScalar(shape.radius);
  const auto half = btScalar(shape.half_height);
  switch (shape.type) {
    case ShapeType::sphere:
      return std::make_shared<btSphereShape>(radius + m);
    case ShapeType::capsule:
      return std::make_shared<btCapsuleShapeZ>(radius + m, 2 * half);
    case ShapeType::cylinder:
      out = std::make_shared<btCylinderShapeZ>(btVector3(radius + m, radius + m, half + m));
      break;
    case ShapeType::cone:
      out = std::make_shared<btConeShapeZ>(radius, 2 * half);
      break;
    case ShapeType::box:
      out = std::make_shared<btBoxShape>(bullet(shape.half_extents) + btVector3(m, m, m));
      break;
    default: {
      const auto hull = std::make_shared<btConvexHullShape>();
      for (const Vector& x : vertices_of(shape)) hull->addPoint(bullet(x), false);
      hull->recalcLocalAabb();
      out = hull;
    }
  }
  if (margin == 0) out->setMargin(0);
  return out;
}

struct Moving {
  std::shared_ptr<btConvexShape> shape;
  btTransform from, to;
};
Moving moving(const Body& body, double t_max, double margin) {
  return {shape_of(body.shape, margin), bullet(pose_at(body, 0)), bullet(pose_at(body, t_max))};
}

// The parts of a cast's answer that are not in its result.
struct Result final : btConvexCast::CastResult {
  bool failed = false;
  void reportFailure(int, int) override { failed = true; }
};

template <class MakeCast>
auto cast(const Question& q, double margin, btScalar epsilon, int iterations, MakeCast make_cast) {
  return
      [=, a = moving(q.a, q.t_max, margin), b = moving(q.b, q.t_max, margin), t_max = q.t_max]() -> Answer {
        btVoronoiSimplexSolver simplex;
        btGjkEpaPenetrationDepthSolver epa;
        auto cast = make_cast(*a.shape, *b.shape, simplex, epa);
        Result result;
        if (epsilon >= 0) {
          result.m_subSimplexCastEpsilon = epsilon;
          result.m_subSimplexCastMaxIterations = iterations;
        }
        const bool hit = cast.calcTimeOfImpact(a.from, a.to, b.from, b.to, result);
        if (result.failed) return Answer::not_converged("reportFailure");
        if (!hit || result.m_fraction > 1) return Answer::miss();
        Answer answer = Answer::hit(result.m_fraction * t_max);
        answer.normal = -plain(result.m_normal);
        return answer;
      };
}

template <class Solver>
auto closest(const Question& q, double margin) {
  return [a = moving(q.a, 0, margin), b = moving(q.b, 0, margin), query = q.query]() -> Answer {
    btVoronoiSimplexSolver simplex;
    Solver solver;
    btGjkPairDetector detector(a.shape.get(), b.shape.get(), &simplex, &solver);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = a.from;
    input.m_transformB = b.from;
    btPointCollector found;
    detector.getClosestPoints(input, found, nullptr);
    // The call reports no contact. This is a miss for a query about contact, and no answer for a distance.
    if (!found.m_hasResult)
      return query == Query::distance ? Answer::not_converged("no result") : Answer::miss();
    Answer answer = found.m_distance > 0 ? Answer::miss() : Answer::overlapping();
    answer.distance = std::max(0.0, double(found.m_distance));
    answer.depth = std::max(0.0, double(-found.m_distance));
    answer.normal = -plain(found.m_normalOnBInWorld);
    answer.point_b = plain(found.m_pointInWorld);
    answer.point_a = plain(found.m_pointInWorld + found.m_normalOnBInWorld * found.m_distance);
    return answer;
  };
}

auto ray(const Question& q, double margin, bool gjk) {
  return [=, a = moving(q.a, 0, margin), from = bullet(q.origin),
          to = bullet(q.origin + q.t_max * q.direction), t_max = q.t_max]() -> Answer {
    btCollisionObject object;
    object.setCollisionShape(a.shape.get());
    object.setWorldTransform(a.from);
    btCollisionWorld::ClosestRayResultCallback closest(from, to);
    if (gjk) closest.m_flags |= btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
    btCollisionWorld::rayTestSingle(btTransform(btQuaternion::getIdentity(), from),
                                    btTransform(btQuaternion::getIdentity(), to), &object, a.shape.get(),
                                    a.from, closest);
    if (!closest.hasHit()) return Answer::miss();
    Answer answer = Answer::hit(closest.m_closestHitFraction * t_max);
    answer.normal = plain(closest.m_hitNormalWorld);
    return answer;
  };
}

double margin_of(const Arguments& arguments) {
  return arguments.setting.rfind("margin0", 0) == 0 ? 0 : double(CONVEX_DISTANCE_MARGIN);
}

template <class Function>
int run(const Arguments& arguments, const Promise& promise, const std::vector<Query>& queries,
        const std::string& calls, Function function) {
  const double margin = margin_of(arguments);
  Engine engine;
  engine.name = std::string("bullet-") + (kScalar == Scalar::float32 ? "float-" : "double-") +
                arguments.call + "-" + arguments.setting;
  engine.version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
  engine.about = calls + (margin > 0 ? "; shapes with the default margin" : "; margin 0");
  engine.scalar = kScalar;
  engine.shapes = {ShapeType::hull, ShapeType::sphere, ShapeType::capsule, ShapeType::cylinder,
                   ShapeType::cone};
  const bool ray = queries.front() == Query::ray;
  if (margin == 0 || (!ray && arguments.call != "subsimplex")) engine.shapes.push_back(ShapeType::box);
  engine.margin = ray ? margin : 2 * margin;  // a ray is a sphere of radius 0 without a margin
  engine.lengths = {{0.05, 10}};
  engine.pivots = false;
  engine.most_turn = 0.78;
  engine.timed = true;
  for (const Query query : queries) {
    Promise& row = engine.queries[query] = promise;
    if (query == Query::overlap) row.answers = {};
    if (query == Query::distance) row.answers = {"distance", "normal", "witnesses"};
    if (query == Query::penetration) row.answers = {"depth", "normal", "witnesses"};
  }
  return serve(engine, function);
}

int main_of(int argc, char** argv) {
  const Arguments arguments =
      read_arguments(argc, argv, {"subsimplex", "gjk", "continuous", "pair", "pair-mpr", "ray", "ray-gjk"},
                     {"default", "margin0", "tightest", "margin0-tightest"});
  const double margin = margin_of(arguments);
  const std::string& call = arguments.call;
  Promise casts;
  casts.answers = {"time", "normal"};
  casts.starts = false;

  const bool tightest = arguments.setting.find("tightest") != std::string::npos;
  if (tightest && call != "subsimplex")
    refuse("--setting " + arguments.setting + ": of --call subsimplex alone");
  if (call == "subsimplex") {
    const btScalar epsilon = tightest ? SIMD_EPSILON : MAX_CONVEX_CAST_EPSILON;  // a square
    casts.early = std::sqrt(double(epsilon));
    return run(arguments, casts, {Query::cast}, "btSubsimplexConvexCast", [=](const Question& q) {
      return cast(q, margin, epsilon, tightest ? 1000 : MAX_CONVEX_CAST_ITERATIONS,
                  [](const btConvexShape& a, const btConvexShape& b, btSimplexSolverInterface& simplex,
                     auto&) { return btSubsimplexConvexCast(&a, &b, &simplex); });
    });
  }
  if (call == "gjk") {
    casts.early = kStop;
    return run(arguments, casts, {Query::cast}, "btGjkConvexCast", [=](const Question& q) {
      return cast(q, margin, MAX_CONVEX_CAST_EPSILON, MAX_CONVEX_CAST_ITERATIONS,
                  [](const btConvexShape& a, const btConvexShape& b, btSimplexSolverInterface& simplex,
                     auto&) { return btGjkConvexCast(&a, &b, &simplex); });
    });
  }
  if (call == "continuous") {
    casts.early = kStop;
    return run(arguments, casts, {Query::cast, Query::rotating_cast}, "btContinuousConvexCollision with EPA",
               [=](const Question& q) {
                 return cast(q, margin, MAX_CONVEX_CAST_EPSILON, MAX_CONVEX_CAST_ITERATIONS,
                             [](const btConvexShape& a, const btConvexShape& b,
                                btSimplexSolverInterface& simplex, btGjkEpaPenetrationDepthSolver& epa) {
                               return btContinuousConvexCollision(&a, &b, &simplex, &epa);
                             });
               });
  }
  const std::vector<Query> at_rest{Query::overlap, Query::distance, Query::penetration};
  if (call == "pair") {
    return run(arguments, {}, at_rest, "btGjkPairDetector with btGjkEpaPenetrationDepthSolver",
               [=](const Question& q) { return closest<btGjkEpaPenetrationDepthSolver>(q, margin); });
  }
  if (call == "pair-mpr") {
    return run(arguments, {}, at_rest, "btGjkPairDetector with btMinkowskiPenetrationDepthSolver",
               [=](const Question& q) { return closest<btMinkowskiPenetrationDepthSolver>(q, margin); });
  }
  const bool gjk = call == "ray-gjk";
  casts.early = gjk ? kStop : std::sqrt(double(MAX_CONVEX_CAST_EPSILON));
  return run(arguments, casts, {Query::ray},
             gjk ? "btCollisionWorld::rayTestSingle with kF_UseGjkConvexCastRaytest"
                 : "btCollisionWorld::rayTestSingle",
             [=](const Question& q) { return ray(q, margin, gjk); });
}

}  // namespace
}  // namespace graze::zoo

int main(int argc, char** argv) { return graze::zoo::main_of(argc, argv); }
