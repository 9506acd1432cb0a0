// The Nef polyhedra of nef_minkowski.cpp and nef_sum.cpp, which alone include this: CGAL stays in those two. A
// kernel of plain rationals, not a filtered one, since that doubles what the compiler needs.
#pragma once

#include <CGAL/Cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Nef_polyhedron_3.h>

namespace graze::oracle {

using NefKernel = CGAL::Cartesian<CGAL::Gmpq>;
using Nef = CGAL::Nef_polyhedron_3<NefKernel>;

// The Minkowski sum. CGAL's takes both by reference and may change how they are decomposed.
[[nodiscard]] Nef nef_sum(Nef& a, Nef& b);

}  // namespace graze::oracle
