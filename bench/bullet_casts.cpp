// btSubsimplexConvexCast as its users call it: shapes built once, margin 0, a Voronoi simplex solver, transforms from
// and to. On request, btGjkPairDetector with EPA is run at the start for casts that give no answer. Every contact comes
// with time, normal and point. Rotating bodies use btContinuousConvexCollision. The file is compiled as one module for
// each of Bullet's scalars (BT_USE_DOUBLE_PRECISION).
#include "bench/bullet_casts.hpp"

#include <btBulletCollisionCommon.h>

#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <cmath>
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
  // A box and a cylinder keep their half extents: the core grows by as much as the margin shrinks. For a
  // sphere and a capsule the margin is the radius, whatever is set.
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

  void cast_all(const std::uint32_t* order, std::size_t count, Answer* answers) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Pair& pair = pairs_[order[k]];
      btVoronoiSimplexSolver solver;
      btSubsimplexConvexCast caster(pair.a.shape, pair.b.shape, &solver);
      btConvexCast::CastResult result;
      bool contact = caster.calcTimeOfImpact(pair.a.from, pair.a.to, pair.b.from, pair.b.to, result) &&
                     result.m_fraction <= 1;
      if (!contact && penetration_) contact = is_deep(pair);
      answers[order[k]] = {contact ? Verdict::contact : Verdict::miss, double(result.m_fraction)};
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

// From pose to pose.
class TurningCasts final : public PreparedCasts {
 public:
  TurningCasts(const PlainShape* shapes, std::size_t shape_count, const PlainPair* pairs,
               std::size_t pair_count, double most) {
    for (std::size_t i = 0; i < shape_count; ++i) shapes_.push_back(shape_of(shapes[i]));
    for (std::size_t i = 0; i < pair_count; ++i) {
      const PlainPair& given = pairs[i];
      const double angle = std::max(length(given.a.rotation), length(given.b.rotation));
      const auto pieces = static_cast<std::size_t>(std::max(1.0, std::ceil(angle / most)));
      Pair& pair = pairs_.emplace_back();
      pair.a = shapes_[given.a.shape].get();
      pair.b = shapes_[given.b.shape].get();
      for (std::size_t k = 0; k <= pieces; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(pieces);
        pair.poses.push_back({pose(given.a, t), pose(given.b, t)});
      }
    }
  }

  void cast_all(const std::uint32_t* order, std::size_t count, Answer* answers) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Pair& pair = pairs_[order[k]];
      Answer out{Verdict::miss, 0};
      const std::size_t pieces = pair.poses.size() - 1;
      for (std::size_t i = 0; i < pieces && out.verdict == Verdict::miss; ++i) {
        btVoronoiSimplexSolver solver;
        btGjkEpaPenetrationDepthSolver depth;
        btContinuousConvexCollision caster(pair.a, pair.b, &solver, &depth);
        btConvexCast::CastResult result;
        const Poses &from = pair.poses[i], &to = pair.poses[i + 1];
        if (caster.calcTimeOfImpact(from.a, to.a, from.b, to.b, result) && result.m_fraction <= 1)
          out = {Verdict::contact,
                 (static_cast<double>(i) + double(result.m_fraction)) / static_cast<double>(pieces)};
      }
      answers[order[k]] = out;
    }
  }

 private:
  struct Poses {
    btTransform a, b;
  };
  struct Pair {
    const btConvexShape *a = nullptr, *b = nullptr;
    std::vector<Poses> poses;
  };

  static double length(const double (&x)[3]) { return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }
  static btTransform pose(const PlainBody& body, double t) {
    double position[3];
    for (int i = 0; i < 3; ++i) position[i] = body.position[i] + t * body.displacement[i];
    const double(&q)[4] = body.orientation;
    const btQuaternion start{btScalar(q[1]), btScalar(q[2]), btScalar(q[3]), btScalar(q[0])};
    const double angle = length(body.rotation);
    if (!(angle * t > 0)) return btTransform(start, vector_of(position));
    const btQuaternion turned =
        btQuaternion(vector_of(body.rotation) / btScalar(angle), btScalar(angle * t)) * start;
    return btTransform(turned.normalized(), vector_of(position));
  }

  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<Pair> pairs_;
};

}  // namespace
}  // namespace graze::bench

extern "C" __attribute__((visibility("default"))) graze::bench::PreparedCasts* graze_make_bullet_casts(
    const graze::bench::PlainShape* shapes, std::size_t shape_count, const graze::bench::PlainPair* pairs,
    std::size_t pair_count, graze::bench::BulletCast which) {
  using namespace graze::bench;
  constexpr double kHalfTurn = 3.14, kEighth = 0.785;  // radians, a little less
  if (which == BulletCast::continuous || which == BulletCast::continuous_in_pieces) {
    const double most = which == BulletCast::continuous ? kHalfTurn : kEighth;
    return new TurningCasts(shapes, shape_count, pairs, pair_count, most);
  }
  return new Casts(shapes, shape_count, pairs, pair_count, which == BulletCast::subsimplex_and_depth);
}
