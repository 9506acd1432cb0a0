#include "properties/attack/claim_judge.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <variant>

#include "oracles/polytope/linear_program.hpp"
#include "oracles/truth/case_truth.hpp"
#include "oracles/truth/rotating_truth.hpp"
#include "oracles/truth/sampled_contact.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::attack {
namespace {

using corpus::Case;
using Kind = Judgement::Kind;

// Number of single times that are checked, spread over the step.
constexpr int kLooks = 12;
// Slices of time that the rotating oracle may try. A rotation of a few radians takes about two dozen, 200 radians a
// hundred. Bodies that slide along each other, closer than it can tell, would take thousands, milliseconds each, and
// remain undecided.
constexpr int kSlices = 1 << 8;

// The proved facts about the first contact.
struct Known {
  Outcome outcome = Outcome::not_converged;
  bool contact = false;                         // is proved, though maybe not whether at t = 0
  double lower = 0, upper = kInfinity<double>;  // no contact before, contact by
  std::string by;
};

bool turns(const Case& problem) {
  return !problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0);
}

bool has_exact_bodies(const Case& problem) {
  return oracle::is_exact_body(problem.a.shape) && oracle::is_exact_body(problem.b.shape);
}

}  // namespace

struct ClaimJudge::Impl {
  Case problem;
  bool second_opinion, turning;
  std::variant<std::monostate, oracle::CaseTruth, oracle::RotatingTruth> truth;
  bool asked = false, looked = false;
  double latest = 0;  // of the lower bounds that were looked at
  std::optional<Known> known;
  std::optional<oracle::SampledContact> looks;

  Impl(const Case& given, bool second) : problem(given), second_opinion(second), turning(turns(given)) {
    // For rotating bodies the policy has no meaning (StartPolicy), and a chain is about contact itself. The
    // pivot of a body that does not rotate has none either.
    if (turning) {
      problem.start_policy = StartPolicy::report;
    } else {
      problem.spin_a = problem.spin_b = {};
    }
  }

  template <class Truth>
  static Known known_of(const Truth& truth, const std::string& by) {
    Known known{.outcome = truth.outcome(), .by = by};
    known.contact = known.outcome == Outcome::hit || known.outcome == Outcome::initially_overlapping;
    known.lower = truth.toi_lower();
    if (known.outcome == Outcome::miss) known.lower = kInfinity<double>;
    if (known.contact) known.upper = truth.toi_upper();
    return known;
  }

  void ask() {
    if (std::exchange(asked, true)) return;
    try {
      if (turning) {
        const oracle::RotatingTruth& said =
            truth.emplace<oracle::RotatingTruth>(problem, oracle::RotatingTruth::kDefaultWidth, kSlices);
        known = known_of(said, "the rotating oracle");
        if (said.contact_proved()) {
          known->contact = true;
          known->upper = said.toi_upper();
        }
      } else if (law::is_exactly_decided(problem) || !has_exact_bodies(problem)) {
        const oracle::CaseTruth& said = truth.emplace<oracle::CaseTruth>(problem);
        known = known_of(said, said.is_exact() ? "the exact oracle" : "the bracket oracle");
      }
    } catch (const std::invalid_argument&) {
      // A case that no oracle takes: its claims stay undecided.
    }
  }

  // sign(t - TOI), where it is proved.
  [[nodiscard]] int compare(double t) const {
    return std::visit(
        [&]<class T>(const T& said) {
          if constexpr (std::same_as<T, std::monostate>) {
            return 0;
          } else {
            return said.compare(t);
          }
        },
        truth);
  }

  [[nodiscard]] Judgement contradicted(const Claim& claim, const std::string& by) const {
    std::string said = known ? fmt::format("{}, toi in [{}, {}]", law::label_of(known->outcome),
                                           law::decimal(known->lower), law::decimal(known->upper))
                             : "";
    if (looks && std::isfinite(looks->earliest()))
      said += fmt::format("; at t = {} they overlap", law::decimal(looks->earliest()));
    return {Kind::contradicted,
            fmt::format("{}toi in [{}, {}]; by {}: {}",
                        claim.outcome ? std::string(law::label_of(*claim.outcome)) + ", " : std::string(),
                        law::decimal(claim.lower), law::decimal(claim.upper), by, said)};
  }

  // Is there a contact before `lower`, in [0, t_max]?
  bool seen_before(double lower) {
    if (!turning || !(lower > 0)) return false;
    if (!std::exchange(looked, true)) {
      try {
        looks.emplace(problem);
        looks->search(kLooks);
      } catch (const std::invalid_argument&) {
        looks.reset();
      }
    }
    if (!looks) return false;
    if (looks->earliest() < lower) return true;
    if (!(lower <= problem.t_max) || lower <= latest) return false;
    // Just before it, where a bound that is raised by too much fails first.
    latest = lower;
    return looks->look_at(lower * (1 - 0x1p-20)) && looks->earliest() < lower;
  }

  Judgement judge_linear_program(const Claim& claim) const {
    const bool plain = !turning && law::is_polytope(problem) && std::isfinite(problem.t_max) &&
                       problem.start_policy == StartPolicy::report;
    if (!plain) return {Kind::agreed, {}};
    std::optional<oracle::Rational> toi;
    try {
      toi = oracle::toi_by_linear_program(problem);
    } catch (const std::invalid_argument&) {
      return {Kind::agreed, {}};
    }
    const bool late = toi && (std::isinf(claim.lower) || *toi < oracle::Rational(claim.lower));
    const bool early = std::isfinite(claim.upper) && (!toi || *toi > oracle::Rational(claim.upper));
    return late || early ? contradicted(claim, "the linear program") : Judgement{Kind::agreed, {}};
  }

  Judgement judge_within(const Claim& claim, double length) {
    ask();
    const auto* said = std::get_if<oracle::CaseTruth>(&truth);
    if (said == nullptr || said->outcome() == Outcome::not_converged) return {};
    const bool contact = said->outcome() != Outcome::miss;
    if (claim.lower > 0 && contact) {
      // S is convex, and apart from the path up to there: some translation of C by `length` is apart from it,
      // too.
      const bool miss = claim.lower > problem.t_max;
      const double depth = miss ? said->depth().low : said->lateness(claim.lower).low;
      if (depth > length)
        return contradicted(claim, known->by + fmt::format(", {:g} deep of {:g}", depth, length));
    }
    if (claim.upper < kInfinity<double>) {
      // The distance of the path from C is convex in t. Between the bounds it is no less than at an end, less
      // the path from there to that end. Before contact it falls.
      const double from = claim.lower, to = std::min(claim.upper, problem.t_max);
      const double way =
          (problem.b.displacement - problem.a.displacement).norm() * (to - from) * (1 + 0x1p-40);
      double apart = std::max(said->distance_at(from).low, said->distance_at(to).low) - way;
      if (!contact) apart = std::max(apart, said->clearance().low);
      if (contact && said->compare(to) < 0) apart = std::max(apart, said->distance_at(to).low);
      if (!(from <= to) || apart > length)
        return contradicted(claim, known->by + fmt::format(", {:g} apart of {:g}", apart, length));
    }
    return {Kind::agreed, {}};
  }

  Judgement judge(const Claim& claim) {
    if (seen_before(claim.lower)) return contradicted(claim, "a look at one time");
    ask();
    if (!known) return {};
    const bool claims_lower = claim.lower > 0, claims_upper = claim.upper < kInfinity<double>;
    bool open = false;
    if (claims_lower) {
      const bool miss = std::isinf(claim.lower);
      if (miss ? known->contact : known->upper < claim.lower || compare(claim.lower) > 0)
        return contradicted(claim, known->by);
      open |=
          miss ? known->outcome != Outcome::miss : !(claim.lower <= known->lower || compare(claim.lower) < 0);
    }
    if (claims_upper) {
      if (known->outcome == Outcome::miss || compare(claim.upper) < 0) return contradicted(claim, known->by);
      open |= !(known->contact && claim.upper >= known->upper) && compare(claim.upper) <= 0;
    }
    if (claim.outcome) {
      const Outcome said = *claim.outcome, is = known->outcome;
      const bool says_contact = said == Outcome::hit || said == Outcome::initially_overlapping;
      const bool wrong =
          says_contact ? is == Outcome::miss || (known->contact && is != Outcome::not_converged && is != said)
                       : said == Outcome::miss && known->contact;
      if (wrong) return contradicted(claim, known->by);
      open |= said != Outcome::not_converged && is == Outcome::not_converged;
    }
    if (open) return {};
    return second_opinion ? judge_linear_program(claim) : Judgement{Kind::agreed, {}};
  }
};

ClaimJudge::ClaimJudge(const Case& problem, bool second_opinion)
    : impl_(std::make_unique<Impl>(problem, second_opinion)) {}
ClaimJudge::~ClaimJudge() = default;
ClaimJudge::ClaimJudge(ClaimJudge&&) noexcept = default;
ClaimJudge& ClaimJudge::operator=(ClaimJudge&&) noexcept = default;

Judgement ClaimJudge::judge(const Claim& claim) { return impl_->judge(claim); }
Judgement ClaimJudge::judge_within(const Claim& claim, double length) {
  return impl_->judge_within(claim, length);
}

}  // namespace graze::attack
