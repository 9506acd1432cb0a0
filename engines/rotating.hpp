// The rotating casts that can be judged, by name. Every one of them takes linear cases, too.
#pragma once

#include <graze/rotating_result.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "corpus/case.hpp"

namespace graze::engine {

// An answer in doubles, whatever scalar computed it (a float is a double). Fields as in RotatingResult.
struct RotatingAnswer {
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  Plan plan = {};
  double toi_lower = 0, toi_upper = 0;
  double distance = 0;       // of the bodies at toi_lower, at most, beyond the target distance
  bool passed_over = false;  // a miss by the start policy
  double hidden_motion = 0;  // of steps and spheres: what they may have missed (length)
  Vec3<double> normal = Vec3<double>::Zero(), point_a = Vec3<double>::Zero(), point_b = Vec3<double>::Zero();
  std::optional<RotatingProof> proof = {};
  Counters counters = {};
};

struct RotatingAsk {
  Request request = Request::verdict;
  double tolerance = 0;           // over scale; 0: the least that the tier reaches
  int max_iterations = 0;         // 0: the method's default
  int time_steps = 0;             // 0: the default
  std::optional<Tier> tier = {};  // another than the method's
  Economies economies = {};       // of the plan
};

struct RotatingEngineMethod {
  std::string name;    // "steps", "spheres", "ca", "bilateral", "bilateral_published", "plan", "certified"
  std::string scalar;  // "float", "double"
  std::string tier;    // "standard", "certified"
  double unit_roundoff;
  // A case for which unsupported_rotating() says something comes back as invalid_input with Invalid::none.
  RotatingAnswer (*cast)(const corpus::Case&, const RotatingAsk&);
  // What that would simulate.
  Plan (*plan)(const corpus::Case&, const RotatingAsk&);
  // The case as this method sees it: every number rounded to its scalar. Proofs and guarantees are about it.
  corpus::Case (*seen)(const corpus::Case&);
  // Prepares a case once and returns the nanoseconds that one cast takes, the median over `repeats` batches.
  double (*time_ns)(const corpus::Case&, const RotatingAsk&, int repeats);

  [[nodiscard]] std::string full_name() const { return name + "/" + scalar; }
  [[nodiscard]] bool is_certified() const { return tier == "certified"; }
};

[[nodiscard]] std::span<const RotatingEngineMethod> rotating_methods();
// By "ca" (the first of that name, in double), "ca/float", ...: nullptr if there is none.
[[nodiscard]] const RotatingEngineMethod* find_rotating_method(std::string_view name);

// Is a body given a rotation, seen or not?
[[nodiscard]] bool turns(const corpus::Case& problem);

// What in a case no method here answers ("a query other than cast"); empty when all of them do.
[[nodiscard]] std::string unsupported_rotating(const corpus::Case& problem);

}  // namespace graze::engine
