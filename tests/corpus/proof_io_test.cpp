// Proofs as text: they read back to the same bits, and what is malformed is refused with the field named.
#include "corpus/format/proof_io.hpp"

#include <gtest/gtest.h>

namespace graze::corpus {
namespace {

ProofRecord example() {
  ProofRecord record;
  record.problem.id = "test/proof";
  record.problem.a.shape = Box<double>{Vec3<double>(1, 2, 3)};
  record.problem.b.shape = Sphere<double>{0.1};
  record.problem.b.displacement = Vec3<double>(0, 0, -1);
  record.method = "mpr";
  record.scalar = "double";
  record.outcome = Outcome::hit;
  record.proof.toi_lower = 1.0 / 3;
  record.proof.has_axis = true;
  record.proof.axis = Vec3<double>(-0.0, 5e-324, 1);
  record.proof.toi_upper = 2.0 / 3;
  record.proof.portal_size = 3;
  record.proof.portal[0].a.vertex = 7;
  record.proof.portal[1].b.offset = Vec3<double>(0, 0, 0.1);
  record.proof.portal[2].b.offset = Vec3<double>(0, -0.0, 0);
  record.proof.portal[1].a.curved[0] = Vec3<double>(0.1, 0.2, -0.0);
  record.proof.portal[2].a.curved[1] = Vec3<double>(0, 0, 1);
  return record;
}

// n = -(v x (a_to - b_to - a_from + b_from)), every field of a pair in use.
ProofRecord symbolic_example() {
  ProofRecord record = example();
  record.proof.symbolic = true;
  record.proof.axis_sign = -1;
  record.proof.axis = Vec3<double>::Zero();
  record.proof.factor[0].kind = AxisFactor::Kind::motion;
  AxisFactor& edge = record.proof.factor[1];
  edge.kind = AxisFactor::Kind::difference;
  edge.from.a.vertex = 6;
  edge.from.b.offset = Vec3<double>(0, 0.3, -0.0);
  edge.to.a.vertex = 4294967295;
  edge.to.b.curved[1] = Vec3<double>(5e-324, 0.7, -1);
  return record;
}

// n to the path at t = 0.1, tilted by n x f, and a portal of cores.
ProofRecord nearest_example() {
  ProofRecord record = example();
  Proof& proof = record.proof;
  proof.symbolic = proof.then = proof.of_cores = true;
  proof.axis = Vec3<double>::Zero();
  proof.nearest.size = 2;
  proof.nearest.pair[0].a.vertex = 6;
  proof.nearest.pair[1].b.vertex = 3;
  proof.nearest.time = 0.1;
  proof.nearest.motion = true;
  proof.factor[0].kind = AxisFactor::Kind::difference;
  proof.factor[0].to.a.vertex = 4;
  return record;
}

void expect_same_pair(const SupportPair& l, const SupportPair& r) {
  EXPECT_EQ(l.a.vertex, r.a.vertex);
  EXPECT_EQ(l.b.vertex, r.b.vertex);
  EXPECT_EQ(l.a.offset, r.a.offset);
  EXPECT_EQ(l.b.offset, r.b.offset);
  EXPECT_EQ(l.a.curved, r.a.curved);
  EXPECT_EQ(l.b.curved, r.b.curved);
}

void expect_same(const ProofRecord& l, const ProofRecord& r) {
  // Equal text is equal bits: the round trip of numbers is tested on its own.
  EXPECT_EQ(write_proof(l), write_proof(r));
  EXPECT_TRUE(same_case(l.problem, r.problem));
  EXPECT_EQ(l.method, r.method);
  EXPECT_EQ(l.scalar, r.scalar);
  EXPECT_EQ(l.outcome, r.outcome);
  EXPECT_EQ(l.proof.toi_lower, r.proof.toi_lower);
  EXPECT_EQ(l.proof.has_axis, r.proof.has_axis);
  EXPECT_EQ(l.proof.axis, r.proof.axis);
  EXPECT_EQ(l.proof.symbolic, r.proof.symbolic);
  EXPECT_EQ(l.proof.axis_sign, r.proof.axis_sign);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(l.proof.factor[i].kind, r.proof.factor[i].kind);
    EXPECT_EQ(l.proof.factor[i].given, r.proof.factor[i].given);
    expect_same_pair(l.proof.factor[i].from, r.proof.factor[i].from);
    expect_same_pair(l.proof.factor[i].to, r.proof.factor[i].to);
  }
  ASSERT_EQ(l.proof.nearest.size, r.proof.nearest.size);
  for (std::size_t i = 0; i < 3; ++i) expect_same_pair(l.proof.nearest.pair[i], r.proof.nearest.pair[i]);
  EXPECT_EQ(l.proof.nearest.time, r.proof.nearest.time);
  EXPECT_EQ(l.proof.nearest.motion, r.proof.nearest.motion);
  EXPECT_EQ(l.proof.then, r.proof.then);
  EXPECT_EQ(l.proof.of_cores, r.proof.of_cores);
  EXPECT_EQ(l.proof.toi_upper, r.proof.toi_upper);
  ASSERT_EQ(l.proof.portal_size, r.proof.portal_size);
  for (int i = 0; i < l.proof.portal_size; ++i) expect_same_pair(l.proof.portal[i], r.proof.portal[i]);
}

TEST(ProofIo, ReadsBackWhatItWrote) {
  ProofRecord bare = example();
  bare.outcome = Outcome::miss;
  bare.proof = {};
  bare.proof.toi_lower = kInfinity<double>;
  const std::string text = write_proof(example()) + "\n" + write_proof(bare) + "\n";
  const ProofReadResult result = read_proofs_text(text, "p.jsonl");
  ASSERT_TRUE(result.ok()) << result.errors[0].text();
  ASSERT_EQ(result.proofs.size(), 2u);
  expect_same(result.proofs[0], example());
  expect_same(result.proofs[1], bare);
  EXPECT_EQ(result.proofs[1].line, 2);
  EXPECT_TRUE(std::signbit(result.proofs[0].proof.axis[0]));
}

TEST(ProofIo, KeepsTheTierAndTheBracketWhereARecordStatesThem) {
  ProofRecord stated = example();
  stated.tier = Tier::certified;
  stated.toi = {5e-324, kInfinity<double>};
  const ProofReadResult result = read_proofs_text(write_proof(stated) + "\n" + write_proof(example()), "p");
  ASSERT_TRUE(result.ok()) << result.errors[0].text();
  expect_same(result.proofs[0], stated);
  EXPECT_EQ(result.proofs[0].tier, Tier::certified);
  ASSERT_TRUE(result.proofs[0].toi);
  EXPECT_EQ(result.proofs[0].toi->lower, 5e-324);
  EXPECT_EQ(result.proofs[0].toi->upper, kInfinity<double>);
  EXPECT_FALSE(result.proofs[1].tier);
  EXPECT_FALSE(result.proofs[1].toi);
  for (const auto& [from, to, message] :
       {std::tuple("\"certified\"", "\"best\"", "p:1: tier: the string \"best\"; one of"),
        std::tuple("\"upper\": \"inf\"", "\"upper\": 0", "p:1: toi: lower is above upper"),
        std::tuple("\"upper\": \"inf\"", "\"uper\": 1", "p:1: toi: unknown field \"uper\"")}) {
    std::string text = write_proof(stated);
    text.replace(text.find(from), std::string(from).size(), to);
    const ProofReadResult bad = read_proofs_text(text, "p");
    ASSERT_EQ(bad.errors.size(), 1u);
    EXPECT_EQ(bad.errors[0].text().substr(0, std::string(message).size()), message) << bad.errors[0].text();
  }
}

TEST(ProofIo, AFileOfCasesIsOneError) {
  const std::string line = write_case(example().problem), pretty = write_case_pretty(example().problem);
  for (const std::string& text : {line, line + "\n" + line + "\n" + line, pretty}) {
    const ProofReadResult result = read_proofs_text(text, "c.jsonl");
    ASSERT_EQ(result.errors.size(), 1u);
    EXPECT_EQ(result.errors[0].text().substr(0, 23), "c.jsonl:1: schema: hold");
  }
  const ProofReadResult mixed = read_proofs_text(write_proof(example()) + "\n" + line + "\n" + line, "m");
  EXPECT_EQ(mixed.proofs.size(), 1u);
  ASSERT_EQ(mixed.errors.size(), 1u);
  EXPECT_EQ(mixed.errors[0].text().substr(0, 26), "m:2: schema: holds 2 cases");
}

TEST(ProofIo, RefusesWhatIsMalformedAndKeepsTheRest) {
  const std::string sound = write_proof(example());
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = sound;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const struct {
    std::string text;
    const char* message;
  } malformations[] = {
      {"{", "p.jsonl:1: not JSON"},
      {replaced("graze.proof/1", "graze.proof/9"), "p.jsonl:1: schema: "},
      {replaced("\"radius\": 0.1", "\"radius\": -1"), "p.jsonl:1: case.b.shape.radius: -1 is negative"},
      {replaced("\"outcome\": \"hit\"", "\"outcome\": \"hits\""),
       "p.jsonl:1: outcome: the string \"hits\"; one of"},
      {replaced("\"toi_lower\"", "\"toi\""), "p.jsonl:1: proof: unknown field \"toi\""},
      {replaced("\"vertex\": 7", "\"vertex\": -7"),
       "p.jsonl:1: proof.portal[0].a.vertex: the number -7; an index"},
      {replaced("\"vertex\": 7", "\"vertex\": 4294967296"), "p.jsonl:1: proof.portal[0].a.vertex: "},
      {replaced("[0, 0, 0.1]", "[0, 0]"), "p.jsonl:1: proof.portal[1].b.offset: an array of 2"},
      {replaced("[0.1, 0.2, -0.0]", "[0.1, 0.2]"), "p.jsonl:1: proof.portal[1].a.curved[0]: an array of 2"},
      {replaced("[0, 0, 0], [0, 0, 1]", "[0, 0, 0], [0, 0, 1], [0, 0, 1]"),
       "p.jsonl:1: proof.portal[2].a.curved: an array of 3"},
      {replaced("\"portal\": [", "\"portal\": [1, 2, "), "p.jsonl:1: proof.portal: an array of 5"},
      {replaced("\"portal\": [", "\"portal\": [1, "), "p.jsonl:1: proof.portal[0]: the number 1"},
      {replaced("\"axis\": [", "\"axis\": [1, "), "p.jsonl:1: proof.axis: an array of 4"},
  };
  for (const auto& malformation : malformations) {
    const ProofReadResult result = read_proofs_text(malformation.text + "\n" + sound, "p.jsonl");
    EXPECT_EQ(result.proofs.size(), 1u);
    ASSERT_EQ(result.errors.size(), 1u) << malformation.text;
    const std::string line = result.errors[0].text();
    EXPECT_EQ(line.substr(0, std::string(malformation.message).size()), malformation.message) << line;
  }
}

TEST(ProofIo, ReadsBackSymbolicAxes) {
  ProofRecord triples = symbolic_example();
  triples.proof.axis_sign = 1;
  triples.proof.factor[0] = {};
  triples.proof.factor[0].given = Vec3<double>(-0.0, 0.1, 5e-324);
  const ProofRecord given[] = {symbolic_example(), triples};
  const ProofReadResult result =
      read_proofs_text(write_proof(given[0]) + "\n" + write_proof(given[1]), "p.jsonl");
  ASSERT_TRUE(result.ok()) << result.errors[0].text();
  ASSERT_EQ(result.proofs.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) expect_same(result.proofs[i], given[i]);
  EXPECT_TRUE(std::signbit(result.proofs[0].proof.factor[1].from.b.offset[2]));
  EXPECT_TRUE(std::signbit(result.proofs[1].proof.factor[0].given[0]));
}

TEST(ProofIo, ReadsBackNearestAxesAndPortalsOfCores) {
  ProofRecord plain = nearest_example();
  plain.proof.then = plain.proof.nearest.motion = false;
  plain.proof.factor[0] = {};
  plain.proof.of_cores = false;
  const ProofReadResult result =
      read_proofs_text(write_proof(nearest_example()) + "\n" + write_proof(plain) + "\n", "p.jsonl");
  ASSERT_TRUE(result.ok()) << result.errors[0].text();
  ASSERT_EQ(result.proofs.size(), 2u);
  expect_same(result.proofs[0], nearest_example());
  expect_same(result.proofs[1], plain);
}

TEST(ProofIo, RefusesMalformedNearestAxes) {
  const std::string sound = write_proof(nearest_example());
  for (const auto& [from, to, message] :
       {std::tuple("\"time\": 0.1, ", "", "p:1: proof.axis.time: missing"),
        std::tuple("\"time\": 0.1", "\"time\": \"inf\"", "p:1: proof.axis.time: "),
        std::tuple("\"motion\": true", "\"motion\": 1", "p:1: proof.axis.motion: the number 1; true if"),
        std::tuple("\"nearest\": [", "\"nearest\": [], \"pairs\": [",
                   "p:1: proof.axis: unknown field \"pairs\""),
        std::tuple("\"then\": {\"from\"", "\"then\": {\"off\"",
                   "p:1: proof.axis.then: unknown field \"off\""),
        std::tuple("\"cores\": [", "\"portal\": [], \"cores\": [",
                   "p:1: proof.cores: the proof has a portal")}) {
    std::string text = sound;
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), std::string(from).size(), to);
    const ProofReadResult bad = read_proofs_text(text, "p");
    ASSERT_EQ(bad.errors.size(), 1u) << text;
    EXPECT_EQ(bad.errors[0].text().substr(0, std::string(message).size()), message) << bad.errors[0].text();
  }
}

TEST(ProofIo, RefusesMalformedSymbolicAxes) {
  const std::string sound = write_proof(symbolic_example());
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = sound;
    EXPECT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const struct {
    std::string text;
    const char* message;
  } malformations[] = {
      {replaced("\"sign\": -1", "\"sign\": 0"), "p.jsonl:1: proof.axis.sign: the number 0; the sign of"},
      {replaced("\"sign\": -1", "\"sign\": \"-\""), "p.jsonl:1: proof.axis.sign: the string \"-\"; the"},
      {replaced("\"sign\": -1, ", ""), "p.jsonl:1: proof.axis.sign: missing"},
      {replaced("\"sign\"", "\"plus\": 1, \"sign\""), "p.jsonl:1: proof.axis: unknown field \"plus\""},
      {replaced("\"cross\"", "\"dot\""), "p.jsonl:1: proof.axis: unknown field \"dot\""},
      {replaced("\"cross\": [", "\"cross\": [[1, 0, 0], "), "p.jsonl:1: proof.axis.cross: an array of 3"},
      {replaced("\"motion\", ", ""), "p.jsonl:1: proof.axis.cross: an array of 1"},
      {replaced("\"motion\"", "\"velocity\""), "p.jsonl:1: proof.axis.cross[0]: the string \"velocity\"; a"},
      {replaced("\"motion\"", "[1, 0]"), "p.jsonl:1: proof.axis.cross[0]: an array of 2"},
      {replaced("\"motion\"", "[1, \"inf\", 0]"), "p.jsonl:1: proof.axis.cross[0][1]: "},
      {replaced("\"from\"", "\"away\""), "p.jsonl:1: proof.axis.cross[1]: unknown field \"away\""},
      {replaced("\"vertex\": 6", "\"vertex\": -6"),
       "p.jsonl:1: proof.axis.cross[1].from.a.vertex: the number"},
  };
  for (const auto& malformation : malformations) {
    const ProofReadResult result = read_proofs_text(malformation.text + "\n" + sound, "p.jsonl");
    EXPECT_EQ(result.proofs.size(), 1u);
    ASSERT_EQ(result.errors.size(), 1u) << malformation.text;
    const std::string line = result.errors[0].text();
    EXPECT_EQ(line.substr(0, std::string(malformation.message).size()), malformation.message) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

ProofRecord rotating_example() {
  ProofRecord record = example();
  record.proof = {};
  record.problem.spin_a.rotation = Vec3<double>(0, 0, 513);
  record.problem.spin_b.pivot = Vec3<double>(0.1, -0.0, 0);
  RotatingProof& proof = record.rotating.emplace();
  proof.toi_lower = 1.0 / 3;
  proof.chain = {{0.1, Vec3<double>(-0.0, 5e-324, 1), AxisFrame::world},
                 {0.2, Vec3<double>(1, 0, 0), AxisFrame::a},
                 {1.0 / 3, Vec3<double>(0, 1, 0), AxisFrame::b}};
  proof.toi_upper = 2.0 / 3;
  proof.contact_size = 2;
  proof.contact[0].a.vertex = 7;
  proof.contact[1].b.curved[0] = Vec3<double>(0.1, 0.2, -0.0);
  proof.weight = {0.3, 0.7, 0, 0};
  return record;
}

void expect_same_rotating(const ProofRecord& l, const ProofRecord& r) {
  expect_same(l, r);
  ASSERT_TRUE(l.rotating && r.rotating);
  EXPECT_EQ(l.rotating->toi_lower, r.rotating->toi_lower);
  EXPECT_EQ(l.rotating->toi_upper, r.rotating->toi_upper);
  ASSERT_EQ(l.rotating->chain.size(), r.rotating->chain.size());
  for (std::size_t i = 0; i < l.rotating->chain.size(); ++i) {
    EXPECT_EQ(l.rotating->chain[i].end, r.rotating->chain[i].end);
    EXPECT_EQ(l.rotating->chain[i].axis, r.rotating->chain[i].axis);
    EXPECT_EQ(l.rotating->chain[i].frame, r.rotating->chain[i].frame);
  }
  ASSERT_EQ(l.rotating->contact_size, r.rotating->contact_size);
  for (std::size_t i = 0; i < static_cast<std::size_t>(l.rotating->contact_size); ++i) {
    expect_same_pair(l.rotating->contact[i], r.rotating->contact[i]);
    EXPECT_EQ(l.rotating->weight[i], r.rotating->weight[i]);
  }
  EXPECT_EQ(l.rotating->crossing, r.rotating->crossing);
  EXPECT_EQ(l.rotating->contact_from, r.rotating->contact_from);
}

ProofRecord crossing_example() {
  ProofRecord record = rotating_example();
  RotatingProof& proof = *record.rotating;
  proof.crossing = true;
  proof.contact_from = 0.1;
  proof.contact_size = 3;
  proof.contact[2].b.vertex = 5;
  proof.weight = {0, 0, 0, 0};
  return record;
}

TEST(ProofIo, ReadsBackRotatingProofsAmongLinearOnes) {
  ProofRecord bare = rotating_example();
  bare.rotating.emplace().toi_lower = kInfinity<double>;
  const ProofReadResult result = read_proofs_text(
      write_proof(rotating_example()) + "\n" + write_proof(example()) + "\n" + write_proof(bare) + "\n",
      "p.jsonl");
  ASSERT_TRUE(result.ok()) << result.errors[0].text();
  ASSERT_EQ(result.proofs.size(), 3u);
  expect_same_rotating(result.proofs[0], rotating_example());
  EXPECT_TRUE(std::signbit(result.proofs[0].rotating->chain[0].axis[0]));
  EXPECT_FALSE(result.proofs[1].rotating);
  expect_same_rotating(result.proofs[2], bare);
}

TEST(ProofIo, RefusesMalformedRotatingProofs) {
  const std::string sound = write_proof(rotating_example());
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = sound;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  };
  const struct {
    std::string text;
    const char* message;
  } malformations[] = {
      {replaced("\"chain\"", "\"axis\": [0, 0, 1], \"chain\""), "p.jsonl:1: proof: unknown field \"axis\""},
      {replaced("\"contact\"", "\"portal\""), "p.jsonl:1: proof: unknown field \"portal\""},
      {replaced("\"end\": 0.1", "\"end\": \"inf\""), "p.jsonl:1: proof.chain[0].end: "},
      {replaced("\"end\": 0.1, ", ""), "p.jsonl:1: proof.chain[0].end: missing"},
      {replaced("\"end\": 0.1", "\"begin\": 0, \"end\": 0.1"),
       "p.jsonl:1: proof.chain[0]: unknown field \"begin\""},
      {replaced("\"axis\": [1, 0, 0]", "\"axis\": [1, 0]"), "p.jsonl:1: proof.chain[1].axis: an array of 2"},
      {replaced("\"frame\": \"b\"", "\"frame\": \"c\""),
       "p.jsonl:1: proof.chain[2].frame: the string \"c\"; one of"},
      {replaced("\"chain\": [", "\"chain\": [0, "), "p.jsonl:1: proof.chain[0]: the number 0"},
      {replaced("\"toi_upper\": ", "\"toi_upper\": true, \"other\": "), "p.jsonl:1: proof: unknown field"},
      {replaced("\"vertex\": 7", "\"vertex\": -7"), "p.jsonl:1: proof.contact[0].a.vertex: the number -7"},
      {replaced("\"weight\": 0.3", "\"weight\": \"inf\""), "p.jsonl:1: proof.contact[0].weight: "},
      {replaced(", \"weight\": 0.3", ""), "p.jsonl:1: proof.contact[0].weight: missing"},
      {replaced("\"contact\": [", "\"contact\": [1, 2, 3, 4, 5, "),
       "p.jsonl:1: proof.contact: an array of 7"},
  };
  for (const auto& malformation : malformations) {
    const ProofReadResult result = read_proofs_text(malformation.text + "\n" + sound, "p.jsonl");
    EXPECT_EQ(result.proofs.size(), 1u);
    ASSERT_EQ(result.errors.size(), 1u) << malformation.text;
    const std::string line = result.errors[0].text();
    EXPECT_EQ(line.substr(0, std::string(malformation.message).size()), malformation.message) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST(ProofIo, ReadsBackCrossingsWithAndWithoutWeights) {
  ProofRecord weighted = crossing_example(), at_once = crossing_example();
  weighted.rotating->weight = {0.25, 0, 0.75, 0};
  at_once.rotating->contact_from = 0;
  const ProofRecord given[] = {crossing_example(), weighted, at_once};
  EXPECT_EQ(write_proof(given[0]).find("\"weight\""), std::string::npos);
  EXPECT_NE(write_proof(given[2]).find("\"contact_from\": 0,"), std::string::npos);
  EXPECT_EQ(write_proof(rotating_example()).find("contact_from"), std::string::npos);
  std::string text;
  for (const ProofRecord& record : given) text += write_proof(record) + "\n";
  const ProofReadResult result = read_proofs_text(text, "p.jsonl");
  ASSERT_TRUE(result.ok()) << result.errors[0].text();
  ASSERT_EQ(result.proofs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) expect_same_rotating(result.proofs[i], given[i]);
}

TEST(ProofIo, RefusesMalformedCrossings) {
  const std::string sound = write_proof(crossing_example());
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = sound;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  };
  const std::string from = "\"contact_from\": 0.1";
  const struct {
    std::string text;
    const char* message;
  } malformations[] = {
      {replaced(from, "\"contact_from\": \"inf\""), "p.jsonl:1: proof.contact_from: "},
      {replaced(from, "\"contact_from\": true"), "p.jsonl:1: proof.contact_from: "},
      {replaced(from, "\"contact_from\": [0.1]"), "p.jsonl:1: proof.contact_from: "},
      {replaced(from, "\"crossing\": true"), "p.jsonl:1: proof: unknown field \"crossing\""},
      // Without it, it is no crossing, and the pairs want weights.
      {replaced(from + ", ", ""), "p.jsonl:1: proof.contact[0].weight: missing"},
      {replaced("\"contact\": [{", "\"contact\": [{\"weight\": \"inf\", "),
       "p.jsonl:1: proof.contact[0].weight: "},
      {replaced("\"chain\": [", "\"chain\": [{\"end\": 0, \"axis\": [0, 0, 1], \"contact_from\": 0}, "),
       "p.jsonl:1: proof.chain[0]: unknown field \"contact_from\""},
  };
  for (const auto& malformation : malformations) {
    const ProofReadResult result = read_proofs_text(malformation.text + "\n" + sound, "p.jsonl");
    EXPECT_EQ(result.proofs.size(), 1u);
    ASSERT_EQ(result.errors.size(), 1u) << malformation.text;
    const std::string line = result.errors[0].text();
    EXPECT_EQ(line.substr(0, std::string(malformation.message).size()), malformation.message) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST(ProofIo, AnEmptyReadFails) { EXPECT_FALSE(read_proofs_text("\n", "p.jsonl").ok()); }

}  // namespace
}  // namespace graze::corpus
