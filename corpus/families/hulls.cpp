// hulls, hulls_rotated: two hulls of random vertices, one aimed near the other: the plainest question, to be
// asked many million times. Hardness: the vertices of each.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

void draw_hulls(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;  // size of a shape (length)
  const int vertices = static_cast<int>(hardness);
  problem.a.shape = draw.hull(kReach, vertices);
  problem.b.shape = draw.hull(kReach, vertices);
}

void fill_hulls(Draw& draw, double hardness, Case& problem) {
  draw_hulls(draw, hardness, problem);
  approach(draw, problem);
}

void fill_hulls_rotated(Draw& draw, double hardness, Case& problem) {
  draw_hulls(draw, hardness, problem);
  problem.a.orientation = draw.turned_pose();
  problem.b.orientation = draw.turned_pose();
  approach(draw, problem);
}

constexpr double kHullsLevels[] = {8, 10, 12, 14, 16};

}  // namespace

const Family family::hulls{
    .name = "hulls",
    .sentence = "Two hulls of few random vertices, not turned, one aimed near the other.",
    .hardness_meaning = "the number of vertices of each hull",
    .levels = kHullsLevels,
    .fill = fill_hulls,
    .picture = {12, 2},
};

const Family family::hulls_rotated{
    .name = "hulls_rotated",
    .sentence = "Two hulls of few random vertices, turned, one aimed near the other.",
    .hardness_meaning = "the number of vertices of each hull",
    .levels = kHullsLevels,
    .fill = fill_hulls_rotated,
    .picture = {12, 4},
};

}  // namespace graze::corpus
