#include "certify/external/terms.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "corpus/format/json_value.hpp"
#include "corpus/format/names.hpp"
#include "corpus/format/shape_json.hpp"
#include "corpus/support_value.hpp"
#include "engines/convert.hpp"
#include "properties/edit/case.hpp"
#include "properties/edit/shape.hpp"
#include "properties/judge/limits.hpp"

namespace graze::external {

using corpus::Case;

namespace {

std::string_view type_of(const Shape<double>& shape) {
  constexpr std::string_view kTypes[] = {"point", "segment",   "triangle", "sphere", "capsule",
                                         "box",   "ellipsoid", "cylinder", "cone",   "hull",
                                         "posed", "rounded",   "sum",      "hull_of"};
  return kTypes[shape.index()];
}

// The vertices of a shape that is the hull of a few points. Empty for any other shape.
std::vector<Vec3<double>> corners_of(const Shape<double>& shape) {
  if (std::holds_alternative<Point<double>>(shape)) return {Vec3<double>::Zero()};
  if (const auto* s = std::get_if<Segment<double>>(&shape)) return {s->a, s->b};
  if (const auto* t = std::get_if<Triangle<double>>(&shape)) return {t->a, t->b, t->c};
  if (const auto* h = std::get_if<Hull<double>>(&shape)) return {h->vertices().begin(), h->vertices().end()};
  std::vector<Vec3<double>> corners;
  if (const auto* b = std::get_if<Box<double>>(&shape)) {
    for (unsigned k = 0; k < 8; ++k) {
      Vec3<double> corner = b->half_extents;
      for (int i = 0; i < 3; ++i) {
        if ((k >> i & 1U) == 0) corner[i] = -corner[i];
      }
      corners.push_back(corner);
    }
  }
  return corners;
}

// The first type within a shape that the engine does not take, as text. Empty if it takes all of them.
std::string not_taken(const Declaration& engine, const Shape<double>& shape) {
  if (!engine.takes(type_of(shape))) return std::string(type_of(shape));
  for (const SharedShape<double>& part : law::parts_of(shape)) {
    if (std::string missing = not_taken(engine, part->shape); !missing.empty()) return missing;
  }
  return {};
}

// The same set as a shape that the engine takes, where there is one.
void offer_as_hull(const Declaration& engine, Shape<double>& shape) {
  if (engine.takes(type_of(shape)) || !engine.takes("hull")) return;
  const std::vector<Vec3<double>> corners = corners_of(shape);
  if (!corners.empty()) shape = Hull<double>(std::span<const Vec3<double>>(corners));
}

// The body's own origin put at its pivot: of a shape that is a hull of vertices.
bool move_to_pivot(const Declaration& engine, Body<double>& body, corpus::Spin& spin) {
  if (spin.pivot.isZero(0) || spin.rotation.isZero(0)) {
    spin.pivot.setZero();
    return true;
  }
  std::vector<Vec3<double>> corners = corners_of(body.shape);
  if (corners.empty() || !engine.takes("hull")) return false;
  for (Vec3<double>& corner : corners) corner -= spin.pivot;
  body.shape = Hull<double>(std::span<const Vec3<double>>(corners));
  const Quaternion<double>& q = body.orientation;
  const Eigen::Quaterniond turn = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
  body.position += turn * spin.pivot;
  spin.pivot.setZero();
  return true;
}

Quaternion<double> unit(const Quaternion<double>& q) {
  const double most = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  if (!(most > 0) || !(most < kInfinity<double>)) return q;
  const double w = q.w / most, x = q.x / most, y = q.y / most, z = q.z / most;
  const double norm = std::sqrt(w * w + x * x + y * y + z * z);
  return {w / norm, x / norm, y / norm, z / norm};
}

bool all_finite(const Case& problem) {
  bool finite = true;
  law::visit_scalars(problem, [&](law::Slot slot, double x) {
    finite = finite && (std::isfinite(x) || slot == law::Slot::horizon);
  });
  return finite;
}

double aspect_of(const Shape<double>& shape) {
  const corpus::Bounds box = corpus::bounds(shape);
  const Vec3<double> sides = box.high - box.low;
  const double least = sides.minCoeff();
  return least > 0 ? sides.maxCoeff() / least : kInfinity<double>;
}

// The power of two that brings a scale into the engine's range.
int exponent_for(const Declaration::Lengths& lengths, double scale) {
  if (!(scale > 0)) return 0;
  if (scale > lengths.most) return -static_cast<int>(std::ceil(std::log2(scale / lengths.most)));
  if (scale < lengths.least) return static_cast<int>(std::ceil(std::log2(lengths.least / scale)));
  return 0;
}

class Translation {
 public:
  Translation(const Declaration& engine, const Offer& offer, const Case& problem, bool beyond)
      : engine_(engine), offer_(offer), problem_(problem), beyond_(beyond) {}

  Terms operator()() {
    out_.asked = problem_;
    out_.asked.expect.reset();
    question();
    shapes();
    if (out_.refused.empty()) motion();
    if (out_.refused.empty()) unit_of_length();
    if (out_.refused.empty()) numbers();
    if (out_.refused.empty()) limits();
    if (out_.refused.empty()) seen();
    return std::move(out_);
  }

 private:
  void refuse(std::string why) {
    if (out_.refused.empty()) out_.refused = std::move(why);
  }
  void beyond(std::string why) {
    if (!out_.refused.empty()) return;
    out_.beyond_limits = true;
    if (!beyond_) out_.refused = std::move(why);
  }

  // Sets the question and its wording.
  void question() {
    Case& asked = out_.asked;
    if (!is_cast(offer_.question)) {
      for (Body<double>* body : {&asked.a, &asked.b}) body->displacement.setZero();
      asked.spin_a = asked.spin_b = {};
      asked.target_distance = 0;
      asked.start_policy = StartPolicy::report;
      return;
    }
    if (asked.t_max == kInfinity<double> && !engine_.infinite_t_max) refuse("its path has no end");
    if (asked.target_distance > 0 && !offer_.takes_target_distance) refuse("it has a target distance");
    if (!offer_.takes_pass_over) asked.start_policy = StartPolicy::report;
    if (offer_.question == Question::ray) ray();
  }

  void ray() {
    Case& asked = out_.asked;
    const bool by_a = std::holds_alternative<Point<double>>(asked.a.shape),
               by_b = std::holds_alternative<Point<double>>(asked.b.shape);
    if (!by_a && !by_b) return refuse("neither body is a point");
    if (!by_b) {
      std::swap(asked.a, asked.b);
      out_.swapped = true;
    }
    if (asked.target_distance > 0) refuse("it has a target distance");
  }

  void shapes() {
    for (Body<double>* body : {&out_.asked.a, &out_.asked.b}) {
      // For a ray, the point is not a body.
      if (offer_.question == Question::ray && body == &out_.asked.b) continue;
      offer_as_hull(engine_, body->shape);
      if (std::string missing = not_taken(engine_, body->shape); !missing.empty())
        refuse(fmt::format("its shape {} is not taken", missing));
    }
  }

  void motion() {
    Case& asked = out_.asked;
    if (engine_.relative_motion || offer_.question == Question::ray) {
      asked.b.displacement -= asked.a.displacement;
      asked.a.displacement.setZero();
    }
    if (offer_.question != Question::rotating_cast) return;
    if (!engine_.pivots &&
        !(move_to_pivot(engine_, asked.a, asked.spin_a) && move_to_pivot(engine_, asked.b, asked.spin_b)))
      refuse("it turns about a pivot");
    const double turn =
        std::max(asked.spin_a.rotation.stableNorm(), asked.spin_b.rotation.stableNorm()) * asked.t_max;
    if (engine_.most_turn && turn > *engine_.most_turn) refuse("it turns further than the engine takes");
  }

  void unit_of_length() {
    if (!engine_.lengths) return;
    out_.exponent = exponent_for(*engine_.lengths, law::scale_of(out_.asked));
    if (out_.exponent == 0) return;
    if (std::optional<Case> scaled = law::scaled(out_.asked, out_.exponent)) {
      out_.asked = std::move(*scaled);
    } else {
      refuse("its numbers do not fit into the engine's unit of length");
    }
  }

  void numbers() {
    Case& asked = out_.asked;
    for (Body<double>* body : {&asked.a, &asked.b}) body->orientation = unit(body->orientation);
    if (engine_.in_float()) asked = engine::rounded_case<float>(asked);
    if (!all_finite(asked)) return refuse("its numbers do not fit into the engine's scalar");
    // Rounding may make a body flat, or the reverse. The result is then the engine's question. A case is
    // refused only if rounding makes it invalid.
    if (!law::in_domain(asked)) refuse("rounded to the engine's scalar it is no question");
  }

  void limits() {
    for (const Body<double>* body : {&out_.asked.a, &out_.asked.b}) {
      if (offer_.question == Question::ray && body == &out_.asked.b) continue;
      const auto* hull = std::get_if<Hull<double>>(&body->shape);
      if (hull != nullptr && engine_.most_vertices && hull->size() > *engine_.most_vertices)
        beyond(fmt::format("a hull has {} vertices, more than {}", hull->size(), *engine_.most_vertices));
      if (engine_.most_aspect && aspect_of(body->shape) > *engine_.most_aspect)
        beyond("a body is longer or thinner than the engine takes");
    }
  }

  void seen() {
    out_.seen = out_.asked;
    if (out_.exponent != 0) {
      if (std::optional<Case> back = law::scaled(out_.asked, -out_.exponent)) {
        out_.seen = std::move(*back);
      } else {
        return refuse("its numbers do not fit into the engine's unit of length");
      }
    }
    if (out_.swapped) std::swap(out_.seen.a, out_.seen.b);
    if (engine_.margin == 0) return;
    const double margin = std::ldexp(engine_.margin, -out_.exponent);
    out_.reach_b = margin;
    // Queries about t = 0 know no target distance.
    if (is_cast(offer_.question)) {
      out_.seen.target_distance += margin;
      out_.reach_a = margin;
    } else {
      out_.seen.a.shape = rounded<double>(std::move(out_.seen.a.shape), margin);
    }
  }

  const Declaration& engine_;
  const Offer& offer_;
  const Case& problem_;
  bool beyond_;
  Terms out_;
};

std::string write_quaternion(const Quaternion<double>& q) {
  using corpus::json_number;
  return fmt::format("[{}, {}, {}, {}]", json_number(q.w), json_number(q.x), json_number(q.y),
                     json_number(q.z));
}

std::string write_body(const Body<double>& body, const corpus::Spin& spin, bool turns) {
  std::string out = fmt::format(R"({{"shape": {}, "position": {}, "orientation": {}, "displacement": {})",
                                corpus::write_shape(body.shape), corpus::write_vec3(body.position),
                                write_quaternion(body.orientation), corpus::write_vec3(body.displacement));
  if (turns)
    out += fmt::format(R"(, "rotation": {}, "pivot": {})", corpus::write_vec3(spin.rotation),
                       corpus::write_vec3(spin.pivot));
  return out + "}";
}

}  // namespace

Terms in_terms_of(const Declaration& engine, const Offer& offer, const Case& problem, bool beyond) {
  return Translation(engine, offer, problem, beyond)();
}

std::string write_question(const Offer& offer, const Terms& terms, std::string_view id, int repeat) {
  const Case& asked = terms.asked;
  const bool turns = offer.question == Question::rotating_cast;
  std::string out =
      fmt::format(R"({{"schema": "graze.question/1", "id": {}, "query": "{}", "a": {})",
                  corpus::json_quote(id), to_text(offer.question), write_body(asked.a, asked.spin_a, turns));
  if (offer.question == Question::ray) {
    out +=
        fmt::format(R"(, "origin": {}, "direction": {}, "t_max": {})", corpus::write_vec3(asked.b.position),
                    corpus::write_vec3(asked.b.displacement), corpus::json_number(asked.t_max));
  } else {
    out += fmt::format(R"(, "b": {})", write_body(asked.b, asked.spin_b, turns));
  }
  if (offer.question == Question::cast || turns) {
    out += fmt::format(R"(, "t_max": {}, "target_distance": {}, "start_policy": "{}")",
                       corpus::json_number(asked.t_max), corpus::json_number(asked.target_distance),
                       corpus::name_of(asked.start_policy));
  }
  if (repeat > 0) out += fmt::format(R"(, "repeat": {})", repeat);
  return out + "}";
}

}  // namespace graze::external
