#include "oracles/checker/check_record.hpp"

#include <algorithm>

#include "corpus/format/names.hpp"
#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/arithmetic/number_text.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "oracles/checker/check_within.hpp"

namespace graze::oracle {
namespace {

// The statement of a true proof about the time of impact.
struct Proved {
  double lower, upper;
  bool no_contact;

  explicit Proved(const corpus::ProofRecord& record)
      : lower(record.rotating ? record.rotating->toi_lower : record.proof.toi_lower),
        upper(record.rotating ? record.rotating->toi_upper : record.proof.toi_upper),
        no_contact(lower == kInfinity<double> || lower > record.problem.t_max) {
    if (no_contact) lower = kInfinity<double>;
  }
  [[nodiscard]] bool contact() const { return upper < kInfinity<double>; }
  [[nodiscard]] bool start_is_free() const { return lower > 0; }

  [[nodiscard]] std::string words() const {
    if (no_contact) return "no contact up to t_max";
    if (upper == 0) return "contact at the start";
    if (start_is_free() && contact()) return "first contact from " + text(lower) + " to " + text(upper);
    if (start_is_free()) return "no contact before " + text(lower);
    if (contact()) return "contact by " + text(upper);
    return "nothing";
  }
};

[[nodiscard]] std::string words_of(const corpus::ProofRecord& record) {
  std::string words(corpus::name_of(record.outcome));
  if (record.toi) words += " from " + text(record.toi->lower) + " to " + text(record.toi->upper);
  return words;
}

[[nodiscard]] bool contradicts(const Proved& proved, const corpus::ProofRecord& record) {
  const auto& toi = record.toi;
  switch (record.outcome) {
    case Outcome::initially_overlapping:
      if (proved.start_is_free() || (toi && toi->lower > 0)) return true;
      break;
    case Outcome::hit:
      if (proved.no_contact || proved.upper == 0 || record.problem.t_max == 0) return true;
      if (toi && (toi->upper == 0 || toi->lower == kInfinity<double> || toi->lower > record.problem.t_max))
        return true;
      break;
    case Outcome::miss:
      if (proved.contact() || (toi && toi->upper <= record.problem.t_max && toi->upper < kInfinity<double>))
        return true;
      break;
    case Outcome::not_converged:
    case Outcome::invalid_input:
      break;
  }
  // A record of no contact is contradicted by any finite upper end within the step.
  if (!toi || record.outcome == Outcome::miss) return false;
  if (proved.no_contact) return toi->upper < kInfinity<double> && toi->upper <= record.problem.t_max;
  return proved.upper < toi->lower || proved.lower > toi->upper;
}

// The proved halves of the outcome's claim.
struct Halves {
  int needed = 0, proved = 0;
  void add(bool is_proved) {
    ++needed;
    proved += is_proved ? 1 : 0;
  }
};

[[nodiscard]] Halves halves_of(const Proved& proved, Outcome outcome) {
  Halves halves;
  if (outcome == Outcome::initially_overlapping) {
    halves.add(proved.upper == 0);
  } else if (outcome == Outcome::hit) {
    halves.add(proved.start_is_free());
    halves.add(proved.contact());
  } else if (outcome == Outcome::miss) {
    halves.add(proved.no_contact);
  }
  return halves;
}

// How many points of curved parts one point of the shape is made of.
[[nodiscard]] std::size_t curved_points(const Shape<double>& shape) {
  const auto of = [](const SharedShape<double>& part) { return part ? curved_points(part->shape) : 0; };
  if (const auto* posed = std::get_if<Posed<double>>(&shape)) return of(posed->shape);
  if (const auto* rounded = std::get_if<Rounded<double>>(&shape)) return of(rounded->shape);
  std::size_t count = 0;
  if (const auto* sum = std::get_if<Sum<double>>(&shape)) {
    for (const SharedShape<double>& part : sum->shapes) count += of(part);
  } else if (const auto* hull_of = std::get_if<HullOf<double>>(&shape)) {
    for (const SharedShape<double>& part : hull_of->shapes) count = std::max(count, of(part));
  } else if (std::holds_alternative<Ellipsoid<double>>(shape) ||
             std::holds_alternative<Cylinder<double>>(shape) || std::holds_alternative<Cone<double>>(shape)) {
    count = 1;
  }
  return count;
}

// Claims that the format cannot express: that a start under pass_over does not leave, and a contact point
// made of more curved points than a feature holds.
[[nodiscard]] bool is_beyond_words(const Proved& proved, const corpus::ProofRecord& record) {
  const corpus::Case& problem = record.problem;
  if (problem.start_policy == corpus::StartPolicy::pass_over && !proved.start_is_free()) return true;
  const bool contact = record.outcome == Outcome::hit || record.outcome == Outcome::initially_overlapping;
  return contact && !can_name_contact(problem);
}

// Is the stated bracket proved? In tier standard, of some convex set within `granted` of C.
[[nodiscard]] bool proves_bracket(const Proved& proved, const corpus::ProofRecord& record, double granted) {
  if (!record.toi || record.outcome == Outcome::miss) return true;
  const double lower = record.toi->lower, upper = record.toi->upper;
  if (proved.lower >= lower && proved.upper <= upper) return true;
  if (record.tier != Tier::standard || record.rotating || !(granted > 0)) return false;
  // The same axis and portal, with each end that is stated more tightly than it is proved in place of the proved one.
  Proof stated = record.proof;
  stated.toi_lower = std::max(stated.toi_lower, lower);
  stated.toi_upper = std::min(stated.toi_upper, upper);
  const bool has_halves = (stated.toi_lower == 0 || stated.has_axis) &&
                          (stated.toi_upper == kInfinity<double> || stated.portal_size > 0);
  return has_halves && check_proof_within(record.problem, stated, granted).accepted();
}

}  // namespace

bool can_name_contact(const corpus::Case& problem) {
  return std::max(curved_points(problem.a.shape), curved_points(problem.b.shape)) <= kCurvedParts;
}

RecordVerdict compare_claim(const corpus::ProofRecord& record, double granted) {
  const DefaultEnvironment environment;
  const Proved proved(record);
  const auto claim = [&](const char* proves) {
    return "claims " + words_of(record) + proves + proved.words();
  };
  if (contradicts(proved, record)) return {RecordFinding::refused, "contradicted", claim(", proves ")};
  const Halves halves = halves_of(proved, record.outcome);
  if (halves.proved == halves.needed && proves_bracket(proved, record, granted)) return {};
  const bool something = halves.proved > 0 || proved.start_is_free() || proved.contact();
  if (something || is_beyond_words(proved, record) || record.tier == Tier::standard)
    return {RecordFinding::in_part, "in_part", claim(something ? ", proves only " : ", proves ")};
  return {RecordFinding::refused, "unproved", claim(", proves ")};
}

RecordVerdict check_record(const corpus::ProofRecord& record, double granted) {
  const auto refused = [](const auto& verdict) {
    return RecordVerdict{RecordFinding::refused, to_string(verdict.refusal), verdict.detail};
  };
  if (record.rotating) {
    const RotatingVerdict verdict = check_rotating_proof(record.problem, *record.rotating);
    if (!verdict.accepted()) return refused(verdict);
  } else {
    const Verdict verdict = check_proof(record.problem, record.proof);
    if (!verdict.accepted()) return refused(verdict);
  }
  return compare_claim(record, granted);
}

}  // namespace graze::oracle
