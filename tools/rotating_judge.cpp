#include "tools/rotating_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/names.hpp"
#include "corpus/support_value.hpp"
#include "tools/table.hpp"

namespace graze::tool {
namespace {

using engine::RotatingAnswer;
using engine::Unseen;
using oracle::Enclosure;
using oracle::RotatingTruth;

void convict(std::string& fault, std::string why) {
  if (fault.empty()) fault = std::move(why);
}

// No point of the body moves faster (length per unit of t): the displacement, and the rotation at the arm of
// the farthest corner of its bounds from the pivot.
double fastest(const Body<double>& body, const corpus::Spin& spin) {
  const corpus::Bounds box = corpus::bounds(body.shape, body.orientation);
  const double arm = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() + spin.pivot.norm();
  return body.displacement.norm() + spin.rotation.norm() * arm;
}

// Does an accepted proof say all that the answer says?
bool proves(const RotatingProof& proof, const RotatingAnswer& answer) {
  switch (answer.outcome) {
    case Outcome::miss:
      return proof.toi_lower == kInfinity<double>;
    case Outcome::initially_overlapping:
      return proof.toi_upper == 0;
    case Outcome::hit:
    case Outcome::not_converged:
      return proof.toi_lower >= answer.toi_lower && proof.toi_upper <= answer.toi_upper;
    case Outcome::invalid_input:
      break;
  }
  return false;
}

class RotatingJudge {
 public:
  RotatingJudge(TurningTruth& truth, const RotatingAnswer& answer, const RotatingLimits& limits,
                Request request)
      : truth_(truth), answer_(answer), limits_(limits), request_(request) {
    judgement_.outcome = answer.outcome;
  }

  RotatingJudgement operator()() {
    if (settled_at_the_door()) return judgement_;
    const corpus::Case& problem = truth_.problem();
    if (std::string why = senseless(answer_.outcome, answer_.toi_lower, answer_.toi_upper, problem.t_max);
        !why.empty()) {
      convict(judgement_.wrong, std::move(why));
      return judgement_;
    }
    proof();
    const RotatingTruth& truth = truth_.bracket();
    scale_ = truth.scale().high;
    limit_ = limits_.kappa * limits_.unit_roundoff * scale_;
    wide_ = std::max(limit_, limits_.width.value_or(0) * scale_);
    speed_ = greatest_speed(problem);
    judgement_.open = truth.outcome() == Outcome::not_converged;
    switch (answer_.outcome) {
      case Outcome::miss:
        miss(truth);
        break;
      case Outcome::not_converged:
        not_converged(truth);
        break;
      default:
        contact(truth);
        break;
    }
    return judgement_;
  }

 private:
  [[nodiscard]] bool certified() const { return limits_.certified; }
  [[nodiscard]] double in_scale(double length) const { return over(length, scale_); }
  [[nodiscard]] std::string length_text(double length) const {
    return short_number(in_scale(length)) + " of scale";
  }
  // How deep a contact may be that goes unseen.
  [[nodiscard]] double allowed(Unseen unseen) const {
    switch (unseen) {
      case Unseen::anything:
        return kInfinity<double>;
      case Unseen::hidden_motion:
        return limit_ + answer_.hidden_motion;
      case Unseen::nothing:
        break;
    }
    return limit_;
  }

  // A time is a number of the method's scalar, rounded outward: by 2 u of itself, in which the fastest points
  // move so far.
  [[nodiscard]] double time_rounding(double t) const { return 2 * limits_.unit_roundoff * t * speed_; }

  bool settled_at_the_door() {
    const corpus::Case& problem = truth_.problem();
    const std::string invalid = why_invalid(problem);
    const bool refused = answer_.outcome == Outcome::invalid_input;
    if (invalid.empty() && (!refused || answer_.invalid == Invalid::not_linear) &&
        (problem.t_max == kInfinity<double> || problem.start_policy == StartPolicy::pass_over)) {
      judgement_.not_asked = true;
      return true;
    }
    if (refused != !invalid.empty()) {
      convict(judgement_.wrong, refused ? "refuses a valid case" : "answers a case that has " + invalid);
    }
    return refused || !invalid.empty();
  }

  void proof() {
    if (answer_.proof) {
      const oracle::RotatingVerdict verdict = oracle::check_rotating_proof(truth_.problem(), *answer_.proof);
      if (!verdict.accepted()) {
        judgement_.proof = ProofState::refused;
        judgement_.false_proof = fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
      } else if (proves(*answer_.proof, answer_)) {
        judgement_.proof = ProofState::accepted;
      }
    }
    // A bracket that claims nothing needs no proof.
    const bool claims = answer_.toi_lower > 0 || answer_.toi_upper < kInfinity<double>;
    if (certified() && asks_for(request_, Request::proof) && claims && judgement_.proof == ProofState::none &&
        !answer_.passed_over) {
      convict(judgement_.unproved,
              answer_.proof ? "its proof claims less than the answer" : "a certified answer without a proof");
    }
  }

  void miss(const RotatingTruth& truth) {
    if (judgement_.open || truth.outcome() == Outcome::miss) return;
    const Enclosure depth = truth.depth();
    judgement_.passed = in_scale(depth.low);
    if (certified() || depth.low > allowed(limits_.may_miss)) {
      convict(judgement_.wrong,
              fmt::format("says miss; there is contact, {} deep, at {:.17g} for the first time",
                          length_text(depth.low), truth.toi_upper()));
    } else {
      (depth.low > limit_ ? judgement_.hidden : judgement_.excused) = true;
    }
  }

  // A hit, or a start in contact.
  void contact(const RotatingTruth& truth) {
    if (truth.outcome() == Outcome::miss) {
      const Enclosure clearance = truth.clearance();
      if (certified() || clearance.low > wide_) {
        convict(judgement_.wrong, fmt::format("says {}; the bodies stay {} apart",
                                              corpus::name_of(answer_.outcome), length_text(clearance.low)));
        return;
      }
      judgement_.excused = true;
    }
    late(truth);
    early(truth);
    bracket(truth);
    own_distance(truth);
    contact_data(truth);
  }

  void not_converged(const RotatingTruth& truth) {
    late(truth);
    early(truth);
    own_distance(truth);
    // Where clearance or depth is below the row's length, a flat C's depth of 0 too, nothing decides.
    const Enclosure decides = truth.outcome() == Outcome::miss ? truth.clearance() : truth.depth();
    if (judgement_.open || !(decides.low > (certified() ? wide_ : limit_))) {
      judgement_.excused = true;
    } else if (!certified()) {
      judgement_.stalled = true;
    } else {
      convict(judgement_.undecided,
              fmt::format("is undecided; {} is {}",
                          truth.outcome() == Outcome::miss ? "the clearance" : "the depth",
                          length_text(decides.low)));
    }
  }

  void late(const RotatingTruth& truth) {
    if (truth.outcome() == Outcome::miss || truth.compare(answer_.toi_lower) <= 0) return;
    const Enclosure depth = truth.depth_before(answer_.toi_lower);
    judgement_.passed = in_scale(depth.low);
    if (certified() || depth.low > allowed(limits_.may_be_late)) {
      convict(judgement_.late, fmt::format("toi_lower {:.17g} is past the contact at {:.17g}, {} deep",
                                           answer_.toi_lower, truth.toi_upper(), length_text(depth.low)));
    } else if (depth.low > limit_) {
      judgement_.hidden = true;
    }
  }

  // toi_upper is a time at which contact is claimed.
  void early(const RotatingTruth& truth) {
    if (!(answer_.toi_upper < kInfinity<double>) || truth.compare(answer_.toi_upper) >= 0) return;
    const Enclosure apart = truth.distance_at(answer_.toi_upper);
    if (certified() || apart.low > wide_) {
      convict(judgement_.early, fmt::format("claims contact by {:.17g}, where the bodies are {} apart",
                                            answer_.toi_upper, length_text(apart.low)));
    }
  }

  // How far the two ends are from a contact.
  void bracket(const RotatingTruth& truth) {
    const Enclosure before = truth.distance_at(answer_.toi_lower);
    Enclosure depth{0, 0};
    // A bracket that ends before the first contact has no depth.
    if (truth.compare(answer_.toi_upper) >= 0) depth = truth.depth_before(answer_.toi_upper);
    judgement_.width = in_scale(std::max(before.low, depth.low));
    if (before.low > wide_ + time_rounding(answer_.toi_lower)) {
      convict(judgement_.wide, fmt::format("at toi_lower {:.17g} the bodies are {} apart", answer_.toi_lower,
                                           length_text(before.low)));
    }
    const double most = std::max(wide_, allowed(limits_.may_be_late));
    if (depth.low > most + time_rounding(answer_.toi_upper)) {
      convict(judgement_.wide, fmt::format("by toi_upper {:.17g} the bodies have met {} deep",
                                           answer_.toi_upper, length_text(depth.low)));
    }
  }

  void contact_data(const RotatingTruth& truth) {
    if (answer_.outcome != Outcome::hit) return;
    const double limit = limits_.contact_kappa * limits_.unit_roundoff * scale_;
    if (asks_for(request_, Request::normal)) normal(truth, limit);
    if (asks_for(request_, Request::witnesses)) witnesses(truth, limit);
  }

  // The normal is the one at toi_lower, and the oracle's question about the first contact: what lies between
  // is granted, the time times the speed of the fastest points.
  void normal(const RotatingTruth& truth, double limit) {
    const double length = answer_.normal.norm();
    if (!(std::abs(length - 1) <= 16 * limits_.unit_roundoff)) {
      convict(judgement_.bad_contact, fmt::format("the normal has length {:.17g}", length));
    } else if (truth.outcome() == Outcome::hit) {
      const double between = std::max(std::abs(answer_.toi_lower - truth.toi_lower()),
                                      std::abs(answer_.toi_lower - truth.toi_upper()));
      const double granted = between * speed_;
      const Enclosure error = truth.normal_error(answer_.normal);
      judgement_.normal = in_scale(std::max(error.low, 0.0));
      if (error.low > limit + granted) {
        convict(judgement_.bad_contact,
                fmt::format("the normal fails to separate the bodies by {}", length_text(error.low)));
      }
    }
  }

  void witnesses(const RotatingTruth& truth, double limit) {
    if (!answer_.point_a.allFinite() || !answer_.point_b.allFinite()) {
      return convict(judgement_.bad_contact, "a witness is not finite");
    }
    for (const char body : {'a', 'b'}) {
      const Vec3<double>& point = body == 'a' ? answer_.point_a : answer_.point_b;
      // Its coordinates round by 2 u of its distance from the origin (docs/guarantees.md).
      const double error = std::max(0.0, truth.distance_from_body(body, answer_.toi_lower, point).low -
                                             2 * limits_.unit_roundoff * point.norm());
      judgement_.witness = std::fmax(judgement_.witness, in_scale(error));
      if (error > limit) {
        convict(judgement_.bad_contact,
                fmt::format("witness {} is {} off its body", body, length_text(error)));
      }
    }
  }

  void own_distance(const RotatingTruth& truth) {
    if (answer_.outcome == Outcome::initially_overlapping) return;
    const Enclosure apart = truth.distance_at(answer_.toi_lower);
    if (apart.low > answer_.distance + limit_) {
      convict(judgement_.wide, fmt::format("says that the bodies are {} apart at toi_lower; they are {}",
                                           length_text(answer_.distance), length_text(apart.low)));
    }
  }

  TurningTruth& truth_;
  const RotatingAnswer& answer_;
  const RotatingLimits& limits_;
  Request request_;
  double scale_ = 0;
  double speed_ = 0;             // of a point of one body relative to one of the other, at most
  double limit_ = 0, wide_ = 0;  // lengths; wide_ also of the row's width
  RotatingJudgement judgement_;
};

}  // namespace

double greatest_speed(const corpus::Case& problem) {
  return fastest(problem.a, problem.spin_a) + fastest(problem.b, problem.spin_b);
}

const RotatingTruth& TurningTruth::bracket() {
  if (!bracket_) bracket_ = std::make_unique<RotatingTruth>(problem_);
  return *bracket_;
}

RotatingLimits limits_of(const engine::RotatingEngineMethod& method, const engine::Guarantee* row,
                         const corpus::Case& seen) {
  if (row == nullptr) {
    return {.kappa = kPlainKappa, .unit_roundoff = method.unit_roundoff, .certified = method.is_certified()};
  }
  return {.kappa = row->kappa(seen),
          .unit_roundoff = method.unit_roundoff,
          .contact_kappa = row->contact_kappa(seen),
          .may_miss = row->may_miss,
          .may_be_late = row->may_be_late,
          .width = row->width,
          .certified = method.is_certified()};
}

const std::string& RotatingJudgement::fault() const {
  static const std::string kNone;
  for (const std::string* fault :
       {&wrong, &late, &early, &wide, &bad_contact, &undecided, &unproved, &false_proof}) {
    if (!fault->empty()) return *fault;
  }
  return kNone;
}

RotatingJudgement judge_rotating(TurningTruth& truth, const RotatingAnswer& answer,
                                 const RotatingLimits& limits, Request request) {
  return RotatingJudge(truth, answer, limits, request)();
}

}  // namespace graze::tool
