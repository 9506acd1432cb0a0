/// @file
/// Many casts at once: pairs, one body against many, and many rays against one body.
///
/// Each answer is that of the single cast, graze::cast(a, b, options), to the bit, with any number of threads. The
/// caller holds questions and answers. Nothing is allocated except the threads, and the requested proofs of rotating
/// bodies. With threads = 1 (or 0) the caller's thread does all.
#pragma once

#include <graze/cast.hpp>
#include <graze/rotating_cast.hpp>
#include <span>

namespace graze::scene {

/// Two bodies that live as long as the call.
struct Question {
  const Body<double>* a;  ///< The first body.
  const Body<double>* b;  ///< The second body.
};
/// Two rotating bodies that live as long as the call.
struct RotatingQuestion {
  const RotatingBody<double>* a;  ///< The first body.
  const RotatingBody<double>* b;  ///< The second body.
};

/// Answers questions[k] in answers[k]. If the sizes differ, the lesser one counts. The time is that of the casts,
/// divided by the threads.
///
/// @code
/// const graze::Body<double> floor{.shape = graze::Box<double>{{50, 50, 1}}, .position = {0, 0, -1}};
/// const graze::Body<double> ball{.shape = graze::Sphere<double>{1}, .position = {0, 0, 3}, .displacement = {0, 0, -4}};
/// const graze::Body<double> bird{.shape = graze::Sphere<double>{1}, .position = {0, 0, 9}, .displacement = {4, 0, 0}};
///
/// const std::vector<graze::scene::Question> questions = {{&floor, &ball}, {&floor, &bird}};
/// std::vector<graze::CastResult<double>> answers(questions.size());
/// graze::scene::cast_all(questions, answers);
/// assert(answers[0].outcome == graze::Outcome::hit && answers[1].outcome == graze::Outcome::miss);
/// @endcode
void cast_all(std::span<const Question> questions, std::span<CastResult<double>> answers,
              const CastOptions<double>& options = {}, unsigned threads = 1);
/// The same for rotating bodies.
void cast_all(std::span<const RotatingQuestion> questions, std::span<RotatingResult<double>> answers,
              const RotatingOptions<double>& options = {}, unsigned threads = 1);

/// One body against many: answers[k] is cast(one, many[k]).
///
/// The bounds of the one body are computed once. A motion that stays clear of them, by 2^-36 of the pair's scale or
/// more, is a miss without a cast. Such a miss has no counters and the default method. Everything else in it is as
/// the single cast returns it.
void cast_all(const Body<double>& one, std::span<const Body<double>> many,
              std::span<CastResult<double>> answers, const CastOptions<double>& options = {},
              unsigned threads = 1);

/// A ray: the path of a point.
struct RayQuestion {
  Vec3<double> origin = Vec3<double>::Zero();        ///< Start of the ray, in world axes.
  Vec3<double> displacement = Vec3<double>::Zero();  ///< Its direction, a length per unit of t.
};
/// Many rays against one body: answers[k] is cast(body, point). Rays that stay clear of the body's bounds are not
/// cast, as above.
///
/// @code
/// const graze::Body<double> wall{.shape = graze::Box<double>{{1, 50, 50}}, .position = {11, 0, 0}};
/// const std::vector<graze::scene::RayQuestion> rays = {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {-1, 0, 0}}};
/// std::vector<graze::CastResult<double>> answers(rays.size());
/// graze::scene::cast_rays(wall, rays, answers, {.t_max = graze::kInfinity<double>});
/// assert(std::abs(answers[0].toi_lower - 10) < 1e-12 && answers[1].outcome == graze::Outcome::miss);
/// @endcode
void cast_rays(const Body<double>& body, std::span<const RayQuestion> rays,
               std::span<CastResult<double>> answers, const CastOptions<double>& options = {},
               unsigned threads = 1);

/// The fields of a ray's CastResult that most callers read: 80 bytes instead of 1,568. Each number is the same, to the bit.
struct RayAnswer {
  Outcome outcome = Outcome::invalid_input;                     ///< As CastResult::outcome.
  double toi_lower = std::numeric_limits<double>::quiet_NaN();  ///< As CastResult::toi_lower.
  double toi_upper = std::numeric_limits<double>::quiet_NaN();  ///< As CastResult::toi_upper.
  Vec3<double> normal =
      Vec3<double>::Zero();  ///< As CastResult::normal: unit, world axes, from the body to the point.
  Vec3<double> point =
      Vec3<double>::Zero();  ///< As CastResult::point_a: on the body at `toi_lower`, world coordinates.
};
/// Many rays against one body, which is prepared once. The answers are slim, and no proof is computed.
void cast_rays(const Body<double>& body, std::span<const RayQuestion> rays, std::span<RayAnswer> answers,
               const CastOptions<double>& options = {}, unsigned threads = 1);

}  // namespace graze::scene
