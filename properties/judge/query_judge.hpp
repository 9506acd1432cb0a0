// Shared by the two judges of queries: the errors that an answer may have, and their reports. One judge knows the truth
// exactly (judge_query.cpp), one by proved brackets (judge_curved_query.cpp).
//
// Errors are lengths over scale: the error of a distance or depth, and the backward error of a time. A verdict is wrong
// if distance, depth or clearance exceeds the limit.
#pragma once

#include <algorithm>

#include "oracles/arithmetic/enclosure.hpp"
#include "properties/judge/judgement.hpp"
#include "properties/judge/limits.hpp"

namespace graze::law {

// Judges by query. A derived judge states the truth at rest and along the motion.
class QueryJudge {
 public:
  virtual ~QueryJudge() = default;
  QueryJudge(const QueryJudge&) = delete;
  QueryJudge& operator=(const QueryJudge&) = delete;
  [[nodiscard]] Judgement operator()();

 protected:
  // `scale`: of the question, a length.
  QueryJudge(const corpus::Case& problem, const engine::Method& method, const engine::Answer& answer,
             double tolerance, double scale);

  virtual void overlap() = 0;
  virtual void distance() = 0;
  virtual void penetration() = 0;
  virtual void penetration_along() = 0;
  virtual void line() = 0;
  virtual void swept_overlap() = 0;
  // How far a point is from a body at t = 0, at least.
  [[nodiscard]] virtual double distance_from_body(char body, const Vec3<double>& point) = 0;

  [[nodiscard]] double in_scale(double length) const { return over(length, scale_); }
  void erred(double length);
  // A claim of contact, or of none, that errs by this length.
  void verdict_errs(double error, const char* what);
  // Either end of a bracket. A bracket that the answer marks as wide may be wide.
  void measure(const char* what, double error);
  // A bracket that does not hold the truth is off, however wide it is marked.
  void held(const char* what, double miss);
  void normal_off(double error, double limit);
  // Do they lie on their bodies? False: something is missing or off, or not part of the method's answers.
  bool witnesses();
  // The closest points of bodies that are this far apart.
  void closest_points(const oracle::Enclosure& distance);
  // True if there is a depth to judge, of bodies in contact.
  [[nodiscard]] bool states_depth();
  // A time that the scalar cannot hold lies between its largest number and infinity, of either sign.
  [[nodiscard]] bool is_beyond_scalar(const engine::Interval& bracket, const oracle::Enclosure& end) const;
  [[nodiscard]] double largest() const;  // number of the scalar

  // The coordinates of a witness round by 2 u of its distance from the origin (docs/reference/guarantees.md).
  [[nodiscard]] double rounding(const Vec3<double>& point) const {
    return 2 * limits_.unit_roundoff * point.norm();
  }
  [[nodiscard]] double pair_rounding() const { return rounding(answer_.point_a) + rounding(answer_.point_b); }
  // A pair of points on bodies that reach less far than those that are seen is farther apart by as much.
  [[nodiscard]] double pair_reach() const { return std::max(answer_.reach_a, answer_.reach_b); }

  const corpus::Case& problem_;
  const engine::Answer& answer_;
  bool has_witnesses_;
  double scale_;
  Limits limits_;
  double limit_, wide_;  // wide_: of the ends of a bracket, the tolerance counted
  Judgement judgement_;
};

}  // namespace graze::law
