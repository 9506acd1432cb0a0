// Compares the claims of a record with those of its proof: by hand, every outcome with every kind of true
// proof, and brackets beside it.
#include "oracles/checker/check_record.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracles/arithmetic/environments.hpp"

namespace graze::oracle {
namespace {

using corpus::ProofRecord;
using test::in_every_environment;
using V = Vec3<double>;
using enum RecordFinding;

constexpr double kInf = kInfinity<double>;

std::string found(const ProofRecord& record) {
  const RecordVerdict verdict = check_record(record);
  EXPECT_EQ(verdict.finding == accepted, verdict.detail.empty());
  EXPECT_EQ(verdict.detail.find('\n'), std::string::npos);
  return verdict.finding == accepted ? "accepted" : verdict.reason;
}

// A cube of half width 1/2 comes down on one of half width 1, from a gap of 2.5, and reaches it at 0.625.
ProofRecord falling_cube(double height = 4) {
  ProofRecord record;
  record.problem.a.shape = Box<double>{V(1, 1, 1)};
  record.problem.b.shape = Box<double>{V(0.5, 0.5, 0.5)};
  record.problem.b.position = V(height, 0.25, 0.125);
  record.problem.b.displacement = V(-4, 0, 0);
  record.method = "any";
  record.scalar = "double";
  return record;
}
// Corner 1 of the cube at A's faces, named by corners of A: 1, 3, 5 and 7 are those with x = 1.
void prove_upper(ProofRecord& record, double at) {
  record.proof.toi_upper = at;
  record.proof.portal_size = 3;
  constexpr std::array<std::uint32_t, 3> kOfA = {1, 7, 3}, kOfB = {6, 0, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    record.proof.portal[i].a.vertex = kOfA[i];
    record.proof.portal[i].b.vertex = kOfB[i];
  }
}
void prove_lower(ProofRecord& record, double at) {
  record.proof.toi_lower = at;
  record.proof.has_axis = true;
  record.proof.axis = V(1, 0, 0);
}
ProofRecord hit(double lower, double upper) {
  ProofRecord record = falling_cube();
  record.outcome = Outcome::hit;
  if (lower > 0) prove_lower(record, lower);
  if (upper < kInf) prove_upper(record, upper);
  return record;
}
// In contact from the start, the cubes' middles together.
ProofRecord overlapping() {
  ProofRecord record = falling_cube(0);
  record.problem.b.position = V(0, 0, 0);
  record.outcome = Outcome::initially_overlapping;
  record.proof.toi_upper = 0;
  record.proof.portal_size = 2;
  record.proof.portal[0].a.vertex = 0;
  record.proof.portal[0].b.vertex = 0;
  record.proof.portal[1].a.vertex = 7;
  record.proof.portal[1].b.vertex = 7;
  return record;
}
ProofRecord missing() {
  ProofRecord record = falling_cube(6);
  record.outcome = Outcome::miss;
  prove_lower(record, kInf);
  return record;
}
std::string as(ProofRecord record, Outcome outcome) {
  record.outcome = outcome;
  return found(record);
}

TEST(CheckRecord, EveryOutcomeAgainstEveryProof) {
  struct Row {
    const char* proof;
    ProofRecord record;
    const char *start, *hit, *miss;
  };
  const Row rows[] = {
      {"of a hit", hit(0.625, 0.625), "contradicted", "accepted", "contradicted"},
      {"of its lower half", hit(0.5, kInf), "contradicted", "in_part", "in_part"},
      {"of its upper half", hit(0, 0.75), "in_part", "in_part", "contradicted"},
      {"of contact at the start", overlapping(), "accepted", "contradicted", "contradicted"},
      {"of a miss", missing(), "contradicted", "contradicted", "accepted"},
      {"of nothing", hit(0, kInf), "unproved", "unproved", "unproved"},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(as(row.record, Outcome::initially_overlapping), row.start) << row.proof;
    EXPECT_EQ(as(row.record, Outcome::hit), row.hit) << row.proof;
    EXPECT_EQ(as(row.record, Outcome::miss), row.miss) << row.proof;
    EXPECT_EQ(as(row.record, Outcome::not_converged), "accepted") << row.proof;
    EXPECT_EQ(as(row.record, Outcome::invalid_input), "accepted") << row.proof;
  }
}

TEST(CheckRecord, SaysWhatIsClaimedAndWhatIsProved) {
  ProofRecord record = hit(0.625, 0.625);
  record.outcome = Outcome::miss;
  EXPECT_EQ(check_record(record).detail, "claims miss, proves first contact from 0.625 to 0.625");
  record = hit(0.5, kInf);
  EXPECT_EQ(check_record(record).detail, "claims hit, proves only no contact before 0.5");
  record = hit(0, kInf);
  record.outcome = Outcome::miss;
  EXPECT_EQ(check_record(record).detail, "claims miss, proves nothing");
  // A false proof is refused by its own name, whatever is claimed.
  EXPECT_EQ(found(hit(0.626, 0.626)), "lower_not_proved");
}

TEST(CheckRecord, ALowerBoundBeyondTheStepIsAMiss) {
  ProofRecord record = hit(0.625, kInf);
  record.problem.t_max = 0.5;
  EXPECT_EQ(as(record, Outcome::miss), "accepted");
  EXPECT_EQ(as(record, Outcome::hit), "contradicted");
  record.problem.t_max = 0.625;  // contact at t_max counts
  EXPECT_EQ(as(record, Outcome::miss), "in_part");
  EXPECT_EQ(as(record, Outcome::hit), "in_part");
  record = missing();
  record.problem.b.displacement = V(4, 0, 0);
  record.problem.t_max = kInf;
  EXPECT_EQ(as(record, Outcome::miss), "accepted");
  EXPECT_EQ(as(record, Outcome::hit), "contradicted");
}

// Whatever is proved, and in every tier: a hit is later than the start.
TEST(CheckRecord, AStepOfNoTimeHasNoHit) {
  ProofRecord record = hit(0, kInf);
  record.problem.t_max = 0;
  for (const std::optional<Tier> tier : {std::optional<Tier>(), {Tier::exact}, {Tier::standard}}) {
    record.tier = tier;
    EXPECT_EQ(as(record, Outcome::hit), "contradicted");
    EXPECT_EQ(as(record, Outcome::not_converged), "accepted");
  }
}

TEST(CheckRecord, BracketsThatShareNoTimeContradict) {
  const double below = std::nextafter(0.625, 0.0), above = std::nextafter(0.625, 1.0);
  struct Row {
    corpus::StatedBracket stated;
    const char *standard, *certified;
  };
  const Row rows[] = {
      {{0.625, 0.625}, "accepted", "accepted"},  // all of it
      {{below, above}, "accepted", "accepted"},  // more closely than stated
      {{0, kInf}, "accepted", "accepted"},
      {{above, above}, "contradicted", "contradicted"},
      {{below, below}, "contradicted", "contradicted"},
      {{0, 0}, "contradicted", "contradicted"},
      {{2, 3}, "contradicted", "contradicted"},  // beyond t_max
  };
  for (const Row& row : rows) {
    ProofRecord record = hit(0.625, 0.625);
    record.toi = row.stated;
    EXPECT_EQ(found(record), row.certified) << row.stated.lower << " " << row.stated.upper;
    for (const Tier tier : {Tier::certified, Tier::exact, Tier::standard}) {
      record.tier = tier;
      EXPECT_EQ(found(record), tier == Tier::standard ? row.standard : row.certified)
          << row.stated.lower << " " << row.stated.upper;
    }
  }
  // A proof that brackets it less closely proves less, in every tier.
  ProofRecord loose = hit(0.5, 0.75);
  for (const corpus::StatedBracket stated :
       {corpus::StatedBracket{0.625, 0.625}, {0.5, 0.625}, {0.625, 0.75}, {0.75, 0.75}}) {
    loose.toi = stated;
    for (const std::optional<Tier> tier :
         {std::optional<Tier>{}, {Tier::certified}, {Tier::exact}, {Tier::standard}}) {
      loose.tier = tier;
      EXPECT_EQ(found(loose), "in_part");
    }
  }
  loose.toi = {0.75 + 0x1p-40, 0.8};
  EXPECT_EQ(found(loose), "contradicted");
  loose.tier = {};
  EXPECT_EQ(found(loose), "contradicted");
}

// The cube goes 4 in a unit of t: a length that is granted moves the times that the same axis and portal prove.
TEST(CheckRecord, ABracketOfTierStandardIsGrantedALength) {
  constexpr double kGranted = 0x1p-20, kTime = kGranted / 4;
  ProofRecord loose = hit(0.5, 0.75);
  struct Row {
    corpus::StatedBracket stated;
    const char* finding;
  };
  for (const Row& row :
       {Row{{0.625, 0.625}, "accepted"}, Row{{0.625 + 0.9 * kTime, 0.625 + 0.9 * kTime}, "accepted"},
        Row{{0.625 - 0.9 * kTime, 0.625 - 0.9 * kTime}, "accepted"},
        Row{{0.625 + 1.1 * kTime, 0.75}, "in_part"}, Row{{0.5, 0.625 - 1.1 * kTime}, "in_part"},
        Row{{0.7, 0.7}, "in_part"}, Row{{0.5, 0.55}, "in_part"}}) {
    loose.toi = row.stated;
    const auto finding = [&](Tier tier) {
      loose.tier = tier;
      const RecordVerdict verdict = check_record(loose, kGranted);
      return verdict.finding == accepted ? "accepted" : verdict.reason;
    };
    EXPECT_EQ(finding(Tier::standard), row.finding) << row.stated.lower << " " << row.stated.upper;
    EXPECT_EQ(finding(Tier::certified), "in_part");
    loose.outcome = Outcome::not_converged;
    EXPECT_EQ(finding(Tier::standard), row.finding);
    loose.outcome = Outcome::hit;
  }
}

TEST(CheckRecord, BracketsBesideOtherOutcomes) {
  ProofRecord record = missing();
  record.toi = {0.5, 1};
  EXPECT_EQ(found(record), "contradicted");  // by itself
  record.toi = {1, kInf};
  EXPECT_EQ(found(record), "accepted");
  record = overlapping();
  record.toi = {0, 0};
  EXPECT_EQ(found(record), "accepted");
  record.toi = {0.25, 0.25};
  EXPECT_EQ(found(record), "contradicted");
  record = hit(0.5, 0.75);
  record.outcome = Outcome::not_converged;
  record.toi = {0.25, kInf};
  EXPECT_EQ(found(record), "accepted");
  record.toi = {0.625, kInf};
  EXPECT_EQ(found(record), "in_part");
  record.toi = {0.8, kInf};
  EXPECT_EQ(found(record), "contradicted");
  record = missing();
  record.outcome = Outcome::not_converged;
  record.toi = {0.25, kInf};
  EXPECT_EQ(found(record), "accepted");
  record.toi = {0.25, 0.75};
  EXPECT_EQ(found(record), "contradicted");
}

TEST(CheckRecord, WhatAnHonestRecordCannotProveIsNotRefused) {
  // The standard tier may give no proof for a miss that is decided by rounding alone.
  ProofRecord record = hit(0, kInf);
  record.outcome = Outcome::miss;
  record.tier = Tier::standard;
  EXPECT_EQ(found(record), "in_part");
  record.tier = Tier::certified;
  EXPECT_EQ(found(record), "unproved");
  // A start that goes deeper is reported under pass_over, and the proof has no words for that.
  record = overlapping();
  record.problem.start_policy = corpus::StartPolicy::pass_over;
  EXPECT_EQ(found(record), "unsupported");
  record.proof = {};
  for (const Tier tier : {Tier::certified, Tier::exact, Tier::standard}) {
    record.tier = tier;
    EXPECT_EQ(found(record), "in_part");
  }
  record.problem.start_policy = corpus::StartPolicy::report;
  record.tier = Tier::exact;
  EXPECT_EQ(found(record), "unproved");
}

// A feature holds two points of curved parts.
TEST(CheckRecord, APointOfThreeCurvedPartsHasNoName) {
  ProofRecord record = overlapping();
  record.proof = {};
  record.tier = Tier::certified;
  Shape<double> shape = Cylinder<double>{1, 1};
  for (const char* expected : {"unproved", "unproved", "in_part"}) {
    record.problem.a.shape = rounded<double>(shape, 0.25);
    EXPECT_EQ(found(record), expected);
    EXPECT_EQ(as(record, Outcome::miss), "unproved");
    shape = sum<double>(shape, Cone<double>{1, 1});
  }
}

TEST(CheckRecord, ChainsAreComparedToo) {
  // A bar turns a quarter over a plate, clear of it.
  ProofRecord record;
  record.problem.a.shape = Box<double>{V(9, 9, 1)};
  record.problem.b.shape = Box<double>{V(2, 0.5, 0.5)};
  record.problem.b.position = V(0, 0, 3.25);
  record.problem.spin_b.rotation = V(0, 1.5, 0);
  record.rotating.emplace();
  record.rotating->toi_lower = kInf;
  record.rotating->chain = {{1, V(0, 0, 1), AxisFrame::world}};
  EXPECT_EQ(as(record, Outcome::miss), "accepted");
  EXPECT_EQ(as(record, Outcome::hit), "contradicted");
  record.rotating->toi_lower = 0.5;
  EXPECT_EQ(as(record, Outcome::miss), "in_part");
  EXPECT_EQ(as(record, Outcome::hit), "in_part");
  EXPECT_EQ(as(record, Outcome::initially_overlapping), "contradicted");
  record.rotating.emplace();
  EXPECT_EQ(as(record, Outcome::miss), "unproved");
}

// 5e-324 > 0, in every environment.
TEST(CheckRecord, ASubnormalTimeIsNotTheStart) {
  ProofRecord record = falling_cube();
  prove_lower(record, 5e-324);
  record.outcome = Outcome::initially_overlapping;
  for (const auto& [name, result, given_back] : in_every_environment([&] { return found(record); })) {
    EXPECT_EQ(result, "contradicted") << name;
    EXPECT_TRUE(given_back) << name;
  }
}

}  // namespace
}  // namespace graze::oracle
