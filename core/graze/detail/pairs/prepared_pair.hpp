// Two polytopes prepared for a quick walk: where a vertex of C = A - B is, and one that is far along a
// direction. A `PreparedCore` is one of the two bodies, a `PreparedPair` both.
//
//   internal length = world length 2^-k,   c = R_A a - (R_B b + offset),  a and b about the bodies' centres.
//
// Takes point, segment, triangle, box, hull, and the cores of sphere, capsule and rounding of one of these. Any other
// shape is reached through its side (side.hpp). In doubles whatever the scalar of the bodies. A guess along a direction is by floats on hulls:
// it costs half, and a caller that needs the farthest vertex must confirm it.
//
// Rounding, internal length, per component, u in double, with |a|, |b| <= reach:
//   body     0 for R x if R is the identity, else kCoreRotation u |x|: entries of R within 10 u (as
//            rotation_matrix, with a product by a reciprocal instead of a quotient), so 10 sqrt(3) u, and
//            3 u for the sum of three
//   offset   2 u of it, and 2^-95 of the centres that were rotated (offset.hpp: 2^-98 of their length each)
#pragma once

#include <graze/detail/numeric/triple.hpp>
#include <graze/detail/pairs/side.hpp>
#include <graze/detail/shapes/approximate_scan.hpp>
#include <optional>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The radius of the ball about a core of these shapes, caller's unit.
template <Scalar S>
[[nodiscard]] double plain_radius(const Shape<S>& shape) {
  if (const auto* rounded = std::get_if<Rounded<S>>(&shape)) return double(rounded->radius);
  if (const auto* sphere = std::get_if<Sphere<S>>(&shape)) return double(sphere->radius);
  if (const auto* capsule = std::get_if<Capsule<S>>(&shape)) return double(capsule->radius);
  return 0;
}

inline constexpr int kCoreRotation = 21;

// One body. Valid while it lives.
template <Scalar S>
class PreparedCore {
 public:
  // Caller's units. `prepare` sets the internal unit.
  explicit PreparedCore(const Body<S>& body) : body_(body) {
    const Shape<S>& shape = without_ball(body.shape);
    if (const auto* hull = std::get_if<Hull<S>>(&shape)) {
      kind_ = Kind::hull;
      if (hull->has_map()) {
        kind_ = Kind::mapped;
        map_ = &hull->graph().map;
      }
      hull_ = hull;
      vertices_ = hull->vertices().data();
      guess_ = hull->approximate_scan(0);
      padded_ = hull->padded_size();
      center_ = triple(hull->center());
      size_ = hull->size_about_center();
      reach_ = hull->reach_about_center();
    } else if (const auto* box = std::get_if<Box<S>>(&shape)) {
      kind_ = Kind::box;
      few_[0] = triple(box->half_extents);
      set_reach(few_[0]);
    } else if (const auto* triangle = std::get_if<Triangle<S>>(&shape)) {
      set_few({triple(triangle->a), triple(triangle->b), triple(triangle->c)}, 3);
    } else if (const auto* segment = std::get_if<Segment<S>>(&shape)) {
      set_few({triple(segment->a), triple(segment->b), triple(segment->b)}, 2);
    } else {
      set_other(shape);
    }
    turned_ = !body.orientation.is_identity() && (size_ > 0 || largest(center_) > 0);
    if (turned_) set_rotation();
    far_out_ = turned_ && largest(center_) > size_;
  }
  // k: the internal length is 2^-k of the caller's.
  void prepare(int k) {
    const double scale = power_of_two(-k);
    unit_ *= scale;
    reach_ *= scale;
    size_ *= scale;
    if (kind_ == Kind::box) few_[0] = scale * few_[0];
    if (kind_ == Kind::few) {
      for (Triple& x : few_) x = scale * x;
    }
    if (kind_ != Kind::side) return;
    side_ = make_side<double>(body_, bounds(body_.shape), k, Turning::quick);
    point_error_ = side_->point_error;
  }

  [[nodiscard]] const PreparedCore& core() const { return *this; }
  [[nodiscard]] const Body<S>& body() const { return body_; }
  [[nodiscard]] double reach() const { return reach_; }
  // The largest of its bounds' coordinates, about the centre.
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] bool turned() const { return turned_; }
  [[nodiscard]] const Triple& center() const { return center_; }  // caller's unit, own axes
  // Rounding of a vertex in world axes about the centre, per component.
  [[nodiscard]] double error() const {
    return (turned_ ? fl(kCoreRotation * kUnitRoundoff<double> * reach_) : 0.0) + point_error_;
  }
  // Error bound, over |n|, on the vertex that support() finds: how far it may lie below the farthest. A guess
  // compares sums of floats. Coordinates and direction round by u each, products by 3 u (u of float). This gives 5 u
  // of |d|_1 reach <= sqrt(3) |n| reach for each of two vertices. In addition n was rotated.
  [[nodiscard]] double support_error() const {
    constexpr double u = kUnitRoundoff<double>, u_float = kUnitRoundoff<float>;
    const double turn = turned_ ? fl(2 * kCoreRotation * u * reach_) : 0.0;
    switch (kind_) {
      case Kind::hull:
      case Kind::mapped:
        return turn + fl(20.0 * u_float * reach_);
      case Kind::side:
        return turn + side_->support_error;
      default:
        return turn + fl(16 * u * reach_);
    }
  }
  // n rotated into the body's axes: within kCoreRotation u |n|.
  [[nodiscard, gnu::always_inline]] Triple to_own(const Triple& n) const {
    double x = n.x, y = n.y, z = n.z;
    if (turned_) {
      x = fl(n.x * row_[0].x) + fl(n.y * row_[1].x) + fl(n.z * row_[2].x);
      y = fl(n.x * row_[0].y) + fl(n.y * row_[1].y) + fl(n.z * row_[2].y);
      z = fl(n.x * row_[0].z) + fl(n.y * row_[1].z) + fl(n.z * row_[2].z);
    }
    return {x, y, z};
  }
  // The centre's position at t = 0: position + R centre, caller's unit.
  [[nodiscard]] Triple placed_center() const {
    const Triple p = triple(body_.position);
    if (!far_out_) return p + to_world(center_);
    return triple(detail::placed_center(p.vector(), as_double(body_.orientation), center_.vector()));
  }
  [[nodiscard]] const Triple& row(std::size_t i) const { return row_[i]; }  // of R, unless it is the identity
  [[nodiscard, gnu::always_inline]] Triple to_world(const Triple& x) const {
    double i = x.x, j = x.y, k = x.z;
    if (turned_) {
      i = dot(row_[0], x);
      j = dot(row_[1], x);
      k = dot(row_[2], x);
    }
    return {i, j, k};
  }

  // The farthest vertex along n in doubles, n of any length but 0: within 8 u |n| reach (leaf.hpp).
  [[nodiscard]] Triple farthest(const Triple& n, std::uint32_t& vertex) const {
    if (kind_ != Kind::hull && kind_ != Kind::mapped) return support(n, vertex);
    vertex = hull_support<double, S>(*hull_, to_own(n).vector());
    return at(vertex);
  }

  // A vertex far along n, and its position. n is in world axes, its largest component near 1.
  [[nodiscard, gnu::always_inline]] Triple support(const Triple& n, std::uint32_t& vertex) const {
    const Triple d = to_own(n);
    double x, y, z;
    if (kind_ == Kind::hull) {
      vertex = approximate_scan(guess_, padded_, float(d.x), float(d.y), float(d.z));
      const Vec3<S>& v = vertices_[vertex];
      x = unit_ * (double(v[0]) - center_.x);
      y = unit_ * (double(v[1]) - center_.y);
      z = unit_ * (double(v[2]) - center_.z);
    } else if (kind_ == Kind::box) {
      // By the sign bits: nothing to guess for the machine.
      vertex = plus(d.x) | plus(d.y) << 1 | plus(d.z) << 2;
      x = std::copysign(few_[0].x, d.x);
      y = std::copysign(few_[0].y, d.y);
      z = std::copysign(few_[0].z, d.z);
    } else if (kind_ == Kind::few) {
      // The places that a segment or a point leaves hold its last: nothing to guess for the machine.
      const double h0 = dot(d, few_[0]), h1 = dot(d, few_[1]), h2 = dot(d, few_[2]);
      const unsigned second = unsigned(h1 > h0) & unsigned(h1 >= h2),
                     third = unsigned(h2 > h0) & unsigned(h2 > h1);
      vertex = second | third << 1;
      x = few_[vertex].x;
      y = few_[vertex].y;
      z = few_[vertex].z;
    } else {
      vertex = other_support(d.x, d.y, d.z);
      const Triple v = own(vertex);
      x = v.x;
      y = v.y;
      z = v.z;
    }
    return to_world({x, y, z});
  }
  [[nodiscard, gnu::always_inline]] Triple at(std::uint32_t vertex) const { return to_world(own(vertex)); }
  [[nodiscard]] bool has_vertex(std::uint32_t vertex) const {
    switch (kind_) {
      case Kind::hull:
      case Kind::mapped:
        return vertex < hull_->size();
      case Kind::box:
        return vertex < 8;
      case Kind::few:
        return vertex < count_;
      case Kind::side:
        return false;
    }
    return false;
  }
  // A point of the body, mostly of its inside, in world axes about the centre: within 8 u of the reach, and error().
  [[nodiscard]] Triple inside() const {
    switch (kind_) {
      case Kind::hull:
      case Kind::mapped:
        return to_world(unit_ * triple(hull_->inside()));
      case Kind::few: {
        if (count_ == 1) return to_world(few_[0]);
        if (count_ == 2) return to_world(0.5 * (few_[0] + few_[1]));
        return to_world((1.0 / 3) * (few_[0] + few_[1] + few_[2]));
      }
      default:
        return {0, 0, 0};
    }
  }
  // Vertex in the body's own axes, about the centre, internal length. It is exact except for shapes reached through
  // their side.
  [[nodiscard, gnu::always_inline]] Triple own(std::uint32_t vertex) const {
    // By number: a Triple that is passed in memory is copied 16 bytes at a time, which waits for its
    // stores.
    double x, y, z;
    switch (kind_) {
      case Kind::hull:
      case Kind::mapped: {
        GRAZE_ASSERT(vertex < hull_->size());
        const Vec3<S>& v = vertices_[vertex];  // exact (hull.hpp)
        x = unit_ * (double(v[0]) - center_.x);
        y = unit_ * (double(v[1]) - center_.y);
        z = unit_ * (double(v[2]) - center_.z);
        break;
      }
      case Kind::box:
        x = vertex & 1u ? few_[0].x : -few_[0].x;
        y = vertex & 2u ? few_[0].y : -few_[0].y;
        z = vertex & 4u ? few_[0].z : -few_[0].z;
        break;
      case Kind::few:
        x = few_[vertex].x;
        y = few_[vertex].y;
        z = few_[vertex].z;
        break;
      default: {
        const Vec3<double> v = side_->support(*side_, Vec3<double>::UnitX(), &vertex).x;
        x = v[0];
        y = v[1];
        z = v[2];
      }
    }
    return {x, y, z};
  }

 private:
  // mapped: a hull whose guesses are by its map, the same to the bit.
  enum class Kind : std::uint8_t { few, box, hull, mapped, side };

  [[nodiscard]] static std::uint32_t plus(double x) {
    return 1u ^ static_cast<std::uint32_t>(detail::bit_cast<std::uint64_t>(x) >> 63);
  }
  [[nodiscard, gnu::noinline]] std::uint32_t other_support(double x, double y, double z) const {
    const Triple d{x, y, z};
    if (kind_ == Kind::mapped) {
      const auto dx = static_cast<float>(x), dy = static_cast<float>(y), dz = static_cast<float>(z);
      DirectionMap::List list;
      if (!map_->find(dx, dy, dz, list)) return approximate_scan(guess_, padded_, dx, dy, dz);
      return list.vertex[approximate_scan(list.xyz, list.size, dx, dy, dz)];
    }
    return side_->support(*side_, d.vector(), nullptr).vertex;
  }
  void set_reach(const Triple& extent) {
    size_ = largest(extent);
    reach_ = square_root(dot(extent, extent)) * (1 + 0x1p-50);
  }
  [[gnu::noinline]] void set_other(const Shape<S>& shape) {
    if (std::holds_alternative<Point<S>>(shape) || std::holds_alternative<Sphere<S>>(shape)) {
      few_.fill({0, 0, 0});
    } else if (const auto* capsule = std::get_if<Capsule<S>>(&shape)) {
      const Triple up{0, 0, double(capsule->half_height)};
      set_few({-up, up, up}, 2);
    } else {
      kind_ = Kind::side;
      const Bounds bounds = detail::bounds(shape);
      center_ = triple(bounds.center);
      set_reach(triple(Vec3<double>(bounds.half + bounds.middle.cwiseAbs())));
    }
  }
  // About their bounds' centre where they lie farther out than they are large: along the axes where the offset exceeds
  // the extent the differences are then exact (hull.hpp). Nearer in nothing is gained, and a centre would be rotated.
  void set_few(const std::array<Triple, 3>& points, std::uint32_t count) {
    kind_ = Kind::few;
    count_ = count;
    Triple low, middle, half;
    const auto bounds = [](double x, double y, double z, double& least, double& at, double& reach) {
      const double most = std::max(std::max(x, y), z);
      least = std::min(std::min(x, y), z);
      at = least / 2 + most / 2;
      reach = most / 2 - least / 2;
    };
    const Triple &p = points[0], &q = points[1], &r = points[2];
    bounds(p.x, q.x, r.x, low.x, middle.x, half.x);
    bounds(p.y, q.y, r.y, low.y, middle.y, half.y);
    bounds(p.z, q.z, r.z, low.z, middle.z, half.z);
    if (largest(middle) > 2.5 * largest(half)) {
      const auto center = [](double& at, double least, double reach) {
        const double out = std::abs(at) > 2.5 * reach ? at : 0.0;
        at = (least - out) + reach;
        return out;
      };
      center_ = {center(middle.x, low.x, half.x), center(middle.y, low.y, half.y),
                 center(middle.z, low.z, half.z)};
    }
    for (std::size_t i = 0; i < 3; ++i) few_[i] = points[i] - center_;
    set_reach(half + magnitude(middle));
  }
  void set_rotation() {
    const double w = body_.orientation.w, x = body_.orientation.x, y = body_.orientation.y,
                 z = body_.orientation.z;
    const double ww = fl(w * w), xx = fl(x * x), yy = fl(y * y), zz = fl(z * z), xy = fl(x * y),
                 xz = fl(x * z), yz = fl(y * z), wx = fl(w * x), wy = fl(w * y), wz = fl(w * z),
                 s = 1 / (ww + xx + yy + zz);
    row_[0] = {s * (ww + xx - yy - zz), s * 2 * (xy - wz), s * 2 * (xz + wy)};
    row_[1] = {s * 2 * (xy + wz), s * (ww - xx + yy - zz), s * 2 * (yz - wx)};
    row_[2] = {s * 2 * (xz - wy), s * 2 * (yz + wx), s * (ww - xx - yy + zz)};
  }

  const Body<S>& body_;
  const Hull<S>* hull_ = nullptr;
  const DirectionMap* map_ = nullptr;
  const Vec3<S>* vertices_ = nullptr;  // of the hull
  const float* guess_ = nullptr;       // its guess scan, by axis, each padded_ long
  std::size_t padded_ = 0;
  Kind kind_ = Kind::few;
  bool turned_ = false, far_out_ = false;
  std::uint32_t count_ = 1;
  double unit_ = 1, reach_ = 0, size_ = 0, point_error_ = 0;
  Triple center_{0, 0, 0};
  std::array<Triple, 3> few_, row_;  // filled as needed, few_ repeats its last
  std::optional<Side<double>> side_;
};

// From the centre of A to the centre of B at t = 0, caller's unit.
template <Scalar S>
[[nodiscard]] Triple offset_of_centers(const PreparedCore<S>& a, const PreparedCore<S>& b) {
  const Body<S>&body_a = a.body(), &body_b = b.body();
  if (largest(a.center()) == 0 && largest(b.center()) == 0)
    return triple(body_b.position) - triple(body_a.position);
  return triple(accurate_offset(body_a.position.template cast<double>(), as_double(body_a.orientation),
                                a.center().vector(), body_b.position.template cast<double>(),
                                as_double(body_b.orientation), b.center().vector()));
}

// The pair: valid while the bodies live. They have passed validate(). G: a PreparedCore, or what has one (prepared_curved.hpp).
// Balls about the cores, and a target distance, are of those walks that ask for them: C is then the cores' difference,
// rounded by R.
template <Scalar S, class G = PreparedCore<S>>
class PreparedPair {
 public:
  PreparedPair(const Body<S>& a, const Body<S>& b) : a_(a), b_(b) { prepare(a, b); }
  // For cores without prepared data.
  PreparedPair(const G& a, const G& b) : a_(a), b_(b) { prepare(a.core().body(), b.core().body()); }
  // With their balls.
  PreparedPair(const Body<S>& a, const Body<S>& b, double target_distance)
      : a_(a),
        b_(b),
        radius_a_(plain_radius(a.shape)),
        radius_b_(plain_radius(b.shape)),
        radius_(radius_a_ + radius_b_ + target_distance) {
    prepare(a, b);
    radius_ *= power_of_two(-k_);
  }

  [[nodiscard]] const G& a() const { return a_; }
  [[nodiscard]] const G& b() const { return b_; }
  [[nodiscard]] const Triple& offset() const { return offset_; }
  // The largest of the bodies' sizes, balls included, and of the offset's components, in [1, 2). It is within a
  // factor 4 of the pair's scale, and below twice that (a core's size is at most 3.5 times half its longest side,
  // hull.hpp).
  [[nodiscard]] double size() const { return size_; }
  // A tolerance over the pair's scale, as a length: no more than that.
  [[nodiscard]] double tolerated(double tolerance) const { return tolerance * (size_ / 2); }
  [[nodiscard]] double offset_error() const { return offset_error_; }  // per component
  [[nodiscard]] double extent() const { return extent_; }      // M, bounds |c| over the cores' difference
  [[nodiscard]] double radius() const { return radius_; }      // R
  [[nodiscard]] double radius_a() const { return radius_a_; }  // caller's unit
  [[nodiscard]] double radius_b() const { return radius_b_; }
  // Error bound on the farthest point along n, over |n|_1 (search/fast/round_walk.hpp).
  [[nodiscard]] double ball_margin() const {
    return 4 * (a_.error() + b_.error()) + offset_error_ + 64 * kUnitRoundoff<double> * (extent_ + radius_);
  }
  // r = v 2^-j, within u per component, or zero if nothing moves.
  [[nodiscard]] const Triple& direction() const { return r_; }
  [[nodiscard]] bool moves() const { return largest(r_) > 0; }
  [[nodiscard]] int length_exponent() const { return k_; }
  [[nodiscard]] int speed_exponent() const { return j_; }

 private:
  [[gnu::always_inline]] void prepare(const Body<S>& a, const Body<S>& b) {
    const PreparedCore<S>&core_a = a_.core(), &core_b = b_.core();
    const Triple d = offset_of_centers(core_a, core_b);
    const double size = std::max({core_a.size() + radius_a_, core_b.size() + radius_b_, largest(d)});
    k_ = size > 0 ? exponent_of(size) : 0;
    size_ = power_of_two(-k_) * size;
    offset_ = power_of_two(-k_) * d;
    // One rounding of a difference, or of a sum of pairs with the error of rotating the centres.
    const double turned = (core_a.turned() ? largest(core_a.center()) : 0.0) +
                          (core_b.turned() ? largest(core_b.center()) : 0.0);
    offset_error_ = 2 * kUnitRoundoff<double> * largest(offset_) + fl(0x1p-95 * power_of_two(-k_) * turned);
    a_.prepare(k_);
    b_.prepare(k_);
    extent_ = a_.reach() + b_.reach() + fl(square_root(dot(offset_, offset_)) * (1 + 0x1p-50));
    const Triple v = triple(b.displacement) - triple(a.displacement);
    const double speed = largest(v);
    j_ = speed > 0 ? exponent_of(speed) : 0;
    r_ = power_of_two(-j_) * v;
  }

  G a_, b_;
  double radius_a_ = 0, radius_b_ = 0, radius_ = 0;
  Triple offset_{}, r_{};
  double extent_ = 0, size_ = 0, offset_error_ = 0;
  int k_ = 0, j_ = 0;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
