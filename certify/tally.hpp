// One row of the certification table, a method on a family of cases, and whether the row of the guarantee
// table holds there.
#pragma once

#include <string>
#include <vector>

#include "engines/guarantees.hpp"
#include "properties/judge/answer.hpp"

namespace graze::tool {

struct Tally {
  std::string method, scalar, family;
  std::size_t cases = 0, not_asked = 0;  // those that are not for the tier are no cases of its row
  std::size_t wrong = 0, late = 0, off = 0, bad_contact = 0, stalled = 0, excused = 0;
  std::size_t accepted = 0, refused = 0, unproved = 0;
  std::size_t by_oracle = 0;
  std::vector<double> forward = {}, backward = {}, normal = {},
                      witness = {};        // over scale, of the cases that the oracle measured
  std::vector<double> true_backward = {};  // the same against the input before rounding to float
  std::vector<double> ns = {};             // of the cases that were timed

  // The first case of each kind, and its reason.
  struct Example {
    std::string id, reason;
  };
  Example first_wrong = {}, first_late = {}, first_off = {}, first_bad_contact = {}, first_stalled = {},
          first_refused = {};

  void add(const std::string& id, const Judgement& judgement);
};

// What of a guarantee does not hold in this tally, a line each: the row, the family, how many, and by which
// case. Without a row nothing is promised and nothing can break.
[[nodiscard]] std::vector<std::string> breaches(const Tally& tally, const engine::Guarantee* row);

// The table, a line a tally; a gap where the method changes.
[[nodiscard]] std::string tally_table(const std::vector<Tally>& tallies);

}  // namespace graze::tool
