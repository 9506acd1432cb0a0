// Cached results for the queried times. A judge needs one time's error when it convicts, when it measures and
// when it looks for the limit that would suffice.
#pragma once

#include <map>

#include "oracles/arithmetic/enclosure.hpp"

namespace graze::oracle {

class ByTime {
 public:
  // compute(), the first time that t is queried. t is not a NaN.
  template <class Compute>
  [[nodiscard]] Enclosure at(double t, const Compute& compute) {
    const auto known = known_.find(t);
    return known != known_.end() ? known->second : known_.emplace(t, compute()).first->second;
  }

 private:
  std::map<double, Enclosure> known_;
};

}  // namespace graze::oracle
