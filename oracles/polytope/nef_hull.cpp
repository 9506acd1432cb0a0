// The hull of points as a Nef polyhedron, compiled by itself: its constructors are half of what CGAL's Nef
// polyhedra cost the compiler.
#include "oracles/polytope/nef_kernel.hpp"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/Projection_traits_xz_3.h>
#include <CGAL/Projection_traits_yz_3.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>

namespace graze::oracle {
namespace {

using Kernel = NefKernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// The convex polygon of coplanar points, in order: their hull as seen along an axis that the plane does not
// contain.
template <class Projection>
Nef polygon(const NefPoints& points) {
  NefPoints loop;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(loop), Projection());
  return Nef(loop.begin(), loop.end());
}

}  // namespace

Nef nef_hull(const NefPoints& points) {
  const auto ends = std::minmax_element(points.begin(), points.end());
  const auto least = ends.first, most = ends.second;
  if (*least == *most) return Nef(*least);
  const auto off_line = std::find_if(points.begin(), points.end(),
                                     [&](const auto& p) { return !CGAL::collinear(*least, *most, p); });
  if (off_line == points.end()) return Nef(Kernel::Segment_3(*least, *most));
  if (std::all_of(points.begin(), points.end(),
                  [&](const auto& p) { return CGAL::coplanar(*least, *most, *off_line, p); })) {
    const Kernel::Vector_3 n = CGAL::cross_product(*most - *least, *off_line - *least);
    if (n.z() != 0) return polygon<CGAL::Projection_traits_xy_3<Kernel>>(points);
    if (n.y() != 0) return polygon<CGAL::Projection_traits_xz_3<Kernel>>(points);
    return polygon<CGAL::Projection_traits_yz_3<Kernel>>(points);
  }
  Polyhedron hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return Nef(hull);
}

}  // namespace graze::oracle
