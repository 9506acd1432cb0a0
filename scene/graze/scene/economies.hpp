/// @file
/// Economies: what a scene may skip.
#pragma once

#include <graze/plan.hpp>

namespace graze::scene {

/// Something that a scene may skip. None changes a verdict.
enum class Economy : std::uint8_t {
  rest,         ///< Two bodies at rest whose bounds are apart: nothing is simulated.
  bounds,       ///< Bodies whose swept bounds never meet: nothing.
  still,        ///< Bodies that do not move relative to each other: one static overlap.
  unseen_spin,  ///< A rotation that leaves the shape as it is: a linear cast.
  as_one,       ///< Bodies that rotate and move as one: a static overlap.
  spheres,      ///< Rotating bodies whose bounding spheres never meet: nothing.
  horizon,      ///< Pairs that an earlier event makes unnecessary are not cast, or only up to that event.
  asked,        ///< Normals, witnesses and proofs are computed only if they are requested.
};
/// The number of economies.
inline constexpr int kEconomies = 8;
/// The enumerator's name.
[[nodiscard]] constexpr std::string_view to_text(Economy economy) {
  constexpr std::string_view kNames[kEconomies] = {"rest",   "bounds",  "still",   "unseen_spin",
                                                   "as_one", "spheres", "horizon", "asked"};
  return static_cast<int>(economy) < kEconomies ? kNames[static_cast<int>(economy)] : std::string_view{};
}

/// A set of economies. By default it has all of them.
///
/// @code
/// using graze::scene::Economies, graze::scene::Economy;
/// const Economies all, some = all.without(Economy::horizon);
/// assert(all.has(Economy::horizon) && !some.has(Economy::horizon) && some.with(Economy::horizon) == all);
/// @endcode
class Economies {
 public:
  constexpr Economies() = default;  ///< All economies.
  /// No economy: every pair is cast as it moves.
  [[nodiscard]] static constexpr Economies none() {
    Economies out;
    out.bits_ = 0;
    return out;
  }
  /// True if the set has this economy.
  [[nodiscard]] constexpr bool has(Economy one) const {
    return (bits_ >> static_cast<unsigned>(one) & 1u) != 0;
  }
  /// The same set without this economy.
  [[nodiscard]] constexpr Economies without(Economy one) const {
    Economies out = *this;
    out.bits_ &= ~(1u << static_cast<unsigned>(one));
    return out;
  }
  /// The same set with this economy.
  [[nodiscard]] constexpr Economies with(Economy one) const {
    Economies out = *this;
    out.bits_ |= 1u << static_cast<unsigned>(one);
    return out;
  }
  /// The economies of one pair, as a rotating cast takes them.
  [[nodiscard]] constexpr graze::Economies of_a_pair() const {
    return {.at_rest = has(Economy::still),
            .unseen_spin = has(Economy::unseen_spin),
            .as_one = has(Economy::as_one),
            .bounds = has(Economy::spheres)};
  }
  /// True if both sets are the same.
  friend constexpr bool operator==(const Economies&, const Economies&) = default;

 private:
  unsigned bits_ = (1u << kEconomies) - 1;
};

}  // namespace graze::scene
