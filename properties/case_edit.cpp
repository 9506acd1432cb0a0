#include "properties/case_edit.hpp"

#include <bit>
#include <cmath>

namespace graze::law {

using corpus::Case;

namespace {

bool zero(const Quaternion<double>& q) { return q.w == 0 && q.is_identity(); }

}  // namespace

std::vector<double> scalars(const Case& problem) {
  std::vector<double> all;
  (void)map_scalars(problem, [&](Slot, double x) {
    all.push_back(x);
    return x;
  });
  return all;
}

bool same_input(const Case& left, const Case& right) {
  if (outline(left.a.shape) != outline(right.a.shape) || outline(left.b.shape) != outline(right.b.shape)) {
    return false;
  }
  const std::vector<double> l = scalars(left), r = scalars(right);
  for (std::size_t i = 0; i < l.size(); ++i) {
    if (!(l[i] == r[i]) && !(std::isnan(l[i]) && std::isnan(r[i]))) return false;
  }
  return true;
}

bool in_domain(const Case& problem) {
  if (must_be_refused(problem)) return false;
  bool inside = true;
  (void)map_scalars(problem, [&](Slot slot, double x) {
    const double size = std::abs(x);
    if (slot != Slot::horizon) inside = inside && (size == 0 || (size >= 1e-60 && size <= 1e60));
    return x;
  });
  return inside;
}

bool must_be_refused(const Case& problem) {
  if (is_malformed(problem.a.shape) || is_malformed(problem.b.shape)) return true;
  if (zero(problem.a.orientation) || zero(problem.b.orientation)) return true;
  bool bad = false;
  (void)map_scalars(problem, [&](Slot slot, double x) {
    if (slot == Slot::horizon) {
      bad = bad || !(x >= 0);
    } else {
      bad = bad || !std::isfinite(x);
      if (slot == Slot::extent || slot == Slot::target) bad = bad || x < 0;
    }
    return x;
  });
  return bad;
}

bool is_polytope(const Case& problem) {
  return problem.target_distance == 0 && is_polytope(problem.a.shape) && is_polytope(problem.b.shape);
}

// The fused error term is exact unless it falls below the subnormals, which the second test excludes.
std::optional<double> exact_product(double a, double b) {
  const double p = a * b;
  if (!std::isfinite(p) || std::fma(a, b, -p) != 0) return std::nullopt;
  if (p != 0 ? std::abs(p) < 1e-290 : (a != 0 && b != 0)) return std::nullopt;
  return p;
}

Vec3<double> velocity(const Case& problem) { return problem.b.displacement - problem.a.displacement; }

Case swapped(const Case& problem) {
  Case other = problem;
  std::swap(other.a, other.b);
  other.expect.reset();
  return other;
}

std::optional<Case> scaled(const Case& problem, int k) {
  bool exact = true;
  Case other = map_scalars(problem, [&](Slot slot, double x) {
    if (!is_length(slot)) return x;
    const double y = std::scalbn(x, k);
    exact = exact && std::scalbn(y, -k) == x;
    return y;
  });
  other.expect.reset();
  if (!exact || !in_domain(other)) return std::nullopt;
  return other;
}

std::optional<Case> translated(const Case& problem, std::uint64_t salt) {
  // Large first: a common offset must cost no accuracy. The last ones fit cases whose positions are full
  // doubles.
  const double pool[] = {0x1p30, -0x1p24, 1048576, -65536, 4096, -1000, 37, -3, 1, 0.5, -0.125};
  constexpr std::size_t kPool = std::size(pool);
  Case other = problem;
  bool moved = false;
  for (int i = 0; i < 3; ++i) {
    const std::uint64_t pick = mix(salt + static_cast<std::uint64_t>(i));
    double &a = other.a.position[i], &b = other.b.position[i];
    const double tail[] = {-a, -b};
    for (std::size_t j = 0; j < kPool + 2; ++j) {
      const double shift = j < kPool ? pool[(j + pick % 5) % kPool] : tail[j - kPool];
      const auto to_a = exact_sum(a, shift), to_b = exact_sum(b, shift);
      if (shift == 0 || !to_a || !to_b) continue;
      a = *to_a;
      b = *to_b;
      moved = true;
      break;
    }
  }
  other.expect.reset();
  if (!moved || !in_domain(other)) return std::nullopt;
  return other;
}

Case grown(const Case& problem, std::uint64_t salt) {
  Case other = problem;
  other.expect.reset();
  const std::uint64_t pick = mix(salt ^ 0x67726f77u);
  Body<double>& body = pick & 1 ? other.a : other.b;
  body.shape = grown(body.shape, pick);
  return other;
}

std::optional<Case> ray_against_cso(const Case& problem) {
  if (!is_polytope(problem)) return std::nullopt;
  const auto sign_a = signs_of(problem.a.orientation), sign_b = signs_of(problem.b.orientation);
  // 400 differences at most: the law is about the identity, not about speed.
  constexpr std::size_t kMost = 400;
  const auto local_a = exact_vertices(problem.a.shape, kMost),
             local_b = exact_vertices(problem.b.shape, kMost);
  if (!sign_a || !sign_b || !local_a || !local_b || local_a->size() * local_b->size() > kMost) {
    return std::nullopt;
  }
  std::vector<Vec3<double>> differences;
  for (const Vec3<double>& local : *local_a) {
    const auto a = exact_sum(problem.a.position, Vec3<double>(sign_a->cwiseProduct(local)));
    if (!a) return std::nullopt;
    for (const Vec3<double>& other : *local_b) {
      const auto b = exact_sum(problem.b.position, Vec3<double>(sign_b->cwiseProduct(other)));
      if (!b) return std::nullopt;
      const auto c = exact_sum(*a, Vec3<double>(-*b));
      if (!c) return std::nullopt;
      differences.push_back(*c);
    }
  }
  const auto v = exact_sum(problem.b.displacement, Vec3<double>(-problem.a.displacement));
  if (!v) return std::nullopt;
  Case ray = problem;
  ray.expect.reset();
  ray.a = Body<double>{};
  ray.b = Body<double>{};
  ray.a.shape = Hull<double>(std::span<const Vec3<double>>(differences));
  ray.b.displacement = *v;
  if (!in_domain(ray)) return std::nullopt;
  return ray;
}

std::optional<Split> split(const Case& problem, std::uint64_t salt) {
  const double horizon = std::isinf(problem.t_max) ? 2 : problem.t_max;
  const double fractions[] = {0.5, 0.25, 0.75, 0.125, 0.875};
  const std::uint64_t first = mix(salt ^ 0x73706c69u);
  for (std::size_t j = 0; j < std::size(fractions); ++j) {
    const double fraction = fractions[(j + first) % std::size(fractions)];
    const auto s = exact_product(fraction, horizon);
    if (!s || !(*s > 0)) continue;
    const auto rest =
        std::isinf(problem.t_max) ? std::optional(problem.t_max) : exact_sum(problem.t_max, -*s);
    if (!rest) continue;
    Split parts{*s, problem, problem};
    parts.before.expect.reset();
    parts.after.expect.reset();
    parts.before.t_max = *s;
    parts.after.t_max = *rest;
    bool exact = true;
    for (Body<double>* body : {&parts.after.a, &parts.after.b}) {
      for (int i = 0; i < 3 && exact; ++i) {
        const auto step = exact_product(*s, body->displacement[i]);
        const auto there = step ? exact_sum(body->position[i], *step) : std::nullopt;
        exact = there.has_value();
        if (exact) body->position[i] = *there;
      }
    }
    if (exact && in_domain(parts.after)) return parts;
  }
  return std::nullopt;
}

std::uint64_t hash_of(const Case& problem) {
  std::uint64_t h = 0;
  for (const Body<double>* body : {&problem.a, &problem.b}) {
    for (const std::uint32_t word : outline(body->shape)) h = mix(h ^ word);
  }
  for (const double x : scalars(problem)) h = mix(h ^ std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x));
  return h;
}

}  // namespace graze::law
