// The certified tier of linear casts: brackets that hold, and are narrow, for every pair of shapes and every
// hardness, judged by the oracles.
#include <gtest/gtest.h>
#include <graze/validate.hpp>

#include <cmath>
#include <graze/cast.hpp>
#include <limits>
#include <optional>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "engines/convert.hpp"
#include "engines/method.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/truth/case_truth.hpp"
#include "tests/shared/flushed.hpp"

namespace {

using namespace graze;

constexpr double kWidth = 1e-12;  // of scale: what the row of the guarantees says

template <Scalar S>
CastOptions<S> certified(const corpus::Case& problem) {
  CastOptions<S> options;
  options.tier = Tier::certified;
  options.request = Request::everything;
  options.t_max = static_cast<S>(problem.t_max);
  options.target_distance = static_cast<S>(problem.target_distance);
  options.start_policy = problem.start_policy;
  return options;
}

struct Count {
  int hits = 0, misses = 0, starts = 0, open = 0;
  [[nodiscard]] int all() const { return hits + misses + starts + open; }
};

template <Scalar S>
bool moves_in_subnormals(const corpus::Case& seen) {
  for (const Body<double>* body : {&seen.a, &seen.b}) {
    for (const double x : body->displacement) {
      if (x != 0 && std::abs(x) < double(std::numeric_limits<S>::min())) return true;
    }
  }
  return false;
}

// A fault of the answer to `seen`, which holds the values that S holds. Empty if there is no fault.
template <Scalar S>
std::string judged(const corpus::Case& seen, Count& count) {
  const CastResult<S> result = [&] {
    // A flushed subnormal is read as 0, which is another case.
    [[maybe_unused]] const std::optional<graze::test::Flushed> flushed =
        moves_in_subnormals<S>(seen) ? std::nullopt : std::optional<graze::test::Flushed>(std::in_place);
    return cast(engine::round_to<S>(seen.a), engine::round_to<S>(seen.b), certified<S>(seen));
  }();
  const oracle::CaseTruth truth(seen);
  const double lower = result.toi_lower, upper = result.toi_upper;
  const double speed = (seen.b.displacement - seen.a.displacement).stableNorm();
  const double rounding =
      std::same_as<S, float> && upper < kInfinity<double> ? speed * (0x1p-22 * upper + 0x1p-125) : 0.0;
  const double bound = kWidth * truth.scale().high + rounding;
  switch (result.outcome) {
    case Outcome::hit:
      ++count.hits;
      break;
    case Outcome::miss:
      ++count.misses;
      break;
    case Outcome::initially_overlapping:
      ++count.starts;
      break;
    default:
      ++count.open;
  }
  if (result.outcome == Outcome::invalid_input) return "refused";
  if (result.proof) {
    if (const auto verdict = oracle::check_proof(seen, *result.proof); !verdict.accepted())
      return "a false proof: " + verdict.detail;
  }
  if (truth.outcome() == Outcome::not_converged) return "";
  const bool contact = truth.outcome() != Outcome::miss;
  if (result.outcome == Outcome::miss) return contact ? "a miss of a contact" : "";
  if (result.outcome == Outcome::not_converged) {
    if ((contact ? truth.depth().low : truth.clearance().low) > bound) return "left open";
  } else {
    if (!contact) return "a contact of a miss";
    if (result.outcome == Outcome::initially_overlapping && truth.outcome() == Outcome::hit)
      return "a start in contact of bodies that are apart";
    for (const double t : {lower, upper}) {
      if (truth.backward_error(t).low > bound) return "a wide bracket";
    }
  }
  if (contact && (lower > truth.toi_upper() || upper < truth.toi_lower())) return "a bracket without the TOI";
  return "";
}

std::vector<Shape<double>> shapes() {
  using Given = SharedShape<double>;
  const Shape<double> box = Box<double>{{0.5, 0.25, 0.75}}, ball = Sphere<double>{0.5};
  const Shape<double> cylinder = Cylinder<double>{0.5, 0.25}, cone = Cone<double>{0.5, 0.75};
  const Given parts[] = {share<double>(box), share<double>(cone)};
  return {Point<double>{},
          Segment<double>{{-0.5, 0, 0}, {0.5, 0.25, 0}},
          Triangle<double>{{-0.5, 0, 0}, {0.5, 0.25, 0}, {0, 0, 0.75}},
          ball,
          Sphere<double>{0},
          Capsule<double>{0.25, 0.5},
          Capsule<double>{0, 0.5},
          box,
          Box<double>{{0.5, 0, 0.5}},
          Ellipsoid<double>{{0.5, 0.25, 0.75}},
          Ellipsoid<double>{{0.5, 0, 0.75}},
          Ellipsoid<double>{{0, 0, 0.75}},
          cylinder,
          Cylinder<double>{0.5, 0},
          Cylinder<double>{0, 0.5},
          cone,
          Cone<double>{0.5, 0},
          Hull<double>{{0.5, 0, 0}, {-0.5, 0.5, 0}, {0, -0.5, 0.25}, {0, 0, 0.75}},
          posed<double>(cylinder, {0.25, 0, -0.25}, {1, 1, 0, 0}),
          rounded<double>(box, 0.25),
          sum<double>(box, cylinder),
          swept<double>(cone, {0.5, 0.25, 0}),
          HullOf<double>{{parts[0], parts[1]}},
          hull_of<double>(ball, posed<double>(box, {0.5, 0.5, 0}, {}))};
}

// Straight at each other along an axis, off centre, past each other, and from contact, aligned and rotated.
TEST(CertifiedTier, EveryPairOfShapes) {
  const std::vector<Shape<double>> all = shapes();
  struct Way {
    Vec3<double> from, motion;
  };
  const Way ways[] = {{{0, 0, 4}, {0, 0, -4}},         {{0.25, 0.125, 4}, {0, 0, -4}},
                      {{3, 2.5, 4}, {-3, -2, -4}},     {{0, 3.5, 3}, {0, 0.25, -6}},
                      {{0.125, 0.0625, 0}, {1, 0, 0}}, {{-4, 0.25, 0}, {0, 0, 0}}};
  Count count;
  int drawn = 0;
  for (const Shape<double>& a : all) {
    ++drawn;  // another half for the next shape
    for (const Shape<double>& b : all) {
      for (const Way& way : ways) {
        if (++drawn % 2 == 0) continue;  // half of them, in turn, tell as much
        corpus::Case problem;
        problem.a.shape = a;
        problem.b.shape = b;
        problem.b.position = way.from;
        problem.b.displacement = way.motion;
        if (drawn % 3 == 1) problem.b.orientation = {3, 1, 2, 2};
        if (drawn % 5 == 4) problem.target_distance = 0.25;
        EXPECT_EQ(judged<double>(problem, count), "") << corpus::write_case(problem);
      }
    }
  }
  EXPECT_GT(count.hits, 250);
  EXPECT_GT(count.misses, 150);
  EXPECT_GT(count.starts, 100);
  EXPECT_LT(count.open, count.all() / 20);  // ties: touching starts, silhouettes
}

template <Scalar S>
void judge_families(int seeds) {
  for (const corpus::Family& family : corpus::families()) {
    if (family.rotating) continue;
    Count count;
    for (const double hardness : family.levels) {
      for (int seed = 0; seed < seeds; ++seed) {
        const corpus::Case problem = family.generate(hardness, static_cast<std::uint64_t>(seed));
        const corpus::Case seen = engine::rounded_case<S>(problem);
        const auto outgrows = [](const Body<double>& body) {
          return graze::validate(engine::round_to<S>(body)) != Invalid::none;
        };
        if (std::same_as<S, float> && (outgrows(problem.a) || outgrows(problem.b))) continue;
        EXPECT_EQ(judged<S>(seen, count), "") << corpus::write_case(seen);
      }
    }
    EXPECT_GT(count.hits + count.starts, 0) << family.name;
    EXPECT_GT(count.misses, 0) << family.name;
  }
}
TEST(CertifiedTier, EveryFamilyAtEveryHardnessInDouble) { judge_families<double>(8); }
TEST(CertifiedTier, EveryFamilyAtEveryHardnessInFloat) { judge_families<float>(4); }

// A path through the sharp point of a cone that points at another's: every portal has that point on its
// border.
TEST(CertifiedTier, PathThroughAnApex) {
  corpus::Case problem;
  problem.a.shape = Cone<double>{1, 1};
  problem.b.shape = Cone<double>{1, 1};
  problem.b.position = {0, 0, 4};
  problem.b.orientation = {0, 1, 0, 0};
  problem.b.displacement = {0, 0, -4};
  Count count;
  EXPECT_EQ(judged<double>(problem, count), "");
  EXPECT_EQ(count.hits, 1);
}

// Spheres that touch at the start, exactly: contact, and leaving is passed over.
TEST(CertifiedTier, TouchingStart) {
  CastOptions<double> options;
  options.tier = Tier::certified;
  Body<double> a, b;
  a.shape = Sphere<double>{1};
  b.shape = Sphere<double>{0.5};
  b.position = {1.5, 0, 0};
  b.displacement = {-1, 0, 0};
  EXPECT_EQ(cast(a, b, options).outcome, Outcome::initially_overlapping);
  b.displacement = {1, 0, 0};
  EXPECT_EQ(cast(a, b, options).outcome, Outcome::initially_overlapping);
  options.start_policy = StartPolicy::pass_over;
  const auto touching = cast(a, b, options);
  EXPECT_EQ(touching.outcome, Outcome::miss);
  EXPECT_TRUE(touching.passed_over);
  b.position = {1.25, 0, 0};
  EXPECT_EQ(cast(a, b, options).outcome, Outcome::initially_overlapping);
  // Within the target distance, and leaving: proved, since the bodies themselves are apart.
  b.position = {2, 0, 0};
  options.target_distance = 1;
  const auto leaving = cast(a, b, options);
  EXPECT_EQ(leaving.outcome, Outcome::miss);
  EXPECT_TRUE(leaving.passed_over);
}

TEST(CertifiedTier, EveryMagnitude) {
  for (const int power : {-190, -100, 0, 100, 190}) {
    const double unit = std::ldexp(1.0, power);
    corpus::Case problem;
    problem.a.shape = Cylinder<double>{unit, 0.5 * unit};
    problem.b.shape = Ellipsoid<double>{Vec3<double>(0.25, 0.5, 0.75) * unit};
    problem.b.position = Vec3<double>(0.25, 0.125, 1.75) * unit;
    problem.b.displacement = Vec3<double>(0, 0.125, -1) * unit;
    Count count;
    EXPECT_EQ(judged<double>(problem, count), "") << power;
    EXPECT_EQ(count.hits, 1) << power;
  }
}

// For polytopes it is the exact tier: the two doubles next to the TOI, the tie decided.
TEST(CertifiedTier, PolytopesAreExact) {
  Body<double> a, b;
  a.shape = Box<double>{{1, 1, 1}};
  b.shape = Box<double>{{1, 1, 1}};
  b.position = {3, 2, 0};
  b.displacement = {-3, 0, 0};
  CastOptions<double> options;
  options.tier = Tier::certified;
  const auto result = cast(a, b, options);
  EXPECT_EQ(result.method, Method::exact_portal);
  EXPECT_EQ(result.outcome, Outcome::hit);
  EXPECT_LT(result.toi_lower, result.toi_upper);
  EXPECT_EQ(std::nextafter(result.toi_lower, 1.0), result.toi_upper);
}

#ifdef GRAZE_TEST_FLUSH
TEST(CertifiedTier, IsBuiltWithFusedMultiplyAdds) {
  const std::optional<bool> fused = test::fuses();
  if (!fused) GTEST_SKIP() << "this machine has none";
  EXPECT_TRUE(*fused);
}
#endif

}  // namespace
