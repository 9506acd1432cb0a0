// Changes of slices, and of the axis of a linear proof.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "properties/attack/mutant.hpp"

namespace graze::attack {

using corpus::Case;
using corpus::Random;

namespace {

using Chain = std::vector<TimeSlice>;

double small_part(Random& random) { return std::scalbn(1.0, -random.integer(3, 40)); }

Vec3<double> turned(const Vec3<double>& n, const Vec3<double>& rotation, double t) {
  const double angle = rotation.norm() * t;
  if (!(angle > 0)) return n;
  return Eigen::AngleAxisd(std::fmod(angle, 6.283185307179586), rotation.normalized()) * n;
}

Vec3<double> other_axis(Vec3<double> n, const Case& problem, Random& random) {
  const Vec3<double>& w = random.once_in(2) ? problem.spin_a.rotation : problem.spin_b.rotation;
  switch (random.below(10)) {
    case 0:
      return -n;
    case 1:
      return {n[1], n[2], n[0]};
    case 2:
      return w.isZero(0) ? n : w;
    case 3: {
      // Nearly parallel to w.
      if (w.isZero(0)) return n;
      const double most = n.cwiseAbs().maxCoeff();
      return w + small_part(random) * (w.cwiseAbs().maxCoeff() / (most > 0 ? most : 1)) * n;
    }
    case 4:
      return problem.b.position - problem.a.position;
    case 5: {
      double& x = n[random.integer(0, 2)];
      x = x == 0 ? small_part(random) : beside(x, random);
      return n;
    }
    default: {
      const double most = n.cwiseAbs().maxCoeff();
      for (int i = 0; i < 3; ++i) n[i] += small_part(random) * random.integer(-2, 2) * most;
      return n;
    }
  }
}

void edit_frame(Chain& chain, const Case& problem, Random& random) {
  const auto frame = static_cast<AxisFrame>(random.below(3));
  const bool all = random.once_in(4), kept = random.once_in(2);
  const std::size_t chosen = random.below(chain.size());
  double begin = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    TimeSlice& slice = chain[i];
    if (all || i == chosen) {
      if (!kept) {
        // The axis in the new frame with the same direction in the world in the middle of the slice.
        const double middle = begin + (slice.end - begin) / 2;
        const auto rotation = [&](AxisFrame of) {
          return of == AxisFrame::a   ? problem.spin_a.rotation
                 : of == AxisFrame::b ? problem.spin_b.rotation
                                      : Vec3<double>::Zero();
        };
        slice.axis = turned(turned(slice.axis, rotation(slice.frame), middle), -rotation(frame), middle);
      }
      slice.frame = frame;
    }
    begin = slice.end;
  }
}

void edit_end(Chain& chain, const Case& problem, Random& random) {
  const std::size_t i = random.below(chain.size());
  const double begin = i == 0 ? 0 : chain[i - 1].end, duration = chain[i].end - begin;
  const bool last = i + 1 == chain.size();
  const auto at = static_cast<std::ptrdiff_t>(i);
  switch (random.below(8)) {
    case 0:
      // The next slice's time is this one's, too.
      if (!last) chain[i].end = chain[i + 1].end;
      if (!last) chain.erase(chain.begin() + at + 1);
      break;
    case 1:
      // One slice for all of it.
      chain[i].end = random.once_in(2) ? chain.back().end : problem.t_max;
      chain = {chain[i]};
      break;
    case 2:
      chain.back().end = problem.t_max;
      break;
    case 3:
      chain.resize(i + 1);
      break;
    case 4: {
      // Cut in two, the second with another axis.
      TimeSlice first = chain[i];
      first.end = begin + duration * random.unit();
      chain.insert(chain.begin() + at, first);
      if (!last) chain[i + 1].axis += small_part(random) * chain[i + 2].axis;
      break;
    }
    case 5:
      chain[i].end += duration * small_part(random) * 4;
      if (!last) chain[i].end = std::min(chain[i].end, chain[i + 1].end);
      break;
    case 6:
      chain[i].end = std::nextafter(chain[i].end, random.once_in(2) ? 0 : kInfinity<double>);
      break;
    default:
      chain[i].end -= duration * small_part(random);
      break;
  }
}

void edit_order(Chain& chain, Random& random) {
  const std::size_t i = random.below(chain.size());
  if (chain.size() < 2) return;
  const std::size_t next = i + 1 < chain.size() ? i + 1 : i - 1;
  // The data of a slice except its time.
  const auto exchange = [&](std::size_t one, std::size_t other) {
    std::swap(chain[one].axis, chain[other].axis);
    std::swap(chain[one].frame, chain[other].frame);
  };
  switch (random.below(5)) {
    case 0:
    case 1:
      exchange(i, next);
      break;
    case 2:
      exchange(i, random.below(chain.size()));
      break;
    case 3:
      for (std::size_t k = 0; k < chain.size() / 2; ++k) exchange(k, chain.size() - 1 - k);
      break;
    default:
      // One is repeated, and the other is lost.
      chain[next].axis = chain[i].axis;
      chain[next].frame = chain[i].frame;
      break;
  }
}

}  // namespace

void edit_chain(corpus::ProofRecord& record, Edit kind, Random& random) {
  if (!record.rotating) {
    Proof& proof = record.proof;
    if (kind != Edit::axis || !proof.has_axis) return;
    if (!proof.symbolic) {
      proof.axis = other_axis(proof.axis, record.problem, random);
    } else if (NearestAxis& nearest = proof.nearest; nearest.size > 0) {
      if (random.once_in(2)) {
        nearest.time = beside(nearest.time, random);
      } else if (random.once_in(2)) {
        nearest.motion = !nearest.motion;
      } else {
        proof.then = !proof.then;
        proof.factor[0].kind = static_cast<AxisFactor::Kind>(random.below(3));
      }
    } else if (random.once_in(3)) {
      proof.axis_sign = -proof.axis_sign;
    } else {
      AxisFactor& factor = proof.factor[random.below(2)];
      if (factor.kind == AxisFactor::Kind::given && !random.once_in(4)) {
        factor.given = other_axis(factor.given, record.problem, random);
      } else {
        factor.kind = static_cast<AxisFactor::Kind>(random.below(3));
      }
    }
    return;
  }
  Chain& chain = record.rotating->chain;
  if (chain.empty()) return;
  if (kind == Edit::frame) edit_frame(chain, record.problem, random);
  if (kind == Edit::end) edit_end(chain, record.problem, random);
  if (kind == Edit::order) edit_order(chain, random);
  if (kind == Edit::axis) {
    TimeSlice& slice = chain[random.below(chain.size())];
    slice.axis = other_axis(slice.axis, record.problem, random);
  }
}

}  // namespace graze::attack
