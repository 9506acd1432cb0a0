// Laws that hold for every query alike: edits without effect, requests, and input that must be refused.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "properties/edit/case.hpp"
#include "properties/edit/same_body.hpp"
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

bool is_about_motion(Query query) { return query == Query::line || query == Query::swept_overlap; }

std::string against(const Answer& one, const Answer& two) {
  return describe(one) + "; against " + describe(two);
}

// Two answers to one question, `two` in the terms of `one`. Gaps differ by both limits at most. If the rest differs by
// more than rounding, the oracle decides.
LawResult same_answers(const Method& method, const Question& first, const Answer& one, const Question& second,
                       const Answer& asked, const Answer& two, std::string_view edit) {
  const double allowed = first.limit + second.limit;
  if (!is_about_motion(method.query)) {
    const bool gap = method.query != Query::penetration_along;
    if (const double off = gap ? apart(gap_of(one), gap_of(two)) : 0; off > allowed) {
      return broken(fmt::format("{} changes the answer by {}, the guarantees allow {}: {}", edit, off,
                                allowed, against(one, two)));
    }
    const bool says = one.outcome != Outcome::not_converged && two.outcome != Outcome::not_converged;
    const bool far = one.depth && two.depth && apart(*one.depth, *two.depth) > allowed;
    if (!says || (one.outcome == two.outcome && !far)) return holds({label_of(one.outcome)});
  } else if (method.query == Query::swept_overlap ? one.outcome == two.outcome
                                                  : same_line(one, two, first.u)) {
    return holds({label_of(one.outcome)});
  }
  LawResult result =
      arbitrate({{"the original", method, first.seen, one}, {"the edited", method, second.seen, asked}},
                fmt::format("{} changes the answer", edit));
  result.labels.push_back(label_of(one.outcome));
  return result;
}

LawResult query_swapping(const Case& problem, const Method& method) {
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  Case other = swapped(question->seen);
  other.direction = -other.direction;
  const auto second = requestioned(std::move(other), method);
  if (!second) return no_question();
  const Answer one = method.answer(question->seen), two = method.answer(second->seen);
  LawResult result = same_answers(method, *question, one, *second, two, two, "swapping");
  if (result.holding != Holding::holds || one.outcome != two.outcome || is_about_motion(method.query))
    return result;
  if (method.query == Query::penetration_along || !one.has_normal() || !two.has_normal() || one.stalled ||
      two.stalled)
    return result;
  // The other's normal, negated, separates the original or ends it as deep as its own does.
  const Reach h = reach(question->seen, Vec3<double>(-two.normal));
  const Interval gap = gap_of(one);
  const double off = h.value + (std::isfinite(gap.lower) ? gap.lower : 0),
               allowed = 2 * question->limit + 2 * second->limit + h.error +
                         (method.is_exact() ? 32 * question->u * h.error / kUnitRoundoff<double> : 0);
  if (off > allowed) {
    return broken(fmt::format("the normal of the swapped, negated, is {} off the gap, {} allowed: {}", off,
                              allowed, against(one, two)));
  }
  return result;
}

LawResult query_translating(const Case& problem, const Method& method) {
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  for (std::uint64_t salt = hash_of(question->seen), tries = 0; tries < 4; ++tries, ++salt) {
    const std::optional<Case> other = translated(question->seen, salt);
    const auto second = other ? requestioned(*other, method) : std::nullopt;
    if (!second) continue;
    const Answer one = method.answer(question->seen), two = method.answer(second->seen);
    return same_answers(method, *question, one, *second, two, two, "translating both");
  }
  return not_applicable("no exact translation");
}

std::optional<Interval> scaled_by(const std::optional<Interval>& x, int k) {
  if (!x) return x;
  return Interval{std::scalbn(x->lower, k), std::scalbn(x->upper, k)};
}
Vec3<double> scaled_by(const Vec3<double>& x, int k) {
  return {std::scalbn(x[0], k), std::scalbn(x[1], k), std::scalbn(x[2], k)};
}
bool same(const std::optional<Interval>& one, const std::optional<Interval>& two) {
  return one.has_value() == two.has_value() &&
         (!one || (one->lower == two->lower && one->upper == two->upper));
}

// The fields that scaling every length by 2^k changed wrongly, or empty.
std::string changed_by_scale(const Answer& one, const Answer& two, int k) {
  if (one.outcome != two.outcome || one.stalled != two.stalled) return "outcome";
  if (!same(one.t_in, two.t_in) || !same(one.t_out, two.t_out)) return "time";
  if (!same(scaled_by(one.separation, k), two.separation)) return "distance";
  if (!same(scaled_by(one.depth, k), two.depth)) return "depth";
  if (one.normal != two.normal || one.normal_out != two.normal_out) return "normal";
  if (one.counters.iterations != two.counters.iterations || one.counters.supports != two.counters.supports)
    return "count of iterations or supports";
  if (one.has_points != two.has_points || scaled_by(one.point_a, k) != two.point_a ||
      scaled_by(one.point_b, k) != two.point_b)
    return "witness";
  return {};
}

// A length of the answer that is, or becomes, subnormal.
bool loses_bits(const Answer& answer, double least) {
  const auto small = [&](double x) { return x != 0 && std::abs(x) < least; };
  bool any = false;
  for (const std::optional<Interval>* x : {&answer.separation, &answer.depth})
    any = any || (*x && (small((*x)->lower) || small((*x)->upper)));
  for (const Vec3<double>& x : {answer.point_a, answer.point_b})
    any = any || small(x[0]) || small(x[1]) || small(x[2]);
  return any;
}

LawResult query_scaling(const Case& problem, const Method& method) {
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  constexpr std::array<int, 8> kPowers = {-1, 1, 7, -9, 24, -31, 60, -60};
  const std::uint64_t first = hash_of(question->seen);
  const double least = method.scalar == "float" ? double(std::numeric_limits<float>::min())
                                                : std::numeric_limits<double>::min();
  for (std::size_t j = 0; j < kPowers.size(); ++j) {
    const int k = kPowers[(j + first) % kPowers.size()];
    const std::optional<Case> other = scaled(question->seen, k);
    const auto second = other ? requestioned(*other, method) : std::nullopt;
    if (!second) continue;
    const Answer one = method.answer(question->seen), two = method.answer(second->seen);
    if (loses_bits(one, least * std::max(1.0, std::scalbn(1.0, -k))) || loses_bits(two, least)) continue;
    const std::string fault = changed_by_scale(one, two, k);
    if (!fault.empty())
      return broken(fmt::format("every length times 2^{} changes the {}: {}", k, fault, against(one, two)));
    return holds({label_of(one.outcome), std::abs(k) > 20 ? "far scale" : "near scale"});
  }
  return not_applicable("no power of two keeps every number in range");
}

LawResult query_requesting(const Case& problem, const Method& method) {
  if (method.query == Query::overlap || method.query == Query::swept_overlap) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer all = method.answer(question->seen);
  for (const Request request : {Request::verdict, Request::normal, Request::witnesses}) {
    const Answer less = method.ask(question->seen, {.request = request});
    if (less.outcome != all.outcome || !same(less.separation, all.separation) ||
        !same(less.depth, all.depth) || !same(less.t_in, all.t_in) || !same(less.t_out, all.t_out) ||
        less.stalled != all.stalled) {
      return broken("asking for less changes the answer: " + against(less, all));
    }
    if (less.counters.supports > all.counters.supports ||
        less.counters.iterations > all.counters.iterations) {
      return broken("asking for less costs more: " + against(less, all));
    }
    // The axis of a miss comes with its verdict, but a distance has no miss.
    const bool verdict_has_axis = all.outcome == Outcome::miss && method.query != Query::distance;
    const bool normal = asks_for(request, Request::normal), points = asks_for(request, Request::witnesses);
    if ((!normal && !verdict_has_axis && (less.has_normal() || !less.normal_out.isZero(0))) ||
        (!points && less.has_points)) {
      return broken("computed unasked: " + describe(less));
    }
    if ((normal && (less.normal != all.normal || less.normal_out != all.normal_out)) ||
        (points &&
         (less.has_points != all.has_points || less.point_a != all.point_a || less.point_b != all.point_b))) {
      return broken("asked for alone it is another: " + against(less, all));
    }
  }
  return holds({label_of(all.outcome)});
}

// The same question twice, with another between, and with the hulls' adjacency added or removed.
LawResult query_asking_again(const Case& problem, const Method& method) {
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer first = method.answer(question->seen);
  (void)method.answer(swapped(question->seen));
  const Answer second = method.answer(question->seen);
  if (const std::string fault = changed_by_scale(first, second, 0); !fault.empty())
    return broken(fmt::format("asked again it has another {}: {}", fault, against(second, first)));
  LawResult result = holds({label_of(first.outcome)});
  const auto given = with_other_hulls(question->seen);
  if (!given) return result;
  const Answer third = method.answer(*given);
  if (const std::string fault = changed_by_scale(first, third, 0); !fault.empty()) {
    return broken(fmt::format("with adjacency where there was none, or without, it has another {}: {}", fault,
                              against(third, first)));
  }
  result.labels.push_back("adjacency");
  return result;
}

bool is_bracket(const std::optional<Interval>& x) { return x && x->lower <= x->upper; }
bool is_length(const std::optional<Interval>& x) {
  return is_bracket(x) && x->lower >= 0 && std::isfinite(x->upper);
}

std::string inconsistent(const Question& question, const Method& method, const Answer& answer) {
  const bool moving = is_about_motion(method.query);
  const Outcome contact = moving ? Outcome::hit : Outcome::initially_overlapping;
  if (answer.outcome == Outcome::invalid_input) return "a valid question was refused";
  if (answer.outcome == Outcome::not_converged) return "";
  if (answer.outcome != contact && answer.outcome != Outcome::miss) return "no outcome of this query";
  const bool meets = answer.outcome == contact;
  if (method.query == Query::distance) {
    if (!is_length(answer.separation)) return "no bracket of a distance";
    if (meets ? answer.separation->upper != 0 : !(answer.separation->lower > 0))
      return "outcome and distance say two things";
  }
  const bool deep = meets && (method.query == Query::penetration || method.query == Query::penetration_along);
  if (deep && !is_length(answer.depth)) return "no bracket of a depth";
  if (!deep && answer.depth) return "a depth without a penetration";
  if (method.query == Query::line && meets) {
    if (!is_bracket(answer.t_in) || !is_bracket(answer.t_out) || !(answer.t_in->lower <= answer.t_out->upper))
      return "the line's ends are no interval";
  }
  for (const Vec3<double>& n : {answer.normal, answer.normal_out}) {
    if (!n.isZero(0) && !(std::abs(n.norm() - 1) <= 8 * question.u))
      return "a normal of a length other than 1";
  }
  for (const Vec3<double>& x : {answer.point_a, answer.point_b}) {
    if (!x.allFinite()) return "a witness that is not a point";
  }
  // A bracket that is not marked as wide is no wider than its guarantee.
  if (answer.stalled || method.query == Query::penetration_along) return "";
  const auto is_wide = [&](const Interval& x) {
    // Two numbers next to each other are as narrow as it gets.
    const double next = method.in_float() ? std::nextafter(float(x.lower), kInfinity<float>)
                                          : std::nextafter(x.lower, kInfinity<double>);
    return !(x.upper <= next || x.upper - x.lower <= 2 * question.limit);
  };
  for (const std::optional<Interval>* x : {&answer.separation, &answer.depth}) {
    if (*x && is_wide(**x)) return "a wide bracket that is not marked as not converged";
  }
  return "";
}

LawResult query_answer_is_consistent(const Case& problem, const Method& method) {
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer answer = method.answer(question->seen);
  const std::string fault = inconsistent(*question, method, answer);
  if (!fault.empty()) return broken(fault + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

// Calls `refused(case, what)` for edits that make a valid question a bad one.
template <class F>
void spoil(const Case& seen, const F& refused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = kInfinity<double>,
                   kMost = std::numeric_limits<double>::max();
  const bool moving = is_about_motion(seen.query);
  const std::size_t count = scalars(seen).size();
  for (std::size_t i = 0; i < count; ++i) {
    for (const double poison : {kNan, kInf, -kInf, kMost}) {
      std::size_t at = 0;
      bool bad = true;
      const Case poisoned = map_scalars(seen, [&](Slot slot, double x) {
        if (at++ != i) return x;
        // A line has no horizon. A query at rest has neither a horizon nor a target distance. A horizon may
        // be infinite.
        if (slot == Slot::horizon && (poison > 0 || seen.query != Query::swept_overlap)) bad = false;
        if (slot == Slot::target && !moving) bad = false;
        return poison;
      });
      if (bad) refused(poisoned, fmt::format("{} as scalar number {}", poison, i));
    }
  }
  for (const bool first : {true, false}) {
    Case bad = seen;
    Body<double>& body = first ? bad.a : bad.b;
    body.orientation = {0, 0, 0, 0};
    refused(bad, "a zero quaternion");
    body = first ? seen.a : seen.b;
    for (Shape<double>& shape : std::vector<Shape<double>>{
             Hull<double>(), Sphere<double>{-1}, Box<double>{{1, -0x1p-30, 1}}, Cone<double>{1, -1},
             rounded<double>(Point<double>{}, -1), Sum<double>{}}) {
      body.shape = std::move(shape);
      refused(bad, "a malformed shape");
    }
  }
  Case bad = seen;
  bad.target_distance = -1;
  if (moving) refused(bad, "a negative target distance");
  bad = seen;
  bad.t_max = -1;
  if (seen.query == Query::swept_overlap) refused(bad, "a negative t_max");
  if (seen.query != Query::penetration_along) return;
  bad = seen;
  for (const Vec3<double>& d : {Vec3<double>(0, 0, 0), Vec3<double>(1, kNan, 1), Vec3<double>(kInf, 0, 0),
                                Vec3<double>(0, 0, kMost)}) {
    bad.direction = d;
    refused(bad, "a direction that is not valid");
  }
}

LawResult query_bad_input_is_refused(const Case& problem, const Method& method) {
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  std::string fault;
  spoil(question->seen, [&](const Case& bad, const std::string& what) {
    const Answer answer = method.answer(bad);
    const bool silent = !answer.separation && !answer.depth && !answer.t_in && !answer.has_normal() &&
                        answer.counters.iterations == 0 && answer.counters.supports == 0;
    if (answer.outcome == Outcome::invalid_input && answer.invalid != Invalid::none && silent) return;
    if (fault.empty()) fault = fmt::format("{} is let in: {}", what, describe(answer));
  });
  if (!fault.empty()) return broken(fault);
  return holds({label_of(method.answer(question->seen).outcome)});
}

}  // namespace

std::vector<Law> query_any_laws() {
  return {
      {"query_swapping",
       "Swapping A and B changes no distance, depth or time of a query, and negates its normal.",
       Needs::metamorphic, &query_swapping},
      {"query_scaling",
       "Multiplying every length by a power of two scales distances, depths and points, and changes no time, "
       "normal or iteration.",
       Needs::metamorphic, &query_scaling},
      {"query_translating", "Translating both bodies by an exact amount changes the answer to no query.",
       Needs::metamorphic, &query_translating},
      {"query_requesting",
       "A query that requests less has the same answer, and computes nothing that was not requested.",
       Needs::metamorphic, &query_requesting},
      {"query_asking_again",
       "The same query gets the same bits, whatever was asked between, and with adjacency of its hulls or "
       "without.",
       Needs::metamorphic, &query_asking_again},
      {"query_answer_is_consistent",
       "Outcome and brackets of a query agree. Normals are unit vectors, points are finite, and a wide "
       "bracket is marked as not converged.",
       Needs::metamorphic, &query_answer_is_consistent},
      {"query_bad_input_is_refused",
       "Bad input is refused at the door of every query, a direction of no length among it.",
       Needs::metamorphic, &query_bad_input_is_refused},
  };
}

}  // namespace graze::law
