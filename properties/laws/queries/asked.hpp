// What the laws of the queries share: a question in the scalar of its method, what its row allows there, and
// who is at fault where two answers differ.
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
  corpus::Case seen;  // its query set; every number one of the method's scalar
  double u = 0;       // unit roundoff of the scalar
  double limit = 0;
};

// Made from a linear case (question_for), for a query that may be another than the method's own. Nothing
// where a number leaves the domain, or tier exact does not answer it.
[[nodiscard]] std::optional<Question> question_of(const corpus::Case& problem, const engine::Method& method);
// The same numbers, edited since: nothing where they are none of the scalar's, or leave the domain.
[[nodiscard]] std::optional<Question> requestioned(corpus::Case edited, const engine::Method& method);

// The method's limit for a question in its scalar.
[[nodiscard]] double limit_of(const engine::Method& method, const corpus::Case& seen);

// What a law is broken by where it is called for a query that it is not about.
[[nodiscard]] LawResult other_query();
[[nodiscard]] LawResult no_question();

// initially_overlapping or hit.
[[nodiscard]] bool in_contact(const engine::Answer& answer);
// The bracket of the gap that an answer to distance or penetration claims; nothing where it claims none:
// distance in contact says only gap <= 0, penetration apart only gap >= 0.
[[nodiscard]] engine::Interval gap_of(const engine::Answer& answer);
// By how much two brackets fail to meet; 0 where they do.
[[nodiscard]] double apart(const engine::Interval& one, const engine::Interval& other);

// The same time, but for the rounding of the two; the same verdict, and the same times.
[[nodiscard]] bool same_time(const engine::Interval& one, const engine::Interval& other, double u);
[[nodiscard]] bool same_line(const engine::Answer& one, const engine::Answer& other, double u);

// h(n) of the bodies as they stand at t = 0, in rounded doubles, and how far the rounding may have it off.
struct Reach {
  double value = 0, error = 0;
};
[[nodiscard]] Reach reach(const corpus::Case& seen, const Vec3<double>& n);
// The same of one body as it stands, without its position: max of n.x.
[[nodiscard]] Reach reach(const Body<double>& body, const Vec3<double>& n);

// The answer judged by the exact oracle and the method's row; a method without one promises nothing. Nothing
// where the oracle does not take the bodies: curved ones, many vertices.
[[nodiscard]] std::optional<Judgement> oracle_judgement(const engine::Method& method,
                                                        const corpus::Case& seen,
                                                        const engine::Answer& answer, double tolerance = 0);

struct AskedQuery {
  std::string_view name;
  const engine::Method& method;
  const corpus::Case& problem;
  const engine::Answer& answer;
};
// The oracle looks at every answer in turn; the first with a fault is named. None, and it holds: the
// questions are ill-conditioned. With the label "undecided" where the oracle does not take a case.
[[nodiscard]] LawResult arbitrate(std::initializer_list<AskedQuery> asked, std::string_view disagreement);

}  // namespace graze::law
