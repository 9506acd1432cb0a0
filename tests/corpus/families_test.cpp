// The families: the same bits everywhere, sound cases, and each level as hard as it says, by the exact
// oracle.
#include "corpus/families.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <graze/cast.hpp>
#include <map>
#include <set>
#include <string_view>

#include "corpus/format/case_io.hpp"
#include "corpus/random.hpp"
#include "corpus/support_value.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "tests/corpus/depth_of.hpp"

namespace graze::corpus {
namespace {

constexpr std::uint64_t kSeeds = 24;

TEST(Families, AreFoundByName) {
  EXPECT_EQ(families().size(), 42u);
  for (const Family& family : families()) EXPECT_EQ(find_family(family.name), &family);
  EXPECT_EQ(find_family("no such family"), nullptr);
}

// Every bit of every level's first cases, through the writer, which keeps every bit. The hashes were made by
// g++ 12 on x86-64. Any other compiler, flag or machine must give the same.
TEST(Families, AreTheSameBitsEverywhere) {
  const struct {
    const char* name;
    std::uint64_t hash;
  } golden[] = {
      {"random", 0x24c4cb8439c2702bu},
      {"aligned_boxes", 0x21721981b372a7e9u},
      {"grazing_vertex", 0x25c803b14876c3e3u},
      {"grazing_edge", 0xa21da478cca01aau},
      {"grazing_face", 0x6adab1f2d829cc81u},
      {"size_ratio", 0x581c2dd2f08677b0u},
      {"far_from_origin", 0x9414bd44dc81a2b0u},
      {"touching", 0xd5a33e25c95b13c3u},
      {"curved", 0x6b3213ce15b85f58u},
      {"combinators", 0x6e8e1445381b78dbu},
      {"hulls", 0xea9f755b2847a9ffu},
      {"hulls_rotated", 0x1364d35715d2d561u},
      {"flat_shapes", 0x0e462526459be696u},
      {"redundant_vertices", 0x379629fc4e77df9du},
      {"lattice", 0xc90284b130a08c2eu},
      {"contained", 0x5c06caaec09a7663u},
      {"sliding", 0xe59888b6c36e7af3u},
      {"speeds", 0xad7ea1b5a5ca025au},
      {"target_margin", 0x1c1045428f2a1315u},
      {"scaled_scene", 0x22f9d75f6f3cd6a5u},
      {"many_vertices", 0x13d85df93dc368a5u},
      {"needles", 0xc40e2211373a362au},
      {"plates", 0xbe56d3cc3b499f13u},
      {"parallel_faces", 0x6a4702cd24c6c892u},
      {"parallel_edges", 0x230779c956fb102eu},
      {"perpendicular", 0xb9a0233f3d1ef4f1u},
      {"noisy_copy", 0x43e28cd2cc216e3au},
      {"smooth_graze", 0xca2099e953b80247u},
      {"slivers", 0xda5a98689399c239u},
      {"far_own_frame", 0xdbcce1176c6becdbu},
      {"mixed_magnitudes", 0x320bae4d2f84d614u},
      {"level_prisms", 0x6cc779ad3ec3dbd7u},
      {"at_rest", 0x3e4abb52f205f8a7u},
      {"coaxial", 0xf095c848483a473fu},
      {"equal_distances", 0x480de57eb3ab620fu},
      {"parallel_caps", 0x173d91cd7b46607du},
      {"rods_and_round", 0xc89bbc86f5f7f328u},
      {"smooth_depths", 0xb17fafe3b63711bu},
      {"rays", 0xcd81db93c0f20c0du},
      {"round_ties", 0xd12f1324da33dc2au},
      {"apexes", 0x606766c0d73250b7u},
      {"ray_ties", 0xb29b32da168f4ca5u},
      {"spinning_graze", 0xfd73f8f495788929u},
      {"fast_spin", 0x94e2b30f2a43459u},
      {"off_centre_pivot", 0xdfce330b062f33cbu},
      {"enters_and_leaves", 0x5f201819e19bbd09u},
      {"both_turn", 0xc9a9d5fd6261b985u},
      {"slow_spin", 0x48d34b1896949a08u},
      {"random_rotating", 0x22e5243af3511725u},
      {"pure_spin", 0xa165f6f39a6b0a63u},
      {"far_own_frame_turning", 0x8318dba1f234dbfdu},
      {"long_arms", 0x444fde69d0808985u},
      {"swung_balls", 0xc6c15f6596daef25u},
      {"level_tiles", 0x5c38716275166fdeu},
      {"wheels", 0x48ce95b994567cbcu},
      {"flat_plates_turning", 0x51eb844475304557u},
      {"above_a_floor", 0xc14c9648f52df2b9u},
  };
  for (const auto& [name, hash] : golden) {
    const Family* family = find_family(name);
    ASSERT_NE(family, nullptr) << name;
    std::string text;
    for (const double level : family->levels) {
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
        text += write_case(family->generate(level, seed)) + "\n";
    }
    EXPECT_EQ(fnv1a(text), hash) << name;
  }
}

TEST(Families, ReadBackAsTheyAreAndDifferBySeed) {
  for (const std::span<const Family> list : {families(), rotating_families()}) {
    for (const Family& family : list) {
      std::set<std::string> bodies;
      for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Case problem = family.generate(family.levels.front(), seed);
        const ReadResult read = read_text(write_case(problem), problem.id, false);
        ASSERT_TRUE(read.ok()) << read.errors[0].text();
        EXPECT_TRUE(same_case(read.cases[0], problem)) << problem.id;
        const std::string text = write_case(problem);
        bodies.insert(text.substr(text.find("\"a\"")));
      }
      EXPECT_EQ(bodies.size(), 100u) << family.name;
    }
  }
}

TEST(Families, BringHardnessToALevelAndNameTheCaseByIt) {
  const Family& grazing = *find_family("grazing_edge");
  EXPECT_EQ(grazing.generate(8, 42).id, "grazing_edge/h8/s42");
  EXPECT_EQ(grazing.generate(1000, 1).id, "grazing_edge/h16/s1");
  EXPECT_EQ(grazing.generate(-5, 1).id, "grazing_edge/h1/s1");
  EXPECT_EQ(grazing.generate(7.6, 1).hardness, 8);
}

// The families whose shapes the exact oracle decides.
bool is_exact(const Family& family) {
  constexpr std::array kOthers = {"curved",           "combinators", "smooth_graze", "far_own_frame",
                                  "mixed_magnitudes", "at_rest",     "coaxial",      "rods_and_round",
                                  "smooth_depths",    "rays",        "round_ties",   "apexes",
                                  "ray_ties"};
  return std::find(kOthers.begin(), kOthers.end(), family.name) == kOthers.end();
}

void add_kinds(const Shape<double>& shape, std::set<std::size_t>& kinds) {
  kinds.insert(shape.index());
  std::visit(
      [&](const auto& one) {
        if constexpr (requires { one.shapes; }) {
          for (const auto& part : one.shapes) add_kinds(part->shape, kinds);
        } else if constexpr (requires { one.shape; }) {
          add_kinds(one.shape->shape, kinds);
        }
      },
      shape);
}

TEST(Families, CurvedDrawsTheTenShapesAndCombinatorsAllOfThem) {
  for (const auto& [name, count] : {std::pair("curved", 10u), std::pair("combinators", 14u)}) {
    const Family& family = *find_family(name);
    std::set<std::size_t> kinds;
    for (const double level : family.levels) {
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const Case problem = family.generate(level, seed);
        add_kinds(problem.a.shape, kinds);
        add_kinds(problem.b.shape, kinds);
      }
    }
    EXPECT_EQ(kinds.size(), count) << name;
  }
}

TEST(Combinators, AreNestedAsDeepAsTheHardnessSays) {
  const Family& family = *find_family("combinators");
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      const int deepest = std::max(depth_of(problem.a.shape), depth_of(problem.b.shape));
      // A hull of two poses its second part: one more, at most.
      EXPECT_GE(deepest, static_cast<int>(level)) << problem.id;
      EXPECT_LE(deepest, static_cast<int>(level) + 1) << problem.id;
    }
  }
}

// The extents that are not zero are 10^-k of the others, in some shape of most cases, and never less.
TEST(Curved, IsAsThinAsTheHardnessSays) {
  const Family& family = *find_family("curved");
  for (const double level : {2.0, 5.0, 8.0}) {
    std::size_t thin = 0;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      for (const Body<double>* body : {&problem.a, &problem.b}) {
        const Bounds box = bounds(body->shape);
        const Vec3<double> size = box.high - box.low;
        for (int i = 0; i < 3; ++i) {
          if (size[i] == 0 || std::get_if<Hull<double>>(&body->shape) != nullptr) continue;
          thin += size[i] <= 8.01 * std::pow(10, -level);
        }
      }
    }
    EXPECT_GE(thin, kSeeds / 3) << level;
  }
}

// The families draw hits, misses and overlaps. This tests the mix, not the answers.
TEST(Families, CurvedAndCombinatorsMixOutcomes) {
  for (const Family& family : families()) {
    if (is_exact(family)) continue;
    std::map<Outcome, std::size_t> outcomes;
    for (const double level : family.levels) {
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const Case problem = family.generate(level, seed);
        ++outcomes[cast(problem.a, problem.b, CastOptions<double>{.t_max = problem.t_max}).outcome];
      }
    }
    const std::size_t total = family.levels.size() * kSeeds;
    EXPECT_GE(outcomes[Outcome::hit], total / 8) << family.name;
    EXPECT_GE(outcomes[Outcome::miss], total / 8) << family.name;
    if (family.name != "smooth_graze") {
      EXPECT_GE(outcomes[Outcome::initially_overlapping], total / 20) << family.name;
    }
    EXPECT_EQ(outcomes[Outcome::invalid_input], 0u) << family.name;
  }
}

// Guards against a family that draws one kind of thing only.
TEST(Families, MixShapesPosesOutcomesAndHorizons) {
  std::set<std::string> kinds;
  for (const Family& family : families()) {
    if (!is_exact(family)) continue;
    std::size_t hits = 0, misses = 0, starts = 0, rotated = 0, infinite = 0;
    // Dense hulls cost the oracle most.
    const bool is_dense =
        family.name == "many_vertices" || family.name == "parallel_caps" || family.name == "equal_distances";
    const std::uint64_t seeds = is_dense ? kSeeds / 4 : kSeeds;
    for (const double level : family.levels) {
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const Case problem = family.generate(level, seed);
        kinds.insert("shape " + std::to_string(problem.a.shape.index()));
        kinds.insert("shape " + std::to_string(problem.b.shape.index()));
        rotated += !problem.a.orientation.is_identity() || !problem.b.orientation.is_identity();
        infinite += std::isinf(problem.t_max);
        const Outcome outcome = oracle::LinearTruth(problem).outcome();
        hits += outcome == Outcome::hit;
        misses += outcome == Outcome::miss;
        starts += outcome == Outcome::initially_overlapping;
      }
    }
    const std::size_t total = family.levels.size() * seeds;
    // A case of sliding bodies starts in touch, passed over or not.
    if (family.name != "sliding") {
      EXPECT_GE(hits, total / 8) << family.name;
    }
    EXPECT_GE(misses, total / 8) << family.name;
    // Two families differ in that alone.
    if (family.name == "hulls") {
      EXPECT_EQ(rotated, 0u);
    } else if (family.name == "hulls_rotated") {
      EXPECT_EQ(rotated, total);
    } else {
      EXPECT_GE(rotated, total / 4) << family.name;
      EXPECT_LE(rotated, total * 19 / 20) << family.name;
    }
    // Those that are about paths from a start apart hold no start in contact (dense hulls, none in so few).
    const std::set<std::string_view> apart_by_construction = {
        "grazing_vertex", "grazing_edge",   "grazing_face",  "size_ratio",
        "parallel_faces", "parallel_edges", "perpendicular", "many_vertices"};
    const bool apart = apart_by_construction.count(family.name) != 0;
    EXPECT_EQ(starts == 0, apart) << family.name;
    const bool ends = family.name == "touching" || family.name == "parallel_caps";
    EXPECT_EQ(infinite == 0, ends) << family.name;
  }
  EXPECT_GE(kinds.size(), 6u);
}

TEST(Touching, StartsInContactExactlyAtHardnessZeroAndMoreRarelyBefore) {
  const Family& family = *find_family("touching");
  std::size_t apart = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Case touching = family.generate(0, seed);
    EXPECT_EQ(oracle::LinearTruth(touching).outcome(), Outcome::initially_overlapping) << touching.id;
    EXPECT_EQ(oracle::LinearTruth(touching).distance().high, 0) << touching.id;
    const Case near = family.generate(-1, seed);
    const oracle::LinearTruth truth(near);
    if (truth.outcome() == Outcome::initially_overlapping) continue;
    ++apart;
    // One unit in the last place of 1, in float or in double. A vertex over a vertex may be off sideways.
    EXPECT_LE(truth.distance().low, 0x1p-23) << near.id;
    EXPECT_GT(truth.distance().high, 0) << near.id;
  }
  EXPECT_GE(apart, kSeeds / 4);
}

TEST(AlignedBoxes, ShareAsManyPlanesAsTheHardnessSays) {
  const Family& family = *find_family("aligned_boxes");
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      // A cube rotation in the poses permutes the extents of both boxes alike.
      int ties = 0;
      const auto extents = [](const Body<double>& body) {
        const Vec3<double> h = std::get<Box<double>>(body.shape).half_extents;
        const Quaternion<double>& q = body.orientation;
        const double n = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
        // |entries| of a rotation of the cube: 0 or 1.
        const double m[3][3] = {{q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z, 2 * (q.x * q.y - q.w * q.z),
                                 2 * (q.x * q.z + q.w * q.y)},
                                {2 * (q.x * q.y + q.w * q.z), q.w * q.w + q.y * q.y - q.x * q.x - q.z * q.z,
                                 2 * (q.y * q.z - q.w * q.x)},
                                {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x),
                                 q.w * q.w + q.z * q.z - q.x * q.x - q.y * q.y}};
        Vec3<double> e;
        for (int i = 0; i < 3; ++i) {
          e[i] = (std::abs(m[i][0]) * h[0] + std::abs(m[i][1]) * h[1] + std::abs(m[i][2]) * h[2]) / n;
        }
        return e;
      };
      const Vec3<double> ea = extents(problem.a), eb = extents(problem.b);
      for (int i = 0; i < 3; ++i) {
        const double offset = std::abs(problem.b.position[i] - problem.a.position[i]);
        ties += offset == ea[i] + eb[i] || offset == std::abs(ea[i] - eb[i]);
      }
      EXPECT_EQ(ties, static_cast<int>(level)) << problem.id;
    }
  }
}

TEST(SizeRatio, IsTheRatioOfTheBodies) {
  const Family& family = *find_family("size_ratio");
  for (const double level : family.levels) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      const auto reach = [](const Shape<double>& shape) {
        double most = 0;
        if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) most = sphere->radius;
        if (const auto* box = std::get_if<Box<double>>(&shape)) most = box->half_extents.maxCoeff();
        if (const auto* hull = std::get_if<Hull<double>>(&shape)) most = hull->largest();
        return most;
      };
      const double large = std::max(reach(problem.a.shape), reach(problem.b.shape));
      // 2 to 4 times 10^k, rounded to an integer at most. Hulls and boxes reach a little below their top.
      EXPECT_GE(large, 2 * std::pow(10, level)) << problem.id;
      EXPECT_LE(large, 4 * std::pow(10, level) + 2) << problem.id;
    }
  }
}

TEST(FarFromOrigin, IsAsFarAsTheHardnessSays) {
  const Family& family = *find_family("far_from_origin");
  for (const double level : {4.0, 6.0, 8.0}) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case problem = family.generate(level, seed);
      for (const Body<double>* body : {&problem.a, &problem.b}) {
        double most = body->position.cwiseAbs().maxCoeff();
        if (const auto* hull = std::get_if<Hull<double>>(&body->shape))
          most = std::max(most, hull->largest());
        EXPECT_GE(most, 0.5 * std::pow(10, level) - 100) << problem.id;
        EXPECT_LE(most, std::pow(10, level) + 100) << problem.id;
      }
    }
  }
}

}  // namespace
}  // namespace graze::corpus
