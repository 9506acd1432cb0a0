// Changes of the case under a proof.
//
// Frame: world, as graze/rotating_body.hpp. c = position + R(orientation) pivot is a body's centre
// of rotation in the world.
#include <cmath>

#include "corpus/families/draw.hpp"
#include "corpus/families/turning.hpp"
#include "properties/attack/mutant.hpp"
#include "properties/edit/shape.hpp"

namespace graze::attack {

using corpus::Case;
using corpus::Random;
using corpus::Spin;

namespace {

struct Side {
  Body<double>& body;
  Spin& spin;
};
Side side_of(Case& problem, bool first) {
  return first ? Side{problem.a, problem.spin_a} : Side{problem.b, problem.spin_b};
}

double small_part(Random& random) { return std::scalbn(1.0, -random.integer(2, 36)); }

double& any_component(Vec3<double>& x, Random& random) { return x[random.integer(0, 2)]; }

// The pivot that brings the body's centre of rotation to that point of the world, up to rounding.
Vec3<double> pivot_at(const Body<double>& body, const Vec3<double>& world) {
  const Quaternion<double>& q = body.orientation;
  return corpus::rotate({q.w, -q.x, -q.y, -q.z}, world - body.position);
}

Vec3<double> centre_of(const Side& side) {
  return side.body.position + corpus::rotate(side.body.orientation, side.spin.pivot);
}

void edit_pivot(Case& problem, bool first, Random& random) {
  const Side side = side_of(problem, first), other = side_of(problem, !first);
  Vec3<double>& pivot = side.spin.pivot;
  switch (random.below(8)) {
    case 0:
      pivot.setZero();
      break;
    case 1:
    case 4:
      pivot = pivot_at(side.body, centre_of(other));
      break;
    case 2:
      for (int i = 0; i < 3; ++i) pivot[i] = random.integer(-8, 8);
      break;
    case 3:
      pivot = std::scalbn(1.0, random.integer(1, 20)) * (pivot + Vec3<double>::UnitX());
      break;
    default: {
      double& x = any_component(pivot, random);
      x = x == 0 ? small_part(random) : beside(x, random);
      break;
    }
  }
}

void edit_placing(Case& problem, Random& random) {
  const Side side = side_of(problem, random.once_in(2));
  const Vec3<double> apart = problem.b.position - problem.a.position;
  switch (random.below(6)) {
    case 0: {
      Quaternion<double>& q = side.body.orientation;
      double* const parts[] = {&q.w, &q.x, &q.y, &q.z};
      double& x = *parts[random.below(4)];
      x = x == 0 ? small_part(random) : beside(x, random);
      if (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0) q.w = 1;
      break;
    }
    case 1:
      any_component(side.body.position, random) += random.integer(-2, 2);
      break;
    case 2:
      // Farther off, which keeps what is apart apart.
      problem.b.position += small_part(random) * apart;
      break;
    case 3:
      problem.b.position -= small_part(random) * apart;
      break;
    default: {
      double& x = any_component(side.body.position, random);
      x = x == 0 || random.once_in(2) ? x + (random.once_in(2) ? 1 : -1) * small_part(random)
                                      : beside(x, random);
      break;
    }
  }
}

void edit_rotation(Case& problem, Random& random) {
  const Side side = side_of(problem, !problem.spin_a.rotation.isZero(0) &&
                                         (problem.spin_b.rotation.isZero(0) || random.once_in(2)));
  const Side other = side_of(problem, &side.body != &problem.a);
  Vec3<double>& w = side.spin.rotation;
  switch (random.below(8)) {
    case 0:
      w = -w;
      break;
    case 1:
      w.setZero();
      break;
    case 2: {
      // Whole turns more.
      const double rate = w.norm();
      if (rate > 0) w += (2 * corpus::kPi * random.integer(1, 2) / problem.t_max / rate) * w;
      break;
    }
    case 3:
      other.spin.rotation = w;
      break;
    case 4:
      w *= 1 + (random.once_in(2) ? 1 : -1) * small_part(random);
      break;
    default: {
      double& x = any_component(w, random);
      x = x == 0 ? small_part(random) : beside(x, random);
      break;
    }
  }
}

void edit_motion(Case& problem, Random& random) {
  const bool turns = !problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0);
  if (turns && random.once_in(2)) return edit_rotation(problem, random);
  const Side side = side_of(problem, random.once_in(2));
  Vec3<double>& v = side.body.displacement;
  switch (random.below(6)) {
    case 0:
      v = random.once_in(2) ? Vec3<double>(-v) : Vec3<double>::Zero();
      break;
    case 1:
      v *= 1 + (random.once_in(2) ? 1 : -1) * small_part(random);
      break;
    default: {
      double& x = any_component(v, random);
      x = x == 0 ? (random.once_in(2) ? 1 : -1) * small_part(random) : beside(x, random);
      break;
    }
  }
}

// One number of the shape, or all of its extents.
void edit_extent(Case& problem, Random& random) {
  Body<double>& body = side_of(problem, random.once_in(2)).body;
  const bool all = random.once_in(3);
  const double by = random.once_in(4) ? std::scalbn(1.0, random.integer(-1, 1)) : 1 - small_part(random);
  std::uint64_t count = 0;
  const auto is_size = [](law::Slot slot) { return slot == law::Slot::extent || slot == law::Slot::vertex; };
  auto counting = [&](law::Slot slot, double x) {
    count += is_size(slot);
    return x;
  };
  Shape<double> shape = law::map_shape(body.shape, counting);
  if (count == 0) return;
  const std::uint64_t chosen = random.below(count);
  std::uint64_t at = 0;
  auto change = [&](law::Slot slot, double x) {
    if (!is_size(slot)) return x;
    if (all) return x * by;
    if (at++ != chosen) return x;
    const double y = x == 0 ? small_part(random) : beside(x, random);
    return slot == law::Slot::extent ? std::abs(y) : y;
  };
  body.shape = law::map_shape(shape, change);
}

void edit_horizon(corpus::ProofRecord& record, Random& random) {
  Case& problem = record.problem;
  const double t_max = std::isfinite(problem.t_max) ? problem.t_max : 1;
  switch (random.below(10)) {
    case 0:
      problem.t_max = std::abs(beside(t_max, random));
      break;
    case 1:
      problem.t_max = t_max * random.unit();
      break;
    case 2:
      problem.t_max = std::scalbn(1.0, -1074 + random.integer(0, 60));
      break;
    case 3:
      if (!record.rotating) problem.t_max = random.once_in(2) ? kInfinity<double> : t_max * 4;
      break;
    case 4:
      if (!record.rotating) {
        problem.start_policy =
            problem.start_policy == StartPolicy::report ? StartPolicy::pass_over : StartPolicy::report;
      }
      break;
    case 5:
      problem.target_distance = problem.target_distance == 0
                                    ? small_part(random)
                                    : std::abs(beside(problem.target_distance, random));
      break;
    case 6:
      problem.target_distance = random.once_in(2) ? 0 : std::scalbn(1.0, -random.integer(8, 40));
      break;
    case 7:
      // Up to the end of the claim.
      if (record.rotating && !record.rotating->chain.empty())
        problem.t_max = record.rotating->chain.back().end;
      break;
    default:
      problem.t_max = t_max * (1 - small_part(random));
      break;
  }
}

}  // namespace

void edit_case(corpus::ProofRecord& record, Edit kind, Random& random) {
  Case& problem = record.problem;
  switch (kind) {
    case Edit::pivot:
    case Edit::resting_pivot: {
      const bool wanted = kind == Edit::pivot;
      const bool a = !problem.spin_a.rotation.isZero(0) == wanted;
      const bool b = !problem.spin_b.rotation.isZero(0) == wanted;
      if (a || b) edit_pivot(problem, a && (!b || random.once_in(2)), random);
      break;
    }
    case Edit::placing:
      edit_placing(problem, random);
      break;
    case Edit::motion:
      edit_motion(problem, random);
      break;
    case Edit::extent:
      edit_extent(problem, random);
      break;
    case Edit::horizon:
      edit_horizon(record, random);
      break;
    case Edit::shape: {
      Body<double>& body = side_of(problem, random.once_in(2)).body;
      body.shape = written_otherwise(body.shape, random);
      break;
    }
    default:
      break;
  }
}

}  // namespace graze::attack
