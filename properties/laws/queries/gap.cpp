// Laws of the gap between two bodies at rest: the distance, or minus the depth.
//
// One function of C, apart and in contact: gap = max over unit n of -h(n), h(n) = max over C of n.c. So it
// does not rise as C grows, falls by r as C is rounded by r, and rises by s as B is moved by s along the
// normal of an answer. Right answers have it within their limits (asked.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/queries/asked.hpp"
#include "properties/laws/queries/question.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Interval;
using engine::Method;

namespace {

bool asks_for_gap(const Method& method) {
  return method.query == Query::overlap || method.query == Query::distance ||
         method.query == Query::penetration;
}

bool is_finite(const Interval& x) { return std::isfinite(x.lower) && std::isfinite(x.upper); }

Case with_query(Case seen, Query query) {
  seen.query = query;
  return seen;
}

// The known facts about the gap.
struct Gap {
  Interval bracket;
  double limit = 0;
  Answer answer;  // the method's own
  std::string text;
};

// By the method. If it knows only one side, by whichever of distance and penetration knows both.
Gap gap_by(const Method& method, const Case& seen) {
  Gap gap;
  gap.answer = method.answer(seen);
  gap.bracket = gap_of(gap.answer);
  gap.limit = limit_of(method, seen);
  gap.text = describe(gap.answer);
  for (const Query query : {Query::distance, Query::penetration}) {
    if (is_finite(gap.bracket) || query == method.query) continue;
    const Method& other = default_method(query, method.scalar);
    const Answer answer = other.answer(with_query(seen, query));
    if (!is_finite(gap_of(answer)) || answer.stalled) continue;
    gap.bracket = gap_of(answer);
    gap.limit = std::max(gap.limit, limit_of(other, seen));
    gap.text += fmt::format("; {}: {}", other.full_name(), describe(answer));
  }
  return gap;
}

std::string both_texts(const Gap& one, const Gap& two) { return one.text + "; against " + two.text; }

LawResult held(const Answer& answer) { return holds({label_of(answer.outcome)}); }

LawResult gaps_agree(const Case& problem, const Method& method) {
  if (!asks_for_gap(method)) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer one = method.answer(question->seen);
  LawResult result = held(one);
  for (const Method& other : engine::methods(engine::Kind::query)) {
    if (&other == &method || other.scalar != method.scalar || !asks_for_gap(other)) continue;
    const auto same = requestioned(with_query(question->seen, other.query), other);
    if (!same) continue;
    const Answer two = other.answer(same->seen);
    const double off = apart(gap_of(one), gap_of(two));
    if (off > question->limit + same->limit) {
      return broken(fmt::format("{} and {} are {} apart, the guarantees allow {}: {}; against {}",
                                method.full_name(), other.full_name(), off, question->limit + same->limit,
                                describe(one), describe(two)));
    }
    // One answers contact and the other none, and neither states a length.
    const bool says = one.outcome != Outcome::not_converged && two.outcome != Outcome::not_converged;
    if (!says || in_contact(one) == in_contact(two)) continue;
    LawResult judged = arbitrate(
        {{method.full_name(), method, question->seen, one}, {other.full_name(), other, same->seen, two}},
        "contact to one and none to the other");
    if (judged.holding == Holding::broken) return judged;
    result.labels.push_back("arbitrated");
  }
  return result;
}

LawResult growing_closes_gaps(const Case& problem, const Method& method) {
  if (!asks_for_gap(method)) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  for (std::uint64_t salt = hash_of(question->seen), tries = 0; tries < 4; ++tries, ++salt) {
    const auto more = requestioned(grown(question->seen, salt), method);
    if (!more) continue;
    const Gap one = gap_by(method, question->seen), two = gap_by(method, more->seen);
    const double wider = two.bracket.lower - one.bracket.upper;
    if (wider > one.limit + two.limit) {
      return broken(
          fmt::format("a superset is {} farther away, or less deep: {}", wider, both_texts(one, two)));
    }
    return held(one.answer);
  }
  return not_applicable("no superset in this scalar");
}

LawResult rounding_takes_its_radius(const Case& problem, const Method& method) {
  if (!asks_for_gap(method)) return other_query();
  const auto question = question_of(problem, method);
  if (!question || question->limit == 0) return no_question();
  const Gap one = gap_by(method, question->seen);
  if (!is_finite(one.bracket)) return not_applicable("the gap is not known");
  // A power of two, which rounds nothing: about half of the gap, all of it, or more.
  const std::uint64_t salt = mix(hash_of(question->seen));
  const double size = std::abs(one.bracket.lower) + std::abs(one.bracket.upper);
  const int exponent =
      size > one.limit ? std::ilogb(size) - 2 + static_cast<int>(salt % 4) : std::ilogb(one.limit) + 40;
  const double r = std::scalbn(1.0, exponent);
  Case round = question->seen;
  Body<double>& body = salt & 4 ? round.a : round.b;
  body.shape = rounded<double>(std::move(body.shape), r);
  const auto after = requestioned(std::move(round), method);
  if (!after) return not_applicable("no such rounding in this scalar");
  const Gap two = gap_by(method, after->seen);
  const Interval expected{one.bracket.lower - r, one.bracket.upper - r};
  const double off = apart(expected, two.bracket);
  if (off > one.limit + two.limit) {
    return broken(fmt::format("rounded by {} the gap is off by {}, the guarantees allow {}: {}", decimal(r),
                              off, one.limit + two.limit, both_texts(one, two)));
  }
  return held(two.answer);
}

LawResult moving_along_the_normal(const Case& problem, const Method& method) {
  if (method.query != Query::distance && method.query != Query::penetration) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Case& seen = question->seen;
  const Gap one = gap_by(method, seen);
  if (!is_finite(gap_of(one.answer)) || one.answer.stalled || !one.answer.has_normal() ||
      !one.answer.has_points) {
    return not_applicable("no normal to move along");
  }
  const Vec3<double>&n = one.answer.normal, &a = one.answer.point_a, &b = one.answer.point_b;
  const double gap = one.bracket.upper;
  // Nearer and farther, or out of each other in part, wholly, and beyond.
  constexpr std::array<double, 4> kOfDistance = {-0.5, -0.875, 0.5, 2}, kOfDepth = {0.5, 1, 1.5, 3};
  const std::size_t pick = mix(hash_of(seen)) % 4;
  const double s = gap > 0 ? kOfDistance[pick] * gap : kOfDepth[pick] * std::abs(one.bracket.lower);
  Case moved = seen;
  moved.b.position += s * n;
  const auto after = requestioned(seen_by(method, moved), method);
  if (!after) return not_applicable("moved out of range");
  const Gap two = gap_by(method, after->seen);
  // The position rounds, below the normal numbers by more than u. So do the coordinates of the witnesses.
  const double placed = (after->seen.b.position - moved.b.position).norm(),
               rounded = 4 * question->u * (after->seen.b.position.norm() + a.norm() + b.norm()) + placed,
               allowed = 3 * one.limit + two.limit + rounded;
  // n keeps them apart by as much more. The witnesses, one of them moved, are no nearer than the bodies.
  const Interval expected{one.bracket.lower + s, (a - b - s * n).norm()};
  if (two.bracket.upper < expected.lower - allowed) {
    return broken(fmt::format("B moved by {} along the normal is nearer than {}: {}", decimal(s),
                              decimal(expected.lower), both_texts(one, two)));
  }
  if (two.bracket.lower > expected.upper + allowed) {
    return broken(fmt::format("B moved by {} along the normal is farther than {}: {}", decimal(s),
                              decimal(expected.upper), both_texts(one, two)));
  }
  return held(one.answer);
}

// The question along another direction, or nothing if the scalar cannot hold it.
std::optional<Question> along(const Case& seen, const Vec3<double>& d, const Method& method) {
  Case other = seen;
  other.query = Query::penetration_along;
  other.direction = d;
  return requestioned(std::move(other), method);
}

LawResult no_way_is_shorter(const Case& problem, const Method& method) {
  if (method.query != Query::penetration_along) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Method& least_by = default_method(Query::penetration, method.scalar);
  const Case rest = with_query(question->seen, Query::penetration);
  const Answer least = least_by.answer(rest);
  if (!least.depth || least.stalled || !least.has_normal()) {
    return holds({label_of(method.answer(question->seen).outcome), "no depth to compare with"});
  }
  const double allowed = question->limit + limit_of(least_by, rest);
  const Vec3<double>& n = least.normal;
  for (const Vec3<double>& d :
       {question->seen.direction, n, Vec3<double>(-question->seen.direction), Vec3<double>(1, 0, 0)}) {
    const auto way = along(question->seen, d, method);
    if (!way) continue;
    const Answer answer = method.answer(way->seen);
    if (!answer.depth || answer.stalled) continue;
    const std::string both = fmt::format("{}; least: {}", describe(answer), describe(least));
    if (answer.depth->upper < least.depth->lower - allowed)
      return broken(fmt::format("the way out along {} is shorter than the least: {}", decimal(d), both));
    // Beyond the plane that the least normal supports there is nothing of C.
    const double along_normal = answer.depth->lower * n.dot(d.stableNormalized());
    if (along_normal > least.depth->upper + allowed)
      return broken(fmt::format("the way out along {} ends outside of C: {}", decimal(d), both));
  }
  return holds({label_of(least.outcome)});
}

LawResult growing_lengthens_the_way(const Case& problem, const Method& method) {
  if (method.query != Query::penetration_along) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  for (std::uint64_t salt = hash_of(question->seen), tries = 0; tries < 4; ++tries, ++salt) {
    const auto more = requestioned(grown(question->seen, salt), method);
    if (!more) continue;
    const Answer one = method.answer(question->seen), two = method.answer(more->seen);
    LawResult result = held(one);
    const bool shorter = !in_contact(two) || !two.depth || (one.depth && two.depth->upper < one.depth->lower);
    if (!in_contact(one) || !shorter) return result;
    LawResult judged =
        arbitrate({{"the original", method, question->seen, one}, {"the superset", method, more->seen, two}},
                  "a superset has a shorter way out");
    judged.labels.push_back(label_of(one.outcome));
    return judged;
  }
  return not_applicable("no superset in this scalar");
}

}  // namespace

std::vector<Law> query_gap_laws() {
  return {
      {"gaps_agree",
       "Overlap, distance and penetration speak of one gap: a distance above zero is a depth of none.",
       Needs::metamorphic, &gaps_agree},
      {"growing_closes_gaps", "A superset is no farther away, and no less deep.", Needs::metamorphic,
       &growing_closes_gaps},
      {"rounding_takes_its_radius",
       "Rounding a body by r takes r from the distance, or adds it to the depth.", Needs::metamorphic,
       &rounding_takes_its_radius},
      {"moving_along_the_normal",
       "Moving B by s along the normal adds s to the gap: by the depth they touch, by less they still meet.",
       Needs::metamorphic, &moving_along_the_normal},
      {"no_way_is_shorter",
       "The penetration along a direction is no less than the least, and ends on this side of its normal's "
       "plane.",
       Needs::metamorphic, &no_way_is_shorter},
      {"growing_lengthens_the_way", "The way out of a superset along a direction is no shorter.",
       Needs::metamorphic, &growing_lengthens_the_way},
  };
}

}  // namespace graze::law
