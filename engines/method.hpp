// The methods that can be judged, by name. Ours are engines like any other.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "corpus/case.hpp"

namespace graze::engine {

// An answer in doubles, whatever scalar computed it (a float is a double). Fields as in CastResult.
struct Answer {
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  double toi_lower = 0, toi_upper = 0;
  Vec3<double> normal = Vec3<double>::Zero(), point_a = Vec3<double>::Zero(), point_b = Vec3<double>::Zero();
  double distance = 0;       // of the bodies at toi_lower, at most, beyond the target distance
  bool passed_over = false;  // a miss by the start policy
  std::optional<Proof> proof = {};
  Counters counters = {};
};

struct Ask {
  Request request = Request::verdict;
  double tolerance = 0;    // over scale; 0: the method's rounding bound
  int max_iterations = 0;  // 0: the method's default
};

struct EngineMethod {
  std::string name;    // "ca", "gjk", "mpr", "certified", "exact"
  std::string scalar;  // "float", "double"
  std::string tier;    // "standard", "certified", "exact"
  double unit_roundoff;
  // A case for which unsupported() says something comes back as invalid_input with Invalid::none.
  Answer (*cast)(const corpus::Case&, const Ask&);
  // The case as this method sees it: every number rounded to its scalar. Proofs and guarantees are about it.
  corpus::Case (*seen)(const corpus::Case&);
  // Prepares a case once (shapes built in the method's scalar) and returns the nanoseconds that one cast
  // takes, the median over `repeats` timed batches.
  double (*time_ns)(const corpus::Case&, const Ask&, int repeats);

  [[nodiscard]] std::string full_name() const { return name + "/" + scalar; }
  [[nodiscard]] bool is_exact() const { return tier == "exact"; }
  [[nodiscard]] bool is_certified() const { return tier == "certified"; }
};

[[nodiscard]] std::span<const EngineMethod> methods();
// By "mpr" (the first of that name, in double), "mpr/double", ...: nullptr if there is none.
[[nodiscard]] const EngineMethod* find_method(std::string_view name);

// Whether a case, as a method of tier exact sees it, is one that the tier answers; from any other it hands
// back invalid_input with Invalid::not_exact. Written from the documentation of the tier, not from its code:
// points, segments, triangles, boxes, hulls, posed and summed, and no target distance.
[[nodiscard]] bool is_exact_question(const corpus::Case& seen);

// What in a case no method here answers ("a rotating motion", ...); empty when all of them do.
[[nodiscard]] std::string unsupported(const corpus::Case& problem);

}  // namespace graze::engine
