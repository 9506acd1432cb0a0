// Large hulls for the tests and the benchmark of the climb: what its cost and its ties depend on.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <graze/scalar.hpp>
#include <numbers>
#include <vector>

#include "tests/shared/generate.hpp"

namespace graze::test {

enum class Family {
  sphere,           // points on the unit sphere, random
  cylinder,         // two rings: caps of exact ties, sides of four exactly coplanar points
  turned_cylinder,  // the same, rotated and rounded: ties off by an ulp
  lattice_ball,     // integer points of a ball: flat faces, interior points
  needle,           // the sphere, 2^-24 thin across x
  plate,            // the sphere, 2^-24 thin along z
  cone,             // one ring and an apex whose degree is all of it
  cluster,          // corners of a cube, each a cloud of a few ulps
};
inline constexpr Family kFamilies[] = {Family::sphere,       Family::cylinder, Family::turned_cylinder,
                                       Family::lattice_ball, Family::needle,   Family::plate,
                                       Family::cone,         Family::cluster};

template <class S>
std::vector<Vec3<S>> large_hull(Family family, int vertices, std::uint64_t seed) {
  Draw draw{seed};
  const Mat3<double> turned =
      Eigen::AngleAxis<double>(0.7, Vec3<double>(1, 2, 3).normalized()).toRotationMatrix();
  const double u = std::numeric_limits<S>::epsilon();
  // The least radius whose ball holds enough integer points.
  const int reach = static_cast<int>(std::ceil(std::cbrt(vertices / 4.1888)));
  std::vector<Vec3<S>> out;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * (i / 2) / (vertices / 2);
    const double once = 2 * std::numbers::pi * i / vertices;
    const Vec3<double> ring(std::cos(angle), std::sin(angle), i % 2 ? 1 : -1);
    Vec3<double> p = draw.vector<double>(1).normalized();
    switch (family) {
      case Family::sphere:
        break;
      case Family::cylinder:
        p = ring;
        break;
      case Family::turned_cylinder:
        p = turned * ring;
        break;
      case Family::lattice_ball:
        p = (reach * std::cbrt(draw.between(0, 1)) * p).array().round();
        break;
      case Family::needle:
        p = p.cwiseProduct(Vec3<double>(1, 0x1p-24, 0x1p-24));
        break;
      case Family::plate:
        p[2] *= 0x1p-24;
        break;
      case Family::cone:
        p = i == 0 ? Vec3<double>(0.1, 0.2, 1) : Vec3<double>(std::cos(once), std::sin(once), 0);
        break;
      case Family::cluster:
        for (int k = 0; k < 3; ++k)
          p[k] = (draw.bits() & 1 ? 1 : -1) * (1 + u * static_cast<double>(draw.bits() % 8));
        break;
    }
    out.push_back(p.template cast<S>());
  }
  return out;
}

}  // namespace graze::test
