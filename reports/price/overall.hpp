// A contender over many tables: its mean cost, and its worst answer.
#pragma once

#include <string>
#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

using Tables = std::vector<const PriceTable*>;

// The families of rotating bodies, or of the others.
[[nodiscard]] Tables families_of(const Document& document, bool turning);
// Does tier exact answer every case?
[[nodiscard]] bool is_for_exact(const PriceTable& table);

// A method of ours that is asked every case of each table. The counts come from the first table's row.
struct Overall {
  const Row* row = nullptr;                      // row in the first table
  double cost = kNone, least = kNone, most = 0;  // geometric mean of the tables' ratios, and both ends
  double worst = 0, late_by = 0, denied = 0;     // over scale, a denied contact counts with its depth
  std::size_t asked = 0, wrong = 0, late = 0;
  std::size_t open = 0, unsettled = 0;  // not converged, and without a time or refused
};
[[nodiscard]] std::vector<Overall> overall(const Tables& tables);  // the cheapest first

// A ratio as text: "1.52", "13", "0.061", "8e-16", "0".
[[nodiscard]] std::string times_text(double ratio);
[[nodiscard]] std::string error_text(double error);

}  // namespace graze::price
