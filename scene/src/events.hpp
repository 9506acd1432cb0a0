// One pair's answer, and what becomes of it.
#pragma once

#include <graze/scene.hpp>

namespace graze::scene {

struct Answer {
  RotatingResult<double> result;
  std::optional<Proof> proof;  // of a linear cast
};

// By the least that the pair calls for, over [0, t_max].
[[nodiscard]] Answer answer(const RotatingBody<double>& a, const RotatingBody<double>& b,
                            const Options& options, double t_max);
// The plan of answer().
[[nodiscard]] graze::Plan plan_of(const RotatingBody<double>& a, const RotatingBody<double>& b,
                                  const Options& options);

[[nodiscard]] inline bool is_event(Outcome outcome) {
  return outcome != Outcome::miss && outcome != Outcome::invalid_input;
}
[[nodiscard]] inline bool is_contact(Outcome outcome) {
  return outcome == Outcome::hit || outcome == Outcome::initially_overlapping;
}
[[nodiscard]] Event event_of(std::uint32_t a, std::uint32_t b, Answer&& answer);

}  // namespace graze::scene
