// A pair of bodies as a case for the exact oracle, and random pairs for the queries.
#pragma once

#include "oracles/truth/linear_truth.hpp"
#include "tests/shared/generate.hpp"

namespace graze::test {

template <class S>
Vec3<double> widened(const Vec3<S>& v) {
  return v.template cast<double>();
}

// The same numbers in double. Points, spheres, boxes and hulls.
template <class S>
Body<double> widened(const Body<S>& body) {
  Body<double> out;
  out.position = widened<S>(body.position);
  out.displacement = widened<S>(body.displacement);
  out.orientation = {body.orientation.w, body.orientation.x, body.orientation.y, body.orientation.z};
  if (const auto* box = std::get_if<Box<S>>(&body.shape))
    out.shape = Box<double>{widened<S>(box->half_extents)};
  if (const auto* ball = std::get_if<Sphere<S>>(&body.shape)) out.shape = Sphere<double>{ball->radius};
  if (const auto* hull = std::get_if<Hull<S>>(&body.shape)) {
    std::vector<Vec3<double>> v;
    for (const Vec3<S>& x : hull->vertices()) v.push_back(widened<S>(x));
    out.shape = Hull<double>(std::span<const Vec3<double>>(v));
  }
  return out;
}

template <class S>
corpus::Case case_of(const Body<S>& a, const Body<S>& b) {
  corpus::Case out;
  out.a = widened(a);
  out.b = widened(b);
  return out;
}

// The families of pairs, in contact more often than not, with coordinates of order 1.
enum class Pairs { hulls, boxes, lattice, flat, balls };
inline constexpr Pairs kPairs[] = {Pairs::hulls, Pairs::boxes, Pairs::lattice, Pairs::flat, Pairs::balls};
inline const char* name(Pairs pairs) {
  constexpr const char* kNames[] = {"hulls", "boxes", "lattice", "flat", "balls"};
  return kNames[static_cast<int>(pairs)];
}

template <class S>
Vec3<S> lattice_point(Draw& draw, int size) {
  Vec3<S> out;
  for (int i = 0; i < 3; ++i) {
    out[i] = static_cast<S>(static_cast<int>(draw.bits() % static_cast<unsigned>(2 * size + 1)) - size);
  }
  return out;
}

template <class S>
Hull<S> lattice_hull(Draw& draw, int vertices, int size, bool flat) {
  std::vector<Vec3<S>> v;
  for (int i = 0; i < vertices; ++i) {
    v.push_back(lattice_point<S>(draw, size));
    if (flat) v.back()[2] = 0;
  }
  return Hull<S>(std::span<const Vec3<S>>(v));
}

template <class S>
std::pair<Body<S>, Body<S>> draw_pair(Draw& draw, Pairs pairs, int round) {
  Body<S> a, b;
  b.position = draw.vector<S>(0.6);
  switch (pairs) {
    case Pairs::hulls:
      a.shape = draw.hull<S>(4 + round % 9, 1);
      b.shape = draw.hull<S>(4 + round % 5, 1);
      a.orientation = draw.turn<S>();
      b.orientation = draw.turn<S>();
      break;
    case Pairs::boxes:
      a.shape = Box<S>{draw.vector<S>(1).cwiseAbs()};
      b.shape = Box<S>{draw.vector<S>(1).cwiseAbs()};
      if (round % 2) b.orientation = draw.turn<S>();
      break;
    case Pairs::lattice:
      a.shape = lattice_hull<S>(draw, 4 + round % 9, 2, false);
      b.shape = lattice_hull<S>(draw, 1 + round % 6, 1 + round % 2, false);
      b.position = lattice_point<S>(draw, 2);
      break;
    case Pairs::flat:
      a.shape = lattice_hull<S>(draw, 1 + round % 6, 2, round % 3 != 0);
      b.shape = lattice_hull<S>(draw, 1 + round % 4, 2, true);
      b.position = round % 4 == 0 ? lattice_point<S>(draw, 1) : Vec3<S>(Vec3<S>::Zero());
      break;
    case Pairs::balls:
      a.shape = draw.hull<S>(1 + round % 9, 1);
      b.shape = Sphere<S>{static_cast<S>(draw.between(0.1, 1))};
      b.position = draw.vector<S>(1.2);
      break;
  }
  return {a, b};
}

}  // namespace graze::test
