// Decides the cast of a point at an ellipsoid, a cylinder or a cone in exact numbers. solid_ray_bracket.hpp comes first.
//
//   x(t) = o + t w              the point in the solid's axes (quadric.hpp), times the weight W = |q|^2 of its rotation
//   g(t) = a t^2 + 2 b t + c    the sum of k_i x_i^2, less (L W)^2: at most 0 inside of the quadric
//   J = [j_0, j_1]              the times of [0, T] between the planes
//
// In J the set g <= 0 is an interval, as the planes leave one half of the double cone. So the point touches first:
//   at j_0 if g(j_0) <= 0, which is rational,
//   at the root where g falls, if g(j_1) <= 0, or if a > 0, g has its least value within J, and b^2 >= a c,
//   and never otherwise.
// t is at or before that root iff t <= j_0, or t <= j_1 and g(t) >= 0 and, if a > 0 or g(t) = 0, a t + b <= 0.
//
// Units: the caller's.   Frame: that of the quadric, carried along.
#pragma once

#include <graze/detail/search/exact/exact_body.hpp>
#include <graze/detail/search/exact/facet.hpp>
#include <graze/detail/search/exact/solid_ray_bracket.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

class SolidRay {
 public:
  // The bodies have passed validate(), and is_quadric(solid.shape).
  template <Scalar S>
  SolidRay(const Body<S>& solid, const Body<S>& point)
      : form_(solid.shape), low_(form_.low), high_(form_.high) {
    if (!solid.orientation.is_identity()) turn_ = scaled_to_one(as_double(solid.orientation));
    o_ = into_solid(Exact::of(wide(point.position), wide(solid.position)));
    w_ = into_solid(Exact::of(wide(point.displacement), wide(solid.displacement))).x;
    o_.x[2] = o_.x[2] - Dyadic(form_.apex) * o_.weight;
    for (std::size_t i = 0; i < 3; ++i) {
      const Dyadic root = Dyadic(form_.root[i][0]) * Dyadic(form_.root[i][1]);
      k_[i] = Dyadic(form_.sign(i)) * root * root;
      a_ = a_ + k_[i] * w_[i] * w_[i];
      b_ = b_ + k_[i] * o_.x[i] * w_[i];
      c_ = c_ + k_[i] * o_.x[i] * o_.x[i];
    }
    const auto& l = form_.limit;
    const Dyadic limit = Dyadic(l[0]) * Dyadic(l[1]) * Dyadic(l[2]) * o_.weight;
    c_ = check(c_ - limit * limit);
    check(a_);
    check(b_);
  }

  // False once a number outgrew its room: nothing may be trusted then.
  [[nodiscard]] bool valid() const { return valid_; }

  [[nodiscard]] bool touches_at_start() {
    return c_.sign() <= 0 && (form_.axis < 0 || (above_low().sign() >= 0 && below_high().sign() >= 0));
  }
  // Of a start in contact: does the point stay out of the interior, at the start if it rests and after it if it moves?
  [[nodiscard]] bool leaves_or_slides() {
    const auto is_inward = [](const Dyadic& depth, const Dyadic& rate) {
      return depth.sign() > 0 || (depth.sign() == 0 && rate.sign() > 0);
    };
    // At an apex c and b are 0, and a < 0 if the path is steeper than the side.
    const bool into_quadric = is_inward(-c_, -b_) || (c_.sign() == 0 && b_.sign() == 0 && a_.sign() < 0);
    if (form_.axis < 0) return !into_quadric;
    const Dyadic& rate = w_[std::size_t(form_.axis)];
    return !(into_quadric && is_inward(above_low(), rate) && is_inward(below_high(), -rate));
  }

  // For a start that is not in contact. False: a miss.
  [[nodiscard]] bool first_contact(double t_max, SolidContact& out) {
    if (!(t_max > 0) || (w_[0].sign() == 0 && w_[1].sign() == 0 && w_[2].sign() == 0)) return false;
    from_ = {Dyadic(), Dyadic(1)};
    to_.reset();
    if (t_max < kInfinity<double>) to_ = ExactTime{Dyadic(t_max), Dyadic(1)};
    if (form_.axis >= 0 && !clip_to_planes()) return false;
    if (to_ && order(from_, *to_) > 0) return false;
    if (const bool is_inside = sign_of_g(from_) <= 0; is_inside && form_.axis >= 0) {
      // A plane is met, as the start is not in contact.
      Exact n;
      n.x[std::size_t(form_.axis)] = Dyadic(w_[std::size_t(form_.axis)].sign() > 0 ? -1.0 : 1.0);
      return take_contact(from_, bracket_of(from_), n, out);
    }
    if (!(to_ && sign_of_g(*to_) <= 0) && !dips()) return false;
    const Dyadic root = root_up(check(b_ * b_ - a_ * c_));
    if (!valid_) return false;
    // The root where g falls, in the form in which nothing cancels. `root` is rounded by 2^-250.
    const ExactTime time = b_.sign() > 0 ? ExactTime{b_ + root, -a_} : ExactTime{c_, root - b_};
    const TimeBracket toi = bracket_by(near_quotient(time.numerator, time.denominator),
                                       [&](double t) { return sign_of_rest(Dyadic(t)); });
    return take_contact(time, toi, gradient_at(time), out);
  }

 private:
  // ---- frames ----

  [[nodiscard]] Exact into_solid(Exact x) const {
    if (!turn_.is_identity()) ExactTurn{{turn_.w, -turn_.x, -turn_.y, -turn_.z}}(x);
    return x;
  }
  [[nodiscard]] Dyadic3 into_world(Exact x) {
    if (!turn_.is_identity()) ExactTurn{turn_}(x);
    for (const Dyadic& one : x.x) check(one);
    return x.x;
  }

  // ---- signs ----

  const Dyadic& check(const Dyadic& x) {
    valid_ = valid_ && x.valid();
    return x;
  }
  [[nodiscard]] Dyadic above_low() { return check(o_.x[std::size_t(form_.axis)] - low_ * o_.weight); }
  [[nodiscard]] Dyadic below_high() { return check(high_ * o_.weight - o_.x[std::size_t(form_.axis)]); }
  [[nodiscard]] int order(const ExactTime& x, const ExactTime& y) {
    return check(x.numerator * y.denominator - y.numerator * x.denominator).sign();
  }
  [[nodiscard]] int sign_of_g(const ExactTime& t) {
    const Dyadic &n = t.numerator, &d = t.denominator;
    return check((a_ * n + (b_ * d).times_power_of_two(1)) * n + c_ * d * d).sign();
  }
  // Is g least within J, and not above 0 there?
  [[nodiscard]] bool dips() {
    if (a_.sign() <= 0) return false;
    const ExactTime least{-b_, a_};
    return order(from_, least) < 0 && (!to_ || order(least, *to_) < 0) &&
           check(b_ * b_ - a_ * c_).sign() >= 0;
  }
  // The sign of the root minus t.
  [[nodiscard]] int sign_of_rest(const Dyadic& t) {
    const ExactTime at{t, Dyadic(1)};
    if (!valid_) return 0;
    if (order(at, from_) <= 0) return 1;
    if (to_ && order(at, *to_) > 0) return -1;
    const int sign = sign_of_g(at), slope = check(a_ * t + b_).sign();
    if (!valid_) return 0;
    if (sign < 0 || (slope > 0 && (a_.sign() > 0 || sign == 0))) return -1;
    return sign;
  }

  // J. False if it is empty.
  [[nodiscard]] bool clip_to_planes() {
    const Dyadic& rate = w_[std::size_t(form_.axis)];
    const Dyadic up = above_low(), down = below_high();
    if (rate.sign() == 0) return up.sign() >= 0 && down.sign() >= 0;
    const bool rises = rate.sign() > 0;
    const ExactTime enter = rises ? ExactTime{-up, rate} : ExactTime{-down, -rate};
    const ExactTime leave = rises ? ExactTime{down, rate} : ExactTime{up, -rate};
    if (enter.numerator.sign() > 0) from_ = enter;
    if (!to_ || order(leave, *to_) < 0) to_ = leave;
    return leave.numerator.sign() >= 0;
  }

  // ---- contact ----

  // x(t), times W and the denominator.
  [[nodiscard]] Exact at(const ExactTime& t) const {
    Exact out;
    for (std::size_t i = 0; i < 3; ++i) out.x[i] = t.denominator * o_.x[i] + t.numerator * w_[i];
    out.weight = t.denominator * o_.weight;
    return out;
  }
  bool take_contact(const ExactTime& t, const TimeBracket& toi, const Exact& n, SolidContact& out) {
    const Exact x = at(t);
    for (const Dyadic* one : {&x.x[0], &x.x[1], &x.x[2], &x.weight}) check(*one);
    const Dyadic3 normal = into_world(n);
    if (!valid_) return false;
    out.toi = toi;
    for (int i = 0; i < 3; ++i) out.point[i] = ratio(x.x[std::size_t(i)], x.weight);
    out.point[2] += form_.apex;
    out.normal = unit_of(normal);
    return true;
  }
  // At an apex, and at what has no thickness, it is 0. A normal there is opposite to the motion across the axis. At an
  // apex it leans as the side does.
  [[nodiscard]] Exact gradient_at(const ExactTime& t) const {
    Exact n = at(t);
    n.weight = Dyadic(1);
    for (std::size_t i = 0; i < 3; ++i) n.x[i] = k_[i] * n.x[i];
    if (n.x[0].sign() != 0 || n.x[1].sign() != 0 || n.x[2].sign() != 0) return n;
    n.x = minus(w_);
    if (form_.axis < 0) return n;
    Dyadic& along = n.x[std::size_t(form_.axis)];
    along = Dyadic();
    if (!(form_.apex > 0)) return n;
    along = Dyadic(form_.tilt) * root_up(dot(n.x, n.x));
    for (std::size_t i = 0; i < 2; ++i) n.x[i] = Dyadic(2 * form_.apex) * n.x[i];
    return n;
  }

  Quadric form_;
  Quaternion<double> turn_ = {};
  Exact o_;
  Dyadic3 w_, k_;
  Dyadic low_, high_, a_, b_, c_;
  ExactTime from_;               // j_0
  std::optional<ExactTime> to_;  // j_1, or infinity
  bool valid_ = true;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
