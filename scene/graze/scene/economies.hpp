// What a scene may spare. Each can be switched off alone; none changes a verdict.
#pragma once

#include <graze/plan.hpp>

namespace graze::scene {

enum class Economy : std::uint8_t {
  rest,         // two bodies at rest whose bounds are apart: nothing
  bounds,       // bodies whose swept bounds never meet: nothing
  still,        // bodies that do not move to each other: one static overlap
  unseen_spin,  // a turn that leaves the shape as it is: linear
  as_one,       // bodies that turn and move as one: a static overlap
  spheres,      // turning bodies whose bounding spheres never meet: nothing
  horizon,      // what an earlier event makes moot is not started; it bounds the others' horizons
  asked,        // a normal, witnesses, a proof: only where they are asked for
};
inline constexpr int kEconomies = 8;
[[nodiscard]] constexpr std::string_view to_text(Economy economy) {
  constexpr std::string_view kNames[kEconomies] = {"rest",   "bounds",  "still",   "unseen_spin",
                                                   "as_one", "spheres", "horizon", "asked"};
  return static_cast<int>(economy) < kEconomies ? kNames[static_cast<int>(economy)] : std::string_view{};
}

class Economies {
 public:
  constexpr Economies() = default;
  [[nodiscard]] static constexpr Economies none() {
    Economies out;
    out.bits_ = 0;
    return out;
  }
  [[nodiscard]] constexpr bool has(Economy one) const {
    return (bits_ >> static_cast<unsigned>(one) & 1u) != 0;
  }
  [[nodiscard]] constexpr Economies without(Economy one) const {
    Economies out = *this;
    out.bits_ &= ~(1u << static_cast<unsigned>(one));
    return out;
  }
  [[nodiscard]] constexpr Economies with(Economy one) const {
    Economies out = *this;
    out.bits_ |= 1u << static_cast<unsigned>(one);
    return out;
  }
  // Those of one pair, as its plan knows them.
  [[nodiscard]] constexpr graze::Economies of_a_pair() const {
    return {.at_rest = has(Economy::still),
            .unseen_spin = has(Economy::unseen_spin),
            .as_one = has(Economy::as_one),
            .bounds = has(Economy::spheres)};
  }
  friend constexpr bool operator==(const Economies&, const Economies&) = default;

 private:
  unsigned bits_ = (1u << kEconomies) - 1;
};

}  // namespace graze::scene
