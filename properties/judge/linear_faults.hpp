// Shared by the laws: the guarantee that applies to a method, the oracle's answer kept for the current case, and the
// faults that an answer may have by it.
//
// Notation   u the unit roundoff of the method, kappa of its guarantee, scale as the oracle gives it.
//            The bound of a method on a case is kappa u scale, a length.
// A fault is a printable reason, or empty. Enclosures are compared by the end that favours the method: an error of a
// few units in the last place does not break a law.
#pragma once

#include "oracles/truth/case_truth.hpp"
#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"
#include "properties/judge/truth.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

// kappa u scale. For tier exact, whose kappa is 0, it is the cost of rounding the times of a hit outward, 2 u TOI |v|.
// The law exact_equals_oracle grants nothing. For tier certified it is the width of its guarantee, and for float that
// rounding as well.
[[nodiscard]] double bound_of(const engine::Method& method, const corpus::Case& problem);
// The bound for a verdict, a late lower end and an early upper end. It is the same, except for tier certified. Its
// bracket holds without condition, so the bound is 0.
[[nodiscard]] double proved_bound_of(const engine::Method& method, const corpus::Case& problem);
// The bound for normals and witnesses.
[[nodiscard]] double contact_bound_of(const engine::Method& method, const corpus::Case& problem);

// Does an oracle take the case? It takes every linear one of valid shapes.
[[nodiscard]] bool has_truth(const corpus::Case& problem);
// Its answer, if it has one. The last few are kept, since a campaign checks many laws on one case.
[[nodiscard]] const oracle::CaseTruth& truth_of(const corpus::Case& problem);
// The bracket oracle answered and left the verdict open: bodies that touch within 1e-20 of the scale, or flat ones in
// one plane.
[[nodiscard]] bool is_undecided(const oracle::CaseTruth& truth);

// A cast that the methods know, in the domain. The laws apply to nothing else (except those of input validation).
[[nodiscard]] bool is_linear_question(const corpus::Case& problem);
// One that this method answers: tier exact does not answer all of them.
[[nodiscard]] bool is_question_for(const engine::Method& method, const corpus::Case& seen);

// Contact or no contact, wrong by more than the bound in clearance or depth. A verdict that the oracle left undecided
// has no such fault. The faults below apply there too, by the proved distances and depths.
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
// n is not a supporting normal of C, neither at the true contact nor at the claimed one. At a graze the two may be far
// apart, and each is right for some convex set within the bound of C.
[[nodiscard]] std::string normal_fault(const corpus::Case& problem, const engine::Answer& answer,
                                       const Vec3<double>& n, double bound);
// not_converged, though clearance or depth exceeds the bound. Tier certified guarantees to decide such cases.
[[nodiscard]] std::string undecided_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                          double bound);
// Tier certified: an answer whose toi_lower is far from contact, by more than the bound, and before the end of the
// motion.
[[nodiscard]] std::string lower_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                      double t_max, double bound);
// Tier certified, not_converged, normal and witnesses requested: faults that keep a caller from treating the answer as
// contact. They are a normal that is not a unit vector, a witness off its body, and a distance above the bound.
[[nodiscard]] std::string open_answer_fault(const oracle::CaseTruth& truth, const engine::Method& method,
                                            const corpus::Case& problem, const engine::Answer& answer,
                                            double bound);
// The first fault of verdict and times.
[[nodiscard]] std::string any_fault(const oracle::CaseTruth& truth, const engine::Answer& answer,
                                    double bound);
// The same by the method's own guarantee.
[[nodiscard]] std::string any_fault(const engine::Method& method, const corpus::Case& problem,
                                    const engine::Answer& answer);

[[nodiscard]] LawResult holds(std::vector<std::string_view> labels = {});
[[nodiscard]] LawResult broken(std::string reason);
[[nodiscard]] LawResult not_applicable(std::string why);
// A law needs the truth of the case, but no oracle takes it, or the bracket oracle leaves it undecided (then with the
// label "undecided"). The result is not applicable, with the reason. Nothing if the truth is known.
[[nodiscard]] std::optional<LawResult> without_truth(const corpus::Case& problem);
// The same for the laws that still judge by the exact oracle alone (they say why).
[[nodiscard]] std::optional<LawResult> without_exact_truth(const corpus::Case& problem);

// Two answers that should be the same contact: equal verdicts, and brackets that overlap or lie within a few
// u of each other. False only raises a question.
[[nodiscard]] bool agree(const engine::Answer& one, const engine::Answer& other, double u);

// A question, the method's answer, and its name in a reason.
struct Asked {
  std::string_view name;
  const corpus::Case& problem;
  const engine::Answer& answer;
};
// The oracle checks every answer in turn, and the first with a fault is named. If none has one, the questions are
// ill-conditioned, and every answer is within its guarantee.
[[nodiscard]] LawResult arbitrate(const engine::Method& method, std::initializer_list<Asked> asked,
                                  std::string_view disagreement);

}  // namespace graze::law
