// Many casts at once. Each answer is that of the single cast, graze::cast(a, b, options), to the bit; in any
// number of threads.
//
// Nothing is allocated but the threads themselves (and what a cast allocates, which is a requested proof of a
// turning body): the caller holds questions and answers, and with threads = 1 (or 0) the caller's thread does
// all. For one body against many, its bounds are computed once. A motion that stays clear of them, by 2^-36 of
// the pair's scale or more, is a miss without a cast. Such a miss has no counters and the default method;
// everything else in it is as the single cast returns it.
#pragma once

#include <graze/cast.hpp>
#include <graze/rotating_cast.hpp>
#include <span>

namespace graze::scene {

// Two bodies that live as long as the call.
struct Question {
  const Body<double>* a;
  const Body<double>* b;
};
struct RotatingQuestion {
  const RotatingBody<double>* a;
  const RotatingBody<double>* b;
};

// answers[k] to questions[k]; as many answers as questions are written: the lesser of both sizes.
void cast_all(std::span<const Question> questions, std::span<CastResult<double>> answers,
              const CastOptions<double>& options = {}, unsigned threads = 1);
void cast_all(std::span<const RotatingQuestion> questions, std::span<RotatingResult<double>> answers,
              const RotatingOptions<double>& options = {}, unsigned threads = 1);

// One body against many: cast(one, many[k]).
void cast_all(const Body<double>& one, std::span<const Body<double>> many,
              std::span<CastResult<double>> answers, const CastOptions<double>& options = {},
              unsigned threads = 1);

// Many rays, each the path of a point, against one body that stays: cast(body, point).
struct RayQuestion {
  Vec3<double> origin = Vec3<double>::Zero(), displacement = Vec3<double>::Zero();
};
void cast_rays(const Body<double>& body, std::span<const RayQuestion> rays,
               std::span<CastResult<double>> answers, const CastOptions<double>& options = {},
               unsigned threads = 1);

// What most callers read of it: 80 bytes instead of 1,568. Each number is that of the CastResult, to the bit.
struct RayAnswer {
  Outcome outcome = Outcome::invalid_input;
  double toi_lower = std::numeric_limits<double>::quiet_NaN();
  double toi_upper = std::numeric_limits<double>::quiet_NaN();
  Vec3<double> normal = Vec3<double>::Zero();  // CastResult::normal
  Vec3<double> point = Vec3<double>::Zero();   // CastResult::point_a: on the body, at toi_lower
};
// A proof is not computed.
void cast_rays(const Body<double>& body, std::span<const RayQuestion> rays, std::span<RayAnswer> answers,
               const CastOptions<double>& options = {}, unsigned threads = 1);

}  // namespace graze::scene
