// Searches over a convex set K given by its support function, in ball arithmetic: nearest point, least depth,
// first point on a line. Searches compare midpoints. Their results are enclosed, and hold whatever path the
// search took.
//
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "oracles/arithmetic/ball.hpp"

namespace graze::oracle {

// A point of K = {a - b + ball(m) - s v : s in [0, sweep]}, and h(n) for the direction that found it.
struct CsoPoint {
  Ball reach;     // holds h(n)
  BallVec point;  // holds a point of K
  BallVec a, b;   // hold points of A and of B at t = 0, in world axes
  Ball s;         // exact
};

using ConvexSet = std::function<CsoPoint(const BallVec& n)>;

// Points of K and weights >= 0 that are not all 0: their combination lies in K.
struct Combination {
  std::vector<CsoPoint> points;
  std::vector<Ball> weights;  // exact, not normalised
  [[nodiscard]] BallVec of(const BallVec CsoPoint::*what) const;
};

// The distance of the origin from K: lower <= dist <= upper, exact balls.
struct Nearest3 {
  Ball lower, upper;
  BallVec axis;         // proves `lower`: h(axis) <= -lower |axis|
  Combination inner;    // proves `upper`
  Ball least_reach;     // the origin is no deeper in K than this (exact, >= 0)
  bool around = false;  // four points that hold the origin, up to `shift`: K may have it inside
  int supports = 0;
};

struct NearestGoal {
  Ball absolute = {}, relative = {};  // stop when upper - lower is below either
  bool until_separated = false;       // or when lower > 0
  int max_supports = 600;
};

// `shift` is a tiny vector, or zero. The search runs about it instead of the origin, so that ties do not
// arise.
[[nodiscard]] Nearest3 nearest(const ConvexSet& set, const BallVec& shift, const NearestGoal& goal);

// The depth of the origin in K, the distance from the complement of K: lower <= depth <= upper, exact balls.
// A positive lower bound proves that the origin is inside.
struct Depth3 {
  Ball lower, upper;
  BallVec axis;  // h(axis) <= upper |axis|
  int supports = 0;
};

struct DepthGoal {
  Ball absolute = {}, relative = {};  // stop when upper - lower is below absolute, or below relative * upper
  int max_supports = 600;
};

// From four points of K whose hull has the origin inside, up to a tiny shift.
[[nodiscard]] Depth3 least_depth(const ConvexSet& set, const std::vector<CsoPoint>& start,
                                 const DepthGoal& goal);

// The least t with t v in K, for a line known to pass through its inside.
struct FirstOnLine {
  Ball lower;         // exact: t >= lower for every t v in K
  BallVec axis;       // proves it, with n.v < 0
  Combination inner;  // a point of K: (height) v, off the line by no more than `off`
  Ball height, off;   // exact, height rounded up
  int supports = 0;
};

struct LineGoal {
  Ball absolute = {};    // stop when (height - lower) |v| is below
  Ball far_behind = {};  // or when height is below this time: the start is in contact
  int max_supports = 800;
};

// `start`: points of K, three of which hold `shift` between them when seen along v. Nothing if none do.
[[nodiscard]] std::optional<FirstOnLine> first_on_line(const ConvexSet& set, const BallVec& v,
                                                       const std::vector<CsoPoint>& start,
                                                       const BallVec& shift, const LineGoal& goal);

}  // namespace graze::oracle
