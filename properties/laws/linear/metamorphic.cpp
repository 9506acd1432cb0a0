// Laws that call the method twice: an exact edit of the case, whose true answer is known from the original's. If the
// two answers differ, the oracle arbitrates (judge.hpp).
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "properties/laws/ask_twice.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;

namespace {

const LawResult kOutside = not_applicable("not a cast that the method answers");

// An edit must survive the rounding to the method's scalar, or the two questions are not the intended ones.
bool fits(const Case& edited, const Method& method) { return same_input(method.seen(edited), edited); }

std::string pair_of(const Answer& one, const Answer& other) {
  return describe(one) + "; against " + describe(other);
}

LawResult swapping(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return kOutside;
  const Case other = swapped(seen);
  const engine::Ask ask{.request = Request::normal};
  const Answer one = method.ask(seen, ask), two = method.ask(other, ask);
  LawResult result = holds();
  if (!agree_within_rows(method, seen, one, two)) {
    result = arbitrate(method, {{"the original", seen, one}, {"the swapped", other, two}},
                       "swapping changes the answer");
    if (result.holding == Holding::broken) return result;
  }
  result.labels.push_back(label_of(one.outcome));
  if (one.outcome != Outcome::hit || two.outcome != Outcome::hit) return result;
  if ((one.normal + two.normal).cwiseAbs().maxCoeff() <= 16 * method.unit_roundoff) return result;
  // At a vertex or an edge there is a cone of normals, and the two need not be opposite: each must support C.
  if (const auto open = without_truth(seen)) return *open;
  if (truth_of(seen).outcome() != Outcome::hit) return result;
  result.labels.push_back("cone");
  const std::string fault = normal_fault(seen, two, -two.normal, contact_bound_of(method, seen));
  if (!fault.empty()) return broken("the swapped normal, negated: " + fault + ": " + pair_of(one, two));
  return result;
}

LawResult scaling(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return kOutside;
  const int powers[] = {-1, 1, 7, -9, 24, -31, 60, -60};
  const std::uint64_t first = hash_of(seen);
  for (std::size_t j = 0; j < std::size(powers); ++j) {
    const int k = powers[(j + first) % std::size(powers)];
    const std::optional<Case> other = scaled(seen, k);
    if (!other || !fits(*other, method)) continue;
    const engine::Ask ask{.request = Request::normal | Request::witnesses};
    const Answer one = method.ask(seen, ask), two = method.ask(*other, ask);
    const auto same = [](double l, double r) { return l == r || (std::isnan(l) && std::isnan(r)); };
    const auto scaled_point = [](const Vec3<double>& p, int by) {
      return Vec3<double>(std::scalbn(p[0], by), std::scalbn(p[1], by), std::scalbn(p[2], by));
    };
    // A coordinate that is, or becomes, subnormal.
    const double least = method.scalar == "float" ? double(std::numeric_limits<float>::min())
                                                  : std::numeric_limits<double>::min();
    const auto loses_bits = [&](const Vec3<double>& p) {
      return (p.array() != 0 && p.array().abs() < least * std::max(1.0, std::scalbn(1.0, -k))).any();
    };
    std::string fault;
    if (one.outcome != two.outcome)
      fault = "outcome";
    else if (!same(one.toi_lower, two.toi_lower) || !same(one.toi_upper, two.toi_upper))
      fault = "time";
    else if (one.counters.iterations != two.counters.iterations ||
             one.counters.supports != two.counters.supports)
      fault = "count of iterations or supports";
    else if (one.normal != two.normal)
      fault = "normal";
    else if (loses_bits(one.point_a) || loses_bits(one.point_b) ||
             loses_bits(scaled_point(two.point_a, -k)) || loses_bits(scaled_point(two.point_b, -k)))
      continue;
    else if (scaled_point(one.point_a, k) != two.point_a || scaled_point(one.point_b, k) != two.point_b)
      fault = "witness";
    if (!fault.empty())
      return broken(fmt::format("every length times 2^{} changes the {}: {}", k, fault, pair_of(one, two)));
    return holds({label_of(one.outcome), std::abs(k) > 20 ? "far scale" : "near scale"});
  }
  return not_applicable("no power of two keeps every number in range");
}

LawResult translating(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return kOutside;
  for (std::uint64_t salt = hash_of(seen), tries = 0; tries < 4; ++tries, ++salt) {
    const std::optional<Case> other = translated(seen, salt);
    if (!other || !fits(*other, method)) continue;
    const Answer one = method.ask(seen, {}), two = method.ask(*other, {});
    LawResult result = agree_within_rows(method, seen, one, two)
                           ? holds()
                           : arbitrate(method, {{"the original", seen, one}, {"the translated", *other, two}},
                                       "translating both changes the answer");
    result.labels.push_back(label_of(one.outcome));
    return result;
  }
  return not_applicable("no exact translation");
}

LawResult superset(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return kOutside;
  for (std::uint64_t salt = hash_of(seen), tries = 0; tries < 4; ++tries, ++salt) {
    const Case other = grown(seen, salt);
    if (!is_question_for(method, other) || !fits(other, method)) continue;
    const Answer one = method.ask(seen, {}), two = method.ask(other, {});
    const bool ordered = one.outcome == Outcome::miss ||
                         (claims_contact(one) && claims_contact(two) && two.toi_lower <= one.toi_upper) ||
                         agree_within_rows(method, seen, one, two);
    LawResult result = ordered
                           ? holds()
                           : arbitrate(method, {{"the original", seen, one}, {"the superset", other, two}},
                                       "a superset is hit later");
    result.labels.push_back(label_of(one.outcome));
    return result;
  }
  return not_applicable("no superset in this scalar");
}

LawResult ray_is_point_cast(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return kOutside;
  const std::optional<Case> ray = ray_against_cso(seen);
  if (!ray || !fits(*ray, method)) return not_applicable("no exact hull of differences");
  const Answer one = method.ask(seen, {}), two = method.ask(*ray, {});
  LawResult result = agree_within_rows(method, seen, one, two)
                         ? holds()
                         : arbitrate(method, {{"the cast", seen, one}, {"the ray", *ray, two}},
                                     "the ray against the CSO answers otherwise");
  result.labels.push_back(label_of(one.outcome));
  return result;
}

LawResult splitting(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return kOutside;
  const std::optional<Split> parts = split(seen, hash_of(seen));
  if (!parts || !fits(parts->before, method) || !fits(parts->after, method))
    return not_applicable("no exact restart");
  const Answer whole = method.ask(seen, {}), before = method.ask(parts->before, {});
  // A difference for curved shapes does not count as a fault: mpr/float finds disks that are flatter than its
  // roundings early by a twentieth of the scale.
  const char* const kDiffers = "splitting the step changes the answer";
  LawResult result = holds();
  if (before.outcome != Outcome::miss) {
    // Contact in the first part is the contact of the whole.
    if (!agree_within_rows(method, seen, whole, before)) {
      if (const auto open = without_exact_truth(seen)) return *open;
      result = arbitrate(method, {{"the whole", seen, whole}, {"the first part", parts->before, before}},
                         kDiffers);
    }
    result.labels.push_back("contact before");
  } else {
    const Answer after = method.ask(parts->after, {});
    Answer joined = after;
    if (claims_contact(after)) {
      joined.outcome = Outcome::hit;
      joined.toi_lower += parts->at;
      joined.toi_upper += parts->at;
    }
    if (!agree_within_rows(method, seen, whole, joined)) {
      if (const auto open = without_exact_truth(seen)) return *open;
      result = arbitrate(method,
                         {{"the whole", seen, whole},
                          {"the first part", parts->before, before},
                          {"the second part", parts->after, after}},
                         kDiffers);
    }
    result.labels.push_back("contact after or none");
  }
  result.labels.push_back(label_of(whole.outcome));
  return result;
}

LawResult methods_meet(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return kOutside;
  const Answer one = method.ask(seen, {});
  LawResult result = holds();
  for (const Method& other : engine::methods(engine::Kind::linear)) {
    if (other.scalar != method.scalar || other.name == method.name || !is_question_for(other, seen)) continue;
    const Answer two = other.ask(seen, {});
    if (agree_within_rows(method.tier == "standard" ? method : other, seen, one, two)) continue;
    // Each within its own guarantee. A difference for curved shapes does not count as a fault: where the edge
    // of a plate grazes a cylinder, mpr/double is 372 u scale early, beyond its guarantee (bracket_holds_toi
    // holds it to it).
    if (const auto open = without_exact_truth(seen)) return *open;
    for (const auto& [judged, answer] : {std::pair(&method, &one), std::pair(&other, &two)}) {
      const std::string fault = any_fault(*judged, seen, *answer);
      if (!fault.empty()) {
        return broken(fmt::format("{} and {} do not meet: {}; at fault is {}: {}", method.full_name(),
                                  other.full_name(), pair_of(one, two), judged->full_name(), fault));
      }
    }
    result.labels.push_back("arbitrated");
  }
  result.labels.push_back(label_of(one.outcome));
  return result;
}

LawResult requesting(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return kOutside;
  const Answer least = method.ask(seen, {.request = Request::verdict});
  const Answer all = method.ask(seen, {.request = Request::everything});
  if (least.outcome != all.outcome || least.toi_lower != all.toi_lower || least.toi_upper != all.toi_upper) {
    return broken("asking for more changes the verdict: " + pair_of(least, all));
  }
  // If no proof is requested, tier certified first decides near ties in exact arithmetic: another search,
  // another cost.
  if (!method.is_certified() && (least.counters.supports > all.counters.supports ||
                                 least.counters.iterations > all.counters.iterations)) {
    return broken("asking for less costs more: " + pair_of(least, all));
  }
  if (!least.normal.isZero(0) || !least.point_a.isZero(0) || !least.point_b.isZero(0) || least.proof) {
    return broken("computed unasked: " + describe(least));
  }
  return holds({label_of(least.outcome)});
}

}  // namespace

std::vector<Law> linear_metamorphic_laws() {
  return {
      {"swapping", "Swapping A and B changes no contact and puts the normal in the negated cone.",
       Needs::metamorphic, &swapping},
      {"scaling", "Multiplying every length by a power of two changes no time, no normal and no iteration.",
       Needs::metamorphic, &scaling},
      {"translating", "Translating both bodies by an exact amount changes no contact.", Needs::metamorphic,
       &translating},
      {"superset", "A superset of a body is never hit later.", Needs::metamorphic, &superset},
      {"ray_is_point_cast", "A cast is the ray against the CSO, which is the cast of a point.",
       Needs::metamorphic, &ray_is_point_cast},
      {"splitting",
       "Casting over [0, T] is casting over [0, s] and then, from where the bodies are, over [s, T].",
       Needs::metamorphic, &splitting},
      {"methods_meet", "The brackets of the methods of one scalar meet, each within its guarantee.",
       Needs::metamorphic, &methods_meet},
      {"requesting", "Asking for less changes no verdict, costs no more and computes nothing unasked.",
       Needs::metamorphic, &requesting},
  };
}

}  // namespace graze::law
