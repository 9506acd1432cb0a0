// An engine's declaration is read field by field. A refusal is one line that names the field and the valid
// values.
#include "certify/external/declaration.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace graze::external {
namespace {

constexpr const char* kLeast =
    R"({"schema": "graze.engine/1", "name": "mine", "scalar": "float", "shapes": ["box"], "queries": {"cast": )"
    R"({"answers": []}}})";

// kLeast with `to` instead of `from`.
std::string with(const std::string& from, const std::string& to) {
  std::string line = kLeast;
  const std::size_t at = line.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return line.replace(at, from.size(), to);
}
// With fields beside the others, or within the query.
std::string and_with(const std::string& field) { return with("\"queries\"", field + ", \"queries\""); }
std::string and_of_the_cast(const std::string& field) { return with("[]}", "[], " + field + "}"); }

TEST(Declaration, NeedsLittle) {
  const Declaration engine = parse_declaration(kLeast);
  EXPECT_EQ(engine.name, "mine");
  EXPECT_TRUE(engine.in_float());
  EXPECT_EQ(engine.unit_roundoff(), kUnitRoundoff<float>);
  EXPECT_TRUE(engine.takes("box"));
  EXPECT_FALSE(engine.takes("sphere"));
  ASSERT_EQ(engine.offers.size(), 1U);
  const Offer& cast = engine.offers.front();
  EXPECT_EQ(cast.question, Question::cast);
  EXPECT_FALSE(cast.holds.time || cast.holds.normal || cast.holds.witnesses);
  EXPECT_FALSE(cast.promises_errors());
  EXPECT_EQ(cast.touching, engine::Touching::either);
  EXPECT_TRUE(cast.starts);
  EXPECT_EQ(engine.margin, 0);
  EXPECT_FALSE(engine.lengths || engine.most_turn || engine.most_aspect || engine.most_vertices);
  EXPECT_FALSE(engine.infinite_t_max || engine.relative_motion || engine.timed);
  EXPECT_TRUE(engine.pivots);
}

TEST(Declaration, IsReadToTheLastField) {
  const Declaration engine = parse_declaration(
      R"({"schema": "graze.engine/1", "name": "a.b_c-2", "version": "1.2", "about": "x", "scalar": "double",
       "shapes": ["sphere", "hull_of"], "margin": 0.25, "lengths": [0.5, 64], "infinite_t_max": true,
       "motion": "relative", "pivots": false, "most_turn": 3, "most_vertices": 64, "most_aspect": 100, "timed": true,
       "queries": {"ray": {"answers": ["time", "normal", "witnesses", "proof"], "tolerance": 1, "relative_tolerance": 2,
        "kappa": 3, "touching": "miss", "early": 4, "starts": false, "stalls": 0.5, "target_distance": true,
        "pass_over": true}, "distance": {"answers": ["distance"], "touching": "contact"},
        "penetration": {"answers": ["depth"]}}})");
  EXPECT_EQ(engine.name, "a.b_c-2");
  EXPECT_EQ(engine.version, "1.2");
  EXPECT_FALSE(engine.in_float());
  EXPECT_EQ(engine.margin, 0.25);
  ASSERT_TRUE(engine.lengths);
  EXPECT_EQ(engine.lengths->least, 0.5);
  EXPECT_EQ(engine.lengths->most, 64);
  EXPECT_TRUE(engine.infinite_t_max && engine.relative_motion && engine.timed && !engine.pivots);
  EXPECT_EQ(engine.most_turn, 3);
  EXPECT_EQ(engine.most_vertices, 64U);
  EXPECT_EQ(engine.most_aspect, 100);
  ASSERT_EQ(engine.offers.size(), 3U);
  const Offer& ray = engine.offers[0];
  EXPECT_EQ(ray.question, Question::ray);
  EXPECT_TRUE(ray.holds.time && ray.holds.normal && ray.holds.witnesses && ray.holds_proof);
  EXPECT_EQ(ray.tolerance, 1);
  EXPECT_EQ(ray.relative_tolerance, 2);
  EXPECT_EQ(ray.kappa, 3);
  EXPECT_EQ(ray.touching, engine::Touching::miss);
  EXPECT_EQ(ray.early, 4);
  EXPECT_FALSE(ray.starts);
  EXPECT_EQ(ray.stalls, 0.5);
  EXPECT_TRUE(ray.takes_target_distance && ray.takes_pass_over);
  EXPECT_EQ(engine.offers[1].touching, engine::Touching::contact);
  EXPECT_TRUE(engine.offers[1].holds_distance && engine.offers[2].holds_depth);
}

struct Bad {
  std::string line, field, right;
};

TEST(Declaration, SaysWhatIsWrongInOneLine) {
  const Bad all[] = {
      {"", "", ""},
      {"Bad Engine 1.0", "", ""},
      {std::string(kLeast) + "x", "", ""},
      {"[]", "", "object"},
      {with("graze.engine/1", "graze.engine/2"), "schema", "graze.engine/1"},
      {with("\"schema\": \"graze.engine/1\", ", ""), "schema", "graze.engine/1"},
      {with("\"mine\"", "\"my engine\""), "name", "letters, digits"},
      {with("\"mine\"", "\"\""), "name", "letters, digits"},
      {with("\"mine\"", "7"), "name", "string"},
      {with("\"mine\"", "\"" + std::string(65, 'a') + "\""), "name", "letters"},
      {with("\"float\"", "\"half\""), "scalar", "float or double"},
      {with("\"scalar\": \"float\", ", ""), "scalar", "float or double"},
      {with("[\"box\"]", "[]"), "shapes", "one or more"},
      {with("[\"box\"]", "\"box\""), "shapes", "array"},
      {with("[\"box\"]", "[\"box\", \"cube\"]"), "shapes[1]", "sphere"},
      {with("\"cast\"", "\"sweep\""), "queries.sweep", "rotating_cast"},
      {with("{\"cast\": {\"answers\": []}}", "{}"), "queries", "one or more"},
      {with("{\"cast\": {\"answers\": []}}", "[\"cast\"]"), "queries", "object"},
      {with("{\"answers\": []}", "{}"), "queries.cast.answers", "array"},
      {with("[]", "[\"toi\"]"), "queries.cast.answers[0]", "time"},
      {with("\"cast\": {\"answers\": []}", "\"distance\": {\"answers\": [\"normal\"]}"),
       "queries.distance.answers", "distance"},
      {with("\"cast\": {\"answers\": []}", "\"penetration\": {\"answers\": []}"),
       "queries.penetration.answers", "depth"},
      {and_of_the_cast("\"tolerance\": -1"), "queries.cast.tolerance", ""},
      {and_of_the_cast("\"tolerance\": \"small\""), "queries.cast.tolerance", "decimal"},
      {and_of_the_cast("\"kappa\": \"inf\""), "queries.cast.kappa", "decimal"},
      {and_of_the_cast("\"touching\": \"maybe\""), "queries.cast.touching", "either"},
      {and_of_the_cast("\"starts\": 1"), "queries.cast.starts", "true or false"},
      {and_of_the_cast("\"stalls\": 1.5"), "queries.cast.stalls", "fraction"},
      {and_of_the_cast("\"accuracy\": 1"), "queries.cast", "tolerance"},
      {and_with("\"margin\": -0.5"), "margin", ""},
      {and_with("\"lengths\": [1]"), "lengths", "[least, most]"},
      {and_with("\"lengths\": [1, 1.5]"), "lengths", "least <= most / 2"},
      {and_with("\"lengths\": [0, 1]"), "lengths", "0 < least"},
      {and_with("\"motion\": \"absolute\""), "motion", "relative"},
      {and_with("\"most_vertices\": 1.5"), "most_vertices", ""},
      {and_with("\"timed\": \"yes\""), "timed", "true or false"},
      {and_with("\"colour\": 1"), "colour", "margin"},
  };
  for (const Bad& bad : all) {
    try {
      (void)parse_declaration(bad.line);
      ADD_FAILURE() << "taken: " << bad.line;
    } catch (const std::runtime_error& error) {
      const std::string line = error.what();
      EXPECT_NE(line.find(bad.field), std::string::npos) << bad.line << "\n" << line;
      EXPECT_NE(line.find(bad.right), std::string::npos) << bad.line << "\n" << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      EXPECT_LT(line.size(), 400U) << line;
    }
  }
}

}  // namespace
}  // namespace graze::external
