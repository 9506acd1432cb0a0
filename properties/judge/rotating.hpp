// Judges an answer to a rotating case by the oracle: the row that the method is held to, and the errors that
// an answer may have. The laws ask for one error each, `graze certify` for all of them. judge.hpp is the same
// for linear casts.
//
// Notation   limit = kappa u scale, a length: how deep a contact may be that goes unseen, or how far apart
//            the bodies where contact is claimed.
//            wide = the larger of that and the width that the row, or the question, grants a bracket.
// Tier certified is held to the truth itself: any proved contradiction is a fault. Enclosures are compared by
// the end that favours the method; where the oracle is undecided, no verdict is wrong.
#pragma once

#include <limits>
#include <string>

#include "engines/guarantees.hpp"
#include "engines/rotating.hpp"
#include "oracles/truth/rotating_truth.hpp"

namespace graze::law {

// The scale of DESIGN's meanings, in rounded doubles.
[[nodiscard]] double scale_of(const corpus::Case& problem);
// No point of one body moves faster relative to one of the other (length per unit of t): the displacement,
// and the rotation at the arm of the farthest corner of the body's bounds from the pivot.
[[nodiscard]] double top_speed_of(const corpus::Case& problem);

struct RotatingRow {
  double limit = 0, wide = 0;
  double contact_limit = 0;  // of normals and witnesses
  engine::Unseen may_miss = engine::Unseen::nothing, may_be_late = engine::Unseen::nothing;
  bool strict = false;  // tier certified
  double unit_roundoff = 0, speed = 0, scale = 0;
  // Of a time of the answer, as a length: it is a number of the method's scalar, rounded outward by 2 u of
  // itself.
  [[nodiscard]] double rounding_at(double t) const { return 2 * unit_roundoff * t * speed; }
};
// `tolerance`: as asked, over scale. `slack`: a length that the question itself is off by.
[[nodiscard]] RotatingRow row_of(const engine::RotatingEngineMethod& method, const engine::Guarantee& row,
                                 const corpus::Case& seen, double scale, double tolerance = 0,
                                 double slack = 0);
// By the project's own table; a method without a row promises nothing.
[[nodiscard]] RotatingRow row_of(const engine::RotatingEngineMethod& method, const corpus::Case& seen,
                                 double tolerance = 0, double slack = 0);

[[nodiscard]] bool claims_contact(const engine::RotatingAnswer& answer);

// What is proved of an error, a length; NaN where the answer or the truth has no such length.
struct RotatingError {
  double length = std::numeric_limits<double>::quiet_NaN();
  std::string fault = {};  // why it is more than the row leaves open, or empty
};

// Contact or no contact: the depth of a contact that is denied, or the clearance where contact is claimed.
[[nodiscard]] RotatingError verdict_error(const oracle::RotatingTruth& truth,
                                          const engine::RotatingAnswer& answer, const RotatingRow& row);
// toi_lower past the first contact: the depth before it.
[[nodiscard]] RotatingError late_error(const oracle::RotatingTruth& truth,
                                       const engine::RotatingAnswer& answer, const RotatingRow& row);
// toi_upper where there has been no contact yet: the distance there.
[[nodiscard]] RotatingError early_error(const oracle::RotatingTruth& truth,
                                        const engine::RotatingAnswer& answer, const RotatingRow& row);
// Of a contact: the larger of the bodies' distance at toi_lower and their depth before toi_upper.
[[nodiscard]] RotatingError width_error(const oracle::RotatingTruth& truth,
                                        const engine::RotatingAnswer& answer, const RotatingRow& row);
// The distance at toi_lower, against the one that the answer states.
[[nodiscard]] RotatingError distance_error(const oracle::RotatingTruth& truth,
                                           const engine::RotatingAnswer& answer, const RotatingRow& row);
// not_converged: the clearance or the depth that decides. A fault of tier certified where that is above
// `wide`.
[[nodiscard]] RotatingError undecided_error(const oracle::RotatingTruth& truth,
                                            const engine::RotatingAnswer& answer, const RotatingRow& row);
// Of a hit: by how much the normal fails to separate the bodies at first contact. It is the one at toi_lower,
// from where the bodies go on to first contact: that long at their top speed is granted.
[[nodiscard]] RotatingError normal_error(const oracle::RotatingTruth& truth,
                                         const engine::RotatingAnswer& answer, const RotatingRow& row);
// Of a hit: how far a witness is off its body at toi_lower, the larger of the two.
[[nodiscard]] RotatingError witness_error(const oracle::RotatingTruth& truth,
                                          const engine::RotatingAnswer& answer, const RotatingRow& row);

// The first fault of verdict, times and width; or empty.
[[nodiscard]] std::string any_fault(const oracle::RotatingTruth& truth, const engine::RotatingAnswer& answer,
                                    const RotatingRow& row);

}  // namespace graze::law
