// The arithmetic beyond doubles that the exact tier filters with (numeric/pair.hpp, vectors.hpp, search/exact/exact_scene.hpp,
// beyond.hpp): each stated error against exact numbers. Trees are as large as validation accepts: 16 levels, many
// shifts above few leaves, sixteen rotations above one leaf, more leaves than pairs of doubles are used for.
#include <gtest/gtest.h>

#include <graze/detail/search/exact/beyond.hpp>
#include <graze/validate.hpp>

#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using detail::exact::Dyadic;
using detail::exact::Fine;
using detail::exact::Pair;
using detail::exact::Scene;
using detail::exact::Term;
using detail::exact::Vertex;
using oracle::WorkingPrecision;

constexpr long kExactBits = 40000;  // more than a Dyadic holds

using test::exactly;
Ball exactly(const Pair& x) { return Ball(x.hi) + Ball(x.lo); }
std::string text(const Pair& x, const Pair& y) {
  std::ostringstream out;
  out << std::hexfloat << "  " << x.hi << " + " << x.lo << ", " << y.hi << " + " << y.lo << "\n";
  return out.str();
}

// --- pair.hpp

TEST(ExactBounds, SumsAndProductsOfPairs) {
  const WorkingPrecision precision(4096);
  HostileDraw draw(91);
  Tally sums("Pair x + y, over 2^-101 (X + Y)"), products("Pair x y, over 2^-97 X Y");
  // |hi| and |hi + lo| at most `size`, |lo| at most 2^-49 of it: at these bounds, at powers of two, and with
  // last bits that a rounding drops half of.
  const auto pair = [&](double size) {
    const auto sign = [&] { return draw.chance(0.8) ? 1.0 : -1.0; };
    Pair out{size * (draw.chance(0.5) ? 1.0 : draw.plain().between(0, 1)), 0};
    if (draw.chance(0.3)) out.hi = size * draw.power(-60, 0);
    const double most = 0x1p-49 * size;
    out.lo = most * (draw.chance(0.4) ? 1 - draw.power(-53, -45) : draw.plain().between(0, 1));
    out.hi *= sign();
    out.lo *= sign();
    if (std::abs(exactly(out).mid_double()) > size) out.lo = -out.lo;
    return out;
  };
  for (int i = 0; i < rounds(20000); ++i) {
    const double size_x = draw.power(-1, 1),
                 size_y = size_x * (draw.chance(0.6) ? draw.power(-1, 1) : draw.power(-60, 0));
    const Pair x = pair(size_x), y = pair(size_y);
    const auto with = [&] { return text(x, y); };
    const Ball both = Ball(size_x) + Ball(size_y), product = Ball(size_x) * Ball(size_y);
    sums.add(0x1p-101, abs(exactly(x + y) - (exactly(x) + exactly(y))) / both, with);
    products.add(0x1p-97, abs(exactly(x * y) - exactly(x) * exactly(y)) / product, with);
  }
  sums.finish(5000);
  products.finish(5000);
}

// --- vectors.hpp: terms of a scene

Quaternion<double> any_turn(HostileDraw& draw) {
  Quaternion<double> q = draw.plain().turn<double>();
  if (draw.chance(0.2)) q = {1, draw.power(-50, 0), 0, 0};
  // Largest weights there are: four components of nearly 2.
  if (draw.chance(0.5)) {
    for (double* c : {&q.w, &q.x, &q.y, &q.z}) *c = std::copysign(2 - draw.power(-50, -2), *c);
  }
  return q;
}

// A rotation of few bits and of nearly the greatest weight. The product of three hundred of them leaves the
// range of doubles but not that of exact numbers.
Quaternion<double> heavy_turn(HostileDraw& draw) {
  const auto c = [&] { return (draw.chance(0.5) ? 1 : -1) * (2 - 0.125 * double(1 + draw.below(4))); };
  return {c(), c(), c(), c()};
}

// Turned in each other, and not moved: a shift has a weight of its own, and hundreds are beyond exact
// numbers.
Shape<double> heavy_chain(HostileDraw& draw, Shape<double> leaf, int levels) {
  for (int i = 0; i < levels; ++i) {
    leaf = posed<double>(std::move(leaf), Vec3<double>(Vec3<double>::Zero()), heavy_turn(draw));
  }
  return leaf;
}

// Nested poses, `turns` of them with a rotation.
Shape<double> chain(HostileDraw& draw, Shape<double> leaf, int levels, int turns, double size) {
  for (int i = 0; i < levels; ++i) {
    const Vec3<double> by = draw.plain().vector<double>(size * (draw.chance(0.3) ? draw.power(-50, 0) : 1));
    leaf = posed<double>(std::move(leaf), by, i < turns ? any_turn(draw) : Quaternion<double>{});
  }
  return leaf;
}
Shape<double> leaf_of(HostileDraw& draw, bool flat) {
  if (flat) return Point<double>{};
  return Segment<double>{draw.plain().vector<double>(1), draw.plain().vector<double>(1)};
}

// Shifts that keep adding to the low part of a sum near 1. Each is below half a last place of the sum, and
// its last bits are those of which a rounding drops the most, to one side.
class LowParts {
 public:
  explicit LowParts(HostileDraw& draw) : draw_(draw) {}
  double next() {
    double best = 0, most = -1;
    for (int k = 0; k < 32; ++k) {
      const double p = 0x1p-53 * (1 - draw_.power(-52, -3));
      const double sum = low_ + p, lost = (low_ - sum) + p;  // exact, as low_ >= p or both are small
      if (-lost > most) {
        most = -lost;
        best = p;
      }
    }
    low_ += best;
    return best;
  }

 private:
  HostileDraw& draw_;
  double low_ = 0;
};

void compare_terms(const Scene<double>& scene, const std::vector<Term>& terms, Tally& tally,
                   const std::function<std::string()>& with) {
  for (const Term& term : terms) {
    const Fine fine = scene.fine(term);
    const detail::exact::Exact truth = scene.exact(term);
    ASSERT_TRUE(scene.valid());
    if (!(fine.size > 0)) continue;
    Ball most;
    for (std::size_t i = 0; i < 3; ++i) most = max(most, abs(exactly(fine.x[i]) - exactly(truth.x[i])));
    tally.add(0x1p-92, most / Ball(fine.size), with);
  }
}

Vertex vertex_of(HostileDraw& draw, const Body<double>& a, const Body<double>& b) {
  return {static_cast<std::uint32_t>(draw.below(detail::vertex_count<double>(a.shape))),
          static_cast<std::uint32_t>(draw.below(detail::vertex_count<double>(b.shape)))};
}

std::string text(const Body<double>& a, const Body<double>& b) {
  std::ostringstream out;
  out << std::hexfloat << "  A: ";
  write(out, RotatingBody<double>{a});
  out << "\n  B: ";
  write(out, RotatingBody<double>{b});
  out << "\n";
  return out.str();
}

// For every scene that admits pairs of doubles, the pairs are as accurate as their header says.
TEST(ExactBounds, FineTermsOfDrawnTrees) {
  const WorkingPrecision precision(kExactBits);
  HostileDraw draw(92);
  Tally fine("Fine terms, over 2^-92 size");
  for (int i = 0; i < rounds(120); ++i) {
    const auto body = [&](std::uint64_t leaves) {
      Sum<double> all;
      for (std::uint64_t k = 0; k < leaves; ++k) {
        const int levels = static_cast<int>(draw.below(draw.chance(0.5) ? 3 : 14));
        // Fewer rotations if there are many leaves: weights multiply, and exact numbers grow.
        const int turns = leaves > 3 ? static_cast<int>(draw.below(2)) : static_cast<int>(draw.below(6));
        all.shapes.push_back(share<double>(chain(draw, leaf_of(draw, draw.chance(0.5)), levels, turns, 1)));
      }
      return Body<double>{.shape = all,
                          .position = draw.plain().vector<double>(2),
                          .orientation = draw.chance(0.5) ? Quaternion<double>{} : any_turn(draw)};
    };
    const bool small = draw.chance(0.7);
    const Body<double> a = body(1 + draw.below(small ? 2 : 6)), b = body(1 + draw.below(small ? 2 : 4));
    const Scene<double> scene(a, b, 0, 0);
    if (!scene.has_fine()) continue;  // then nothing is claimed of pairs
    const Vertex from = vertex_of(draw, a, b), to = vertex_of(draw, a, b);
    compare_terms(scene, {Term::point(to), Term::difference(from, to), Term::inside({from, to, from}, to)},
                  fine, [&] { return text(a, b); });
  }
  fine.finish(100);
}

// Few leaves, but up to fifteen shifts above each of them: as many parts as the scene is willing to add up in
// pairs of doubles, or more.
TEST(ExactBounds, FineTermsOfManyShifts) {
  const WorkingPrecision precision(kExactBits);
  HostileDraw draw(93);
  Tally fine("Fine terms of many shifts, over 2^-92 size");
  int all_there_are = 0;
  for (int i = 0; i < rounds(40); ++i) {
    const int leaves = i % 2 == 0 ? 1 : i % 10 == 9 ? 64 : i % 10 == 7 ? 31 : 1 + i % 15;
    const int levels = i % 4 == 3 ? 15 : 8 + static_cast<int>(draw.below(7));
    std::array<LowParts, 3> low = {LowParts(draw), LowParts(draw), LowParts(draw)};
    Sum<double> all;
    for (int k = 0; k < leaves; ++k) {
      // The outermost of a chain is added first.
      std::vector<Vec3<double>> shifts;
      for (int level = 0; level < levels; ++level) {
        Vec3<double> by(1, 1, 1);
        if (k > 0 || level > 0) by = {low[0].next(), low[1].next(), low[2].next()};
        shifts.push_back(by);
      }
      Shape<double> shape = Point<double>{};
      for (std::size_t level = shifts.size(); level-- > 0;) shape = translated<double>(shape, shifts[level]);
      all.shapes.push_back(share<double>(shape));
    }
    const Body<double> a{.shape = all,
                         .orientation = draw.chance(0.5) ? Quaternion<double>{} : any_turn(draw)};
    const Body<double> b{.shape = Point<double>{}};
    ASSERT_EQ(validate(a), Invalid::none);
    const Scene<double> scene(a, b, 0, 0);
    all_there_are += leaves * levels >= 150;
    if (!scene.has_fine()) continue;  // then nothing is claimed of pairs
    compare_terms(scene, {Term::point({0, 0})}, fine, [&] {
      return std::to_string(leaves) + " leaves of " + std::to_string(levels) + " shifts\n";
    });
  }
  fine.finish(5);
  EXPECT_GT(all_there_are, 2);
}

// --- beyond.hpp

// The direction of two terms is within its error of the exact direction, or its error is not a number, which
// nothing beats. The draw includes trees with more leaves than pairs of doubles are trusted for, and deep
// rotations.
TEST(ExactBounds, DirectionsOfTwoTerms) {
  const WorkingPrecision precision(kExactBits);
  HostileDraw draw(94);
  Tally direction("direction_of, over its error");
  int unknown = 0, many = 0, wrong = 0;
  std::string failures;
  for (int i = 0; i < rounds(60); ++i) {
    const std::uint64_t leaves = draw.chance(0.5) ? 1 + draw.below(4) : 17 + draw.below(12);
    const bool deep = leaves > 4 && draw.chance(0.6);
    Sum<double> all;
    for (std::uint64_t k = 0; k < leaves; ++k) {
      const int levels = deep ? 14 : static_cast<int>(draw.below(3));
      all.shapes.push_back(
          share<double>(chain(draw, leaf_of(draw, k > 4), levels, leaves > 4 && !deep ? 0 : levels, 1)));
    }
    const Body<double> a{.shape = all,
                         .orientation = draw.chance(0.5) ? Quaternion<double>{} : any_turn(draw)};
    const Body<double> b{
        .shape = Segment<double>{draw.plain().vector<double>(1), draw.plain().vector<double>(1)},
        .position = draw.plain().vector<double>(2)};
    const Scene<double> scene(a, b, 0, 0);
    const Term f = Term::difference(vertex_of(draw, a, b), vertex_of(draw, a, b)),
               g = draw.chance(0.5) ? Term::given(draw.plain().vector<double>(1))
                                    : Term::point(vertex_of(draw, a, b));
    const detail::exact::Direction seen = detail::exact::direction_of(scene, f, g, 1);
    many += !scene.has_fine();
    if (!(seen.error.maxCoeff() < kInfinity<double>) || !seen.approx.allFinite()) {
      // A comparison with it is never sure: no component may look known.
      const Vec3<double> step(1, 1, 1);
      const double height = seen.approx.dot(step), error = seen.error.dot(step);
      wrong += height > error || height < -error;
      ++unknown;
      continue;
    }
    const detail::exact::Exact x = scene.exact(f), y = scene.exact(g);
    if (!scene.valid()) continue;  // beyond what exact numbers hold: no sign is trusted
    const detail::exact::Dyadic3 n = detail::exact::cross(x.x, y.x);
    if (!n[0].valid() || !n[1].valid() || !n[2].valid()) continue;
    // The factor that pairs of doubles were scaled by: the same weights stand in both.
    const auto scale = [&](const Term& term) {
      return -exponent_of(std::max(scene.fine(term).size, 0x1p-1000));
    };
    const int factor = scale(f) + scale(g);
    for (std::size_t k = 0; k < 3; ++k) {
      const int j = static_cast<int>(k);
      direction.add(seen.error[j], abs(Ball(seen.approx[j]) - exactly(n[k]) * two_to(factor)),
                    [&] { return text(a, b); });
    }
  }
  std::printf("directions: %d of more parts than pairs are for, %d not known\n", many, unknown);
  direction.finish(40);
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(many, rounds(15));
}

// A vertex beyond a plane is found exactly if there is one. The exact sign of every vertex of each leaf is
// the reference. The trees have many leaves, rotated so often that weights leave the range of doubles.
TEST(ExactBounds, WhatIsBeyondIsFound) {
  HostileDraw draw(95);
  int found = 0, none = 0, overflowed = 0, given_up = 0;
  for (int i = 0; i < rounds(40); ++i) {
    const bool heavy = draw.chance(0.5);
    const std::uint64_t leaves = heavy ? 21 + draw.below(6) : 1 + draw.below(20);
    Sum<double> all;
    for (std::uint64_t k = 0; k < leaves; ++k) {
      const Segment<double> few{{draw.chance(0.5) ? 1.0 : -1.0, 0.5, 0},
                                {0.25, draw.chance(0.5) ? 1.0 : -1.0, 1}};
      Shape<double> leaf = k > 3 ? Shape<double>(Point<double>{}) : Shape<double>(few);
      if (!heavy && k <= 3) leaf = leaf_of(draw, false);
      all.shapes.push_back(share<double>(heavy ? heavy_chain(draw, leaf, 15) : chain(draw, leaf, 2, 2, 1)));
    }
    const Body<double> a{.shape = all}, b{.shape = Box<double>{{1, 1, 1}}, .position = {3, 0, 0}};
    ASSERT_EQ(validate(a), Invalid::none);
    const Scene<double> scene(a, b, 0, 0);
    const detail::PreparedPair<double> pair(a, b);
    const detail::exact::BeyondSearch<double> search(scene, pair);
    Vertex from = vertex_of(draw, a, b);
    const Term f = Term::given(Vec3<double>(draw.chance(0.5) ? 1 : -1, 0.5, 0.25)), g = Term::point(from);
    const detail::exact::Direction n = detail::exact::direction_of(scene, f, g, 1);
    overflowed += !(scene.fine(g).size < kInfinity<double>);
    const detail::exact::Dyadic3 along = detail::exact::cross(scene.exact(f).x, scene.exact(g).x);
    // From vertex to vertex, until nothing is beyond.
    for (int step = 0; step < 40; ++step) {
      Vertex beyond{};
      const bool seen = search.find(n, from, {}, beyond);
      bool truth = false, known = true;
      for (std::uint32_t l = 0; l < scene.leaves().size(); ++l) {
        const auto& leaf = scene.leaves()[l];
        for (std::uint32_t k = 0; k < leaf.count; ++k) {
          if (k == leaf.vertex(from)) continue;
          const detail::exact::Dyadic height =
              detail::exact::dot(scene.exact(Term::step(l, leaf.vertex(from), k)).x, along);
          known = known && height.valid();
          truth = truth || height.sign() > 0;
        }
      }
      if (!known || !scene.valid()) {
        ++given_up;
        break;
      }
      EXPECT_EQ(seen, truth) << text(a, b);
      (truth ? found : none) += 1;
      if (!seen) break;
      from = beyond;
    }
  }
  std::printf("beyond: %d found, %d none, %d along directions beyond doubles, %d beyond exact numbers\n",
              found, none, overflowed, given_up);
  EXPECT_GT(found, rounds(10));
  EXPECT_GT(none, rounds(10));
  EXPECT_GT(overflowed - given_up, rounds(3));
}

}  // namespace
}  // namespace graze::test
