// Judges answers to queries between bodies that the exact oracles do not represent. It uses brackets that ball
// arithmetic proves (oracles/truth/bracket_truth.hpp) instead of exact numbers.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracles/truth/bracket_truth.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/limits.hpp"
#include "properties/judge/query_judge.hpp"

namespace graze::law {
namespace {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Interval;
using engine::Method;
using oracle::BracketTruth;
using oracle::Enclosure;

// The oracle's question: the motion of the case, whatever its query. Displacements are never subtracted or scaled by
// anything but a sign, so that nothing rounds.
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

class CurvedJudge : public QueryJudge {
 public:
  // `rest`: at t = 0 without the target distance. `pair`: as the query asks.
  CurvedJudge(const Case& problem, const Method& method, const Answer& answer, double tolerance,
              const BracketTruth& rest, const BracketTruth& pair)
      : QueryJudge(problem, method, answer, tolerance,
                   scale_of_question(problem.query, problem.target_distance, pair.scale().high)),
        rest_(rest),
        pair_(pair) {}

 private:
  // `apart` is the length by which a wrong claim of contact errs.
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
  void holds(const char* what, const Interval& bracket, const Enclosure& value) {
    if (!(bracket.lower <= bracket.upper))
      return add_fault(judgement_.off, fmt::format("{} has no bracket", what));
    const double miss = std::max({bracket.lower - value.high, value.low - bracket.upper, 0.0});
    held(what, miss);
    measure(what, std::max({value.low - bracket.lower, bracket.upper - value.high, miss}));
  }
  double distance_from_body(char body, const Vec3<double>& point) override {
    return rest_.distance_from_body(body, 0, point).low;
  }

  void overlap() override { verdict_at_rest(); }
  void swept_overlap() override {
    verdict(answer_.outcome == Outcome::hit, pair_, [&] { return pair_.clearance(); });
  }
  void distance() override {
    verdict_at_rest();
    if (!answer_.separation) return add_fault(judgement_.wrong, "no distance");
    const Enclosure true_distance = rest_.distance();
    holds("the distance", *answer_.separation, true_distance);
    if (answer_.outcome == Outcome::miss && witnesses() && !judgement_.stalled) closest_points(true_distance);
  }

  // Common to both kinds of depth. True if there is one to judge.
  bool has_depth() {
    verdict_at_rest();
    return states_depth() && rest_.outcome() == Outcome::initially_overlapping;
  }
  // The depth is the least h(n) over unit n: no more than h of the answer's own normal, whose enclosure is
  // narrow, and no less than the bracket proves.
  void penetration() override {
    if (!has_depth()) return;
    Enclosure proved = rest_.penetration().distance;
    if (answer_.has_normal()) {
      const Enclosure reach = rest_.normal_error(answer_.normal);
      if (!judgement_.stalled) normal_off(reach.low - answer_.depth->upper, wide_);
      proved.high = std::min(proved.high, reach.high);
    }
    holds("the depth", *answer_.depth, proved);
    (void)witnesses();
  }

  // The rest of the line beyond t v, along the motion (onward) or back: its depth in C, less the rounding of
  // its start.
  [[nodiscard]] double depth_beyond(const Case& path, double t, bool onward) const {
    const Vec3<double> step = t * relative(path);
    Case rest_of_it = ray_of(path, onward);
    rest_of_it.b.position += step;
    const double rounded = 4 * kUnitRoundoff<double> * (step.norm() + path.b.position.norm());
    return BracketTruth(rest_of_it).depth().low - rounded;
  }
  void end_of_line(const char* what, const Case& path, const BracketTruth& truth, const Interval& bracket,
                   const Enclosure& end, bool onward) {
    if (is_beyond_scalar(bracket, end)) return;
    for (const double given : {bracket.lower, bracket.upper}) {
      const double t = std::clamp(given, -largest(), largest());
      if (!(t * relative(path)).allFinite() || std::isnan(given)) {
        return add_fault(judgement_.off, fmt::format("{} is not finite", what));
      }
      if (!judgement_.stalled)
        measure(what, std::max(truth.distance_at(t).low, depth_beyond(path, t, onward)));
    }
    // Beyond the end on the wrong side of it, however wide: there is contact before t_in, none after t_out.
    const auto missed_by = [&](double t, bool in_contact) {
      t = std::clamp(t, -largest(), largest());
      return in_contact ? depth_beyond(path, t, onward) : truth.distance_at(t).low;
    };
    if (bracket.lower > end.high) held(what, missed_by(bracket.lower, !onward));
    if (bracket.upper < end.low) held(what, missed_by(bracket.upper, onward));
  }

  void penetration_along() override {
    if (!has_depth()) return;
    const Vec3<double> d = problem_.direction;
    Case path = at_rest(problem_);
    path.b.displacement = d;
    const Interval times = {answer_.depth->lower / d.norm(), answer_.depth->upper / d.norm()};
    const BracketTruth truth(path);
    end_of_line("the depth", path, truth, times, truth.contact_interval().t_out, true);
    (void)witnesses();
  }

  void line() override {
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
  // For a line that misses: its clearance from the point at t = 0, either way.
  [[nodiscard]] static double line_clearance(const Case& path) {
    double least = kInfinity<double>;
    for (const bool onward : {true, false}) {
      least = std::min(least, BracketTruth(ray_of(path, onward)).clearance().low);
    }
    return least;
  }

  const BracketTruth& rest_;
  const BracketTruth& pair_;
};

}  // namespace

Judgement judge_curved_query(const Case& seen, const Method& method, const Answer& answer, double tolerance) {
  const BracketTruth rest(at_rest(seen)), pair(is_along_the_path(seen.query) ? as_cast(seen) : at_rest(seen));
  return CurvedJudge(seen, method, answer, tolerance, rest, pair)();
}

}  // namespace graze::law
