// The contents of a prepared body. graze/prepared.hpp declares it and says when to use one.
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/prepared.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

template <Scalar S>
struct PreparedBody {
  explicit PreparedBody(const Body<S>& given) : body(given), invalid(validate(body)) {
    if (invalid == Invalid::none && has_fast_search(body.shape)) core.emplace(body);
  }
  PreparedBody(const PreparedBody&) = delete;  // core refers to body
  PreparedBody& operator=(const PreparedBody&) = delete;

  Body<S> body;
  Invalid invalid;
  std::optional<PreparedCore<S>> core;  // of polytopes
};

}  // namespace detail

template <Scalar S>
Prepared<S>::Prepared(const Body<S>& body) : inner_(std::make_shared<const detail::PreparedBody<S>>(body)) {}
template <Scalar S>
const Body<S>& Prepared<S>::body() const {
  return inner_->body;
}
template <Scalar S>
Invalid Prepared<S>::invalid() const {
  return inner_->invalid;
}

namespace detail {

// validate(a, b, options) of graze/validate.hpp, in its order.
template <Scalar S>
[[nodiscard]] Invalid validate_prepared(const Prepared<S>& a, const Prepared<S>& b,
                                        const CastOptions<S>& options) {
  if (const Invalid one = check_arithmetic(); one != Invalid::none) return one;
  if (const Invalid one = a.inner().invalid; one != Invalid::none) return one;
  if (const Invalid one = b.inner().invalid; one != Invalid::none) return one;
  return validate(options);
}
template <Scalar S>
[[nodiscard]] bool both_prepared(const Prepared<S>& a, const Prepared<S>& b) {
  return a.inner().core && b.inner().core;
}

}  // namespace detail

}}  // namespace graze::GRAZE_LINKAGE
