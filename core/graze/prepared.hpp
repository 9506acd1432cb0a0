/// @file
/// Bodies prepared for many queries at one pose.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>
#include <memory>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {
template <Scalar S>
struct PreparedBody;  // detail/pairs/prepared_body.hpp
}

/// A body that is validated once, with its bounds and its rotation computed. It pays from the second query about a
/// pose on.
///
/// overlap_mpr(), overlap_gjk(), distance() and penetration() accept two prepared bodies instead of two bodies. The
/// answers are the same, to the bit. A prepared body never changes, and copies share it. It holds the body, and
/// through it the hull. A body that has moved is prepared anew. If the body is invalid, so is every query with it.
///
/// @code
/// const graze::Body<float> crate{.shape = graze::Box<float>{{1, 1, 1}}};
/// const graze::Prepared<float> prepared(crate);  // allocates
/// assert(prepared.invalid() == graze::Invalid::none && prepared.body().position == crate.position);
/// @endcode
template <Scalar S>
class Prepared {
 public:
  /// Validates and prepares the body. It takes time proportional to the number of vertices, and allocates memory.
  explicit Prepared(const Body<S>& body);

  /// The body as it was given.
  [[nodiscard]] const Body<S>& body() const;
  /// Invalid::none, or the reason why every query with the body is `invalid_input`.
  [[nodiscard]] Invalid invalid() const;
  /// @cond
  // For the queries.
  [[nodiscard]] const detail::PreparedBody<S>& inner() const { return *inner_; }
  /// @endcond

 private:
  std::shared_ptr<const detail::PreparedBody<S>> inner_;
};

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/pairs/prepared_body.hpp>
#endif
