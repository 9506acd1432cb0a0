// graze campaign and graze merge as they are used: threads, shards, signals, job files, bad input.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

// 600 casts in 19 blocks.
const std::string kSmall =
    "campaign --casts 600 --block 32 --family touching --family grazing_edge --family hulls ";

class CampaignCommand : public testing::Test {
 protected:
  // Runs `command` in a shell, in the folder, with GRAZE the command. Returns its exit code.
  [[nodiscard]] int shell(const std::string& command) const {
    folder.write("script", "cd \"$(dirname \"$0\")\"; export GRAZE='" GRAZE_COMMAND "'\n" + command);
    const int status = std::system(("bash '" + folder.path().string() + "/script' >/dev/null 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  void expect_one_complaint(const std::string& arguments, const std::string& part) const {
    const CommandRun run = folder.graze(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_TRUE(run.err.starts_with("graze: ")) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }

  const Folder folder;
};

TEST_F(CampaignCommand, StdoutAndJsonDoNotDependOnThreadsAndTimeGoesToStderr) {
  const CommandRun one = folder.graze(kSmall + "--threads 1 --json one.json");
  const CommandRun four = folder.graze(kSmall + "--threads 4 --json four.json");
  EXPECT_EQ(one.exit_code, 0) << one.out << one.err;
  EXPECT_EQ(one.out, four.out);
  EXPECT_EQ(folder.read("one.json"), folder.read("four.json"));
  EXPECT_NE(one.out.find("Campaign: 600 casts by exact/double, seed 1"), std::string::npos) << one.out;
  EXPECT_NE(one.out.find("None of 600 failed"), std::string::npos) << one.out;
  EXPECT_EQ(one.out.find(" s: "), std::string::npos) << one.out;
  EXPECT_NE(one.err.find("a second on 1 thread;"), std::string::npos) << one.err;
}

TEST_F(CampaignCommand, MergedShardsPrintWhatOnePiecePrints) {
  const CommandRun whole = folder.graze(kSmall + "--json whole.json");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  for (const std::string i : {"1", "2", "3"}) {
    const CommandRun part = folder.graze(kSmall + "--shard " + i + "/3 --state part" + i + ".json");
    EXPECT_EQ(part.exit_code, 0);
    EXPECT_NE(part.out.find("Shard " + i + "/3: " + (i == "3" ? "7" : "6") + " of 19 blocks"),
              std::string::npos)
        << part.out;
  }
  const CommandRun merged = folder.graze("merge part3.json part1.json part2.json --json merged.json");
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(merged.out, whole.out);
  EXPECT_EQ(folder.read("merged.json"), folder.read("whole.json"));

  expect_one_complaint("merge part1.json part2.json", "7 of 19 blocks are in no file");
  expect_one_complaint("merge part1.json part2.json part3.json part2.json", "both hold block 6");
  const CommandRun partial = folder.graze("merge --partial part1.json part3.json --json joined.json");
  EXPECT_EQ(partial.exit_code, 0) << partial.err;
  EXPECT_EQ(folder.graze(kSmall + "--state joined.json").out, whole.out);
  EXPECT_EQ(folder.read("joined.json"), folder.read("whole.json"));
}

TEST_F(CampaignCommand, OtherMethodsQueriesAndTurningBodiesArePartsOfOneCampaign) {
  const std::string command =
      "campaign --casts 60 --queries 1 --rotating 12 --methods standard --family hulls --family slow_spin "
      "--block 20 ";
  const CommandRun whole = folder.graze(command + "--levels --json whole.json");
  EXPECT_EQ(whole.exit_code, 0) << whole.out << whole.err;
  for (const char* part :
       {"Campaign: 60 casts by ca/double, gjk/double, mpr/double, ca/float, gjk/float, mpr/float, seed 1",
        "\nswept_overlap mpr/float\n", "\nrotating plan/double\n", "  h8"}) {
    EXPECT_NE(whole.out.find(part), std::string::npos) << part << "\n" << whole.out;
  }
  for (const std::string i : {"1", "2"})
    EXPECT_EQ(folder.graze(command + "--shard " + i + "/2 --state part" + i + ".json").exit_code, 0);
  EXPECT_EQ(folder.graze("merge --levels part2.json part1.json --json merged.json").out, whole.out);
  EXPECT_EQ(folder.read("merged.json"), folder.read("whole.json"));
}

TEST_F(CampaignCommand, SignalsStopItAndTheSameCommandGoesOn) {
  // Ended by signals again and again until it is done. Exit code 143 says that it kept its results.
  const std::string command = "campaign --casts 600 --block 4 --family many_vertices ";
  const CommandRun whole = folder.graze(command + "--json whole.json");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const int ended = shell(R"(
    for delay in 0.3 0.5 1 2 4 8 16 32; do
      timeout -s TERM $delay "$GRAZE" )" +
                          command + R"(--threads 1 --state kept.json >out.txt 2>err.txt
      code=$?
      [[ $code == 124 || $code == 143 ]] || exit $code
      grep -q 'the same command continues from kept.json' err.txt || [[ ! -s err.txt ]] || exit 99
    done
    exit 98)");
  EXPECT_EQ(ended, 0);
  EXPECT_EQ(folder.read("out.txt"), whole.out);
  EXPECT_EQ(folder.read("kept.json"), folder.read("whole.json"));
}

// timeout(1) sends its signal to the program and to its group: the program gets it twice.
TEST_F(CampaignCommand, TwoSignalsAtOnceAreOneRequest) {
  for (const std::string signal : {"INT", "TERM"}) {
    SCOPED_TRACE(signal);
    const int ended = shell(
        "\"$GRAZE\" campaign --casts 100000000 --block 4 --family many_vertices --state " + signal +
        ".json >out.txt 2>err.txt &\nsleep 1\nkill -" + signal + " $!\nkill -" + signal + " $!\nwait $!");
    EXPECT_EQ(ended, signal == "INT" ? 130 : 143);
    const std::string err = folder.read("err.txt");
    EXPECT_EQ(err.find("graze: stopping; what is being judged is finished first. Once more ends at once.\n"),
              0U)
        << err;
    EXPECT_NE(err.find("the same command continues from " + signal + ".json"), std::string::npos) << err;
    EXPECT_NE(folder.read(signal + ".json").find("graze.campaign/2"), std::string::npos);
  }
}

TEST_F(CampaignCommand, TheSlurmJobCastsItsShardAndGoesOn) {
  const CommandRun whole = folder.graze(kSmall);
  const std::string job = "'" GRAZE_SOURCE_DIR "/tools/cluster/campaign.slurm' ";
  const std::string options = kSmall.substr(kSmall.find(' '));
  EXPECT_EQ(shell("export SLURM_ARRAY_TASK_COUNT=3 SLURM_CPUS_PER_TASK=2\nfor i in 1 2 3; do\n"
                  "SLURM_ARRAY_TASK_ID=$i bash " +
                  job + options + " || exit\ndone"),
            0);
  EXPECT_EQ(folder.graze("merge part1.json part2.json part3.json").out, whole.out);
  EXPECT_EQ(folder.read("failures2.jsonl"), "");
  // The same task again, which has nothing left to do, and a task of another share, which is refused.
  EXPECT_EQ(shell("SLURM_ARRAY_TASK_ID=2 GRAZE_SHARDS=3 bash " + job + options), 0);
  EXPECT_EQ(shell("SLURM_ARRAY_TASK_ID=2 GRAZE_SHARDS=4 bash " + job + options), 2);
  EXPECT_EQ(shell("bash " + job + options), 2);
}

TEST_F(CampaignCommand, BadInputIsNamedInOneLine) {
  expect_one_complaint("campaign --casts 0", "--casts");
  expect_one_complaint("campaign --casts 10 --block 0", "--block");
  expect_one_complaint("campaign --casts -5", "--casts");
  expect_one_complaint("campaign --casts 1e30", "--casts");
  expect_one_complaint("campaign --threads -1", "--threads");
  expect_one_complaint("campaign --family grazzing", "grazzing is no family");
  expect_one_complaint("campaign --family fast_spin", "rotate");
  expect_one_complaint("campaign --rotating 8 --family hulls", "no body of hulls rotates");
  expect_one_complaint("campaign --rotating 8 --method mpr", "mpr is no method for casts of rotating bodies");
  expect_one_complaint("campaign --queries 8 --method plan", "plan is no method for queries");
  expect_one_complaint("campaign --queries 0", "--queries");
  expect_one_complaint("campaign --casts 5 --per-family 5", "give one");
  expect_one_complaint("campaign --rotating 5 --rotating-per-family 5", "give one");
  expect_one_complaint("campaign --family rods_and_round", "exact/double");
  expect_one_complaint("campaign --method epa", "epa is no method");
  for (const std::string shard : {"0/3", "4/3", "1", "1/", "a/b", "1/3x", "/3"})
    expect_one_complaint("campaign --shard " + shard, "--shard: " + shard);
  expect_one_complaint("campaign --casts 10 --state no/such/folder.json", "no/such/folder.json");
  expect_one_complaint("campaign --casts 10 --save no/such/folder.jsonl", "no/such/folder.jsonl");
  expect_one_complaint("merge", "parts");
  expect_one_complaint("merge absent.json", "absent.json: cannot be read");
  folder.write("odd.json", "{\"schema\": 1}");
  expect_one_complaint("merge odd.json", "odd.json: is no state of a campaign");

  ASSERT_EQ(folder.graze(kSmall + "--state kept.json").exit_code, 0);
  const std::string kept = folder.read("kept.json");
  expect_one_complaint(kSmall + "--state kept.json --seed 2", "the seed is 2 here and 1 there");
  expect_one_complaint(kSmall + "--state kept.json --method exact/float", "the list of methods");
  expect_one_complaint(kSmall + "--state kept.json --shard 1/2", "the shard is 1/2 here and 1/1 there");
  expect_one_complaint(kSmall + "--state odd.json", "odd.json");
  expect_one_complaint("campaign --rotating 8 --state kept.json", "kept.json belongs to another campaign");
  folder.write("older.json", "{\"schema\": \"graze.campaign/1\"}");
  expect_one_complaint("merge older.json", "schema is \"graze.campaign/1\", not \"graze.campaign/2\"");
  EXPECT_EQ(folder.read("kept.json"), kept);
}

}  // namespace
}  // namespace graze
