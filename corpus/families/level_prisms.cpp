// level_prisms: two prisms, their ends exactly level and at one height or nearly, their edges upright except
// for 10^-k. Hardness: k.
//
// A ring of three to six corners stands at two heights, the same to the bit. One body's edges lean by 10^-k,
// in one of three ways:
//   - its upper ring is moved by that,
//   - its orientation is a quarter of a turn and a little more,
//   - it is a copy of the other body with noise of 10^-k across.
// So edges of one body are parallel to edges of the other, ends lie in one plane, and A - B has slivers of
// faces there whose normals agree to 10^-k. The motion is level, or along the edges, or any. It passes beside
// the other body as often as it goes into it.
//
// This breaks a simplex of corners that are 10^-k from being in one plane, a projection on it, and a stopping
// test that waits for a support to repeat among ends that tie.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

struct Prism {
  std::vector<Vec3<double>> ring;  // at z = 0
  double half_height = 1;
};

// Six decimals, as models come.
double decimals(double x) { return std::floor(x * 1e6 + 0.5) / 1e6; }

Prism prism(Draw& draw, double size) {
  Random& random = draw.random;
  Prism out;
  const int corners = random.integer(3, 6);
  const bool regular = random.once_in(2);
  // Corners of a regular pentagon and hexagon, to six decimals. Otherwise corners of any triangle to hexagon.
  constexpr double kFive[][2] = {
      {1, 0}, {0.309017, 0.951057}, {-0.809017, 0.587785}, {-0.809017, -0.587785}, {0.309017, -0.951057}};
  constexpr double kSix[][2] = {{1, 0},  {0.5, 0.866025},   {-0.5, 0.866025},
                                {-1, 0}, {-0.5, -0.866025}, {0.5, -0.866025}};
  for (int i = 0; i < corners; ++i) {
    Vec3<double> x = Vec3<double>::Zero();
    for (int j = 0; j < 2; ++j) x[j] = draw.coordinate(size);
    if (draw.coordinates != Coordinates::integers) x = Vec3<double>(decimals(x[0]), decimals(x[1]), 0);
    if (regular && corners == 5) x = Vec3<double>(kFive[i][0], kFive[i][1], 0);
    if (regular && corners == 6) x = Vec3<double>(kSix[i][0], kSix[i][1], 0);
    out.ring.push_back(x);
  }
  constexpr double kHeights[] = {0.5, 2, 10};
  out.half_height = kHeights[random.below(std::size(kHeights))];
  return out;
}

// The upper ring moved by `lean`.
Shape<double> upright(const Prism& prism, const Vec3<double>& lean) {
  std::vector<Vec3<double>> list;
  for (const Vec3<double>& x : prism.ring) {
    list.emplace_back(x[0], x[1], -prism.half_height);
    list.emplace_back(x[0] + lean[0], x[1] + lean[1], prism.half_height);
  }
  return Hull<double>(std::span<const Vec3<double>>(list));
}

// Lies along x in its own frame. A quaternion turns it upright, exactly or nearly.
void lay_down(Draw& draw, Body<double>& body, const Prism& prism, double unit) {
  Random& random = draw.random;
  std::vector<Vec3<double>> list;
  for (const Vec3<double>& x : prism.ring) {
    for (const double height : {-prism.half_height, prism.half_height}) list.emplace_back(height, x[0], x[1]);
  }
  body.shape = Hull<double>(std::span<const Vec3<double>>(list));
  // A quarter of a turn about y, after any turn about x: no entry is a round number.
  const double w = random.uniform(0.1, 1), x = random.once_in(2) ? 0 : random.uniform(-1, 1);
  const double lean[] = {random.uniform(-1, 1), random.uniform(-1, 1)};
  body.orientation = {w, x, -w, x};
  body.orientation.y += unit * lean[0];
  body.orientation.z += unit * lean[1];
}

void fill_level_prisms(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double unit = power_of_ten(-static_cast<int>(hardness));
  const Prism a = prism(draw, 2);
  Prism b = prism(draw, 2);
  if (!random.once_in(8)) b.half_height = a.half_height;
  Vec3<double> lean = Vec3<double>::Zero();
  for (int i = 0; i < 2; ++i) lean[i] = unit * random.uniform(-2, 2);
  const auto manner = random.below(6);
  problem.a.shape = upright(a, Vec3<double>::Zero());
  if (manner < 3) {
    problem.b.shape = upright(b, lean);
  } else if (manner == 3) {
    b = a;
    for (Vec3<double>& x : b.ring) {
      for (int i = 0; i < 2; ++i) x[i] += unit * random.uniform(-1, 1);
    }
    problem.b.shape = upright(b, Vec3<double>::Zero());
  } else {
    lay_down(draw, problem.b, b, unit);
  }
  if (random.once_in(3)) {
    for (int i = 0; i < 3; ++i) problem.a.position[i] = draw.coordinate(8);
  }

  Vec3<double> v = Vec3<double>::Zero();
  // Along the edges, any way, along an axis, or, mostly, level.
  const auto way = random.below(8);
  if (way != 0) {
    for (int i = 0; i < 2; ++i) v[i] = draw.coordinate(12);
  }
  if (way < 2) v[2] = random.once_in(2) ? 40 : -40;
  if (way == 2) v[random.integer(0, 1)] = 0;
  // Beside each other across the way, by at most the width of the bodies, level or nearly.
  const double width = random.once_in(3) ? 0.6 : 2.5;
  Vec3<double> beside = Vec3<double>::Zero();
  for (int i = 0; i < 2; ++i) beside[i] = random.uniform(-width, width);
  if (way == 1 && random.once_in(2)) beside[2] = random.uniform(-1, 1);
  const double t = meeting_time(random);
  meet(draw, problem, Vec3<double>::Zero(), Vec3<double>::Zero(), beside, v, t);
  draw_horizon(random, problem);
  maybe_swap(draw, problem);
}

constexpr double kLevelPrismsLevels[] = {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};

}  // namespace

const Family family::level_prisms{
    .name = "level_prisms",
    .sentence = "Prisms with level ends, whose edges are nearly parallel.",
    .hardness_meaning = "k: edges lean by 10^-k, for shapes of size 4",
    .levels = kLevelPrismsLevels,
    .fill = fill_level_prisms,
    .picture = {3, 1},
};

}  // namespace graze::corpus
