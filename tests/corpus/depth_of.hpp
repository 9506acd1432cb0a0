// How deep a shape's combinators are nested.
#pragma once

#include <algorithm>
#include <graze/shape.hpp>
#include <variant>

namespace graze::corpus {

inline int depth_of(const Shape<double>& shape) {
  return std::visit(
      [](const auto& one) {
        int most = -1;
        if constexpr (requires { one.shapes; }) {
          for (const auto& part : one.shapes) most = std::max(most, depth_of(part->shape));
        } else if constexpr (requires { one.shape; }) {
          most = depth_of(one.shape->shape);
        }
        return most + 1;
      },
      shape);
}

}  // namespace graze::corpus
