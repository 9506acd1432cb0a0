// The contenders of a table: a method with its request.
#pragma once

#include <vector>

#include "reports/price/draw_price.hpp"

namespace graze::price {

struct Contender {
  const engine::Method* method = nullptr;
  engine::Ask ask = {};
  Row head = {};  // identifies the contender, before any measurement
};

// 1e-1 down to what the scalar reaches, over scale, and 0: the least that a method reaches.
[[nodiscard]] std::vector<double> tolerances_of(const engine::Method& method, bool thorough);

// Ours and `others`, as the topic has it.
[[nodiscard]] std::vector<Contender> contenders_of(const Topic& topic,
                                                   const std::vector<const engine::Method*>& others,
                                                   bool thorough);

// True if a method is asked the case.
[[nodiscard]] bool takes(const engine::Method& method, const corpus::Case& problem);

}  // namespace graze::price
