#include <graze/cast_all.hpp>

#include <graze/detail/casts/exact_ends.hpp>
#include <graze/detail/rays/ray_answer.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/scene/swept_box.hpp>

#include <algorithm>
#include <new>
#include <type_traits>

#include "parallel.hpp"

namespace graze::scene {
namespace {

// So many casts are one job: enough that handing them out costs nothing.
constexpr std::size_t kPart = 64;

template <class Job>
void for_each_part(std::size_t count, unsigned threads, const Job& job) {
  for_each_index((count + kPart - 1) / kPart, threads,
                 [&](std::size_t part) { job(part * kPart, std::min(count, (part + 1) * kPart)); });
}

// Constructs the answer in place. It has 1,568 bytes, and an assignment would write all of them twice.
template <class Make>
void answer_by(CastResult<double>& answer, const Make& make) {
  static_assert(std::is_trivially_destructible_v<CastResult<double>>);
  ::new (static_cast<void*>(&answer)) CastResult<double>(make());
}

// The exact tier refuses curved bodies, however far apart.
bool is_known_to(Tier tier, const Body<double>& body) {
  return tier != Tier::exact || detail::exact::takes(body.shape);
}

// Is "miss" the whole answer of a cast of the body against anything that stays clear of it? A proof has an axis, too.
bool spares_misses(const Body<double>& body, const CastOptions<double>& options) {
  return validate(body, body, options) == Invalid::none && !asks_for(options.request, Request::proof) &&
         options.start_policy == StartPolicy::report && is_known_to(options.tier, body);
}

// One body's box, made once, and whether another body stays clear of it. An invalid body never does: its cast says
// what is wrong.
class Shared {
 public:
  Shared(const Body<double>& body, const CastOptions<double>& options) : options_(options) {
    usable_ = spares_misses(body, options);
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
  [[nodiscard]] SweptBox box_of(const Body<double>& body, double end) const {
    return contact_box(body, {}, end, options_.target_distance);
  }

  const CastOptions<double>& options_;
  bool usable_ = false, moves_ = false, ended_ = true;
  SweptBox box_ = SweptBox::nothing();
};

// The same for rays: the slabs of the body's box at t = 0 are made once, and a ray is clipped by them in the frame
// of the body. No box of the ray is needed.
//
//   miss  iff  no t in [0, t_max] has  low_i <= p_i + t (v - v_body)_i <= high_i  for i = 0, 1, 2
//
// Slack: the body's box has its noise around it, and the noise of a point is 2^-36 |p|_1 (swept_box.hpp).
// Rounding, u = 2^-53: at a contact |t (v - v_body)_i| <= |p_i| + m_i, m_i = max(|low_i|, |high_i|). The
// difference v - v_body is within u of itself, so the path is within u (|p_i| + m_i) of the true one. The two
// subtractions for a slab's end lose at most 2 u of the same. Together that is below 4 u. The slack has
// 2^-48 |p|_1 = 32 u |p|_1 more than the noise, and each slab is widened by 8 u m_i once. The last subtraction
// has the exact sign, so a ray that starts beyond a slab and moves away is decided exactly. A time has two
// roundings, of a reciprocal and of a product, and is moved outward by 8 u.
class RayFilter {
 public:
  RayFilter(const Body<double>& body, const CastOptions<double>& options)
      : velocity_(body.displacement), t_max_(options.t_max), usable_(spares_misses(body, options)) {
    if (!usable_) return;
    // Twice the distance: a point's half of it is the body's too.
    const SweptBox box = contact_box(body, {}, 0, 2 * options.target_distance);
    const Vec3<double> lost = 8 * kUnitRoundoff<double> * box.low0.cwiseAbs().cwiseMax(box.high0.cwiseAbs());
    low_ = box.low0 - lost;
    high_ = box.high0 + lost;
  }

  // A proved miss, whatever the tier.
  [[nodiscard]] bool misses(const RayQuestion& ray) const {
    if (!usable_ || !detail::is_common(ray.origin) || !detail::is_common(ray.displacement)) return false;
    constexpr double kOutward = 8 * kUnitRoundoff<double>;
    const Vec3<double>& p = ray.origin;
    const double slack = (0x1p-36 + 0x1p-48) * (std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]));
    double enter = 0, exit = t_max_;
    for (int i = 0; i < 3; ++i) {
      const double to_low = (low_[i] - slack) - p[i], to_high = (high_[i] + slack) - p[i];
      const double speed = ray.displacement[i] - velocity_[i];
      if (speed == 0) {
        if (to_low > 0 || to_high < 0) return true;
        continue;
      }
      const double per_speed = 1 / speed, t_low = to_low * per_speed, t_high = to_high * per_speed;
      enter = std::max(enter, std::min(t_low, t_high) * (1 - kOutward));
      exit = std::min(exit, std::max(t_low, t_high) * (1 + kOutward));
    }
    return enter > exit;
  }

 private:
  Vec3<double> low_, high_, velocity_;
  double t_max_;
  bool usable_;
};

// The casts that a direct clip answers (casts/ray_cast.hpp), of a body that is prepared once.
class DirectRays {
 public:
  DirectRays(const Body<double>& body, const CastOptions<double>& options)
      : options_(options), target_(body), usable_(is_clipped(body, options)) {}

  // False: `out` has not changed.
  [[nodiscard]] bool answer(const RayQuestion& ray, RayAnswer& out) const {
    if (!usable_ || !detail::is_common(ray.origin) || !detail::is_common(ray.displacement)) return false;
    const detail::RayPath<double> path{ray.origin, ray.displacement, options_.t_max,
                                       options_.target_distance};
    detail::RayHit hit;
    detail::clip_any(target_, path, hit);
    const detail::RayTimes<double> times = detail::times_of<double>(hit, options_);
    if (!times.known) return false;
    out.outcome = times.outcome;
    out.toi_lower = times.lower;
    out.toi_upper = times.upper;
    if (times.outcome != Outcome::hit) return true;
    if (asks_for(options_.request, Request::normal)) out.normal = target_.to_world(hit.n).vector();
    if (asks_for(options_.request, Request::witnesses))
      out.point = detail::point_on_body(target_, path, hit, times.lower).vector();
    return true;
  }

 private:
  static bool is_clipped(const Body<double>& body, const CastOptions<double>& options) {
    if (options.tier != Tier::standard || validate(body, body, options) != Invalid::none) return false;
    return !options.method || *options.method == Method::mpr_sweep || *options.method == Method::gjk_ray_cast;
  }

  const CastOptions<double>& options_;
  detail::RayTarget<double> target_;
  bool usable_;
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
  for_each_part(std::min(questions.size(), answers.size()), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      answer_by(answers[k], [&] { return graze::cast(*questions[k].a, *questions[k].b, options); });
  });
}

void cast_all(std::span<const RotatingQuestion> questions, std::span<RotatingResult<double>> answers,
              const RotatingOptions<double>& options, unsigned threads) {
  for_each_part(std::min(questions.size(), answers.size()), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      answers[k] = graze::cast(*questions[k].a, *questions[k].b, options);
  });
}

void cast_all(const Body<double>& one, std::span<const Body<double>> many,
              std::span<CastResult<double>> answers, const CastOptions<double>& options, unsigned threads) {
  const Shared shared(one, options);
  for_each_part(std::min(many.size(), answers.size()), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      answer_by(answers[k],
                [&] { return shared.misses(many[k]) ? clear_miss() : graze::cast(one, many[k], options); });
    }
  });
}

void cast_rays(const Body<double>& body, std::span<const RayQuestion> rays,
               std::span<CastResult<double>> answers, const CastOptions<double>& options, unsigned threads) {
  const RayFilter filter(body, options);
  for_each_part(std::min(rays.size(), answers.size()), threads, [&](std::size_t begin, std::size_t end) {
    Body<double> point{.shape = Point<double>{}};
    for (std::size_t k = begin; k < end; ++k) {
      answer_by(answers[k], [&] {
        if (filter.misses(rays[k])) return clear_miss();
        point.position = rays[k].origin;
        point.displacement = rays[k].displacement;
        return graze::cast(body, point, options);
      });
    }
  });
}

void cast_rays(const Body<double>& body, std::span<const RayQuestion> rays, std::span<RayAnswer> answers,
               const CastOptions<double>& options, unsigned threads) {
  const RayFilter filter(body, options);
  const DirectRays direct(body, options);
  CastOptions<double> without_proof = options;
  if (asks_for(options.request, Request::proof)) {
    without_proof.request = static_cast<Request>(static_cast<unsigned>(options.request) & ~4u);
  }
  for_each_part(std::min(rays.size(), answers.size()), threads, [&](std::size_t begin, std::size_t end) {
    Body<double> point{.shape = Point<double>{}};
    for (std::size_t k = begin; k < end; ++k) {
      RayAnswer& out = answers[k] = {};
      if (filter.misses(rays[k])) {
        out.outcome = Outcome::miss;
        out.toi_lower = out.toi_upper = kInfinity<double>;
      } else if (!direct.answer(rays[k], out)) {
        point.position = rays[k].origin;
        point.displacement = rays[k].displacement;
        const CastResult<double> found = graze::cast(body, point, without_proof);
        out = {found.outcome, found.toi_lower, found.toi_upper, found.normal, found.point_a};
      }
    }
  });
}

}  // namespace graze::scene
