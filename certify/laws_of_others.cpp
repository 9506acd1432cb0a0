#include "certify/laws_of_others.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "properties/edit/case.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using engine::Answer;
using engine::Failure;
using engine::Kind;
using engine::Method;

constexpr std::string_view kBudget = "the protocol has no budget, tolerance or part of an answer to ask for",
                           kBits = "it holds to the last bit, which no engine guarantees",
                           kTier = "it is about our tiers", kScalars = "a third-party engine has one scalar",
                           kRead = "reading an answer of the protocol already checks this",
                           kDoor = "the protocol cannot write what must be refused",
                           kOurs = "it asks other queries, of our methods",
                           kAll = "it needs more of an answer than the protocol's hold",
                           kPlan = "it is about our plan";

struct NotForOthers {
  std::string_view law, why;
};
constexpr NotForOthers kNotForOthers[] = {
    // Laws of linear casts.
    {"scaling", kBits},
    {"changing_the_clock", kBits},
    {"asking_again", kBits},
    {"requesting", kBudget},
    {"interrupting", kBudget},
    {"tightening", kBudget},
    {"every_iterate_is_proved", kBudget},
    {"interrupted_is_right", kBudget},
    {"tolerance_bounds_the_error", kBudget},
    {"distance_is_stated", kAll},
    {"scalars_meet", kScalars},
    {"tiers_nest", kTier},
    {"certified_decides", kTier},
    {"certified_lower_is_near", kTier},
    {"open_answer_is_near_contact", kTier},
    {"exact_equals_oracle", kTier},
    {"exact_queries_agree", kTier},
    {"answer_is_consistent", kRead},
    {"bad_input_is_refused", kDoor},
    {"reversing", kOurs},
    {"threshold_of_swept_overlap", kOurs},
    {"proof_is_tight", kTier},
    {"overclaims_are_refused", kTier},
    // Laws of the queries.
    {"query_scaling", kBits},
    {"query_requesting", kBudget},
    {"query_answer_is_consistent", kRead},
    {"query_bad_input_is_refused", kDoor},
    {"gaps_agree", kOurs},
    {"growing_closes_gaps", kOurs},
    {"rounding_takes_its_radius", kOurs},
    {"moving_along_the_normal", kAll},
    {"no_way_is_shorter", kOurs},
    {"growing_lengthens_the_way", kOurs},
    {"line_holds_cast", kOurs},
    {"line_reversed", kOurs},
    {"line_grows", kOurs},
    {"swept_overlap_is_cast", kOurs},
    {"swept_overlap_grows", kOurs},
    {"swept_overlap_of_volume", kOurs},
    {"motion_at_rest", kOurs},
    {"target_is_rounding", kOurs},
    {"distance_is_shown", kAll},
    {"depth_is_shown", kAll},
    {"miss_is_shown", kAll},
    {"line_normals_support", kOurs},
    // Laws of rotating bodies.
    {"turning_scaling", kBits},
    {"stretching_time", kBits},
    {"turning_scalars_meet", kScalars},
    {"turning_budget", kBudget},
    {"tolerance_is_kept", kBudget},
    {"turning_requesting", kBudget},
    {"turning_answer_is_consistent", kRead},
    {"bad_turn_is_refused", kDoor},
    {"turning_certified_decides", kTier},
    {"turning_distance_is_stated", kAll},
    {"turning_stands_as_said", kAll},
    {"turning_proof_is_accepted", kAll},
    {"unturned_is_linear", kPlan},
    {"unseen_turn_is_none", kPlan},
    {"as_one_stands_still", kPlan},
    {"plan_changes_nothing", kPlan},
    {"plan_spares_the_work", kPlan},
    {"plan_is_monotone", kPlan},
};

// A record of the calls that a law made on this thread.
struct Heard {
  bool has_seen = false;  // the law has asked the case as the engine sees it
  bool not_seen = false;  // the engine does not take an edit of the case
  std::string declined, failed;
};
Heard& heard() {
  thread_local Heard all;
  return all;
}

// The length by which the engine rounds the bodies: its margin, in the unit of the case.
double margin_of(const Method& method, Case problem) {
  problem.target_distance = 0;
  return method.refuses(problem).empty() ? method.seen(problem).target_distance : 0;
}

// The case to ask the engine so that it sees `seen`.
Case without_margin(const Method& method, Case seen) {
  const double margin = margin_of(method, seen);
  if (margin > 0 && seen.target_distance >= margin) seen.target_distance -= margin;
  return seen;
}

// A quaternion that was made unit may change its last bit when it is made unit again: so often at most.
constexpr int kRounds = 4;

Case seen_by_laws(const Method& method, const Case& problem) {
  const bool is_first = !heard().has_seen;
  heard().has_seen = true;
  Case seen = problem;
  for (int round = 0; round < kRounds; ++round) {
    const Case asked = without_margin(method, seen);
    if (const std::string why = law::in_domain(asked) ? method.refuses(asked) : "out of the domain";
        !why.empty()) {
      if (is_first)
        heard().declined = why;
      else
        heard().not_seen = true;
      return problem;
    }
    Case next = method.seen(asked);
    if (law::same_input(next, seen)) break;
    seen = std::move(next);
  }
  return seen;
}

// Replaces a missing answer. It claims nothing, so that the law can finish, and the law's result is then ignored.
Answer no_answer() {
  Answer answer;
  answer.outcome = Outcome::not_converged;
  answer.toi_lower = 0;
  answer.toi_upper = answer.distance = kInfinity<double>;
  answer.separation = answer.depth = engine::Interval{0, kInfinity<double>};
  answer.stalled = true;
  return answer;
}

Answer answer_to_laws(const Method& method, const Case& seen, const engine::Ask& ask) {
  Heard& all = heard();
  const auto decline = [&](std::string why) {
    if (all.declined.empty()) all.declined = std::move(why);
    return no_answer();
  };
  if (!all.failed.empty()) return no_answer();
  const Case asked = without_margin(method, seen);
  if (!law::in_domain(asked)) return decline("out of the domain");
  if (std::string why = method.refuses(asked); !why.empty()) return decline(std::move(why));
  if (!law::same_input(method.seen(asked), seen)) return decline("its terms make it another question");
  Answer answer = method.ask(asked, ask);
  if (answer.failure != Failure::none) {
    all.failed = fmt::format("{}: {}", to_text(answer.failure), answer.message);
    return no_answer();
  }
  if (answer.declined) {
    return decline(answer.message.empty() ? "it says that it does not support the question" : answer.message);
  }
  // For queries: an answer without the value that the law is about. A distance that was not given reads as 0.
  const bool lacks_distance = method.query == corpus::Query::distance && answer.outcome == Outcome::miss &&
                              !(answer.separation && answer.separation->upper > 0);
  const bool lacks_depth = method.query == corpus::Query::penetration &&
                           answer.outcome == Outcome::initially_overlapping && !answer.depth;
  if (lacks_distance || lacks_depth) return decline("its answers hold no distance or no depth");
  return answer;
}

}  // namespace

std::string_view why_not_for_others(std::string_view law) {
  const auto* const found = std::find_if(std::begin(kNotForOthers), std::end(kNotForOthers),
                                         [&](const NotForOthers& one) { return one.law == law; });
  return found == std::end(kNotForOthers) ? "" : found->why;
}

std::string_view why_not_for(const law::Law& law, const Method& method) {
  if (const std::string_view why = why_not_for_others(law.name); !why.empty()) return why;
  const bool is_verdict = law.name.ends_with("verdict_is_right");
  if (method.kind != Kind::query && !method.holds.time && !is_verdict) return "its answers hold no time";
  if (law.name == "normal_supports" && !method.holds.normal) return "its answers hold no normal";
  if (law.name == "witnesses_touch" && !method.holds.witnesses) return "its answers hold no witnesses";
  const bool is_contact = law.name == "query_contact_is_right" || law.name == "turning_contact_is_right";
  if (is_contact && !(method.holds.normal && method.holds.witnesses))
    return "its answers do not hold both a normal and witnesses";
  return {};
}

Method as_laws_ask(const Method& method) {
  Method asked = method;
  asked.seen = [&method](const Case& problem) { return seen_by_laws(method, problem); };
  asked.ask = [&method](const Case& problem, const engine::Ask& ask) {
    return answer_to_laws(method, problem, ask);
  };
  return asked;
}

law::LawResult check_other(const law::Law& law, const Case& problem, const Method& as_laws_ask_it) {
  heard() = {};
  law::LawResult result = law.check(problem, as_laws_ask_it);
  const Heard all = heard();
  if (!all.failed.empty())
    return {.holding = law::Holding::broken, .reason = all.failed, .labels = {kFailed}};
  const bool is_broken = result.holding == law::Holding::broken;
  const bool has_no_proof =
      std::find(result.labels.begin(), result.labels.end(), "no proof") != result.labels.end();
  if (!all.declined.empty() || (is_broken && all.not_seen) || has_no_proof) {
    const std::string why = !all.declined.empty() ? all.declined
                            : has_no_proof        ? "it has no proof"
                                                  : "it does not take an edit of the case";
    return {.holding = law::Holding::not_applicable, .reason = why, .labels = {kSkipped}};
  }
  return result;
}

}  // namespace graze::tool
