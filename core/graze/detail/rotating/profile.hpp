// How far a solid of revolution reaches along a fixed axis of the world, over a span of its rotation.
//
// A cylinder, a cone or an ellipsoid looks the same at every angle about its own axis a. Its pivot is on that axis, so
// along a unit vector n only c = n.a counts, however fast it spins: it reaches the largest f(c) of its parts,
//   f(c) = height c + sqrt(radius^2 (1 - c^2) + length^2 c^2).
// A rim or a tip is a part without length, and an ellipsoid is one part. A wheel that rolls, or a ball that spins about
// its axis, has points that move fast and a c that hardly changes. Over a span h of t, c stays within |n x w| |w x a|
// h^2 / 8 of its chord, and always between (n.w)(w.a) -+ |n x w| |w x a|, over |w|^2.
//
// Internal lengths. Each reach is an upper bound of the exact value.
#pragma once

#include <algorithm>
#include <array>
#include <graze/detail/numeric/rounding.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct ProfilePart {
  double height = 0, radius = 0, length = 0;

  // The largest f for c in [least, most], within [-1, 1]. With k = radius^2 - length^2 > 0 it is concave, and its vertex
  // at c^2 = height^2 radius^2 / (k (k + height^2)) is radius sqrt(1 + height^2 / k). Otherwise it is convex.
  [[nodiscard]] double reach(double least, double most) const {
    const double r_sq = radius * radius, l_sq = length * length, z_sq = height * height;
    const auto f = [&](double c) {
      return fl(height * c) + square_root(fl(r_sq * ((1 - c) * (1 + c))) + fl(l_sq * (c * c)));
    };
    const double k = (radius - length) * (radius + length);
    double out = std::max(f(least), f(most));
    if (k > 0) {
      const double vertex = height * radius / square_root(k * (k + z_sq));
      if (least < vertex && vertex < most) out = std::max(out, radius * square_root(1 + z_sq / k));
    }
    return out + fl(8 * kUnitRoundoff<double> * (std::abs(height) + radius + length));
  }
};

struct Profile {
  std::array<ProfilePart, 2> parts;
  int size = 0;  // 0: no solid of revolution, or its pivot is beside its axis
  int axis = 2;  // own frame
  [[nodiscard]] double reach(double least, double most) const {
    double out = parts[0].reach(least, most);
    if (size > 1) out = std::max(out, parts[1].reach(least, most));
    return out;
  }
};

// `unit`: the internal length of a world length. `along`: the pivot's place on the axis of revolution.
template <Scalar S>
Profile profile_of(const Shape<S>& shape, int axis, double along, double unit) {
  Profile out;
  out.axis = axis;
  const auto add = [&](double height, double radius, double length) {
    out.parts[static_cast<std::size_t>(out.size++)] = {unit * (height - along), unit * radius, unit * length};
  };
  if (const auto* cylinder = std::get_if<Cylinder<S>>(&shape)) {
    add(cylinder->half_height, cylinder->radius, 0);
    add(-cylinder->half_height, cylinder->radius, 0);
  } else if (const auto* cone = std::get_if<Cone<S>>(&shape)) {
    add(cone->half_height, 0, 0);
    add(-cone->half_height, cone->radius, 0);
  } else if (const auto* ellipsoid = std::get_if<Ellipsoid<S>>(&shape)) {
    add(0, ellipsoid->radii[(axis + 1) % 3], ellipsoid->radii[axis]);
  }
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
