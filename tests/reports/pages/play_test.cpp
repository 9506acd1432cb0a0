#include "reports/pages/play.hpp"

#include <gtest/gtest.h>

namespace graze {
namespace {

using show::PlaySettings;
using Json = nlohmann::ordered_json;

constexpr std::string_view kThree = R"({"schema": "graze.scene/1", "id": "three", "ask": "pair",
 "shapes": [{"name": "ball", "shape": {"type": "sphere", "radius": 1}}],
 "bodies": [{"name": "far", "shape": "ball", "position": [0, 50, 0]},
            {"name": "left", "shape": "ball", "position": [-4, 0, 0], "displacement": [4, 0, 0]},
            {"name": "right", "shape": "ball", "position": [4, 0, 0], "displacement": [-4, 0, 0]},
            {"name": "wall", "shape": {"type": "box", "half_extents": [1, 9, 9]}, "position": [-9, 0, 0]}],
 "rays": [{"name": "sight", "origin": [-9, 50, 0], "displacement": [1, 0, 0]}]})";

Json played(const PlaySettings& settings) {
  const scene::ReadResult read = scene::read_scene_text(kThree, "three");
  EXPECT_TRUE(read.document);
  return show::play_of(*read.document, scene::run(read.document->scene, read.document->options), settings);
}

TEST(Play, HoldsEachShapeOnceAndWhatHappens) {
  const Json play = played({.command = "again"});
  EXPECT_EQ(play["schema"], "graze.play/1");
  EXPECT_EQ(play["command"], "again");
  ASSERT_EQ(play["bodies"].size(), 4U);
  EXPECT_EQ(play["shapes"].size(), 3U);  // a ball, a box, the ray's point
  EXPECT_EQ(play["bodies"][0]["shape"], play["bodies"][2]["shape"]);
  EXPECT_NE(play["bodies"][0]["shape"], play["bodies"][3]["shape"]);
  const Json& ball = play["shapes"][play["bodies"][0]["shape"].get<std::size_t>()];
  EXPECT_EQ(ball["shape"]["type"], "sphere");
  EXPECT_TRUE(ball["mesh"]["curved"]);
  ASSERT_EQ(play["events"].size(), 1U);
  EXPECT_EQ(play["events"][0]["a"], "left");
  EXPECT_EQ(play["events"][0]["b"], "right");
  EXPECT_NEAR(play["events"][0]["toi"]["lower"].get<double>(), 0.75, 1e-12);
  ASSERT_EQ(play["probe_events"].size(), 1U);
  // Six pairs: one that meets, and five that need not be looked at.
  const std::string sentence = play["spared"]["sentence"];
  EXPECT_NE(sentence.find("1 of 6 pairs were simulated: 0 by a static overlap, 1 linear, 0 rotating."),
            std::string::npos)
      << sentence;
  EXPECT_NE(sentence.find("1 stay apart at rest, 4 have swept bounds that never meet"), std::string::npos)
      << sentence;
}

TEST(Play, WhatItLeavesOutIsCountedAndMeetsNobody) {
  const Json play = played({.most_bodies = 2, .most_events = 0});
  ASSERT_EQ(play["bodies"].size(), 2U);
  EXPECT_EQ(play["bodies"][0]["name"], "left");
  EXPECT_EQ(play["bodies"][1]["name"], "right");
  EXPECT_EQ(play["left_out"]["bodies"], 2);
  EXPECT_EQ(play["left_out"]["events"], 1);
  EXPECT_EQ(play["left_out"]["probe_events"], 1);
  EXPECT_TRUE(play["events"].empty());
}

}  // namespace
}  // namespace graze
