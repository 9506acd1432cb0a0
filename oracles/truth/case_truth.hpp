// The truth about a linear case, by the oracle that knows most of it: exact if the bodies are polytopes or
// rounded ones (LinearTruth), a proved bracket for every other pair of shapes (BracketTruth).
//
// It decides the same questions as the oracle behind it. An outcome of not_converged is the bracket oracle's
// "undecided": clearance and depth are then below its width, or only contact at t = 0 is open. Enclosures are
// those of the oracle. A judge convicts by the end that favours the accused.
#pragma once

#include <variant>

#include "oracles/polytope/exact_body.hpp"
#include "oracles/truth/bracket_truth.hpp"
#include "oracles/truth/linear_truth.hpp"

namespace graze::oracle {

class CaseTruth {
  using Either = std::variant<LinearTruth, BracketTruth>;
  Either truth_;

  template <class F>
  auto of(const F& f) const {
    return std::visit(f, truth_);
  }

 public:
  // width: over scale, of the bracket oracle (see bracket_truth.hpp). Throws as the oracle does.
  explicit CaseTruth(const corpus::Case& problem, double width = BracketTruth::kDefaultWidth)
      : truth_(is_exact_body(problem.a.shape) && is_exact_body(problem.b.shape)
                   ? Either(std::in_place_type<LinearTruth>, problem)
                   : Either(std::in_place_type<BracketTruth>, problem, width)) {}

  [[nodiscard]] bool is_exact() const { return std::holds_alternative<LinearTruth>(truth_); }
  [[nodiscard]] Outcome outcome() const {
    return of([](const auto& t) { return t.outcome(); });
  }
  [[nodiscard]] double toi_lower() const {
    return of([](const auto& t) { return t.toi_lower(); });
  }
  [[nodiscard]] double toi_upper() const {
    return of([](const auto& t) { return t.toi_upper(); });
  }
  [[nodiscard]] int compare(double time) const {
    return of([&](const auto& t) { return t.compare(time); });
  }
  [[nodiscard]] Enclosure scale() const {
    return of([](const auto& t) { return t.scale(); });
  }
  [[nodiscard]] Enclosure clearance() const {
    return of([](const auto& t) { return t.clearance(); });
  }
  [[nodiscard]] Enclosure depth() const {
    return of([](const auto& t) { return t.depth(); });
  }
  [[nodiscard]] Enclosure distance_at(double time) const {
    return of([&](const auto& t) { return t.distance_at(time); });
  }
  [[nodiscard]] Enclosure depth_before(double time) const {
    return of([&](const auto& t) { return t.depth_before(time); });
  }
  [[nodiscard]] Enclosure backward_error(double time) const {
    return of([&](const auto& t) { return t.backward_error(time); });
  }
  [[nodiscard]] Enclosure forward_error(double time) const {
    return of([&](const auto& t) { return t.forward_error(time); });
  }
  [[nodiscard]] Enclosure lateness(double time) const {
    return of([&](const auto& t) { return t.lateness(time); });
  }
  [[nodiscard]] Enclosure normal_error(const Vec3<double>& n) const {
    return of([&](const auto& t) { return t.normal_error(n); });
  }
  [[nodiscard]] Enclosure distance_from_body(char body, double time, const Vec3<double>& point) const {
    return of([&](const auto& t) { return t.distance_from_body(body, time, point); });
  }
  [[nodiscard]] Enclosure distance() const {
    return of([](const auto& t) { return t.distance(); });
  }
};

}  // namespace graze::oracle
