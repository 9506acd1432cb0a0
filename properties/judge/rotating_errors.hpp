// Judges an answer to a rotating case by the oracle: the guarantee of the method, and the errors that an answer may
// have. The laws check one error each, `graze certify` all of them. judge.hpp is the same for linear casts.
//
// Notation   limit = kappa u scale, a length: the depth of a contact that may be missed, or the distance of the bodies
//            where contact is claimed.
//            wide = the larger of that and the width that the limits, or the question, grants a bracket.
// Tier certified is compared with the truth itself: any proved contradiction is a fault. Enclosures are compared by the
// end that favours the method. If the oracle is undecided, no verdict is wrong.
#pragma once

#include <limits>
#include <string>

#include "engines/guarantees.hpp"
#include "oracles/truth/rotating_truth.hpp"
#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"

namespace graze::law {

// The proved size of an error, a length. NaN if the answer or the truth has no such length.
struct RotatingError {
  double length = std::numeric_limits<double>::quiet_NaN();
  double over_limit = std::numeric_limits<double>::quiet_NaN();  // of a width: over what it may be
  std::string fault = {};  // why it is more than the row leaves open, or empty
};

// Contact or no contact: the depth of a contact that is denied, or the clearance where contact is claimed.
[[nodiscard]] RotatingError verdict_error(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                          const Limits& limits);
// toi_lower past the first contact: the depth before it.
[[nodiscard]] RotatingError late_error(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                       const Limits& limits);
// toi_upper where there has been no contact yet: the distance there.
[[nodiscard]] RotatingError early_error(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                        const Limits& limits);
// For a contact: the larger of the bodies' distance at toi_lower and their depth before toi_upper.
[[nodiscard]] RotatingError width_error(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                        const Limits& limits);
// The distance at toi_lower, against the one that the answer states.
[[nodiscard]] RotatingError distance_error(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                           const Limits& limits);
// not_converged: the clearance or the depth that decides. A fault of tier certified if that is above `wide`.
[[nodiscard]] RotatingError undecided_error(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                            const Limits& limits);
// For a hit: the length by which the normal fails to separate the bodies at first contact. It is the normal at
// toi_lower, from where the bodies continue to first contact. The travel of that time at their top speed is granted.
[[nodiscard]] RotatingError normal_error(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                         const Limits& limits);
// For a hit: the distance of a witness from its body at toi_lower, the larger of the two.
[[nodiscard]] RotatingError witness_error(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                          const Limits& limits);

// The distance of the bodies at toi_lower, if the certified tier leaves the verdict open before the motion ends. It
// must be within the width. The answer must also have a distance, a normal and points, so that a caller can treat it as
// contact.
[[nodiscard]] RotatingError open_error(const oracle::RotatingTruth& truth, const corpus::Case& problem,
                                       const engine::Answer& answer, const Limits& limits);

// The first fault of verdict, times and width, or empty.
[[nodiscard]] std::string any_fault(const oracle::RotatingTruth& truth, const engine::Answer& answer,
                                    const Limits& limits);

}  // namespace graze::law
