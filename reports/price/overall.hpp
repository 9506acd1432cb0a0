// A contender over many tables: what it costs in the mean, and the worst that it did.
#pragma once

#include <string>
#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

using Tables = std::vector<const PriceTable*>;

// The families of bodies that turn, or of those that do not.
[[nodiscard]] Tables families_of(const Document& document, bool turning);

// One of ours that is asked every case of each table; the first table's rows are the ones that count.
struct Overall {
  const Row* row = nullptr;                      // of the first table
  double cost = kNone, least = kNone, most = 0;  // of the tables' ratios the geometric mean, and the ends
  double worst = 0, late_by = 0, denied = 0;     // over scale; of a contact that is denied its depth counts
  std::size_t asked = 0, wrong = 0, late = 0;
  std::size_t open = 0, unsettled = 0;  // not converged; no time, or refused
};
[[nodiscard]] std::vector<Overall> overall(const Tables& tables);  // the cheapest first

// "1.52", "13", "0.061"; "8e-16", "0".
[[nodiscard]] std::string times_text(double ratio);
[[nodiscard]] std::string error_text(double error);

}  // namespace graze::price
