// Scenes as files: what is read is what was written, errors name the file and the field, and the law holds of
// the examples.
#include <gtest/gtest.h>

#include <filesystem>

#include "corpus/format/case_json.hpp"
#include "properties/scenes/generate.hpp"
#include "properties/scenes/law.hpp"
#include "scene/format/report_json.hpp"

namespace graze::scene {
namespace {

std::vector<std::string> example_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(GRAZE_SOURCE_DIR "/examples/scenes")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(SceneFiles, ReadBackAsTheyWereWritten) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const law::RandomScene drawn = law::random_scene(seed);
    Document document{"drawn", "from a seed", drawn.scene, drawn.options};
    const std::string text = write_scene(document);
    const ReadResult read = read_scene_text(text, "file");
    ASSERT_TRUE(read.document) << read.errors[0].text() << "\n" << text;
    EXPECT_EQ(write_scene(*read.document), text);
    EXPECT_EQ(read.document->scene.bodies.size(), drawn.scene.bodies.size());
    EXPECT_EQ(read.document->scene.probes.size(), drawn.scene.probes.size());
  }
}

struct Bad {
  const char* text;
  const char* said;
};

TEST(SceneFiles, ErrorsNameTheFileAndTheField) {
  const std::string head = R"({"schema": "graze.scene/1", "id": "s", )";
  const std::string ball = R"("shape": {"type": "sphere", "radius": 1})";
  const Bad cases[] = {
      {R"("bodies": [{"name": "a", BALL}, {"name": "a", BALL}]})",
       "f: bodies[1].name: \"a\" is named by bodies[0].name already"},
      {R"("bodies": [{"name": "a", "shape": "cube"}]})",
       "f: bodies[0].shape: unknown shape \"cube\"; shapes names none"},
      {R"("shapes": [{"name": "ball", BALL}], "bodies": [{"name": "a", "shape": "cube"}]})",
       "shapes names \"ball\""},
      {R"("bodies": [{"name": "a", BALL, "position": [0, 1]}]})", "f: bodies[0].position: an array of 2"},
      {R"("bodies": [{"name": "a", BALL, "position": [0, 1, "nan"]}]})", "f: bodies[0].position[2]: "},
      {R"("bodies": [{"name": "", BALL}]})", "f: bodies[0].name: an empty name"},
      {R"("bodies": [{"name": "a", BALL, "speed": 1}]})", "f: bodies[0]: unknown field \"speed\""},
      {R"("bodies": [{"name": "a", BALL, "mask": -1}]})", "f: bodies[0].mask: the number -1; 32 bits"},
      {R"("rays": [{"name": "r", "origin": [0, 0, 0]}]})", "f: rays[0].displacement: missing"},
      {R"("casts": [{"name": "r", BALL, "rotation": [0, 0, 1], "t_max": "inf"}]})",
       "f: cast \"r\": t_max is infinite, and it rotates"},
      {R"("t_max": "inf"})", "f: t_max: infinite; a step has an end"},
      {R"("ask": "everything"})", "f: ask: the string \"everything\"; one of verdict, first, body or pair"},
      {R"("request": ["speed"]})", "f: request[0]: "},
      {R"("tier": "exact", "bodies": [{"name": "a", "shape": {"type": "cone", "radius": 1, "half_height": 1}}]})",
       "f: body \"a\": shape is curved"},
      {R"("bodies": {}})", "f: bodies: an object; an array of objects"},
      {R"("bodies": [)", "f: "},
  };
  for (const Bad& one : cases) {
    std::string text = head + one.text;
    for (std::size_t at = text.find("BALL"); at != std::string::npos; at = text.find("BALL"))
      text.replace(at, 4, ball);
    const ReadResult read = read_scene_text(text, "f");
    EXPECT_FALSE(read.document) << text;
    ASSERT_EQ(read.errors.size(), 1u) << text;
    EXPECT_NE(read.errors[0].text().find(one.said), std::string::npos) << read.errors[0].text();
  }
  const ReadResult none = read_scene_file("/no/such/scene.json");
  ASSERT_EQ(none.errors.size(), 1u);
  EXPECT_EQ(none.errors[0].text().find("/no/such/scene.json: "), 0u);
}

TEST(SceneFiles, TheLawHoldsOfTheExamples) {
  const std::vector<std::string> files = example_files();
  ASSERT_GE(files.size(), 7u);
  law::SceneTally tally;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const ReadResult read = read_scene_file(files[k]);
    ASSERT_TRUE(read.document) << read.errors[0].text();
    EXPECT_EQ(law::scene_law(read.document->scene, read.document->options, tally), "") << files[k];
    const Report report = run(read.document->scene, read.document->options);
    EXPECT_GT(report.events.size(), 0u) << files[k];
    const std::string json = write_report(*read.document, report);
    EXPECT_FALSE(corpus::parse_json(json).error) << files[k];
  }
  EXPECT_GT(tally.contacts, 1000u);
}

}  // namespace
}  // namespace graze::scene
