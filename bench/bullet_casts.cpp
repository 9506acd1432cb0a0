// btSubsimplexConvexCast as its users call it: shapes built once, margin 0, a Voronoi simplex solver,
// transforms from and to; if that is wanted, btGjkPairDetector with EPA at the start where the cast answers nothing.
// It hands out time, normal and point with every contact. Compiled as one module for each of Bullet's scalars
// (BT_USE_DOUBLE_PRECISION).
#include "bench/bullet_casts.hpp"

#include <btBulletCollisionCommon.h>

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>
#include <vector>

namespace graze::bench {
namespace {

btVector3 vector_of(const double (&x)[3]) { return {btScalar(x[0]), btScalar(x[1]), btScalar(x[2])}; }

std::unique_ptr<btConvexShape> shape_of(const PlainShape& plain) {
  std::unique_ptr<btConvexShape> out;
  const btScalar radius = btScalar(plain.half_extents[0]), height = btScalar(2 * plain.half_extents[2]);
  if (plain.kind == PlainKind::hull) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (std::size_t i = 0; i < plain.vertices; ++i) {
      const double* x = plain.xyz + 3 * i;
      hull->addPoint({btScalar(x[0]), btScalar(x[1]), btScalar(x[2])}, false);
    }
    hull->recalcLocalAabb();
    out = std::move(hull);
  } else if (plain.kind == PlainKind::sphere) {
    out = std::make_unique<btSphereShape>(radius);
  } else if (plain.kind == PlainKind::capsule) {
    out = std::make_unique<btCapsuleShapeZ>(radius, height);
  } else if (plain.kind == PlainKind::cylinder) {
    out = std::make_unique<btCylinderShapeZ>(vector_of(plain.half_extents));
  } else if (plain.kind == PlainKind::cone) {
    out = std::make_unique<btConeShapeZ>(radius, height);
  } else {
    out = std::make_unique<btBoxShape>(vector_of(plain.half_extents));
  }
  // A box and a cylinder keep their half extents: the core grows by what the margin shrinks. Of a sphere and a capsule
  // the margin is the radius, whatever is set.
  out->setMargin(0);
  return out;
}

struct Motion {
  const btConvexShape* shape;
  btTransform from, to;
};

class Casts final : public PreparedCasts {
 public:
  Casts(const PlainShape* shapes, std::size_t shape_count, const PlainPair* pairs, std::size_t pair_count,
        bool penetration)
      : penetration_(penetration) {
    for (std::size_t i = 0; i < shape_count; ++i) shapes_.push_back(shape_of(shapes[i]));
    for (std::size_t i = 0; i < pair_count; ++i) pairs_.push_back({motion(pairs[i].a), motion(pairs[i].b)});
  }

  void cast_all(const std::uint32_t* order, std::size_t count, Verdict* verdicts) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Pair& pair = pairs_[order[k]];
      btVoronoiSimplexSolver solver;
      btSubsimplexConvexCast caster(pair.a.shape, pair.b.shape, &solver);
      btConvexCast::CastResult result;
      bool contact = caster.calcTimeOfImpact(pair.a.from, pair.a.to, pair.b.from, pair.b.to, result) &&
                     result.m_fraction <= 1;
      if (!contact && penetration_) contact = is_deep(pair);
      verdicts[order[k]] = contact ? Verdict::contact : Verdict::miss;
    }
  }

 private:
  struct Pair {
    Motion a, b;
  };

  [[nodiscard]] static bool is_deep(const Pair& pair) {
    btVoronoiSimplexSolver solver;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(pair.a.shape, pair.b.shape, &solver, &depth);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = pair.a.from;
    input.m_transformB = pair.b.from;
    btPointCollector found;
    detector.getClosestPoints(input, found, nullptr);
    return found.m_hasResult && found.m_distance <= 0;
  }

  [[nodiscard]] Motion motion(const PlainBody& body) const {
    const double(&q)[4] = body.orientation;
    const btVector3 position = vector_of(body.position);
    const btQuaternion turn{btScalar(q[1]), btScalar(q[2]), btScalar(q[3]), btScalar(q[0])};
    return {shapes_[body.shape].get(), btTransform(turn, position),
            btTransform(turn, position + vector_of(body.displacement))};
  }

  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<Pair> pairs_;
  bool penetration_;
};

}  // namespace
}  // namespace graze::bench

extern "C" __attribute__((visibility("default"))) graze::bench::PreparedCasts* graze_make_bullet_casts(
    const graze::bench::PlainShape* shapes, std::size_t shape_count, const graze::bench::PlainPair* pairs,
    std::size_t pair_count, bool penetration) {
  return new graze::bench::Casts(shapes, shape_count, pairs, pair_count, penetration);
}
