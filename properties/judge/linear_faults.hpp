// What the laws share: the row that a method is held to, the oracle's answer kept for the case at hand, and
// the faults that an answer may have by it.
//
// Notation   u the unit roundoff of the method, kappa its row of the guarantees, scale as the oracle gives
// it;
//            the bound of a method on a case is kappa u scale, a length.
// A fault is a printable reason, or empty. Enclosures are compared by the end that favours the method: a few
// units in the last place of an error are not what a law is about.
#pragma once

#include "oracles/truth/case_truth.hpp"
#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"
#include "properties/judge/truth.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

// kappa u scale. Of tier exact, whose kappa is 0: what rounding the times of a hit outward may cost, 2 u TOI
// |v|; the law exact_equals_oracle leaves it nothing. Of tier certified: the width of its row, and for float
// that rounding besides.
[[nodiscard]] double bound_of(const engine::Method& method, const corpus::Case& problem);
// What a verdict, a late lower end and an early upper end are held to: the same, but of tier certified, whose
// bracket holds without condition, nothing.
[[nodiscard]] double proved_bound_of(const engine::Method& method, const corpus::Case& problem);
// Of normals and witnesses.
[[nodiscard]] double contact_bound_of(const engine::Method& method, const corpus::Case& problem);

// Whether an oracle takes the case: every linear one of valid shapes.
[[nodiscard]] bool has_truth(const corpus::Case& problem);
// Its answer, where it has one; the last few are kept, since a campaign asks many laws about one case.
[[nodiscard]] const oracle::CaseTruth& truth_of(const corpus::Case& problem);
// The bracket oracle spoke and left the verdict open: bodies that touch within 1e-20 of the scale, or flat
// ones in one plane.
[[nodiscard]] bool is_undecided(const oracle::CaseTruth& truth);

// A cast that the methods know, in the domain: the laws speak about nothing else (but the door's).
[[nodiscard]] bool is_linear_question(const corpus::Case& problem);
// One that this method answers: tier exact does not answer all of them.
[[nodiscard]] bool is_question_for(const engine::Method& method, const corpus::Case& seen);

// Contact or no contact, wrong by more than the bound in clearance or depth. Says nothing of a verdict that
// the oracle left undecided; the faults below stand there too, by what is proved of distances and depths.
[[nodiscard]] std::string verdict_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                        double bound);
// toi_lower late: the path over [0, toi_lower) goes deeper than the bound.
[[nodiscard]] std::string late_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                     double bound);
// toi_upper early: before the TOI, and farther from contact than the bound.
[[nodiscard]] std::string early_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                      double bound);
// Backward error of either end of a hit's bracket beyond the bound.
[[nodiscard]] std::string time_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                     double bound);
// n is no supporting normal of C, neither at the true contact nor at the contact that the answer claims: at a
// graze the two may be far apart, and each is right for some convex set within the bound of C.
[[nodiscard]] std::string normal_fault(const corpus::Case& problem, const engine::Answer& answer,
                                       const Vec3<double>& n, double bound);
// not_converged, though clearance or depth exceeds the bound: what tier certified promises to decide.
[[nodiscard]] std::string undecided_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                          double bound);
// Tier certified: an answer whose toi_lower is far from contact, by more than the bound, and before the end of the motion.
[[nodiscard]] std::string lower_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                      double t_max, double bound);
// Tier certified, not_converged, normal and witnesses requested: what keeps a caller from taking it for contact. A
// normal that is not a unit vector, a witness off its body, a distance above the bound.
[[nodiscard]] std::string open_answer_fault(const oracle::CaseTruth& truth, const engine::Method& method,
                                            const corpus::Case& problem, const engine::Answer& answer,
                                            double bound);
// The first fault of verdict and times.
[[nodiscard]] std::string any_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                    double bound);
// The same by the method's own row.
[[nodiscard]] std::string any_fault(const engine::Method& method, const corpus::Case& problem,
                                    const engine::Answer& answer);

[[nodiscard]] LawResult holds(std::vector<std::string_view> labels = {});
[[nodiscard]] LawResult broken(std::string reason);
[[nodiscard]] LawResult not_applicable(std::string why);
// The case that a law needs the truth of is taken by no oracle, or left undecided by the bracket oracle (then
// with the label "undecided"): not applicable, and why. Nothing where the truth is known.
[[nodiscard]] std::optional<LawResult> without_truth(const corpus::Case& problem);
// The same for the laws that still judge by the exact oracle alone (they say why).
[[nodiscard]] std::optional<LawResult> without_exact_truth(const corpus::Case& problem);

// Two answers that should be the same contact: equal verdicts, and brackets that overlap or lie within a few
// u of each other. False only raises a question.
[[nodiscard]] bool agree(const engine::Answer& one, const engine::Answer& other, double u);

// A question, what the method said to it, and how a reason calls it.
struct Asked {
  std::string_view name;
  const corpus::Case& problem;
  const engine::Answer& answer;
};
// The oracle looks at every answer in turn; the first with a fault is named. None: the questions are
// ill-conditioned, and every answer is within its row.
[[nodiscard]] LawResult arbitrate(const engine::Method& method, std::initializer_list<Asked> asked,
                                  std::string_view disagreement);

}  // namespace graze::law
