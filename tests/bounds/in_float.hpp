// A hostile scene as bodies of floats are given, and the same in double, which is what they stand for.
#pragma once

#include <graze/detail/shapes/validation.hpp>
#include <graze/rotating_cast.hpp>
#include <optional>

#include "engines/convert.hpp"
#include "tests/bounds/hostile.hpp"

namespace graze::test {

struct FloatScene {
  RotatingBody<float> a, b;
  HostileScene scene;  // of their numbers, widened

  // Empty if validation refuses a number of the scene as a float.
  static std::optional<FloatScene> of(const HostileScene& given) {
    FloatScene out{narrow<float>(given.a), narrow<float>(given.b), given};
    if (validate(out.a.body) != Invalid::none || validate(out.b.body) != Invalid::none) return {};
    for (const RotatingBody<float>* body : {&out.a, &out.b}) {
      if (detail::check_vector(body->rotation) != Invalid::none) return {};
      if (detail::check_vector(body->pivot) != Invalid::none) return {};
    }
    out.scene.a = narrow<double>(out.a);
    out.scene.b = narrow<double>(out.b);
    return out;
  }

 private:
  template <Scalar To, Scalar From>
  static RotatingBody<To> narrow(const RotatingBody<From>& x) {
    using engine::round_to;
    return {{round_to<To>(x.body.shape), round_to<To>(x.body.position), round_to<To>(x.body.orientation),
             round_to<To>(x.body.displacement)},
            round_to<To>(x.rotation),
            round_to<To>(x.pivot)};
  }
};

}  // namespace graze::test
