// CGAL's sum, compiled by itself: it decomposes both bodies into convex parts, and takes the compiler as much
// time and memory as all the rest. The polyhedra come first: CGAL's header of sums does not stand alone.
#include "oracles/polytope/nef_kernel.hpp"

#include <CGAL/minkowski_sum_3.h>

namespace graze::oracle {

Nef nef_sum(Nef& a, Nef& b) { return CGAL::minkowski_sum_3(a, b); }

}  // namespace graze::oracle
