// Brackets the time at which a point enters an ellipsoid, a cylinder or a cone between two neighbouring doubles, proved in
// pairs of doubles. solid_ray.hpp, which has the notation, decides the cases that it leaves open.
//
// The solid is convex. So if the point is outside of it at one double and inside at the next, TOI is between them. From
// the clip's time, the root of the bound that is met last leads to these two.
//
// x is within e = 2^-91 (|o| + t |w|), as o and w are within 2^-92 of their sizes (vectors.hpp), an apex included. It is
// then normalised. k_i and L W are products of at most six factors, within 2^-94 of themselves, and so g is within
//   sum of |k_i| (2 |x_i| + e) e, and 2^-91 (sum of |k_i| x_i^2 + (L W)^2).
// Its terms stay so far from the least number that underflow is small beside that.
//
// Units: lengths times 2^-k, so that the solid's largest extent is about 1. No scale changes an answer.
#pragma once

#include <graze/detail/search/exact/exact_answer.hpp>
#include <graze/detail/search/exact/facet.hpp>
#include <graze/detail/search/exact/quadric.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

struct SolidContact {
  bool proved = false;
  TimeBracket toi;
  Vec3<double> point = Vec3<double>::Zero();   // of the solid, in its axes
  Vec3<double> normal = Vec3<double>::Zero();  // outward, in world axes, of length 1
};

class SolidRayBracket {
 public:
  // The bodies have passed validate(), and is_quadric(solid.shape).
  template <Scalar S>
  SolidRayBracket(const Body<S>& solid, const Body<S>& point)
      : exponent_(exponent_of(largest_extent(solid.shape))), form_(solid.shape, power_of_two(-exponent_)) {
    const double unit = power_of_two(-exponent_);
    o_ = Fine::of(unit * wide(point.position), unit * wide(solid.position));
    w_ = Fine::of(unit * wide(point.displacement), unit * wide(solid.displacement));
    if (solid.orientation.is_identity()) return;
    turn_ = scaled_to_one(as_double(solid.orientation));
    const FineTurn back({turn_.w, -turn_.x, -turn_.y, -turn_.z});
    back(o_);
    back(w_);
  }

  // How far x(t) is inside of each bound: -g(t), and the ways to the planes. Within the error, then rounded to a double.
  struct Depths {
    std::array<double, 3> inside, error;
    Vec3<double> x;
    double x_error = 0;

    [[nodiscard]] bool is_in() const {
      return inside[0] > error[0] && inside[1] > error[1] && inside[2] > error[2];
    }
    [[nodiscard]] bool is_out() const {
      return inside[0] < -error[0] || inside[1] < -error[1] || inside[2] < -error[2];
    }
  };

  template <bool kFused>
  [[nodiscard]] Depths depths_at(double t) const {
    using P = PairOf<kFused>;
    const P weight = o_.weighted ? pair_as<kFused>(o_.weight) : P{1, 0};
    const double apex = fl(form_.apex * weight.hi);
    Depths out;
    const double e = out.x_error = 0x1p-91 * ((o_.size + fl(t * w_.size)) + 2 * apex);
    P limit{form_.limit[0], 0};
    for (const double factor : {form_.limit[1], form_.limit[2]}) limit = limit * P{factor, 0};
    limit = limit * weight;
    P depth = limit * limit;
    double size = depth.hi, moved = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      P x = pair_as<kFused>(o_.x[i]) + pair_as<kFused>(w_.x[i]) * P{t, 0};
      if (i == 2) x = x - P{form_.apex, 0} * weight;
      const TwoDoubles normal = two_sum(x.hi, x.lo);
      x = {normal.hi, normal.lo};
      out.x[int(i)] = x.hi;
      const P root = product<kFused>(form_.root[i][0], form_.root[i][1]), k = root * root;
      const P term = k * (x * x);
      depth = form_.sign(i) > 0 ? depth - term : depth + term;
      size += term.hi;
      moved += fl(fl(k.hi * (2 * std::abs(x.hi) + e)) * e);
      if (int(i) != form_.axis) continue;
      for (const bool high : {false, true}) {
        const P plane = P{high ? form_.high : form_.low, 0} * weight;
        out.inside[1 + std::size_t(high)] = rounded(high ? plane - x : x - plane);
        out.error[1 + std::size_t(high)] = fl(1.01 * e) + 0x1p-90 * std::abs(plane.hi);
      }
    }
    out.inside[0] = rounded(depth);
    out.error[0] = 1.01 * (moved + 0x1p-91 * size);
    if (!(size > 0x1p-600 && size < 0x1p900)) out.error[0] = kInfinity<double>;
    if (form_.axis < 0) {
      out.inside[1] = out.inside[2] = 1;
      out.error[1] = out.error[2] = 0;
    }
    return out;
  }

  // near: about the time of impact.
  [[nodiscard]] SolidContact prove(double near) const {
    SolidContact out;
    const double far = o_.size + fl(near * w_.size);
    if (!is_plain() || !(near > 0) || !(far > 0x1p-70 && far < 0x1p300)) return out;
    fuses() ? prove_fused(near, out) : prove_plain(near, out);
    return out;
  }

 private:
  // No number of the solid is far from 1 beside the range of doubles.
  [[nodiscard]] bool is_plain() const {
    const auto is = [](double x) { return x == 0 || (x > 0x1p-60 && x < 0x1p60); };
    for (const auto& root : form_.root)
      if (!is(root[0]) || !is(root[1])) return false;
    return is(form_.limit[0]) && is(form_.limit[1]) && is(form_.limit[2]) && is(form_.high - form_.low);
  }

  template <bool kFused>
  void find(double near, SolidContact& out) const {
    constexpr double u = kUnitRoundoff<double>;
    const Depths at = depths_at<kFused>(near);
    // The quadric's depth s later: inside + rate s - bend s^2.
    double rate = 0, bend = 0, rate_error = 0, bend_error = 0;
    Vec3<double> w, square;
    for (int i = 0; i < 3; ++i) {
      const std::size_t k = std::size_t(i);
      w[i] = w_.x[k].hi;
      const double root = form_.root[k][0] * form_.root[k][1], along = fl(root * root) * std::abs(w[i]);
      square[i] = form_.sign(k) * fl(root * root);
      rate -= 2 * fl(fl(square[i] * at.x[i]) * w[i]);
      bend += fl(square[i] * fl(w[i] * w[i]));
      rate_error += fl(2 * along * (fl(8 * u * std::abs(at.x[i])) + at.x_error));
      bend_error += fl(8 * u * along * std::abs(w[i]));
    }
    // To the root nearest to 0, where the depth changes by at least 0.7 rate.
    double step = -kInfinity<double>, step_error = 0, part = 1;
    if (rate > 0) {
      const double first = -at.inside[0] / rate;
      part = 1 - 4 * fl(bend * first) / rate;
      step = part > 0.5 ? 2 * first / (1 + square_root(part)) : first;
      const double size = std::abs(step);
      step_error =
          2 * (at.error[0] + fl(size * (rate_error + fl(size * bend_error)))) / rate + fl(8 * u * size);
    }
    bool by_plane = false;
    if (form_.axis >= 0 && w[form_.axis] != 0) {
      const double along = w[form_.axis], to_plane = -at.inside[along > 0 ? 1 : 2] / std::abs(along);
      by_plane = to_plane > step;
      if (by_plane) step = to_plane;
    }
    if (!(std::abs(step) < 0x1p-30 * near)) return;
    const double t = near + step;
    const bool above = (near - t) + step > 0;
    out.toi = above ? TimeBracket{t, next_up(t)} : TimeBracket{next_down(t), t};
    if (!(out.toi.lower > 0x1p-900) || !depths_at<kFused>(out.toi.lower).is_out() ||
        !depths_at<kFused>(out.toi.upper).is_in())
      return;
    Fine n;
    double largest = 0, error = 0;
    for (int i = 0; i < 3; ++i) {
      const double moved = fl(step * w[i]);
      out.point[i] = at.x[i] + moved;
      const double gradient = square[i] * out.point[i];
      largest = std::max(largest, std::abs(gradient));
      error += fl(std::abs(square[i]) * (fl(2 * u * (std::abs(at.x[i]) + std::abs(moved))) + at.x_error +
                                         fl(std::abs(w[i]) * step_error)));
      n.x[std::size_t(i)].hi = by_plane ? (i != form_.axis ? 0.0 : w[i] > 0 ? -1.0 : 1.0) : gradient;
    }
    // The gradient is that of the contact within 8 u, near an apex too.
    if (!by_plane && !(part > 0.5 && error < 8 * u * largest)) return;
    if (!turn_.is_identity()) FineTurn{turn_}(n);
    out.normal = over_length_as<kFused>(Vec3<double>(rounded(n.x[0]), rounded(n.x[1]), rounded(n.x[2])));
    out.point[2] += fl(form_.apex * (o_.weighted ? o_.weight.hi : 1));
    if (o_.weighted) out.point /= o_.weight.hi;
    out.point *= power_of_two(exponent_);
    out.proved = true;
  }
  [[gnu::noinline]] void prove_plain(double near, SolidContact& out) const { find<false>(near, out); }
  GRAZE_FUSED void prove_fused(double near, SolidContact& out) const { find<true>(near, out); }

  int exponent_;  // k
  Quadric form_;
  Quaternion<double> turn_ = {};
  Fine o_, w_;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
