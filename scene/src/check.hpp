#pragma once

#include <graze/scene.hpp>

namespace graze::scene {

// Indices are 32 bits wide.
inline constexpr std::size_t kMostBodies = std::size_t{1} << 31;

}  // namespace graze::scene
