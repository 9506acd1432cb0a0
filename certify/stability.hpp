// Stability: every method on every level of a family's hardness, and every case measured by the oracle.
//
//   A method is stable when its backward error stays within a small multiple of u scale whatever the case,
//   and its verdict is wrong only where clearance or depth is below that. The curve of error against hardness
//   shows which methods are, and where the others break.   u: unit roundoff of the method's scalar.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus/families.hpp"
#include "engines/guarantees.hpp"

namespace graze::tool {

inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

// The oracle's measurement of one answer to the case as the method saw it. Lengths are over scale. A correct
// miss has no errors. An answer that did not converge has none either, and is counted.
struct Measured {
  bool rounded = false;  // else polytopes, target distance 0
  bool asked = true;     // false if the method's tier or a third-party engine does not take the case
  bool wrong = false, stalled = false, late = false;
  bool failed = false;             // a third-party engine crashed, hung, or wrote an invalid answer
  double backward = kNotMeasured;  // at the bracket's worse end, for a wrong verdict a lower bound on
                                   // `denied`
  double forward = kNotMeasured;   // at the worse end, absent for a wrong verdict
  double denied = kNotMeasured;    // the clearance or depth that a wrong verdict denies
  std::string fault;               // invalid answer, or verdict or time beyond the method's guarantee
};

// One method on the cases of one level.
struct LevelErrors {
  double hardness = 0;
  std::size_t cases = 0, skipped = 0, wrong = 0, stalled = 0, late = 0, failed = 0, faulty = 0;
  std::vector<double> backward = {}, forward = {};
  double denied = kNotMeasured;  // the largest

  void add(const Measured& measured);
  void add(const LevelErrors& other);  // other is of the same level
};

// One method on one family, on polytopes or on shapes that are round.
struct Curve {
  std::string method, tier;  // "mpr/float", "standard"
  double unit_roundoff = 0;
  std::optional<engine::Guarantee> row = {};
  std::string family;
  bool rotating = false, rounded = false;
  std::vector<LevelErrors> levels = {};  // the levels of the family, in its order
  std::string first_fault = {};          // the case and why

  [[nodiscard]] LevelErrors total() const;
  // The level with the largest backward error, or nullptr if none was measured.
  [[nodiscard]] const LevelErrors* hardest() const;
  // True if the guarantee covers every answer. False without a guarantee, and if it lets contacts be missed.
  [[nodiscard]] bool claims_stability() const;
  // No fault, and the number of unconverged answers is at most the guarantee's share of the cases, rounded
  // up. True without a guarantee.
  [[nodiscard]] bool holds() const;
};

struct StabilitySettings {
  std::vector<const engine::Method*> methods = {};  // methods of casts, each measured on families of its kind
  std::size_t count = 1, rotating_count = 1;        // cases a level
  std::uint64_t seed = 1;
  unsigned threads = 1;  // the result does not depend on them
  // Called between cases: true ends the run. The measurements until then are kept.
  std::function<bool()> stop = [] { return false; };
};

struct FamilyStability {
  std::string family, hardness_meaning;
  std::size_t cases = 0;           // measured cases
  bool stopped = false;            // before all were
  std::vector<Curve> curves = {};  // by method, polytopes first, only kinds that occur
  struct Skipped {
    std::string method = {};
    std::size_t cases = 0;
  };
  std::vector<Skipped> skipped = {};         // cases that third-party engines do not take
  std::vector<corpus::Case> convicted = {};  // cases with a method at fault or not converged
};

[[nodiscard]] FamilyStability measure_family(const corpus::Family& family, const StabilitySettings& settings);

// The same cases of polytopes and of round shapes in one curve each.
[[nodiscard]] std::vector<Curve> merged(const std::vector<Curve>& curves);

}  // namespace graze::tool
