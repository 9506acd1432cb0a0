// One body of a pair for the curved walk: cylinder, cone and ellipsoid in closed form, the rest as their core.
//
// A core is the hull of pieces. Each piece has one farthest point along a direction, which changes smoothly with that
// direction: a vertex, a cylinder's rims (0 below, 1 above), a cone's rim (0) and apex (1), an ellipsoid (0). For a
// piece the walk needs its point p(n) and its bend, the second derivative of n.p(n), by which p changes as n rotates.
//
// Rounding per component, internal length, u in double. A rim's point and an ellipsoid's are within 6 u of the reach
// (leaf.hpp). The choice falls short of the greatest along n by at most 12 u of the reach. These lie within error()
// once and twice. Else as prepared_pair.hpp says.
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
[[nodiscard]] bool is_curved_leaf(const Shape<S>& shape) {
  return std::holds_alternative<Ellipsoid<S>>(shape) || std::holds_alternative<Cylinder<S>>(shape) ||
         std::holds_alternative<Cone<S>>(shape);
}

// Second derivatives along two directions e, f across the path.
struct Bend {
  double ee = 0, ef = 0, ff = 0;
};

template <Scalar S>
class PreparedCurved {
 public:
  explicit PreparedCurved(const Body<S>& body) : core_(body) {
    if (const auto* cylinder = std::get_if<Cylinder<S>>(&body.shape)) {
      kind_ = Kind::cylinder;
      radii_ = {double(cylinder->radius), double(cylinder->radius), double(cylinder->half_height)};
    } else if (const auto* cone = std::get_if<Cone<S>>(&body.shape)) {
      kind_ = Kind::cone;
      radii_ = {double(cone->radius), double(cone->radius), double(cone->half_height)};
    } else if (const auto* ellipsoid = std::get_if<Ellipsoid<S>>(&body.shape)) {
      kind_ = Kind::ellipsoid;
      radii_ = triple(ellipsoid->radii);
    }
  }
  // k: the internal length is 2^-k of the caller's.
  void prepare(int k) {
    const double scale = power_of_two(-k);
    reach_ = scale * core_.reach();
    if (kind_ == Kind::core) {
      core_.prepare(k);
    } else {
      radii_ = scale * radii_;
    }
  }

  [[nodiscard]] const PreparedCore<S>& core() const { return core_; }
  [[nodiscard]] bool is_curved() const { return kind_ != Kind::core; }
  [[nodiscard]] double reach() const { return reach_; }  // of the core
  [[nodiscard]] double error() const {
    if (kind_ == Kind::core) return core_.error();
    return (6 + (core_.turned() ? kCoreRotation : 0)) * kUnitRoundoff<double> * reach_;
  }
  [[nodiscard]] double support_error() const { return kind_ == Kind::core ? core_.support_error() : 0.0; }

  // Along n, which is in world axes, its largest component near 1: a piece that is far along it, and its point.
  [[nodiscard, gnu::always_inline]] Triple support(const Triple& n, std::uint32_t& piece) const {
    if (kind_ == Kind::core) return core_.support(n, piece);
    const Triple d = core_.to_own(n);
    piece = farthest_piece(d);
    return core_.to_world(point(piece, d));
  }
  // The farthest one in doubles.
  [[nodiscard]] Triple farthest(const Triple& n, std::uint32_t& piece) const {
    return kind_ == Kind::core ? core_.farthest(n, piece) : support(n, piece);
  }
  // The piece's point that is farthest along n, in the body's own axes about its centre.
  [[nodiscard]] Triple own(std::uint32_t piece, const Triple& n) const {
    return kind_ == Kind::core ? core_.own(piece) : point(piece, core_.to_own(n));
  }

  // The point of a curved body's piece that is farthest along n, and its bend along e and f, the directions across
  // the path in the body's own axes.
  [[nodiscard]] Triple turn(std::uint32_t piece, const Triple& n, const Triple& e, const Triple& f,
                            Bend& bend) const {
    const Triple d = core_.to_own(n);
    bend = {};
    if (kind_ == Kind::ellipsoid) {
      const Triple y = scaled(d), e_y = scaled(e), f_y = scaled(f);
      const double length_sq = dot(y, y);
      if (!(length_sq > kLeastSquare)) return {0, 0, 0};
      const double by = 1 / square_root(length_sq), along_e = by * dot(y, e_y), along_f = by * dot(y, f_y);
      bend.ee = by * (dot(e_y, e_y) - fl(along_e * along_e));
      bend.ef = by * (dot(e_y, f_y) - fl(along_e * along_f));
      bend.ff = by * (dot(f_y, f_y) - fl(along_f * along_f));
      return core_.to_world(by * scaled(y));
    }
    // A rim: R |d_xy|, which bends along the tangent alone, by R / |d_xy|.
    const double z = piece == 1 ? radii_.z : -radii_.z, across_sq = fl(d.x * d.x) + fl(d.y * d.y);
    if ((kind_ == Kind::cone && piece == 1) || !(across_sq > kLeastSquare)) return core_.to_world({0, 0, z});
    const double one = 1 / square_root(across_sq), by = radii_.x * one, bent = by * one * one,
                 e_t = fl(d.x * e.y) - fl(d.y * e.x), f_t = fl(d.x * f.y) - fl(d.y * f.x);
    bend.ee = bent * e_t * e_t;
    bend.ef = bent * e_t * f_t;
    bend.ff = bent * f_t * f_t;
    return core_.to_world({by * d.x, by * d.y, z});
  }

  // A flat end's outward normal is up or down along the axis, and its rim is at that height.
  [[nodiscard]] bool has_end(bool up) const {
    return kind_ == Kind::cylinder || (kind_ == Kind::cone && !up);
  }
  [[nodiscard]] Triple axis() const { return core_.to_world({0, 0, 1}); }
  [[nodiscard]] double rim_radius() const { return radii_.x; }
  [[nodiscard]] double half_height() const { return radii_.z; }

 private:
  enum class Kind : std::uint8_t { core, cylinder, cone, ellipsoid };
  // Squares of what is shorter are out of range: such a rim point is taken for the centre of the end.
  static constexpr double kLeastSquare = 0x1p-500;

  [[nodiscard]] Triple scaled(const Triple& d) const {
    return {radii_.x * d.x, radii_.y * d.y, radii_.z * d.z};
  }
  [[nodiscard]] std::uint32_t farthest_piece(const Triple& d) const {
    switch (kind_) {
      case Kind::cylinder:
        return d.z >= 0 ? 1 : 0;
      case Kind::cone:
        return 2 * radii_.z * d.z >= radii_.x * square_root(fl(d.x * d.x) + fl(d.y * d.y)) ? 1 : 0;
      default:
        return 0;
    }
  }
  [[nodiscard]] Triple point(std::uint32_t piece, const Triple& d) const {
    if (kind_ == Kind::ellipsoid) {
      const Triple y = scaled(d);
      const double length_sq = dot(y, y);
      return length_sq > kLeastSquare ? (1 / square_root(length_sq)) * scaled(y) : Triple{0, 0, 0};
    }
    const double z = piece == 1 ? radii_.z : -radii_.z, across_sq = fl(d.x * d.x) + fl(d.y * d.y);
    if ((kind_ == Kind::cone && piece == 1) || !(across_sq > kLeastSquare)) return {0, 0, z};
    const double by = radii_.x / square_root(across_sq);
    return {by * d.x, by * d.y, z};
  }

  PreparedCore<S> core_;
  Kind kind_ = Kind::core;
  double reach_ = 0;
  Triple radii_{0, 0, 0};  // of a cylinder and a cone: radius, radius, half height
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
