#include "properties/defects/sample.hpp"

#include "corpus/families.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/large_hull.hpp"
#include "properties/generate/near_ball.hpp"
#include "properties/generate/near_degenerate.hpp"
#include "properties/generate/rotating.hpp"
#include "properties/generate/round_tie.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Family;

namespace {

Case of_family(const Family& family, std::size_t turn) {
  return family.generate(family.levels[turn % ((family.levels.size() + 1) / 2)], turn);
}

std::vector<Case> linear_cases(int count) {
  std::vector<Case> out;
  corpus::Random random(20260117), balls(20261126), large(20261127);
  for (int seed = 0; static_cast<int>(out.size()) < count; ++seed) {
    for (const Family& family : corpus::families()) {
      out.push_back(of_family(family, static_cast<std::size_t>(seed)));
      out.push_back(draw_case(random, seed % 100));
    }
  }
  for (int i = 0; i < count / 16; ++i) out.push_back(draw_near_ball(balls));
  for (int i = 0; i < count / 24; ++i) out.push_back(draw_large_hull(large));
  // Of the families, too few cases are a point that meets a box or a triangle.
  const Family& rays = *corpus::find_family("rays");
  for (int i = 0; i < count / 16; ++i) out.push_back(rays.generate(0, static_cast<std::uint64_t>(i)));
  // A line through an apex. One in some hundreds of these has a portal whose corners can orbit.
  out.push_back(corpus::find_family("equal_distances")->generate(4, 3479603925236361016u));
  return out;
}

std::vector<Case> near_ties(int count) {
  std::vector<Case> out;
  out.reserve(static_cast<std::size_t>(count));
  corpus::Random random(20261122), round(20261123);
  const Family &rays = *corpus::find_family("ray_ties"), &rounds = *corpus::find_family("round_ties");
  for (int i = 0; i < count; ++i) {
    out.push_back(draw_near_tie(random));
    if (i % 16 == 0) out.push_back(draw_round_tie(round));
    if (i % 16 == 8) out.push_back(rays.generate(0, static_cast<std::uint64_t>(i / 16)));
    if (i % 16 == 12) out.push_back(rounds.generate(0, static_cast<std::uint64_t>(i / 16)));
  }
  return out;
}

// Also depths of smooth bodies. Few of them have a second minimum, or discs that touch all over.
std::vector<Case> near_touches(int count) {
  std::vector<Case> out;
  corpus::Random random(20261125);
  const Family& smooth = *corpus::find_family("smooth_depths");
  for (int i = 0; i < count; ++i) {
    out.push_back(draw_near_touch(random));
    if (i % 4 == 0) out.push_back(of_family(smooth, static_cast<std::size_t>(i / 4)));
  }
  return out;
}

std::vector<Case> rotating_cases(int count) {
  std::vector<Case> out;
  corpus::Random random(20261121), large(20261128);
  const auto families = corpus::rotating_families();
  for (int i = 0; static_cast<int>(out.size()) < count; ++i) {
    if (i % 8 != 7) {
      out.push_back(draw_rotating(random, i % 100));
      continue;
    }
    const std::size_t turn = static_cast<std::size_t>(i) / 8;
    const Family& family = families[turn % families.size()];
    const std::size_t level = turn / families.size() % ((family.levels.size() + 1) / 2);
    out.push_back(family.generate(family.levels[level], turn));
  }
  for (int i = 0; i < count / 24; ++i) out.push_back(draw_turning_large_hull(large));
  return out;
}

}  // namespace

Sample sample_for(Kind kind, int count) {
  switch (kind) {
    case Kind::linear:
      return {linear_cases(count), near_ties(10 * count)};
    case Kind::query:
      return {linear_cases(count), near_touches(4 * count)};
    case Kind::rotating:
      break;
  }
  return {rotating_cases(count), {}};
}

}  // namespace graze::law
