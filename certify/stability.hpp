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

// What the oracle says of one answer, to the case as the method saw it. Lengths are over scale. A miss that
// is right has no errors; nor has a stall, which is counted.
struct Measured {
  bool rounded = false;  // else polytopes, target distance 0
  bool asked = true;     // false: not for the method's tier, or none that an engine of others takes
  bool wrong = false, stalled = false, late = false;
  bool failed = false;             // an engine of others crashed, hung, or wrote what is no answer
  double backward = kNotMeasured;  // of the bracket's worse end; of a wrong verdict what it denies, at least
  double forward = kNotMeasured;   // of the worse end; of a wrong verdict there is none
  double denied = kNotMeasured;    // of a wrong verdict: the clearance or the depth
  std::string fault;               // no answer, or verdict or time, by more than the method's row grants
};

// One method on the cases of one level.
struct LevelErrors {
  double hardness = 0;
  std::size_t cases = 0, skipped = 0, wrong = 0, stalled = 0, late = 0, failed = 0, faulty = 0;
  std::vector<double> backward = {}, forward = {};
  double denied = kNotMeasured;  // the largest

  void add(const Measured& measured);
  void add(const LevelErrors& other);  // of the same level
};

// One method on one family, on polytopes or on shapes that are round.
struct Curve {
  std::string method, tier;  // "mpr/float", "standard"
  double unit_roundoff = 0;
  std::optional<engine::Guarantee> row = {};
  std::string family;
  bool rotating = false, rounded = false;
  std::vector<LevelErrors> levels = {};  // of the family, in its order
  std::string first_fault = {};          // the case and why

  [[nodiscard]] LevelErrors total() const;
  // The level of the largest backward error; nullptr if none was measured.
  [[nodiscard]] const LevelErrors* hardest() const;
  // Does the row promise anything about every answer? False without one, and where it lets contacts be
  // missed.
  [[nodiscard]] bool claims_stability() const;
  // No fault, and no more stalls than the row's share of the cases, rounded up. True without a row.
  [[nodiscard]] bool holds() const;
};

struct StabilitySettings {
  std::vector<const engine::Method*> methods = {};  // of casts; those of a family's kind are measured on it
  std::size_t count = 1, rotating_count = 1;        // cases a level
  std::uint64_t seed = 1;
  unsigned threads = 1;  // the result does not depend on them
  // Asked between cases: whether to stop. What is measured then is kept.
  std::function<bool()> stop = [] { return false; };
};

struct FamilyStability {
  std::string family, hardness_meaning;
  std::size_t cases = 0;           // that were measured
  bool stopped = false;            // before all were
  std::vector<Curve> curves = {};  // by method, polytopes first; of kinds that occur
  struct Skipped {
    std::string method = {};
    std::size_t cases = 0;
  };
  std::vector<Skipped> skipped = {};         // of engines of others: what they do not take
  std::vector<corpus::Case> convicted = {};  // cases on which some method is at fault or stalled
};

[[nodiscard]] FamilyStability measure_family(const corpus::Family& family, const StabilitySettings& settings);

// The same cases of polytopes and of round shapes in one curve each.
[[nodiscard]] std::vector<Curve> merged(const std::vector<Curve>& curves);

}  // namespace graze::tool
