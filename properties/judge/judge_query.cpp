// Judges answers to the queries beside the cast: overlap, distance, penetration, line, swept overlap. The exact oracles
// decide every one. There is no proof to check first.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracles/polytope/exact_body.hpp"
#include "properties/judge/exact_answer.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/limits.hpp"
#include "properties/judge/query_judge.hpp"

namespace graze::law {
namespace {

using corpus::Query;
using engine::Answer;
using engine::Interval;
using engine::Method;
using oracle::Enclosure;

double scale_asked(Truth& truth) {
  const bool moves = truth.problem().query == Query::line || truth.problem().query == Query::swept_overlap;
  return scale_of_question(truth.problem().query, truth.problem().target_distance,
                           (moves ? truth.moving() : truth.at_rest()).scale().high);
}

class RepresentedJudge : public QueryJudge {
 public:
  RepresentedJudge(Truth& truth, const Method& method, const Answer& answer, double tolerance)
      : QueryJudge(truth.problem(), method, answer, tolerance, scale_asked(truth)), truth_(truth) {}

 private:
  // Claims of contact or of none. `apart` and `deep` return the error of either claim.
  template <class Apart, class Deep>
  void verdict(bool claims, bool contact, const Apart& apart, const Deep& deep) {
    if (answer_.outcome == Outcome::not_converged || claims == contact) return;
    verdict_errs((claims ? apart() : deep()).low, claims ? "they are apart" : "they overlap");
  }
  void holds(const char* what, const Interval& bracket, const Enclosure& value) {
    if (!(bracket.lower <= bracket.upper))
      return add_fault(judgement_.off, fmt::format("{} has no bracket", what));
    held(what, std::max({bracket.lower - value.high, value.low - bracket.upper, 0.0}));
    measure(what, std::max(std::abs(bracket.lower - value.low), std::abs(bracket.upper - value.high)));
  }
  double distance_from_body(char body, const Vec3<double>& point) override {
    return truth_.at_rest().distance_from_body(body, 0, point).low;
  }

  void overlap() override {
    verdict_at_rest();
    separating_normal();
  }
  void verdict_at_rest() {
    const bool contact = truth_.at_rest().outcome() != Outcome::miss;
    verdict(
        answer_.outcome == Outcome::initially_overlapping, contact,
        [&] { return truth_.at_rest().distance(); }, [&] { return truth_.penetration().depth(); });
  }
  // For a miss: all of C is on the far side, h(n) <= 0.
  void separating_normal() {
    if (answer_.outcome == Outcome::miss && answer_.has_normal()) {
      normal_off(truth_.penetration().reach(answer_.normal).low, limit_);
    }
  }

  void distance() override {
    verdict_at_rest();
    if (!answer_.separation) return add_fault(judgement_.wrong, "no distance");
    const Enclosure exact = truth_.at_rest().distance();
    holds("the distance", *answer_.separation, exact);
    if (answer_.outcome != Outcome::miss) return;
    // However wide the bracket, the points are points of the bodies, and the axis separates.
    if (judgement_.stalled) {
      separating_normal();
      (void)witnesses();
      return;
    }
    // h(n) = -distance for the axis of the closest points.
    if (answer_.has_normal()) normal_off(truth_.penetration().reach(answer_.normal).low + exact.high, wide_);
    (void)witnesses();
    if (judgement_.bad_contact.empty() && has_witnesses_) closest_points(exact);
  }

  // Common to both kinds of depth. True if there is one to judge.
  bool has_depth() {
    verdict_at_rest();
    return states_depth() && truth_.penetration().in_contact();
  }
  void penetration() override {
    if (!has_depth()) return separating_normal();
    holds("the depth", *answer_.depth, truth_.penetration().depth());
    if (!judgement_.stalled && answer_.has_normal())
      normal_off(truth_.penetration().normal_error(answer_.normal).low, wide_);
    (void)witnesses();
    if (judgement_.stalled || !judgement_.bad_contact.empty() || !has_witnesses_) return;
    const double error = truth_.penetration().pair_error(answer_.point_a, answer_.point_b).low -
                         pair_rounding() - pair_reach();
    if (!(error <= 2 * limit_ + wide_)) {
      add_fault(judgement_.bad_contact,
                fmt::format("moved by its witnesses B is {:.2e} of scale off touching", in_scale(error)));
    }
  }
  void penetration_along() override {
    if (!has_depth()) return separating_normal();
    const Vec3<double> d = truth_.problem().direction;
    const Interval way{answer_.depth->lower / d.norm(), answer_.depth->upper / d.norm()};
    // s d in length: the quotient rounds by u of the depth.
    const auto error_of = [&](double s) {
      return truth_.penetration().along_error(d, s).low - 4 * kUnitRoundoff<double> * s * d.norm();
    };
    for (const double s : {way.lower, way.upper}) measure("the depth", error_of(s));
    if (const std::optional<oracle::DepthAlong> exact = truth_.penetration().along(d)) {
      if (way.lower > exact->factor_bounds.high) held("the depth", error_of(way.lower));
      if (way.upper < exact->factor_bounds.low) held("the depth", error_of(way.upper));
    }
    (void)witnesses();
  }

  void line() override {
    const oracle::LinearTruth& exact = truth_.moving();
    const bool meets = exact.contact_interval().has_value();
    verdict(
        answer_.outcome == Outcome::hit, meets, [&] { return exact.line_clearance(); },
        [&] { return exact.line_depth(); });
    if (answer_.outcome == Outcome::miss || !meets || !answer_.t_in || !answer_.t_out) return;
    const oracle::ContactInterval ends = *exact.contact_interval();
    end_of_line("t_in", *answer_.t_in, ends.in, [&](double t) { return exact.entry_error(t).low; });
    end_of_line("t_out", *answer_.t_out, ends.out, [&](double t) { return exact.exit_error(t).low; });
  }

  template <class Error>
  void end_of_line(const char* what, const Interval& bracket, const Enclosure& end, const Error& error) {
    if (is_beyond_scalar(bracket, end)) return;
    // A finite end that the scalar cannot hold is no nearer than its largest number.
    const bool finite = std::isfinite(end.low) && std::isfinite(end.high);
    const auto error_of = [&](double t) { return error(finite ? std::clamp(t, -largest(), largest()) : t); };
    for (const double t : {bracket.lower, bracket.upper}) measure(what, error_of(t));
    // Beyond the end on the wrong side of it, however wide.
    if (bracket.lower > end.high) held(what, error_of(bracket.lower));
    if (bracket.upper < end.low) held(what, error_of(bracket.upper));
  }

  void swept_overlap() override {
    const oracle::LinearTruth& exact = truth_.moving();
    verdict(
        answer_.outcome == Outcome::hit, exact.outcome() != Outcome::miss, [&] { return exact.clearance(); },
        [&] { return exact.depth(); });
    if (answer_.outcome == Outcome::miss && answer_.has_normal()) separating_for_the_path();
  }
  // For a miss: h(n) + m <= min(0, T n.v), where n.v may be off by limit over scale of |v|, as in a cast.
  void separating_for_the_path() {
    const corpus::Case& asked = truth_.problem();
    const Vec3<double> v = asked.b.displacement - asked.a.displacement;
    const double rate = answer_.normal.dot(v) + (scale_ > 0 ? limit_ / scale_ : 0.0) * v.norm();
    const double way = rate < 0 ? asked.t_max * rate : 0.0;
    normal_off(truth_.penetration().reach(answer_.normal).low + asked.target_distance - way, limit_);
  }

  Truth& truth_;
};

// The closest points of bodies that are apart: on the bodies, and as far apart as the bodies are.
void judge_closest_points(Truth& truth, const Method& method, const Answer& answer, const Enclosure& distance,
                          double limit, Judgement& judgement) {
  const double u = method.unit_roundoff, rounding = 2 * u * (answer.point_a.norm() + answer.point_b.norm());
  if (!answer.has_points) judgement.bad_contact = "a witness is missing";
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    const double off = truth.at_rest().distance_from_body(body, 0, point).low - 2 * u * point.norm();
    if (!(off <= limit)) judgement.bad_contact = fmt::format("a witness is {:.2e} off its body", off);
  }
  const double between = (answer.point_a - answer.point_b).norm(),
               off = std::max(distance.low - between, between - distance.high) - rounding;
  if (!(off <= limit)) judgement.bad_contact = fmt::format("the closest points' distance is {:.2e} off", off);
}

// Verdict, distance and both ends of the line to the last bit.
Judgement judge_exact_query(Truth& truth, const Method& method, const Answer& answer) {
  const corpus::Case& problem = truth.problem();
  const bool in_float = method.in_float();
  Judgement judgement;
  judgement.outcome = answer.outcome;
  corpus::Case question = problem;
  // An overlap and a distance know no target distance.
  if (problem.query == Query::overlap || problem.query == Query::distance) question.target_distance = 0;
  if (!engine::is_exact_question(question)) {
    judgement.skipped = true;
    if (answer.invalid != Invalid::not_exact) judgement.wrong = "answers what is not for the exact tier";
    return judgement;
  }
  judgement.by_oracle = true;
  judgement.stalled = answer.outcome == Outcome::not_converged;
  if (problem.query == Query::line) {
    const std::optional<oracle::ContactInterval> exact = truth.moving().contact_interval();
    if (answer.outcome != (exact ? Outcome::hit : Outcome::miss))
      judgement.wrong = "the verdict is not the oracle's";
    if (!exact || !judgement.wrong.empty()) return judgement;
    if (!detail::is_outward(answer.t_in, exact->in, in_float))
      judgement.off = "t_in is not the oracle's, rounded outward";
    if (!detail::is_outward(answer.t_out, exact->out, in_float))
      judgement.off = "t_out is not the oracle's, rounded outward";
    return judgement;
  }
  const bool swept = problem.query == Query::swept_overlap;
  const bool contact = (swept ? truth.moving() : truth.at_rest()).outcome() != Outcome::miss;
  const Outcome claim = swept ? Outcome::hit : Outcome::initially_overlapping;
  if (answer.outcome != (contact ? claim : Outcome::miss))
    judgement.wrong = "the verdict is not the oracle's";
  if (swept || contact || answer.outcome != Outcome::miss) return judgement;
  const double scale = truth.at_rest().scale().high, limit = limits_of(method, problem, scale).contact;
  Enclosure distance{0, 0};
  if (problem.query == Query::distance) {
    distance = truth.at_rest().distance();
    if (!detail::is_outward(answer.separation, distance, in_float))
      judgement.off = "the distance is not the oracle's, rounded outward";
    judge_closest_points(truth, method, answer, distance, limit, judgement);
  }
  if (answer.has_normal()) {
    const double beyond = std::max(0.0, truth.penetration().reach(answer.normal).low + distance.high);
    if (beyond > limit) {
      judgement.bad_contact = fmt::format("the normal is {:.2e} off separating", beyond);
    }
    judgement.errors.normal = over(beyond, scale);
  }
  return judgement;
}

bool is_represented(const corpus::Case& problem) {
  return oracle::is_exact_body(problem.a.shape) && oracle::is_exact_body(problem.b.shape);
}

}  // namespace

Judgement judge_query(Truth& truth, const Method& method, const Answer& answer, double tolerance) {
  if (method.is_exact()) return judge_exact_query(truth, method, answer);
  Judgement judgement = is_represented(truth.problem())
                            ? RepresentedJudge(truth, method, answer, tolerance)()
                            : judge_curved_query(truth.problem(), method, answer, tolerance);
  judgement.by_oracle = true;
  return judgement;
}

}  // namespace graze::law
