#include "properties/laws_rotating.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "corpus/support_value.hpp"
#include "oracles/check_rotating_proof.hpp"
#include "properties/case_edit.hpp"
#include "properties/judge.hpp"
#include "properties/judge_rotating.hpp"

namespace graze::law {

using corpus::Case;
using engine::RotatingAnswer;
using engine::RotatingAsk;
using engine::RotatingEngineMethod;
using oracle::RotatingTruth;

namespace {

const LawResult kOutside = not_applicable("not a rotating cast that the method answers");

bool fits(const Case& edited, const RotatingEngineMethod& method) {
  return same_input(method.seen(edited), edited);
}

std::string pair_of(const RotatingAnswer& one, const RotatingAnswer& other) {
  return describe(one) + "; against " + describe(other);
}

LawResult labelled(LawResult result, std::initializer_list<std::string_view> labels) {
  result.labels.insert(result.labels.end(), labels);
  return result;
}

// ---- the oracle's

using Fault = std::string (*)(const RotatingTruth&, const RotatingAnswer&, const RotatingRow&);

LawResult by_truth(const Case& problem, const RotatingEngineMethod& method, Fault fault) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const RotatingTruth* truth = rotating_truth_of(seen);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  const RotatingAnswer answer = method.cast(seen, {});
  if (std::string reason = fault(*truth, answer, row_of(method, seen)); !reason.empty())
    return broken(reason + ": " + describe(answer));
  LawResult result = holds({label_of(answer.outcome)});
  if (truth->outcome() == Outcome::not_converged) result.labels.push_back("undecided");
  return result;
}

LawResult turning_verdict_is_right(const Case& problem, const RotatingEngineMethod& method) {
  return by_truth(problem, method, &verdict_fault);
}
LawResult turning_is_never_late(const Case& problem, const RotatingEngineMethod& method) {
  return by_truth(problem, method, &late_fault);
}
LawResult turning_claims_no_contact_early(const Case& problem, const RotatingEngineMethod& method) {
  return by_truth(problem, method, &early_fault);
}
LawResult turning_bracket_is_narrow(const Case& problem, const RotatingEngineMethod& method) {
  return by_truth(problem, method, &width_fault);
}

// Normal and witnesses are those at toi_lower, from where the bodies go on to first contact: that long at
// their top speed is granted.
LawResult turning_contact_is_right(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  const engine::Guarantee* row = engine::find_guarantee(engine::guarantees(), method);
  if (!is_rotating_question(seen) || row == nullptr) return kOutside;
  const RotatingAnswer answer = method.cast(seen, {.request = Request::normal | Request::witnesses});
  if (answer.outcome != Outcome::hit) return holds({label_of(answer.outcome)});
  const double u = method.unit_roundoff;
  if (!(std::abs(answer.normal.norm() - 1) <= 16 * u)) return broken("a normal of a length other than 1");
  if (!answer.point_a.allFinite() || !answer.point_b.allFinite())
    return broken("a witness that is not a point: " + describe(answer));
  const RotatingTruth* truth = rotating_truth_of(seen);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  const double limit = row->contact_kappa(seen) * u * scale_of(seen);
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    // Its coordinates round by 2 u of its distance from the origin.
    const double off = truth->distance_from_body(body, answer.toi_lower, point).low - 2 * u * point.norm();
    if (off > limit + row_of(method, seen).rounding_at(answer.toi_lower))
      return broken(fmt::format("witness {} is {} off its body: {}", body, off, describe(answer)));
  }
  // At each other, by no more than the distance that is stated. A normal that misses support by g is known to
  // the root of 2 g over a ball's radius, so the ball's point to sqrt(2 g R) <= 2e-5 of the scale for g <=
  // 2e-10 of it, which is above what any row's bracket leaves.
  const double between_points = (answer.point_b - answer.point_a).norm() - seen.target_distance;
  const double near_enough = answer.distance + 2e-5 * scale_of(seen) + 2 * limit +
                             row_of(method, seen).rounding_at(answer.toi_lower) +
                             4 * u * (answer.point_a.norm() + answer.point_b.norm());
  if (between_points > near_enough)
    return broken(fmt::format("the witnesses are {} apart: {}", between_points, describe(answer)));
  if (truth->outcome() != Outcome::hit) return holds({label_of(answer.outcome), "no true normal"});
  const double between = std::max(std::abs(answer.toi_lower - truth->toi_lower()),
                                  std::abs(answer.toi_lower - truth->toi_upper()));
  const double error = truth->normal_error(answer.normal).low;
  if (error > limit + between * top_speed_of(seen)) {
    return broken(fmt::format("the normal {} fails to separate the bodies by {}: {}", hex(answer.normal),
                              error, describe(answer)));
  }
  return holds({label_of(answer.outcome)});
}

// ---- the checker's

// How many points of curved parts a point of the shape consists of; a proof's feature names kCurvedParts.
std::size_t curved_points(const Shape<double>& shape) {
  const auto of_part = [](const SharedShape<double>& part) { return part ? curved_points(part->shape) : 0; };
  if (const auto* posed = std::get_if<Posed<double>>(&shape)) return of_part(posed->shape);
  if (const auto* rounded = std::get_if<Rounded<double>>(&shape)) return of_part(rounded->shape);
  std::size_t count = 0;
  if (const auto* sum = std::get_if<Sum<double>>(&shape)) {
    for (const auto& part : sum->shapes) count += of_part(part);
    return count;
  }
  if (const auto* hull = std::get_if<HullOf<double>>(&shape)) {
    for (const auto& part : hull->shapes) count = std::max(count, of_part(part));
    return count;
  }
  return std::holds_alternative<Ellipsoid<double>>(shape) ||
                 std::holds_alternative<Cylinder<double>>(shape) ||
                 std::holds_alternative<Cone<double>>(shape)
             ? 1
             : 0;
}

LawResult turning_proof_is_accepted(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const RotatingAnswer answer = method.cast(seen, {.request = Request::proof});
  if (!answer.proof) {
    // A bracket that claims nothing needs no proof.
    const bool claims = answer.toi_lower > 0 || answer.toi_upper < kInfinity<double>;
    if (method.is_certified() && claims)
      return broken("a certified answer without a proof: " + describe(answer));
    return holds({label_of(answer.outcome), "no proof"});
  }
  const RotatingProof& proof = *answer.proof;
  const oracle::RotatingVerdict verdict = oracle::check_rotating_proof(seen, proof);
  if (!verdict.accepted() && verdict.refusal != oracle::RotatingRefusal::out_of_range) {
    return broken(fmt::format("proof refused, {}: {}; answered: {}", oracle::to_string(verdict.refusal),
                              verdict.detail, describe(answer)));
  }
  // In doubles, before the times are rounded to the scalar. A start that is called contact for being near has
  // no upper half, nor has a contact whose points cannot be named.
  const bool near = (answer.outcome == Outcome::initially_overlapping && !method.is_certified()) ||
                    std::max(curved_points(seen.a.shape), curved_points(seen.b.shape)) > kCurvedParts;
  if (!(proof.toi_lower >= answer.toi_lower) || !(near || proof.toi_upper <= answer.toi_upper)) {
    return broken(fmt::format("the proof says [{}, {}] only; answered: {}", hex(proof.toi_lower),
                              hex(proof.toi_upper), describe(answer)));
  }
  return holds({label_of(answer.outcome)});
}

// ---- the plan's

struct Asking {
  std::string_view name;
  Economies economies;
};
constexpr std::array<Asking, 11> kEconomies = {{
    {"every economy", {}},
    {"all but a static query", {.at_rest = false}},
    {"all but unseen turns", {.unseen_spin = false}},
    {"all but turning as one", {.as_one = false}},
    {"all but slow turns", {.slow_spin = false}},
    {"all but bounds", {.bounds = false}},
    {"a static query only", {true, false, false, false, false}},
    {"unseen turns only", {false, true, false, false, false}},
    {"turning as one only", {false, false, true, false, false}},
    {"slow turns only", {false, false, false, true, false}},
    {"bounds only", {false, false, false, false, true}},
}};
// Over scale: half of the slow turns drawn sway by less.
constexpr double kAskedTolerance = 0x1p-10;

LawResult plan_changes_nothing(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!follows_plan(method) || !is_rotating_question(seen)) return kOutside;
  LawResult result;
  for (const double tolerance : {0.0, kAskedTolerance, 64 * kAskedTolerance}) {
    RotatingAsk ask{.tolerance = tolerance, .economies = Economies::none()};
    const RotatingAnswer whole = method.cast(seen, ask);
    for (const Asking& one : kEconomies) {
      ask.economies = one.economies;
      const RotatingAnswer spared = method.cast(seen, ask);
      LawResult found = compare(method, {"without economies", seen, whole, tolerance},
                                {one.name, seen, spared, tolerance}, "economies change the answer");
      if (found.holding == Holding::broken) return found;
      result.labels = std::move(found.labels);
      // Brackets as wide as the tolerance meet, late or not.
      if (spared.plan.added > 0) {
        const RotatingTruth* truth = rotating_truth_of(seen);
        const std::string fault =
            truth == nullptr ? "" : late_fault(*truth, spared, row_of(method, seen, tolerance));
        if (!fault.empty()) return broken(fmt::format("with {}: {}: {}", one.name, fault, describe(spared)));
      }
      if (spared.plan.effects != Effects::rotating) result.labels.push_back(to_text(spared.plan.effects));
      if (spared.plan.added > 0) result.labels.push_back("slow");
    }
  }
  return result;
}

LawResult plan_spares_the_work(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!follows_plan(method) || !is_rotating_question(seen)) return kOutside;
  LawResult result;
  for (const double tolerance : {0.0, kAskedTolerance}) {
    const RotatingAnswer answer = method.cast(seen, {.tolerance = tolerance});
    const Plan& plan = answer.plan;
    const Plan said = method.plan(seen, {.tolerance = tolerance});
    Plan without = plan;
    without.reasons &=
        static_cast<std::uint16_t>(~(1u << static_cast<unsigned>(PlanReason::linear_left_open)));
    std::string fault;
    if (said.effects != plan.effects || said.reasons != without.reasons || said.added != plan.added) {
      fault = "plan() says otherwise than what is simulated";
    } else if (plan.effects == Effects::rotating && !engine::turns(seen)) {
      fault = "a rotating cast where neither body turns";
    } else if (plan.effects != Effects::rotating && !(plan.added > 0) && answer.counters.poses != 0) {
      fault = "turning bodies are placed where no turn is to be simulated";
    } else if (plan.effects == Effects::nothing &&
               (answer.counters.supports != 0 || answer.outcome != Outcome::miss)) {
      fault = "bounds that never meet are searched";
    } else if (plan.effects == Effects::at_rest && answer.outcome == Outcome::hit) {
      fault = "a static query that finds a later contact";
    } else if (plan.added > row_of(method, seen, tolerance).wide) {
      fault = "more is added than was asked for";
    } else if (plan.reasons == 0) {
      fault = "a plan without a reason";
    }
    const Plan full = method.plan(seen, {.tolerance = tolerance, .economies = Economies::none()});
    if (fault.empty() && engine::turns(seen) && full.effects != Effects::rotating)
      fault = "without economies a turn is not simulated";
    if (!fault.empty()) return broken(fault + ": " + describe(answer));
    result = holds({label_of(answer.outcome), to_text(plan.effects)});
    if (plan.added > 0) result.labels.push_back("slow");
  }
  return result;
}

// ---- metamorphic

// Steps and spheres may miss what happens between two steps, the published form anything: they are judged by
// the oracle's laws alone.
bool is_safe(const RotatingEngineMethod& method) {
  const engine::Guarantee* row = engine::find_guarantee(engine::guarantees(), method);
  return row != nullptr && row->may_miss == engine::Unseen::nothing;
}

LawResult turning_methods_meet(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return kOutside;
  const RotatingAnswer one = method.cast(seen, {});
  LawResult result = holds({label_of(one.outcome)});
  for (const RotatingEngineMethod& other : engine::rotating_methods()) {
    if (other.scalar != method.scalar || other.name == method.name || !is_safe(other)) continue;
    const RotatingAnswer two = other.cast(seen, {});
    if (overlap(times_of(one), times_of(two))) continue;
    result.labels.push_back("arbitrated");
    const RotatingTruth* truth = rotating_truth_of(seen);
    if (truth == nullptr) continue;
    for (const auto& [judged, answer] : {std::pair(&method, &one), std::pair(&other, &two)}) {
      const std::string fault = any_fault(*truth, *answer, row_of(*judged, seen));
      if (!fault.empty()) {
        return broken(fmt::format("{} and {} do not meet: {}; at fault is {}: {}", method.full_name(),
                                  other.full_name(), pair_of(one, two), judged->full_name(), fault));
      }
    }
  }
  return result;
}

LawResult turning_swapping(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const Case other = swapped(seen);
  const RotatingAnswer one = method.cast(seen, {}), two = method.cast(other, {});
  return compare(method, {"the original", seen, one}, {"the swapped", other, two},
                 "swapping changes the answer");
}

std::string difference(const RotatingAnswer& one, const RotatingAnswer& two) {
  if (one.outcome != two.outcome) return "outcome";
  if (!same_times(one, two)) return "time";
  if (one.counters.iterations != two.counters.iterations || one.counters.supports != two.counters.supports ||
      one.counters.poses != two.counters.poses)
    return "count of iterations, supports or poses";
  if (one.plan.reasons != two.plan.reasons) return "plan";
  return "";
}

LawResult turning_scaling(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const int powers[] = {-1, 1, 7, -9, 24, -31, 60, -60};
  const std::uint64_t first = hash_of(seen);
  for (std::size_t j = 0; j < std::size(powers); ++j) {
    const int k = powers[(j + first) % std::size(powers)];
    const std::optional<Case> other = scaled(seen, k);
    if (!other || !fits(*other, method)) continue;
    const RotatingAnswer one = method.cast(seen, {}), two = method.cast(*other, {});
    const std::string what = difference(one, two);
    if (!what.empty())
      return broken(fmt::format("every length times 2^{} changes the {}: {}", k, what, pair_of(one, two)));
    return holds({label_of(one.outcome), std::abs(k) > 20 ? "far scale" : "near scale"});
  }
  return not_applicable("no power of two keeps every number in range");
}

LawResult turning_translating(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  for (std::uint64_t salt = hash_of(seen), tries = 0; tries < 4; ++tries, ++salt) {
    const std::optional<Case> other = translated(seen, salt);
    if (!other || !fits(*other, method)) continue;
    const RotatingAnswer one = method.cast(seen, {}), two = method.cast(*other, {});
    return compare(method, {"the original", seen, one}, {"the translated", *other, two},
                   "translating both changes the answer");
  }
  return not_applicable("no exact translation");
}

LawResult turning_both(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const RotatingAnswer one = method.cast(seen, {});
  const std::optional<Case> turned = turned_about(seen, hash_of(seen));
  LawResult result = not_applicable("no exact turn");
  if (turned && fits(*turned, method)) {
    const RotatingAnswer two = method.cast(*turned, {});
    result = compare(method, {"the original", seen, one}, {"the turned", *turned, two},
                     "turning both changes the answer");
    if (result.holding == Holding::broken) return result;
  }
  const Case image = mirrored(seen);
  const RotatingAnswer three = method.cast(image, {});
  LawResult second = compare(method, {"the original", seen, one}, {"the mirror image", image, three},
                             "mirroring changes the answer");
  return second.holding == Holding::broken || result.holding == Holding::not_applicable ? second : result;
}

LawResult stretching_time(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const int powers[] = {1, -1, 3, -3, 10, -10};
  const std::uint64_t first = mix(hash_of(seen));
  for (std::size_t j = 0; j < std::size(powers); ++j) {
    const int k = powers[(j + first) % std::size(powers)];
    const std::optional<Case> other = stretched(seen, k);
    if (!other || !fits(*other, method) || !is_rotating_question(*other)) continue;
    const RotatingAnswer one = method.cast(seen, {});
    RotatingAnswer two = method.cast(*other, {});
    two.toi_lower = std::scalbn(two.toi_lower, -k);
    two.toi_upper = std::scalbn(two.toi_upper, -k);
    const std::string what = difference(one, two);
    if (!what.empty())
      return broken(fmt::format("a step 2^{} times as long changes the {}: {}", k, what, pair_of(one, two)));
    return holds({label_of(one.outcome)});
  }
  return not_applicable("no power of two keeps every number in range");
}

constexpr double kFractions[] = {0.5, 0.25, 0.75, 0.125, 0.875};

LawResult turning_horizon(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !(seen.t_max > 0)) return kOutside;
  Case sooner = seen;
  sooner.expect.reset();
  sooner.t_max *= kFractions[hash_of(seen) % std::size(kFractions)];
  if (!fits(sooner, method)) return not_applicable("no horizon in this scalar");
  const RotatingAnswer whole = method.cast(seen, {});
  RotatingAnswer part = method.cast(sooner, {});
  if (claims_contact(part) && !(part.toi_lower <= sooner.t_max))
    return broken("a contact after the end of the step: " + describe(part));
  if (part.outcome == Outcome::miss) part.toi_lower = sooner.t_max;  // no contact before that
  return labelled(compare(method, {"the whole step", seen, whole}, {"a part of it", sooner, part},
                          "a shorter step has another contact"),
                  {part.outcome == Outcome::miss ? "contact after or none" : "contact before"});
}

// What is restarted is off by a rounding (case_edit.hpp: Restart), which is granted as a length.
LawResult turning_splitting(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return kOutside;
  const std::optional<Restart> restart =
      restarted(seen, kFractions[mix(hash_of(seen)) % std::size(kFractions)]);
  if (!restart) return not_applicable("no restart");
  Case before = seen;
  before.expect.reset();
  before.t_max = restart->at;
  if (!fits(before, method)) return not_applicable("no horizon in this scalar");
  if (method.cast(before, {}).outcome != Outcome::miss) return not_applicable("contact before the restart");
  const RotatingAnswer whole = method.cast(seen, {});
  const Case after = method.seen(restart->after);
  if (!is_rotating_question(after)) return kOutside;
  // The pose is rounded to the scalar once more: a quaternion's components by u each, so a point of the body,
  // and the pivot, by 2 u of its distance from the body's origin, which is rounded by u. Three times as much
  // later (Restart).
  double slack = restart->error;
  for (const auto& [body, spin] : {std::pair(&after.a, &after.spin_a), std::pair(&after.b, &after.spin_b)}) {
    const corpus::Bounds box = corpus::bounds(body->shape);
    const double reach = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() + spin->pivot.norm();
    slack += 3 * method.unit_roundoff * (2 * reach + body->position.norm());
  }
  // A time less by `at` is rounded, too.
  slack += 2 * method.unit_roundoff * seen.t_max * top_speed_of(seen);
  RotatingAnswer joined = method.cast(after, {});
  // Each question has a scale of its own.
  RotatingRow row = row_of(method, seen, 0, slack);
  const RotatingRow its = row_of(method, after, 0, slack);
  row.limit = std::max(row.limit, its.limit);
  row.wide = std::max(row.wide, its.wide);
  if (joined.outcome == Outcome::initially_overlapping) joined.outcome = Outcome::hit;
  joined.toi_lower += restart->at;
  joined.toi_upper += restart->at;
  LawResult result = holds({label_of(whole.outcome)});
  if (overlap(times_of(whole), times_of(joined))) return result;
  const RotatingTruth* truth = rotating_truth_of(seen);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  result.labels.push_back("arbitrated");
  std::string fault = any_fault(*truth, whole, row_of(method, seen));
  if (fault.empty()) fault = any_fault(*truth, joined, row);
  if (!fault.empty()) {
    return broken(fmt::format("from {} on the answer is another: {}; {}", hex(restart->at),
                              pair_of(whole, joined), fault));
  }
  return result;
}

LawResult unturned_is_linear(const Case& problem, const RotatingEngineMethod& method) {
  const Case still = without_turns(method.seen(problem));
  if (!engine::unsupported_rotating(still).empty() || !in_domain(still)) return kOutside;
  const bool ray = std::isinf(still.t_max) || still.start_policy != StartPolicy::report;
  const RotatingAnswer answer = method.cast(still, {});
  if (ray && !follows_plan(method)) {
    // What no method alone takes is refused.
    const bool refused = answer.outcome == Outcome::invalid_input && answer.invalid == Invalid::not_linear;
    if (std::isinf(still.t_max) && !refused)
      return broken("a rotating method takes a ray: " + describe(answer));
    return kOutside;
  }
  LawResult result = holds({label_of(answer.outcome)});
  if (follows_plan(method)) {
    // By the tier's method: of tier standard one of two, whichever suits the shapes.
    std::string said;
    for (const char* name : {"certified", "mpr", "gjk"}) {
      if (method.is_certified() != (name == std::string_view("certified"))) continue;
      const engine::EngineMethod* linear = engine::find_method(std::string(name) + "/" + method.scalar);
      if (linear == nullptr) return not_applicable("no linear method of this tier");
      const engine::Answer its = linear->cast(still, {});
      if (answer.outcome == its.outcome && answer.passed_over == its.passed_over &&
          (answer.outcome == Outcome::invalid_input ||
           (answer.toi_lower == its.toi_lower && answer.toi_upper == its.toi_upper)))
        return result;
      said += "; " + linear->full_name() + " says " + describe(its);
    }
    return broken("without turns the plan says " + describe(answer) + said);
  }
  const engine::EngineMethod* linear = engine::find_method("gjk/" + method.scalar);
  if (linear == nullptr) return not_applicable("no linear method in this scalar");
  const engine::Answer said = linear->cast(still, {});
  if (overlap(times_of(answer), {said.toi_lower, said.toi_upper})) return result;
  const RotatingTruth* truth = rotating_truth_of(still);
  if (truth == nullptr) return not_applicable("no oracle decides the case");
  const std::string fault = any_fault(*truth, answer, row_of(method, still));
  if (!fault.empty())
    return broken(fmt::format("without turns: {}; the linear cast says {}", fault, describe(said)));
  return labelled(std::move(result), {"arbitrated"});
}

// Against the body without its turn. The other body keeps what it has, or, at times, turns unseen as well:
// then the plan must come to a linear cast, for rays and policies too.
LawResult unseen_turn_is_none(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!in_domain(seen)) return kOutside;
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
  if (!is_rotating_question(*spun) && !(linear && follows_plan(method))) return kOutside;
  const RotatingAnswer one = method.cast(*spun, {}), two = method.cast(still, {});
  if (!linear || !follows_plan(method)) {
    return compare(method, {"with the turn", *spun, one}, {"without", still, two},
                   "a turn that cannot be seen changes the answer");
  }
  if (one.plan.effects == Effects::rotating)
    return broken("a turn that cannot be seen is simulated: " + describe(one));
  // By the same query, to the bit.
  if (one.plan.effects == two.plan.effects && !(one.plan.added > 0) && !same_times(one, two))
    return broken("a turn that cannot be seen changes the answer: " + pair_of(one, two));
  if (!is_rotating_question(*spun)) return holds({label_of(one.outcome), "ray"});
  return labelled(compare(method, {"with the turn", *spun, one}, {"without", still, two},
                          "a turn that cannot be seen changes the answer"),
                  {"linear"});
}

LawResult as_one_stands_still(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const std::optional<Case> alike = moved_as_one(seen);
  if (!alike || !fits(*alike, method)) return not_applicable("no exact common pivot");
  Case still = without_turns(*alike);
  still.a.displacement.setZero();
  still.b.displacement.setZero();
  const RotatingAnswer one = method.cast(*alike, {}), two = method.cast(still, {});
  if (follows_plan(method) && one.plan.effects == Effects::rotating)
    return broken("bodies that stand still to each other are simulated: " + describe(one));
  return compare(method, {"both moving as one", *alike, one}, {"both at rest", still, two},
                 "moving as one changes the answer");
}

LawResult turning_superset(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const RotatingAnswer one = method.cast(seen, {});
  LawResult result = holds({label_of(one.outcome)});
  const auto check = [&](const Case& larger, std::string_view name) {
    if (!is_rotating_question(larger) || !fits(larger, method)) return;
    RotatingAnswer two = method.cast(larger, {});
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

LawResult tolerance_is_kept(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  // Steps are refined to the tolerance too, but may miss; the published form has its slop.
  if (method.name == "bilateral_published") return not_applicable("its tolerance is a slop");
  const RotatingAnswer tight = method.cast(seen, {});
  LawResult result = holds({label_of(tight.outcome)});
  for (const double tolerance : {0x1p-7, 0x1p-20}) {
    const RotatingAnswer loose = method.cast(seen, {.tolerance = tolerance});
    LawResult found = compare(method, {"tight", seen, tight}, {"loose", seen, loose, tolerance},
                              "a tolerance changes the answer");
    if (found.holding == Holding::broken) return found;
    const RotatingRow row = row_of(method, seen, method.is_certified() ? 0 : tolerance);
    // Of a linear cast a tolerance means the backward error, and its distance may be the larger.
    const bool marched = loose.plan.effects == Effects::rotating || loose.plan.added > 0;
    if (marched && claims_contact(loose) && loose.distance > row.wide + row.rounding_at(loose.toi_lower)) {
      return broken(fmt::format("asked for a width of {} of the scale, {} is given: {}", tolerance,
                                loose.distance, describe(loose)));
    }
    if (loose.outcome == Outcome::not_converged && tight.outcome != Outcome::not_converged)
      result.labels.push_back("loose stalls");
  }
  return result;
}

// A proof is of the whole motion, whatever the plan spares: another search, at times a shorter one.
LawResult turning_requesting(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const RotatingAnswer least = method.cast(seen, {});
  const RotatingAnswer more = method.cast(seen, {.request = Request::normal | Request::witnesses});
  const RotatingAnswer all = method.cast(seen, {.request = Request::everything});
  if (!same_times(least, more)) return broken("asking for more changes the verdict: " + pair_of(least, more));
  if (least.counters.supports > more.counters.supports || least.counters.poses > more.counters.poses)
    return broken("asking for less costs more: " + pair_of(least, more));
  if (!least.normal.isZero(0) || !least.point_a.isZero(0) || !least.point_b.isZero(0) || least.proof ||
      more.proof)
    return broken("computed unasked: " + describe(least));
  return compare(method, {"without a proof", seen, least}, {"with a proof", seen, all},
                 "asking for a proof changes the answer");
}

LawResult turning_answer_is_consistent(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  const RotatingAnswer answer = method.cast(seen, {});
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
  // Rounded, so a little below 0 at times; without a bound where nothing is known at toi_lower.
  const bool unknown = answer.outcome == Outcome::not_converged && answer.distance == kInfinity<double>;
  if (!unknown && !(answer.distance >= -row_of(method, seen).wide && std::isfinite(answer.distance)))
    fault = fmt::format("a distance that is none, {}", answer.distance);
  if (!fault.empty()) return broken(fault + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

LawResult bad_turn_is_refused(const Case& problem, const RotatingEngineMethod& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return kOutside;
  std::string fault;
  const auto expect_refusal = [&](const Case& bad, const RotatingAsk& ask, const std::string& what) {
    const RotatingAnswer answer = method.cast(bad, ask);
    if (answer.outcome == Outcome::invalid_input && answer.invalid != Invalid::none &&
        answer.counters.iterations == 0 && std::isnan(answer.toi_lower) && std::isnan(answer.toi_upper)) {
      return;
    }
    if (fault.empty()) fault = fmt::format("{} is let in: {}", what, describe(answer));
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = kInfinity<double>;
  for (const auto spin : {&Case::spin_a, &Case::spin_b}) {
    for (const auto given : {&corpus::Spin::rotation, &corpus::Spin::pivot}) {
      for (const double poison : {kNan, kInf, -kInf, std::numeric_limits<double>::max()}) {
        Case bad = seen;
        (bad.*spin.*given)[static_cast<int>(hash_of(seen) % 3)] = poison;
        expect_refusal(bad, {}, fmt::format("{} in a turn", poison));
      }
    }
    Case fast = seen;
    fast.t_max = 1;
    (fast.*spin).rotation = Vec3<double>(0, 0x1p31, 0);
    expect_refusal(fast, {}, "a turn by 2^31 radians");
  }
  for (const double t_max : {kNan, -1.0}) {
    Case bad = seen;
    bad.t_max = t_max;
    expect_refusal(bad, {}, fmt::format("a t_max of {}", t_max));
  }
  for (const double tolerance : {kNan, kInf, -1.0}) {
    expect_refusal(seen, {.tolerance = tolerance}, fmt::format("a tolerance of {}", tolerance));
  }
  // A turn that is seen, as a ray or by the policy.
  Case rod = seen;
  rod.a.shape = Segment<double>{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0)};
  rod.a.orientation = {};
  rod.spin_a = {Vec3<double>(0, 0, 1), Vec3<double>::Zero()};
  rod.b = {};
  rod.spin_b = {};
  rod.b.position = rod.a.position;
  rod.b.displacement = rod.a.displacement;
  rod.t_max = kInf;
  expect_refusal(rod, {}, "a seen turn without an end");
  rod.t_max = 1;
  rod.start_policy = StartPolicy::pass_over;
  if (follows_plan(method)) expect_refusal(rod, {}, "a seen turn by the policy pass_over");
  if (!fault.empty()) return broken(fault);
  return holds({label_of(method.cast(seen, {}).outcome)});
}

constexpr RotatingLaw kLaws[] = {
    {"turning_swapping", "Swapping A and B keeps the bracket.", Needs::metamorphic, &turning_swapping},
    {"turning_scaling", "Multiplying every length by a power of two changes no time and no count.",
     Needs::metamorphic, &turning_scaling},
    {"turning_translating", "Translating both bodies by an exact amount keeps the bracket.",
     Needs::metamorphic, &turning_translating},
    {"turning_both", "Turning both bodies and their motion, or mirroring them, keeps the bracket.",
     Needs::metamorphic, &turning_both},
    {"stretching_time", "A step 2^k times as long at velocities 2^-k times as large has times times 2^k.",
     Needs::metamorphic, &stretching_time},
    {"turning_horizon", "A shorter step has the same first contact, or none before its end.",
     Needs::metamorphic, &turning_horizon},
    {"turning_splitting", "Casting from where the bodies are at s, on to T, finds the same first contact.",
     Needs::metamorphic, &turning_splitting},
    {"turning_superset", "A superset, or a larger target distance, is never hit later.", Needs::metamorphic,
     &turning_superset},
    {"unturned_is_linear", "Without turns the answer is the linear cast's.", Needs::metamorphic,
     &unturned_is_linear},
    {"unseen_turn_is_none", "A ball's turn about its centre, or a solid's about its axis, changes nothing.",
     Needs::metamorphic, &unseen_turn_is_none},
    {"as_one_stands_still", "Bodies that turn and move as one meet at t = 0 or never.", Needs::metamorphic,
     &as_one_stands_still},
    {"plan_changes_nothing", "Every economy on or off, verdicts stay and brackets meet.", Needs::metamorphic,
     &plan_changes_nothing},
    {"plan_spares_the_work", "What a plan spares is not done, and a plan says what is done.",
     Needs::metamorphic, &plan_spares_the_work},
    {"turning_methods_meet", "The brackets of the methods of one scalar meet, each within its row.",
     Needs::metamorphic, &turning_methods_meet},
    {"tolerance_is_kept", "A tolerance widens a bracket by no more than itself, and makes no time late.",
     Needs::metamorphic, &tolerance_is_kept},
    {"turning_requesting", "Asking for less changes no verdict, costs no more and computes nothing unasked.",
     Needs::metamorphic, &turning_requesting},
    {"turning_answer_is_consistent", "Outcome and bracket say one thing.", Needs::metamorphic,
     &turning_answer_is_consistent},
    {"bad_turn_is_refused", "A NaN, an infinity, 2^31 radians, or a seen turn without an end is refused.",
     Needs::metamorphic, &bad_turn_is_refused},
    {"turning_proof_is_accepted", "Every proof is accepted, and says as much as the answer.", Needs::proof,
     &turning_proof_is_accepted},
    {"turning_verdict_is_right", "Contact or no contact is wrong only within the row.", Needs::oracle,
     &turning_verdict_is_right},
    {"turning_is_never_late", "toi_lower is not past the first contact by more than the row's depth.",
     Needs::oracle, &turning_is_never_late},
    {"turning_claims_no_contact_early", "At toi_upper the bodies have met.", Needs::oracle,
     &turning_claims_no_contact_early},
    {"turning_bracket_is_narrow", "Either end of a contact's bracket is as near to it as the row says.",
     Needs::oracle, &turning_bracket_is_narrow},
    {"turning_contact_is_right", "A hit's normal separates the bodies, and its witnesses lie in them.",
     Needs::oracle, &turning_contact_is_right},
};

}  // namespace

std::span<const RotatingLaw> rotating_laws() { return kLaws; }

const RotatingLaw* find_rotating_law(std::string_view name) {
  for (const RotatingLaw& law : kLaws) {
    if (law.name == name) return &law;
  }
  return nullptr;
}

}  // namespace graze::law
