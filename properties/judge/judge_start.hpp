// What an answer says of a start in contact beside the verdict: its normal and its witnesses.
//
// They have no one meaning. Engines hand out the direction of least penetration, the one against the motion, the
// outward normal of A at some point, or what a search stopped at; and points of the surfaces, points deep within, or
// one halfway. Each of them is of use to somebody who knows which it is. So only what all of them share is held
// against an answer, of bodies that touch as of bodies that overlap:
//
//   a normal is a unit vector             (none, or one of zeros, says that there is none)
//   a witness of a body is a point of it  (in it or on it, within the limit of witnesses)
//
// Where a normal points is judged of an engine that promises it. Of least penetration, with C = A - B at t = 0, the
// target distance counted, and h(n) the largest n.c over C: B moved along n leaves A after the length h(n), and after
// no less than the depth, so that h(n) - depth is the error, a length. Of bodies that touch the depth is 0, and n is then
// one that separates them. Bodies that do not touch, and are said to by less than the limit, have no such error.
// Our own methods document that they hand out neither.
#pragma once

#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"
#include "properties/judge/truth.hpp"

namespace graze::law {

// Into judgement.bad_contact and its errors, as far as requested, of a cast's answer initially_overlapping.
void judge_start(Judgement& judgement, Truth& truth, const engine::Answer& answer,
                 const engine::Method& method, const Limits& limits, Request request);

}  // namespace graze::law
