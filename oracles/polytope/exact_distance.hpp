// Exact squared distances of points and of a line from a convex hull, by its features.
#pragma once

#include <optional>

#include "oracles/polytope/exact_cso.hpp"

namespace graze::oracle {

enum class Nearest { inside, facet, edge, vertex };

struct PointDistance {
  Rational distance_sq;
  Nearest feature = Nearest::inside;
  int index = 0;  // of the facet, edge or vertex whose affine hull holds the nearest point
};

// The interval {s : base + s v in hull}, v != 0. Nothing if it is empty.
struct LineInterval {
  Rational in, out;
};

struct LineDistance {
  Rational distance_sq;  // the least over s in R of the squared distance of s v from the hull
  Rational first;        // the least s that attains it
};

using Guess = std::array<double, 3>;  // a vector in doubles: it orders candidates and decides nothing

// A hull prepared for repeated questions.
class HullDistance {
 public:
  explicit HullDistance(ConvexHull hull);

  [[nodiscard]] const ConvexHull& hull() const { return hull_; }

  [[nodiscard]] bool contains(const HomogeneousPoint& p) const;
  [[nodiscard]] PointDistance from_point(const HomogeneousPoint& p) const;
  [[nodiscard]] std::optional<LineInterval> clip_line(const HomogeneousPoint& base, const IntVec& v) const;
  [[nodiscard]] LineDistance from_line(const IntVec& v) const;  // the line through the origin, v != 0

 private:
  // The vectors w (p - vertex), exact: every candidate feature is tested on them.
  using Relative = std::vector<IntVec>;
  using Candidate = std::optional<PointDistance>;
  [[nodiscard]] Candidate try_facet(const Integer& w, const Relative& relative, int facet) const;
  [[nodiscard]] Candidate try_edge(const Integer& w, const Relative& relative, int edge) const;
  [[nodiscard]] Candidate try_vertex(const Integer& w, const Relative& relative, int vertex) const;
  // Does the vertex attain the maximum of direction.c over the hull?
  [[nodiscard]] bool supports(const IntVec& direction, int vertex) const;

  ConvexHull hull_;
  std::vector<Guess> unit_normals_;  // of the facets, rounded: only for guesses
};

}  // namespace graze::oracle
