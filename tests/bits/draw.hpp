// Pairs of bodies for the digests, of integers times powers of two.
#pragma once

#include <graze/rotating_body.hpp>

namespace graze::bits {

// splitmix64 (Steele, Lea, Flood 2014).
struct Random {
  std::uint64_t state;
  std::uint64_t operator()() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  int below(int n) { return static_cast<int>((*this)() % static_cast<unsigned>(n)); }
};

struct Kind {
  std::uint64_t seed;
  int reach;     // coordinates are integers up to this
  int exponent;  // times 2^exponent
  bool turned;
  int leaves;       // how many of the kinds of leaf are drawn: polytopes, then round, then curved ones
  int scatter = 0;  // the exponents of a case's lengths and speed vary by so many
  bool combined = false;
};
inline constexpr int kPolytopes = 6, kRound = 8, kAll = 11;
inline constexpr Kind kKinds[] = {
    {1, 2, 0, false, kPolytopes},  {2, 2, 0, true, kPolytopes},     {3, 1 << 20, -18, true, kPolytopes},
    {4, 2, 0, false, kRound},      {5, 1 << 20, -18, true, kRound}, {6, 2, 0, true, kAll},
    {7, 1 << 20, -18, true, kAll}, {8, 3, 0, true, kAll, 0, true},  {9, 1 << 18, -16, true, kAll, 30},
};

template <Scalar S>
class Draw {
 public:
  explicit Draw(const Kind& kind) : kind_(kind), random_{kind.seed} {}

  std::pair<RotatingBody<S>, RotatingBody<S>> pair() {
    const auto scattered = [&] {
      return kind_.scatter > 0 ? random_.below(2 * kind_.scatter) - kind_.scatter : 0;
    };
    const int up = scattered() / (sizeof(S) == 8 ? 1 : 3),
              faster = up + (random_.below(2) == 0 ? 0 : scattered() / 3);
    const double length = power_of_two(kind_.exponent + up), speed = power_of_two(kind_.exponent + faster);
    unit_ = length;
    RotatingBody<S> a, b;
    for (RotatingBody<S>* one : {&a, &b}) {
      one->body.shape = shape();
      if (kind_.turned) one->body.orientation = turn();
      // About one radian in a unit of time, or none.
      for (int i = 0; i < 3; ++i) {
        if (random_.below(3) != 0) one->rotation[i] = static_cast<S>((random_.below(33) - 16) * 0.0625);
      }
      if (random_.below(2) == 0) one->pivot = vector(kind_.reach);
    }
    unit_ = speed;
    b.body.displacement = vector(kind_.reach);
    if (random_.below(3) == 0) b.body.displacement[random_.below(3)] = 0;
    unit_ = length;
    // Half of the bodies are aimed: the middles meet near t = 2.
    b.body.position = vector(2 * kind_.reach);
    if (random_.below(2) == 0 && speed == length) {
      b.body.position = vector(kind_.reach) - S(2) * b.body.displacement;
    }
    return {a, b};
  }
  S length() { return std::abs(number(kind_.reach)); }

 private:
  S number(int reach) { return static_cast<S>((random_.below(2 * reach + 1) - reach) * unit_); }
  Vec3<S> vector(int reach) {
    const S x = number(reach), y = number(reach), z = number(reach);
    return {x, y, z};
  }
  Shape<S> shape() {
    if (!kind_.combined) return leaf();
    const Vec3<S> by = vector(kind_.reach);
    const Quaternion<S> inner = turn();
    Shape<S> first = leaf();
    Shape<S> second = posed<S>(leaf(), by, inner);
    switch (random_.below(3)) {
      case 0:
        return sum<S>(std::move(first), std::move(second));
      case 1:
        return hull_of<S>(std::move(first), std::move(second));
      default:
        return rounded<S>(std::move(second), length());
    }
  }
  Shape<S> leaf() {
    const int reach = kind_.reach;
    switch (random_.below(kind_.leaves)) {
      case 0: {
        const Vec3<S> a = vector(reach), b = vector(reach);
        return Segment<S>{a, b};
      }
      case 1: {
        const Vec3<S> a = vector(reach), b = vector(reach), c = vector(reach);
        return Triangle<S>{a, b, c};
      }
      case 2:
      case 3:
        return Box<S>{vector(reach).cwiseAbs()};
      case 6:
        return Sphere<S>{length()};
      case 7: {
        const S radius = length(), half_height = length();
        return Capsule<S>{radius, half_height};
      }
      case 8:
        return Ellipsoid<S>{vector(reach).cwiseAbs()};
      case 9: {
        const S radius = length(), half_height = length();
        return Cylinder<S>{radius, half_height};
      }
      case 10: {
        const S radius = length(), half_height = length();
        return Cone<S>{radius, half_height};
      }
      default:
        break;
    }
    std::vector<Vec3<S>> vertices(
        static_cast<std::size_t>(random_.below(9) == 0 ? 200 : 4 + random_.below(60)));
    for (Vec3<S>& v : vertices) v = vector(reach);
    return Hull<S>(std::span<const Vec3<S>>(vertices));
  }
  Quaternion<S> turn() {
    const auto small = [&] { return static_cast<S>(random_.below(9) - 4); };
    const S w = small(), x = small(), y = small(), z = small();
    return w == 0 && x == 0 && y == 0 && z == 0 ? Quaternion<S>{} : Quaternion<S>{w, x, y, z};
  }

  Kind kind_;
  Random random_;
  double unit_ = 1;
};

}  // namespace graze::bits
