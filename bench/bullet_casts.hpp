// Bullet's casts behind an interface without Bullet's types: Bullet in float and Bullet in double define the
// same names, so each lives in a module of its own that the benchmark opens.
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
  double half_extents[3] = {0, 0, 0};  // of a box; radius, radius, half height of what is round, along z
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

// Cases made ready for one contestant.
class PreparedCasts {
 public:
  virtual ~PreparedCasts() = default;
  // Casts the cases order[0] .. order[count - 1], and notes each answer under the case's index.
  virtual void cast_all(const std::uint32_t* order, std::size_t count, Answer* answers) const = 0;
};

// Which of Bullet's casts.
enum class BulletCast : std::uint8_t {
  subsimplex,            // of bodies that do not turn
  subsimplex_and_depth,  // where it answers nothing, the start is asked for the penetration, as who needs that must
  // Of bodies that turn. It is asked from pose to pose: a step of more than half a turn in equal pieces, in order.
  continuous,
  // The same in pieces of an eighth of a turn at most: beyond that Bullet's own poses stop turning on the way.
  continuous_in_pieces,
};

// What a module exports under kMakeBulletCasts; delete the result before closing the module.
using MakeBulletCasts = PreparedCasts* (*)(const PlainShape* shapes, std::size_t shape_count,
                                           const PlainPair* pairs, std::size_t pair_count, BulletCast which);
inline constexpr const char* kMakeBulletCasts = "graze_make_bullet_casts";

}  // namespace graze::bench
