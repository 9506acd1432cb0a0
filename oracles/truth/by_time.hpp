// What is known of the times that were asked about: a judge asks for one time's error when it convicts, when it measures
// and when it looks for the limit that would do.
#pragma once

#include <map>

#include "oracles/arithmetic/enclosure.hpp"

namespace graze::oracle {

class ByTime {
 public:
  // compute(), the first time that t is asked about; t is no NaN.
  template <class Compute>
  [[nodiscard]] Enclosure at(double t, const Compute& compute) {
    const auto known = known_.find(t);
    return known != known_.end() ? known->second : known_.emplace(t, compute()).first->second;
  }

 private:
  std::map<double, Enclosure> known_;
};

}  // namespace graze::oracle
