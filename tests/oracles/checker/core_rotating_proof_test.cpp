// Proofs that core's rotating casts make are accepted by the checker, which shares no code with them: random
// turning pairs of every shape, flat ones included.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <graze/rotating_cast.hpp>

#include "corpus/format/proof_io.hpp"
#include "engines/convert.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "tests/shared/flushed.hpp"
#include "tests/shared/turning_bodies.hpp"

namespace graze::test {
namespace {

template <Scalar To, Scalar From>
RotatingBody<To> converted(const RotatingBody<From>& x) {
  using engine::round_to;
  return {{round_to<To>(x.body.shape), round_to<To>(x.body.position), round_to<To>(x.body.orientation),
           round_to<To>(x.body.displacement)},
          round_to<To>(x.rotation),
          round_to<To>(x.pivot)};
}

struct Pair {
  RotatingBody<double> a, b;
};

// A point inside a flat shape, off its middle: rods that meet in the middle of both have the origin on an
// edge of every triangle of their four pairs. For other shapes, a point that is inside, or near.
Vec3<double> inner(const Shape<double>& shape, Draw& draw) {
  const double p = draw.between(0.25, 0.4), q = draw.between(0.25, 0.4);
  if (const auto* s = std::get_if<Segment<double>>(&shape)) return p * s->a + (1 - p) * s->b;
  if (const auto* s = std::get_if<Triangle<double>>(&shape)) return p * s->a + q * s->b + (1 - p - q) * s->c;
  return Vec3<double>::Zero();
}

// The position of the body's point x at time t.
Vec3<double> placed(const RotatingBody<double>& body, const Vec3<double>& x, double t) {
  const auto& q = body.body.orientation;
  const Vec3<double> arm = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized() * (x - body.pivot);
  const Vec3<double> pivot = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized() * body.pivot;
  const Eigen::AngleAxisd turn(t * body.rotation.norm(), body.rotation.normalized());
  return body.body.position + pivot + turn * arm + t * body.body.displacement;
}

// Every other pair is of two flat bodies. Most pairs are led to meet within the time, and some start near
// each other.
Pair draw_pair(Draw& draw, int round) {
  Pair out{turning_body(draw), turning_body(draw)};
  const double from = round % 2 == 0 ? 9 : 0;
  for (RotatingBody<double>* x : {&out.a, &out.b})
    x->body.shape = any_shape(draw, static_cast<int>(draw.between(from, kTurningShapes)));
  if (round % 8 == 3) out.b.body.position = out.a.body.position + draw.vector<double>(0.5);
  if (round % 8 == 3 || round % 4 == 1) return out;
  const double t = draw.between(0.1, 1);
  const Vec3<double> of_a = placed(out.a, inner(out.a.body.shape, draw), t);
  const Vec3<double> of_b = placed(out.b, inner(out.b.body.shape, draw), t);
  out.b.body.displacement += (of_a - of_b) / t;
  return out;
}

template <Scalar S>
corpus::Case as_case(const RotatingBody<S>& a, const RotatingBody<S>& b, const RotatingOptions<S>& options) {
  const RotatingBody<double> wide_a = converted<double>(a), wide_b = converted<double>(b);
  corpus::Case problem;
  problem.id = "test/core-rotating";
  problem.a = wide_a.body;
  problem.b = wide_b.body;
  problem.spin_a = {wide_a.rotation, wide_a.pivot};
  problem.spin_b = {wide_b.rotation, wide_b.pivot};
  problem.t_max = double(options.t_max);
  problem.target_distance = double(options.target_distance);
  return problem;
}

std::string text_of(const corpus::Case& problem, const RotatingProof& proof) {
  corpus::ProofRecord record;
  record.problem = problem;
  record.rotating = proof;
  return corpus::write_proof(record);
}

struct Tally {
  int hits = 0, misses = 0, starts = 0, open = 0, crossings = 0, thin = 0;
};

// Is C without area? Then it meets the origin at single times, which nothing proves.
bool thin(const Pair& pair, double target_distance) {
  const auto rank = [](const Shape<double>& shape) {
    return std::holds_alternative<Point<double>>(shape)     ? 0
           : std::holds_alternative<Segment<double>>(shape) ? 1
                                                            : 2;
  };
  return target_distance == 0 && rank(pair.a.body.shape) + rank(pair.b.body.shape) < 2;
}

template <Scalar S>
void cast_and_check(const Pair& pair, RotatingOptions<S> options, Tally& tally) {
  const RotatingBody<S> a = converted<S>(pair.a), b = converted<S>(pair.b);
  options.request = Request::proof;
  const RotatingResult<S> result = [&] {
    const Flushed flushed;
    return cast(a, b, options);
  }();
  ASSERT_NE(result.outcome, Outcome::invalid_input);
  ASSERT_TRUE(result.proof.has_value());
  const RotatingProof& proof = *result.proof;
  const corpus::Case problem = as_case(a, b, options);
  const oracle::RotatingVerdict verdict = oracle::check_rotating_proof(problem, proof);
  ASSERT_TRUE(verdict.accepted()) << to_string(verdict.refusal) << ": " << verdict.detail << "\n"
                                  << text_of(problem, proof);
  // No lower bound that is claimed is beyond the one that is proved, and no upper one short of it.
  switch (result.outcome) {
    case Outcome::hit:
      ++tally.hits;
      EXPECT_LE(double(result.toi_lower), proof.toi_lower) << text_of(problem, proof);
      EXPECT_GT(proof.toi_lower, 0) << text_of(problem, proof);
      EXPECT_LT(proof.toi_upper, kInfinity<double>) << text_of(problem, proof);
      EXPECT_GE(double(result.toi_upper), proof.toi_upper) << text_of(problem, proof);
      tally.crossings += proof.crossing ? 1 : 0;
      break;
    case Outcome::miss:
      ++tally.misses;
      EXPECT_EQ(proof.toi_lower, kInfinity<double>) << text_of(problem, proof);
      EXPECT_EQ(proof.toi_upper, kInfinity<double>);
      break;
    case Outcome::initially_overlapping:
      ++tally.starts;
      EXPECT_EQ(proof.toi_upper, 0) << text_of(problem, proof);
      break;
    default:
      ++(thin(pair, problem.target_distance) ? tally.thin : tally.open);
      EXPECT_EQ(proof.toi_upper, kInfinity<double>) << text_of(problem, proof);
  }
}

template <Scalar S>
void run(std::uint64_t seed, Tally& tally) {
  Draw draw{seed};
  for (int round = 0; round < 300 && !testing::Test::HasFatalFailure(); ++round) {
    const Pair pair = draw_pair(draw, round);
    RotatingOptions<S> options;
    if (round % 5 == 4) options.target_distance = S(0.0625);
    for (const Tier tier : {Tier::standard, Tier::certified}) {
      for (const RotatingMethod method :
           {RotatingMethod::conservative_advancement, RotatingMethod::bilateral_advancement}) {
        options.tier = tier;
        options.method = method;
        SCOPED_TRACE("round " + std::to_string(round) + ", tier " + std::to_string(int(tier)) + ", method " +
                     std::to_string(int(method)));
        cast_and_check(pair, options, tally);
      }
    }
  }
}

void expect_of_every_kind(const Tally& tally) {
  std::cout << tally.hits << " hits (" << tally.crossings << " by crossing), " << tally.misses << " misses, "
            << tally.starts << " starts in contact, " << tally.open << " not converged, and " << tally.thin
            << " without area\n";
  EXPECT_GT(tally.hits, 500);
  EXPECT_GT(tally.crossings, 100);
  EXPECT_GT(tally.misses, 200);
  EXPECT_GT(tally.starts, 50);
  EXPECT_LT(tally.open, 12);  // in a hundred
}

TEST(CoreRotatingProof, IsAcceptedInDouble) {
  Tally tally;
  run<double>(31, tally);
  expect_of_every_kind(tally);
}
TEST(CoreRotatingProof, IsAcceptedInFloat) {
  Tally tally;
  run<float>(32, tally);
  expect_of_every_kind(tally);
}

}  // namespace
#ifdef GRAZE_TEST_FLUSH
TEST(CoreRotatingProof, IsBuiltWithFusedMultiplyAdds) {
  const std::optional<bool> fused = test::fuses();
  if (!fused) GTEST_SKIP() << "this machine has none";
  EXPECT_TRUE(*fused);
}
#endif

}  // namespace graze::test
