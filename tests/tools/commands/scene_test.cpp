// graze scene, as a user runs it.
#include <gtest/gtest.h>

#include "run_command.hpp"

namespace graze {
namespace {

using test::CommandRun;
using test::Folder;

const std::string kScene =
    R"({"schema": "graze.scene/1", "id": "two", "bodies": [)"
    R"({"name": "wall", "shape": {"type": "box", "half_extents": [1, 5, 5]}}, )"
    R"({"name": "aside", "shape": {"type": "sphere", "radius": 1}, "position": [0, 90, 0]}, )"
    R"({"name": "crate", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "position": [6, 0, 0], )"
    R"("displacement": [-8, 0, 0], "rotation": [0, 0, 1]}], )"
    R"("rays": [{"name": "sight", "origin": [-9, 0, 0], "displacement": [1, 0, 0]}]})";

TEST(SceneCommand, TellsEventsInTheOrderOfTimeAndWhatWasSimulated) {
  const Folder folder;
  const CommandRun run = folder.graze("scene - --threads 1", kScene);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* part : {"two: standard, 1 event\n", "wall - crate", "[rotating]", "sight - wall",
                           "1 simulated: rotating", "1 nothing: at rest, and their bounds are apart"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
  }
  const CommandRun plan = folder.graze("scene - --plan", kScene);
  EXPECT_NE(plan.out.find("wall - crate: rotating, not before t = 0."), std::string::npos) << plan.out;
  EXPECT_EQ(plan.out.find("sight"), std::string::npos);
}

TEST(SceneCommand, WritesTheSameJsonInAnyNumberOfThreadsAndWithAnyEconomiesTheSameEvents) {
  const Folder folder;
  const CommandRun one = folder.graze("scene - --json --threads 1", kScene);
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(folder.graze("scene - --json --threads 5", kScene).out, one.out);
  const auto events = [](const std::string& json) {
    const std::size_t at = json.find("\"events\": ");
    return json.substr(at, json.find("\"distance\"", at) - at);
  };
  EXPECT_NE(events(one.out).find("\"b\": \"crate\", \"outcome\": \"hit\""), std::string::npos) << one.out;
  const CommandRun none = folder.graze("scene - --json --economy none", kScene);
  EXPECT_EQ(events(none.out), events(one.out));
  EXPECT_NE(none.out.find("\"apart\": 0"), std::string::npos) << none.out;
  EXPECT_NE(folder.graze("scene - --json --without rest", kScene).out.find("\"apart\": 0"),
            std::string::npos);
}

TEST(SceneCommand, WritesProofsThatAreAccepted) {
  const Folder folder;
  EXPECT_EQ(folder.graze("scene - --tier certified --proof proofs.jsonl", kScene).exit_code, 0);
  const CommandRun checked = folder.graze("check proofs.jsonl");
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
  EXPECT_NE(checked.out.find("2 accepted"), std::string::npos) << checked.out;
}

TEST(SceneCommand, RefusesInOneLine) {
  const Folder folder;
  folder.write("bad.json",
               R"({"schema": "graze.scene/1", "id": "x", "bodies": [{"name": "a", "shape": "cube"}]})");
  folder.write("case.json", R"({"schema": "graze.case/1", "id": "x", "a": {}, "b": {}})");
  folder.write("scene.json", R"({"schema": "graze.scene/1", "id": "x", "ask": "first", "bodies": []})");
  folder.write("proofs.jsonl", "{\"schema\": \"graze.proof/1\"}\n{\"schema\": \"graze.proof/1\"}\n");
  const std::pair<const char*, const char*> cases[] = {
      {"scene bad.json", "bad.json: bodies[0].shape: unknown shape \"cube\""},
      {"scene none.json", "none.json: cannot be opened: No such file or directory; "},
      {"scene case.json", "case.json: holds a case (graze.case/1); graze cast answers it\n"},
      {"cast scene.json", "scene.json: holds a scene (graze.scene/1); graze scene answers it\n"},
      {"cast proofs.jsonl", "proofs.jsonl: holds a proof (graze.proof/1); graze check checks it\n"},
      {"scene - --economy thrift", "--economy: thrift is no economy; it is one of rest, bounds"},
      {"scene - --without thrift", "--without: thrift is no economy"},
      {"scene - --tier best", "--tier: best is not a value; it is standard, certified or exact"},
      {"scene - --ask all", "--ask: all is not a value; it is verdict, first, body or pair"},
      {"scene - --plan --gains", "--plan: nothing is cast"},
      {"scene - --threads 0", "--threads"},
      {"scene - --tier exact", "body \"crate\": rotates, which the exact tier does not support"},
  };
  for (const auto& [arguments, said] : cases) {
    const CommandRun run = folder.graze(arguments, kScene);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
    EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
  }
  const std::string still = R"({"name": "B", "shape": {"type": "point"}, "displacement": [1, 0, 0]})";
  std::string crowd = R"({"schema": "graze.scene/1", "id": "spot", "bodies": [)";
  for (char name = 'a'; name <= 'f'; ++name) {
    std::string one = still;
    crowd += (name == 'a' ? "" : ", ") + one.replace(one.find('B'), 1, 1, name);
  }
  const CommandRun spot = folder.graze("scene - --most-pairs 14", crowd + "]}");
  EXPECT_EQ(spot.exit_code, 2);
  EXPECT_NE(spot.err.find("more than 14 pairs of bodies may meet"), std::string::npos) << spot.err;
  EXPECT_EQ(folder.graze("scene - --most-pairs 15", crowd + "]}").exit_code, 0);
}

}  // namespace
}  // namespace graze
