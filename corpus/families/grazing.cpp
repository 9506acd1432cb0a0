// grazing_vertex, grazing_edge, grazing_face: the path passes a vertex, an edge or a face of C at a distance
// of 10^-k. Hardness: k. Above the feature this is a miss with that clearance. Below it is a hit with at most
// that depth. Now and then it is a miss by less, if C is flat and the path lies in a plane beside it.
//
// Frame and construction: pass_over in topped.hpp. C's top feature is the sum of A's and of B's mirrored
// bottom:
//   vertex   two vertices,
//   edge     an edge and a vertex, or two parallel edges,
//   face     a face and any feature, or two edges that cross.
// The path lies over it, along or across an edge. Over a face, supports tie along the whole path. Clearance
// and depth stay exact unless full doubles are turned. Then delta is known to within 4 u times the
// coordinates (about 32), and from k = 15 on rounding decides the side.
//
// This breaks three kinds of methods. A method that stops when "near" turns the miss into a hit. A method
// whose normal is off by an angle e reports a time that is off by 10^-k / e. A ray cast that clips against a
// plane of its simplex loses the sign of a height of the size of its rounding.
#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"
#include "corpus/families/topped.hpp"

namespace graze::corpus {
namespace {

constexpr double kReach = 4;  // size of a shape (length)

// 10^-k, either sign.
double height(Draw& draw, double hardness) {
  const bool above = draw.random.once_in(2);
  const double size = small_unit(draw, hardness);
  return above ? size : -size;
}

void fill_grazing_vertex(Draw& draw, double hardness, Case& problem) {
  const double delta = height(draw, hardness);
  Topped a = topped_vertex(draw, kReach), b = topped_vertex(draw, kReach);
  if (draw.random.once_in(3)) turn_about_z(draw, a);
  if (draw.random.once_in(3)) turn_about_z(draw, b);
  pass_over(draw, problem, a, b, Vec3<double>::Zero(), delta);
}

void fill_grazing_edge(Draw& draw, double hardness, Case& problem) {
  const double delta = height(draw, hardness);
  const Vec3<double> edge = edge_vector(draw);
  Topped a = topped_edge(draw, kReach, edge), b;
  if (draw.random.once_in(2)) {
    b = topped_edge(draw, kReach, edge);
  } else {
    b = topped_vertex(draw, kReach);
    if (draw.random.once_in(3)) turn_about_z(draw, b);
  }
  pass_over(draw, problem, a, b, draw.random.once_in(3) ? edge : Vec3<double>::Zero(), delta);
}

void fill_grazing_face(Draw& draw, double hardness, Case& problem) {
  const double delta = height(draw, hardness);
  if (draw.random.once_in(3)) {
    const Vec3<double> edge = edge_vector(draw);
    const Topped a = topped_edge(draw, kReach, edge);
    pass_over(draw, problem, a, topped_edge(draw, kReach, Vec3<double>(0 - edge[1], edge[0], 0)),
              Vec3<double>::Zero(), delta);
    return;
  }
  Topped a = topped_face(draw, kReach), b = topped_any(draw, kReach);
  if (draw.random.once_in(3)) turn_about_z(draw, a);
  if (draw.random.once_in(3)) turn_about_z(draw, b);
  pass_over(draw, problem, a, b, Vec3<double>::Zero(), delta);
}

constexpr double kGrazingLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

}  // namespace

const Family family::grazing_vertex{
    .name = "grazing_vertex",
    .sentence = "The path just touches, or just misses, a vertex.",
    .hardness_meaning = "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4",
    .levels = kGrazingLevels,
    .fill = fill_grazing_vertex,
    .picture = {9, 1},
};

const Family family::grazing_edge{
    .name = "grazing_edge",
    .sentence = "The path just touches, or just misses, an edge.",
    .hardness_meaning = "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4",
    .levels = kGrazingLevels,
    .fill = fill_grazing_edge,
    .picture = {6, 2},
};

const Family family::grazing_face{
    .name = "grazing_face",
    .sentence = "The path just touches, or just misses, a face.",
    .hardness_meaning = "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4",
    .levels = kGrazingLevels,
    .fill = fill_grazing_face,
    .picture = {6, 5},
};

}  // namespace graze::corpus
