// The cases that are priced. Every number of a case is a float, so that float and double answer one question.
//
// A case is a pure function of the table, its place and the seed, on one platform: directions are normalised
// by a square root, and no sine is drawn.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "corpus/case.hpp"
#include "corpus/random.hpp"
#include "engines/method.hpp"
#include "reports/price/document.hpp"

namespace graze::price {

// A table to be measured: its cases and its contenders.
struct Topic {
  PriceTable head = {};  // without rows
  engine::Kind kind = engine::Kind::linear;
  bool measures = true;  // true if its errors are measured, else only times and work
  bool sweeps = true;    // true for a range of tolerances, else the least that each method reaches
  std::size_t cases = 1;
  std::function<corpus::Case(corpus::Random&, std::size_t place)> draw = {};
  // The requests of the rows: "cast" with these requests, or the queries.
  std::vector<std::string> methods = {};  // by question_name without the scalar, empty for all of the kind
  std::vector<Request> requests = {Request::verdict};
  bool in_float = true;  // float, too
};

// Everything that graze price measures, in order.
[[nodiscard]] std::vector<Topic> topics(bool thorough);

// Its cases: the same for one seed.
[[nodiscard]] std::vector<corpus::Case> cases_of(const Topic& topic, std::uint64_t seed);

}  // namespace graze::price
