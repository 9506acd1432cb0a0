// A body prepared for many queries: checked, its bounds taken and its rotation formed, once.
//
// A value, never changed; copies share it. overlap, distance and penetration take two of them in place of two bodies,
// and answer the same, to the bit: a query then pays for the pair alone. It holds the body, and through it the hull; a
// body that has moved is prepared anew. It pays from the second query about a pose on.
// Where the body is refused, so is every query with it, as it would be with the body.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>
#include <memory>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
struct PreparedBody;  // pairs/prepared_body.hpp

template <Scalar S>
class Prepared {
 public:
  explicit Prepared(const Body<S>& body);

  [[nodiscard]] const Body<S>& body() const;
  // Invalid::none, or why the body is refused.
  [[nodiscard]] Invalid invalid() const;
  // For the queries.
  [[nodiscard]] const PreparedBody<S>& inner() const { return *inner_; }

 private:
  std::shared_ptr<const PreparedBody<S>> inner_;
};

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/pairs/prepared_body.hpp>
#endif
