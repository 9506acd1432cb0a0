// The command graze on cases of every query: ids, tolerances, and what certify judges of a file.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"
#include "engines/method.hpp"
#include "run_command.hpp"

namespace graze {
namespace {

using Json = nlohmann::json;
using test::CommandRun;
using test::Folder;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void expect_one_complaint(const CommandRun& run, const std::vector<std::string>& parts) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(lines_of(run.err).size(), 1U) << run.err;
  EXPECT_TRUE(run.err.starts_with("graze: ")) << run.err;
  for (const std::string& part : parts)
    EXPECT_NE(run.err.find(part), std::string::npos) << part << "\n" << run.err;
}

// Cubes of side 2, the second at x along the axis, which moves back by 4 in one unit of time.
std::string cubes(const std::string& id, double x, const std::string& more = "",
                  const std::string& shape = R"({"type": "box", "half_extents": [1, 1, 1]})") {
  return R"({"schema": "graze.case/1", "id": ")" + id + R"(", "a": {"shape": )" + shape +
         R"(}, "b": {"shape": {"type": "box", "half_extents": [1, 1, 1]}, "position": [)" +
         std::to_string(x) + R"(, 0.3, 0.7], "displacement": [-4, 0, 0]})" + more + "}\n";
}
constexpr const char* kBall = R"({"type": "ellipsoid", "radii": [1, 2, 3]})";

TEST(Ids, TheSameInTwoFilesIsOneComplaintThatNamesBoth) {
  const Folder folder;
  folder.write("a.json", cubes("test/one", 3));
  folder.write("b.jsonl", "\n" + cubes("test/other", 3) + cubes("test/one", 4));
  for (const std::string line :
       {"cast --json a.json b.jsonl", "certify a.json b.jsonl --method exact --queries 0",
        "laws --law swapping a.json b.jsonl", "draw a.json b.jsonl --out pictures",
        "corpus validate a.json b.jsonl", "corpus format a.json b.jsonl", "corpus fill a.json b.jsonl"}) {
    SCOPED_TRACE(line);
    expect_one_complaint(folder.graze(line), {"b.jsonl:3: id: \"test/one\"", "a.json"});
  }
  const std::vector<std::string> answers = lines_of(folder.graze("cast --json a.json b.jsonl").out);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(Json::parse(answers[0])["id"], "test/one");
  EXPECT_EQ(Json::parse(answers[1])["id"], "test/other");
  EXPECT_EQ(folder.read("b.jsonl"), "\n" + cubes("test/other", 3) + cubes("test/one", 4));
}

TEST(Ids, TheSameTwiceInOneFileOrInAFileGivenTwiceNamesTheLines) {
  const Folder folder;
  folder.write("a.jsonl", cubes("test/one", 3) + cubes("test/one", 4));
  expect_one_complaint(folder.graze("cast a.jsonl"), {"a.jsonl:2: id:", "a.jsonl:1;"});
  folder.write("b.jsonl", cubes("test/two", 3));
  expect_one_complaint(folder.graze("cast b.jsonl ./b.jsonl"), {"./b.jsonl:1: id:", "b.jsonl:1;"});
  expect_one_complaint(folder.graze("cast b.jsonl -", cubes("test/two", 4)),
                       {"standard input:1: id:", "b.jsonl:1;"});
}

TEST(Tolerance, ReachesEverySearchAndWidensItsBracket) {
  const Folder folder;
  // Rounded, so that the portal is refined: Newton's method on a bare ellipsoid ends within any tolerance.
  const std::string rounded = R"({"type": "rounded", "radius": 0.25, "shape": )" + std::string(kBall) + "}";
  folder.write("linear.json", cubes("test/linear", 4, "", rounded));
  folder.write("turning.json",
               R"({"schema": "graze.case/1", "id": "test/turning", "a": {"shape": )" + std::string(kBall) +
                   R"(, "rotation": [0, 0, 1]}, "b": {"shape": {"type": "box", "half_extents": [1, 1, 1]},
 "position": [4, 0.3, 0.7], "displacement": [-4, 0, 0]}})");
  for (const std::string query : {"distance", "line", "penetration_along"}) {
    std::string more = ", \"query\": \"" + query + "\"";
    if (query == "penetration_along") more += ", \"direction\": [1, 0.5, 0.25]";
    folder.write(query + ".json",
                 cubes("test/" + query, query.starts_with("penetration") ? 1.5 : 4, more, kBall));
  }
  // A hull, as the depth of two smooth bodies is mostly a proof, which a tolerance makes no shorter.
  folder.write("penetration.json",
               R"({"schema": "graze.case/1", "id": "test/penetration", "query": "penetration",
 "a": {"shape": {"type": "hull", "vertices": [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]}},
 "b": {"shape": )" +
                   std::string(kBall) + R"(, "position": [1.5, 0.3, 0.2]}})");
  const auto width = [&](const std::string& line, const std::string& field) {
    const CommandRun run = folder.graze("cast --json " + line);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const Json bracket = Json::parse(run.out).at(field);
    return bracket.at("upper").get<double>() - bracket.at("lower").get<double>();
  };
  const std::pair<std::string, std::string> kSearches[] = {
      {"linear.json", "toi"},        {"linear.json --method mpr", "toi"},
      {"turning.json", "toi"},       {"turning.json --method ca", "toi"},
      {"distance.json", "distance"}, {"line.json", "t_in"},
      {"penetration.json", "depth"}, {"penetration_along.json", "depth"}};
  for (const auto& [line, field] : kSearches) {
    SCOPED_TRACE(line);
    const double fine = width(line, field), same = width(line + " --tolerance 0", field),
                 coarse = width(line + " --tolerance 0.05", field);
    EXPECT_EQ(fine, same);
    EXPECT_LT(fine, 1e-8);
    EXPECT_GT(coarse, 1e-6);
  }
}

TEST(Tolerance, ThatIsNoneIsRefused) {
  const Folder folder;
  folder.write("x.json", cubes("test/x", 4, "", kBall));
  for (const std::string value : {"-1e-9", "nan", "inf", "-inf", "1e999", "few", "''"}) {
    SCOPED_TRACE(value);
    expect_one_complaint(folder.graze("cast x.json --tolerance=" + value), {"--tolerance"});
  }
  // In float it is infinite, which the core refuses.
  const CommandRun run = folder.graze("cast x.json --scalar float --tolerance 1e300");
  expect_one_complaint(run, {"test/x", "tolerance"});
}

std::string rows_with(double kappa) {
  Json rows = Json::array();
  for (const engine::Method& method : engine::methods(engine::Kind::query)) {
    rows.push_back({{"query", corpus::name_of(method.query)},
                    {"method", method.name},
                    {"scalar", method.scalar},
                    {"tier", method.tier},
                    {"kappa_polytope", kappa},
                    {"kappa_rounded", kappa},
                    {"stall_cap", 1},
                    {"mechanism", "a test"}});
  }
  return Json{{"schema", "graze.guarantees/1"}, {"rows", rows}}.dump();
}

TEST(CertifyQueries, ACaseOfAnyQueryIsJudged) {
  const std::string kBox = R"({"type": "box", "half_extents": [1, 1, 1]})";
  for (const std::string query :
       {"line", "overlap", "distance", "penetration", "penetration_along", "swept_overlap"}) {
    for (const std::string& shape : {kBox, std::string(kBall)}) {
      SCOPED_TRACE(query + " " + shape);
      const Folder folder;
      std::string more = ", \"query\": \"" + query + "\"";
      if (query == "penetration_along") more += ", \"direction\": [1, 0.5, 0.25]";
      folder.write("x.json", cubes("test/x", query.starts_with("penetration") ? 1.5 : 4, more, shape));
      const CommandRun run = folder.graze("certify x.json --queries 0 --full");
      EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
      EXPECT_EQ(run.err, "");
      EXPECT_NE(run.out.find("1 question beside the cast is judged"), std::string::npos) << run.out;
      std::size_t judged = 0;
      for (const std::string& line : lines_of(run.out)) {
        std::istringstream words(line);
        std::string asked, method, cases;
        words >> asked >> method >> cases;
        if (asked == query && method.find('/') != std::string::npos) judged += std::stoul(cases);
      }
      EXPECT_GE(judged, 2U) << run.out;
    }
  }
}

TEST(CertifyQueries, ABrokenRowOfAQueryAloneIsExitCode1AndItsCaseIsSaved) {
  const Folder folder;
  folder.write("strict.json", rows_with(0));
  // Rotated, so that no arithmetic in doubles is exact.
  std::string turned = cubes("test/deep", 1.5, R"(, "query": "penetration")");
  turned.insert(turned.find("\"displacement\""), "\"orientation\": [0.9, 0.1, 0.3, -0.2], ");
  folder.write("deep.json", turned);
  const CommandRun run =
      folder.graze("certify deep.json --queries 0 --guarantees strict.json --save saved.jsonl");
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  EXPECT_NE(run.out.find(" by penetration epa/"), std::string::npos) << run.out;
  const corpus::ReadResult saved = corpus::read_text(folder.read("saved.jsonl"), "saved.jsonl", true);
  ASSERT_TRUE(saved.ok()) << saved.errors.at(0).text();
  ASSERT_EQ(saved.cases.size(), 1U);
  EXPECT_EQ(saved.cases[0].query, corpus::Query::penetration);
}

TEST(CertifyQueries, WhatIsNotJudgedIsSaidAndHidesNoExitCode) {
  const Folder folder;
  folder.write("strict.json", rows_with(0));
  std::string unasked = cubes("test/turning-line", 4, R"(, "query": "line")");
  unasked.insert(unasked.find("\"displacement\""), "\"rotation\": [0, 0, 1], ");
  folder.write("unasked.json", unasked);
  folder.write("bad.json", "{");
  std::string turned = cubes("test/deep", 1.5, R"(, "query": "penetration")");
  turned.insert(turned.find("\"displacement\""), "\"orientation\": [0.9, 0.1, 0.3, -0.2], ");
  folder.write("deep.json", turned);

  const CommandRun kept = folder.graze("certify unasked.json deep.json --queries 0");
  EXPECT_EQ(kept.exit_code, 0) << kept.out << kept.err;
  EXPECT_NE(kept.err.find("test/turning-line"), std::string::npos) << kept.err;
  EXPECT_NE(kept.out.find("1 case is not judged"), std::string::npos) << kept.out;
  const CommandRun broken =
      folder.graze("certify unasked.json deep.json --queries 0 --guarantees strict.json");
  EXPECT_EQ(broken.exit_code, 1) << broken.out << broken.err;
  EXPECT_NE(broken.err.find("test/turning-line"), std::string::npos) << broken.err;
  const CommandRun bad =
      folder.graze("certify unasked.json bad.json deep.json --queries 0 --guarantees strict.json");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_NE(bad.out.find(" by penetration epa/"), std::string::npos) << bad.out;
  // Nothing at all is judged.
  EXPECT_EQ(folder.graze("certify unasked.json --queries 0").exit_code, 2);
  // Nor is a cast for which the command line leaves no method.
  folder.write("cast.json", cubes("test/cast", 4));
  const CommandRun left =
      folder.graze("certify cast.json deep.json --queries 0 --method bilateral --method epa");
  EXPECT_EQ(left.exit_code, 0) << left.out << left.err;
  EXPECT_NE(left.err.find("cast.json"), std::string::npos) << left.err;
}

TEST(CertifyQueries, WhatIsAskedOfBodiesThatTurnIsAskedAtRest) {
  const Folder folder;
  std::string turning = cubes("test/turning", 4, R"(, "query": "distance")");
  turning.insert(turning.find("\"displacement\""), "\"rotation\": [0, 0, 1], ");
  folder.write("turning.json", turning);
  folder.write("still.json", cubes("test/still", 4, R"(, "query": "distance")"));
  const CommandRun cast = folder.graze("cast --json turning.json still.json");
  ASSERT_EQ(cast.exit_code, 0) << cast.err;
  const std::vector<std::string> lines = lines_of(cast.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(Json::parse(lines[0])["distance"], Json::parse(lines[1])["distance"]);
  const CommandRun certified = folder.graze("certify turning.json --queries 0");
  EXPECT_EQ(certified.exit_code, 0) << certified.out << certified.err;
  EXPECT_NE(certified.out.find("1 question beside the cast is judged"), std::string::npos);
}

}  // namespace
}  // namespace graze
