// Laws of the line and of swept overlap. A cast finds the beginning of {t : t v in C}, and these queries ask about the
// whole set.
//
// Times of two right answers may be far apart at a graze, so if two differ the exact oracle decides which is at fault.
// If it does not take the bodies, neither counts as a fault.
#include <fmt/format.h>

#include <cmath>

#include "engines/method.hpp"
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

LawResult labelled(LawResult result, const Answer& answer) {
  result.labels.push_back(label_of(answer.outcome));
  return result;
}

Interval negated(const Interval& t) { return {-t.upper, -t.lower}; }

// The method's answer with the bodies' own motion, or without one, or for another query or other numbers.
Answer ask(const Method& method, const Question& question) { return method.answer(question.seen); }

Case as_cast(Case seen) {
  seen.query = Query::cast;
  return seen;
}

// The cast of the same tier and scalar, by portals as the line is.
const engine::Method* cast_for(const Method& method) {
  return engine::find_method(engine::Kind::linear, (method.is_exact() ? "exact/" : "mpr/") + method.scalar);
}

// The contradiction between the cast and the line, or empty.
std::string against_cast(const Case& seen, const Answer& line, const engine::Answer& cast, double u) {
  if (!claims_contact(cast)) {
    const bool inside = line.outcome == Outcome::hit && line.t_in && line.t_out &&
                        line.t_in->upper <= seen.t_max && line.t_out->lower >= 0;
    return inside ? "the cast misses what the line meets" : "";
  }
  if (line.outcome != Outcome::hit || !line.t_in || !line.t_out) return "the line misses what the cast meets";
  if (cast.outcome == Outcome::hit) {
    return same_time(*line.t_in, {cast.toi_lower, cast.toi_upper}, u) ? ""
                                                                      : "the line enters at another time";
  }
  const bool at_start = line.t_in->lower <= 0 && line.t_out->upper >= 0;
  return at_start ? "" : "the line is not in contact at the start";
}

LawResult line_holds_cast(const Case& problem, const Method& method) {
  if (method.query != Query::line) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer line = ask(method, *question);
  const engine::Answer cast = cast_for(method)->ask(as_cast(question->seen), {});
  if (line.outcome == Outcome::not_converged || cast.outcome == Outcome::not_converged)
    return holds({label_of(line.outcome)});
  const std::string differs = against_cast(question->seen, line, cast, question->u);
  if (differs.empty()) return holds({label_of(line.outcome)});
  return labelled(
      arbitrate({{"the line", method, question->seen, line}}, differs + "; the cast: " + describe(cast)),
      line);
}

LawResult line_reversed(const Case& problem, const Method& method) {
  if (method.query != Query::line) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  Case back = question->seen;
  for (Body<double>* body : {&back.a, &back.b}) body->displacement = -body->displacement;
  const Answer one = ask(method, *question), two = method.answer(back);
  Answer turned = two;
  if (two.t_in && two.t_out) {
    turned.t_in = negated(*two.t_out);
    turned.t_out = negated(*two.t_in);
  }
  if (same_line(one, turned, question->u)) return holds({label_of(one.outcome)});
  return labelled(arbitrate({{"forwards", method, question->seen, one}, {"backwards", method, back, two}},
                            "backwards the line is not the same interval, negated"),
                  one);
}

LawResult line_grows(const Case& problem, const Method& method) {
  if (method.query != Query::line) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  for (std::uint64_t salt = hash_of(question->seen), tries = 0; tries < 4; ++tries, ++salt) {
    const auto more = requestioned(grown(question->seen, salt), method);
    if (!more) continue;
    const Answer one = ask(method, *question), two = ask(method, *more);
    const bool inside = one.outcome != Outcome::hit ||
                        (two.outcome == Outcome::hit && two.t_in && one.t_in &&
                         two.t_in->lower <= one.t_in->upper && two.t_out->upper >= one.t_out->lower);
    if (inside) return holds({label_of(one.outcome)});
    return labelled(
        arbitrate({{"the original", method, question->seen, one}, {"the superset", method, more->seen, two}},
                  "a superset is met for a shorter time"),
        one);
  }
  return not_applicable("no superset in this scalar");
}

LawResult swept_overlap_is_cast(const Case& problem, const Method& method) {
  if (method.query != Query::swept_overlap) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer swept = ask(method, *question);
  const Case moving = as_cast(question->seen);
  LawResult result = holds({label_of(swept.outcome)});
  if (swept.outcome == Outcome::not_converged) return result;
  for (const engine::Method& caster : engine::methods(engine::Kind::linear)) {
    if (caster.scalar != method.scalar || !is_question_for(caster, moving)) continue;
    const engine::Answer cast = caster.ask(moving, {});
    if (cast.outcome == Outcome::not_converged || claims_contact(cast) == in_contact(swept)) continue;
    LawResult judged =
        arbitrate({{"the swept overlap", method, question->seen, swept}},
                  fmt::format("the cast {} says otherwise: {}", caster.full_name(), describe(cast)));
    if (judged.holding == Holding::broken) return judged;
    result.labels.push_back("arbitrated");
  }
  return result;
}

LawResult swept_overlap_grows(const Case& problem, const Method& method) {
  if (method.query != Query::swept_overlap) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer one = ask(method, *question);
  const double t_max = question->seen.t_max;
  const auto bodies = requestioned(grown(question->seen, hash_of(question->seen)), method);
  std::vector<std::pair<std::string_view, Case>> larger;
  for (const double factor : {2.0, 1024.0, kInfinity<double>}) {
    if (!(t_max > 0)) continue;
    larger.emplace_back("a longer path", question->seen);
    larger.back().second.t_max = factor * t_max;
  }
  larger.emplace_back("a target distance", question->seen);
  larger.back().second.target_distance = std::max(1.0, 2 * question->seen.target_distance);
  if (bodies) larger.emplace_back("a superset", bodies->seen);
  for (const auto& [what, edited] : larger) {
    const auto more = requestioned(edited, method);
    if (!more) continue;
    const Answer two = ask(method, *more);
    if (!in_contact(one) || in_contact(two)) continue;
    LawResult judged =
        arbitrate({{"the original", method, question->seen, one}, {"the larger", method, more->seen, two}},
                  fmt::format("{} loses the contact", what));
    if (judged.holding == Holding::broken) return judged;
  }
  return holds({label_of(one.outcome)});
}

LawResult swept_overlap_of_volume(const Case& problem, const Method& method) {
  if (method.query != Query::swept_overlap) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Case& seen = question->seen;
  const auto v = exact_sum(seen.b.displacement, Vec3<double>(-seen.a.displacement));
  if (!v || !std::isfinite(seen.t_max)) return not_applicable("no exact volume");
  Vec3<double> sweep;
  for (int i = 0; i < 3; ++i) {
    const auto step = exact_product(seen.t_max, (*v)[i]);
    if (!step) return not_applicable("no exact volume");
    sweep[i] = *step;
  }
  Case still = seen;
  still.query = Query::overlap;
  still.a.displacement.setZero();
  still.b.displacement.setZero();
  still.t_max = 1;
  still.target_distance = 0;
  still.b.orientation = {};
  still.b.shape = sum<double>(posed<double>(seen.b.shape, Vec3<double>::Zero(), seen.b.orientation),
                              Segment<double>{Vec3<double>::Zero(), sweep});
  if (seen.target_distance > 0)
    still.b.shape = rounded<double>(std::move(still.b.shape), seen.target_distance);
  LawResult result = not_applicable("no exact volume");
  const Answer one = ask(method, *question);
  for (const Method& other : engine::methods(engine::Kind::query)) {
    if (other.query != Query::overlap || other.scalar != method.scalar || other.tier != method.tier) continue;
    const auto volume = requestioned(still, other);
    if (!volume) continue;
    const Answer two = other.answer(volume->seen);
    result = holds({label_of(one.outcome)});
    const bool says = one.outcome != Outcome::not_converged && two.outcome != Outcome::not_converged;
    if (!says || in_contact(one) == in_contact(two)) continue;
    LawResult judged = arbitrate({{"the sweep", method, seen, one}, {"the volume", other, volume->seen, two}},
                                 "the volume that B sweeps overlaps A otherwise");
    if (judged.holding == Holding::broken) return judged;
  }
  return result;
}

LawResult motion_at_rest(const Case& problem, const Method& method) {
  if (method.query != Query::line && method.query != Query::swept_overlap) return other_query();
  // The bodies as they stand at one of the times at which an overlap is queried.
  const auto rest = question_of(problem, default_method(Query::overlap, method.scalar));
  if (!rest) return no_question();
  Case still = rest->seen;
  still.query = method.query;
  const auto question = requestioned(still, method);
  if (!question) return no_question();
  // Nothing moves, both move as one, or anything moves for no time at all.
  std::vector<Case> same{question->seen, question->seen};
  for (Body<double>* body : {&same[1].a, &same[1].b}) body->displacement = Vec3<double>(1, -2, 4);
  if (method.query == Query::swept_overlap) {
    same.push_back(question->seen);
    same.back().t_max = 0;
    same.back().b.displacement = Vec3<double>(-8, 1, 2);
  }
  Case overlapping = question->seen;
  overlapping.query = Query::overlap;
  LawResult result = no_question();
  for (const Method& other : engine::methods(engine::Kind::query)) {
    if (other.query != Query::overlap || other.scalar != method.scalar || other.tier != method.tier) continue;
    const Answer overlap = other.answer(overlapping);
    result = holds({label_of(overlap.outcome)});
    if (overlap.outcome == Outcome::not_converged) continue;
    for (const Case& one : same) {
      const Answer answer = method.answer(one);
      if (method.query == Query::line && answer.outcome == Outcome::hit &&
          !(answer.t_in && answer.t_out && answer.t_in->upper == -kInfinity<double> &&
            answer.t_out->lower == kInfinity<double>)) {
        return broken("a contact at rest does not last: " + describe(answer));
      }
      if (answer.outcome == Outcome::not_converged || in_contact(answer) == in_contact(overlap)) continue;
      LawResult judged =
          arbitrate({{"the motion", method, one, answer}, {"the overlap", other, overlapping, overlap}},
                    "at rest the answer is not the overlap's");
      if (judged.holding == Holding::broken) return judged;
    }
  }
  return result;
}

LawResult target_is_rounding(const Case& problem, const Method& method) {
  if (method.query != Query::line && method.query != Query::swept_overlap) return other_query();
  if (method.is_exact()) return not_applicable("the oracle decides tier exact to the last bit");
  auto question = question_of(problem, method);
  if (!question) return no_question();
  Case target = question->seen, round = question->seen;
  if (target.target_distance == 0) {
    if (!(question->limit > 0)) return not_applicable("two points in one place have no scale to choose by");
    target.target_distance = std::scalbn(1.0, std::ilogb(question->limit / question->u) - 8);
  }
  round.target_distance = 0;
  Body<double>& body = mix(hash_of(target)) & 1 ? round.a : round.b;
  body.shape = rounded<double>(std::move(body.shape), target.target_distance);
  const auto by_target = requestioned(target, method), by_radius = requestioned(round, method);
  if (!by_target || !by_radius) return not_applicable("no such distance in this scalar");
  const Answer one = ask(method, *by_target), two = ask(method, *by_radius);
  if (same_line(one, two, question->u)) return holds({label_of(one.outcome)});
  if (method.query == Query::swept_overlap && in_contact(one) == in_contact(two))
    return holds({label_of(one.outcome)});
  return labelled(arbitrate({{"by the target distance", method, by_target->seen, one},
                             {"by the radius", method, by_radius->seen, two}},
                            "a body rounded by the target distance is met otherwise"),
                  one);
}

}  // namespace

std::vector<Law> query_motion_laws() {
  return {
      {"line_holds_cast",
       "The line's interval begins where the cast hits, and holds 0 where it starts in contact.",
       Needs::metamorphic, &line_holds_cast},
      {"line_reversed", "Backwards the line is the same interval, negated.", Needs::metamorphic,
       &line_reversed},
      {"line_grows", "The line meets a superset for no shorter a time.", Needs::metamorphic, &line_grows},
      {"swept_overlap_is_cast", "Swept overlap says whether the cast finds contact, whatever the method.",
       Needs::metamorphic, &swept_overlap_is_cast},
      {"swept_overlap_grows",
       "A longer path, a target distance and a superset lose no contact of a swept overlap.",
       Needs::metamorphic, &swept_overlap_grows},
      {"swept_overlap_of_volume", "Swept overlap is the overlap of A with the volume that B sweeps.",
       Needs::metamorphic, &swept_overlap_of_volume},
      {"motion_at_rest",
       "At rest, moved as one, or on no time at all, swept overlap and line say what the overlap says.",
       Needs::metamorphic, &motion_at_rest},
      {"target_is_rounding", "A target distance is a rounding of either body.", Needs::metamorphic,
       &target_is_rounding},
  };
}

}  // namespace graze::law
