// How a shape is copied, moved and destroyed: as its kind is.
#pragma once

#include <graze/shape.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
Shape<S>::Shape(const Shape&) = default;
template <Scalar S>
Shape<S>::Shape(Shape&&) noexcept = default;
template <Scalar S>
Shape<S>& Shape<S>::operator=(const Shape&) = default;
template <Scalar S>
Shape<S>& Shape<S>::operator=(Shape&&) noexcept = default;
template <Scalar S>
Shape<S>::~Shape() = default;

}}  // namespace graze::GRAZE_LINKAGE
