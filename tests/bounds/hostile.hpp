// Hostile inputs for the tests of bounds: pairs of rotating bodies that the bounds were not written for, and
// directions to look along. The draw is seeded, so a failure is reproducible. hostile_test.cpp tests the
// distribution.
//
// A scene is drawn ordinary first and then made hostile in a few ways at once: each class below has its own
// chance, so they also occur together. Every scene passes validation: magnitudes of 0 or 1e-60 to 1e60, at
// most 2^30 radians within t_end.
#pragma once

#include <Eigen/Geometry>
#include <graze/detail/numeric/offset.hpp>
#include <graze/rotating_body.hpp>
#include <string_view>

#include "tests/shared/generate.hpp"

namespace graze::test {

enum class Hostile : unsigned {
  equal_spins,            // both rotate by the same w
  spins_an_ulp_apart,     // or by one that differs in last places
  equal_pivots,           // in the world, within the rounding of doubles
  pivots_an_ulp_apart,    // by some last places
  pivots_along_axis,      // by a multiple of w, nearly
  far_in_own_frame,       // vertices 1e6 to 2^40 out in their own frame
  far_from_origin,        // positions 1e6 to 2^40
  long_arm,               // pivots 1e6 to 2^40 from the body
  pivot_along_own_spin,   // a long arm that is nearly the axis of rotation
  mixed_magnitudes,       // 1e-57 beside 1e57
  fast_spin,              // up to 2^30 radians
  slow_spin,              // down to 1e-57
  at_rest,                // one body does not rotate
  axis_near_coordinate,   // w along a coordinate axis, except in last places
  own_axis_spin,          // a solid of revolution about its own axis, nearly
  zero_extent,            // flat in some direction
  permuting_orientation,  // axes to axes
  odd_orientation,        // components of many sizes, or one last place off one that permutes
  ball_by_another_name,   // ellipsoids of equal radii, capsules of no length, rounded points
  combinator,             // sums, hulls and poses of parts
  cancelling_parts,       // parts put far out and rotated back
  moves_as_one,           // equal displacements
};
inline constexpr unsigned kHostileClasses = 22;
inline constexpr std::array<std::string_view, kHostileClasses> kHostileNames = {"equal spins",
                                                                                "spins an ulp apart",
                                                                                "equal pivots",
                                                                                "pivots an ulp apart",
                                                                                "pivots along axis",
                                                                                "far in own frame",
                                                                                "far from origin",
                                                                                "long arm",
                                                                                "pivot along own spin",
                                                                                "mixed magnitudes",
                                                                                "fast spin",
                                                                                "slow spin",
                                                                                "at rest",
                                                                                "axis near coordinate",
                                                                                "own axis spin",
                                                                                "zero extent",
                                                                                "permuting orientation",
                                                                                "odd orientation",
                                                                                "ball by another name",
                                                                                "combinator",
                                                                                "cancelling parts",
                                                                                "moves as one"};

struct HostileScene {
  RotatingBody<double> a, b;
  double target = 0, t_end = 1;
  std::uint32_t classes = 0;

  [[nodiscard]] bool is(Hostile one) const { return (classes >> static_cast<unsigned>(one) & 1u) != 0; }
};

class HostileDraw {
 public:
  explicit HostileDraw(std::uint64_t seed) : draw_{seed} {}

  [[nodiscard]] HostileScene scene() {
    HostileScene out;
    scene_ = &out;
    out.t_end = chance(0.5) ? 1.0 : power(-3, 3);
    double size_a = 1, size_b = 1;
    if (flag(Hostile::mixed_magnitudes, 0.12)) {
      size_a = power(-165, -60);
      size_b = chance(0.5) ? power(60, 150) : 1.0;
      if (chance(0.5)) std::swap(size_a, size_b);
    }
    out.a = body(size_a);
    out.b = body(size_b);
    relate();
    if (chance(0.3)) out.target = power(-10, 3);
    for (RotatingBody<double>* body : {&out.a, &out.b}) admit(*body);
    return out;
  }

  // Unit up to rounding, and hostile to the scene: along a spin, an own axis, between the pivots.
  [[nodiscard]] Vec3<double> direction(const HostileScene& scene) {
    const RotatingBody<double>& body = chance(0.5) ? scene.a : scene.b;
    Vec3<double> n = draw_.vector<double>(1);
    switch (below(8)) {
      case 0:
        n = Vec3<double>::Unit(static_cast<int>(below(3)));
        break;
      case 1:
        n = unit(body.rotation);
        break;
      case 2:
        n = nudged(unit(body.rotation));
        break;
      case 3:
        n = unit(body.rotation) + power(-50, -5) * draw_.vector<double>(1);
        break;
      case 4:
        n = unit(body.rotation).cross(n);
        break;
      case 5:
        n = detail::rotation_matrix(body.body.orientation).col(2);
        break;
      case 6:
        n = unit(Vec3<double>(scene.b.body.position - scene.a.body.position));
        break;
      default:
        break;
    }
    if (!(n.cwiseAbs().maxCoeff() > 0)) n = Vec3<double>::UnitX();
    return chance(0.5) ? unit(n) : Vec3<double>(-unit(n));
  }
  // A time in [0, t_end], its ends among them.
  [[nodiscard]] double time(const HostileScene& scene) {
    switch (below(6)) {
      case 0:
        return 0;
      case 1:
        return scene.t_end;
      case 2:
        return scene.t_end * power(-40, 0);
      default:
        return scene.t_end * draw_.between(0, 1);
    }
  }

  [[nodiscard]] bool chance(double p) { return draw_.between(0, 1) < p; }
  [[nodiscard]] double power(double low, double high) { return std::exp2(draw_.between(low, high)); }
  [[nodiscard]] std::uint64_t below(std::uint64_t n) { return draw_.bits() % n; }
  [[nodiscard]] Draw& plain() { return draw_; }
  // Some last places off, in some components.
  [[nodiscard]] Vec3<double> nudged(Vec3<double> x) {
    for (int i = 0; i < 3; ++i) x[i] = nudged(x[i]);
    return x;
  }
  [[nodiscard]] double nudged(double x) {
    for (std::uint64_t steps = below(4); steps > 0 && x != 0; --steps) {
      x = std::nextafter(x, chance(0.5) ? kInfinity<double> : -kInfinity<double>);
    }
    return x;
  }

 private:
  bool flag(Hostile one, double p) {
    if (!chance(p)) return false;
    mark(one);
    return true;
  }
  void mark(Hostile one) { scene_->classes |= 1u << static_cast<unsigned>(one); }
  [[nodiscard]] double far() { return chance(0.2) ? 1e6 : power(20, 40); }

  Quaternion<double> orientation() {
    if (chance(0.3)) return {};
    Quaternion<double> q = draw_.turn<double>();
    const double kind = draw_.between(0, 1);
    if (kind < 0.3) {
      mark(Hostile::permuting_orientation);
      q = chance(0.5) ? Quaternion<double>{1, 1, 0, 0} : Quaternion<double>{0.5, -0.5, 0.5, 0.5};
      if (chance(0.3)) q = {0, 0, 1, 0};
    } else if (kind < 0.7) {
      mark(Hostile::odd_orientation);
      switch (below(3)) {
        case 0:
          q = {q.w * power(-90, 90), q.x * power(-90, 90), q.y * power(-90, 90), q.z * power(-90, 90)};
          break;
        case 1:
          q = {1, nudged(1.0), 0, 0};
          break;
        default:
          q = {1, power(-60, -20), 0, chance(0.5) ? 0.0 : power(-60, -20)};
          break;
      }
    }
    return q;
  }

  Vec3<double> extents(double size) {
    Vec3<double> out;
    for (int i = 0; i < 3; ++i) out[i] = size * draw_.between(0.1, 1);
    if (flag(Hostile::zero_extent, 0.15)) out[static_cast<int>(below(3))] = 0;
    if (chance(0.1)) out[static_cast<int>(below(3))] *= power(-20, 0);
    return out;
  }
  Shape<double> hull(double size, const Vec3<double>& at) {
    std::vector<Vec3<double>> points;
    for (int i = 0; i < 8; ++i) points.push_back(at + draw_.vector<double>(size));
    return Hull<double>(std::span<const Vec3<double>>(points));
  }
  Shape<double> leaf(double size) {
    const Vec3<double> e = extents(size);
    switch (below(9)) {
      case 0:
        return Point<double>{};
      case 1:
        return Sphere<double>{e[0]};
      case 2:
        return Capsule<double>{e[0], e[1]};
      case 3:
        return Cylinder<double>{e[0], e[1]};
      case 4:
        return Cone<double>{e[0], e[1]};
      case 5:
        return Ellipsoid<double>{chance(0.5) ? e : Vec3<double>(e[0], e[0], e[2])};
      case 6:
        return hull(size, Vec3<double>::Zero());
      default:
        return Box<double>{e};
    }
  }
  Shape<double> tree(double size, int depth = 0) {
    const Shape<double> part = depth < 3 && chance(0.3) ? tree(size, depth + 1) : leaf(size);
    switch (below(5)) {
      case 0:
        return sum<double>(part, Segment<double>{Vec3<double>::Zero(), draw_.vector<double>(size)});
      case 1:
        return hull_of<double>(
            Sphere<double>{size},
            translated<double>(Sphere<double>{size * draw_.between(0.1, 1)}, draw_.vector<double>(2 * size)));
      case 2:
        return rounded<double>(part, size * draw_.between(0.1, 1));
      case 3: {
        mark(Hostile::cancelling_parts);
        // Out by far, turned, and back by what that comes to: near the origin again.
        const double out = size * far();
        const Quaternion<double> q = draw_.turn<double>();
        const Vec3<double> there = unit(draw_.vector<double>(1)) * out;
        const Vec3<double> back = detail::rotation_matrix(q) * there;
        return posed<double>(translated<double>(part, there), Vec3<double>(-back), q);
      }
      default:
        mark(Hostile::cancelling_parts);
        out_there_ = draw_.vector<double>(size * far());
        return sum<double>(translated<double>(part, out_there_), Point<double>{});
    }
  }
  Shape<double> shape(double size) {
    if (flag(Hostile::combinator, 0.2)) return tree(size);
    if (flag(Hostile::ball_by_another_name, 0.1)) {
      const double r = size * draw_.between(0.1, 1);
      switch (below(3)) {
        case 0:
          return Ellipsoid<double>{{r, r, r}};
        case 1:
          return Capsule<double>{r, 0};
        default:
          return rounded<double>(Point<double>{}, r);
      }
    }
    if (flag(Hostile::far_in_own_frame, 0.25)) {
      Vec3<double> at = size * far() * unit(draw_.vector<double>(1));
      if (chance(0.5)) at = size * far() * Vec3<double>::Unit(static_cast<int>(below(3)));
      out_there_ = at;
      switch (below(3)) {
        case 0:
          return Segment<double>{at + draw_.vector<double>(size), at + draw_.vector<double>(size)};
        case 1:
          return Triangle<double>{at + draw_.vector<double>(size), at + draw_.vector<double>(size),
                                  at + draw_.vector<double>(size)};
        default:
          return hull(size, at);
      }
    }
    return leaf(size);
  }

  Vec3<double> spin() {
    Vec3<double> w = draw_.vector<double>(4);
    switch (below(4)) {
      case 0:
        w = power(-2, 2) * Vec3<double>::Unit(static_cast<int>(below(3)));
        if (flag(Hostile::axis_near_coordinate, 0.6)) {
          w[static_cast<int>(below(3))] += w.norm() * power(-60, -40);
        }
        break;
      case 1:
        w = power(-2, 2) * Vec3<double>(1, chance(0.5) ? 1.0 : nudged(1.0), 0);
        break;
      default:
        break;
    }
    if (flag(Hostile::fast_spin, 0.15)) {
      w *= std::min(power(8, 31), 0x1.fp29 / (w.norm() * scene_->t_end));
    } else if (flag(Hostile::slow_spin, 0.08)) {
      w *= power(-185, -30);
    }
    return w;
  }

  RotatingBody<double> body(double size) {
    RotatingBody<double> out;
    out_there_ = Vec3<double>::Zero();
    out.body.shape = shape(size);
    out.body.orientation = orientation();
    out.body.position = draw_.vector<double>(3 * size);
    if (flag(Hostile::far_from_origin, 0.15)) out.body.position += draw_.vector<double>(size * far());
    if (chance(0.7)) out.body.displacement = draw_.vector<double>(size * power(-3, 2));
    out.rotation = spin();
    if (flag(Hostile::at_rest, 0.12)) out.rotation = Vec3<double>::Zero();
    // A shape that is far out in its own frame rotates about its own middle as often as about the origin.
    out.pivot = chance(0.5) ? out_there_ : Vec3<double>(Vec3<double>::Zero());
    if (chance(0.6)) out.pivot += draw_.vector<double>(size);
    if (out_there_ != Vec3<double>::Zero() && chance(0.5)) {
      out.body.position -= detail::rotation_matrix(out.body.orientation) * out_there_;
    }
    if (flag(Hostile::long_arm, 0.25)) {
      out.pivot = size * far() * unit(draw_.vector<double>(1));
      if (flag(Hostile::pivot_along_own_spin, 0.4)) {
        const Vec3<double> own =
            detail::rotation_matrix(out.body.orientation).transpose() * unit(out.rotation);
        out.pivot = nudged(Vec3<double>(size * far() * own));
      } else if (chance(0.3)) {
        const double x = size * far();
        out.pivot = {x, nudged(x), 0};
      }
    }
    if (flag(Hostile::own_axis_spin, 0.12)) {
      const double rate = power(-2, 6) / scene_->t_end;
      out.rotation = rate * detail::rotation_matrix(out.body.orientation).col(2);
      if (chance(0.5)) out.rotation = nudged(out.rotation);
      if (chance(0.5)) out.pivot[0] = out.pivot[1] = 0;
    }
    return out;
  }

  // Properties that the bodies have in common, within the rounding of doubles.
  void relate() {
    RotatingBody<double>&a = scene_->a, &b = scene_->b;
    const bool equal = flag(Hostile::equal_spins, 0.2);
    if (equal) {
      b.rotation = a.rotation;
    } else if (flag(Hostile::spins_an_ulp_apart, 0.15)) {
      b.rotation = nudged(a.rotation);
    }
    if (flag(Hostile::moves_as_one, 0.3)) b.body.displacement = a.body.displacement;
    const auto pivot_of = [](const RotatingBody<double>& body) {
      return Vec3<double>(body.body.position + detail::rotation_matrix(body.body.orientation) * body.pivot);
    };
    // B's pivot where A's is, by B's position, or by its pivot where B has no orientation.
    const auto bring_together = [&](const Vec3<double>& apart) {
      const Vec3<double> there = pivot_of(a) + apart;
      if (chance(0.5)) {
        b.body.orientation = {};
        b.pivot = there - b.body.position;
      } else {
        b.body.position = there - (pivot_of(b) - b.body.position);
      }
    };
    const double kind = draw_.between(0, 1);
    if (kind < 0.1) {
      mark(Hostile::equal_pivots);
      bring_together(Vec3<double>::Zero());
    } else if (kind < 0.2) {
      mark(Hostile::pivots_an_ulp_apart);
      bring_together(Vec3<double>::Zero());
      b.body.position = nudged(b.body.position);
    } else if (kind < 0.35) {
      mark(Hostile::pivots_along_axis);
      bring_together(power(-3, 40) * unit(a.rotation));
      if (chance(0.5)) b.pivot = nudged(b.pivot);
    }
  }

  // Values that validation refuses become 0 or the greatest value that it admits.
  static void admit(Vec3<double>& x) {
    for (int i = 0; i < 3; ++i) {
      if (std::abs(x[i]) < 1e-60) x[i] = 0;
      if (std::abs(x[i]) > 1e60) x[i] = std::copysign(1e60, x[i]);
    }
  }
  static void admit(RotatingBody<double>& body) {
    for (Vec3<double>* x : {&body.body.position, &body.body.displacement, &body.rotation, &body.pivot}) {
      admit(*x);
    }
  }

  Draw draw_;
  HostileScene* scene_ = nullptr;
  Vec3<double> out_there_ = Vec3<double>::Zero();  // where the last shape is in its own frame
};

}  // namespace graze::test
