// Laws that call a rotating method twice, the second time for other times: a longer or a shorter step, a part of it,
// the way back.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>

#include "corpus/support_value.hpp"
#include "engines/method.hpp"
#include "properties/edit/case.hpp"
#include "properties/edit/turning.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using oracle::RotatingTruth;

namespace {

LawResult stretching_time(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const int powers[] = {1, -1, 3, -3, 10, -10};
  const std::uint64_t first = mix(hash_of(seen));
  for (std::size_t j = 0; j < std::size(powers); ++j) {
    const int k = powers[(j + first) % std::size(powers)];
    const std::optional<Case> other = stretched(seen, k);
    if (!other || !fits(*other, method) || !is_rotating_question(*other)) continue;
    const Answer one = plain_answer(method, seen);
    Answer two = method.ask(*other, {});
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

// A pose that is rounded to the scalar. A quaternion's components round by u each, so a point of the body, and the
// pivot, round by 2 u of their distance from the body's origin, which is rounded by u. Later the error is three times
// as much (Restart).
double rounding_of_pose(const Case& given, const Method& method) {
  double sum = 0;
  for (const auto& [body, spin] : {std::pair(&given.a, &given.spin_a), std::pair(&given.b, &given.spin_b)}) {
    const corpus::Bounds box = corpus::bounds(body->shape);
    const double reach = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() + spin->pivot.norm();
    sum += 3 * method.unit_roundoff * (2 * reach + body->position.norm());
  }
  return sum;
}

LawResult turning_horizon(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !(seen.t_max > 0)) return no_rotating_question();
  Case sooner = seen;
  sooner.expect.reset();
  sooner.t_max *= kFractions[hash_of(seen) % std::size(kFractions)];
  if (!fits(sooner, method)) return not_applicable("no horizon in this scalar");
  const Answer whole = plain_answer(method, seen);
  Answer part = method.ask(sooner, {});
  if (claims_contact(part) && !(part.toi_lower <= sooner.t_max))
    return broken("a contact after the end of the step: " + describe(part));
  if (part.outcome == Outcome::miss) part.toi_lower = sooner.t_max;  // no contact before that
  return labelled(compare(method, {"the whole step", seen, whole}, {"a part of it", sooner, part},
                          "a shorter step has another contact"),
                  {part.outcome == Outcome::miss ? "contact after or none" : "contact before"});
}

// A restarted motion is off by a rounding (edit/turning.hpp: Restart), which is granted as a length.
LawResult turning_splitting(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return no_rotating_question();
  const std::optional<Restart> restart =
      restarted(seen, kFractions[mix(hash_of(seen)) % std::size(kFractions)]);
  if (!restart) return not_applicable("no restart");
  Case before = seen;
  before.expect.reset();
  before.t_max = restart->at;
  if (!fits(before, method)) return not_applicable("no horizon in this scalar");
  if (method.ask(before, {}).outcome != Outcome::miss) return not_applicable("contact before the restart");
  const Answer whole = plain_answer(method, seen);
  const Case after = method.seen(restart->after);
  if (!is_rotating_question(after)) return no_rotating_question();
  double slack = restart->error + rounding_of_pose(after, method);
  // A time less by `at` is rounded, too.
  slack += 2 * method.unit_roundoff * seen.t_max * top_speed_of(seen);
  Answer joined = method.ask(after, {});
  // Each question has a scale of its own.
  Limits row = limits_of(method, seen, scale_of(seen), 0, slack);
  const Limits its = limits_of(method, after, scale_of(after), 0, slack);
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
  std::string fault = any_fault(*truth, whole, limits_of(method, seen, scale_of(seen)));
  if (fault.empty()) fault = any_fault(*truth, joined, row);
  if (!fault.empty()) {
    return broken(fmt::format("from {} on the answer is another: {}; {}", decimal(restart->at),
                              pair_of(whole, joined), fault));
  }
  return result;
}

// The last contact of a path is the first on the way back, so that is no later than T less the first one. A miss stays
// a miss. Either answer has a case of its own, and a truth. They differ by a rounding.
LawResult turning_backwards(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return no_rotating_question();
  const std::optional<WayBack> way = way_back(seen);
  if (!way) return not_applicable("no way back");
  const Case back = method.seen(way->problem);
  if (!is_rotating_question(back)) return no_rotating_question();
  const Answer one = plain_answer(method, seen), two = method.ask(back, {});
  const double most = seen.t_max * (1 + 4 * method.unit_roundoff);
  const bool meets = one.outcome == Outcome::miss || two.outcome == Outcome::miss
                         ? one.outcome == two.outcome || !(claims_contact(one) || claims_contact(two))
                         : one.toi_lower + two.toi_lower <= most;
  LawResult result = holds({label_of(one.outcome)});
  if (meets) return result;
  // Proved or not, one is off by the slack.
  const double slack = way->error + rounding_of_pose(back, method);
  return arbitrate(method, {"the way there", seen, one, 0, slack}, {"the way back", back, two, 0, slack},
                   "the way back finds other contacts");
}

// Fast rotations are answered by their swept volume (whole_turns.hpp), a single one is not.
LawResult whole_turn_is_all(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen) || !is_safe(method)) return no_rotating_question();
  LawResult result = not_applicable("neither body turns");
  for (const bool first : {true, false}) {
    const std::optional<WholeTurn> turn = whole_turns(seen, first);
    if (!turn || !fits(turn->once, method) || !is_rotating_question(turn->often)) continue;
    const Answer one = method.ask(turn->once, {}), two = method.ask(turn->often, {});
    result = compare(method, {"one turn", turn->once, one}, {"eight turns", turn->often, two},
                     "more than a whole turn has another contact");
    if (result.holding == Holding::broken) return result;
  }
  return result;
}

}  // namespace

std::vector<Law> rotating_time_laws() {
  return {
      {"stretching_time", "A step 2^k times as long at velocities 2^-k times as large has times times 2^k.",
       Needs::metamorphic, &stretching_time},
      {"turning_horizon", "A shorter step has the same first contact, or none before its end.",
       Needs::metamorphic, &turning_horizon},
      {"turning_splitting", "Casting from where the bodies are at s, on to T, finds the same first contact.",
       Needs::metamorphic, &turning_splitting},
      {"turning_backwards",
       "On the way back contact is no later than T less the first one, and a miss stays a miss.",
       Needs::metamorphic, &turning_backwards},
      {"whole_turn_is_all", "A body that only rotates meets nothing new after a full turn.",
       Needs::metamorphic, &whole_turn_is_all},
  };
}

}  // namespace graze::law
