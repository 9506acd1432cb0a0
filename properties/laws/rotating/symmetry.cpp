// Laws that call a rotating method twice, the second time with the same bodies and motion described in another way.
// They use exact edits of a case (edit/turning.hpp) that keep the times of contact.
#include <fmt/format.h>

#include <cmath>
#include <optional>

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

namespace {

LawResult turning_swapping(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const Case other = swapped(seen);
  const Answer one = plain_answer(method, seen), two = method.ask(other, {});
  return compare(method, {"the original", seen, one}, {"the swapped", other, two},
                 "swapping changes the answer");
}

LawResult turning_scaling(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const int powers[] = {-1, 1, 7, -9, 24, -31, 60, -60};
  const std::uint64_t first = hash_of(seen);
  for (std::size_t j = 0; j < std::size(powers); ++j) {
    const int k = powers[(j + first) % std::size(powers)];
    const std::optional<Case> other = scaled(seen, k);
    if (!other || !fits(*other, method)) continue;
    const Answer one = plain_answer(method, seen), two = method.ask(*other, {});
    const std::string what = difference(one, two);
    if (!what.empty())
      return broken(fmt::format("every length times 2^{} changes the {}: {}", k, what, pair_of(one, two)));
    return holds({label_of(one.outcome), std::abs(k) > 20 ? "far scale" : "near scale"});
  }
  return not_applicable("no power of two keeps every number in range");
}

LawResult turning_translating(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  for (std::uint64_t salt = hash_of(seen), tries = 0; tries < 4; ++tries, ++salt) {
    const std::optional<Case> other = translated(seen, salt);
    if (!other || !fits(*other, method)) continue;
    const Answer one = plain_answer(method, seen), two = method.ask(*other, {});
    return compare(method, {"the original", seen, one}, {"the translated", *other, two},
                   "translating both changes the answer");
  }
  return not_applicable("no exact translation");
}

LawResult turning_both(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const Answer one = plain_answer(method, seen);
  const std::optional<Case> turned = turned_about(seen, hash_of(seen));
  LawResult result = not_applicable("no exact turn");
  if (turned && fits(*turned, method)) {
    const Answer two = method.ask(*turned, {});
    result = compare(method, {"the original", seen, one}, {"the turned", *turned, two},
                     "turning both changes the answer");
    if (result.holding == Holding::broken) return result;
  }
  const Case image = mirrored(seen);
  const Answer three = method.ask(image, {});
  LawResult second = compare(method, {"the original", seen, one}, {"the mirror image", image, three},
                             "mirroring changes the answer");
  return second.holding == Holding::broken || result.holding == Holding::not_applicable ? second : result;
}

LawResult pivot_is_a_line(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  LawResult result = not_applicable("no exact place on the axis for another pivot");
  for (const bool first : {true, false}) {
    const std::optional<SlidPivot> slid = with_slid_pivot(seen, first, hash_of(seen) + (first ? 0 : 1));
    if (!slid || !fits(slid->before, method) || !fits(slid->after, method)) continue;
    const Answer one = plain_answer(method, slid->before), two = method.ask(slid->after, {});
    result =
        compare(method, {"as it was", slid->before, one}, {"with a pivot along the axis", slid->after, two},
                "a pivot moved along its axis changes the answer");
    if (result.holding == Holding::broken) return result;
    // In tier certified no motion is below noise: an exactly invisible one stays so. Bounds are about the
    // pivots.
    const Vec3<double>& w = first ? slid->before.spin_a.rotation : slid->before.spin_b.rotation;
    const bool plain = (w.array() != 0).count() == 1;
    const auto bounded = [](const Answer& a) { return a.plan.effects == Effects::nothing; };
    if (plain && method.is_certified() && !bounded(one) && !bounded(two) &&
        one.plan.effects != two.plan.effects)
      return broken("a pivot moved along its axis changes the plan: " + pair_of(one, two));
  }
  return result;
}

LawResult idle_pivot_is_nothing(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const std::optional<Case> other = with_idle_pivots(seen, hash_of(seen));
  if (!other || !fits(*other, method)) return not_applicable("both bodies turn");
  const Answer one = plain_answer(method, seen), two = method.ask(*other, {});
  const std::string what = difference(one, two);
  if (!what.empty()) {
    return broken(
        fmt::format("the pivot of a body that does not rotate changes the {}: {}", what, pair_of(one, two)));
  }
  return holds({label_of(one.outcome), engine::turns(seen) ? "one turns" : "none turns"});
}

// Velocities count by their difference alone, and their sums here are exact. The answers are the same to the bit,
// except for witnesses, which are carried along.
LawResult turning_drifting(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const std::optional<Drift> drift = drifting(seen, hash_of(seen));
  if (!drift || !fits(drift->problem, method)) return not_applicable("no exact sum of velocities");
  constexpr Request kContact = Request::normal | Request::witnesses;
  const Answer one = method.ask(seen, {.request = kContact}),
               two = method.ask(drift->problem, {.request = kContact});
  LawResult result = compare(method, {"the original", seen, one}, {"the drifting", drift->problem, two},
                             "a velocity that both share changes the answer");
  // A linear cast answers to the given numbers, and may come to another end of its bracket.
  if (result.holding == Holding::broken || one.outcome != Outcome::hit || !same_times(one, two))
    return result;
  const Vec3<double> way = one.toi_lower * drift->drift;
  const double u = method.unit_roundoff;
  for (const bool first : {true, false}) {
    const Vec3<double>&x = first ? one.point_a : one.point_b, &y = first ? two.point_a : two.point_b;
    const double off = (y - x - way).norm();
    // Each is rounded to the scalar: an axis by u of itself, and a point by u of its summands.
    const double granted =
        2 * limits_of(method, seen, scale_of(seen)).contact + 8 * u * (x.norm() + y.norm() + way.norm());
    if (off > granted) {
      return broken(fmt::format("carried along by {}, witness {} is {} off: {}", decimal(way),
                                first ? 'a' : 'b', off, pair_of(one, two)));
    }
  }
  return labelled(std::move(result), {"witnesses"});
}

}  // namespace

std::vector<Law> rotating_symmetry_laws() {
  return {
      {"turning_swapping", "Swapping A and B keeps the bracket.", Needs::metamorphic, &turning_swapping},
      {"turning_scaling", "Multiplying every length by a power of two changes no time and no count.",
       Needs::metamorphic, &turning_scaling},
      {"turning_translating", "Translating both bodies by an exact amount keeps the bracket.",
       Needs::metamorphic, &turning_translating},
      {"turning_both", "Rotating both bodies and their motion, or mirroring them, keeps the bracket.",
       Needs::metamorphic, &turning_both},
      {"pivot_is_a_line", "A pivot moved along its axis keeps the bracket.", Needs::metamorphic,
       &pivot_is_a_line},
      {"idle_pivot_is_nothing", "The pivot of a body that does not rotate changes nothing.",
       Needs::metamorphic, &idle_pivot_is_nothing},
      {"turning_drifting", "A velocity that both bodies share keeps the bracket, and carries the witnesses.",
       Needs::metamorphic, &turning_drifting},
  };
}

}  // namespace graze::law
