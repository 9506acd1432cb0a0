#include "properties/judge/judge_followed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "properties/judge/rotating_errors.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using oracle::RotatingTruth;

namespace {

// Least part of the followed depth that counts as deeper, or as a gap.
constexpr double kLeast = 1.0 / 8;
// Width of the oracle's searches over scale: a tenth of the least depth, 4,096 u / 8.
constexpr double kFine = 0x1p-47;

// Are the bodies apart by more than `least` at a time that is looked at before `end`?
bool comes_apart(const RotatingTruth& truth, double end, double least) {
  constexpr int kEven = 32, kHalvings = 40;
  const auto apart_at = [&](double t) { return t > 0 && t < end && truth.distance_at(t).high > least; };
  for (int i = 1; i < kEven; ++i) {
    if (apart_at(end * i / kEven)) return true;
  }
  for (int i = 5; i < kHalvings; ++i) {
    const double part = std::ldexp(1.0, -i);
    for (const double of : {1.0, 0.75}) {
      if (apart_at(end * (1 - of * part)) || apart_at(end * of * part)) return true;
    }
  }
  return false;
}

}  // namespace

Case reporting(Case problem) {
  problem.start_policy = StartPolicy::report;
  return problem;
}

RotatingTruth truth_from_start(const Case& problem) {
  return RotatingTruth::of_proved(reporting(problem), 0, 0, kFine);
}

double followed_depth(const Limits& limits) {
  return limits.strict ? 4096 * kUnitRoundoff<double> * limits.scale : limits.limit;
}

void judge_followed(Judgement& judgement, const RotatingTruth& truth, const Case& problem,
                    const Answer& answer, const Limits& limits, Request request) {
  const double d = followed_depth(limits), least = kLeast * d;
  const auto over_scale = [&](double length) {
    return fmt::format("{:.1e} of scale", over(length, limits.scale));
  };
  const auto deeper_before = [&](double t, std::string& fault, std::string_view what) {
    const double deep = truth.depth_before(t).low;
    judgement.errors.passed = over(deep, limits.scale);
    if (deep > d)
      add_fault(fault,
                fmt::format("{}, and the contact of the start gets {} deep before", what, over_scale(deep)));
  };
  judgement.by_oracle = true;
  judgement.errors.scale = limits.scale;
  switch (answer.outcome) {
    case Outcome::miss:
      deeper_before(problem.t_max, judgement.wrong, "says miss");
      // In the standard tier a start within the limit may count as apart, too.
      if (!answer.passed_over && truth.depth_at(0).low > (limits.strict ? 0 : limits.limit))
        add_fault(judgement.wrong, "says miss, and not that it passed over the start in contact");
      return;
    case Outcome::initially_overlapping:
      if (truth.depth_at(0).high <= least)
        add_fault(judgement.wrong,
                  fmt::format("reports a start that is {} deep", over_scale(truth.depth_at(0).high)));
      return;
    case Outcome::not_converged: {
      deeper_before(answer.toi_lower, judgement.late, "toi_lower is late");
      // A tie that is open is at toi_lower: bodies that were apart meet again there, or nearly.
      const oracle::Enclosure deep = truth.depth_before(problem.t_max);
      const double t = answer.toi_lower;
      const bool meet_again = t > 0 && t < problem.t_max && comes_apart(truth, t, least) &&
                              truth.distance_at(t).low <= std::max(limits.wide, least);
      judgement.stalled = deep.low > std::max(d, limits.wide) || (deep.high <= least && !meet_again);
      judgement.within_tolerance = !judgement.stalled;
      return;
    }
    case Outcome::hit:
      break;
    case Outcome::invalid_input:
      return;
  }
  deeper_before(answer.toi_lower, judgement.late, "toi_lower is late");
  // As above, of a start that is apart by less than counts.
  const bool goes_in_at_once =
      answer.plan.effects != Effects::rotating && truth.depth_before(problem.t_max).high > least;
  const double apart = truth.distance_at(answer.toi_upper).low;
  if (apart > std::max(limits.wide, least)) {
    add_fault(judgement.early, fmt::format("claims contact by {:.17g}, where the bodies are {} apart",
                                           answer.toi_upper, over_scale(apart)));
  } else if (truth.depth_before(answer.toi_upper).high <= least &&
             !comes_apart(truth, answer.toi_upper, least) && !goes_in_at_once) {
    add_fault(judgement.wrong,
              fmt::format("says hit by {:.17g}; until then the contact of the start gets no deeper than "
                          "{}, and there is no new one",
                          answer.toi_upper, over_scale(truth.depth_before(answer.toi_upper).high)));
  }
  for (const auto& [error, fault] :
       {std::pair(&width_error, &Judgement::off), std::pair(&distance_error, &Judgement::off)}) {
    const RotatingError found = error(truth, answer, limits);
    if (!found.fault.empty()) add_fault(judgement.*fault, found.fault);
  }
  Limits contact = limits;
  contact.contact += d;  // as deep as the contact that is followed may be
  const RotatingTruth there = RotatingTruth::of_proved(reporting(problem), answer.toi_lower,
                                                       std::min(answer.toi_upper, problem.t_max), kFine);
  if (asks_for(request, Request::normal)) {
    const RotatingError found = normal_error(there, answer, contact);
    if (!found.fault.empty()) add_fault(judgement.bad_contact, found.fault);
  }
  if (asks_for(request, Request::witnesses)) {
    const RotatingError found = witness_error(there, answer, contact);
    if (!found.fault.empty()) add_fault(judgement.bad_contact, found.fault);
  }
}

}  // namespace graze::law
