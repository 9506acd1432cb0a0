// Shared by the laws of the queries: a question in the scalar of its method, the tolerance of its guarantee, and the
// decision about which of two different answers is at fault.
//
// Notation   limit = kappa u scale of the method and the question, a length: an answer is true of some C'
//            within it.   gap: the distance, or minus the depth.   h(n) = max over C of n.c.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>

#include "engines/method.hpp"
#include "properties/judge/judge.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

struct Question {
  corpus::Case seen;  // its query set, with every number one of the method's scalar
  double u = 0;       // unit roundoff of the scalar
  double limit = 0;
};

// Made from a linear case (question_for), for a query that may differ from the method's own. Nothing if a number leaves
// the domain, or tier exact does not answer it.
[[nodiscard]] std::optional<Question> question_of(const corpus::Case& problem, const engine::Method& method);
// The same question after an edit. Nothing if its numbers are not exact in the scalar, or leave the domain.
[[nodiscard]] std::optional<Question> requestioned(corpus::Case edited, const engine::Method& method);

// The method's limit for a question in its scalar.
[[nodiscard]] double limit_of(const engine::Method& method, const corpus::Case& seen);
// By how much normals and witnesses may be off: tier exact has no limit, but rounds these.
[[nodiscard]] double contact_limit_of(const engine::Method& method, const Question& question);

// The result of a law that is called for a query that it does not cover.
[[nodiscard]] LawResult other_query();
[[nodiscard]] LawResult no_question();

// initially_overlapping or hit.
[[nodiscard]] bool in_contact(const engine::Answer& answer);
// The bracket of the gap that an answer to distance or penetration claims, or nothing. Distance in contact states only
// gap <= 0, penetration apart only gap >= 0.
[[nodiscard]] engine::Interval gap_of(const engine::Answer& answer);
// The length by which two brackets fail to meet, or 0 if they do.
[[nodiscard]] double apart(const engine::Interval& one, const engine::Interval& other);

// The first compares times within the rounding of the two. The second compares verdicts and times.
[[nodiscard]] bool same_time(const engine::Interval& one, const engine::Interval& other, double u);
[[nodiscard]] bool same_line(const engine::Answer& one, const engine::Answer& other, double u);

// h(n) of the bodies as they stand at t = 0, in rounded doubles, and the error bound of the rounding.
struct Reach {
  double value = 0, error = 0;
};
[[nodiscard]] Reach reach(const corpus::Case& seen, const Vec3<double>& n);
// The same of one body as it stands, without its position: max of n.x.
[[nodiscard]] Reach reach(const Body<double>& body, const Vec3<double>& n);

// The answer judged by the exact oracle and the method's guarantee. A method without one promises nothing. Returns
// nothing if the oracle does not take the bodies: curved ones, many vertices.
[[nodiscard]] std::optional<Judgement> oracle_judgement(const engine::Method& method,
                                                        const corpus::Case& seen,
                                                        const engine::Answer& answer, double tolerance = 0);

struct AskedQuery {
  std::string_view name;
  const engine::Method& method;
  const corpus::Case& problem;
  const engine::Answer& answer;
};
// The oracle judges every answer in turn, and the first with a fault is named. Without a fault the law holds: the
// questions are ill-conditioned. The label is "undecided" if the oracle does not take a case.
[[nodiscard]] LawResult arbitrate(std::initializer_list<AskedQuery> asked, std::string_view disagreement);

}  // namespace graze::law
