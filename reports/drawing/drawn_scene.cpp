#include "reports/drawing/drawn_scene.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <graze/distance.hpp>

#include <algorithm>
#include <functional>
#include <graze/penetration.hpp>
#include <numbers>

#include "corpus/format/names.hpp"
#include "engines/method.hpp"
#include "reports/drawing/canvas.hpp"

namespace graze::draw {
namespace {

// Steps of a golden section: each leaves 0.618 of the interval, so 90 leave 2^-62 of it.
constexpr int kGoldenSteps = 90;

// The argument of a least f in [low, high], of the one valley that it is led into.
Real least_by_golden_section(Real low, Real high, const std::function<Real(Real)>& f) {
  const Real part = (std::sqrt(Real(5)) - 1) / 2;
  Real x = high - part * (high - low), y = low + part * (high - low);
  Real fx = f(x), fy = f(y);
  for (int step = 0; step < kGoldenSteps; ++step) {
    if (fx <= fy) {
      high = y;
      y = x;
      fy = fx;
      x = high - part * (high - low);
      fx = f(x);
    } else {
      low = x;
      x = y;
      fx = fy;
      y = low + part * (high - low);
      fy = f(y);
    }
  }
  return fx <= fy ? x : y;
}

// The same, of samples first and then around the least of them.
Real least_of_samples(Real low, Real high, int samples, const std::function<Real(Real)>& f) {
  Real best = low, least = kUnbounded;
  const Real step = (high - low) / samples;
  for (int k = 0; k <= samples; ++k) {
    const Real value = f(low + step * k);
    if (!(value < least)) continue;
    least = value;
    best = low + step * k;
  }
  const Real found = least_by_golden_section(std::max(low, best - step), std::min(high, best + step), f);
  return f(found) < least ? found : best;
}

class Analysis {
 public:
  explicit Analysis(const corpus::Case& problem) : problem_(problem) {
    scene_.problem = &problem;
    scene_.origin = wide(problem.a.position);
    near_ = problem;
    near_.a.position = Vec3<double>::Zero();
    near_.b.position = (wide(problem.b.position) - scene_.origin).cast<double>();
  }

  Scene operator()() {
    ask();
    if (!scene_.drawable) return scene_;
    measure();
    if (problem_.query != corpus::Query::cast && problem_.query != corpus::Query::line &&
        problem_.query != corpus::Query::swept_overlap) {
      stand_still();
    } else if (scene_.has_contact) {
      meet();
    } else {
      pass();
    }
    find_velocity();
    if (scene_.speed > 0 || scene_.turns) find_margin();
    find_end();
    return scene_;
  }

 private:
  // Fills `result` and `drawable`, and the contact data of the answer.
  void ask() {
    if (problem_.query == corpus::Query::cast) {
      const engine::Method& method = *engine::find_method(engine::Kind::rotating, "plan/double");
      const engine::Ask everything{.request = Request::normal | Request::witnesses};
      const engine::Answer answer = method.ask(problem_, everything);
      outcome_ = answer.outcome;
      scene_.result = corpus::name_of(answer.outcome);
      scene_.drawable = answer.outcome != Outcome::invalid_input;
      if (answer.passed_over) scene_.result += ", the start in contact passed over";
      if (outcome_ == Outcome::hit || outcome_ == Outcome::not_converged) {
        scene_.result += fmt::format(" at t = {}", answer.toi_lower);
        scene_.moment = answer.toi_lower;
      }
      if (outcome_ == Outcome::hit) {
        // The same question about A's position: its points are not rounded at a far offset.
        const engine::Answer near = method.ask(near_, everything);
        if (near.outcome == Outcome::hit) {
          witness_ = {0, wide(near.normal), wide(near.point_a), wide(near.point_b)};
        } else {
          witness_ = {0, wide(answer.normal), wide(answer.point_a) - scene_.origin,
                      wide(answer.point_b) - scene_.origin};
        }
      }
    } else {
      for (const engine::Method& method : engine::methods(engine::Kind::query)) {
        if (method.query != problem_.query) continue;
        const engine::Answer answer = method.answer(problem_);
        outcome_ = answer.outcome;
        describe(answer);
        break;
      }
    }
    scene_.has_contact = outcome_ == Outcome::hit || outcome_ == Outcome::initially_overlapping;
  }

  void describe(const engine::Answer& answer) {
    scene_.drawable = answer.outcome != Outcome::invalid_input;
    scene_.result = fmt::format("{}: {}", corpus::name_of(problem_.query), corpus::name_of(answer.outcome));
    if (answer.separation) scene_.result += fmt::format(", distance {}", answer.separation->lower);
    if (answer.depth) scene_.result += fmt::format(", depth {}", answer.depth->upper);
    if (answer.t_in) {
      scene_.result += fmt::format(", in contact from t = {} to {}", answer.t_in->lower, answer.t_out->upper);
      scene_.moment = std::clamp<Real>(answer.t_in->lower, 0, problem_.t_max);
    }
  }

  void measure() {
    const Extent a = extent(problem_.a.shape), b = extent(problem_.b.shape);
    const Pose at_a = scene_.pose_a(0, Vec::Zero()), at_b = scene_.pose_b(0, Vec::Zero());
    scene_.diagonal_a = a.diagonal;
    scene_.diagonal_b = b.diagonal;
    const Vec between =
        (at_b.position + at_b.rotation * b.middle) - (at_a.position + at_a.rotation * a.middle);
    scene_.scale = std::max({a.diagonal, b.diagonal, between.norm()});
    scene_.turns = engine::turns(problem_);
    scene_.turn_rate = std::max(wide(problem_.spin_a.rotation).norm(), wide(problem_.spin_b.rotation).norm());
    // So far from the origin, the offset is the subject of the case.
    if (scene_.scale > 0 && scene_.origin.norm() > kFar * scene_.scale) {
      scene_.result += fmt::format("; {} from the origin", plain_number(scene_.origin.norm()));
    }
    relative_ = wide(problem_.b.displacement) - wide(problem_.a.displacement);
  }

  [[nodiscard]] Separation separation_at(Real t) const {
    const Body<double> a = placed(problem_.a, scene_.pose_a(t, Vec::Zero()));
    const Body<double> b = placed(problem_.b, scene_.pose_b(t, Vec::Zero()));
    const DistanceResult<double> apart = distance(a, b);
    if (apart.lower > 0) {
      return {apart.upper, wide(apart.normal), wide(apart.point_a), wide(apart.point_b)};
    }
    const PenetrationResult<double> in = penetration(a, b);
    if (in.outcome == Outcome::initially_overlapping) {
      return {-in.upper, wide(in.normal), wide(in.point_a), wide(in.point_b)};
    }
    return {apart.upper, wide(in.normal), wide(apart.point_a), wide(apart.point_b)};
  }
  static Body<double> placed(const Body<double>& body, const Pose& pose) {
    Eigen::Quaternion<Real> q(pose.rotation);
    q.normalize();
    Body<double> out;
    out.shape = body.shape;
    out.position = pose.position.cast<double>();
    out.orientation = {static_cast<double>(q.w()), static_cast<double>(q.x()), static_cast<double>(q.y()),
                       static_cast<double>(q.z())};
    return out;
  }

  void take(const Separation& s) {
    scene_.focus = (s.point_a + s.point_b) / 2;
    scene_.touching_a = s.point_a;
    scene_.touching_b = s.point_b;
    if (s.normal.norm() > Real(0.5)) scene_.normal = s.normal.normalized();
  }

  void stand_still() {
    scene_.moment = 0;
    const Separation now = separation_at(0);
    take(now);
    keep_margin(std::abs(now.distance), now.distance < 0 ? "depth" : "distance");
  }

  void meet() {
    if (problem_.query != corpus::Query::cast || outcome_ == Outcome::initially_overlapping) {
      const Separation then = separation_at(scene_.moment);
      take(then);
      if (outcome_ == Outcome::initially_overlapping) keep_margin(std::abs(then.distance), "depth at t = 0");
    } else {
      take(witness_);
    }
  }

  // The nearest approach within the time that matters.
  void pass() {
    Real last = problem_.t_max;
    if (!scene_.turns) {
      // Beyond, the path leads away: |x + t v| grows once t |v| > |x|.
      const Real speed = relative_.norm();
      const Real reach = 2 * (scene_.scale + scene_.diagonal_a + scene_.diagonal_b);
      last = speed > 0 ? std::min(last, 2 * reach / speed) : 0;
    }
    if (outcome_ != Outcome::not_converged) {
      const auto distance_at = [&](Real t) { return separation_at(t).distance; };
      const Real radians = scene_.turn_rate * last;
      // A minimum of a rotating body's distance is rarely narrower than a sixteenth of a radian.
      const int samples = scene_.turns ? static_cast<int>(std::clamp<Real>(16 * radians, 64, 8192)) : 1;
      scene_.moment = last > 0 ? least_of_samples(0, last, samples, distance_at) : Real(0);
    }
    const Separation then = separation_at(scene_.moment);
    take(then);
    const Real clearance = finer(then);
    if (!(clearance > 0)) return;
    // To a target distance it is more than what the path is clear by.
    const char* const name = problem_.target_distance > 0 ? "least distance" : "clearance";
    keep_margin(clearance, name);
    if (!scene_.margin) scene_.result += fmt::format("; {}: {}", name, plain_number(clearance));
  }

  // The distance along its normal in Real, if that has more digits than the doubles it was found in.
  [[nodiscard]] Real finer(const Separation& s) const {
    const Real by_normal = -height_of_cso(s.normal);
    return by_normal > s.distance / 2 ? by_normal : s.distance;
  }
  // h(n) of C at the moment.
  [[nodiscard]] Real height_of_cso(const Vec& n) const {
    return height(problem_.a.shape, scene_.pose_a(scene_.moment, scene_.focus), n) +
           height(problem_.b.shape, scene_.pose_b(scene_.moment, scene_.focus), Vec(-n));
  }

  void find_velocity() {
    const auto at = [&](const corpus::Spin& spin, const Body<double>& body, const Pose& pose) {
      const Vec arm = scene_.focus - (pose.position + pose.rotation * wide(spin.pivot));
      return Vec(wide(body.displacement) + wide(spin.rotation).cross(arm));
    };
    scene_.velocity = at(problem_.spin_b, problem_.b, scene_.pose_b(scene_.moment, Vec::Zero())) -
                      at(problem_.spin_a, problem_.a, scene_.pose_a(scene_.moment, Vec::Zero()));
    scene_.speed = scene_.velocity.norm();
  }

  // Finds the first small quantity that decides the answer.
  void find_margin() {
    if (outcome_ == Outcome::hit) {
      if (scene_.moment > 0) {
        const Separation start = separation_at(0);
        if (start.distance > 0) keep_margin(start.distance, "gap at t = 0");
      }
      if (!scene_.margin) keep_margin(scene_.turns ? depth_of_turn() : depth_of_line(), "depth");
    } else if (outcome_ == Outcome::miss && !scene_.turns) {
      depth_of_line();  // its normal is the better one
    }
  }

  // The least h(n) over n across the motion: how deep the line is in C, or minus how far from it.
  Real depth_of_line() {
    const Vec along = scene_.velocity.normalized();
    const Vec first = along.unitOrthogonal(), second = along.cross(first);
    const auto n_at = [&](Real angle) { return Vec(std::cos(angle) * first + std::sin(angle) * second); };
    const Real best = least_of_samples(0, 2 * std::numbers::pi_v<Real>, 720,
                                       [&](Real angle) { return height_of_cso(n_at(angle)); });
    const Real depth = height_of_cso(n_at(best));
    // For a path that just misses: the normal between the bodies, to all digits.
    if (depth < 0 && scene_.margin) scene_.normal = n_at(best);
    return depth > 0 ? depth : -1;
  }

  // The greatest depth of the contact that begins at the moment: steps that double until it gets less.
  Real depth_of_turn() {
    const Real last = problem_.t_max;
    const auto depth_at = [&](Real t) { return -separation_at(t).distance; };
    Real step = Real(1e-15) * std::max(last, scene_.moment), before = scene_.moment, t = scene_.moment;
    Real deepest = depth_at(t);
    while (t < last) {
      const Real next = std::min(last, t + step), depth = depth_at(next);
      if (depth < deepest) {
        const Real top = least_by_golden_section(before, next, [&](Real x) { return -depth_at(x); });
        return std::max(deepest, depth_at(top));
      }
      before = t;
      t = next;
      deepest = depth;
      step *= 2;
    }
    return deepest;
  }

  void keep_margin(Real length, const char* name) {
    if (!(length > 0) || !(length < kSmall * scene_.scale)) return;
    scene_.margin = length;
    scene_.margin_name = name;
  }

  void find_end() {
    scene_.end = scene_.moment;
    if (scene_.has_contact || !(scene_.speed > 0)) return;
    const Real bodies = std::max(scene_.diagonal_a, scene_.diagonal_b);
    const Real further = (bodies > 0 ? bodies : scene_.scale) / scene_.speed;
    scene_.end = std::min<Real>(problem_.t_max, scene_.moment + std::max(scene_.moment, further));
  }

  // A length below this part of the scale cannot be seen in a picture of the whole.
  static constexpr Real kSmall = Real(1) / 50;
  static constexpr Real kFar = 50;  // scales

  const corpus::Case& problem_;
  corpus::Case near_;  // A's position is 0
  Scene scene_;
  Outcome outcome_ = Outcome::invalid_input;
  Separation witness_;  // witnesses of a hit
  Vec relative_ = Vec::Zero();
};

// The direction across `axis` along which the bodies are widest.
Vec widest_across(const Scene& scene, const Vec& axis) {
  const Vec first = axis.unitOrthogonal(), second = axis.cross(first);
  const Pose a = scene.pose_a(scene.moment, scene.focus), b = scene.pose_b(scene.moment, scene.focus);
  Vec best = first;
  Real most = -1;
  constexpr int kDirections = 24;
  for (int k = 0; k < kDirections; ++k) {
    const Real angle = std::numbers::pi_v<Real> * k / kDirections;
    const Vec n = std::cos(angle) * first + std::sin(angle) * second;
    const auto width = [&](const Shape<double>& shape, const Pose& pose, Real diagonal) {
      return diagonal > 0 ? (height(shape, pose, n) + height(shape, pose, Vec(-n))) / diagonal : Real(0);
    };
    const Real widths = width(scene.problem->a.shape, a, scene.diagonal_a) +
                        width(scene.problem->b.shape, b, scene.diagonal_b);
    if (!(widths > most * Real(1.0001))) continue;
    most = widths;
    best = n;
  }
  return best;
}

View upright(const Vec& right, const Vec& up) { return {right, up, right.cross(up)}; }

}  // namespace

Scene make_scene(const corpus::Case& problem) { return Analysis(problem)(); }

View make_view(const Scene& scene, const std::optional<Vec3<double>>& axis) {
  constexpr Real kParallel = Real(0.02);  // sine of the angle
  if (axis) {
    const Vec towards = wide(*axis).normalized();
    for (const Vec& wish : {scene.normal, Vec(Vec::UnitZ()), Vec(Vec::UnitY())}) {
      const Vec up = wish - wish.dot(towards) * towards;
      if (up.norm() > kParallel) return upright(up.normalized().cross(towards), up.normalized());
    }
  }
  const bool moves = scene.speed > 0;
  if (!(scene.normal.norm() > 0)) {
    const Vec right = moves ? Vec(scene.velocity.normalized()) : Vec(Vec::UnitX());
    return upright(right, widest_across(scene, right));
  }
  const Vec up = scene.normal;
  if (moves) {
    const Vec v = scene.velocity.normalized(), right = v - v.dot(up) * up;
    if (right.norm() > kParallel) {
      const Vec unit_right = right.normalized();
      return upright(unit_right, up);
    }
  }
  return upright(widest_across(scene, up), up);
}

}  // namespace graze::draw
