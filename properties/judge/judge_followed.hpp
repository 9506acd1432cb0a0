// Judges an answer to a rotating case with the start policy pass_over whose bodies are in contact at t = 0.
//
// Notation   d = the depth up to which a contact is followed: the method's limit, of tier certified 4,096 u scale, u of
//            double (docs/explanation/rotating.md);   T the end of the motion.
// The policy's first time, for contact that is deeper than x or new after a gap of more than x, depends on x. A method is
// right with any x from d / 8 to d, so the judge holds an answer to what is true for all of them:
//   toi_lower, a miss     at most d deep until then
//   toi_upper             by then deeper than d / 8; or in contact, after a gap of more than d / 8 in between
//   a start reported      deeper than d / 8
// The last two are looked for: depths are bounded by the oracle on all of [0, t], and a gap is sought at many times, close
// to both ends of the bracket above all. Not seen is not proved to be absent, but no right answer hides it: the gap before
// a new contact reaches back from toi_lower.
#pragma once

#include "engines/method.hpp"
#include "oracles/truth/rotating_truth.hpp"
#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"

namespace graze::law {

// The same motion with every start in contact reported.
[[nodiscard]] corpus::Case reporting(corpus::Case problem);
// What is true of its times, from a contact at t = 0 on; none is searched for.
[[nodiscard]] oracle::RotatingTruth truth_from_start(const corpus::Case& problem);
[[nodiscard]] double followed_depth(const Limits& limits);

// Into the judgement. `truth`: truth_from_start().
void judge_followed(Judgement& judgement, const oracle::RotatingTruth& truth, const corpus::Case& problem,
                    const engine::Answer& answer, const Limits& limits, Request request);

}  // namespace graze::law
