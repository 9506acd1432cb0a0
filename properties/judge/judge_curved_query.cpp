// Answers to queries between bodies that the exact oracles do not represent, by brackets that ball arithmetic
// proves (oracles/truth/bracket_truth.hpp) in the place of exact numbers.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/format/names.hpp"
#include "oracles/truth/bracket_truth.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/limits.hpp"

namespace graze::law {
namespace {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Interval;
using engine::Method;
using oracle::BracketTruth;
using oracle::Enclosure;

// What the oracle is asked: the motion of the case, whatever its query. Displacements are never subtracted or
// scaled by anything but a sign, so that nothing rounds.
Case as_cast(Case problem) {
  problem.query = Query::cast;
  problem.start_policy = StartPolicy::report;
  return problem;
}
Case at_rest(Case problem) {
  problem.target_distance = 0;
  problem.a.displacement.setZero();
  problem.b.displacement.setZero();
  return as_cast(std::move(problem));
}
// The whole ray along the motion, or back.
Case ray_of(Case path, bool onward) {
  path.t_max = kInfinity<double>;
  if (onward) return path;
  path.a.displacement *= -1;
  path.b.displacement *= -1;
  return path;
}
Vec3<double> relative(const Case& problem) { return problem.b.displacement - problem.a.displacement; }

bool is_along_the_path(Query query) { return query == Query::line || query == Query::swept_overlap; }

class CurvedJudge {
 public:
  CurvedJudge(const Case& problem, const Method& method, const Answer& answer, double tolerance)
      : problem_(problem),
        answer_(answer),
        has_witnesses_(method.holds.witnesses),
        rest_(at_rest(problem)),
        pair_(is_along_the_path(problem.query) ? as_cast(problem) : at_rest(problem)) {
    scale_ = scale_of_question(problem.query, problem.target_distance, pair_.scale().high);
    limits_ = limits_of(method, problem, scale_);
    limit_ = limits_.limit;
    wide_ = limit_ + tolerance * scale_;
    judgement_.outcome = answer.outcome;
    judgement_.errors.scale = scale_;
    judgement_.stalled = answer.stalled || answer.outcome == Outcome::not_converged;
  }

  Judgement operator()() {
    if (answer_.outcome == Outcome::invalid_input) {
      add_fault(judgement_.wrong, "a valid case was refused");
      return judgement_;
    }
    switch (problem_.query) {
      case Query::overlap:
        verdict_at_rest();
        break;
      case Query::distance:
        distance();
        break;
      case Query::penetration:
        penetration();
        break;
      case Query::penetration_along:
        penetration_along();
        break;
      case Query::line:
        line();
        break;
      case Query::swept_overlap:
        verdict(answer_.outcome == Outcome::hit, pair_, [&] { return pair_.clearance(); });
        break;
      case Query::cast:
        add_fault(judgement_.wrong, "a cast is judged elsewhere");
        break;
    }
    return judgement_;
  }

 private:
  void erred(double length) {
    const double error = std::max(length, 0.0);
    judgement_.errors.backward = std::fmax(judgement_.errors.backward, in_scale(error));
    judgement_.errors.over_limit = std::fmax(judgement_.errors.over_limit, over(error, wide_));
  }
  [[nodiscard]] double in_scale(double length) const { return over(length, scale_); }

  // A claim that errs by this much, proved.
  void verdict_errs(double error, const char* what) {
    erred(error);
    if (error <= limit_) {
      judgement_.within_tolerance = true;
    } else {
      add_fault(judgement_.wrong, fmt::format("says {}; {} by {:.2e} of scale",
                                              corpus::name_of(answer_.outcome), what, in_scale(error)));
    }
  }
  // `apart` is the length by which a claim of contact errs where there is none.
  template <class Apart>
  void verdict(bool claims, const BracketTruth& truth, const Apart& apart) {
    if (answer_.outcome == Outcome::not_converged) return;
    if (truth.outcome() == Outcome::miss) {
      if (claims) verdict_errs(apart().low, "they are apart");
    } else if (truth.contact_proved() || truth.outcome() != Outcome::not_converged) {
      if (!claims) verdict_errs(truth.depth().low, "they overlap");
    } else {
      judgement_.within_tolerance = true;
    }
  }
  void verdict_at_rest() {
    verdict(answer_.outcome == Outcome::initially_overlapping, rest_, [&] { return rest_.distance(); });
  }
  // Either end of a bracket; one that says of itself that it is wide may be.
  void measure(const char* what, double error) {
    if (judgement_.stalled) return;
    erred(error);
    if (!(error <= wide_)) {
      add_fault(judgement_.off, fmt::format("{} is off by {:.2e} of scale", what, in_scale(error)));
    }
  }
  // A bracket that does not hold the truth is off, however wide it says it is.
  void held(const char* what, double miss) {
    if (!(miss <= limit_)) {
      add_fault(judgement_.off,
                fmt::format("the bracket of {} misses it by {:.2e} of scale", what, in_scale(miss)));
    }
  }
  void holds(const char* what, const Interval& bracket, const Enclosure& value) {
    if (!(bracket.lower <= bracket.upper))
      return add_fault(judgement_.off, fmt::format("{} has no bracket", what));
    const double miss = std::max({bracket.lower - value.high, value.low - bracket.upper, 0.0});
    held(what, miss);
    measure(what, std::max({value.low - bracket.lower, bracket.upper - value.high, miss}));
  }
  [[nodiscard]] double rounding(const Vec3<double>& point) const {
    return 2 * limits_.unit_roundoff * point.norm();
  }
  // Do they lie on their bodies? False: something is missing or off, or not part of the method's answers.
  bool witnesses() {
    if (!has_witnesses_) return false;
    for (const char body : {'a', 'b'}) {
      const Vec3<double>& point = body == 'a' ? answer_.point_a : answer_.point_b;
      if (!answer_.has_points) {
        add_fault(judgement_.bad_contact, "a witness is missing");
        return false;
      }
      const double error = rest_.distance_from_body(body, 0, point).low - rounding(point) -
                           (body == 'a' ? answer_.reach_a : answer_.reach_b);
      judgement_.errors.witness = std::fmax(judgement_.errors.witness, in_scale(std::max(error, 0.0)));
      if (!(error <= limit_)) {
        add_fault(judgement_.bad_contact,
                  fmt::format("a witness is {:.2e} of scale off its body", in_scale(error)));
        return false;
      }
    }
    return true;
  }

  void distance() {
    verdict_at_rest();
    if (!answer_.separation) return add_fault(judgement_.wrong, "no distance");
    const Enclosure true_distance = rest_.distance();
    holds("the distance", *answer_.separation, true_distance);
    if (answer_.outcome != Outcome::miss || !witnesses() || judgement_.stalled) return;
    const double between = (answer_.point_a - answer_.point_b).norm();
    // A pair of points on bodies that reach less far than those that are seen is farther apart by as much.
    const double reach = std::max(answer_.reach_a, answer_.reach_b);
    const double error = std::max(true_distance.low - between, between - reach - true_distance.high) -
                         rounding(answer_.point_a) - rounding(answer_.point_b);
    if (!(error <= 2 * limit_ + wide_)) {
      add_fault(judgement_.bad_contact,
                fmt::format("the closest points' distance is {:.2e} of scale off", in_scale(error)));
    }
  }

  // Common to both kinds. True if there is a depth to judge.
  bool has_depth() {
    verdict_at_rest();
    if (answer_.outcome != Outcome::initially_overlapping) return false;
    if (!answer_.depth) add_fault(judgement_.wrong, "no depth");
    return answer_.depth.has_value() && rest_.outcome() == Outcome::initially_overlapping;
  }
  // The depth is the least h(n) over unit n: no more than h of the answer's own normal, whose enclosure is
  // narrow, and no less than the bracket proves.
  void penetration() {
    if (!has_depth()) return;
    Enclosure proved = rest_.penetration().distance;
    if (answer_.has_normal()) {
      const Enclosure reach = rest_.normal_error(answer_.normal);
      const double beyond = reach.low - answer_.depth->upper;
      if (!judgement_.stalled) {
        judgement_.errors.normal = std::fmax(judgement_.errors.normal, in_scale(std::max(beyond, 0.0)));
        if (!(beyond <= wide_)) {
          add_fault(judgement_.bad_contact,
                    fmt::format("the normal is {:.2e} of scale off", in_scale(beyond)));
        }
      }
      proved.high = std::min(proved.high, reach.high);
    }
    holds("the depth", *answer_.depth, proved);
    (void)witnesses();
  }

  // What is left of the line beyond t v, seen along the motion (onward) or back: its depth in C, less what
  // the start there rounds to.
  [[nodiscard]] double depth_beyond(const Case& path, double t, bool onward) const {
    const Vec3<double> step = t * relative(path);
    Case rest_of_it = ray_of(path, onward);
    rest_of_it.b.position += step;
    const double rounded = 4 * kUnitRoundoff<double> * (step.norm() + path.b.position.norm());
    return BracketTruth(rest_of_it).depth().low - rounded;
  }
  void end_of_line(const char* what, const Case& path, const BracketTruth& truth, const Interval& bracket,
                   const Enclosure& end, bool onward) {
    // A time that the scalar cannot hold lies between its largest number and infinity, of either sign.
    const double u = limits_.unit_roundoff;
    if ((is_beyond_range(bracket.lower, bracket.upper, u) ||
         is_beyond_range(-bracket.upper, -bracket.lower, u)) &&
        bracket.lower <= end.high && end.low <= bracket.upper) {
      return;
    }
    const double largest = u == kUnitRoundoff<float> ? double(std::numeric_limits<float>::max())
                                                     : std::numeric_limits<double>::max();
    for (const double given : {bracket.lower, bracket.upper}) {
      const double t = std::clamp(given, -largest, largest);
      if (!(t * relative(path)).allFinite() || std::isnan(given)) {
        return add_fault(judgement_.off, fmt::format("{} is not finite", what));
      }
      if (!judgement_.stalled)
        measure(what, std::max(truth.distance_at(t).low, depth_beyond(path, t, onward)));
    }
    // Beyond the end on the wrong side of it, however wide: there is contact before t_in, none after t_out.
    const auto missed_by = [&](double t, bool in_contact) {
      t = std::clamp(t, -largest, largest);
      return in_contact ? depth_beyond(path, t, onward) : truth.distance_at(t).low;
    };
    if (bracket.lower > end.high) held(what, missed_by(bracket.lower, !onward));
    if (bracket.upper < end.low) held(what, missed_by(bracket.upper, onward));
  }

  void penetration_along() {
    if (!has_depth()) return;
    const Vec3<double> d = problem_.direction;
    Case path = at_rest(problem_);
    path.b.displacement = d;
    const Interval times = {answer_.depth->lower / d.norm(), answer_.depth->upper / d.norm()};
    const BracketTruth truth(path);
    end_of_line("the depth", path, truth, times, truth.contact_interval().t_out, true);
    (void)witnesses();
  }

  void line() {
    const oracle::LineContact contact = pair_.contact_interval();
    const bool claims = answer_.outcome == Outcome::hit, open = answer_.outcome == Outcome::not_converged;
    if (contact.outcome == Outcome::not_converged) {
      judgement_.within_tolerance = !open;
      return;
    }
    const Case path = as_cast(problem_);
    const bool moves = relative(problem_) != Vec3<double>::Zero();
    if (contact.outcome == Outcome::miss) {
      if (claims) verdict_errs(moves ? line_clearance(path) : pair_.clearance().low, "they are apart");
      return;
    }
    if (open && (!moves || !answer_.t_in || !answer_.t_out)) return;
    if (!claims && !open) {
      return verdict_errs(moves ? depth_beyond(path, contact.t_in.low, true) : pair_.depth().low,
                          "they overlap");
    }
    if (!answer_.t_in || !answer_.t_out) return add_fault(judgement_.off, "an end is missing");
    if (!moves) {
      const bool always =
          answer_.t_in->upper == -kInfinity<double> && answer_.t_out->lower == kInfinity<double>;
      if (!always) add_fault(judgement_.off, "bodies at rest and in contact have an end");
      return;
    }
    end_of_line("t_in", path, pair_, *answer_.t_in, contact.t_in, false);
    end_of_line("t_out", path, pair_, *answer_.t_out, contact.t_out, true);
  }
  // Of a line that misses: from its point at t = 0, either way.
  [[nodiscard]] static double line_clearance(const Case& path) {
    double least = kInfinity<double>;
    for (const bool onward : {true, false}) {
      least = std::min(least, BracketTruth(ray_of(path, onward)).clearance().low);
    }
    return least;
  }

  const Case& problem_;
  const Answer& answer_;
  bool has_witnesses_;
  Limits limits_;
  BracketTruth rest_, pair_;                 // at t = 0 without the target distance; as the query asks
  double scale_ = 0, limit_ = 0, wide_ = 0;  // wide_: of the ends of a bracket, the tolerance counted
  Judgement judgement_;
};

}  // namespace

Judgement judge_curved_query(const Case& seen, const Method& method, const Answer& answer, double tolerance) {
  return CurvedJudge(seen, method, answer, tolerance)();
}

}  // namespace graze::law
