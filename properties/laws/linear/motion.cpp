// Laws of the motion: the same bodies on a longer, slower, shared, reversed or farther path, or with a target distance
// between them. The true answer is known from the original's. If two answers differ, the oracle arbitrates (judge.hpp).
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engines/method.hpp"
#include "properties/edit/motion.hpp"
#include "properties/judge/own_frames.hpp"
#include "properties/laws/ask_twice.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;

namespace {

// The difference of two answers to one time that needs no arbitration, as in agree() of judge/linear_faults.cpp.
double slack(const Method& method) { return 16 * method.unit_roundoff; }

Case reporting(Case problem) {
  problem.start_policy = StartPolicy::report;
  return problem;
}

Case with_horizon(Case problem, double t_max) {
  problem.t_max = t_max;
  problem.expect.reset();
  return problem;
}

LawResult moving_the_horizon(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  const Answer one = method.ask(seen, {});
  LawResult result = holds({label_of(one.outcome)});

  const double horizons[] = {2, 0x1p20, kInfinity<double>};
  const double factor = horizons[hash_of(seen) % std::size(horizons)];
  if (const Case later = with_horizon(seen, seen.t_max > 0 ? seen.t_max * factor : factor);
      !std::isinf(seen.t_max) && is_sound_edit(later, method)) {
    const Answer two = method.ask(later, {});
    // A contact stays. A miss may become one beyond the old end.
    const bool beyond = one.outcome == Outcome::miss && two.outcome == Outcome::hit &&
                        two.toi_upper * (1 + slack(method)) >= seen.t_max;
    if (!agree_within_rows(method, seen, one, two) && !beyond) {
      LawResult judged = arbitrate(method, {{"the shorter", seen, one}, {"the longer", later, two}},
                                   "a longer horizon changes the answer");
      if (judged.holding != Holding::holds) return judged;
      result.labels.insert(result.labels.end(), judged.labels.begin(), judged.labels.end());
    }
    if (beyond) result.labels.push_back("contact beyond");
  }

  // Half of the path that is proved free of contact, and all of it but a little.
  if (one.outcome != Outcome::hit || !(one.toi_lower > 0)) return result;
  for (const double part : {0.5, 1 - 0x1p-18}) {
    const Case sooner = method.seen(with_horizon(seen, part * one.toi_lower));
    if (!is_sound_edit(sooner, method) || !(sooner.t_max < one.toi_lower)) continue;
    const Answer two = method.ask(sooner, {});
    if (two.outcome == Outcome::miss) {
      result.labels.push_back("ends before");
      continue;
    }
    LawResult judged = arbitrate(method, {{"the longer", seen, one}, {"the shorter", sooner, two}},
                                 "a path that ends before toi_lower is no miss");
    if (judged.holding != Holding::holds) return judged;
    result.labels.insert(result.labels.end(), judged.labels.begin(), judged.labels.end());
  }
  return result;
}

LawResult keeping_distance(const Case& problem, const Method& method) {
  // Under the policy pass_over a start is judged by C without the target distance.
  const Case seen = reporting(method.seen(problem));
  if (!is_question_for(method, seen)) return outside();
  const std::uint64_t pick = mix(hash_of(seen) ^ 0x64697374u);
  double m = seen.target_distance;
  if (m == 0) {
    const double size =
        std::max(velocity(seen).stableNorm(), (seen.b.position - seen.a.position).stableNorm());
    const double parts[] = {0x1p-10, 0.25, 1, 16};
    m = size > 0 ? std::scalbn(parts[pick % 4], std::ilogb(size)) : 1;
  }
  Case near = seen, far = seen, round = seen;
  near.target_distance = m;
  far.target_distance = (pick >> 8 & 1) != 0 ? 2 * m : std::nextafter(static_cast<float>(m), 1e38F);
  round.target_distance = 0;
  Body<double>& body = (pick >> 9 & 1) != 0 ? round.a : round.b;
  body.shape = rounded<double>(body.shape, m);
  if (!is_sound_edit(near, method) || !is_sound_edit(round, method))
    return not_applicable("no such distance in this scalar, or the method knows none");
  const Answer one = method.ask(near, {}), two = method.ask(round, {});
  LawResult result = agree_within_rows(method, near, one, two)
                         ? holds()
                         : arbitrate(method, {{"the distance", near, one}, {"the rounding", round, two}},
                                     "a body rounded by the target distance answers otherwise");
  if (result.holding != Holding::holds) return result;
  result.labels.push_back(label_of(one.outcome));
  if (!is_sound_edit(far, method)) return result;
  const Answer sooner = method.ask(far, {});
  const bool ordered = one.outcome == Outcome::miss ||
                       (claims_contact(one) && claims_contact(sooner) && sooner.toi_lower <= one.toi_upper) ||
                       agree_within_rows(method, near, one, sooner);
  if (ordered) return result;
  return arbitrate(method, {{"the distance", near, one}, {"the larger distance", far, sooner}},
                   "a larger target distance is met later");
}

LawResult changing_the_clock(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  const int powers[] = {1, -1, 12, -12, 40, -40};
  const std::uint64_t first = mix(hash_of(seen) ^ 0x636c6f63u);
  for (std::size_t j = 0; j < std::size(powers); ++j) {
    const int k = powers[(j + first) % std::size(powers)];
    const std::optional<Case> other = stretched(seen, k);
    if (!other || !is_sound_edit(*other, method)) continue;
    const engine::Ask ask{.request = Request::normal};
    const Answer one = method.ask(seen, ask), two = method.ask(*other, ask);
    // Times that are, or become, subnormal or too large for the scalar.
    const double least = method.scalar == "float" ? double(std::numeric_limits<float>::min())
                                                  : std::numeric_limits<double>::min();
    const auto in_range = [&](double t) {
      return t == 0 || std::isinf(t) || (t >= 4 * least && t <= 0.25 / least);
    };
    if (!in_range(one.toi_lower) || !in_range(one.toi_upper) || !in_range(two.toi_lower) ||
        !in_range(two.toi_upper)) {
      continue;
    }
    std::string fault;
    if (one.outcome != two.outcome)
      fault = "outcome";
    else if (std::scalbn(one.toi_lower, k) != two.toi_lower || std::scalbn(one.toi_upper, k) != two.toi_upper)
      fault = "time by another factor";
    else if (one.counters.iterations != two.counters.iterations ||
             one.counters.supports != two.counters.supports)
      fault = "count of iterations or supports";
    else if (one.normal != two.normal)
      fault = "normal";
    if (!fault.empty()) {
      return broken(fmt::format("times 2^{}, velocities by it, changes the {}: {}; against {}", k, fault,
                                describe(one), describe(two)));
    }
    return holds({label_of(one.outcome), std::abs(k) > 20 ? "far scale" : "near scale"});
  }
  return not_applicable("no power of two keeps every number in range");
}

LawResult moving_together(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  for (std::uint64_t salt = hash_of(seen), tries = 0; tries < 4; ++tries, ++salt) {
    const std::optional<Case> other = moved_together(seen, salt);
    if (!other || !is_sound_edit(*other, method)) continue;
    return same_contact(method, seen, *other, "the moved", "a velocity that both share changes the answer");
  }
  return not_applicable("no exact velocity to share");
}

const engine::Method* query_of(corpus::Query query, std::string_view name, const std::string& scalar) {
  for (const engine::Method& one : engine::methods(engine::Kind::query)) {
    if (one.query == query && one.name == name && one.scalar == scalar) return &one;
  }
  return nullptr;
}

// The path's part of the line that is in contact, run backwards: the time when a cast from the end must meet it.
Answer from_the_end(const engine::Answer& line, double t_max) {
  Answer answer;
  answer.toi_lower = answer.toi_upper = kInfinity<double>;
  answer.outcome = line.outcome == Outcome::hit ? Outcome::miss : line.outcome;
  if (line.outcome != Outcome::hit || !line.t_in || !line.t_out) return answer;
  if (line.t_out->upper < 0 || line.t_in->lower > t_max) return answer;
  answer.toi_lower = std::max(t_max - line.t_out->upper, 0.0);
  answer.toi_upper = std::max(t_max - line.t_out->lower, 0.0);
  answer.outcome = answer.toi_upper > 0 ? Outcome::hit : Outcome::initially_overlapping;
  return answer;
}

LawResult reversing(const Case& problem, const Method& method) {
  const Case seen = reporting(method.seen(problem));
  if (!is_question_for(method, seen)) return outside();
  const std::optional<Case> back = reversed(seen);
  if (!back || !is_sound_edit(*back, method)) return not_applicable("no exact end to start from");
  const Answer one = method.ask(seen, {}), two = method.ask(*back, {});
  // t_in <= t_out.
  const bool consistent = (one.outcome == Outcome::miss && two.outcome == Outcome::miss) ||
                          (claims_contact(one) && claims_contact(two) &&
                           one.toi_lower + two.toi_lower <= seen.t_max * (1 + slack(method)));
  LawResult result = consistent
                         ? holds()
                         : arbitrate(method, {{"the path", seen, one}, {"the path reversed", *back, two}},
                                     "the reversed path answers otherwise");
  if (result.holding != Holding::holds) return result;
  result.labels.push_back(label_of(two.outcome));
  if (two.outcome == Outcome::not_converged || seen.a.displacement == seen.b.displacement) return result;
  if (method.is_exact() && engine::is_exact_ray(seen)) return result;  // no line_exact of it
  Case question = seen;
  question.query = corpus::Query::line;
  const engine::Method* line =
      query_of(corpus::Query::line, method.is_exact() ? "exact" : "mpr", method.scalar);
  const engine::Answer ends = line->answer(question);
  // The portal of a line along a face is as long as the face, and gives little information about either end.
  if (!ends.t_out || ends.stalled || !(ends.t_out->upper < kInfinity<double>)) return result;
  const Answer end = from_the_end(ends, seen.t_max);
  // t_max - t_out is rounded at the size of t_max.
  const double gap = std::max(two.toi_lower - end.toi_upper, end.toi_lower - two.toi_upper);
  const bool meets = two.outcome == Outcome::miss || end.outcome == Outcome::miss
                         ? two.outcome == end.outcome
                         : gap <= slack(method) * std::max(seen.t_max, std::abs(ends.t_out->upper));
  if (meets) {
    result.labels.push_back("line");
    return result;
  }
  // The line answers for some set near C about the start. The cast of this law is judged at its own.
  return arbitrate(method, {{"the path reversed", *back, two}},
                   fmt::format("the line leaves contact at [{}, {}]", decimal(ends.t_out->lower),
                               decimal(ends.t_out->upper)));
}

LawResult extending(const Case& problem, const Method& method) {
  const Case seen = reporting(method.seen(problem));
  if (!is_question_for(method, seen)) return outside();
  for (std::uint64_t salt = hash_of(seen), tries = 0; tries < 2; ++tries, ++salt) {
    const std::optional<Extended> before = extended(seen, salt);
    if (!before || !is_sound_edit(before->longer, method)) continue;
    const Answer one = method.ask(seen, {}), two = method.ask(before->longer, {});
    const double s = before->by;
    bool consistent = false;
    if (one.outcome == Outcome::hit) {
      Answer moved = one;
      moved.toi_lower += s;
      moved.toi_upper += s;
      consistent = agree_within_rows(method, before->longer, moved, two);
    } else if (one.outcome == Outcome::initially_overlapping) {
      consistent = claims_contact(two) && two.toi_lower <= s * (1 + slack(method));
    } else if (one.outcome == Outcome::miss) {
      consistent =
          two.outcome == Outcome::miss || (claims_contact(two) && two.toi_lower <= s * (1 + slack(method)));
    }
    LawResult result =
        consistent ? holds()
                   : arbitrate(method, {{"the path", seen, one}, {"the extended", before->longer, two}},
                               fmt::format("starting {} earlier changes the answer", decimal(s)));
    if (result.holding != Holding::holds) return result;
    result.labels.push_back(label_of(one.outcome));
    result.labels.push_back(s >= 8 * (std::isinf(seen.t_max) ? 1 : seen.t_max) ? "far start" : "near start");
    return result;
  }
  return not_applicable("no exact start farther back");
}

LawResult threshold_of_swept_overlap(const Case& problem, const Method& method) {
  const Case seen = reporting(method.seen(problem));
  if (!is_question_for(method, seen)) return outside();
  if (method.is_exact() && engine::is_exact_ray(seen))
    return not_applicable("no swept_overlap_exact of a ray at a solid");
  const Answer one = method.ask(seen, {});
  LawResult result = holds({label_of(one.outcome)});
  if (one.outcome == Outcome::not_converged) return result;
  // Within a millionth of the TOI in double, a hundredth in float.
  const double away = method.unit_roundoff == kUnitRoundoff<float> ? 0x1p-7 : 0x1p-20;
  const std::string names[] = {method.is_exact() ? "exact" : "mpr", method.is_exact() ? "exact" : "gjk"};
  const engine::Method* swept =
      query_of(corpus::Query::swept_overlap, names[hash_of(seen) & 1], method.scalar);
  for (const bool after : {false, true}) {
    double end = seen.t_max;
    bool expected = one.outcome != Outcome::miss;
    if (one.outcome == Outcome::hit) {
      end = after ? one.toi_upper * (1 + away) : one.toi_lower * (1 - away);
      expected = after;
    } else if (!after) {
      continue;  // one end is enough
    }
    const Case until = method.seen(with_horizon(seen, std::min(end, seen.t_max)));
    // At the very end of the path the answer is the cast's.
    const bool too_short = one.outcome == Outcome::hit && after && until.t_max < one.toi_upper;
    if (too_short || !is_sound_edit(until, method)) continue;
    Case question = until;
    question.query = corpus::Query::swept_overlap;
    const engine::Answer said = swept->answer(question);
    if (said.outcome == Outcome::not_converged) continue;
    if ((said.outcome != Outcome::miss) == expected) {
      result.labels.push_back(expected ? "contact until" : "free until");
      continue;
    }
    // Only the oracle decides which is at fault. The swept overlap is judged by the same guarantee.
    Answer overlap;
    overlap.outcome = said.outcome == Outcome::miss ? Outcome::miss : Outcome::initially_overlapping;
    if (const auto open = without_truth(until)) return *open;
    const std::string text =
        fmt::format("swept overlap by {} over [0, {}] says {}; the cast: {}", swept->full_name(),
                    decimal(until.t_max), label_of(said.outcome), describe(one));
    if (const auto open = without_truth(seen)) return *open;
    if (const std::string fault = any_fault(method, seen, one); !fault.empty())
      return broken(text + "; at fault is the cast: " + fault);
    const double scale = truth_of(until).scale().high,
                 bound = std::max(bound_of(method, until),
                                  64 * method.unit_roundoff * scale + unseen_of_trees(until, scale));
    if (const std::string fault = verdict_fault(truth_of(until), overlap, bound); !fault.empty())
      return broken(text + "; at fault is the swept overlap: " + fault);
    result.labels.push_back("arbitrated");
  }
  return result;
}

}  // namespace

std::vector<Law> linear_motion_laws() {
  return {
      {"moving_the_horizon",
       "A longer horizon keeps the contact found within a shorter one. A horizon before toi_lower is a miss.",
       Needs::metamorphic, &moving_the_horizon},
      {"keeping_distance", "A target distance is a rounding of either body. A larger one is never met later.",
       Needs::metamorphic, &keeping_distance},
      {"changing_the_clock",
       "T times 2^k and velocities by it multiply every time by 2^k and change no normal and no count.",
       Needs::metamorphic, &changing_the_clock},
      {"moving_together", "A velocity added to both bodies changes no contact.", Needs::metamorphic,
       &moving_together},
      {"reversing", "The path run backwards meets the other end of the line's contact.", Needs::metamorphic,
       &reversing},
      {"extending", "Starting farther back on the same line delays the contact by as much.",
       Needs::metamorphic, &extending},
      {"threshold_of_swept_overlap", "The swept overlap over [0, T] is in contact if T is not below the TOI.",
       Needs::metamorphic, &threshold_of_swept_overlap},
  };
}

}  // namespace graze::law
