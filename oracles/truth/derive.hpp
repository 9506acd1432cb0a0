// The expected answer of a case, by the exact oracle: what the corpus stores and a later run derives again.
#pragma once

#include <stdexcept>

#include "corpus/case.hpp"

namespace graze::oracle {

// What no oracle here answers: too close to call at any width, or not asked of it.
struct Undecided : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// Fills `by`, outcome and, by the query, numbers that are the nearest doubles unless it says otherwise:
//   cast                toi_lower, toi_upper (the doubles on either side), toi_exact (empty if irrational);
//                       of bodies that do not turn also scale, rounded up, and clearance of a miss or
//                       path_depth of a contact, rounded down (linear_truth.hpp has their meaning)
//   line                the same, and t_in, t_out where the line meets the CSO
//   swept_overlap       no number; the outcome is hit, for contact at any t in [0, T], 0 included, or miss
//   overlap, distance   distance at t = 0, the target distance not counted
//   penetration         depth; normal where there is just one, unit. Apart: distance
//   penetration_along   depth: the length of the move along `direction`. Apart: distance
// The last four queries are asked at t = 0, their outcome is initially_overlapping or miss, and penetration
// does not look at the target distance. start_policy bears on the outcome and time of casts and lines alone.
//
// Throws Undecided for what the oracles do not decide:
//   curved shapes     a clearance or depth below 1e-30 of scale, and every penetration. The TOI is the exact
//                     one's neighbours but at a graze, where it is a bracket as wide as 1e-30 of scale makes
//                     it. Clearance and depth are lower bounds, of depths up to a sixteenth below; there is none
//                     of a graze that a closed form decides and no bracket does
//   bodies that turn  in casts and swept_overlap, a clearance or depth below 1e-14 of scale, a search beyond
//                     the budget of rotating_truth.hpp, an infinite t_max; a line. toi_lower and toi_upper are a
//                     bracket as wide as 1e-14 of scale makes it. With the policy pass_over, a contact at the start
//                     that gets between 1e-14 and 1e-12 of scale deep, or is new without that depth; the bracket
//                     is from the one depth to the other
[[nodiscard]] corpus::Expect derive_expectation(const corpus::Case& problem);

}  // namespace graze::oracle
