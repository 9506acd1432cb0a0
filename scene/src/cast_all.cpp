#include <graze/cast_all.hpp>

#include <graze/scene/swept_box.hpp>
#include <graze/support/prepared_pair.hpp>
#include <graze/validate.hpp>

#include <algorithm>

#include "parallel.hpp"

namespace graze::scene {
namespace {

// So many casts are one job: enough that handing them out costs nothing.
constexpr std::size_t kPart = 64;

template <class Job>
void for_each_part(std::size_t count, unsigned threads, const Job& job) {
  for_each_index((count + kPart - 1) / kPart, threads, [&](std::size_t part) {
    for (std::size_t k = part * kPart; k < std::min(count, (part + 1) * kPart); ++k) job(k);
  });
}

// One body's box, made once, against which others are held. Only where a miss is all that a cast could answer:
// a proof has its axis. The others' validity is their cast's to judge.
class Shared {
 public:
  Shared(const Body<double>& body, const CastOptions<double>& options) : options_(options) {
    usable_ = validate(body, body, options) == Invalid::none && !asks_for(options.request, Request::proof) &&
              options.start_policy == StartPolicy::report && is_known_to(options.tier, body);
    if (!usable_) return;
    moves_ = body.displacement != Vec3<double>::Zero();
    ended_ = options.t_max < kInfinity<double>;
    box_ = box_of(body, ended_ ? options.t_max : 0.0);
  }

  // A proved miss, whatever the tier: the boxes hold the bodies, half the target distance each, and 2^-36 of
  // scale, which no method's rounding reaches.
  [[nodiscard]] bool misses(const Body<double>& other) const {
    if (!usable_ || validate(other) != Invalid::none || !is_known_to(options_.tier, other)) return false;
    if (ended_) return !meeting(box_, box_of(other, options_.t_max)).possible();
    if (moves_ || other.displacement == Vec3<double>::Zero()) return false;
    const double end = last_exit(other.displacement, box_of(other, 0), box_);
    return end < 0 || !meeting_at_rest(box_of(other, end), box_).possible();
  }

 private:
  // Tier exact refuses curved bodies, however far apart.
  [[nodiscard]] static bool is_known_to(Tier tier, const Body<double>& body) {
    return tier != Tier::exact || detail::is_quick(body.shape);
  }
  [[nodiscard]] SweptBox box_of(const Body<double>& body, double end) const {
    return swept_box(body, {}, end, options_.target_distance / 2 * (1 + 0x1p-50) + noise_around(body));
  }

  const CastOptions<double>& options_;
  bool usable_ = false, moves_ = false, ended_ = true;
  SweptBox box_ = SweptBox::nothing();
};

CastResult<double> clear_miss() {
  CastResult<double> out;
  out.outcome = Outcome::miss;
  out.toi_lower = out.toi_upper = kInfinity<double>;
  return out;
}

}  // namespace

void cast_all(std::span<const Question> questions, std::span<CastResult<double>> answers,
              const CastOptions<double>& options, unsigned threads) {
  for_each_part(std::min(questions.size(), answers.size()), threads,
                [&](std::size_t k) { answers[k] = graze::cast(*questions[k].a, *questions[k].b, options); });
}

void cast_all(std::span<const RotatingQuestion> questions, std::span<RotatingResult<double>> answers,
              const RotatingOptions<double>& options, unsigned threads) {
  for_each_part(std::min(questions.size(), answers.size()), threads,
                [&](std::size_t k) { answers[k] = graze::cast(*questions[k].a, *questions[k].b, options); });
}

void cast_all(const Body<double>& one, std::span<const Body<double>> many,
              std::span<CastResult<double>> answers, const CastOptions<double>& options, unsigned threads) {
  const Shared shared(one, options);
  for_each_part(std::min(many.size(), answers.size()), threads, [&](std::size_t k) {
    answers[k] = shared.misses(many[k]) ? clear_miss() : graze::cast(one, many[k], options);
  });
}

void cast_rays(const Body<double>& body, std::span<const RayQuestion> rays,
               std::span<CastResult<double>> answers, const CastOptions<double>& options, unsigned threads) {
  const Shared shared(body, options);
  for_each_part(std::min(rays.size(), answers.size()), threads, [&](std::size_t k) {
    const Body<double> point{
        .shape = Point<double>{}, .position = rays[k].origin, .displacement = rays[k].displacement};
    answers[k] = shared.misses(point) ? clear_miss() : graze::cast(body, point, options);
  });
}

}  // namespace graze::scene
