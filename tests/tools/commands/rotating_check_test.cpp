// graze check on the proofs of rotating casts that graze cast writes, of a crossing too, and on what was made
// of them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "corpus/format/case_io.hpp"
#include "run_command.hpp"
#include "tests/shared/rotating_cases.hpp"

namespace graze {
namespace {

using Json = nlohmann::json;
using test::CommandRun;
using test::Folder;

// Two rods that turn, one about z and one about x, and pass each other: contact by crossing alone.
corpus::Case rod_past_a_rod() {
  corpus::Case problem;
  problem.id = "test/rod-past-a-rod";
  problem.a.shape = Segment<double>{{-1, 0.25, 0}, {1, -0.125, 0}};
  problem.spin_a.rotation = {0.25, 0, 0};
  problem.b.shape = Segment<double>{{0.25, -1, 0}, {0, 1.5, 0.125}};
  problem.b.position = {0, 0, 1};
  problem.b.displacement = {0, 0, -2};
  problem.spin_b.rotation = {0, 0, 1};
  return problem;
}

TEST(CheckRotating, AcceptsEveryMethodsProofAndRefusesWhatWasMadeOfOne) {
  const Folder folder;
  folder.write("rod.json", corpus::write_case(rod_past_a_rod()));
  folder.write("bar.json", corpus::write_case(test::turning_bar()));
  folder.write("above.json", corpus::write_case(test::turning_bar_above()));
  for (const std::string method : {"ca", "bilateral", "certified"}) {
    for (const std::string scalar : {"double", "float"}) {
      ASSERT_EQ(folder
                    .graze("cast rod.json bar.json above.json --proofs proofs.jsonl --method " + method +
                           " --scalar " + scalar)
                    .exit_code,
                0);
      const CommandRun check = folder.graze("check proofs.jsonl");
      EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
      EXPECT_EQ(check.out, "3 accepted, 0 refused\n") << method << "/" << scalar;
    }
  }
}

TEST(CheckRotating, NamesTheCaseAndTheClaimThatItRefuses) {
  const Folder folder;
  folder.write("rod.json", corpus::write_case(rod_past_a_rod()));
  ASSERT_EQ(folder.graze("cast rod.json --method bilateral --proofs proofs.jsonl").exit_code, 0);
  const Json sound = Json::parse(folder.read("proofs.jsonl"));
  ASSERT_TRUE(sound["proof"].contains("contact_from")) << sound["proof"].dump();
  // A time that ends where the crossing begins, and one that begins where it ends.
  Json first = sound, second = sound, without = sound;
  const double from = sound["proof"]["contact_from"], to = sound["proof"]["toi_upper"];
  first["proof"]["contact_from"] = from / 2;
  first["proof"]["toi_upper"] = from;
  second["proof"]["contact_from"] = to;
  second["proof"]["toi_upper"] = to + (1 - to) / 16;
  without["proof"].erase("contact_from");
  folder.write("first.jsonl", first.dump() + "\n");
  folder.write("second.jsonl", second.dump() + "\n");
  folder.write("without.jsonl", without.dump() + "\n");
  const CommandRun check = folder.graze("check proofs.jsonl first.jsonl second.jsonl");
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_NE(check.out.find("test/rod-past-a-rod"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("crossing_not_proved"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("1 accepted, 2 refused"), std::string::npos) << check.out;
  const CommandRun unread = folder.graze("check without.jsonl");
  EXPECT_EQ(unread.exit_code, 2) << unread.out;
  EXPECT_NE(unread.err.find("proof.contact[0].weight"), std::string::npos) << unread.err;
}

}  // namespace
}  // namespace graze
