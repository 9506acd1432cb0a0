// The law of the checker of proofs itself, by proofs that claim too much. The claims, and the cases to which they do
// not apply, are in checker.cpp and the table in linear.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "oracles/checker/check_proof.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;

namespace {

// Half a proof: the other half claims nothing.
Proof lower_half(const Proof& proof, double toi_lower) {
  Proof out = proof;
  out.toi_lower = toi_lower;
  out.toi_upper = kInfinity<double>;
  out.portal_size = 0;
  return out;
}
Proof upper_half(const Proof& proof, double toi_upper) {
  Proof out = proof;
  out.toi_lower = 0;
  out.has_axis = false;
  out.toi_upper = toi_upper;
  return out;
}

// About an accepted proof everything here is false, whatever the TOI is: between its two bounds.
class Overclaims {
 public:
  Overclaims(const Case& seen, const Proof& proof) : seen_(seen), proof_(proof) {}

  // The first false claim that the checker accepts, or empty.
  [[nodiscard]] std::string accepted() {
    if (proof_.toi_lower == kInfinity<double>) {
      contact_after_all();
    } else if (proof_.toi_upper < kInfinity<double>) {
      later_than_contact();
      no_contact();
      if (proof_.toi_lower > 0) {
        earlier_than_proved();
        behind_the_start();
      }
    }
    return fault_;
  }

 private:
  void try_claim(const char* what, const Case& problem, const Proof& claim) {
    if (!fault_.empty() || !oracle::check_proof(problem, claim).accepted()) return;
    fault_ = fmt::format("the checker believes {}, lower {} upper {}, though it accepted lower {} upper {}",
                         what, decimal(claim.toi_lower), decimal(claim.toi_upper), decimal(proof_.toi_lower),
                         decimal(proof_.toi_upper));
  }

  // A miss has no portal, whichever points are named.
  void contact_after_all() {
    Proof claim = upper_half(proof_, kInfinity<double>);
    claim.toi_upper = std::min(seen_.t_max, std::numeric_limits<double>::max());
    for (int size = 1; size <= 4; ++size) {
      claim.portal_size = size;
      for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
        claim.portal[i].a.vertex = claim.portal[i].b.vertex = static_cast<std::uint32_t>(i % 2);
      }
      for (const bool of_cores : {false, true}) {
        claim.of_cores = of_cores;
        try_claim("a portal of a miss", seen_, claim);
      }
    }
  }
  void later_than_contact() {
    const double late = std::nextafter(proof_.toi_upper, kInfinity<double>);
    try_claim("a lower bound above the upper one", seen_, lower_half(proof_, late));
  }
  void no_contact() {
    const Proof claim = lower_half(proof_, kInfinity<double>);
    try_claim("a miss where there is contact", seen_, claim);
    Case ends_there = seen_;
    ends_there.t_max = proof_.toi_upper;
    try_claim("a miss where contact is at the end at the latest", ends_there, claim);
  }
  void earlier_than_proved() {
    const double early = std::nextafter(proof_.toi_lower, 0.0);
    try_claim("an upper bound below the lower one", seen_, upper_half(proof_, early));
    Case ends_before = seen_;
    ends_before.t_max = early;
    try_claim("contact after the end of the path", ends_before, upper_half(proof_, proof_.toi_upper));
  }
  // Shapes ahead of bodies that are apart lie behind them when they move the other way.
  void behind_the_start() {
    Case away = seen_;
    away.a.displacement = -seen_.a.displacement;
    away.b.displacement = -seen_.b.displacement;
    try_claim("contact behind the start", away, upper_half(proof_, proof_.toi_upper));
  }

  const Case& seen_;
  const Proof& proof_;
  std::string fault_;
};

LawResult overclaims_are_refused(const Case& problem, const engine::Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  const engine::Answer answer = method.ask(seen, {.request = Request::proof});
  if (!answer.proof || !oracle::check_proof(seen, *answer.proof).accepted())
    return not_applicable("no proof that is accepted");
  std::string fault = Overclaims(seen, *answer.proof).accepted();
  if (!fault.empty()) return broken(std::move(fault));
  return holds({label_of(answer.outcome)});
}

}  // namespace

std::vector<Law> linear_checker_laws() {
  return {
      {"overclaims_are_refused",
       "An accepted proof is not accepted for a claim beyond the room that its bounds leave.", Needs::proof,
       &overclaims_are_refused},
  };
}

}  // namespace graze::law
