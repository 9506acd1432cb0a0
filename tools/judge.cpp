#include "tools/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "corpus/names.hpp"
#include "corpus/support_value.hpp"
#include "properties/exact_answer.hpp"
#include "properties/judge.hpp"
#include "tools/table.hpp"

namespace graze::tool {
namespace {

using engine::Answer;
using oracle::CaseTruth;
using oracle::Enclosure;

bool claims_contact(Outcome outcome) {
  return outcome == Outcome::hit || outcome == Outcome::initially_overlapping;
}

// --- What an accepted proof settles, in double. Every bound is rounded up by kSlack, and the scale down:
// what is then still within the limit is so without doubt; the rest is the oracle's.
constexpr double kSlack = 1 + 1e-6;

struct Box3 {
  Vec3<double> low, high;
  [[nodiscard]] Vec3<double> center() const { return low / 2 + high / 2; }
  [[nodiscard]] double diagonal() const { return (high - low).norm(); }
};

// Of the rotated shape, relative to the body's position.
Box3 bounds_of(const Body<double>& body) {
  const corpus::Bounds box = corpus::bounds(body.shape, body.orientation);
  return {box.low, box.high};
}

// Not above the scale, unless rounding of the poses ate more than a hundredth of it (hulls far from their own
// origin); then the error of the coordinates is subtracted.
double scale_from_below(const corpus::Case& problem) {
  const Box3 a = bounds_of(problem.a), b = bounds_of(problem.b);
  const double centers = (problem.b.position - problem.a.position + b.center() - a.center()).norm();
  const auto magnitude = [](const Box3& box) {
    return std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  };
  const double coordinates =
      magnitude(a) + magnitude(b) + problem.a.position.norm() + problem.b.position.norm();
  const double scale = std::max({a.diagonal(), b.diagonal(), centers});
  return std::max(0.0, 0.99 * scale - 64 * kUnitRoundoff<double> * coordinates);
}

// An upper bound of the backward error of time t that an accepted proof implies (infinity: none).
//   distance of t v from C   <= |s - t| |v|, for the contact at s in [proof.toi_lower, proof.toi_upper];
//   depth of the path over [0, t)  <= (t - proof.toi_lower) |n.v| / |n|: move C by that much against n, and
//   the axis proves that the path up to t misses it. Of a symbolic axis |n.v| / |n| is taken as its bound
//   |v|.
double proved_backward_error(const Proof& proof, const Vec3<double>& v, double t) {
  const double apart = std::max({proof.toi_upper - t, t - proof.toi_lower, 0.0}) * v.norm();
  const double slope = proof.symbolic ? v.norm() : std::abs(proof.axis.normalized().dot(v));
  const double before =
      t > proof.toi_lower ? (proof.has_axis ? (t - proof.toi_lower) * slope : kInfinity<double>) : 0;
  return kSlack * std::max(apart, before);
}

bool proves_verdict(const Proof& proof, Outcome outcome) {
  switch (outcome) {
    case Outcome::miss:
      return proof.toi_lower == kInfinity<double>;
    case Outcome::hit:
      return proof.toi_upper < kInfinity<double>;
    case Outcome::initially_overlapping:
      return proof.toi_upper == 0;
    default:
      return false;
  }
}

// True if nothing about the answer is left open by its accepted proof.
bool settled_by(const Proof& proof, const corpus::Case& problem, const Answer& answer, const Limits& limits) {
  if (!proves_verdict(proof, answer.outcome)) return false;
  if (answer.outcome != Outcome::hit) return true;
  const Vec3<double> v = problem.b.displacement - problem.a.displacement;
  const double rounding = 8 * kUnitRoundoff<double> *
                          (problem.a.displacement.norm() + problem.b.displacement.norm()) * answer.toi_upper;
  const double error = std::max(proved_backward_error(proof, v, answer.toi_lower),
                                proved_backward_error(proof, v, answer.toi_upper));
  return error + rounding <= limits.kappa * limits.unit_roundoff * scale_from_below(problem);
}

// --- What the exact oracle says.

// How far the normal is from supporting C where the path is at contact:  (h(n) - n.(t v)) / |n|.
// The answer is true of a convex set near C, whose time of impact may be far from C's own at a graze, and its
// normal is a normal there: so t is the TOI or either end of the bracket, whichever is best.
double normal_error(const CaseTruth& exact, const Answer& answer, const Vec3<double>& v) {
  const double at_toi = exact.normal_error(answer.normal).low, slope = answer.normal.normalized().dot(v);
  const double toi = exact.toi_lower();
  return std::min(
      {at_toi, at_toi + (toi - answer.toi_lower) * slope, at_toi + (toi - answer.toi_upper) * slope});
}

double witness_error(const CaseTruth& exact, const Answer& answer, const Limits& limits) {
  double worst = 0;
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    // The coordinates are rounded too, allowed beside the limit: a witness is the sum of position, motion and
    // offset, and both additions round each coordinate by u of its size.
    const double rounding = 2 * limits.unit_roundoff * point.norm();
    worst = std::max(worst, exact.distance_from_body(body, answer.toi_lower, point).low - rounding);
  }
  return worst;
}

// Keeps the first reason.
void convict(std::string& fault, std::string why) {
  if (fault.empty()) fault = std::move(why);
}

void judge_contact(Judgement& judgement, const CaseTruth& exact, const Answer& answer,
                   const corpus::Case& problem, const Limits& limits, double limit, Request request) {
  if (answer.outcome != Outcome::hit || exact.outcome() == Outcome::miss) return;
  const double scale = exact.scale().low;
  if (asks_for(request, Request::normal)) {
    const double length = answer.normal.norm();
    const Vec3<double> v = problem.b.displacement - problem.a.displacement;
    if (!(std::abs(length - 1) <= 16 * limits.unit_roundoff)) {
      convict(judgement.bad_contact, fmt::format("the normal has length {:.17g}", length));
    } else if (!(answer.normal.dot(v) <= limits.contact_kappa * limits.unit_roundoff * v.norm())) {
      convict(judgement.bad_contact, "the normal points along the motion");
    } else if (const double error = normal_error(exact, answer, v); error > limit) {
      convict(judgement.bad_contact,
              fmt::format("the normal supports C {:.2e} of scale beyond the contact", over(error, scale)));
    }
  }
  if (asks_for(request, Request::witnesses)) {
    if (!answer.point_a.allFinite() || !answer.point_b.allFinite()) {
      convict(judgement.bad_contact, "a witness is not finite");
    } else if (const double error = witness_error(exact, answer, limits); error > limit) {
      convict(judgement.bad_contact,
              fmt::format("a witness is {:.2e} of scale off its body", over(error, scale)));
    }
  }
}

void judge_by_oracle(Judgement& judgement, const CaseTruth& exact, const Answer& answer,
                     const corpus::Case& problem, const Limits& limits, Request request) {
  const double scale = exact.scale().high;
  const double limit = limits.kappa * limits.unit_roundoff * scale;
  const bool contact = exact.outcome() != Outcome::miss;
  const auto beyond = [&](const Enclosure& error) { return error.low > limit; };
  const auto in_scale = [&](const Enclosure& error) { return short_number(over(error.low, scale)); };

  if (answer.outcome == Outcome::miss) {
    if (!contact) return;
    const Enclosure depth = exact.depth();
    if (beyond(depth)) {
      convict(judgement.wrong, fmt::format("says miss; the path meets C {} of scale deep", in_scale(depth)));
    } else {
      judgement.excused = true;
    }
    return;
  }
  if (contact) {
    const Enclosure lateness = exact.lateness(answer.toi_lower);
    if (beyond(lateness)) {
      convict(judgement.late,
              fmt::format("toi_lower {:.17g} is past the contact at {:.17g}, {} of scale deep",
                          answer.toi_lower, exact.toi_lower(), in_scale(lateness)));
    }
  }
  if (claims_contact(answer.outcome)) {
    if (!contact) {
      const Enclosure clearance = exact.clearance();
      if (beyond(clearance)) {
        convict(judgement.wrong, fmt::format("says {}; the path stays {} of scale away",
                                             corpus::name_of(answer.outcome), in_scale(clearance)));
        return;
      }
      judgement.excused = true;
    }
    for (const double t : {answer.toi_lower, answer.toi_upper}) {
      const Enclosure error = exact.backward_error(t);
      if (beyond(error)) {
        convict(judgement.off, fmt::format("backward error {} of scale at t = {:.17g}", in_scale(error), t));
      }
    }
    const double contact_limit = limits.contact_kappa * limits.unit_roundoff * scale;
    judge_contact(judgement, exact, answer, problem, limits, contact_limit, request);
    return;
  }
  // not_converged. Its finite upper end claims contact by then; up to the first contact the distance from C
  // never grows (C is convex), so it is least at that end.
  if (answer.toi_upper < kInfinity<double> && (!contact || exact.compare(answer.toi_upper) < 0)) {
    const Enclosure apart = contact ? exact.distance_at(answer.toi_upper) : exact.clearance();
    if (beyond(apart)) {
      convict(judgement.wrong, fmt::format("says contact by {:.17g}; the path stays {} of scale away",
                                           answer.toi_upper, in_scale(apart)));
    }
  }
}

// The range that every method accepts: 0, and magnitudes of 1e-60 to 1e60.
bool in_range(double x) {
  const double magnitude = std::abs(x);
  return magnitude == 0 || (magnitude >= 1e-60 && magnitude <= 1e60);
}
bool in_range(const Vec3<double>& x) { return in_range(x.x()) && in_range(x.y()) && in_range(x.z()); }

std::string orientation_fault(const Quaternion<double>& q) {
  if (!in_range({q.x, q.y, q.z}) || !in_range(q.w)) return "a quaternion outside 1e-60 to 1e60";
  return q.w == 0 && q.is_identity() ? "a zero quaternion" : "";
}

// Why a shape must be refused; empty for a sound one.
struct ShapeFault {
  int* parts_seen;
  int nested = 0;  // combinators around it

  [[nodiscard]] static std::string length(double x, const char* what) {
    if (!in_range(x)) return fmt::format("a {} outside 1e-60 to 1e60", what);
    return x < 0 ? fmt::format("a negative {}", what) : "";
  }
  [[nodiscard]] static std::string lengths(const Vec3<double>& x, const char* what) {
    for (int i = 0; i < 3; ++i) {
      if (std::string why = length(x[i], what); !why.empty()) return why;
    }
    return "";
  }
  [[nodiscard]] static std::string vertices(std::initializer_list<Vec3<double>> all) {
    const bool inside = std::all_of(all.begin(), all.end(), [](const auto& x) { return in_range(x); });
    return inside ? "" : "a vertex outside 1e-60 to 1e60";
  }
  [[nodiscard]] std::string parts(std::span<const SharedShape<double>> all) const {
    constexpr int kMostNested = 16, kMostParts = 4096;
    if (all.empty()) return "a combinator without parts";
    if (nested >= kMostNested) return "combinators nested deeper than 16";
    for (const SharedShape<double>& part : all) {
      if (!part) return "a combinator with a missing part";
      if (++*parts_seen > kMostParts) return "combinators of more than 4096 parts";
      const ShapeFault inner{parts_seen, nested + 1};
      if (std::string why = std::visit(inner, part->shape); !why.empty()) return why;
    }
    return "";
  }

  std::string operator()(const Point<double>&) const { return ""; }
  std::string operator()(const Segment<double>& s) const { return vertices({s.a, s.b}); }
  std::string operator()(const Triangle<double>& t) const { return vertices({t.a, t.b, t.c}); }
  std::string operator()(const Sphere<double>& s) const { return length(s.radius, "radius"); }
  std::string operator()(const Box<double>& b) const { return lengths(b.half_extents, "half extent"); }
  std::string operator()(const Ellipsoid<double>& e) const { return lengths(e.radii, "radius"); }
  std::string operator()(const Hull<double>& h) const {
    if (h.size() == 0) return "a hull without a vertex";
    const auto all = h.vertices();
    const bool inside = std::all_of(all.begin(), all.end(), [](const auto& x) { return in_range(x); });
    return inside ? "" : "a vertex outside 1e-60 to 1e60";
  }
  std::string operator()(const Posed<double>& p) const {
    if (!in_range(p.position)) return "a position outside 1e-60 to 1e60";
    if (std::string why = orientation_fault(p.orientation); !why.empty()) return why;
    return parts(std::span(&p.shape, 1));
  }
  std::string operator()(const Rounded<double>& r) const {
    if (std::string why = length(r.radius, "radius"); !why.empty()) return why;
    return parts(std::span(&r.shape, 1));
  }
  // Sum, hull of several.
  template <class Combinator>
  requires requires(Combinator s) { s.shapes; }
  std::string operator()(const Combinator& s) const { return parts(s.shapes); }
  // Capsule, cylinder, cone.
  template <class Round>
  requires requires(Round s) { s.half_height; }
  std::string operator()(const Round& s) const {
    if (std::string why = length(s.radius, "radius"); !why.empty()) return why;
    return length(s.half_height, "half height");
  }
};

// Vertices by the rule of core/graze/shape.hpp, of a shape without another fault. A double holds what no
// integer does.
constexpr double kMostVertices = 4294967295.0;
double vertex_count(const Shape<double>& shape) {
  return std::visit(
      []<class T>(const T& s) -> double {
        if constexpr (requires { s.shape; }) {
          return vertex_count(s.shape->shape);
        } else if constexpr (requires { s.shapes; }) {
          constexpr bool kProduct = std::same_as<T, Sum<double>>;
          double count = kProduct ? 1 : 0;
          for (const auto& part : s.shapes) {
            const double more = vertex_count(part->shape);
            count = std::min(kProduct ? count * more : count + more, 1e300);
          }
          return count;
        } else if constexpr (std::same_as<T, Hull<double>>) {
          return static_cast<double>(s.size());
        } else if constexpr (std::same_as<T, Box<double>>) {
          return 8;
        } else if constexpr (std::same_as<T, Triangle<double>>) {
          return 3;
        } else {
          return std::same_as<T, Segment<double>> || std::same_as<T, Capsule<double>> ? 2 : 1;
        }
      },
      shape);
}

}  // namespace

double over(double length, double scale) {
  if (length == 0) return 0;
  return scale > 0 ? length / scale : kInfinity<double>;
}

std::string senseless(Outcome outcome, double lower, double upper, double t_max) {
  switch (outcome) {
    case Outcome::initially_overlapping:
      if (!(lower == 0 && upper == 0)) return "a start in contact has a time other than 0";
      return {};
    case Outcome::miss:
      if (!(lower == kInfinity<double> && upper == kInfinity<double>)) return "a miss has a finite time";
      return {};
    case Outcome::hit:
      if (!(0 <= lower && lower <= upper && upper < kInfinity<double> && lower <= t_max)) {
        return "a hit has a bracket that is no interval of times up to t_max";
      }
      return {};
    case Outcome::not_converged:
      if (!(0 <= lower && lower <= upper && lower < kInfinity<double>)) {
        return "the bracket of not_converged is no interval";
      }
      return {};
    case Outcome::invalid_input:
      return {};
  }
  return "an outcome that does not exist";
}

const CaseTruth& Truth::exact() {
  if (!exact_) exact_ = std::make_unique<CaseTruth>(problem_);
  return *exact_;
}

std::string why_invalid(const corpus::Case& problem) {
  for (const corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    if (!in_range(spin->rotation) || !in_range(spin->pivot))
      return "a rotation or a pivot outside 1e-60 to 1e60";
    constexpr double kMostTurn = 0x1p30;  // radians
    if (problem.t_max < kInfinity<double> && spin->rotation.norm() * problem.t_max > kMostTurn)
      return "a turn of more than 2^30 radians";
  }
  for (const Body<double>* body : {&problem.a, &problem.b}) {
    if (!in_range(body->position) || !in_range(body->displacement)) {
      return "a magnitude outside 1e-60 to 1e60";
    }
    if (std::string why = orientation_fault(body->orientation); !why.empty()) return why;
    int parts_seen = 0;
    if (std::string why = std::visit(ShapeFault{&parts_seen}, body->shape); !why.empty()) return why;
    if (vertex_count(body->shape) > kMostVertices) return "a shape of more than 2^32 - 1 vertices";
  }
  if (!(problem.t_max >= 0)) return "a negative t_max";
  if (!in_range(problem.target_distance) || problem.target_distance < 0)
    return "a target distance out of range";
  return {};
}

Errors errors_of(Truth& truth, const Answer& answer, Request request) {
  Errors errors;
  const CaseTruth& exact = truth.exact();
  const double scale = exact.scale().high;
  const bool contact = exact.outcome() != Outcome::miss;
  if (answer.outcome == Outcome::invalid_input ||
      !senseless(answer.outcome, answer.toi_lower, answer.toi_upper, truth.problem().t_max).empty())
    return errors;
  if (answer.outcome == Outcome::miss) {
    if (contact) errors.backward = over(exact.depth().high, scale);
    return errors;
  }
  // A bracket without an upper end has no error there.
  for (const double t : {answer.toi_lower, answer.toi_upper}) {
    if (!(t < kInfinity<double>)) continue;
    const double backward = over(exact.backward_error(t).high, scale);
    errors.backward = std::fmax(errors.backward, backward);
    // Where the oracle leaves the contact open, no time is right.
    const bool known = contact && exact.outcome() != Outcome::not_converged;
    if (known) errors.forward = std::fmax(errors.forward, over(exact.forward_error(t).high, scale));
  }
  if (answer.outcome == Outcome::hit && contact) {
    if (asks_for(request, Request::normal) && answer.normal.allFinite() && !answer.normal.isZero(0)) {
      const corpus::Case& problem = truth.problem();
      const Vec3<double> v = problem.b.displacement - problem.a.displacement;
      errors.normal = over(std::max(0.0, normal_error(exact, answer, v)), scale);
    }
    if (asks_for(request, Request::witnesses) && answer.point_a.allFinite() && answer.point_b.allFinite()) {
      errors.witness = over(std::max(exact.distance_from_body('a', answer.toi_lower, answer.point_a).high,
                                     exact.distance_from_body('b', answer.toi_lower, answer.point_b).high),
                            scale);
    }
  }
  return errors;
}

namespace {

// The door. True if there is nothing more to judge.
bool is_settled_at_the_door(Judgement& judgement, const corpus::Case& problem, const Answer& answer) {
  judgement.outcome = answer.outcome;
  judgement.stalled = answer.outcome == Outcome::not_converged;
  const std::string invalid = why_invalid(problem);
  const bool refused = answer.outcome == Outcome::invalid_input;
  if (refused != !invalid.empty()) {
    convict(judgement.wrong, refused ? "refuses a valid case" : "answers a case that has " + invalid);
  }
  return refused || !invalid.empty();
}

// A hit at a time that the scalar cannot hold. True if there is nothing more to judge.
bool is_settled_beyond_range(Judgement& judgement, Truth& truth, const Answer& answer, const Limits& limits) {
  if (answer.outcome != Outcome::hit || truth.problem().t_max < kInfinity<double> ||
      !law::is_beyond_range(answer.toi_lower, answer.toi_upper, limits.unit_roundoff)) {
    return false;
  }
  judgement.by_oracle = true;
  if (truth.exact().outcome() != Outcome::hit || truth.exact().compare(answer.toi_lower) > 0) {
    convict(judgement.wrong, "a time beyond the scalar's range, where there is contact before that, or none");
  }
  return true;
}

}  // namespace

Judgement judge(Truth& truth, const Answer& answer, const Limits& limits, bool ask_oracle, Request request) {
  Judgement judgement;
  if (is_settled_at_the_door(judgement, truth.problem(), answer)) return judgement;
  if (is_settled_beyond_range(judgement, truth, answer, limits)) return judgement;
  if (const std::string why =
          senseless(answer.outcome, answer.toi_lower, answer.toi_upper, truth.problem().t_max);
      !why.empty()) {
    convict(judgement.wrong, why);
    return judgement;
  }

  bool settled = false;
  if (answer.proof) {
    const oracle::Verdict verdict = oracle::check_proof(truth.problem(), *answer.proof);
    if (!verdict.accepted()) {
      judgement.proof = ProofState::refused;
      judgement.false_proof = fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
    } else if (proves_verdict(*answer.proof, answer.outcome)) {
      judgement.proof = ProofState::accepted;
      settled = settled_by(*answer.proof, truth.problem(), answer, limits);
    }
  }
  if (settled && !ask_oracle) return judgement;
  judgement.by_oracle = true;
  judge_by_oracle(judgement, truth.exact(), answer, truth.problem(), limits, request);
  judgement.errors = errors_of(truth, answer, request);
  return judgement;
}

namespace {

// What rounding the times to float costs, a length; nothing in double, whose width counts it.
double rounding_of_times(const corpus::Case& problem, double time, const Limits& limits) {
  if (limits.unit_roundoff != kUnitRoundoff<float> || !(time < kInfinity<double>)) return 0;
  const double speed = (problem.b.displacement - problem.a.displacement).stableNorm();
  return kSlack * speed * (2 * limits.unit_roundoff * time + double(std::numeric_limits<float>::min()));
}

// True if the accepted proof shows the verdict, that the bracket holds, and that it is narrow.
bool certified_by(const Proof& proof, const corpus::Case& problem, const Answer& answer,
                  const Limits& limits) {
  if (!proves_verdict(proof, answer.outcome)) return false;
  if (answer.outcome != Outcome::hit) return true;
  if (!(answer.toi_lower <= proof.toi_lower && proof.toi_upper <= answer.toi_upper)) return false;
  const Vec3<double> v = problem.b.displacement - problem.a.displacement;
  const double error = std::max(proved_backward_error(proof, v, answer.toi_lower),
                                proved_backward_error(proof, v, answer.toi_upper));
  return error <=
         limits.width * scale_from_below(problem) + rounding_of_times(problem, answer.toi_lower, limits);
}

void judge_certified_by_oracle(Judgement& judgement, const CaseTruth& exact, const Answer& answer,
                               const corpus::Case& problem, const Limits& limits) {
  const double width = limits.width * exact.scale().high;
  const double time = std::min(exact.toi_upper(), answer.toi_upper);  // where the oracle is open, the claim
  const double bound = width + rounding_of_times(problem, time, limits);
  convict(judgement.wrong, law::verdict_fault(exact, answer, 0));
  if (answer.outcome == Outcome::initially_overlapping && exact.outcome() == Outcome::hit)
    convict(judgement.wrong, "claims contact at t = 0 of bodies that are apart then");
  convict(judgement.late, law::late_fault(exact, answer, 0));
  convict(judgement.off, law::early_fault(exact, answer, 0));
  convict(judgement.off, law::time_fault(exact, answer, bound));
  if (answer.outcome == Outcome::not_converged) {
    judgement.stalled = !law::undecided_fault(exact, answer, bound).empty();
    judgement.excused = !judgement.stalled;
  }
  const double limit = limits.contact_kappa * limits.unit_roundoff * exact.scale().high + bound;
  judge_contact(judgement, exact, answer, problem, limits, limit, Request::everything);
}

}  // namespace

Judgement judge_certified(Truth& truth, const Answer& answer, const Limits& limits, bool ask_oracle) {
  const corpus::Case& problem = truth.problem();
  Judgement judgement;
  if (is_settled_at_the_door(judgement, problem, answer)) return judgement;
  if (is_settled_beyond_range(judgement, truth, answer, limits)) return judgement;
  if (std::string why = senseless(answer.outcome, answer.toi_lower, answer.toi_upper, problem.t_max);
      !why.empty()) {
    convict(judgement.wrong, std::move(why));
    return judgement;
  }
  bool settled = false;
  if (answer.proof) {
    const oracle::Verdict verdict = oracle::check_proof(problem, *answer.proof);
    if (!verdict.accepted()) {
      judgement.proof = ProofState::refused;
      judgement.false_proof = fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
    } else if (proves_verdict(*answer.proof, answer.outcome)) {
      judgement.proof = ProofState::accepted;
      settled = certified_by(*answer.proof, problem, answer, limits);
    }
  }
  if (settled && !ask_oracle) return judgement;
  judgement.by_oracle = true;
  judge_certified_by_oracle(judgement, truth.exact(), answer, problem, limits);
  judgement.errors = errors_of(truth, answer, Request::everything);
  return judgement;
}

Judgement judge_exact(Truth& truth, const Answer& answer, const Limits& limits, bool ask_oracle) {
  const corpus::Case& problem = truth.problem();
  const bool in_float = limits.unit_roundoff == kUnitRoundoff<float>;
  Judgement judgement;
  if (why_invalid(problem).empty() && !engine::is_exact_question(problem)) {
    judgement.outcome = answer.outcome;
    judgement.not_asked = true;
    if (answer.outcome != Outcome::invalid_input || answer.invalid != Invalid::not_exact) {
      judgement.wrong = "answers a case that is not for the exact tier";
    }
    return judgement;
  }
  if (is_settled_at_the_door(judgement, problem, answer)) return judgement;

  const law::ExactFinding finding = law::judge_exact_by_proof(problem, answer, in_float);
  if (finding.false_proof) {
    judgement.proof = ProofState::refused;
    judgement.false_proof = finding.fault;
  } else {
    judgement.proof = finding.fault.empty() && answer.proof ? ProofState::accepted : ProofState::none;
    judgement.wrong = finding.fault;
  }
  if (!ask_oracle && finding.settled) return judgement;
  judgement.by_oracle = true;
  const CaseTruth& exact = truth.exact();
  if (std::string why = law::exact_fault_by_truth(exact, answer, in_float); !why.empty()) {
    convict(judgement.wrong, std::move(why));
  }
  const double limit = limits.contact_kappa * limits.unit_roundoff * exact.scale().high;
  judge_contact(judgement, exact, answer, problem, limits, limit, Request::everything);
  judgement.errors = errors_of(truth, answer, Request::everything);
  return judgement;
}

Judgement judge_method(Truth& truth, const corpus::Case& problem, const engine::EngineMethod& method,
                       const Answer& answer, const engine::Guarantee* row, bool ask_oracle) {
  const Limits limits{.kappa = row != nullptr ? row->kappa(problem) : kPlainKappa,
                      .unit_roundoff = method.unit_roundoff,
                      .contact_kappa = row != nullptr ? row->contact_kappa(problem) : kPlainKappa,
                      .width = row != nullptr ? row->width.value_or(0) : 0};
  if (method.is_certified()) return judge_certified(truth, answer, limits, ask_oracle);
  return method.is_exact() ? judge_exact(truth, answer, limits, ask_oracle)
                           : judge(truth, answer, limits, ask_oracle, Request::everything);
}

}  // namespace graze::tool
