// Rotating cases whose first contact is known in closed form, and a small prover for them that shares nothing
// with core or the oracles. Everything is in long double (u = 2^-64), and times are accurate to 1e-14 (see
// `settled`).
//
// Every scene reduces to one equation: a gap that is   base + 2 amplitude cos(theta - phase)   or a linear
// function of such a cosine, with the angle of rotation theta = |w| t. Contact lasts while cos(theta - phase)
// <= kappa.
//   orbit   Two balls. One rotates about a pivot off its centre, or both do with equal w:
//           |P + R q|^2 = |P|^2 + |q|^2 + 2 (P.q cos + P.(w x q)/|w| sin) <= (sum of radii)^2.
//   tumble  A box, or a rounded one, that rotates over a plate: each of its corners is at a height of
//           c + |corner| cos(theta - phase).
//   rod     A segment, or a rounded one, that rotates about its end towards a ball: D sin(phase - theta).
// Both bodies may drift along with one common velocity.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "corpus/case.hpp"
#include "graze/rotating_proof.hpp"

namespace graze::test {

using Long = long double;
using LongVec = Eigen::Matrix<Long, 3, 1>;
inline constexpr Long kPi = std::numbers::pi_v<Long>;
inline constexpr Long kNever = std::numeric_limits<Long>::infinity();

[[nodiscard]] inline LongVec wide(const Vec3<double>& x) { return x.cast<Long>(); }

// R(w) x, by |w| radians about w (Rodrigues).
[[nodiscard]] inline LongVec turned(const LongVec& w, const LongVec& x) {
  const Long angle = w.norm();
  if (angle == 0) return x;
  const LongVec u = w / angle;
  return std::cos(angle) * x + std::sin(angle) * u.cross(x) + (1 - std::cos(angle)) * u.dot(x) * u;
}

// A body of a scene as the hull of moving points plus a turning solid plus a ball. Orientations are the
// identity.
struct Mover {
  std::vector<LongVec> core;                  // at t = 0, from the pivot
  std::function<Long(const LongVec&)> solid;  // h of a cylinder, cone or ellipsoid about its origin
  Long radius = 0;
  LongVec pivot, rotation, velocity;

  Mover(const Body<double>& body, const corpus::Spin& spin)
      : pivot(wide(body.position) + wide(spin.pivot)),
        rotation(wide(spin.rotation)),
        velocity(wide(body.displacement)) {
    read(body.shape, -wide(spin.pivot));
  }

  [[nodiscard]] LongVec place(std::size_t vertex, Long t) const {
    return turned(t * rotation, core[vertex]) + pivot + t * velocity;
  }
  [[nodiscard]] Long support(const LongVec& n, Long t) const {
    Long most = -kNever;
    for (std::size_t i = 0; i < core.size(); ++i) most = std::max(most, n.dot(place(i, t)));
    if (solid) most += solid(turned(-t * rotation, n));
    return most + radius * n.norm();
  }
  [[nodiscard]] Long reach() const {
    Long most = 0;
    for (const LongVec& x : core) most = std::max(most, x.norm());
    return most;
  }

 private:
  void read(const Shape<double>& shape, const LongVec& at) {
    if (std::holds_alternative<Point<double>>(shape)) {
      core = {at};
    } else if (const auto* triangle = std::get_if<Triangle<double>>(&shape)) {
      core = {at + wide(triangle->a), at + wide(triangle->b), at + wide(triangle->c)};
    } else if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) {
      core = {at};
      radius = sphere->radius;
    } else if (const auto* segment = std::get_if<Segment<double>>(&shape)) {
      core = {at + wide(segment->a), at + wide(segment->b)};
    } else if (const auto* box = std::get_if<Box<double>>(&shape)) {
      for (unsigned k = 0; k < 8; ++k) {
        LongVec x = wide(box->half_extents);
        for (unsigned i = 0; i < 3; ++i)
          if ((k >> i & 1u) == 0) x[i] = -x[i];
        core.emplace_back(at + x);
      }
    } else if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape)) {
      core = {at};
      solid = [r = cylinder->radius, h = cylinder->half_height](const LongVec& n) {
        return r * std::hypot(n.x(), n.y()) + h * std::abs(n.z());
      };
    } else if (const auto* cone = std::get_if<Cone<double>>(&shape)) {
      core = {at};
      solid = [r = cone->radius, h = cone->half_height](const LongVec& n) {
        return std::max(h * n.z(), r * std::hypot(n.x(), n.y()) - h * n.z());
      };
    } else if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&shape)) {
      core = {at};
      solid = [r = wide(ellipsoid->radii)](const LongVec& n) { return r.cwiseProduct(n).norm(); };
    } else {
      const auto& outer = std::get<Rounded<double>>(shape);
      read(outer.shape->shape, at);
      radius = outer.radius;
    }
  }
};

struct Scene {
  corpus::Case problem;
  Long first = kNever;                // the time of first contact, or kNever without contact
  Long leaves = kNever;               // the end of that contact, for two balls
  std::function<LongVec(Long)> axis;  // world, unit, from A to B: separates until `first`
  // Pairs and weights that prove contact soon after it, written into an empty contact.
  std::function<void(Long, RotatingProof&)> contact;

  [[nodiscard]] Mover a() const { return {problem.a, problem.spin_a}; }
  [[nodiscard]] Mover b() const { return {problem.b, problem.spin_b}; }
  void write_contact(Long t, RotatingProof& proof) const {
    proof.contact = {};
    contact(t, proof);
  }
};

// The separation along a slice's axis at t, less the target distance. Good to 1e-16 of the scene's size.
[[nodiscard]] inline Long excess(const Scene& scene, const TimeSlice& slice, Long t) {
  const Mover a = scene.a(), b = scene.b();
  LongVec n = wide(slice.axis);
  if (slice.frame == AxisFrame::a) n = turned(t * a.rotation, n);
  if (slice.frame == AxisFrame::b) n = turned(t * b.rotation, n);
  return -a.support(n, t) - b.support(-n, t) - scene.problem.target_distance * n.norm();
}

// ---- drawing ----------------------------------------------------------------------------------------------

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  [[nodiscard]] Vec3<double> vector(double most) {
    return {between(-most, most), between(-most, most), between(-most, most)};
  }

 private:
  std::mt19937_64 engine_;
};

// ---- the equation -----------------------------------------------------------------------------------------

// Requires cos(theta - phase) > kappa at theta = 0. The angles at which it first fails and then holds again.
struct Fall {
  Long first = kNever, leaves = kNever;  // angles
  bool settled = false;  // not near a double root, nor near contact at 0: an error of e in kappa is 50 e here
};

[[nodiscard]] inline Fall fall(Long phase, Long kappa) {
  if (kappa < -1.02L) return {kNever, kNever, true};
  if (kappa < -0.98L || kappa > 0.98L) return {};
  const Long at = std::acos(kappa);
  const Long start = std::remainder(-phase, 2 * kPi);
  if (std::abs(start) > at - 0.05L) return {};
  return {at - start, 2 * kPi - at - start, true};
}

// ---- the scenes -------------------------------------------------------------------------------------------

namespace detail {

// Moves both in the same way. A common velocity moves nothing relative to the other.
inline void drift(Scene& scene, Draw& draw) {
  if (draw.below(2) == 0) return;
  scene.problem.a.displacement = scene.problem.b.displacement = draw.vector(2);
}

inline std::uint32_t cycled_bits(std::uint32_t vertex, int k) {
  std::uint32_t out = 0;
  for (int i = 0; i < 3; ++i) out |= (vertex >> i & 1u) << ((i + k) % 3);
  return out;
}
template <class V>
[[nodiscard]] V cycled(const V& x, int k) {
  V out;
  for (int i = 0; i < 3; ++i) out[(i + k) % 3] = x[i];
  return out;
}
inline Shape<double> cycled(const Shape<double>& shape, int k) {
  if (const auto* box = std::get_if<Box<double>>(&shape)) return Box<double>{cycled(box->half_extents, k)};
  if (const auto* s = std::get_if<Segment<double>>(&shape))
    return Segment<double>{cycled(s->a, k), cycled(s->b, k)};
  if (const auto* s = std::get_if<Rounded<double>>(&shape))
    return rounded(cycled(s->shape->shape, k), s->radius);
  return shape;
}

// The axes renamed: x becomes the axis k, exactly.
[[nodiscard]] inline Scene cycled(const Scene& scene, int k) {
  Scene out = scene;
  for (Body<double>* body : {&out.problem.a, &out.problem.b}) {
    body->shape = cycled(body->shape, k);
    body->position = cycled(body->position, k);
    body->displacement = cycled(body->displacement, k);
  }
  for (corpus::Spin* spin : {&out.problem.spin_a, &out.problem.spin_b}) {
    spin->rotation = cycled(spin->rotation, k);
    spin->pivot = cycled(spin->pivot, k);
  }
  out.axis = [axis = scene.axis, k](Long t) { return cycled(axis(t), k); };
  const auto is_box = [](const Shape<double>& shape) {
    const auto* outer = std::get_if<Rounded<double>>(&shape);
    return std::holds_alternative<Box<double>>(outer != nullptr ? outer->shape->shape : shape);
  };
  const bool box_a = is_box(out.problem.a.shape), box_b = is_box(out.problem.b.shape);
  out.contact = [contact = scene.contact, k, box_a, box_b](Long t, RotatingProof& proof) {
    contact(t, proof);
    for (SupportPair& pair : proof.contact) {
      if (box_a) pair.a.vertex = cycled_bits(pair.a.vertex, k);
      if (box_b) pair.b.vertex = cycled_bits(pair.b.vertex, k);
    }
  };
  return out;
}

[[nodiscard]] inline Scene swapped(const Scene& scene) {
  Scene out = scene;
  std::swap(out.problem.a, out.problem.b);
  std::swap(out.problem.spin_a, out.problem.spin_b);
  out.axis = [axis = scene.axis](Long t) { return LongVec(-axis(t)); };
  out.contact = [contact = scene.contact](Long t, RotatingProof& proof) {
    contact(t, proof);
    for (SupportPair& pair : proof.contact) std::swap(pair.a, pair.b);
  };
  return out;
}

}  // namespace detail

// Each draws until its equation is settled, the turn such that first contact is at 0.1 to 0.95 of t_max = 1,
// or a miss over 1 to 9 radians.

[[nodiscard]] inline Scene orbit(Draw& draw, bool miss) {
  for (;;) {
    Scene scene;
    corpus::Case& c = scene.problem;
    c.a.shape = Sphere<double>{draw.between(0.1, 1)};
    c.b.shape = Sphere<double>{draw.below(4) == 0 ? 0 : draw.between(0.1, 1)};
    c.a.position = draw.vector(2);
    c.b.position = draw.vector(4);
    if (draw.below(2) == 0) c.target_distance = draw.between(0, 0.3);
    const std::size_t who = draw.below(3);  // A turns, B turns, both
    const Vec3<double> direction = draw.vector(1);
    if (who != 1) c.spin_a.pivot = draw.vector(3);
    if (who != 0) c.spin_b.pivot = draw.vector(3);
    double rate = draw.between(1, 9) / direction.norm();
    Fall found;
    for (int pass = 0; pass < 2; ++pass) {  // the second with the rate that the first asks for
      if (who != 1) c.spin_a.rotation = rate * direction;
      if (who != 0) c.spin_b.rotation = rate * direction;
      const Mover a = scene.a(), b = scene.b();
      const LongVec w = who != 1 ? a.rotation : b.rotation, u = w.normalized();
      const LongVec q =
          (who != 0 ? b.core[0] : LongVec::Zero().eval()) - (who != 1 ? a.core[0] : LongVec::Zero().eval());
      const LongVec along = u * u.dot(q), across = q - along;
      LongVec p = b.pivot - a.pivot + along;
      if (who == 0) p += b.core[0];
      if (who == 1) p -= a.core[0];
      const Long alpha = p.dot(across), beta = p.dot(u.cross(across));
      const Long reach = a.radius + b.radius + c.target_distance;
      const Long amplitude = 2 * std::hypot(alpha, beta);
      if (amplitude < 0.1L) break;
      found =
          fall(std::atan2(beta, alpha), (reach * reach - p.squaredNorm() - across.squaredNorm()) / amplitude);
      if (!found.settled || (found.first == kNever) != miss) break;
      if (miss) {
        scene.first = kNever;
      } else {
        scene.first = found.first / w.norm();
        scene.leaves = found.leaves / w.norm();
        if (pass == 0) rate *= static_cast<double>(scene.first) / draw.between(0.1, 0.95);
      }
    }
    if (!found.settled || (found.first == kNever) != miss) continue;
    detail::drift(scene, draw);
    scene.axis = [a = scene.a(), b = scene.b()](Long t) {
      return (b.place(0, t) - a.place(0, t)).normalized().eval();
    };
    scene.contact = [](Long, RotatingProof& proof) {
      proof.contact_size = 1;
      proof.weight[0] = 0.25;
    };
    return scene;
  }
}

// The plate, A, is the box of half extents (50, 50, 1) whose upper face is z = 0.
[[nodiscard]] inline Scene tumble(Draw& draw, bool miss) {
  for (;;) {
    Scene scene;
    corpus::Case& c = scene.problem;
    c.a.shape = Box<double>{Vec3<double>(50, 50, 1)};
    c.a.position = Vec3<double>(0, 0, -1);
    const Vec3<double> half(draw.between(0.2, 1), draw.between(0.2, 2), draw.between(0.2, 2));
    const double radius = draw.below(2) == 0 ? 0 : draw.between(0.01, 0.3);
    c.b.shape = radius == 0 ? Shape<double>(Box<double>{half}) : rounded<double>(Box<double>{half}, radius);
    c.b.position = Vec3<double>(draw.between(-3, 3), draw.between(-3, 3), draw.between(0.2, 6));
    if (draw.below(2) == 0) c.target_distance = draw.between(0, 0.3);
    if (draw.below(2) == 0) c.spin_b.pivot = Vec3<double>(0, draw.between(-2, 2), draw.between(-2, 2));
    double rate = draw.between(1, 9);
    Fall found;
    std::uint32_t corner = 0;
    for (int pass = 0; pass < 2; ++pass) {
      c.spin_b.rotation = Vec3<double>(rate, 0, 0);
      const Mover b = scene.b();
      found = {kNever, kNever, true};
      for (std::uint32_t k = 1; k < 8; k += 2) {  // one corner of each edge along x
        const Long y = b.core[k].y(), z = b.core[k].z();
        const Fall one =
            fall(std::atan2(y, z), (radius + Long(c.target_distance) - b.pivot.z()) / std::hypot(y, z));
        found.settled &= one.settled;
        if (one.first < found.first) {
          found.first = one.first;
          corner = k;
        }
      }
      if (!found.settled || (found.first == kNever) != miss) break;
      scene.first = miss ? kNever : found.first / rate;
      if (!miss && pass == 0) rate *= static_cast<double>(scene.first) / draw.between(0.1, 0.95);
    }
    if (!found.settled || (found.first == kNever) != miss) continue;
    detail::drift(scene, draw);
    scene.axis = [](Long) { return LongVec(0, 0, 1); };
    // The corner's foot on the plate is in the triangle of the corner (sx, sy) of the upper face, on its
    // side, and the two beside it. Without a ball, the lower corner below (sx, sy) makes it a tetrahedron.
    const bool ball = radius + c.target_distance > 0;
    scene.contact = [a = scene.a(), b = scene.b(), corner, ball](Long t, RotatingProof& proof) {
      const LongVec foot = b.place(corner, t) - t * a.velocity;
      const std::uint32_t near = (foot.x() > 0 ? 1u : 0u) | (foot.y() > 0 ? 2u : 0u) | 4u;
      const std::array<std::uint32_t, 4> of_plate = {near, near ^ 1u, near ^ 2u, near ^ 4u};
      proof.contact_size = ball ? 3 : 4;
      for (std::size_t i = 0; i < 4; ++i) {
        proof.contact[i].a.vertex = of_plate[i];
        proof.contact[i].b.vertex = corner;
      }
      const Long x = (50 - std::abs(foot.x())) / 100, y = (50 - std::abs(foot.y())) / 100;
      if (ball)
        proof.weight = {static_cast<double>(1 - x - y), static_cast<double>(x), static_cast<double>(y), 0};
    };
    scene = detail::cycled(scene, static_cast<int>(draw.below(3)));
    return draw.below(2) == 0 ? scene : detail::swapped(scene);
  }
}

// A turns about its end, at its origin, in the plane z = 0, from the x axis towards B.
[[nodiscard]] inline Scene rod(Draw& draw) {
  for (;;) {
    Scene scene;
    corpus::Case& c = scene.problem;
    const double length = draw.between(1, 4), radius = draw.below(2) == 0 ? 0 : draw.between(0.01, 0.2);
    const Segment<double> segment{Vec3<double>::Zero(), Vec3<double>(length, 0, 0)};
    c.a.shape = radius == 0 ? Shape<double>(segment) : rounded<double>(segment, radius);
    c.b.shape = Sphere<double>{draw.between(0.05, 0.5)};
    const double distance = draw.between(1, 4), at = draw.between(0.3, 2.9);
    c.b.position = Vec3<double>(distance * std::cos(at), distance * std::sin(at), 0);
    if (draw.below(2) == 0) c.target_distance = draw.between(0, 0.1);
    const Mover ball = scene.b();
    const Long reach = radius + ball.radius + Long(c.target_distance), d = ball.pivot.norm();
    const Long beta = std::asin(reach / d), phi = std::atan2(ball.pivot.y(), ball.pivot.x());
    if (phi < beta + 0.05L || phi > kPi - beta - 0.05L || d * std::cos(beta) > 0.98L * length) continue;
    const double rate = static_cast<double>(phi - beta) / draw.between(0.1, 0.95);
    c.spin_a.rotation = Vec3<double>(0, 0, rate);
    scene.first = (phi - beta) / rate;
    detail::drift(scene, draw);
    scene.axis = [rate](Long t) { return LongVec(-std::sin(rate * t), std::cos(rate * t), 0); };
    scene.contact = [d, phi, rate, length](Long t, RotatingProof& proof) {
      const Long foot = d * std::cos(phi - rate * t) / length;
      proof.contact_size = 2;
      proof.contact[1].a.vertex = 1;
      proof.weight = {static_cast<double>(1 - foot), static_cast<double>(foot), 0, 0};
    };
    scene = detail::cycled(scene, static_cast<int>(draw.below(3)));
    return draw.below(2) == 0 ? scene : detail::swapped(scene);
  }
}

[[nodiscard]] inline Scene draw_scene(Draw& draw, bool miss) {
  const std::size_t kind = draw.below(miss ? 2 : 3);
  return kind == 0 ? orbit(draw, miss) : kind == 1 ? tumble(draw, miss) : rod(draw);
}

// ---- the prover -------------------------------------------------------------------------------------------

// A bound on |(n(t).x(t))''| of both bodies' points together, on [0, end].
[[nodiscard]] inline Long curvature(const Scene& scene, const TimeSlice& slice, Long end) {
  const Mover a = scene.a(), b = scene.b();
  const Long length = wide(slice.axis).norm();
  if (slice.frame == AxisFrame::world) {
    return length * (a.rotation.squaredNorm() * a.reach() + b.rotation.squaredNorm() * b.reach());
  }
  const bool with_a = slice.frame == AxisFrame::a;
  const Mover &x = with_a ? a : b, &y = with_a ? b : a;
  const Long w = x.rotation.norm(), dv = (y.velocity - x.velocity).norm();
  return length * ((y.rotation - x.rotation).norm() * (w + y.rotation.norm()) * y.reach() + 2 * w * dv +
                   w * w * ((y.pivot - x.pivot).norm() + dv * end));
}

// Slices in drawn frames that separate over [0, end], end before `first`. Empty if they would be more than
// `most`.
[[nodiscard]] inline std::vector<TimeSlice> prove_chain(const Scene& scene, double end, Draw& draw,
                                                        std::size_t most = 3000) {
  std::vector<TimeSlice> chain;
  for (double begin = 0; begin < end;) {
    if (chain.size() == most) return {};
    TimeSlice slice;
    slice.frame = static_cast<AxisFrame>(draw.below(3));
    LongVec n = scene.axis(begin);
    if (slice.frame == AxisFrame::a) n = turned(-begin * scene.a().rotation, n);
    if (slice.frame == AxisFrame::b) n = turned(-begin * scene.b().rotation, n);
    slice.axis = (draw.between(0.1, 10) * n).cast<double>();
    const Long first = excess(scene, slice, begin);
    for (Long step = end - begin;; step /= 2) {
      slice.end = step == Long(end) - begin ? end : static_cast<double>(begin + step);
      if (!(slice.end > begin) || !(first > 0)) return {};
      const Long last = excess(scene, slice, slice.end);
      const Long root = std::sqrt(curvature(scene, slice, slice.end) / 2);
      if (last > 0 && std::sqrt(first) + std::sqrt(last) > 1.01L * step * root) break;
    }
    chain.push_back(slice);
    begin = slice.end;
  }
  return chain;
}

}  // namespace graze::test
