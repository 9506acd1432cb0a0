// A good axis between two convex shapes, in double: a guess that claims nothing, for proofs to start from.
#pragma once

#include "corpus/case.hpp"

namespace graze::oracle {

// x -> turn x of a shape's own frame. The shapes' origins lie `between` apart, B's from A's.
struct PlacedShapes {
  const Shape<double>& a;
  const Shape<double>& b;
  Mat3<double> turn_a, turn_b;
  Vec3<double> between;
  double rounding = 0;  // the target distance
  int exponent = 0;     // lengths are about 2^exponent
};

struct AxisGuess {
  bool apart = false;
  Vec3<double> axis = Vec3<double>::Zero();  // unit up to rounding, from A to B
  double upper = 0;                          // of the distance, up to rounding
};

// `start`: an axis to begin with, any but zero. Stops where the axis shows 7/8 of the distance.
[[nodiscard]] AxisGuess guess_axis(const PlacedShapes& pair, const Vec3<double>& start);

}  // namespace graze::oracle
