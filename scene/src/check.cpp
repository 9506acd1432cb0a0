// Checks the requirements on a scene at the entry of run() and plan().
#include <graze/detail/casts/exact_ends.hpp>
#include <graze/detail/rotating/mobility.hpp>
#include <graze/detail/rotating/turn.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/invalid_text.hpp>

#include <algorithm>
#include <cmath>

#include "check.hpp"

namespace graze::scene {
namespace {

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

// The rules of core that the body breaks, as of body a. Its name stands before it.
std::string why_invalid_body(const RotatingBody<double>& moving, double t_max) {
  detail::InvalidFinder<double> find;
  if (validate(moving.body) != Invalid::none && find.body(moving.body, InvalidBody::none))
    return to_text(find.at());
  if (find.vector(InvalidField::rotation, moving.rotation) ||
      find.vector(InvalidField::pivot, moving.pivot)) {
    InvalidAt at = find.at();
    at.part = -1;
    return to_text(at);
  }
  if (t_max < kInfinity<double> && detail::norm(moving.rotation) * t_max > detail::kMostTurn) {
    return "rotation is a turn of more than 2^30 radians";
  }
  return {};
}

// The exact tier casts polytopes and rounded polytopes that do not rotate.
// The body has passed why_invalid_body().
std::string why_not_exact(const RotatingBody<double>& moving) {
  if (moving.rotation != Vec3<double>::Zero()) return "rotates, which the exact tier does not support";
  if (detail::exact::takes(moving.body.shape)) return {};
  return to_text(InvalidAt{
      .why = Invalid::not_exact, .body = InvalidBody::none, .field = InvalidField::shape, .part = 0});
}

template <class Named>
std::string why_names_invalid(const std::vector<Named>& all, const std::string& what) {
  std::vector<std::uint32_t> order(all.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) {
    return all[l].name != all[r].name ? all[l].name < all[r].name : l < r;
  });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::string& name = all[order[k]].name;
    if (!name.empty() && name == all[order[k - 1]].name) {
      return what + " " + std::to_string(order[k - 1]) + " and " + what + " " + std::to_string(order[k]) +
             " have the same name, " + quoted(name) + "; each needs its own";
    }
  }
  return {};
}

std::string why_options_invalid(const Options& options) {
  if (detail::check_arithmetic() != Invalid::none) {
    InvalidAt at;
    at.why = detail::check_arithmetic();
    return to_text(at);
  }
  if (!(options.t_max >= 0 && options.t_max < kInfinity<double>) || is_flushed(options.t_max)) {
    return "t_max of the step is negative, NaN or infinite; a step has an end";
  }
  CastOptions<double> pair;
  pair.target_distance = options.target_distance;
  pair.tolerance = options.tolerance;
  if (validate(pair) == Invalid::bad_target) return "target_distance is negative, NaN or out of range";
  if (validate(pair) == Invalid::bad_tolerance) return "tolerance is negative, NaN or infinite";
  return {};
}

std::string why_invalid_probe(const Probe& probe, Tier tier) {
  const RotatingBody<double>& body = probe.body;
  if (std::string why = why_invalid_body(body, probe.t_max); !why.empty()) return why;
  if (!(probe.t_max >= 0) || is_flushed(probe.t_max)) return "t_max is negative or NaN";
  if (body.rotation != Vec3<double>::Zero() && !(probe.t_max < kInfinity<double>))
    return "t_max is infinite, and it rotates";
  return tier == Tier::exact ? why_not_exact(body) : std::string();
}

}  // namespace

std::string why_invalid(const Scene& scene, const Options& options) {
  if (std::string why = why_options_invalid(options); !why.empty()) return why;
  if (scene.bodies.size() > kMostBodies || scene.probes.size() > kMostBodies) {
    return "more than 2^31 bodies or casts";
  }
  for (const Member& member : scene.bodies) {
    std::string why = why_invalid_body(member.body, options.t_max);
    if (why.empty() && options.tier == Tier::exact) why = why_not_exact(member.body);
    if (!why.empty()) return "body " + quoted(member.name) + ": " + why;
  }
  for (const Probe& probe : scene.probes) {
    const std::string why = why_invalid_probe(probe, options.tier);
    if (!why.empty()) return "cast " + quoted(probe.name) + ": " + why;
  }
  if (std::string why = why_names_invalid(scene.bodies, "body"); !why.empty()) return why;
  return why_names_invalid(scene.probes, "cast");
}

}  // namespace graze::scene
