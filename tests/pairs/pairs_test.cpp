// All pairs of the ten shapes and of four combinators, cast by every method in double and in float. The proof
// and the oracle judge each answer, which must keep the method's guarantee.
#include <gtest/gtest.h>

#include "corpus/random.hpp"
#include "engines/guarantees.hpp"
#include "properties/judge/judge.hpp"

namespace graze::tool {
namespace {

struct Named {
  const char* name;
  Shape<double> shape;
};

const std::vector<Named>& shapes() {
  static const std::vector<Named> kShapes = {
      {"point", Point<double>{}},
      {"segment", Segment<double>{{-1, 0.5, 0}, {1, 0, 0.75}}},
      {"triangle", Triangle<double>{{-1, 0, 0}, {1, -0.5, 0.25}, {0, 1, 0.5}}},
      {"sphere", Sphere<double>{0.75}},
      {"capsule", Capsule<double>{0.5, 1}},
      {"box", Box<double>{{1, 0.5, 0.75}}},
      {"ellipsoid", Ellipsoid<double>{{1, 0.5, 0.25}}},
      {"cylinder", Cylinder<double>{0.75, 0.5}},
      {"cone", Cone<double>{0.75, 1}},
      {"hull", Hull<double>{{1, 0, 0}, {-1, 0.25, 0}, {0, 1, 0}, {0, -0.75, 0.5}, {0.25, 0, 1}, {0, 0, -1}}},
      {"swept_box", swept<double>(Box<double>{{0.5, 0.25, 0.5}}, {1, 0.5, 0})},
      {"rounded_cone", rounded<double>(Cone<double>{0.5, 0.5}, 0.25)},
      {"two_balls",
       hull_of<double>(Sphere<double>{0.5}, translated<double>(Sphere<double>{0.25}, {1, 0, 0}))},
      {"box_and_ellipsoid", sum<double>(Box<double>{{0.25, 0.5, 0.25}}, Ellipsoid<double>{{0.5, 0.25, 0.5}})},
  };
  return kShapes;
}

// Rotations with small integer quaternions, B aimed at A: most of the paths hit, some pass by.
corpus::Case placed(const Named& a, const Named& b, corpus::Random& random, int round) {
  const auto turn = [&] {
    const auto component = [&] { return static_cast<double>(random.below(19)) - 9; };
    return Quaternion<double>{10, component(), component(), component()};
  };
  const auto offset = [&](double reach) {
    const auto component = [&] { return reach * (static_cast<double>(random.below(2001)) - 1000) / 1000; };
    return Vec3<double>(component(), component(), component());
  };
  corpus::Case out;
  out.id = std::string("pairs/") + a.name + "-" + b.name + "-" + std::to_string(round);
  out.a.shape = a.shape;
  out.b.shape = b.shape;
  if (round % 3 != 0) {
    out.a.orientation = turn();
    out.b.orientation = turn();
  }
  out.a.position = offset(1);
  const Vec3<double> aim = offset(round % 2 == 0 ? 0.25 : 1.25);
  out.b.position = out.a.position + Vec3<double>(5, 0, 0) + offset(2);
  out.b.displacement = 2 * (out.a.position + aim - out.b.position);
  return out;
}

class Pairs : public testing::TestWithParam<std::size_t> {};

TEST_P(Pairs, KeepTheirRowsWithEveryShape) {
  const Named& a = shapes()[GetParam()];
  int hits = 0, misses = 0;
  for (std::size_t k = 0; k < shapes().size(); ++k) {
    const Named& b = shapes()[k];
    corpus::Random random(1000 * GetParam() + k);
    for (int round = 0; round < 4; ++round) {
      const corpus::Case problem = placed(a, b, random, round);
      SCOPED_TRACE(problem.id);
      std::unique_ptr<law::Truth> as_double, as_float;
      for (const engine::Method& method : engine::methods(engine::Kind::linear)) {
        SCOPED_TRACE(method.full_name());
        std::unique_ptr<law::Truth>& truth = method.scalar == "float" ? as_float : as_double;
        if (!truth) truth = std::make_unique<law::Truth>(method.seen(problem));
        ASSERT_NE(method.guarantee, nullptr);
        const engine::Answer answer = method.ask(problem, {.request = Request::everything});
        const law::Judgement judgement = judge(*truth, method, answer, Request::everything, true);
        if (judgement.skipped) {
          EXPECT_EQ(judgement.wrong, "");
          continue;
        }
        EXPECT_FALSE(judgement.faulty()) << judgement.fault();
        EXPECT_FALSE(judgement.stalled);
        // Well-conditioned pairs: what was found is proved. A flat C, and a line that meets an edge or a
        // vertex of it, have no portal whose signs double can see.
        if (answer.outcome == Outcome::miss) {
          EXPECT_TRUE(judgement.within_tolerance || judgement.proof == law::ProofState::accepted);
        }
        (answer.outcome == Outcome::miss ? misses : hits) += 1;
      }
    }
  }
  EXPECT_GT(hits, GetParam() == 0 ? 60 : 120);
  EXPECT_GT(misses, 6);
}

INSTANTIATE_TEST_SUITE_P(All, Pairs, testing::Range(std::size_t{0}, shapes().size()),
                         [](const testing::TestParamInfo<std::size_t>& shape) {
                           return std::string(shapes()[shape.param].name);
                         });

}  // namespace
}  // namespace graze::tool
