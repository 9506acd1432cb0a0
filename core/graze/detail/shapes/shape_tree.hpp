// Combinators: a walk through the tree, in double whatever the caller's scalar.
//
// Frame: the body's own, about a centre that the caller subtracts.   Units: the caller's length.
// A shape is its core plus a ball of common_radius. If the parts of a hull_of have balls of different radii,
// the radius of a part beyond the least of them is its `excess`, a ball that belongs to the core.
//
// Positions add up as sums of two doubles, and vertices are compared by their differences. So large offsets
// that cancel cost next to nothing (kTwoDoublesOfANode) unless a rotation comes between. Under k rotations
// the quick error is u |position| 23 k. It is next to nothing as well if the rotations are composed in two
// doubles (Turning::accurate: for proofs).
#pragma once

#include <algorithm>
#include <graze/detail/numeric/offset.hpp>
#include <graze/detail/numeric/sine_cosine.hpp>
#include <graze/detail/shapes/leaf.hpp>
#include <graze/proof.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// How deep combinators may stand in each other, how many parts a walk may meet (a shared one each time), and
// how many vertices a core may have: beyond, the door says too_complex.
inline constexpr int kMaxNesting = 16;
inline constexpr int kMaxParts = 4096;
inline constexpr std::uint64_t kMaxVertices = 0xffffffffu;

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

template <Scalar S>
using Parts = std::vector<SharedShape<S>>;

// A shape whose vertices a fast walk takes as they are.
template <Scalar S>
[[nodiscard]] bool has_fast_search(const Shape<S>& shape) {
  return std::holds_alternative<Hull<S>>(shape) || std::holds_alternative<Box<S>>(shape) ||
         std::holds_alternative<Point<S>>(shape) || std::holds_alternative<Segment<S>>(shape) ||
         std::holds_alternative<Triangle<S>>(shape);
}

// The shape inside of a rounding of such a shape. Any other shape itself, valid or not.
template <Scalar S>
[[nodiscard]] const Shape<S>& without_ball(const Shape<S>& shape) {
  const auto* rounded = std::get_if<Rounded<S>>(&shape);
  return rounded && rounded->shape && has_fast_search(rounded->shape->shape) ? rounded->shape->shape : shape;
}

template <Scalar S>
Quaternion<double> as_double(const Quaternion<S>& q) {
  return {double(q.w), double(q.x), double(q.y), double(q.z)};
}

inline bool is_less(const TwoDoubles& l, const TwoDoubles& r) {
  return l.hi < r.hi || (l.hi == r.hi && l.lo < r.lo);
}

template <Scalar S>
TwoDoubles exact_radius(const Shape<S>& shape);

template <Scalar S>
TwoDoubles least_radius(const Parts<S>& parts) {
  TwoDoubles least{kInfinity<double>, 0};
  for (const auto& part : parts) {
    if (const TwoDoubles r = exact_radius<S>(part->shape); is_less(r, least)) least = r;
  }
  return least;
}

// The radius of the ball that the shape is rounded by, within 2^-98 for each part.
template <Scalar S>
TwoDoubles exact_radius(const Shape<S>& shape) {
  return std::visit(Overloaded{[](const Sphere<S>& s) {
                                 return TwoDoubles{double(s.radius), 0};
                               },
                               [](const Capsule<S>& s) {
                                 return TwoDoubles{double(s.radius), 0};
                               },
                               [](const Posed<S>& s) { return exact_radius<S>(s.shape->shape); },
                               [](const Rounded<S>& s) {
                                 return exact_radius<S>(s.shape->shape) + TwoDoubles{double(s.radius), 0};
                               },
                               [](const Sum<S>& s) {
                                 TwoDoubles total;
                                 for (const auto& part : s.shapes) {
                                   total = total + exact_radius<S>(part->shape);
                                 }
                                 return total;
                               },
                               [](const HullOf<S>& s) { return least_radius<S>(s.shapes); },
                               [](const auto&) { return TwoDoubles{}; }},
                    shape);
}
// The same, rounded once.
template <Scalar S>
double common_radius(const Shape<S>& shape) {
  const TwoDoubles r = exact_radius(shape);
  return r.hi + r.lo;
}

template <Scalar S>
std::uint64_t vertex_count(const Shape<S>& shape);

template <Scalar S>
std::uint64_t count_of_sum(const Parts<S>& parts) {
  std::uint64_t n = 1;
  for (const auto& part : parts) n = std::min(n * vertex_count<S>(part->shape), kMaxVertices + 1);
  return n;
}
template <Scalar S>
std::uint64_t count_of_hull(const Parts<S>& parts) {
  std::uint64_t n = 0;
  for (const auto& part : parts) n = std::min(n + vertex_count<S>(part->shape), kMaxVertices + 1);
  return n;
}

// The number of vertices of the core. kMaxVertices + 1 stands for any larger number.
template <Scalar S>
std::uint64_t vertex_count(const Shape<S>& shape) {
  return std::visit(Overloaded{[](const Segment<S>&) -> std::uint64_t { return 2; },
                               [](const Capsule<S>&) -> std::uint64_t { return 2; },
                               [](const Triangle<S>&) -> std::uint64_t { return 3; },
                               [](const Box<S>&) -> std::uint64_t { return 8; },
                               [](const Hull<S>& s) -> std::uint64_t { return s.size(); },
                               [](const Posed<S>& s) { return vertex_count<S>(s.shape->shape); },
                               [](const Rounded<S>& s) { return vertex_count<S>(s.shape->shape); },
                               [](const Sum<S>& s) { return count_of_sum<S>(s.shapes); },
                               [](const HullOf<S>& s) { return count_of_hull<S>(s.shapes); },
                               [](const auto&) -> std::uint64_t { return 1; }},
                    shape);
}

// Is the core no polytope?
template <Scalar S>
bool is_curved(const Shape<S>& shape) {
  const auto any = [](const auto& parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [](const auto& part) { return is_curved<S>(part->shape); });
  };
  return std::visit(Overloaded{[](const Ellipsoid<S>&) { return true; },
                               [](const Cylinder<S>&) { return true; }, [](const Cone<S>&) { return true; },
                               [](const Posed<S>& s) { return is_curved<S>(s.shape->shape); },
                               [](const Rounded<S>& s) { return is_curved<S>(s.shape->shape); },
                               [&](const Sum<S>& s) { return any(s.shapes); },
                               [&](const HullOf<S>& s) {
                                 const TwoDoubles least = least_radius<S>(s.shapes);
                                 return any(s.shapes) ||
                                        std::any_of(s.shapes.begin(), s.shapes.end(), [&](const auto& part) {
                                          return is_less(least, exact_radius<S>(part->shape));
                                        });
                               },
                               [](const auto&) { return false; }},
                    shape);
}

// The matrix of a rotation as quickly as its error allows, or as accurately as doubles can hold it.
enum class Turning : std::uint8_t { quick, accurate };

// Rounding in a tree besides the last sum and sums of two doubles, over u. It bounds the error of a point per
// component, and how far the one chosen along a unit n may lie below the greatest.
struct TreeRounding {
  double point = 0, choice = 0;
};

// A leaf of a polytope is compared with 8 u of its extent (leaf.hpp). A curved leaf rounds 6 u itself, a unit
// vector 4 u. k rotations above cost 23 k u of the extent, and of positions, quickly, but accurately 5 u of
// the direction. Rounding counts for both points that are compared.
template <Scalar S>
TreeRounding tree_rounding(const Shape<S>& shape, Turning turning, int k = 0) {
  const bool quick = turning == Turning::quick;
  const double turn = quick ? 23 * k : 0, tilt = quick ? 23 * k : (k > 0 ? 5 : 0);
  const auto size = [](const Vec3<S>& x) { return norm(x.template cast<double>()); };
  const auto polytope = [&](double extent, double position = 0) {
    return TreeRounding{turn * (extent + position), fl((8 + 2 * tilt) * extent) + fl(2 * turn * position)};
  };
  const auto curved = [&](double extent) {
    return TreeRounding{(6 + turn) * extent, (12 + 2 * tilt) * extent};
  };
  const auto inner = [&](const SharedShape<S>& part, int more) {
    return tree_rounding<S>(part->shape, turning, k + more);
  };
  const auto with_ball = [](TreeRounding r, double radius) {
    return TreeRounding{r.point + 4 * radius, r.choice + 8 * radius};
  };
  return std::visit(
      Overloaded{
          [](const Point<S>&) { return TreeRounding{}; },
          [&](const Sphere<S>& s) { return with_ball({}, s.radius); },
          [&](const Capsule<S>& s) { return with_ball(polytope(s.half_height), s.radius); },
          [&](const Segment<S>& s) { return polytope(size(s.b - s.a), size(s.a)); },
          [&](const Triangle<S>& s) { return polytope(size(s.b - s.a) + size(s.c - s.a), size(s.a)); },
          [&](const Box<S>& s) { return polytope(size(s.half_extents)); },
          [&](const Ellipsoid<S>& s) { return curved(size(s.radii)); },
          [&](const Cylinder<S>& s) { return curved(hypotenuse(double(s.radius), double(s.half_height))); },
          [&](const Cone<S>& s) { return curved(hypotenuse(double(s.radius), double(s.half_height))); },
          [&](const Hull<S>& s) {
            const Vec3<S> reach = s.scan_half_extents() + s.scan_middle().cwiseAbs();
            return polytope(std::ldexp(size(reach), s.exponent()), size(s.center()));
          },
          [&](const Posed<S>& s) {
            TreeRounding r = inner(s.shape, s.orientation.is_identity() ? 0 : 1);
            r.point += fl(turn * size(s.position));
            r.choice += fl(2 * turn * size(s.position));
            return r;
          },
          [&](const Rounded<S>& s) { return with_ball(inner(s.shape, 0), s.radius); },
          [&](const Sum<S>& s) {
            TreeRounding total;
            for (const auto& part : s.shapes) {
              const TreeRounding r = inner(part, 0);
              total.point += r.point;
              total.choice += r.choice;
            }
            return total;
          },
          [&](const HullOf<S>& s) {
            TreeRounding most;
            for (const auto& part : s.shapes) {
              const TreeRounding r = inner(part, 0);
              most.point = std::max(most.point, r.point);
              most.choice = std::max(most.choice, r.choice);
            }
            // The parts are compared with each other, too.
            return TreeRounding{most.point, most.choice + 2 * most.point};
          }},
      shape);
}

// Shapes in the tree.
template <Scalar S>
int nodes_of(const Shape<S>& shape) {
  return std::visit(
      [](const auto& s) {
        int nodes = 1;
        if constexpr (requires { s.shapes; }) {
          for (const auto& part : s.shapes) nodes += nodes_of<S>(part->shape);
        } else if constexpr (requires { s.shape->shape; }) {
          nodes += nodes_of<S>(s.shape->shape);
        }
        return nodes;
      },
      shape);
}
// The sum of all lengths that the shape is made of: a walk to a point of it adds up no more.
template <Scalar S>
double lengths_of(const Shape<S>& shape) {
  const auto size = [](const Vec3<S>& x) { return norm_1(x.template cast<double>()); };
  const auto all = [](const auto& parts) {
    double total = 0;
    for (const auto& part : parts) total += lengths_of<S>(part->shape);
    return total;
  };
  return std::visit(
      Overloaded{[](const Point<S>&) { return 0.0; }, [](const Sphere<S>& s) { return double(s.radius); },
                 [&](const Segment<S>& s) { return size(s.a) + size(s.b); },
                 [&](const Triangle<S>& s) { return size(s.a) + size(s.b) + size(s.c); },
                 [&](const Box<S>& s) { return size(s.half_extents); },
                 [&](const Ellipsoid<S>& s) { return size(s.radii); },
                 [&](const Hull<S>& s) { return 4 * double(s.largest()); },
                 [&](const Posed<S>& s) { return size(s.position) + lengths_of<S>(s.shape->shape); },
                 [&](const Rounded<S>& s) { return double(s.radius) + lengths_of<S>(s.shape->shape); },
                 [&](const Sum<S>& s) { return all(s.shapes); },
                 [&](const HullOf<S>& s) { return all(s.shapes); },
                 [](const auto& s) { return 2 * double(s.radius) + 2 * double(s.half_height); }},
      shape);
}
// A rotation, a placement and a sum of two doubles each cost 2^-96 to 2^-100 of the lengths involved
// (offset.hpp). A node of the tree has a few of each, so a point is within this times nodes times lengths.
inline constexpr double kTwoDoublesOfANode = 0x1p-95;

struct TreePoint {
  Vec3<double> x = Vec3<double>::Zero(), lo = Vec3<double>::Zero();  // the point is x + lo + excess n
  TwoDoubles excess;
  std::uint32_t vertex = 0;
};

// The placement of a part: x of the part is at offset + rotation x.
struct Placement {
  Turning turning = Turning::quick;
  bool rotated = false;
  Mat3<double> rotation = Mat3<double>::Identity();
  std::array<TwoDoubles3, 3> rows = {};  // of the rotation, where it is accurate
  TwoDoubles3 offset = {};

  [[nodiscard]] Vec3<double> to_own(const Vec3<double>& n) const {
    return rotated ? turned_back_by(rotation, n) : n;
  }
  [[nodiscard]] TwoDoubles3 turn(const Vec3<double>& x) const {
    if (rotated && turning == Turning::accurate) {
      TwoDoubles3 out;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          out[i] = out[i] + rows[i][j] * TwoDoubles{x[static_cast<int>(j)], 0};
        }
      }
      return out;
    }
    const Vec3<double> y = rotated ? turned_by(rotation, x) : x;
    return {TwoDoubles{y[0], 0}, TwoDoubles{y[1], 0}, TwoDoubles{y[2], 0}};
  }
  // The part's point x.
  [[nodiscard]] TreePoint at(const Vec3<double>& x, std::uint32_t vertex) const {
    const TwoDoubles3 turned = turn(x);
    TreePoint out;
    for (std::size_t i = 0; i < 3; ++i) {
      const TwoDoubles sum = offset[i] + turned[i];
      out.x[static_cast<int>(i)] = sum.hi;
      out.lo[static_cast<int>(i)] = sum.lo;
    }
    out.vertex = vertex;
    return out;
  }
  [[nodiscard]] Placement moved(const Vec3<double>& position) const {
    Placement out = *this;
    const TwoDoubles3 by = turn(position);
    for (std::size_t i = 0; i < 3; ++i) out.offset[i] = out.offset[i] + by[i];
    return out;
  }
  [[nodiscard]] Placement turned(const Quaternion<double>& q) const {
    Placement out = *this;
    if (q.is_identity()) return out;
    out.rotated = true;
    if (turning == Turning::quick) {
      const Mat3<double> own = rotation_matrix(q);
      if (!rotated) {
        out.rotation = own;
      } else {
        for (int i = 0; i < 3; ++i) out.rotation.col(i) = turned_by<double>(rotation, own.col(i));
      }
      return out;
    }
    const std::array<TwoDoubles3, 3> own = rotation_rows(q);
    if (!rotated) {
      out.rows = own;
    } else {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          out.rows[i][j] = rows[i][0] * own[0][j] + (rows[i][1] * own[1][j] + rows[i][2] * own[2][j]);
        }
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        out.rotation(static_cast<int>(i), static_cast<int>(j)) = out.rows[i][j].hi + out.rows[i][j].lo;
      }
    }
    return out;
  }
  // For the further parts of a sum: the first has the offset.
  [[nodiscard]] Placement about_zero() const {
    Placement out = *this;
    out.offset = {};
    return out;
  }
};

// The support point along n, or the one that `chosen` names (n then tells which point of a curved part). In
// the latter case it can fill in a feature: its points are drawn in by kInside, so that they lie in their
// parts.
inline constexpr double kInside = 1 - 8 * kUnitRoundoff<double>;

template <Scalar S>
class TreeWalk {
 public:
  // n: unit, in the body's frame. `drawn`: how far the points of curved parts are drawn in beyond kInside, as
  // a fraction of the way to a point inside. It is 0, or well above u.
  explicit TreeWalk(const Vec3<double>& n, Feature* feature = nullptr, double drawn = 0)
      : n_(n), feature_(feature), drawn_(drawn) {}

  TreePoint operator()(const Shape<S>& shape, const Placement& at, const std::uint32_t* chosen = nullptr) {
    return std::visit([&](const auto& s) { return step(s, at, chosen); }, shape);
  }
  // The number of features filled in. If it is more than kCurvedParts, the feature cannot be named.
  [[nodiscard]] std::size_t curved_parts() const { return curved_parts_; }

 private:
  static Vec3<double> wide(const Vec3<S>& x) { return x.template cast<double>(); }

  // A polytope of few vertices.
  template <std::size_t N>
  TreePoint choose(const std::array<Vec3<double>, N>& points, const Placement& at,
                   const std::uint32_t* chosen) const {
    const std::uint32_t k = chosen ? *chosen : first_greatest<double>(points, at.to_own(n_));
    return at.at(points[k], k);
  }
  TreePoint step(const Point<S>&, const Placement& at, const std::uint32_t*) const {
    return at.at(Vec3<double>::Zero(), 0);
  }
  TreePoint step(const Sphere<S>&, const Placement& at, const std::uint32_t* chosen) const {
    return step(Point<S>{}, at, chosen);
  }
  TreePoint step(const Segment<S>& s, const Placement& at, const std::uint32_t* chosen) const {
    return choose<2>({wide(s.a), wide(s.b)}, at, chosen);
  }
  TreePoint step(const Triangle<S>& s, const Placement& at, const std::uint32_t* chosen) const {
    return choose<3>({wide(s.a), wide(s.b), wide(s.c)}, at, chosen);
  }
  TreePoint step(const Capsule<S>& s, const Placement& at, const std::uint32_t* chosen) const {
    return choose<2>({Vec3<double>(0, 0, -double(s.half_height)), Vec3<double>(0, 0, double(s.half_height))},
                     at, chosen);
  }
  TreePoint step(const Box<S>& s, const Placement& at, const std::uint32_t* chosen) const {
    const std::uint32_t k = chosen ? *chosen : box_support(at.to_own(n_));
    return at.at(box_vertex(wide(s.half_extents), k), k);
  }
  TreePoint step(const Hull<S>& s, const Placement& at, const std::uint32_t* chosen) const {
    const std::uint32_t k = chosen ? *chosen : hull_support(s, at.to_own(n_));
    const Vec3<double> x = power_of_two(s.exponent()) * hull_vertex<double>(s, k);
    return at.moved(wide(s.center())).at(x, k);
  }
  // `drawn_in` is the point moved into the shape. A walk that names its points returns these.
  TreePoint curved(const Vec3<double>& x, const Vec3<double>& drawn_in, const Placement& at) {
    if (feature_ && curved_parts_ < kCurvedParts) feature_->curved[curved_parts_] = drawn_in;
    ++curved_parts_;
    return at.at(feature_ ? drawn_in : x, 0);
  }
  // Beyond kInside, towards a point well inside that no symmetry of the shape keeps in place.
  [[nodiscard]] Vec3<double> towards(const Vec3<double>& x, const Vec3<double>& inner) const {
    return drawn_ > 0 ? Vec3<double>(x + drawn_ * (inner - x)) : x;
  }
  TreePoint step(const Ellipsoid<S>& s, const Placement& at, const std::uint32_t*) {
    const Vec3<double> x = ellipsoid_point(wide(s.radii), at.to_own(n_));
    return curved(x, towards(kInside * x, scaled_by_axis(wide(s.radii), Vec3<double>(0.2, 0.1, 0.15))), at);
  }
  TreePoint step(const Cylinder<S>& s, const Placement& at, const std::uint32_t*) {
    const double r = s.radius, h = s.half_height;
    const Vec3<double> x = cylinder_point(r, h, at.to_own(n_));
    return curved(x, towards({kInside * x[0], kInside * x[1], x[2]}, {0.2 * r, 0.1 * r, 0.15 * h}), at);
  }
  TreePoint step(const Cone<S>& s, const Placement& at, const std::uint32_t*) {
    const double r = s.radius, h = s.half_height;
    const Vec3<double> x = cone_point(r, h, at.to_own(n_));
    return curved(x, towards({kInside * x[0], kInside * x[1], x[2]}, {0.2 * r, 0.1 * r, -0.5 * h}), at);
  }

  TreePoint step(const Posed<S>& s, const Placement& at, const std::uint32_t* chosen) {
    return (*this)(s.shape->shape, at.moved(wide(s.position)).turned(as_double(s.orientation)), chosen);
  }
  TreePoint step(const Rounded<S>& s, const Placement& at, const std::uint32_t* chosen) {
    return (*this)(s.shape->shape, at, chosen);
  }
  TreePoint step(const Sum<S>& s, const Placement& at, const std::uint32_t* chosen) {
    TreePoint total;
    std::uint64_t stride = chosen ? count_of_sum<S>(s.shapes) : 1;
    std::uint32_t rest = chosen ? *chosen : 0;
    Placement here = at;
    for (const auto& part : s.shapes) {
      const std::uint64_t count = vertex_count<S>(part->shape);
      std::uint32_t own = 0;
      if (chosen) {
        stride /= count;
        own = static_cast<std::uint32_t>(rest / stride);
        rest = static_cast<std::uint32_t>(rest % stride);
      }
      const TreePoint point = (*this)(part->shape, here, chosen ? &own : nullptr);
      for (int i = 0; i < 3; ++i) {
        const TwoDoubles sum = TwoDoubles{total.x[i], total.lo[i]} + TwoDoubles{point.x[i], point.lo[i]};
        total.x[i] = sum.hi;
        total.lo[i] = sum.lo;
      }
      total.excess = total.excess + point.excess;
      total.vertex = static_cast<std::uint32_t>(total.vertex * count) + point.vertex;
      here = at.about_zero();
    }
    return total;
  }
  TreePoint step(const HullOf<S>& s, const Placement& at, const std::uint32_t* chosen) {
    const TwoDoubles least = least_radius<S>(s.shapes);
    TreePoint best;
    bool found = false;
    std::uint64_t before = 0;
    for (const auto& part : s.shapes) {
      const std::uint64_t count = vertex_count<S>(part->shape);
      const bool here = chosen && *chosen >= before && *chosen < before + count;
      if (!chosen || here) {
        const std::uint32_t own = chosen ? static_cast<std::uint32_t>(*chosen - before) : 0;
        TreePoint point = (*this)(part->shape, at, chosen ? &own : nullptr);
        point.excess = point.excess + (exact_radius<S>(part->shape) + -least);
        const double above =
            dot(n_, (point.x - best.x) + (point.lo - best.lo)) + (point.excess + -best.excess).hi;
        if (!found || above > 0) {
          found = true;
          best = point;
          best.vertex += static_cast<std::uint32_t>(before);
        }
      }
      before += count;
    }
    return best;
  }

  Vec3<double> n_;
  Feature* feature_;
  double drawn_;
  std::size_t curved_parts_ = 0;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
