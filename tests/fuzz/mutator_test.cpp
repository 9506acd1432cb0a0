// The mutator: total, deterministic for a seed, and each move does what it says.
#include "fuzz/mutator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "corpus/format/case_io.hpp"
#include "engines/method.hpp"
#include "fuzz/placing.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/rotating.hpp"

namespace graze::fuzz {
namespace {

using corpus::Case;
using corpus::Random;

Case cube_over_tetrahedron() {
  Case problem;
  problem.a.shape = Hull<double>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  problem.b.shape = Box<double>{{1, 1, 1}};
  problem.b.position = {1, 2, 9};
  problem.b.displacement = {0, 0, -8};
  return problem;
}

// How many of the numbers differ.
int changes(const Case& one, const Case& other) {
  const std::vector<double> l = law::scalars(one), r = law::scalars(other);
  if (l.size() != r.size()) return -1;
  int count = 0;
  for (std::size_t i = 0; i < l.size(); ++i) count += l[i] != r[i];
  return count;
}

// Calls f for every case that the move makes, and returns their number.
template <class F>
int tried(Move move, const Case& problem, const F& f) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const std::optional<Case> after = moved(move, problem, random);
    if (!after) continue;
    f(*after);
    ++count;
  }
  return count;
}

TEST(Mutator, AStepIsOneUnitInTheLastPlace) {
  const Case problem = cube_over_tetrahedron();
  int stepped = 0;
  tried(Move::one_ulp, problem, [&](const Case& after) {
    const std::vector<double> l = law::scalars(problem), r = law::scalars(after);
    EXPECT_LE(changes(problem, after), 1);
    for (std::size_t i = 0; i < l.size(); ++i) {
      EXPECT_TRUE(l[i] == r[i] || std::nextafter(l[i], r[i]) == r[i]);
    }
    stepped += changes(problem, after);
  });
  EXPECT_GE(stepped, 50);
}

TEST(Mutator, ACopyBringsInNoNewMagnitudeButANeighbour) {
  const Case problem = cube_over_tetrahedron();
  const std::vector<double> l = law::scalars(problem);
  const int count = tried(Move::copy, problem, [&](const Case& after) {
    EXPECT_LE(changes(problem, after), 1);
    for (const double x : law::scalars(after)) {
      EXPECT_TRUE(std::any_of(l.begin(), l.end(), [&](double y) {
        return std::abs(std::abs(x) - std::abs(y)) <= std::abs(x) * 0x1p-52;
      })) << x;
    }
  });
  EXPECT_GE(count, 150);  // a zero quaternion is no move
}

TEST(Mutator, AScaleIsAPowerOfTwo) {
  const Case problem = cube_over_tetrahedron();
  const int count = tried(Move::scale, problem, [&](const Case& after) {
    const std::vector<double> l = law::scalars(problem), r = law::scalars(after);
    ASSERT_EQ(l.size(), r.size());
    for (std::size_t i = 0; i < l.size(); ++i) {
      int exponent = 0;
      EXPECT_TRUE(l[i] == 0 ? r[i] == 0 : std::frexp(r[i] / l[i], &exponent) == 0.5);
    }
  });
  EXPECT_EQ(count, 200);
}

// Snapping makes the least distance of a point of one body from a vertex, an edge or a plane of the other
// small. A vertex on a vertex is the part that is easy to test.
TEST(Mutator, ASnapPutsFeaturesTogether) {
  const Case problem = cube_over_tetrahedron();
  int on_vertex = 0;
  const int count = tried(Move::snap, problem, [&](const Case& after) {
    bool together = false;
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
      for (const Vec3<double>& p : feature_points(after.a)) {
        for (const Vec3<double>& q : feature_points(after.b)) {
          together = together || (p - q - t * law::velocity(after)).norm() < 1e-12;
        }
      }
    }
    on_vertex += together;
  });
  EXPECT_GE(count, 120);
  EXPECT_GE(on_vertex, 40);
}

TEST(Mutator, ATouchMakesTheBodiesTouchAtTheStartOrAtATimeOfThePath) {
  const Case problem = cube_over_tetrahedron();
  const engine::Method& exact = *engine::find_method(engine::Kind::linear, "exact");
  int start = 0, end = 0, middle = 0;
  const int count = tried(Move::touch, problem, [&](const Case& after) {
    const engine::Answer answer = exact.ask(after, {});
    const double toi = answer.outcome == Outcome::miss ? -1 : answer.toi_upper;
    start += toi >= 0 && toi < 1e-12;
    middle += std::abs(toi - 0.5) < 1e-12;
    end += std::abs(toi - 1) < 1e-12;
  });
  EXPECT_EQ(count, 200);
  EXPECT_GE(start, 80);
  EXPECT_GE(middle, 10);
  EXPECT_GE(end, 5);
}

TEST(Mutator, ADuplicateIsOneVertexMoreAndTheSameHull) {
  const Case problem = cube_over_tetrahedron();
  const auto& before = std::get<Hull<double>>(problem.a.shape);
  int exact = 0;
  const int count = tried(Move::duplicate, problem, [&](const Case& after) {
    const auto& hull = std::get<Hull<double>>(after.a.shape);
    ASSERT_EQ(hull.size(), before.size() + 1);
    int equal = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) equal += hull.vertex(i) == hull.vertex(j);
    }
    exact += equal;
  });
  EXPECT_GE(count, 60);
  EXPECT_GE(exact, 20);
  EXPECT_LT(exact, count);
}

TEST(Mutator, ADropIsOneVertexLess) {
  const Case problem = cube_over_tetrahedron();
  EXPECT_GE(tried(Move::drop, problem,
                  [&](const Case& after) { EXPECT_EQ(std::get<Hull<double>>(after.a.shape).size(), 3u); }),
            60);
}

TEST(Mutator, AFlattenedShapeLiesInAPlane) {
  const Case problem = cube_over_tetrahedron();
  int flat = 0;
  const int count = tried(Move::flatten, problem, [&](const Case& after) {
    for (const Body<double>* body : {&after.a, &after.b}) {
      const std::vector<Vec3<double>> points = feature_points(*body);
      for (int i = 0; i < 3; ++i) {
        bool level = true;
        for (const Vec3<double>& p : points) level = level && p[i] == points[0][i];
        flat += level;
      }
    }
  });
  EXPECT_EQ(count, 200);
  EXPECT_GE(flat, 100);
}

TEST(Mutator, AnAlignmentChangesAPoseAPositionOrAMotion) {
  Case problem = cube_over_tetrahedron();
  problem.b.orientation = {1, 2, 3, 4};
  int identity = 0, along = 0;
  const int count = tried(Move::align, problem, [&](const Case& after) {
    EXPECT_EQ(law::outline(after.a.shape), law::outline(problem.a.shape));
    EXPECT_EQ(after.t_max, problem.t_max);
    identity += after.b.orientation.is_identity();
    along += after.b.displacement != problem.b.displacement;
  });
  EXPECT_GE(count, 150);
  EXPECT_GE(identity, 10);
  EXPECT_GE(along, 10);
}

TEST(Mutator, AStartChangesTheQuestionAlone) {
  const Case problem = cube_over_tetrahedron();
  int rays = 0, passing = 0, to_contact = 0;
  const int count = tried(Move::start, problem, [&](const Case& after) {
    Case back = after;
    back.t_max = problem.t_max;
    back.target_distance = problem.target_distance;
    back.start_policy = problem.start_policy;
    EXPECT_TRUE(law::same_input(back, problem));
    rays += std::isinf(after.t_max);
    passing += after.start_policy == StartPolicy::pass_over;
    // A face of the tetrahedron is hit by the cube's lower corner (0, 1, 8): 4 = 1 + 8 - 8 t.
    to_contact += std::abs(after.t_max - 0.625) < 1e-12;
  });
  EXPECT_EQ(count, 200);
  EXPECT_GE(rays, 3);
  EXPECT_GE(passing, 20);
  EXPECT_GE(to_contact, 20);
}

TEST(Mutator, ATurnChangesASpinAlone) {
  Case problem = cube_over_tetrahedron();
  problem.spin_a.rotation = {0, 1, 0};
  int quarter = 0, pivots = 0;
  const int count = tried(Move::turn, problem, [&](const Case& after) {
    Case back = after;
    back.spin_a = problem.spin_a;
    back.spin_b = problem.spin_b;
    EXPECT_TRUE(law::same_input(back, problem));
    quarter += std::abs(after.spin_a.rotation.norm() - 1.5707963267948966) < 1e-15;
    pivots += !after.spin_a.pivot.isZero(0);
  });
  EXPECT_EQ(count, 200);
  EXPECT_GE(quarter, 2);
  EXPECT_GE(pivots, 5);
}

TEST(Mutator, ABodyIsSwappedForAnotherCases) {
  const Case problem = cube_over_tetrahedron();
  int other = 0;
  EXPECT_EQ(tried(Move::swap_in, problem,
                  [&](const Case& after) {
                    other += law::outline(after.a.shape) != law::outline(problem.a.shape) ||
                             law::outline(after.b.shape) != law::outline(problem.b.shape);
                  }),
            200);
  EXPECT_GE(other, 130);  // about 150, by the compiler, and the others get a shape of their kind
}

TEST(Mutator, EveryMoveAppliesToSomeCaseAndLeavesTheDomainToNone) {
  Random drawn(5);
  std::array<int, kMoveNames.size()> applied = {};
  for (int i = 0; i < 400; ++i) {
    const Case problem = i % 2 ? law::draw_case(drawn, i % 60) : law::draw_rotating(drawn, i % 60);
    for (std::size_t move = 0; move < kMoveNames.size(); ++move) {
      Random random(static_cast<std::uint64_t>(i));
      const std::optional<Case> after = moved(static_cast<Move>(move), problem, random);
      if (!after) continue;
      ++applied[move];
      EXPECT_TRUE(law::in_domain(*after) || !law::in_domain(problem))
          << kMoveNames[move] << " of " << corpus::write_case(problem);
    }
  }
  for (std::size_t move = 0; move < kMoveNames.size(); ++move) {
    EXPECT_GE(applied[move], 40) << kMoveNames[move];
  }
}

TEST(Mutator, ItIsTotalOnBytesAndDependsOnTheSeedAlone) {
  Random drawn(6);
  int changed = 0, tails = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Bytes bytes(drawn.below(200));
    for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(drawn.bits());
    const std::optional<Bytes> once = mutated(bytes, 4096, seed), again = mutated(bytes, 4096, seed);
    EXPECT_EQ(once, again);
    if (!once) continue;
    EXPECT_LE(once->size(), 4096u);
    changed += *once != bytes;
    const std::optional<Bytes> child = crossed(bytes, *once, 4096, seed);
    EXPECT_EQ(child, crossed(bytes, *once, 4096, seed));
    tails += !decode_with_tail(*once).tail.empty();
  }
  EXPECT_GE(changed, 450);
  EXPECT_GE(tails, 50);
  EXPECT_FALSE(mutated(encode(cube_over_tetrahedron()).value(), 4, 1));
}

}  // namespace
}  // namespace graze::fuzz
