// A hull in a method's scalar, with adjacency if the given one has it.
//
// Deriving adjacency takes longer than most questions about the hull, and a case is asked many times. So the last few
// hulls are kept, by the input they were made from.
//
//   GRAZE_OWN_HULLS       a hull is made anew in double, too, by the code that a method is compiled from. Trials of the
//                         laws ask for it: what is planted there would else never make the hulls that methods are given
//   GRAZE_KEPT_HULLS=0    none is kept: where that code changes while the program runs
#pragma once

#include <array>
#include <concepts>
#include <graze/hull.hpp>
#include <vector>

#ifndef GRAZE_KEPT_HULLS
#define GRAZE_KEPT_HULLS 8
#endif

namespace graze::engine {

#ifdef GRAZE_OWN_HULLS
inline constexpr bool kOwnHulls = true;
#else
inline constexpr bool kOwnHulls = false;
#endif

// The last few hulls, each with the input it was made from. The input is kept too, so that no other input can occupy
// the address of its adjacency.
template <Scalar To, Scalar From>
class KeptHulls {
 public:
  [[nodiscard]] const Hull<To>* find(const Hull<From>& given) const {
    for (const Pair& one : all_) {
      if (one.given.has_adjacency() && &one.given.graph() == &given.graph()) return &one.made;
    }
    return nullptr;
  }
  void keep(const Hull<From>& given, const Hull<To>& made) {
    if (all_.empty()) return;
    all_[oldest_] = {given, made};
    oldest_ = (oldest_ + 1) % all_.size();
  }

 private:
  struct Pair {
    Hull<From> given;
    Hull<To> made;
  };
  std::array<Pair, GRAZE_KEPT_HULLS> all_;
  std::size_t oldest_ = 0;
};

template <Scalar To, Scalar From>
[[nodiscard]] Hull<To> own_hull(const Hull<From>& given) {
  if constexpr (std::same_as<To, From> && !kOwnHulls) {
    return given;
  } else {
    thread_local KeptHulls<To, From> kept;
    if (given.has_adjacency()) {
      if (const Hull<To>* made = kept.find(given)) return *made;
    }
    std::vector<Vec3<To>> vertices;
    vertices.reserve(given.size());
    for (const Vec3<From>& v : given.vertices()) vertices.push_back(v.template cast<To>());
    if (!given.has_adjacency()) return Hull<To>(std::span<const Vec3<To>>(vertices));
    Hull<To> made = with_adjacency<To>(vertices);
    kept.keep(given, made);
    return made;
  }
}

}  // namespace graze::engine
