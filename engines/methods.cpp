#include <algorithm>
#include <cmath>

#include "corpus/format/names.hpp"
#include "engines/guarantees.hpp"
#include "engines/method.hpp"
#include "engines/ours.hpp"

namespace graze::engine {

Answer not_taken() {
  return {.outcome = Outcome::invalid_input, .toi_lower = std::nan(""), .toi_upper = std::nan("")};
}

std::string Method::question_name() const {
  switch (kind) {
    case Kind::linear:
      return full_name();
    case Kind::query:
      return std::string(corpus::name_of(query)) + " " + full_name();
    case Kind::rotating:
      break;
  }
  return "rotating " + full_name();
}

std::span<const Method> methods() {
  static const std::vector<Method> kMethods = [] {
    std::vector<Method> all;
    add_linear_methods(all);
    add_query_methods(all);
    add_rotating_methods(all);
    for (Method& method : all) method.guarantee = find_guarantee(guarantees(), method);
    return all;
  }();
  return kMethods;
}

std::span<const Method> methods(Kind kind) {
  const auto is_of_kind = [&](const Method& method) { return method.kind == kind; };
  const std::span<const Method> all = methods();
  const auto first = std::find_if(all.begin(), all.end(), is_of_kind);
  return {first, std::find_if_not(first, all.end(), is_of_kind)};
}

namespace {

const Method* find_if(std::string_view name, auto&& is_meant) {
  for (const Method& method : methods()) {
    if (is_meant(method) && (name == method.name || name == method.full_name())) return &method;
  }
  return nullptr;
}

}  // namespace

const Method* find_method(Kind kind, std::string_view name) {
  return find_if(name, [&](const Method& method) { return method.kind == kind; });
}

const Method* find_method(corpus::Query query, std::string_view name) {
  return find_if(name,
                 [&](const Method& method) { return method.kind == Kind::query && method.query == query; });
}

std::string_view to_text(Kind kind) {
  switch (kind) {
    case Kind::linear:
      return "linear";
    case Kind::query:
      return "query";
    case Kind::rotating:
      return "rotating";
  }
  return "";
}

std::string_view to_text(Failure failure) {
  switch (failure) {
    case Failure::none:
      return "none";
    case Failure::crashed:
      return "crashed";
    case Failure::hung:
      return "hung";
    case Failure::silent:
      return "silent";
    case Failure::half_a_line:
      return "half a line";
    case Failure::garbage:
      return "garbage";
    case Failure::wrong_id:
      return "another's answer";
    case Failure::non_finite:
      return "no number";
    case Failure::out_of_range:
      return "out of range";
    case Failure::out_of_memory:
      return "out of memory";
    case Failure::orphaned_process:
      return "left behind";
  }
  return "";
}

std::string unsupported(Kind kind, const corpus::Case& problem) {
  const bool is_cast = problem.query == corpus::Query::cast;
  if (kind == Kind::rotating) return is_cast ? "" : "a query other than cast";
  const bool along_the_path =
      is_cast || problem.query == corpus::Query::line || problem.query == corpus::Query::swept_overlap;
  if (kind == Kind::query && !along_the_path) return {};
  if (turns(problem)) return "a rotating motion";
  return kind == Kind::linear && !is_cast ? "a query other than cast" : "";
}

bool turns(const corpus::Case& problem) {
  // Written so that a NaN counts as a rotation, too.
  return !(problem.spin_a.rotation == Vec3<double>::Zero() &&
           problem.spin_b.rotation == Vec3<double>::Zero());
}

namespace {

// rounded: or one with a ball about it.
bool is_polytope(const Shape<double>& shape, bool rounded) {
  const auto part_is = [&](const SharedShape<double>& part) {
    return part && is_polytope(part->shape, rounded);
  };
  return std::visit(
      [&]<class T>(const T& s) {
        if constexpr (std::same_as<T, Posed<double>>) {
          return part_is(s.shape);
        } else if constexpr (std::same_as<T, Rounded<double>>) {
          return rounded && part_is(s.shape);
        } else if constexpr (std::same_as<T, Sum<double>>) {
          return std::all_of(s.shapes.begin(), s.shapes.end(), part_is);
        } else if constexpr (std::same_as<T, Sphere<double>> || std::same_as<T, Capsule<double>>) {
          return rounded;
        } else {
          return std::same_as<T, Point<double>> || std::same_as<T, Segment<double>> ||
                 std::same_as<T, Triangle<double>> || std::same_as<T, Box<double>> ||
                 std::same_as<T, Hull<double>>;
        }
      },
      shape);
}

}  // namespace

bool is_exact_ray(const corpus::Case& seen) {
  const auto is_point = [](const Shape<double>& shape) {
    return std::holds_alternative<Point<double>>(shape);
  };
  const auto is_solid = [](const Shape<double>& shape) {
    return std::holds_alternative<Ellipsoid<double>>(shape) ||
           std::holds_alternative<Cylinder<double>>(shape) || std::holds_alternative<Cone<double>>(shape);
  };
  return seen.query == corpus::Query::cast && seen.target_distance == 0 &&
         ((is_point(seen.a.shape) && is_solid(seen.b.shape)) ||
          (is_point(seen.b.shape) && is_solid(seen.a.shape)));
}

bool is_exact_question(const corpus::Case& seen) {
  return (is_polytope(seen.a.shape, true) && is_polytope(seen.b.shape, true)) || is_exact_ray(seen);
}

bool is_sharp_question(const corpus::Case& seen) {
  return is_polytope(seen.a.shape, false) && is_polytope(seen.b.shape, false) && seen.target_distance == 0;
}

}  // namespace graze::engine
