// Judges the parts of an answer to a start in contact beside the verdict: its normal and its witnesses.
//
// These parts have no single meaning. As a normal, engines return the direction of least penetration, the one against
// the motion, the outward normal of A at some point, or the last direction of a search. As witnesses they return points
// of the surfaces, points deep within, or one halfway. Each is useful to callers that know which one it is. So only the
// properties that all of them share are checked, for touching and for overlapping bodies:
//
//   a normal is a unit vector             (a missing or zero normal means that the engine has none)
//   a witness of a body is a point of it  (in it or on it, within the limit of witnesses)
//
// The direction of a normal is judged only for an engine that guarantees it. For least penetration, let C = A - B at t
// = 0, with the target distance counted, and h(n) the largest n.c over C. B moved along n leaves A after the length
// h(n), and after no less than the depth, so h(n) - depth is the error, a length. For touching bodies the depth is 0,
// and n is then a direction that separates them. Bodies that do not touch, but are reported as touching within the
// limit, have no such error. Our own methods document that they return neither.
#pragma once

#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"
#include "properties/judge/truth.hpp"

namespace graze::law {

// Into judgement.bad_contact and its errors, for the requested parts of a cast's answer initially_overlapping.
void judge_start(Judgement& judgement, Truth& truth, const engine::Answer& answer,
                 const engine::Method& method, const Limits& limits, Request request);

}  // namespace graze::law
