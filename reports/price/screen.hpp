// The text of graze price: a table for each family, curves, requests, and the sentences.
#pragma once

#include <string>

#include "reports/price/document.hpp"

namespace graze::price {

// With `full`: every table. Otherwise the tables of families at their ends and at 1e-3, 1e-6, and all
// sentences.
[[nodiscard]] std::string screen_of(const Document& document, bool full);

}  // namespace graze::price
