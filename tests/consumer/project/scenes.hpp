// Pseudo-random casts, the same bits everywhere: integers, divided by powers of two.
//
// Only powers of two multiply, so no contracted multiply-add changes a bit, and a scene times a power of two
// is the same question.
#pragma once

#include <cmath>
#include <cstdint>
#include <graze/cast.hpp>
#include <vector>

// splitmix64 [Steele, Lea, Flood 2014]
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  int integer(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

template <class S>
struct Scene {
  graze::Body<S> a, b;
  S t_max = 1, target_distance = 0;
};

// Makes the numbers of a scene: small integers, where everything ties, or 20 bits, where nothing does.
class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random_(seed), ties_(random_.integer(0, 3) == 0) {}

  template <class S>
  Scene<S> scene() {
    Scene<S> out;
    out.a = body<S>();
    out.b = body<S>();
    const S wide = std::ldexp(S(1), random_.integer(0, 3) == 0 ? random_.integer(1, 9) : 0);
    out.a.shape = shape<S>(wide);
    out.b.shape = shape<S>(S(1));
    out.b.position *= wide;
    // Towards a, and past it by a shape's size: most paths hit, some graze, some miss.
    const graze::Vec3<S> aside = vector<S>();
    out.b.displacement = S(2) * (out.a.position - out.b.position) + aside;
    if (random_.integer(0, 7) == 0) out.b.displacement = vector<S>();
    if (random_.integer(0, 31) == 0) out.b.displacement.setZero();
    if (random_.integer(0, 5) == 0) out.b.position = out.a.position + vector<S>() / 8;
    if (random_.integer(0, 7) == 0) out.t_max = std::numeric_limits<S>::infinity();
    if (random_.integer(0, 7) == 0) out.target_distance = extent<S>() / 4;
    return out;
  }

 private:
  // In [-4, 4].
  template <class S>
  S coordinate() {
    return ties_ ? S(random_.integer(-4, 4)) : S(random_.integer(-(1 << 20), 1 << 20)) / S(1 << 18);
  }
  // In (0, 2].
  template <class S>
  S extent() {
    return ties_ ? S(random_.integer(1, 4)) / 2 : S(random_.integer(1, 1 << 20)) / S(1 << 19);
  }
  template <class S>
  graze::Vec3<S> vector() {
    const S x = coordinate<S>(), y = coordinate<S>(), z = coordinate<S>();
    return {x, y, z};
  }
  template <class S>
  graze::Body<S> body() {
    graze::Body<S> out;
    out.position = vector<S>();
    if (random_.integer(0, 1) == 0) {
      out.orientation = {coordinate<S>(), coordinate<S>(), coordinate<S>(), coordinate<S>()};
      if (out.orientation.is_identity()) out.orientation = {1, 1, 0, 0};
    }
    return out;
  }
  template <class S>
  graze::Shape<S> shape(S size) {
    switch (random_.integer(0, 6)) {
      case 0:
        return graze::Point<S>{};
      case 1:
        return graze::Sphere<S>{size * extent<S>()};
      case 2:
      case 3: {
        const S x = extent<S>(), y = extent<S>(), z = extent<S>();
        return graze::Box<S>{size * graze::Vec3<S>(x, y, z)};
      }
      default:
        break;
    }
    std::vector<graze::Vec3<S>> vertices;
    for (int n = random_.integer(1, 16); n > 0; --n) vertices.push_back(size / 2 * vector<S>());
    return graze::Hull<S>(std::span<const graze::Vec3<S>>(vertices));
  }

  Random random_;
  bool ties_;
};

// The scene with all lengths times 2^exponent: the same question, the same times.
template <class S>
graze::Shape<S> scaled(const graze::Shape<S>& shape, S factor) {
  if (const auto* sphere = std::get_if<graze::Sphere<S>>(&shape)) {
    return graze::Sphere<S>{factor * sphere->radius};
  }
  if (const auto* box = std::get_if<graze::Box<S>>(&shape)) {
    return graze::Box<S>{factor * box->half_extents};
  }
  if (const auto* hull = std::get_if<graze::Hull<S>>(&shape)) {
    std::vector<graze::Vec3<S>> vertices;
    for (const graze::Vec3<S>& v : hull->vertices()) vertices.push_back(factor * v);
    return graze::Hull<S>(std::span<const graze::Vec3<S>>(vertices));
  }
  return shape;
}
template <class S>
Scene<S> scaled(const Scene<S>& scene, int exponent) {
  const S factor = std::ldexp(S(1), exponent);
  Scene<S> out = scene;
  for (graze::Body<S>* body : {&out.a, &out.b}) {
    body->shape = scaled(body->shape, factor);
    body->position *= factor;
    body->displacement *= factor;
  }
  out.target_distance *= factor;
  return out;
}
