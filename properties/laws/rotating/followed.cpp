// The laws of the start policy pass_over where a rotation is visible (judge/judge_followed.hpp).
//
// Few drawn cases start in contact, so the law makes one of each case that has a hit. The bodies stand where they meet,
// and continue as they came, or back, or slide and spin on the contact's plane. For the last motion the truth is known:
// n separates the bodies, one rests and the other keeps to its side of the plane, so the contact never gets deeper.
#include <cmath>
#include <optional>
#include <stdexcept>

#include "engines/method.hpp"
#include "properties/edit/case.hpp"
#include "properties/edit/turning.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/judge_followed.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;

namespace {

enum class Motion { as_it_is, back, along_the_plane };

bool refuses(const Answer& answer) {
  return answer.outcome == Outcome::invalid_input && answer.invalid == Invalid::not_followed;
}

// The motion from the place where the bodies meet.
std::optional<Case> from_contact(const Case& seen, const Answer& met, Motion motion) {
  const std::optional<Standing> standing = standing_at(seen, met.toi_lower);
  if (!standing) return std::nullopt;
  Case out = standing->still;
  out.t_max = seen.t_max;
  out.spin_a = seen.spin_a;
  out.spin_b = seen.spin_b;
  out.a.displacement = seen.a.displacement;
  out.b.displacement = seen.b.displacement;
  switch (motion) {
    case Motion::as_it_is:
      break;
    case Motion::back:
      for (Body<double>* body : {&out.a, &out.b}) body->displacement *= -1;
      for (corpus::Spin* spin : {&out.spin_a, &out.spin_b}) spin->rotation *= -1;
      break;
    case Motion::along_the_plane: {
      const Vec3<double> n = met.normal, v = seen.b.displacement - seen.a.displacement;
      out.spin_a = {};
      out.spin_b = {2 * n, Vec3<double>::Zero()};
      out.a.displacement.setZero();
      out.b.displacement = v - v.dot(n) * n;
      break;
    }
  }
  out.start_policy = StartPolicy::pass_over;
  return out;
}

LawResult judged(const Case& problem, const Method& method, Motion motion) {
  const Case seen = method.seen(problem);
  std::optional<Case> start;
  if (seen.start_policy == StartPolicy::pass_over && motion == Motion::as_it_is) {
    start = seen;
  } else if (is_rotating_question(seen)) {
    const Answer met = method.ask(seen, {.request = Request::normal});
    if (met.outcome == Outcome::hit) start = from_contact(seen, met, motion);
  }
  if (start) start = method.seen(*start);
  if (!start || !in_domain(*start) || !std::isfinite(start->t_max) || !turns_within_range(*start))
    return no_rotating_question();
  const Request request = Request::normal | Request::witnesses;
  const Answer answer = method.ask(*start, {.request = request});
  if (refuses(answer)) return not_applicable("the method does not follow a contact");
  // In linear motion the policy decides by the bodies without the target distance if they separate.
  if (answer.plan.effects != Effects::rotating && start->target_distance > 0)
    return not_applicable("linear motion at a target distance");
  LawResult result = holds({label_of(answer.outcome)});
  if (answer.passed_over) result.labels.push_back("passed over");
  try {
    Truth truth(*start);
    const Judgement judgement = judge(truth, method, answer, request, true);
    if (judgement.skipped) return no_rotating_question();
    if (judgement.faulty()) return broken(judgement.fault() + ": " + describe(answer));
    if (motion == Motion::along_the_plane && judgement.stalled)
      return broken("a spin on the plane of the contact is left open: " + describe(answer));
  } catch (const std::invalid_argument&) {
    return not_applicable("no oracle decides the case");
  }
  return result;
}

LawResult contact_is_followed(const Case& problem, const Method& method) {
  return judged(problem, method, Motion::as_it_is);
}
LawResult contact_is_left_as_it_came(const Case& problem, const Method& method) {
  return judged(problem, method, Motion::back);
}
LawResult spin_on_the_plane_is_passed_over(const Case& problem, const Method& method) {
  return judged(problem, method, Motion::along_the_plane);
}

LawResult apart_start_has_no_policy(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  Case passing = seen;
  passing.start_policy = StartPolicy::pass_over;
  const Answer report = plain_answer(method, seen), over = method.ask(passing, {});
  if (refuses(over)) return not_applicable("the method does not follow a contact");
  const oracle::RotatingTruth* truth = rotating_truth_of(seen);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  const Limits limits = limits_of(method, seen, scale_of(seen));
  if (!(truth->distance_at(0).low > followed_depth(limits))) return not_applicable("the start is in contact");
  if (over.passed_over) return broken("the start is apart, and was passed over: " + describe(over));
  if (same_times(report, over)) return holds({label_of(report.outcome)});
  // Another search may have answered: for an invisible rotation, or for a tie at the end of the motion.
  LawResult found =
      compare(method, {"report", seen, report}, {"pass_over", passing, over}, "the start is apart");
  if (found.holding != Holding::broken) found.labels.push_back("other search");
  return found;
}

}  // namespace

std::vector<Law> rotating_followed_laws() {
  return {
      {"contact_is_followed",
       "pass_over: until toi_lower the contact of the start gets no deeper. By toi_upper it does, or there "
       "is a new one.",
       Needs::oracle, &contact_is_followed},
      {"contact_is_left_as_it_came", "The same from where bodies meet, on their way back.", Needs::oracle,
       &contact_is_left_as_it_came},
      {"spin_on_the_plane_is_passed_over",
       "pass_over: a body that slides and spins on the plane of its contact gets no hit from it.",
       Needs::oracle, &spin_on_the_plane_is_passed_over},
      {"apart_start_has_no_policy", "If the start is apart, pass_over answers as report does.", Needs::oracle,
       &apart_start_has_no_policy},
  };
}

}  // namespace graze::law
