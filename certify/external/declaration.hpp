// An engine's declaration about itself, graze.engine/1 (docs/reference/protocol.md describes each field).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engines/guarantees.hpp"
#include "engines/method.hpp"

namespace graze::external {

enum class Question { cast, rotating_cast, ray, overlap, distance, penetration };
[[nodiscard]] std::string_view to_text(Question question);
// True for questions about moving bodies. The others are about t = 0.
[[nodiscard]] constexpr bool is_cast(Question question) {
  return question == Question::cast || question == Question::rotating_cast || question == Question::ray;
}

// A question that the engine supports: the fields of its answers, and their guarantees.
struct Offer {
  Question question = Question::cast;
  engine::Holds holds = {.time = false, .normal = false, .witnesses = false};
  bool holds_distance = false, holds_depth = false, holds_proof = false;
  // Lengths: as it is, over scale, in units of u scale. None: nothing is promised about errors.
  std::optional<double> tolerance = {}, relative_tolerance = {}, kappa = {};
  engine::Touching touching = engine::Touching::either;
  engine::StartNormal start_normal = engine::StartNormal::any;
  double own_frames = 0;                  // over the lengths in the bodies' own frames, a number of them
  double early = 0;                       // a length by which its times stop short by design
  bool starts = true;                     // it is asked about starts in contact
  double stalls = 0;                      // the fraction of a family that may be not_converged
  std::optional<int> most_supports = {};  // upper bound on an answer's `supports`
  bool takes_target_distance = false, takes_pass_over = false;

  [[nodiscard]] bool promises_errors() const { return tolerance || relative_tolerance || kappa; }
};

struct Declaration {
  std::string name, version, about, scalar;
  std::vector<std::string> shapes;
  std::vector<Offer> offers;
  double margin = 0;  // a length: contact is where the distance of the bodies reaches it
  struct Lengths {
    double least = 0, most = kInfinity<double>;
  };
  std::optional<Lengths> lengths = {};  // the scales that its questions are brought to
  bool infinite_t_max = false;
  bool relative_motion = false;  // A is at rest in every question
  bool pivots = true;
  std::optional<double> most_turn = {};  // radians over the path
  // Documented limits.
  std::optional<double> most_aspect = {};
  std::optional<std::size_t> most_vertices = {};
  bool timed = false;

  [[nodiscard]] bool in_float() const { return scalar == "float"; }
  [[nodiscard]] double unit_roundoff() const {
    return in_float() ? kUnitRoundoff<float> : kUnitRoundoff<double>;
  }
  [[nodiscard]] bool takes(std::string_view shape) const;
};

// The types of the case format that an engine may declare as supported.
[[nodiscard]] std::span<const std::string_view> shape_names();

// Throws std::runtime_error with one line: the error, its field, and the correct form.
[[nodiscard]] Declaration parse_declaration(std::string_view line);

}  // namespace graze::external
