// Compares bounds with the truth: no bound may be below it, and the slack of each bound is counted.
//
// A tally belongs to one bound of core. Each sample is the bound, a double, and the truth, a ball. A bound
// that is certainly less than the truth is a failure, reported with its inputs. Truths are lower bounds of
// the claimed quantity (the greatest over the sampled points and times), so the reported slack is never too
// little.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "oracles/arithmetic/ball.hpp"

namespace graze::test {

// Rounds of the default run, times GRAZE_BOUNDS_TIMES where that is set: 100 for a long run.
inline int rounds(int usual) {
  const char* given = std::getenv("GRAZE_BOUNDS_TIMES");
  return usual * std::max(1, given ? std::atoi(given) : 1);
}

class Tally {
 public:
  explicit Tally(std::string name) : name_(std::move(name)) {}

  // bound >= truth. `describe` says with what inputs.
  void add(double bound, const oracle::Ball& truth, const std::function<std::string()>& describe) {
    using oracle::Ball;
    ++count_;
    const bool known = truth.is_finite();
    const bool below = std::isnan(bound) || (bound < kInfinity<double> && certainly_less(Ball(bound), truth));
    if (!known || below) {
      if (++below_ <= kShown) {
        char line[200];
        std::snprintf(line, sizeof line, "%s: bound %a, truth %a%s\n", name_.c_str(), bound,
                      truth.mid_double(), known ? "" : " (not known)");
        failures_ += line + describe();
      }
    }
    loose_ += bound > 0 && bound < kInfinity<double> &&
              certainly_less(Ball(bound) * oracle::power_of_two(-60), truth.high() - truth.low());
    if (truth.is_positive() && bound < kInfinity<double>) {
      ratios_.push_back((Ball(bound) / truth).mid_double());
    }
  }

  // Prints the line that docs/reports/bounds.md shows (table.py reads it), and fails for a bound below the truth.
  // `least_samples`: so many truths above 0 must have been seen, or the test says nothing.
  void finish(std::size_t least_samples) {
    std::sort(ratios_.begin(), ratios_.end());
    const auto at = [&](double part) {
      return ratios_.empty() ? 0.0 : ratios_[static_cast<std::size_t>(part * double(ratios_.size() - 1))];
    };
    std::printf("bound | %s | %zu | %zu | %.9g | %.3g | %.3g\n", name_.c_str(), count_, below_, at(0),
                at(0.5), at(1));
    EXPECT_EQ(below_, 0u) << failures_;
    // A truth known less well than that says nothing of its bound.
    EXPECT_EQ(loose_, 0u) << name_ << ": truths not known to 2^-60 of the bound";
    EXPECT_GE(ratios_.size(), least_samples) << name_ << ": too few truths above 0";
  }

 private:
  static constexpr std::size_t kShown = 3;
  std::string name_, failures_;
  std::size_t count_ = 0, below_ = 0, loose_ = 0;
  std::vector<double> ratios_;
};

}  // namespace graze::test
