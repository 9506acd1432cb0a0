// What the figures of a run say, in words. Every sentence is computed from them; what a run did not measure,
// it says nothing of.
#pragma once

#include <vector>

#include "reports/price/document.hpp"

namespace graze::price {

[[nodiscard]] std::vector<Sentence> sentences_of(const Document& document);

}  // namespace graze::price
