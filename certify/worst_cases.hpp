// The cases that a report names. For each method and family these are the first case of every fault, the case with the
// largest error relative to its limit, and the case with the most support evaluations.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "certify/suites.hpp"
#include "properties/judge/judgement.hpp"

namespace graze::tool {

class WorstCases {
 public:
  // A case of a suite, which is drawn again when it is looked at: the suites outlive this.
  struct Place {
    const Suite* suite = nullptr;
    std::size_t index = 0;
    // As the method was asked it.
    [[nodiscard]] corpus::Case problem(const engine::Method& method) const;
  };
  struct Named {
    std::string id = {}, why = {};
    double over_limit = std::numeric_limits<double>::quiet_NaN();
    int supports = 0;
    Place place = {};
  };
  // A method on a family.
  struct Cell {
    std::optional<Named> worst = {}, costliest = {};
    std::array<std::optional<Named>, law::kFaults> faults = {};
    std::optional<Named> stalled = {};
  };

  // Told of every judgement, as Settings::judged is.
  void note(const Suite& suite, std::size_t i, const engine::Method& method, const law::Judgement& judgement);

  // nullptr if no case of the method and family is kept.
  [[nodiscard]] const Cell* find(const engine::Method& method, const std::string& family) const;

 private:
  std::map<std::pair<const engine::Method*, std::string>, Cell> cells_;
};

}  // namespace graze::tool
