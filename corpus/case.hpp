// A case: two bodies, a question, and, where it is known, the answer. The schemas are those of docs/reference/case-format.md.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>
#include <optional>
#include <string>
#include <vector>

namespace graze::corpus {

using StartPolicy = graze::StartPolicy;
enum class Query { cast, line, overlap, distance, penetration, penetration_along, swept_overlap };

// The rotating part of a body's motion. It is zero for every linear case.
struct Spin {
  Vec3<double> rotation = Vec3<double>::Zero();  // rotation vector per unit of t, radians, world axes
  Vec3<double> pivot = Vec3<double>::Zero();     // centre of the rotation, body's own frame
};

// The expected answer. Absent numbers are not claimed. `by` names the oracle that gave it, never core.
struct Expect {
  std::string by;
  std::optional<Outcome> outcome;
  std::optional<double> toi_lower,
      toi_upper;          // the doubles on either side of the exact TOI (equal if it is one)
  std::string toi_exact;  // "n/d" or "n" where the TOI is rational, else empty
  std::optional<double> t_in, t_out, distance, depth;
  std::optional<Vec3<double>> normal;
  // Lengths of a linear cast that tell a wrong verdict from a harmless one. `clearance` is the distance of
  // the path of a miss from contact, and `path_depth` is how deep the path of a contact goes. Both are
  // rounded down. `scale` is the scale of the question, rounded up.
  std::optional<double> clearance, path_depth, scale;

  [[nodiscard]] bool has_measures() const { return clearance || path_depth || scale; }
};

struct Case {
  std::string id, family;
  std::optional<double> hardness;
  std::string comment, source;
  std::vector<std::string> flags;

  Body<double> a, b;
  Spin spin_a, spin_b;
  double t_max = 1;  // may be infinite
  double target_distance = 0;
  StartPolicy start_policy = StartPolicy::report;
  Query query = Query::cast;
  Vec3<double> direction = Vec3<double>::Zero();  // of penetration_along
  std::optional<Expect> expect;
};

}  // namespace graze::corpus
