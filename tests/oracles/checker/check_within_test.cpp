// Proofs that are true except for rounding are refused by the exact check, and accepted for shapes within
// kappa u of scale. They are not accepted if they are false by more. They are not accepted, either, if each
// half is true of a nearby set but no single set satisfies both.
#include "oracles/checker/check_within.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace graze::oracle {
namespace {

using corpus::Case;
using corpus::ProofRecord;

constexpr double kU = kUnitRoundoff<double>, kNever = kInfinity<double>;

// A point falls on the inner of a triangle in the plane x = 1 from x = 4, by 4 in a unit of t: contact at 3/4.
ProofRecord triangle_and_point() {
  ProofRecord record;
  record.problem.a.shape = Triangle<double>{{1, -1, -1}, {1, 2, -1}, {1, -1, 2}};
  record.problem.b.position = {4, 0, 0};
  record.problem.b.displacement = {-4, 0, 0};
  record.scalar = "double";
  record.tier = Tier::exact;
  record.outcome = Outcome::hit;
  Proof& proof = record.proof;
  proof.has_axis = true;
  proof.axis = {1, 0, 0};
  proof.toi_lower = proof.toi_upper = 0.75;
  proof.portal_size = 3;
  for (unsigned i = 0; i < 3; ++i) proof.portal[i].a.vertex = i;
  return record;
}
// A ball of radius 1 and a point that meet at 3/4, by the ball's point in front.
ProofRecord ball_and_point() {
  ProofRecord record = triangle_and_point();
  record.problem.a.shape = Sphere<double>{1};
  record.proof.portal_size = 1;
  record.proof.portal[0] = {};
  record.proof.portal[0].a.offset = {1, 0, 0};
  return record;
}

bool holds(const ProofRecord& record, double kappa) {
  return check_record_within(record, {.of_proof = kappa}).finding == RecordFinding::accepted;
}
// By kappa u of scale, but not by half of that, nor exactly.
void expect_needs(const ProofRecord& record, double kappa, const char* what) {
  EXPECT_FALSE(holds(record, 0)) << what;
  EXPECT_FALSE(holds(record, kappa / 2)) << what;
  EXPECT_TRUE(holds(record, kappa)) << what << ": "
                                    << check_record_within(record, {.of_proof = kappa}).detail;
}

TEST(CheckWithin, GrantsNothingThatIsNotNeeded) {
  bool exactly = false;
  EXPECT_EQ(check_record_within(triangle_and_point(), {.of_proof = 16}, &exactly).finding,
            RecordFinding::accepted);
  EXPECT_TRUE(exactly);
  ProofRecord late = triangle_and_point();
  late.proof.toi_lower = late.proof.toi_upper = std::nextafter(0.75, 1);
  EXPECT_EQ(check_record_within(late, {.of_proof = 16}, &exactly).finding, RecordFinding::accepted);
  EXPECT_FALSE(exactly);
  EXPECT_EQ(check_record_within(late, {.of_proof = 0}, &exactly).finding, RecordFinding::refused);
  EXPECT_TRUE(exactly);
}

// Lengths of which u scale of triangle and point, whose scale is sqrt(18), is one to within a hundredth.
const double kGranted = kU * std::sqrt(18.0);

TEST(CheckWithin, GrantsATimeItsWay) {
  // By 2^-30 of t the point goes 2^-28.
  const double kappa = 1.0625 * 0x1p-28 / kGranted;
  ProofRecord late = triangle_and_point(), early = late;
  late.proof.toi_lower = late.proof.toi_upper = 0.75 + 0x1p-30;
  early.proof.toi_lower = early.proof.toi_upper = 0.75 - 0x1p-30;
  expect_needs(late, kappa, "late");
  expect_needs(early, kappa, "early");
  // The same by a symbolic axis.
  late.proof.symbolic = true;
  late.proof.factor[0].given = {0, 1, 0};
  late.proof.factor[1].given = {0, 0, 1};
  expect_needs(late, kappa, "late by a symbolic axis");
}

TEST(CheckWithin, GrantsAnAxisThatIsTilted) {
  ProofRecord record = triangle_and_point();
  record.proof.axis = {1, 0x1p-30, 0};
  // The corner at y = 2 stands out by 2^-29 then.
  expect_needs(record, 1.0625 * 0x1p-29 / kGranted, "tilted");
}

TEST(CheckWithin, GrantsAMissThatTouches) {
  ProofRecord record = triangle_and_point();
  record.problem.b.position = {4, -1, 0};  // along the edge y = -1
  record.outcome = Outcome::miss;
  record.proof.axis = {0, -1, 0};
  record.proof.toi_lower = kNever;
  record.proof.toi_upper = kNever;
  record.proof.portal_size = 0;
  EXPECT_FALSE(holds(record, 0));
  EXPECT_TRUE(holds(record, 1));
  // And one that is 2^-30 deep by as much.
  record.problem.b.position[1] = -1 + 0x1p-30;
  expect_needs(record, 1.0625 * 0x1p-30 / kGranted, "a miss");
}

TEST(CheckWithin, GrantsPointsThatLieJustOutside) {
  ProofRecord record = ball_and_point();
  EXPECT_TRUE(holds(record, 0));
  record.proof.portal[0].a.offset = {1 + 0x1p-40, 0, 0};
  record.proof.toi_lower = 0.75 - 0x1p-42;
  // Points are drawn in by a sixteenth of the allowance, and this one is 2^-40 outside. The scale is 4.
  expect_needs(record, 1.0625 * 16 * 0x1p-40 / (4 * kU), "an offset");
  record = ball_and_point();
  record.problem.a.shape = Ellipsoid<double>{{1, 2, 3}};
  record.proof.portal[0].a = {};
  record.proof.portal[0].a.curved[0] = {1, 0, 0};
  EXPECT_TRUE(holds(record, 0));
  record.proof.portal[0].a.curved[0] = {1 + 0x1p-40, 0, 0};
  const double scale = std::sqrt(4.0 + 16 + 36);
  expect_needs(record, 1.0625 * 16 * 0x1p-40 / (scale * kU), "a point of an ellipsoid");
}

TEST(CheckWithin, TakesTheUnitRoundoffOfTheScalar) {
  ProofRecord record = triangle_and_point();
  record.proof.axis = {1, static_cast<double>(0x1p-24F), 0};
  EXPECT_FALSE(holds(record, 8));
  record.scalar = "float";
  EXPECT_TRUE(holds(record, 8));
}

// A point passes another by `apart`, where t is 1/2. An axis along the path proves that there is no contact
// before 0.9. A portal of the two points themselves lies on the path to within `apart`. No set within that
// has its first contact at 0.9, since the points are 3.2 apart then.
TEST(CheckWithin, WantsOneSetForBothHalves) {
  constexpr double kApart = 0x1p-20;
  ProofRecord record;
  record.problem.b.position = {4, kApart, 0};
  record.problem.b.displacement = {-8, 0, 0};
  record.scalar = "double";
  record.outcome = Outcome::hit;
  record.proof.has_axis = true;
  record.proof.axis = {kApart / 4, 1, 0};
  record.proof.toi_lower = record.proof.toi_upper = 0.9;
  record.proof.portal_size = 1;
  const double kappa = 2 * kApart / (4 * kU);
  EXPECT_FALSE(holds(record, kappa));
  ProofRecord half = record;
  half.proof.toi_lower = 0;
  half.proof.has_axis = false;
  EXPECT_TRUE(check_proof_within(half.problem, half.proof, 2 * kApart).accepted());
  half = record;
  half.proof.toi_upper = kNever;
  half.proof.portal_size = 0;
  EXPECT_TRUE(check_proof(half.problem, half.proof).accepted());
  // One set has contact at 1/2.
  record.proof.toi_lower = record.proof.toi_upper = 0.5;
  record.proof.axis = {1, 0, 0};
  EXPECT_FALSE(holds(record, 0));
  EXPECT_TRUE(holds(record, kappa));
  // And a bracket upside down never is.
  record.proof.toi_upper = std::nextafter(0.5, 0);
  EXPECT_FALSE(holds(record, kappa));
}

TEST(CheckWithin, GrantsNoFormAndNoContradiction) {
  ProofRecord record = triangle_and_point();
  record.proof.portal[0].a.vertex = 3;
  EXPECT_FALSE(holds(record, 1e6));
  record = triangle_and_point();
  record.proof.toi_lower = record.proof.toi_upper = std::nextafter(0.75, 1);
  record.outcome = Outcome::miss;
  EXPECT_EQ(check_record_within(record, {.of_proof = 16}).reason, "contradicted");
  record.outcome = Outcome::hit;
  record.toi = {0.25, 0.5};
  EXPECT_EQ(check_record_within(record, {.of_proof = 16}).reason, "contradicted");
}

}  // namespace
}  // namespace graze::oracle
