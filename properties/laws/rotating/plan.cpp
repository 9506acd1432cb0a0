// The laws of the plan: motion that it spares changes no answer, and is not simulated.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "engines/method.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/judge_followed.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Ask;
using engine::Method;

namespace {

struct Asking {
  std::string_view name;
  Economies economies;
};
constexpr std::array<Asking, 9> kEconomies = {{
    {"every economy", {}},
    {"all but a static query", {.at_rest = false}},
    {"all but unseen turns", {.unseen_spin = false}},
    {"all but turning as one", {.as_one = false}},
    {"all but bounds", {.bounds = false}},
    {"a static query only", {true, false, false, false}},
    {"unseen turns only", {false, true, false, false}},
    {"turning as one only", {false, false, true, false}},
    {"bounds only", {false, false, false, true}},
}};
// Over scale.
constexpr double kAskedTolerance = 0x1p-10;

LawResult plan_changes_nothing(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!follows_plan(method) || !is_rotating_question(seen)) return no_rotating_question();
  LawResult result;
  for (const double tolerance : {0.0, kAskedTolerance, 64 * kAskedTolerance}) {
    Ask ask{.tolerance = tolerance, .economies = Economies::none()};
    const Answer whole = method.ask(seen, ask);
    for (const Asking& one : kEconomies) {
      ask.economies = one.economies;
      const Answer spared = method.ask(seen, ask);
      LawResult found = compare(method, {"without economies", seen, whole, tolerance},
                                {one.name, seen, spared, tolerance}, "economies change the answer");
      if (found.holding == Holding::broken) return found;
      result.labels = std::move(found.labels);
      if (spared.plan.effects != Effects::rotating) result.labels.push_back(to_text(spared.plan.effects));
    }
  }
  return result;
}

LawResult plan_spares_the_work(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!follows_plan(method) || !is_rotating_question(seen)) return no_rotating_question();
  LawResult result;
  for (const double tolerance : {0.0, kAskedTolerance}) {
    const Answer answer = method.ask(seen, {.tolerance = tolerance});
    const Plan& plan = answer.plan;
    const Plan said = method.plan(seen, {.tolerance = tolerance});
    std::string fault;
    if (said.effects != plan.effects || said.reasons != plan.reasons) {
      fault = "plan() says otherwise than what is simulated";
    } else if (plan.effects == Effects::rotating && !engine::turns(seen)) {
      fault = "a rotating cast where neither body rotates";
    } else if (plan.effects != Effects::rotating && answer.counters.poses != 0) {
      fault = "rotating bodies are placed where no rotation is to be simulated";
    } else if (plan.effects == Effects::nothing &&
               (answer.counters.supports != 0 || answer.outcome != Outcome::miss)) {
      fault = "bounds that never meet are searched";
    } else if (plan.effects == Effects::at_rest && answer.outcome == Outcome::hit) {
      fault = "a static query that finds a later contact";
    } else if (plan.reasons == 0) {
      fault = "a plan without a reason";
    }
    const Plan full = method.plan(seen, {.tolerance = tolerance, .economies = Economies::none()});
    if (fault.empty() && engine::turns(seen) && full.effects != Effects::rotating)
      fault = "without economies a rotation is not simulated";
    if (!fault.empty()) return broken(fault + ": " + describe(answer));
    result = holds({label_of(answer.outcome), to_text(plan.effects)});
  }
  return result;
}

LawResult plan_is_monotone(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!follows_plan(method) || !is_rotating_question(seen)) return no_rotating_question();
  constexpr unsigned kSubsets = 1u << 4;
  const auto economies = [](unsigned set) {
    return Economies{(set & 1) != 0, (set & 2) != 0, (set & 4) != 0, (set & 8) != 0};
  };
  LawResult result = holds();
  for (const double tolerance : {0.0, kAskedTolerance, 64 * kAskedTolerance}) {
    std::array<Plan, kSubsets> plans;
    for (unsigned set = 0; set < kSubsets; ++set)
      plans[set] = method.plan(seen, {.tolerance = tolerance, .economies = economies(set)});
    for (unsigned set = 0; set < kSubsets; ++set) {
      for (unsigned one = 1; one < kSubsets; one <<= 1) {
        const Plan &less = plans[set & ~one], &more = plans[set | one];
        // A static query is spared by the bounds alone, a linear cast by either, and so on.
        if (more.effects <= less.effects) continue;
        return broken(fmt::format("with the economies {:04b} it is {}, with {:04b} it is {}", set & ~one,
                                  to_text(less.effects), set | one, to_text(more.effects)));
      }
    }
    const Plan& all = plans[kSubsets - 1];
    result.labels.push_back(to_text(all.effects));
  }
  return labelled(std::move(result), {label_of(plain_answer(method, seen).outcome)});
}

LawResult unturned_is_linear(const Case& problem, const Method& method) {
  Case still = without_turns(method.seen(problem));
  // Few cases come with that policy. Here every other one may have it.
  if (follows_plan(method) && hash_of(still) % 2 == 0) still.start_policy = StartPolicy::pass_over;
  if (!engine::unsupported(engine::Kind::rotating, still).empty() || !in_domain(still))
    return no_rotating_question();
  const bool ray = std::isinf(still.t_max) || still.start_policy != StartPolicy::report;
  const Answer answer = method.ask(still, {});
  if (ray && !follows_plan(method)) {
    // A question that no single method takes is refused.
    const bool refused = answer.outcome == Outcome::invalid_input && answer.invalid == Invalid::not_linear;
    if (std::isinf(still.t_max) && !refused)
      return broken("a rotating method takes a ray: " + describe(answer));
    return no_rotating_question();
  }
  LawResult result = holds({label_of(answer.outcome)});
  if (follows_plan(method)) {
    // By the tier's method. Tier standard has two, and uses the one that suits the shapes.
    std::string said;
    for (const char* name : {"certified", "mpr", "gjk"}) {
      if (method.is_certified() != (name == std::string_view("certified"))) continue;
      const engine::Method* linear =
          engine::find_method(engine::Kind::linear, std::string(name) + "/" + method.scalar);
      if (linear == nullptr) return not_applicable("no linear method of this tier");
      const engine::Answer its = linear->ask(still, {});
      if (answer.outcome == its.outcome && answer.passed_over == its.passed_over &&
          (answer.outcome == Outcome::invalid_input ||
           (answer.toi_lower == its.toi_lower && answer.toi_upper == its.toi_upper)))
        return result;
      // A rotating cast follows the start that a linear one reports. It is judged by what happens to that
      // contact.
      if (still.start_policy == StartPolicy::pass_over && its.outcome == Outcome::initially_overlapping) {
        const RotatingTruth start = truth_from_start(still);
        Judgement followed;
        judge_followed(followed, start, still, answer, limits_of(method, still, start.scale().high),
                       Request::verdict);
        if (followed.faulty()) return broken("without turns: " + followed.fault());
        return labelled(std::move(result), {"followed"});
      }
      said += "; " + linear->full_name() + " says " + describe(its);
    }
    return broken("without turns the plan says " + describe(answer) + said);
  }
  const engine::Method* linear = engine::find_method(engine::Kind::linear, "gjk/" + method.scalar);
  if (linear == nullptr) return not_applicable("no linear method in this scalar");
  const engine::Answer said = linear->ask(still, {});
  if (overlap(times_of(answer), {said.toi_lower, said.toi_upper})) return result;
  const RotatingTruth* truth = rotating_truth_of(still);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  const std::string fault = any_fault(*truth, answer, limits_of(method, still, scale_of(still)));
  if (!fault.empty())
    return broken(fmt::format("without turns: {}; the linear cast says {}", fault, describe(said)));
  return labelled(std::move(result), {"arbitrated"});
}

// Compared with the body without its rotation. The other body keeps its motion or, at times, also rotates invisibly.
// Then the plan must reduce to a linear cast, for rays and policies too.
LawResult unseen_turn_is_none(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!in_domain(seen)) return no_rotating_question();
  const std::uint64_t salt = hash_of(seen);
  std::optional<Case> spun = with_unseen_turn(seen, true, salt);
  const bool a = spun.has_value();
  bool b = false;
  if (const auto both = with_unseen_turn(spun ? *spun : seen, false, mix(salt)); both) {
    spun = both;
    b = true;
  }
  if (!spun || !fits(*spun, method)) return not_applicable("every turn can be seen");
  Case still = *spun;
  if (a) still.spin_a = {};
  if (b) still.spin_b = {};
  const bool linear = !engine::turns(still);
  const bool is_ray = linear && follows_plan(method) && turns_within_range(*spun);
  if (!is_rotating_question(*spun) && !is_ray) return no_rotating_question();
  const Answer one = method.ask(*spun, {}), two = method.ask(still, {});
  if (!linear || !follows_plan(method)) {
    return compare(method, {"with the turn", *spun, one}, {"without", still, two},
                   "a rotation that cannot be seen changes the answer");
  }
  if (one.plan.effects == Effects::rotating)
    return broken("a rotation that cannot be seen is simulated: " + describe(one));
  // By the same query, to the bit.
  if (one.plan.effects == two.plan.effects && !same_times(one, two))
    return broken("a rotation that cannot be seen changes the answer: " + pair_of(one, two));
  if (!is_rotating_question(*spun)) return holds({label_of(one.outcome), "ray"});
  return labelled(compare(method, {"with the turn", *spun, one}, {"without", still, two},
                          "a rotation that cannot be seen changes the answer"),
                  {"linear"});
}

LawResult as_one_stands_still(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const std::optional<Case> alike = moved_as_one(seen);
  if (!alike || !fits(*alike, method)) return not_applicable("no exact common pivot");
  Case still = without_turns(*alike);
  still.a.displacement.setZero();
  still.b.displacement.setZero();
  const Answer one = method.ask(*alike, {}), two = method.ask(still, {});
  if (follows_plan(method) && one.plan.effects == Effects::rotating)
    return broken("bodies that stand still relative to each other are simulated: " + describe(one));
  return compare(method, {"both moving as one", *alike, one}, {"both at rest", still, two},
                 "moving as one changes the answer");
}

}  // namespace

std::vector<Law> rotating_plan_laws() {
  return {
      {"unturned_is_linear",
       "Without rotation the answer is the linear cast's. A start in contact may be followed instead.",
       Needs::metamorphic, &unturned_is_linear},
      {"unseen_turn_is_none",
       "A ball's rotation about its centre, or a solid's about its axis, changes nothing.",
       Needs::metamorphic, &unseen_turn_is_none},
      {"as_one_stands_still", "Bodies that rotate and move as one meet at t = 0 or never.",
       Needs::metamorphic, &as_one_stands_still},
      {"plan_changes_nothing", "Every economy on or off, verdicts stay and brackets meet.",
       Needs::metamorphic, &plan_changes_nothing},
      {"plan_spares_the_work", "A plan says what is done, and nothing that it skips is done.",
       Needs::metamorphic, &plan_spares_the_work},
      {"plan_is_monotone", "One more economy never leaves more to simulate.", Needs::metamorphic,
       &plan_is_monotone},
  };
}

}  // namespace graze::law
