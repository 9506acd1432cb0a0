#include "properties/edit/turning.hpp"

#include <cmath>
#include <iterator>

#include "properties/edit/case.hpp"
#include "properties/edit/shape.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Spin;

namespace {

bool turns(const Spin& spin) { return !spin.rotation.isZero(0); }

// A body's rotation must not be near the ends of the range, or its multiples leave it.
bool is_moderate(const Vec3<double>& w) { return w.norm() >= 0x1p-20 && w.norm() <= 0x1p20; }

}  // namespace

namespace {

// By lengths of 2^-4 to 2^4 or so.
std::optional<Vec3<double>> along_the_axis(const Spin& spin, const Vec3<double>& signs, std::uint64_t pick) {
  constexpr int kSlides[] = {1, -1, 4, -4, 0, 2};
  const int power = -std::ilogb(spin.rotation.norm());
  const double sense = (pick & 256) != 0 ? 1 : -1;
  for (std::size_t j = 0; j < std::size(kSlides); ++j) {
    const int slide = kSlides[(j + pick) % std::size(kSlides)];
    const Vec3<double> by = std::scalbn(sense, power + slide) * signs.cwiseProduct(spin.rotation);
    if (auto pivot = exact_sum(spin.pivot, by)) return pivot;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SlidPivot> with_slid_pivot(const Case& problem, bool first, std::uint64_t salt) {
  SlidPivot out{problem, {}};
  out.before.expect.reset();
  Body<double>& body = first ? out.before.a : out.before.b;
  Spin& spin = first ? out.before.spin_a : out.before.spin_b;
  if (!signs_of(body.orientation)) body.orientation = {};
  const auto signs = signs_of(body.orientation);
  if (!signs || !turns(spin) || !is_moderate(spin.rotation)) return std::nullopt;
  std::optional<Vec3<double>> pivot = along_the_axis(spin, *signs, mix(salt));
  if (!pivot) {
    spin.rotation = spin.rotation.cast<float>().cast<double>();
    spin.pivot = spin.pivot.cast<float>().cast<double>();
    pivot = along_the_axis(spin, *signs, mix(salt));
    if (!pivot) return std::nullopt;
  }
  out.after = out.before;
  (first ? out.after.spin_a : out.after.spin_b).pivot = *pivot;
  if (!in_domain(out.before) || !in_domain(out.after)) return std::nullopt;
  return out;
}

std::optional<Case> with_idle_pivots(const Case& problem, std::uint64_t salt) {
  constexpr double kPivots[] = {1, -64, 0x1p20, 0.375, -3};
  Case other = problem;
  other.expect.reset();
  bool idle = false;
  for (Spin* spin : {&other.spin_a, &other.spin_b}) {
    if (turns(*spin)) continue;
    idle = true;
    for (int i = 0; i < 3; ++i) {
      salt = mix(salt);
      spin->pivot[i] += kPivots[salt % std::size(kPivots)];
    }
  }
  if (!idle || !in_domain(other)) return std::nullopt;
  return other;
}

std::optional<Drift> drifting(const Case& problem, std::uint64_t salt) {
  constexpr double kSpeeds[] = {1, -8, 0.25, 64, -0.5};
  Drift out;
  out.problem = problem;
  out.problem.expect.reset();
  for (int i = 0; i < 3; ++i) {
    salt = mix(salt);
    const double u = kSpeeds[salt % std::size(kSpeeds)];
    const auto a = exact_sum(problem.a.displacement[i], u), b = exact_sum(problem.b.displacement[i], u);
    if (!a || !b) continue;
    out.drift[i] = u;
    out.problem.a.displacement[i] = *a;
    out.problem.b.displacement[i] = *b;
  }
  if (out.drift.isZero(0) || !in_domain(out.problem)) return std::nullopt;
  return out;
}

std::optional<Standing> standing_at(const Case& problem, double s) {
  if (!(s >= 0) || !std::isfinite(s)) return std::nullopt;
  Standing out{0, problem};
  out.still.t_max = s;
  if (s > 0) {
    std::optional<Restart> end = restarted(out.still, 1);
    if (!end) return std::nullopt;
    out.error = end->error;
    out.still = std::move(end->after);
  }
  out.still.expect.reset();
  out.still.spin_a = out.still.spin_b = {};
  out.still.a.displacement.setZero();
  out.still.b.displacement.setZero();
  out.still.t_max = 0;
  return out;
}

std::optional<WayBack> way_back(const Case& problem) {
  std::optional<Restart> end = restarted(problem, 1);
  if (!end) return std::nullopt;
  WayBack out{end->error, std::move(end->after)};
  out.problem.t_max = problem.t_max;
  for (Body<double>* body : {&out.problem.a, &out.problem.b}) body->displacement *= -1;
  for (Spin* spin : {&out.problem.spin_a, &out.problem.spin_b}) spin->rotation *= -1;
  return out;
}

std::optional<WholeTurn> whole_turns(const Case& problem, bool first) {
  constexpr double kFullTurn = 0x1.921fb54442d18p+2;  // radians
  const Spin& spin = first ? problem.spin_a : problem.spin_b;
  if (!turns(spin) || !is_moderate(spin.rotation)) return std::nullopt;
  WholeTurn out{problem, {}};
  out.once.expect.reset();
  (first ? out.once.spin_b : out.once.spin_a) = {};
  out.once.a.displacement.setZero();
  out.once.b.displacement.setZero();
  // By 2^-20 more than a turn: a contact at the very end is a contact at the beginning, too.
  out.once.t_max = static_cast<double>(static_cast<float>(kFullTurn / spin.rotation.norm() * (1 + 0x1p-20)));
  out.often = out.once;
  out.often.t_max *= 8;
  if (!in_domain(out.once) || !in_domain(out.often)) return std::nullopt;
  return out;
}

}  // namespace graze::law
