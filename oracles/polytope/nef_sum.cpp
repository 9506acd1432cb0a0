// CGAL's sum, compiled by itself: it decomposes both bodies into convex parts, and takes the compiler as much
// time and memory as all the rest.
#include <CGAL/minkowski_sum_3.h>

#include "oracles/polytope/nef_kernel.hpp"

namespace graze::oracle {

Nef nef_sum(Nef& a, Nef& b) { return CGAL::minkowski_sum_3(a, b); }

}  // namespace graze::oracle
