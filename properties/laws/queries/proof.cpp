// Laws that need only the answer of a query: an axis bounds from one side, points from the other.
//
//   h(n) = max over C of n.c by corpus/support_value.hpp, in rounded doubles, which is independent of the
//   methods. Witnesses a, b of an axis n are where A and B end along it: n.a = h_A(n), n.b = -h_B(-n).
// The multiples of the limit follow from the tolerances of docs/reference/guarantees.md: a witness may be one limit off
// its body, a pair three, a normal one, an end of the bracket one.
#include <fmt/format.h>

#include <cmath>

#include "corpus/families/draw.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/queries/asked.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Method;

namespace {

// The coordinates of a witness round by 2 u of its distance from the origin (docs/reference/guarantees.md).
double rounding(const Vec3<double>& point, double u) { return 2 * u * point.norm(); }

// Distance of the witness from the end of its body along n, beyond rounding. Negative if it is outside.
double short_of_end(const Body<double>& body, const Vec3<double>& n, const Vec3<double>& point) {
  const Reach end = reach(body, n);
  const double at = n.dot(point - body.position);
  return end.value - at;
}

// n.v of a unit normal that is at right angles to v, over u |v|: its components are as good as kappa u.
constexpr double kLean = 64;

// Tier exact has no limit, but its normals are rounded, by 2 u a component. h moves by that much of the sizes of which
// h.error is 64 u (of double), and by no more than the 16 u of its guarantee.
double exact_slack(const Reach& h, double u) { return 16 * u * (h.error / kUnitRoundoff<double>); }

struct Shown {
  const Case& seen;
  const Answer& answer;
  double limit, u;

  // Both witnesses end their bodies along n, within `most` limits.
  [[nodiscard]] std::string ends(const Vec3<double>& n, double most) const {
    for (const bool first : {true, false}) {
      const Body<double>& body = first ? seen.a : seen.b;
      const Vec3<double>& point = first ? answer.point_a : answer.point_b;
      const Vec3<double> out = first ? n : Vec3<double>(-n);
      const double slack = most * limit + rounding(point, u) + reach(body, out).error +
                           4 * kUnitRoundoff<double> * (point - body.position).norm();
      const double off = std::abs(short_of_end(body, out, point));
      if (!(off <= slack)) {
        return fmt::format("the witness of {} is {} off the end of its body along the normal, {} allowed",
                           first ? 'A' : 'B', off, slack);
      }
    }
    return {};
  }
};

LawResult distance_is_shown(const Case& problem, const Method& method) {
  if (method.query != Query::distance) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer answer = method.answer(question->seen);
  if (answer.outcome != Outcome::miss || answer.stalled) return holds({label_of(answer.outcome)});
  if (!answer.has_normal() || !answer.has_points) return broken("no normal or points: " + describe(answer));
  const Reach h = reach(question->seen, answer.normal);
  const double limit = contact_limit_of(method, *question);
  if (const double off = h.value + answer.separation->lower; !(off <= 2 * limit + h.error))
    return broken(
        fmt::format("the normal separates by {} less than the distance: {}", off, describe(answer)));
  const double between = (answer.point_b - answer.point_a).norm(),
               rounded = rounding(answer.point_a, question->u) + rounding(answer.point_b, question->u);
  if (const double off = between - answer.separation->upper; !(std::abs(off) <= 4 * limit + rounded))
    return broken(
        fmt::format("the points are {} farther apart than the distance: {}", off, describe(answer)));
  const Shown shown{question->seen, answer, limit, question->u};
  if (const std::string fault = shown.ends(answer.normal, 6); !fault.empty())
    return broken(fault + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

LawResult depth_is_shown(const Case& problem, const Method& method) {
  if (method.query != Query::penetration && method.query != Query::penetration_along) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer answer = method.answer(question->seen);
  if (answer.outcome != Outcome::initially_overlapping || answer.stalled)
    return holds({label_of(answer.outcome)});
  if (!answer.depth || !answer.has_points) return broken("no depth or points: " + describe(answer));
  if (!answer.has_normal()) return broken("no normal: " + describe(answer));
  const Vec3<double> n = answer.normal;
  // The distance by which B is moved, and the part of it along the normal.
  const bool least = method.query == Query::penetration;
  const Vec3<double> d = least ? n : Vec3<double>(question->seen.direction.stableNormalized());
  const double along = answer.depth->upper * n.dot(d);
  const Reach h = reach(question->seen, n);
  // Along a direction the end is off by the limit in distance from C, and its normal by another.
  if (const double off = h.value - along; !(std::abs(off) <= 3 * question->limit + h.error))
    return broken(fmt::format("the normal ends C {} off the depth: {}", off, describe(answer)));
  // For the least move the normal is as good as its h. Where C curves, or a face tilts by 1e-9 to the next
  // one, points may end C along n at the depth and yet lie beside depth n. With a shortfall along n the
  // offset is its root,
  // x - depth n|^2 <= 2 depth (depth - n.x) for |x| <= depth.
  const double beside = least ? std::sqrt(16 * question->limit * answer.depth->upper) : 0;
  const double rounded = rounding(answer.point_a, question->u) + rounding(answer.point_b, question->u);
  const Vec3<double> pair = answer.point_a - answer.point_b;
  if (const double off = (pair - answer.depth->upper * d).norm();
      !(off <= 6 * question->limit + beside + rounded)) {
    return broken(
        fmt::format("the points do not meet when B is moved, but are {} apart: {}", off, describe(answer)));
  }
  const Shown shown{question->seen, answer, question->limit, question->u};
  if (const std::string fault = shown.ends(n, 8); !fault.empty())
    return broken(fault + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

// The least depth is a minimum over all directions. The law tries many, along the bodies' axes and at random, then ever
// nearer to the best of them. None may be less deep than the lower end of the bracket.
LawResult no_direction_is_less_deep(const Case& problem, const Method& method) {
  constexpr int kAtRandom = 128, kNearTheBest = 128;
  if (method.query != Query::penetration) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer answer = method.answer(question->seen);
  if (answer.outcome != Outcome::initially_overlapping || !answer.depth)
    return holds({label_of(answer.outcome)});
  Vec3<double> best = Vec3<double>::UnitX();
  Reach least{kInfinity<double>, 0};
  const auto look = [&](const Vec3<double>& n) {
    const Reach h = reach(question->seen, n);
    if (h.value + h.error < least.value + least.error) {
      least = h;
      best = n;
    }
  };
  for (const Body<double>* body : {&question->seen.a, &question->seen.b}) {
    for (int i = 0; i < 3; ++i) {
      const Vec3<double> axis = unit(corpus::rotate(body->orientation, Vec3<double>::Unit(i)));
      look(axis);
      look(-axis);
    }
  }
  corpus::Random random(hash_of(question->seen));
  for (int k = 0; k < kAtRandom + kNearTheBest; ++k) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const Vec3<double> about(x, y, random.uniform(-1, 1));
    // From a radian to 2^-16 of one.
    const double size = std::exp2(-(k - kAtRandom) / 8.0);
    const Vec3<double> n = k < kAtRandom ? about : Vec3<double>(best + size * about);
    if (n.norm() > 0.01) look(unit(n));
  }
  if (const double off = answer.depth->lower - least.value; !(off <= question->limit + least.error)) {
    return broken(fmt::format("along {} it is {} less deep: {}", decimal(best), off, describe(answer)));
  }
  return holds({label_of(answer.outcome)});
}

LawResult miss_is_shown(const Case& problem, const Method& method) {
  if (method.query == Query::distance) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer answer = method.answer(question->seen);
  if (answer.outcome != Outcome::miss) return holds({label_of(answer.outcome)});
  if (!answer.has_normal()) return broken("a miss without an axis: " + describe(answer));
  const Vec3<double>& n = answer.normal;
  const Reach h = reach(question->seen, n);
  const Vec3<double> v = velocity(question->seen);
  const double speed = n.dot(v), speed_error = kLean * question->u * v.stableNorm();
  // C, rounded by the target distance, is on the far side of 0 and of the path so far.
  const bool swept = method.query == Query::swept_overlap;
  const bool moving = swept || method.query == Query::line;
  const double target = moving ? question->seen.target_distance : 0;
  const double path = swept && speed < 0 ? question->seen.t_max * speed : 0;
  double slack = question->limit + h.error + (method.is_exact() ? exact_slack(h, question->u) : 0);
  if (swept) slack += std::isfinite(question->seen.t_max) ? question->seen.t_max * speed_error : 0;
  // Along the whole line the axis must be perpendicular to the motion, within rounding.
  if ((method.query == Query::line || (swept && std::isinf(question->seen.t_max))) && moving) {
    const bool leans = method.query == Query::line ? std::abs(speed) > speed_error : speed < -speed_error;
    if (leans) return broken(fmt::format("the axis of a miss leans by {}: {}", speed, describe(answer)));
    if (h.value + target > slack)
      return broken(
          fmt::format("the axis of a miss does not separate, by {}: {}", h.value, describe(answer)));
    return holds({label_of(answer.outcome)});
  }
  if (h.value + target - path > slack) {
    return broken(fmt::format("the axis of a miss does not separate, by {}: {}", h.value + target - path,
                              describe(answer)));
  }
  return holds({label_of(answer.outcome)});
}

LawResult line_normals_support(const Case& problem, const Method& method) {
  if (method.query != Query::line) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Answer answer = method.answer(question->seen);
  const Vec3<double> v = velocity(question->seen);
  if (answer.outcome != Outcome::hit || v == Vec3<double>::Zero()) return holds({label_of(answer.outcome)});
  if (!answer.has_normal() || answer.normal_out.isZero(0))
    return broken("an end without a normal: " + describe(answer));
  for (const bool in : {true, false}) {
    const Vec3<double>& n = in ? answer.normal : answer.normal_out;
    const engine::Interval& t = in ? *answer.t_in : *answer.t_out;
    if (!std::isfinite(t.lower) || !std::isfinite(t.upper)) continue;
    const double lean = (in ? 1 : -1) * n.dot(v);
    if (!(lean <= kLean * question->u * v.stableNorm()))
      return broken(fmt::format("a normal the wrong way along the motion: {}", describe(answer)));
    const Reach h = reach(question->seen, n);
    const double target = question->seen.target_distance;
    // The end of the bracket that suits the normal, since each has its own backward error.
    const double at_lower = h.value + target - t.lower * n.dot(v),
                 at_upper = h.value + target - t.upper * n.dot(v);
    const double off = std::min(std::abs(at_lower), std::abs(at_upper));
    const double slack = 2 * (method.is_exact() ? exact_slack(h, question->u) : question->limit) + h.error +
                         8 * question->u * std::abs(t.upper) * v.stableNorm();
    if (!(off <= slack)) {
      return broken(fmt::format("the normal of the {} end is {} off supporting C there, {} allowed: {}",
                                in ? "near" : "far", off, slack, describe(answer)));
    }
  }
  return holds({label_of(answer.outcome)});
}

}  // namespace

std::vector<Law> query_proof_laws() {
  return {
      {"distance_is_shown",
       "The normal of a distance separates by it, its points are as far apart and end their bodies there.",
       Needs::proof, &distance_is_shown},
      {"depth_is_shown", "The normal of a depth ends C there, and its points meet when B is moved by it.",
       Needs::proof, &depth_is_shown},
      {"no_direction_is_less_deep",
       "No direction out of the other body is shorter than the lower end of a depth.", Needs::proof,
       &no_direction_is_less_deep},
      {"miss_is_shown", "The axis of a miss separates the bodies, for all times that the query is about.",
       Needs::proof, &miss_is_shown},
      {"line_normals_support", "The line's normals support C where the line enters and where it leaves.",
       Needs::proof, &line_normals_support},
  };
}

}  // namespace graze::law
