// Compares one answer with the truth about its case.
//
// The truth comes from three sources:
// - the exact oracle for polytopes, rounded or not
// - the bracket oracle for other shapes, proved in ball arithmetic
// - the certified tier for rotating bodies if the checker accepts its proof, else the bracket oracle
// A case that no source decides is open, and no answer to it is wrong or late.
//
// Errors are those of toi_lower, the time that a simulator uses. Every error is a proved upper bound.
#pragma once

#include <map>
#include <memory>

#include "corpus/case.hpp"
#include "engines/method.hpp"
#include "properties/judge/truth.hpp"
#include "reports/price/document.hpp"

namespace graze::price {

struct Measured {
  bool asked = true;
  bool not_converged = false, no_time = false, refused = false;
  bool wrong = false, late = false, proved = false;
  double backward = kNone, forward = kNone, width = kNone, denied = kNone, late_by = kNone;
  double iterations = kNone, supports = kNone;
};

enum class TruthBy : std::uint8_t { exact, bracket, proof, open };

// The truth about one case. Use it in one thread only.
class Judge {
 public:
  explicit Judge(corpus::Case problem, engine::Kind kind);

  // Into `measured`, its errors and verdict. A query's answer is judged by the judge of queries.
  void judge(Measured& measured, const engine::Method& method, const engine::Answer& answer);

  [[nodiscard]] TruthBy by() const { return by_; }
  [[nodiscard]] Shown shown() const;  // without the case

 private:
  struct Off {
    double backward = kNone, forward = kNone, late_by = kNone;
    bool late = false;
  };
  const Off& off(double t);
  [[nodiscard]] Off off_linear(double t);
  [[nodiscard]] Off off_turning(double t);
  void settle();

  law::Truth truth_;
  engine::Kind kind_;
  TruthBy by_ = TruthBy::open;
  Outcome outcome_ = Outcome::not_converged;
  double lower_ = kNone, upper_ = kNone, scale_ = 0, speed_ = 0;
  std::map<double, Off> seen_;
  std::optional<double> depth_, clearance_;
};

// The work and the proof of an answer, which need no truth.
[[nodiscard]] Measured begun(const corpus::Case& problem, const engine::Method& method,
                             const engine::Answer& answer, Request request);

}  // namespace graze::price
