// The Nef polyhedra of nef_minkowski.cpp, nef_hull.cpp and nef_sum.cpp, which alone include this: CGAL stays in
// those three. A kernel of plain rationals, not a filtered one, since that doubles what the compiler needs.
#pragma once

#include <CGAL/Cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <vector>

namespace graze::oracle {

using NefKernel = CGAL::Cartesian<CGAL::Gmpq>;
using Nef = CGAL::Nef_polyhedron_3<NefKernel>;
using NefPoints = std::vector<NefKernel::Point_3>;

// The hull of the points, in the dimension that it has.
[[nodiscard]] Nef nef_hull(const NefPoints& points);

// The Minkowski sum. CGAL's takes both by reference and may change how they are decomposed.
[[nodiscard]] Nef nef_sum(Nef& a, Nef& b);

}  // namespace graze::oracle
