// The expected answer of a case, by the exact oracle. The corpus stores it, and a later run derives it again.
#pragma once

#include <stdexcept>

#include "corpus/case.hpp"

namespace graze::oracle {

// A question that no oracle here answers: too close to call at any width, or out of scope.
struct Undecided : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// Fills `by`, outcome and, by the query, numbers that are the nearest doubles unless it says otherwise:
//   cast                toi_lower, toi_upper (the doubles on either side), toi_exact (empty if irrational).
//                       For bodies without rotation also scale, rounded up, and clearance of a miss or
//                       path_depth of a contact, rounded down (linear_truth.hpp has their meaning)
//   line                the same, and t_in, t_out if the line meets the CSO
//   swept_overlap       no number. The outcome is hit, for contact at any t in [0, T], 0 included, or miss
//   overlap, distance   distance at t = 0, the target distance not counted
//   penetration         depth, and normal if there is just one, unit. Apart: distance
//   penetration_along   depth: the length of the move along `direction`. Apart: distance
// The last four queries are for t = 0, their outcome is initially_overlapping or miss, and penetration
// ignores the target distance. start_policy affects the outcome and time of casts and lines alone.
//
// Throws Undecided for questions that the oracles do not decide:
//   curved shapes     a clearance or depth below 1e-30 of scale, and every penetration. The TOI is given by the
//                     exact one's neighbours except at a graze, where it is a bracket whose width follows from
//                     1e-30 of scale. Clearance and depth are lower bounds, of depths up to a sixteenth below.
//                     They are missing for a graze that a closed form decides and no bracket does
//   rotating bodies   in casts and swept_overlap, a clearance or depth below 1e-14 of scale, a search beyond
//                     the budget of rotating_truth.hpp, an infinite t_max, and a line. toi_lower and toi_upper
//                     are a bracket whose width follows from 1e-14 of scale. With the policy pass_over, a contact
//                     at the start that gets between 1e-14 and 1e-12 of scale deep, or is new without that depth.
//                     The bracket is from the one depth to the other
[[nodiscard]] corpus::Expect derive_expectation(const corpus::Case& problem);

}  // namespace graze::oracle
