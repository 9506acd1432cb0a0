// What a prepared body holds: declared, with what it is for, in graze/prepared.hpp.
#pragma once

#include <graze/prepared.hpp>
#include <graze/support/prepared_pair.hpp>
#include <graze/support/validate.hpp>

namespace graze::inline GRAZE_LINKAGE {

template <Scalar S>
struct PreparedBody {
  explicit PreparedBody(const Body<S>& given) : body(given), invalid(validate(body)) {
    if (invalid == Invalid::none && detail::is_quick(body.shape)) guide.emplace(body);
  }
  PreparedBody(const PreparedBody&) = delete;  // the guide sees the body
  PreparedBody& operator=(const PreparedBody&) = delete;

  Body<S> body;
  Invalid invalid;
  std::optional<Guide<S>> guide;  // of polytopes
};

template <Scalar S>
Prepared<S>::Prepared(const Body<S>& body) : inner_(std::make_shared<const PreparedBody<S>>(body)) {}
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
[[nodiscard]] bool both_guided(const Prepared<S>& a, const Prepared<S>& b) {
  return a.inner().guide && b.inner().guide;
}

}  // namespace detail

}  // namespace graze::inline GRAZE_LINKAGE
