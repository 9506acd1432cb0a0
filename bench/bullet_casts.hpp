// Bullet's casts behind an interface without Bullet's types. Bullet in float and Bullet in double define the same
// names, so each lives in a module of its own that the benchmark opens.
#pragma once

#include <cstddef>
#include <cstdint>

namespace graze::bench {

// Contact in [0, 1]?
enum class Verdict : std::uint8_t { miss, contact, none };

struct Answer {
  Verdict verdict = Verdict::none;
  double toi = 0;  // of a contact
};

enum class PlainKind : std::uint8_t { hull, box, sphere, capsule, cylinder, cone };

struct PlainShape {
  PlainKind kind = PlainKind::hull;
  const double* xyz = nullptr;  // the vertices of a hull
  std::size_t vertices = 0;
  double half_extents[3] = {0, 0, 0};  // of a box, or radius, radius and half height of a round shape along z
};

struct PlainBody {
  std::size_t shape = 0;
  double position[3] = {0, 0, 0}, displacement[3] = {0, 0, 0};
  double orientation[4] = {1, 0, 0, 0};  // w, x, y, z
  double rotation[3] = {0, 0, 0};        // rotation vector over the step, about the position
};

struct PlainPair {
  PlainBody a, b;
};

// Cases prepared for one contestant.
class PreparedCasts {
 public:
  virtual ~PreparedCasts() = default;
  // Casts the cases order[0] .. order[count - 1] and stores each answer under the case's index.
  virtual void cast_all(const std::uint32_t* order, std::size_t count, Answer* answers) const = 0;
};

// The Bullet cast to run.
enum class BulletCast : std::uint8_t {
  subsimplex,            // for bodies that do not rotate
  subsimplex_and_depth,  // queries the penetration at the start where a cast has no answer
  // For rotating bodies, called from pose to pose: a step of more than half a turn in equal pieces, in order.
  continuous,
  // The same in pieces of at most an eighth of a turn: beyond that Bullet's poses stop rotating on the way.
  continuous_in_pieces,
};

// The function that a module exports as kMakeBulletCasts. Delete the result before closing the module.
using MakeBulletCasts = PreparedCasts* (*)(const PlainShape* shapes, std::size_t shape_count,
                                           const PlainPair* pairs, std::size_t pair_count, BulletCast which);
inline constexpr const char* kMakeBulletCasts = "graze_make_bullet_casts";

}  // namespace graze::bench
