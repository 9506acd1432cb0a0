#include "reports/pages/page_scene.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "reports/pages/features.hpp"

namespace graze {
namespace {

using corpus::Case;
using show::Json;

Vec3<double> vector_of(const Json& x) { return {x[0].get<double>(), x[1].get<double>(), x[2].get<double>()}; }

Case falling_box() {
  Case problem;
  problem.id = "test/falling";
  problem.a.shape = Box<double>{{5, 5, 1}};
  problem.b.shape = Box<double>{{1, 1, 1}};
  problem.b.position = {0.25, 0.5, 4};
  problem.b.displacement = {0.125, 0, -4};
  return problem;
}

// t v at the claimed time lies in the portal's plane, and no corner of C beyond the axis' plane.
TEST(Scene, ShowsTheProofWhereItIs) {
  for (const corpus::Family& family : corpus::families()) {
    if (family.name != "hulls_rotated" && family.name != "random" && family.name != "curved") continue;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Case problem = family.generate(8, seed);
      const Json scene = show::scene_of(problem, {}, {.has_still = false});
      if (!scene["contact"] || !scene.contains("proof") || scene["moment"] == 0) continue;
      SCOPED_TRACE(problem.id);
      EXPECT_TRUE(scene["proof"]["accepted"]);
      const double size = scene["scale"];
      const Vec3<double> contact =
          scene["moment"].get<double>() * (problem.b.displacement - problem.a.displacement);
      const Vec3<double> axis = vector_of(scene["proof"]["axis"]);
      ASSERT_NEAR(axis.norm(), 1, 1e-12);
      const auto& flat = scene["cso"]["mesh"]["vertices"];
      double reach = -1e300;
      for (std::size_t i = 0; i < flat.size(); i += 3)
        reach = std::max(reach, axis.dot(Vec3<double>(flat[i].get<double>(), flat[i + 1].get<double>(),
                                                      flat[i + 2].get<double>())));
      EXPECT_NEAR(reach, axis.dot(contact), 1e-5 * size);
      // The contact is in the hull of the portal's points: their affine span at the least.
      ASSERT_GT(scene["proof"]["portal"].size(), 0U);
      double nearest = 1e300;
      for (const Json& corner : scene["proof"]["portal"]) {
        EXPECT_LE(axis.dot(vector_of(corner)), reach + 1e-5 * size);
        nearest = std::min(nearest, std::abs(axis.dot(vector_of(corner)) - reach));
      }
      EXPECT_LE(nearest, 1e-5 * size);
    }
  }
}

TEST(Scene, SetsWhatIsClaimedBesideWhatIsTrue) {
  const Case problem = falling_box();
  engine::Method late = *engine::find_method(engine::Kind::linear, "gjk");
  late.name = "late";
  late.guarantee = nullptr;  // it promises nothing, and is shown to be wrong all the same
  late.ask = [](const Case&, const engine::Ask&) {
    engine::Answer answer;
    answer.outcome = Outcome::hit;
    answer.toi_lower = answer.toi_upper = 0.625;
    answer.normal = {0, 0, 1};
    return answer;
  };
  late.holds.witnesses = false;
  const engine::Method* const methods[] = {engine::find_method(engine::Kind::linear, "mpr"), &late};
  const Json scene = show::scene_of(problem, methods, {.command = "again", .has_still = true});
  EXPECT_EQ(scene["schema"], "graze.shown/1");
  EXPECT_EQ(scene["truth"]["outcome"], "hit");
  EXPECT_EQ(scene["truth"]["toi"]["lower"], 0.5);
  EXPECT_EQ(scene["moment"], 0.5);
  ASSERT_EQ(scene["answers"].size(), 2U);
  EXPECT_EQ(scene["answers"][0]["fault"], "");
  EXPECT_EQ(scene["answers"][1]["faults"][0], "late");
  EXPECT_EQ(scene["answers"][1]["toi"]["lower"], 0.625);
  EXPECT_EQ(scene["command"], "again");
  EXPECT_NE(scene["still"].get<std::string>().find("</svg>"), std::string::npos);
  // The drawn case can be read again.
  const corpus::ReadResult read = corpus::read_text(scene["case"].get<std::string>(), "case", false);
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(corpus::same_case(read.cases[0], problem));
  const std::vector<show::Claim> claims = show::claims_of(problem, methods);
  ASSERT_EQ(claims.size(), 2U);
  EXPECT_FALSE(claims[0].is_wrong);
  EXPECT_TRUE(claims[1].is_wrong);
  EXPECT_EQ(claims[1].time, 0.625);
}

TEST(Scene, KeepsItsDigitsFarFromTheOrigin) {
  Case problem = falling_box();
  const Vec3<double> far(1e9, -3e9, 2e9);
  const Json near = show::scene_of(problem, {}, {.has_still = false});
  problem.a.position += far;
  problem.b.position += far;
  const Json moved = show::scene_of(problem, {}, {.has_still = false});
  EXPECT_EQ(moved["a"]["position"], near["a"]["position"]);
  EXPECT_EQ(moved["b"]["position"], near["b"]["position"]);
  EXPECT_EQ(moved["cso"], near["cso"]);
  EXPECT_EQ(vector_of(moved["origin"]), far);
}

TEST(Scene, ShowsBodiesThatTurnWithTheChainOfTheirProof) {
  Case problem = falling_box();
  problem.spin_b.rotation = {0.5, 0, 1};
  const Json scene = show::scene_of(problem, {}, {.has_still = false});
  EXPECT_TRUE(scene["turns"]);
  EXPECT_EQ(scene["proof"]["kind"], "rotating");
  EXPECT_TRUE(scene["proof"]["accepted"]);
  ASSERT_GT(scene["proof"]["chain"].size(), 0U);
  double end = 0;
  for (const Json& slice : scene["proof"]["chain"]) {
    EXPECT_EQ(slice["begin"], end);
    end = slice["end"];
  }
  EXPECT_GE(end, scene["proof"]["claims"]["lower"]);
  EXPECT_EQ(scene["cso"]["time"], scene["moment"]);
}

TEST(Scene, IsGeneratedAgainByItsCommand) {
  const corpus::Family& family = *corpus::find_family("random");
  EXPECT_EQ(show::generating_command(family.generate(8, 17)),
            "graze generate random --hardness 8 --seed 17 --count 1");
  Case changed = family.generate(8, 17);
  changed.b.displacement[0] += 1;
  EXPECT_EQ(show::generating_command(changed), "");
  EXPECT_EQ(show::generating_command(falling_box()), "");
}

}  // namespace
}  // namespace graze
