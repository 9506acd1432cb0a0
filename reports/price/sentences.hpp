// The results of a run in words. Every sentence is computed from its figures. There is no sentence about
// anything that the run did not measure.
#pragma once

#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

[[nodiscard]] std::vector<Sentence> sentences_of(const Document& document);

}  // namespace graze::price
