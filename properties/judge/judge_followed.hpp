// Judges an answer to a rotating case with the start policy pass_over whose bodies are in contact at t = 0.
//
// Notation   d = the depth up to which a contact is followed: the method's limit, in tier certified 4,096 u scale, u of
//            double (docs/explanation/rotating.md).   T the end of the motion.
// The policy's first time depends on a length x: contact counts if it is deeper than x or new after a gap of more than
// x. A method is right with any x from d / 8 to d. The judge therefore checks only facts that are true for all of them:
//   toi_lower, a miss     at most d deep until then.
//   toi_upper             by then deeper than d / 8, or in contact after a gap of more than d / 8 in between.
//   a start reported      deeper than d / 8.
// The judge searches for the last two. The oracle bounds depths on all of [0, t], and a gap is sought at many times,
// mostly close to both ends of the bracket. A gap that is not found is not proved to be absent. No right answer hides
// it, however: the gap before a new contact reaches back from toi_lower.
#pragma once

#include "engines/method.hpp"
#include "oracles/truth/rotating_truth.hpp"
#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"

namespace graze::law {

// The same motion with every start in contact reported.
[[nodiscard]] corpus::Case reporting(corpus::Case problem);
// The truth about its times, from a contact at t = 0 on. It searches for none.
[[nodiscard]] oracle::RotatingTruth truth_from_start(const corpus::Case& problem);
[[nodiscard]] double followed_depth(const Limits& limits);

// Into the judgement. `truth`: truth_from_start().
void judge_followed(Judgement& judgement, const oracle::RotatingTruth& truth, const corpus::Case& problem,
                    const engine::Answer& answer, const Limits& limits, Request request);

}  // namespace graze::law
