// The convex hull of integer points, in whatever dimension it has, with its faces and its half-spaces.
#pragma once

#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

// {x : normal.x <= offset}
struct HalfSpace {
  IntVec normal;
  Integer offset;
};

// A polygon of the boundary: a triangle of a solid (several of them may be coplanar), or one side of a flat
// hull.
struct HullFacet {
  int half_space = 0;     // its plane, normal outward
  std::vector<int> loop;  // vertices, counter-clockwise about the normal
  std::vector<IntVec>
      outward;  // outward[i]: in the plane, perpendicular to the edge from loop[i] to loop[i + 1]
};

struct HullEdge {
  int from = 0, to = 0;
  std::array<int, 2>
      facets{};      // the facets that meet in it (both sides of a flat hull, unused for a segment)
  IntVec direction;  // to - from
};

struct ConvexHull {
  int dimension = 0;
  std::vector<IntVec> vertices;   // every extreme point, and maybe other given points in a solid's flat face
  std::vector<HullEdge> edges;    // every edge, including diagonals between coplanar triangles
  std::vector<HullFacet> facets;  // solids and polygons
  std::vector<HalfSpace> half_spaces;  // their intersection is the hull, in every dimension
};

// points is not empty. Duplicates are allowed.
[[nodiscard]] ConvexHull convex_hull(std::vector<IntVec> points);

}  // namespace graze::oracle
