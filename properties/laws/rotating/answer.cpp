// Laws about the consistency of a rotating method's answer, and about its changes with the options, the shapes and the
// method.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engines/method.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"
#include "properties/laws/tables.hpp"
#include "properties/laws/work.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using oracle::RotatingTruth;

namespace {

LawResult turning_methods_meet(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return no_rotating_question();
  const Answer one = plain_answer(method, seen);
  LawResult result = holds({label_of(one.outcome)});
  for (const Method& other : engine::methods(engine::Kind::rotating)) {
    if (other.scalar != method.scalar || other.name == method.name || !is_safe(other)) continue;
    const Answer two = plain_answer(other, seen);
    if (overlap(times_of(one), times_of(two))) continue;
    result.labels.push_back("arbitrated");
    const RotatingTruth* truth = rotating_truth_of(seen);
    if (truth == nullptr) continue;
    for (const auto& [judged, answer] : {std::pair(&method, &one), std::pair(&other, &two)}) {
      const std::string fault = any_fault(*truth, *answer, limits_of(*judged, seen, scale_of(seen)));
      if (!fault.empty()) {
        return broken(fmt::format("{} and {} do not meet: {}; at fault is {}: {}", method.full_name(),
                                  other.full_name(), pair_of(one, two), judged->full_name(), fault));
      }
    }
  }
  return result;
}

LawResult turning_superset(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const Answer one = plain_answer(method, seen);
  LawResult result = holds({label_of(one.outcome)});
  const auto check = [&](const Case& larger, std::string_view name) {
    if (!is_rotating_question(larger) || !fits(larger, method)) return;
    Answer two = method.ask(larger, {});
    if (two.toi_lower <= one.toi_upper) return;
    result = compare(method, {"the original", seen, one}, {name, larger, two}, "what is larger is hit later");
  };
  Case nearer = seen;
  nearer.expect.reset();
  nearer.target_distance += std::scalbn(1.0, static_cast<int>(hash_of(seen) % 8) - 6);
  check(nearer, "a larger target distance");
  for (std::uint64_t salt = hash_of(seen), tries = 0; tries < 2 && result.holding == Holding::holds;
       ++tries, ++salt) {
    check(grown(seen, salt), "the superset");
  }
  return result;
}

LawResult tolerance_is_kept(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  // Steps are refined to the tolerance too, but may miss. The published form has its slop.
  if (method.name == "bilateral_published") return not_applicable("its tolerance is a slop");
  const Answer tight = plain_answer(method, seen);
  LawResult result = holds({label_of(tight.outcome)});
  for (const double tolerance : {0x1p-7, 0x1p-20}) {
    const Answer loose = method.ask(seen, {.tolerance = tolerance});
    LawResult found = compare(method, {"tight", seen, tight}, {"loose", seen, loose, tolerance},
                              "a tolerance changes the answer");
    if (found.holding == Holding::broken) return found;
    const Limits row = limits_of(method, seen, scale_of(seen), method.is_certified() ? 0 : tolerance);
    // In a linear cast a tolerance means the backward error, and its distance may be the larger.
    const bool marched = loose.plan.effects == Effects::rotating;
    if (marched && claims_contact(loose) && loose.distance > row.wide + row.rounding_at(loose.toi_lower)) {
      return broken(fmt::format("asked for a width of {} of the scale, {} is given: {}", tolerance,
                                loose.distance, describe(loose)));
    }
    // It ends the same search earlier.
    if (loose.outcome != tight.outcome && tight.outcome != Outcome::not_converged)
      return broken("a tolerance changes the verdict: " + pair_of(tight, loose));
    if (loose.counters.supports > tight.counters.supports) {
      return broken(fmt::format("a tolerance of {} costs {} supports, none costs {}: {}", tolerance,
                                loose.counters.supports, tight.counters.supports, describe(loose)));
    }
  }
  return result;
}

// A proof covers the whole motion, whatever the plan spares: another search, at times a shorter one.
LawResult turning_requesting(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const Answer least = plain_answer(method, seen);
  const Answer more = method.ask(seen, {.request = Request::normal | Request::witnesses});
  const Answer all = method.ask(seen, {.request = Request::everything});
  if (!same_times(least, more)) return broken("asking for more changes the verdict: " + pair_of(least, more));
  if (least.counters.supports > more.counters.supports || least.counters.poses > more.counters.poses)
    return broken("asking for less costs more: " + pair_of(least, more));
  if (!least.normal.isZero(0) || !least.point_a.isZero(0) || !least.point_b.isZero(0) ||
      least.rotating_proof || more.rotating_proof)
    return broken("computed unasked: " + describe(least));
  return compare(method, {"without a proof", seen, least}, {"with a proof", seen, all},
                 "asking for a proof changes the answer");
}

LawResult turning_answer_is_consistent(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const Answer answer = plain_answer(method, seen);
  const double lower = answer.toi_lower, upper = answer.toi_upper;
  std::string fault;
  switch (answer.outcome) {
    case Outcome::initially_overlapping:
      if (lower != 0 || upper != 0) fault = "a start in contact not at time 0";
      break;
    case Outcome::hit:
      if (!(lower >= 0 && lower <= upper && upper > 0 && lower <= seen.t_max))
        fault = "a hit without a bracket";
      // Rounded outward.
      if (!(upper <= seen.t_max * (1 + 4 * method.unit_roundoff))) fault = "a hit beyond t_max";
      break;
    case Outcome::miss:
      if (!(std::isinf(lower) && std::isinf(upper) && lower > 0)) fault = "a miss with a time";
      break;
    case Outcome::not_converged:
      if (!(lower >= 0 && lower <= upper)) fault = "no bracket is handed in";
      break;
    case Outcome::invalid_input:
      fault = "a valid case was refused";
      break;
  }
  // Rounded, so at times a little below 0. Unbounded if nothing is known at toi_lower.
  const bool unknown = answer.outcome == Outcome::not_converged && answer.distance == kInfinity<double>;
  if (!unknown &&
      !(answer.distance >= -limits_of(method, seen, scale_of(seen)).wide && std::isfinite(answer.distance)))
    fault = fmt::format("not a valid distance, {}", answer.distance);
  if (!fault.empty()) return broken(fault + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

// The search is the same until its budget ends, so its bracket then holds the bracket of the full search.
LawResult turning_budget(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return no_rotating_question();
  const Answer whole = plain_answer(method, seen);
  LawResult result = holds({label_of(whole.outcome)});
  Answer less;
  less.toi_upper = kInfinity<double>;
  for (const int budget : {1, 2, 4, 8, 16, 32, 64, 128, 512}) {
    const Answer more = method.ask(seen, {.max_iterations = budget});
    std::string fault;
    if (!(more.toi_lower >= less.toi_lower)) {
      fault = "takes back a lower bound";
    } else if (!(more.toi_upper <= less.toi_upper || more.outcome == Outcome::miss)) {
      fault = "takes back a contact";
    } else if (!(more.toi_lower <= whole.toi_lower)) {
      fault = "has a later lower bound than the whole search";
    } else if (!(more.toi_upper >= whole.toi_upper)) {
      fault = "has an earlier contact than the whole search";
    }
    if (!fault.empty()) {
      // Near contact a start may be called either, within the guarantee.
      LawResult found = arbitrate(method, {"a part of the search", seen, more}, {"all of it", seen, whole},
                                  fmt::format("a budget of {} {}", budget, fault));
      if (found.holding == Holding::broken) return found;
      result.labels.push_back("arbitrated");
    }
    if (more.outcome == Outcome::not_converged && whole.outcome != Outcome::not_converged)
      result.labels.push_back("cut short");
    less = more;
  }
  return result;
}

LawResult turning_scalars_meet(const Case& problem, const Method& method) {
  const Method* wide = engine::find_method(engine::Kind::rotating, method.name + "/double");
  if (method.scalar == "double" || wide == nullptr) return not_applicable("no other scalar");
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return no_rotating_question();
  const Answer one = plain_answer(method, seen), two = plain_answer(*wide, seen);
  LawResult result = holds({label_of(one.outcome)});
  if (overlap(times_of(one), times_of(two))) return result;
  const std::string all = fmt::format("{} and double do not meet: {}", method.scalar, pair_of(one, two));
  if (method.is_certified()) return broken(all + "; and both are proved");
  result.labels.push_back("arbitrated");
  const RotatingTruth* truth = rotating_truth_of(seen);
  if (truth == nullptr) return result;
  for (const auto& [judged, answer] : {std::pair(&method, &one), std::pair(wide, &two)}) {
    const std::string fault = any_fault(*truth, *answer, limits_of(*judged, seen, scale_of(seen)));
    if (!fault.empty()) return broken(fmt::format("{}; at fault is {}: {}", all, judged->scalar, fault));
  }
  return result;
}

LawResult rotating_work(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  return is_rotating_question(seen) ? within_its_work(seen, method) : no_rotating_question();
}

}  // namespace

std::vector<Law> rotating_answer_laws() {
  return {
      {"rotating_work",
       "A rotating cast takes no more support evaluations than its guarantee's most_supports.",
       Needs::metamorphic, &rotating_work},
      {"turning_superset", "A superset, or a larger target distance, is never hit later.", Needs::metamorphic,
       &turning_superset},
      {"turning_methods_meet", "The brackets of the methods of one scalar meet, each within its guarantee.",
       Needs::metamorphic, &turning_methods_meet},
      {"turning_scalars_meet",
       "The brackets of a method in float and in double meet, each within its guarantee.", Needs::metamorphic,
       &turning_scalars_meet},
      {"turning_budget", "With a larger budget a bracket is within the one before, and the whole one in it.",
       Needs::metamorphic, &turning_budget},
      {"tolerance_is_kept",
       "A tolerance widens a bracket by no more than itself, changes no verdict and costs no more supports.",
       Needs::metamorphic, &tolerance_is_kept},
      {"turning_requesting",
       "Asking for less changes no verdict, costs no more and computes nothing unasked.", Needs::metamorphic,
       &turning_requesting},
      {"turning_answer_is_consistent", "Outcome and bracket say one thing.", Needs::metamorphic,
       &turning_answer_is_consistent},
  };
}

}  // namespace graze::law
