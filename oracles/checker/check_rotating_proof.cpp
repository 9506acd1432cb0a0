// The form of the proof (rotating_proof_form.hpp), then its chain, slice by slice, each in double
// (slice_filter.hpp) and where that leaves it open in balls (slice_claim.hpp), then its contact
// (contact_claim.hpp, crossing_claim.hpp).
#include "oracles/checker/check_rotating_proof.hpp"

#include <algorithm>
#include <memory>

#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/arithmetic/number_text.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/checker/contact_claim.hpp"
#include "oracles/checker/crossing_claim.hpp"
#include "oracles/checker/rotating_proof_form.hpp"
#include "oracles/checker/slice_claim.hpp"
#include "oracles/checker/slice_filter.hpp"

namespace graze::oracle {
namespace {

constexpr std::array<long, 3> kPrecisions = {128, 256, 512};

class Claims {
 public:
  Claims(const corpus::Case& problem, const TreesOfCase& trees, const RotatingProof& proof,
         RotatingCheckCost& cost, Stages stages)
      : problem_(problem), trees_(trees), proof_(proof), cost_(cost), stages_(stages) {}

  [[nodiscard]] RotatingVerdict chain() {
    if (proof_.chain.empty()) return {};
    const WorkingPrecision working(kPrecisions[0]);
    const PairMotion& motion = at_precision(0);
    std::optional<SliceFilter> filter;
    SliceFilter::Instant first;
    if (stages_ == Stages::all) {
      filter.emplace(problem_, trees_.a, trees_.b, motion.a, motion.b);
      first = filter->at(0);
    }
    double begin = 0;
    for (std::size_t i = 0; i < proof_.chain.size(); ++i) {
      const TimeSlice& slice = proof_.chain[i];
      if (slice.axis.isZero(0))
        return {RotatingRefusal::axis_missing, "slice " + std::to_string(i) + " has a zero axis"};
      ++cost_.slices;
      bool proved = false;
      if (filter) {
        const SliceFilter::Instant last = filter->at(slice.end);
        proved = filter->proves(slice, first, last, kMostPieces, cost_.pieces);
        first = last;
      }
      if (proved) {
        ++cost_.in_double;
      } else if (const SliceAnswer answer = in_balls(slice, begin); answer.finding != SliceFinding::holds) {
        return refuse(i, begin, answer);
      }
      begin = slice.end;
    }
    return {};
  }

  [[nodiscard]] RotatingVerdict contact() {
    if (!(proof_.toi_upper < kInfinity<double>)) return {};
    if (proof_.contact_size == 0)
      return {RotatingRefusal::contact_missing,
              "toi_upper " + text(proof_.toi_upper) + " needs a pair of points in contact"};
    if (proof_.toi_upper > problem_.t_max)
      return {RotatingRefusal::upper_beyond_end,
              "toi_upper " + text(proof_.toi_upper) + " exceeds t_max, " + text(problem_.t_max)};
    if (!proof_.crossing && proof_.contact_size != 4 && !weights_hold(proof_))
      return {RotatingRefusal::weights_missing,
              "pairs that are not four need finite weights of at least 0, one of them above it"};
    ContactAnswer answer{ContactFinding::open};
    for (std::size_t k = 0; k < kPrecisions.size() && answer.finding == ContactFinding::open; ++k) {
      const WorkingPrecision working(kPrecisions[k]);
      if (k == 1) ++cost_.raised;
      const PairMotion& motion = at_precision(k);
      answer = proof_.crossing ? CrossingClaim(motion, proof_).prove() : prove_contact(motion, proof_);
    }
    if (answer.finding != ContactFinding::holds && holds_at_start()) return {};
    return refuse(answer);
  }

 private:
  // At t = 0 nothing has turned yet, and the hull of the named points holds the origin or does not, exactly,
  // its boundary included. So does the hull of points of the cores with the balls about them.
  [[nodiscard]] bool holds_at_start() const {
    if (proof_.toi_upper != 0 || proof_.crossing || proof_.contact_size > 4) return false;
    corpus::Case start = problem_;
    start.spin_a = start.spin_b = {};
    Proof portal;
    portal.toi_upper = 0;
    portal.portal_size = proof_.contact_size;
    std::copy_n(proof_.contact.begin(), portal.portal.size(), portal.portal.begin());
    if (check_proof(start, portal).accepted()) return true;
    portal.of_cores = true;
    return check_proof(start, portal).accepted();
  }

  [[nodiscard]] const PairMotion& at_precision(std::size_t k) {
    if (!motions_[k]) motions_[k] = std::make_unique<PairMotion>(problem_);
    return *motions_[k];
  }

  [[nodiscard]] SliceAnswer in_balls(const TimeSlice& slice, double begin) {
    SliceAnswer answer{SliceFinding::open};
    for (std::size_t k = 0; k < kPrecisions.size() && answer.finding == SliceFinding::open; ++k) {
      const WorkingPrecision working(kPrecisions[k]);
      if (k == 1) ++cost_.raised;
      ++cost_.pieces;
      const PairMotion& motion = at_precision(k);
      answer = SliceClaim(motion, slice, begin, cost_)
                   .prove(PairInstant(motion, begin), PairInstant(motion, slice.end));
    }
    return answer;
  }

  [[nodiscard]] RotatingVerdict refuse(std::size_t i, double begin, const SliceAnswer& answer) const {
    const TimeSlice& slice = proof_.chain[i];
    const std::string name = "slice " + std::to_string(i) + ", [" + text(begin) + ", " + text(slice.end) +
                             "]: at t = " + text(answer.at) +
                             " the separation along its axis less the target distance is about " +
                             text(answer.excess);
    if (answer.finding == SliceFinding::is_false)
      return {RotatingRefusal::slice_false, name + ", not above 0"};
    if (answer.finding == SliceFinding::open)
      return {RotatingRefusal::undecided,
              name + ", too near 0 for " + std::to_string(kPrecisions.back()) + " bits"};
    return {RotatingRefusal::slice_not_proved,
            name + "; " + std::to_string(kMostPieces) + " pieces do not show that it stays above 0"};
  }

  [[nodiscard]] RotatingVerdict refuse(const ContactAnswer& answer) const {
    const std::string values = "at toi_upper " + text(proof_.toi_upper) + " the weighted points are about " +
                               text(answer.distance) + " apart, with a reach of about " + text(answer.reach);
    const std::string seen =
        "the crossing from " + text(proof_.contact_from) + " to " + text(proof_.toi_upper) + ": ";
    const std::string line = "at t = " + text(answer.at) + " the line through the origin along its normal ";
    switch (answer.finding) {
      case ContactFinding::holds:
        return {};
      case ContactFinding::beside:
        return {RotatingRefusal::crossing_not_proved, seen + line + "does not pass inside the triangle"};
      case ContactFinding::one_side:
        return {RotatingRefusal::crossing_not_proved,
                seen + "the triangle is on one side of the origin at both ends, at heights of about " +
                    text(answer.first) + " and " + text(answer.last)};
      case ContactFinding::too_many_pieces:
        return {RotatingRefusal::crossing_not_proved,
                seen + std::to_string(kMostPieces) + " pieces do not show that near t = " + text(answer.at) +
                    " the line through the origin along its normal stays inside the triangle"};
      case ContactFinding::unnamed:
        return malformed("contact pair " + std::to_string(answer.pair) +
                         " has a point on a way with more than " + std::to_string(kCurvedParts) +
                         " curved parts, which a feature cannot name");
      case ContactFinding::point_outside:
        return {RotatingRefusal::point_outside,
                "a point of contact pair " + std::to_string(answer.pair) + " lies outside its shape"};
      case ContactFinding::apart:
        return {RotatingRefusal::contact_not_proved,
                weights_hold(proof_) ? values : "the origin is not strictly inside the hull of the pairs"};
      case ContactFinding::open:
        break;
    }
    return {RotatingRefusal::undecided, (proof_.crossing ? seen : values + ", ") + "too close for " +
                                            std::to_string(kPrecisions.back()) + " bits"};
  }

  const corpus::Case& problem_;
  const TreesOfCase& trees_;
  const RotatingProof& proof_;
  RotatingCheckCost& cost_;
  Stages stages_;
  std::array<std::unique_ptr<PairMotion>, kPrecisions.size()> motions_;
};

}  // namespace

const char* to_string(RotatingRefusal refusal) {
  switch (refusal) {
    case RotatingRefusal::none:
      return "accepted";
    case RotatingRefusal::malformed:
      return "malformed";
    case RotatingRefusal::unsupported:
      return "unsupported";
    case RotatingRefusal::out_of_range:
      return "out_of_range";
    case RotatingRefusal::chain_too_short:
      return "chain_too_short";
    case RotatingRefusal::axis_missing:
      return "axis_missing";
    case RotatingRefusal::slice_false:
      return "slice_false";
    case RotatingRefusal::slice_not_proved:
      return "slice_not_proved";
    case RotatingRefusal::contact_missing:
      return "contact_missing";
    case RotatingRefusal::upper_beyond_end:
      return "upper_beyond_end";
    case RotatingRefusal::point_outside:
      return "point_outside";
    case RotatingRefusal::weights_missing:
      return "weights_missing";
    case RotatingRefusal::contact_not_proved:
      return "contact_not_proved";
    case RotatingRefusal::crossing_not_proved:
      return "crossing_not_proved";
    case RotatingRefusal::undecided:
      return "undecided";
  }
  return "unknown refusal";
}

RotatingVerdict check_rotating_proof(const corpus::Case& problem, const RotatingProof& proof,
                                     RotatingCheckCost* cost, Stages stages) {
  const DefaultEnvironment environment;
  if (RotatingVerdict form = read_proof(proof); !form.accepted()) return form;
  const TreesOfCase trees(problem);
  if (RotatingVerdict form = read_case(problem, trees, proof); !form.accepted()) return form;
  if (RotatingVerdict reach = chain_reaches(problem, proof); !reach.accepted()) return reach;
  RotatingCheckCost ignored;
  Claims claims(problem, trees, proof, cost != nullptr ? *cost : ignored, stages);
  if (RotatingVerdict chain = claims.chain(); !chain.accepted()) return chain;
  return claims.contact();
}

}  // namespace graze::oracle
