// The search behind a rotating cast: by its plan, or by one method. Declared in graze/rotating_cast.hpp.
#pragma once

#include <algorithm>
#include <graze/cast.hpp>
#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/rotating/bilateral_published.hpp>
#include <graze/detail/rotating/follow_contact.hpp>
#include <graze/detail/rotating/make_plan.hpp>
#include <graze/detail/rotating/steps.hpp>
#include <graze/detail/rotating/touching.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/rotating_cast.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

// kRotatingStop times the rounding of a gap is as near as axes lead: a contact a few times as deep is proved.
inline constexpr double kRotatingStop = 4;
// Tier certified: the default width of the bracket over scale, for rotating bodies and for others, and the fraction
// of it that each end may use.
inline constexpr double kCertifiedTurningWidth = 1e-9, kCertifiedWidth = 1e-12, kWidthPart = 1.0 / 16;
// Depth over scale that a contact at the start may have and still be passed over: kappa of tier standard, times u.
// Tier certified proves its result about it in double. If the rounding of a gap is larger, as with a target distance
// far above the scale, so many times that.
template <Scalar S>
constexpr double kFollowedDepth(Tier tier) {
  return tier == Tier::standard && sizeof(S) == 4 ? 64 * double(kUnitRoundoff<S>)
                                                  : 4096 * kUnitRoundoff<double>;
}
inline constexpr double kFollowedErrors = 16;
// Support evaluations after which a contact is no longer followed. A crate that tips about its edge until its next
// face lands takes a thousand. A longer search would need slices as short as the rounding. The last search of a
// distance may take 256 more.
inline constexpr int kMostFollowedSupports = 1792;
// The linear slop of the slides, over scale, if the caller sets no tolerance.
inline constexpr double kPublishedSlop = 0.005;

template <Scalar S>
Invalid validate(const RotatingBody<S>& body, S t_max) {
  if (const Invalid one = graze::validate(body.body); one != Invalid::none) return one;
  if (const Invalid one = first_of({check_vector(body.rotation), check_vector(body.pivot)});
      one != Invalid::none)
    return one;
  const double turned = norm(wide(body.rotation)) * static_cast<double>(t_max);
  return t_max < kInfinity<S> && turned > kMostTurn ? Invalid::out_of_range : Invalid::none;
}

template <Scalar S>
CastOptions<S> linear_options(const RotatingOptions<S>& options) {
  CastOptions<S> out;
  out.tier = options.tier;
  out.request =
      static_cast<Request>(static_cast<unsigned>(options.request) & ~static_cast<unsigned>(Request::proof));
  out.t_max = options.t_max;
  out.target_distance = options.target_distance;
  out.start_policy = options.start_policy;
  return out;
}

template <Scalar S>
Invalid validate(const RotatingBody<S>& a, const RotatingBody<S>& b, const RotatingOptions<S>& options) {
  if (const Invalid one = check_arithmetic(); one != Invalid::none) return one;
  if (const Invalid one = graze::validate(linear_options(options)); one != Invalid::none) return one;
  if (!(options.tolerance >= 0 && options.tolerance < kInfinity<S>) || options.max_iterations < 1 ||
      options.time_steps < 1)
    return Invalid::bad_tolerance;
  if (const Invalid one = validate(a, options.t_max); one != Invalid::none) return one;
  return validate(b, options.t_max);
}

// Locates the value for which validate() above refuses: the same checks in the same order.
template <Scalar S>
[[gnu::noinline]] InvalidAt find_invalid(const RotatingBody<S>& a, const RotatingBody<S>& b,
                                         const RotatingOptions<S>& options) {
  InvalidFinder<S> find;
  if (find.arithmetic() || find.options(linear_options(options)) ||
      find.limits(options.tolerance, options.max_iterations))
    return find.at();
  if (options.time_steps < 1) return {.why = Invalid::bad_tolerance, .field = InvalidField::time_steps};
  for (const InvalidBody which : {InvalidBody::a, InvalidBody::b}) {
    const RotatingBody<S>& body = which == InvalidBody::a ? a : b;
    if (find.body(body.body, which) || find.vector(InvalidField::rotation, body.rotation) ||
        find.vector(InvalidField::pivot, body.pivot))
      return find.at();
    if (const Invalid why = validate(body, options.t_max); why != Invalid::none)
      return {.why = why, .body = which, .field = InvalidField::rotation};
  }
  return find.at();
}

template <Scalar S>
class RotatingCast {
 public:
  RotatingCast(const RotatingBody<S>& a, const RotatingBody<S>& b, const RotatingOptions<S>& options)
      : a_(a), b_(b), options_(options) {}

  RotatingResult<S> operator()() {
    if (!prepare()) return out_;
    if (options_.method) {
      run(*options_.method);
    } else {
      follow_plan();
    }
    return out_;
  }

  Plan plan() {
    prepare();
    return out_.plan;
  }

 private:
  [[nodiscard]] bool passes_over() const { return options_.start_policy == StartPolicy::pass_over; }
  // Only the methods that never miss a contact follow one.
  static bool follows(RotatingMethod method) {
    return method == RotatingMethod::conservative_advancement ||
           method == RotatingMethod::bilateral_advancement;
  }
  [[nodiscard]] bool wants_proof() const { return asks_for(options_.request, Request::proof); }
  [[nodiscard]] double scale() const { return pair_->scale(); }
  [[nodiscard]] double t_end() const { return static_cast<double>(options_.t_max); }
  // Internal lengths: the least gap at which axes are useful, and the caller's allowance at either end of the
  // bracket.
  [[nodiscard]] double stop() const { return kRotatingStop * pair_->error(); }
  [[nodiscard]] double width() const {
    double width = static_cast<double>(options_.tolerance);
    if (options_.tier == Tier::certified) {
      const bool turns = out_.plan.effects == Effects::rotating &&
                         (pair_->mobility_a().turns() || pair_->mobility_b().turns());
      const double most = turns ? kCertifiedTurningWidth : kCertifiedWidth;
      width = width > 0 ? std::min(width, most) : most;
    }
    return kWidthPart * width * scale();
  }
  // Bodies as near are in contact, in tier standard. A gap of `stop`, which its rounding and the end of the search
  // make half as much again, is within.
  [[nodiscard]] double touching() const { return std::max(noise(), 2 * stop()); }
  [[nodiscard]] double noise() const {
    return options_.tier == Tier::standard ? kContact * double(kUnitRoundoff<S>) * scale() : 0.0;
  }

  // The door and the plan. False: the answer is out_.
  bool prepare() {
    out_.invalid = validate(a_, b_, options_);
    if (out_.invalid != Invalid::none) {
      out_.invalid_at = find_invalid(a_, b_, options_);
      GRAZE_ASSERT(out_.invalid_at.why == out_.invalid);
      return false;
    }
    const bool turns = a_.rotation != Vec3<S>::Zero() || b_.rotation != Vec3<S>::Zero();
    if (!turns && !options_.method) {
      out_.plan = plan_without_rotation(a_, b_, options_.economies);
      return true;
    }
    if (passes_by()) {
      out_.plan.effects = Effects::nothing;
      out_.plan.add(PlanReason::bounds_never_meet);
      return true;
    }
    pair_.emplace(a_, b_, static_cast<double>(options_.target_distance));
    if (options_.method) {
      out_.plan.effects = Effects::rotating;
      if (!turns) out_.plan.add(PlanReason::no_rotation);
      if (pair_->mobility_a().turns()) out_.plan.add(PlanReason::rotation_a);
      if (pair_->mobility_b().turns()) out_.plan.add(PlanReason::rotation_b);
    } else {
      out_.plan = plan_of(*pair_, a_, b_, options_.economies, {t_end(), noise()});
    }
    if (is_linear() && !sees_turn_unended()) return true;
    if (!(options_.t_max < kInfinity<S>)) {
      refuse(Invalid::not_linear, InvalidField::t_max);
    } else if (passes_over() && options_.method && !follows(*options_.method)) {
      refuse(Invalid::not_followed, InvalidField::start_policy);
    } else if (options_.tier == Tier::exact) {
      refuse(Invalid::not_exact, InvalidField::tier);
    }
    return out_.invalid == Invalid::none;
  }

  // Decided without preparing anything, if the plan would find it.
  [[nodiscard]] bool passes_by() const {
    if (options_.method || !options_.economies.bounds) return false;
    if (!(options_.t_max < kInfinity<S>)) return false;
    const double more =
        options_.tier == Tier::standard ? kContact * double(kUnitRoundoff<S>) / kUnitRoundoff<double> : 0.0;
    return outer_spheres_never_meet(a_, b_, static_cast<double>(options_.target_distance), t_end(), more);
  }

  // Without an end, a rotation that is not negligible has no meaning, even if the bounds never meet.
  [[nodiscard]] bool sees_turn_unended() const {
    if (out_.plan.effects != Effects::nothing) return false;
    if (options_.t_max < kInfinity<S>) return false;
    Economies without = options_.economies;
    without.bounds = false;
    return plan_of(*pair_, a_, b_, without, {t_end(), noise()}).effects == Effects::rotating;
  }

  void follow_plan() {
    if (wants_proof() && options_.t_max < kInfinity<S> && options_.tier != Tier::exact) {
      // A chain records the proof of the whole motion, whatever the plan omits. A linear motion's start in contact
      // that is passed over, or reported, has no chain.
      if (passes_over() && is_linear()) {
        follow_effects();
        if (!(out_.toi_lower > 0) || out_.passed_over) return;
        out_.toi_lower = out_.toi_upper = std::numeric_limits<S>::quiet_NaN();
      }
      if (!pair_) pair_.emplace(a_, b_, static_cast<double>(options_.target_distance));
      return run(RotatingMethod::bilateral_advancement);
    }
    follow_effects();
  }
  [[nodiscard]] bool is_linear() const { return out_.plan.effects != Effects::rotating; }
  void follow_effects() {
    switch (out_.plan.effects) {
      case Effects::nothing:
        out_.outcome = Outcome::miss;
        out_.toi_lower = out_.toi_upper = kInfinity<S>;
        return;
      case Effects::at_rest:
        run_at_rest();
        return follow_linear_start();
      case Effects::linear:
        take(graze::cast(a_.body, b_.body, linear_options(options_)));
        return follow_linear_start();
      case Effects::rotating:
        return run(RotatingMethod::bilateral_advancement);
    }
  }
  // A linear cast reports a start whose depth is within rounding, if the motion neither leaves nor slides to the last
  // bit, as for a ball that rolls along the floor. As for all contacts of rotating casts, the criterion is whether it
  // gets deeper.
  void follow_linear_start() {
    if (!passes_over() || out_.outcome != Outcome::initially_overlapping) return;
    if (options_.tier == Tier::exact || !(options_.t_max < kInfinity<S>)) return;
    RotatingResult<S> followed;
    followed.plan = out_.plan;
    followed.counters = out_.counters;
    out_ = std::move(followed);
    if (!pair_) pair_.emplace(a_, b_, static_cast<double>(options_.target_distance));
    run(RotatingMethod::bilateral_advancement);
  }

  void take(const CastResult<S>& linear) {
    out_.outcome = linear.outcome;
    out_.invalid = linear.invalid;
    out_.invalid_at = linear.invalid_at;
    out_.toi_lower = linear.toi_lower;
    out_.toi_upper = linear.toi_upper;
    out_.distance = std::max(linear.distance, S(0));
    out_.passed_over = linear.passed_over;
    out_.normal = linear.normal;
    out_.point_a = linear.point_a;
    out_.point_b = linear.point_b;
    out_.counters += linear.counters;
  }

  // The bodies stand still to each other: contact now, or never.
  void run_at_rest() {
    CastOptions<S> options = linear_options(options_);
    options.t_max = 0;
    take(graze::cast(a_.body, b_.body, options));
  }

  void run(RotatingMethod method) {
    if (!(options_.t_max < kInfinity<S>)) return refuse(Invalid::not_linear, InvalidField::t_max);
    switch (method) {
      case RotatingMethod::time_steps:
        return run_steps(0);
      case RotatingMethod::bounding_spheres: {
        const SphereCast spheres = cast_spheres(*pair_, t_end(), 0);
        if (spheres.meet) return run_steps(spheres.begin);
        out_.outcome = Outcome::miss;
        out_.toi_lower = out_.toi_upper = kInfinity<S>;
        return;
      }
      case RotatingMethod::conservative_advancement:
        return run_march(Advance::conservative);
      case RotatingMethod::bilateral_advancement:
        return run_march(Advance::bilateral);
      case RotatingMethod::bilateral_published: {
        const double slop = options_.tolerance > 0 ? static_cast<double>(options_.tolerance) : kPublishedSlop;
        const PublishedLimits limits{t_end(), slop * scale(), slop * scale() / 4, options_.max_iterations};
        return fill(PublishedBilateral(*pair_, limits, out_.counters)());
      }
    }
  }
  void refuse(Invalid why, InvalidField field) {
    out_.invalid = why;
    out_.invalid_at = {.why = why, .field = field};
  }

  void run_steps(double begin) {
    StepLimits limits;
    limits.begin = begin;
    limits.end = t_end();
    limits.steps = options_.time_steps;
    limits.touching = stop();
    limits.width = width();
    limits.budget = options_.max_iterations;
    out_.hidden_motion =
        round_up<S>(pair_->cso().to_length(pair_->top_speed()) * t_end() / options_.time_steps);
    fill(step_through(*pair_, limits, out_.counters));
  }

  void run_march(Advance advance) {
    MarchLimits limits;
    limits.advance = advance;
    limits.end = t_end();
    limits.stop = stop();
    limits.width = width();
    limits.touching = options_.tier == Tier::standard ? touching() : -1.0;
    limits.proves_later = wants_proof();
    limits.budget = options_.max_iterations;
    limits.record = wants_proof();
    limits.may_sweep = {!limits.record || has_plain_ball(a_.body.shape),
                        !limits.record || has_plain_ball(b_.body.shape)};
    limits.asks_start = options_.tier == Tier::certified;
    if (passes_over() && !leaves_start(limits)) return;
    March found = march(*pair_, limits, out_.counters);
    if (is_open_at_start(found)) {
      if (touches_at_start()) return;
      limits.asks_start = false;
      found = march(*pair_, limits, out_.counters);
    }
    if (limits.record) out_.proof = proof_of(found);
    fill(found);
    if (out_.outcome != Outcome::miss) out_.passed_over = false;
  }

  // Under the policy pass_over, follows a contact at the start. False: that is the answer, in out_. Otherwise the
  // march begins at a time with the bodies apart, and its result is the answer, passed over if it is a miss.
  bool leaves_start(MarchLimits& march_limits) {
    const double allowed =
        std::max(kFollowedDepth<S>(options_.tier) * scale(), kFollowedErrors * pair_->error());
    const FollowLimits limits{.end = t_end(),
                              .allowed = allowed,
                              .apart = std::max(allowed / 4, 2 * touching()),
                              .touching = touching(),
                              .width = march_limits.width,
                              .stop = march_limits.stop,
                              .budget = std::min(march_limits.budget, kMostFollowedSupports)};
    Followed start = ContactFollower(*pair_, limits, out_.counters)();
    using State = Followed::State;
    const bool certified = options_.tier == Tier::certified;
    switch (start.state) {
      case State::none:
        return true;
      case State::separated:
        march_limits.begin = start.found.lower;
        march_limits.record = false;  // no chain of axes shows a contact that is followed
        out_.passed_over = true;
        return true;
      case State::ended:
        out_.passed_over = true;
        start.found.outcome = Outcome::miss;
        break;
      case State::deeper:
        start.found.outcome = Outcome::hit;
        break;
      case State::deep:
        if (certified && !start.proved)
          return refuse(Invalid::not_followed, InvalidField::start_policy), false;
        start.found.outcome = Outcome::initially_overlapping;
        break;
      case State::open:
        if (certified && out_.counters.supports < march_limits.budget)
          return refuse(Invalid::not_followed, InvalidField::start_policy), false;
        break;
    }
    fill(start.found);
    return false;
  }

  // A contact at t = 0 that no ball about the origin proves. The origin is on C's boundary, or its distance from the
  // border of the hull of any four support points is within rounding. No body has rotated yet, so the linear tier may
  // decide.
  [[nodiscard]] bool is_open_at_start(const March& found) const {
    return options_.tier == Tier::certified && found.lower == 0 && found.outcome != Outcome::miss &&
           found.outcome != Outcome::initially_overlapping;
  }
  bool touches_at_start() {
    RotatingProof proof;
    if (!touches_exactly(proof) && !touches_by_linear_tier(proof)) return false;
    if (wants_proof()) out_.proof = std::move(proof);
    March contact;
    contact.outcome = Outcome::initially_overlapping;
    fill(contact);
    return true;
  }
  bool touches_exactly(RotatingProof& proof) {
    pair_->place(0);
    Simplex<double> closest;
    const Distance<double> d = gjk_distance(pair_->cso(), Vec3<double>(Vec3<double>::Zero()), closest, 0.0,
                                            0.0, options_.max_iterations, out_.counters);
    return d.upper <= pair_->error() && touches(*pair_, a_.body, b_.body, closest, proof);
  }
  bool touches_by_linear_tier(RotatingProof& proof) {
    CastOptions<S> options = linear_options(options_);
    options.t_max = 0;
    options.request = wants_proof() ? Request::proof : Request::verdict;
    const CastResult<S> start = graze::cast(a_.body, b_.body, options);
    out_.counters += start.counters;
    if (start.outcome != Outcome::initially_overlapping) return false;
    if (!wants_proof()) return true;
    if (!start.proof || !(start.proof->toi_upper == 0)) return false;
    if (start.proof->portal_size == 0)
      return true;  // of curved shapes that touch: decided, and nothing to name
    proof.toi_upper = 0;
    proof.contact_size = start.proof->portal_size;
    std::copy(start.proof->portal.begin(), start.proof->portal.end(), proof.contact.begin());
    proof.weight = {0.25, 0.25, 0.25, 0.25};
    return true;
  }

  void fill(const March& found) {
    out_.outcome = found.outcome;
    out_.counters.poses = pair_->poses();
    if (found.outcome == Outcome::miss) {
      out_.toi_lower = out_.toi_upper = kInfinity<S>;
      return;
    }
    if (found.outcome == Outcome::initially_overlapping) {
      out_.toi_lower = out_.toi_upper = 0;
      return;
    }
    GRAZE_ASSERT(0 <= found.lower && found.lower <= found.upper);
    out_.toi_lower = round_down<S>(found.lower);
    out_.toi_upper = found.upper < kInfinity<double> ? round_up<S>(found.upper) : kInfinity<S>;
    double apart = found.apart;
    if (found.upper < kInfinity<double> && found.upper > found.lower) {
      // Contact is at upper: the rest of the motion bounds the distance as well.
      apart = std::min(apart, pair_->approach_speed(t_end()) * (found.upper - found.lower) * (1 + 0x1p-50));
    }
    apart += fl(pair_->approach_speed(t_end()) * (found.lower - static_cast<double>(out_.toi_lower)) *
                (1 + 0x1p-50));
    // If a translation overflowed the range of doubles, nothing is known.
    if (!(apart < kInfinity<double>)) apart = kInfinity<double>;
    out_.distance = round_up<S>(pair_->cso().to_length(apart));
    // A search that used up its budget before it found an axis has no location.
    if (found.n == Vec3<double>::Zero()) return;
    if (asks_for(options_.request, Request::normal)) out_.normal = found.n.template cast<S>();
    if (asks_for(options_.request, Request::witnesses)) set_witnesses(found);
  }

  // The closest points at toi_lower, each on its own body.
  void set_witnesses(const March& found) {
    // The points are determined at the time at which they were found, because on a flat end they depend on the last
    // bit of a direction.
    pair_->place(found.lower);
    const Cso<double>& cso = pair_->cso();
    Vec3<double> x_a = Vec3<double>::Zero(), x_b = Vec3<double>::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(found.closest.size); ++i) {
      const CsoPoint<double>& p = found.closest.point[i];
      const auto& side_a = cso.side_a();
      const auto& side_b = cso.side_b();
      const Vec3<double> d_b = -p.n;
      x_a += found.closest.lambda[i] * side_a.support(side_a, side_a.to_own(p.n), &p.vertex_a).x;
      x_b += found.closest.lambda[i] * side_b.support(side_b, side_b.to_own(d_b), &p.vertex_b).x;
    }
    const double t = static_cast<double>(out_.toi_lower);
    pair_->place(t);
    const Vec3<double> rel_a = cso.side_a().to_world(x_a) + cso.side_a().radius * found.n;
    const Vec3<double> rel_b = cso.side_b().to_world(x_b) - cso.side_b().radius * found.n;
    // From the centre to the pivot of A and to the world: long arms cancel, so nothing is rounded before the
    // end.
    const double length = power_of_two(cso.length_exponent());
    const TwoDoubles3 at_a = scaled_by(pair_->center_a_in_two(), length),
                      at_b = scaled_by(pair_->center_b_in_two(), length);
    const TwoDoubles3 turned = posed(scaled_near_one(a_.body.orientation), pair_->pivot_a());
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const TwoDoubles origin = (two_sum(double(a_.body.position[i]), 0) + turned[k]) +
                                times({double(a_.body.displacement[i]), 0}, t);
      const auto world = [&](const TwoDoubles& center, double rel) {
        const TwoDoubles sum = (origin + center) + TwoDoubles{cso.to_length(rel), 0};
        return static_cast<S>(sum.hi + sum.lo);
      };
      out_.point_a[i] = world(at_a[k], rel_a[i]);
      out_.point_b[i] = world(at_b[k], rel_b[i]);
    }
  }

  // The chain, and the pairs of the contact by name.
  RotatingProof proof_of(March& found) {
    RotatingProof proof;
    proof.toi_lower = found.lower;
    proof.chain = std::move(found.chain);
    if (!found.contact.proved) return proof;
    if (found.contact.unweighed) weigh(found.contact.pairs);
    pair_->place(found.upper);
    const Cso<double>& cso = pair_->cso();
    const Vec3<double> none = Vec3<double>::Zero();
    // The fourth, or those that it is the mean of.
    const auto means = found.contact.means, last = means > 0 ? std::size_t(3) : std::size_t(4);
    const auto size = means > 0 ? last + means : static_cast<std::size_t>(found.contact.pairs.size);
    for (std::size_t i = 0; i < size; ++i) {
      const CsoPoint<double>& p = i < last ? found.contact.pairs.point[i] : found.contact.mean_of[i - last];
      SupportPair& named = proof.contact[i];
      if (!name_feature(a_.body, cso.side_a(), p.vertex_a, p.n, none, 0.0, named.a) ||
          !name_feature(b_.body, cso.side_b(), p.vertex_b, Vec3<double>(-p.n), none, 0.0, named.b))
        return proof;
      proof.weight[i] = found.contact.crossing ? 0.0
                        : i < last             ? found.contact.pairs.lambda[i]
                                               : found.contact.pairs.lambda[last] / double(means);
    }
    proof.crossing = found.contact.crossing;
    proof.contact_from = found.contact.from;
    proof.contact_size = static_cast<int>(size);
    proof.toi_upper = found.upper;
    return proof;
  }

  const RotatingBody<S>&a_, &b_;
  const RotatingOptions<S>& options_;
  RotatingResult<S> out_;
  std::optional<MovingPair> pair_;
};

}  // namespace detail

template <Scalar S>
RotatingResult<S> cast(const RotatingBody<S>& a, const RotatingBody<S>& b,
                       const RotatingOptions<S>& options) {
  return detail::RotatingCast<S>(a, b, options)();
}

template <Scalar S>
Plan plan(const RotatingBody<S>& a, const RotatingBody<S>& b, const RotatingOptions<S>& options) {
  return detail::RotatingCast<S>(a, b, options).plan();
}

}}  // namespace graze::GRAZE_LINKAGE
