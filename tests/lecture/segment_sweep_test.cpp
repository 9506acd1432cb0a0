// The lecture says "a segment is not numerically stable with MPR", so a ray should not be swept into a
// segment but the shape be swept by it. This test shows the effect with numbers, and its reason:
//
//   A - (p + [0, 1] v)  =  (A - p) + [0, 1] (-v):     the two sweeps are the same set D, with the same
//   supports.
//
// Every portal that has corners from both ends of the sweep is unstable: the longer the path, the thinner.
// The time, t = 1 - d / |v|, d the penetration of D along -v, cancels all but u |v| of the path. core's sweep
// keeps v out of the set (portals of C alone, seen along v) and counts from the start of the path, so its
// error does not depend on |v|.
//
// The textbook MPR below is written after Snethen, XenoCollide (Game Programming Gems 7, 2008), with the
// lecture's first point v and its four steps.
#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <graze/cast.hpp>

#include <cstdio>

#include "tests/shared/globe.hpp"
#include "tests/shared/query_truth.hpp"

namespace graze {
namespace {

using namespace test;

struct Swept {
  const std::vector<Vec3<double>>& hull;
  Vec3<double> p, v;  // the ray's point and displacement

  [[nodiscard]] Vec3<double> of_hull(const Vec3<double>& n) const {
    const Vec3<double>* best = &hull[0];
    for (const Vec3<double>& x : hull) {
      if (n.dot(x) > n.dot(*best)) best = &x;
    }
    return *best;
  }
  // The segment as a shape of its own: one of its two ends.
  [[nodiscard]] Vec3<double> by_segment(const Vec3<double>& n) const {
    const Vec3<double> end = p + v;
    return of_hull(n) - (n.dot(end) < n.dot(p) ? end : p);
  }
  // The shape swept by the ray.
  [[nodiscard]] Vec3<double> by_shape(const Vec3<double>& n) const {
    const Vec3<double> x = of_hull(n) - p;
    return n.dot(v) < 0 ? Vec3<double>(x - v) : x;
  }
};

struct TextbookAnswer {
  bool hit = false, converged = false;
  double t = 0;
};

// MPR's penetration of D along -v, as t. `support` is D's.
template <class Support>
TextbookAnswer textbook_mpr(const Support& support, const Vec3<double>& v) {
  constexpr int kBudget = 200;
  const Vec3<double> v0 = v;
  Vec3<double> v1 = support(-v0);
  if (v1.dot(-v0) < 0) return {false, true};
  Vec3<double> n = v1.cross(v0);
  if (n.norm() == 0) return {true, true, 1 - v1.norm() / v.norm()};
  Vec3<double> v2 = support(n), v3;
  if (v2.dot(n) < 0) return {false, true};
  n = (v1 - v0).cross(v2 - v0);
  if (n.dot(v0) > 0) {
    std::swap(v1, v2);
    n = -n;
  }
  int i = 0;
  for (;; ++i) {
    if (i == kBudget) return {};
    v3 = support(n);
    if (v3.dot(n) < 0) return {false, true};
    if (v1.cross(v3).dot(v0) < 0) {
      v2 = v3;
    } else if (v3.cross(v2).dot(v0) < 0) {
      v1 = v3;
    } else {
      break;
    }
    n = (v1 - v0).cross(v2 - v0);
  }
  bool hit = false;
  for (;; ++i) {
    if (i >= 2 * kBudget) return {};
    n = (v2 - v1).cross(v3 - v1);
    hit = hit || n.dot(v1) >= 0;
    const Vec3<double> v4 = support(n);
    if (!hit && v4.dot(n) < 0) return {false, true};
    // On the surface: the new point is one that the portal has, or no farther out.
    if (!(n.dot(v4 - v1) > 1e-15 * n.norm() * v.norm())) break;
    const Vec3<double> c = v4.cross(v0);
    if (v1.dot(c) > 0) {
      (v2.dot(c) > 0 ? v1 : v3) = v4;
    } else {
      (v3.dot(c) > 0 ? v2 : v1) = v4;
    }
  }
  // d: where the ray along -v meets the portal's plane.
  const double d = n.dot(v1) / n.dot(-v) * v.norm();
  return {hit, true, 1 - d / v.norm()};
}

struct Tally {
  std::vector<double> errors;  // backward, over u scale
  int wrong = 0, stalled = 0;

  void add(const oracle::LinearTruth& truth, bool converged, bool hit, double t) {
    if (!converged || !std::isfinite(t)) {
      ++stalled;
    } else if (!hit) {
      ++wrong;
    } else {
      errors.push_back(truth.backward_error(std::max(t, 0.0)).low /
                       (kUnitRoundoff<double> * truth.scale().high));
    }
  }
  [[nodiscard]] double worst() const {
    return errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end());
  }
  [[nodiscard]] double median() {
    std::sort(errors.begin(), errors.end());
    return errors.empty() ? 0 : errors[errors.size() / 2];
  }
};

struct Row {
  Tally segment, shape, ours;
};

// 200 rays at a polytope of 47 vertices, from a distance of 3, of a length of `length`. Every ray hits.
Row measure(double length) {
  Draw draw{111};
  Row row;
  const Globe<double> g = globe<double>(5, 9, 1);
  const Body<double> hull{.shape = Hull<double>(std::span<const Vec3<double>>(g.vertices))};
  for (int round = 0; round < 200; ++round) {
    const Vec3<double> p = 3 * unit(draw.vector<double>(1));
    const Vec3<double> v = length * unit(Vec3<double>(draw.vector<double>(0.4) - p));
    const Body<double> ray{.shape = Point<double>{}, .position = p, .displacement = v};
    const oracle::LinearTruth truth(case_of(hull, ray));
    EXPECT_EQ(truth.outcome(), Outcome::hit);
    const Swept swept{g.vertices, p, v};
    const auto by_segment = textbook_mpr([&](const Vec3<double>& n) { return swept.by_segment(n); }, v);
    row.segment.add(truth, by_segment.converged, by_segment.hit, by_segment.t);
    const auto by_shape = textbook_mpr([&](const Vec3<double>& n) { return swept.by_shape(n); }, v);
    row.shape.add(truth, by_shape.converged, by_shape.hit, by_shape.t);
    const CastResult<double> r = cast_mpr_sweep(hull, ray);
    row.ours.add(truth, r.outcome != Outcome::not_converged, r.outcome == Outcome::hit, r.toi_lower);
  }
  return row;
}

TEST(SegmentSweep, ErrorGrowsWithTheLengthOfTheRayAndOursDoesNot) {
  double before = 0;
  for (const double length : {8.0, 8e2, 8e4, 8e6, 8e8}) {
    Row row = measure(length);
    std::printf(
        "|v| %8.0e   segment: median %9.2g worst %9.2g u scale, %3d wrong %3d stalled   "
        "swept shape: %9.2g %9.2g, %3d %3d   ours: %5.2g %5.2g, %d %d\n",
        length, row.segment.median(), row.segment.worst(), row.segment.wrong, row.segment.stalled,
        row.shape.median(), row.shape.worst(), row.shape.wrong, row.shape.stalled, row.ours.median(),
        row.ours.worst(), row.ours.wrong, row.ours.stalled);
    EXPECT_EQ(row.ours.wrong + row.ours.stalled, 0);
    EXPECT_LE(row.ours.worst(), 8) << "u scale, whatever the length";
    if (length >= 8e4) {
      EXPECT_GT(row.segment.worst(), length / 64) << "u |v|: what 1 - d / |v| leaves";
      EXPECT_GT(row.segment.median(), before);
    }
    before = row.segment.median();
  }
}

TEST(SegmentSweep, BothSweepsAreTheSameSet) {
  Draw draw{112};
  const Globe<double> g = globe<double>(5, 9, 1);
  for (int round = 0; round < 200; ++round) {
    // Whole numbers over 1024, so that every sum is exact.
    const Vec3<double> p = lattice_point<double>(draw, 4096) / 1024,
                       v = lattice_point<double>(draw, 65536) / 1024;
    std::vector<Vec3<double>> hull;
    for (const Vec3<double>& x : g.vertices) hull.push_back((x * 1024).array().round().matrix() / 1024);
    const Swept swept{hull, p, v};
    const Vec3<double> n = lattice_point<double>(draw, 1000);
    EXPECT_EQ(n.dot(swept.by_segment(n)), n.dot(swept.by_shape(n)));
  }
}

}  // namespace
}  // namespace graze
