// A ray in the axes of the body that it is cast at: {o + t w : t >= 0}, where o and w are exact up to rounding.
//
// A ray is the cast of a Point. Each shape has a direct answer (rays/*.hpp): no search and no support function.
//
//   o = R^T (p - position),   w = R^T (v - displacement),   R the body's rotation, p + t v the point.
//
// predicate_error   bounds the error of a point x = o + t w of the ray that is near the body, |x| <= reach (1 + 2^-10), and of
//         n.x / |n| and h(n) / |n|. u in double, per component, d = p - position:
//           R          entries within 10 u (prepared_pair.hpp): 10 sqrt(3) u reach, as o and t w are rotated alike
//           d and v    u |d| and u |t v|, and |t v| <= |d| + reach
//           R^T d      3 u |d| and 3 u |t v|
//           o + t w    2 u (|d| + |t v|)
//         In all 24 u reach + 12 u |d|, as a length sqrt(3) times that: 42 u reach + 21 u |d|. The forms n.x and h(n)
//         add less than 12 u reach. |d| <= |o|_1 (1 + 2^-40). So 64 u (|o|_1 + reach) is enough.
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct Ray {
  Triple o, w;
  double predicate_error = 0;  // length
  double t_max = 0;

  [[nodiscard]] Triple at(double t) const { return o + t * w; }
};

// A body prepared for rays: valid while it lives. It has passed validate().
template <Scalar S>
class RayTarget {
 public:
  explicit RayTarget(const Body<S>& body) : body_(body), turned_(!body.orientation.is_identity()) {
    if (turned_) set_rotation();
  }
  [[nodiscard]] const Body<S>& body() const { return body_; }

  // reach: bounds |x| over the body.
  [[nodiscard, gnu::always_inline]] Ray ray(const Vec3<S>& origin, const Vec3<S>& displacement, double reach,
                                            double t_max) const {
    Ray out;
    out.o = to_own(triple(origin) - triple(body_.position));
    out.w = to_own(triple(displacement) - triple(body_.displacement));
    out.predicate_error = 64 * kUnitRoundoff<double> * (sum(magnitude(out.o)) + reach);
    out.t_max = t_max;
    return out;
  }
  [[nodiscard]] bool turned() const { return turned_; }
  // By number, here and below: a Triple that is chosen or copied in memory is read 16 bytes at a time, which waits for its
  // stores.
  [[nodiscard, gnu::always_inline]] Triple to_world(const Triple& x) const {
    double i = x.x, j = x.y, k = x.z;
    if (turned_) {
      i = dot(row_[0], x);
      j = dot(row_[1], x);
      k = dot(row_[2], x);
    }
    return {i, j, k};
  }
  // The body's point x, in its own axes, at time t.
  [[nodiscard]] Triple placed(const Triple& x, double t) const {
    return triple(body_.position) + (t * triple(body_.displacement) + to_world(x));
  }

 private:
  void set_rotation() {
    const Mat3<double> r = rotation_matrix(as_double(body_.orientation));
    for (int i = 0; i < 3; ++i) row_[std::size_t(i)] = {r(i, 0), r(i, 1), r(i, 2)};
  }
  [[nodiscard, gnu::always_inline]] Triple to_own(const Triple& n) const {
    double i = n.x, j = n.y, k = n.z;
    if (turned_) {
      i = fl(n.x * row_[0].x) + (fl(n.y * row_[1].x) + fl(n.z * row_[2].x));
      j = fl(n.x * row_[0].y) + (fl(n.y * row_[1].y) + fl(n.z * row_[2].y));
      k = fl(n.x * row_[0].z) + (fl(n.y * row_[1].z) + fl(n.z * row_[2].z));
    }
    return {i, j, k};
  }

  const Body<S>& body_;
  bool turned_;
  std::array<Triple, 3> row_;  // of R, unless it is the identity
};

// The result of a clip.
struct RayHit {
  enum class Kind : std::uint8_t {
    open,   // rounding decides, or the shape is degenerate: another search answers
    start,  // in contact at t = 0, deeper than the predicate_error
    miss,   // no contact up to t_max, by more than the predicate_error
    hit,    // n supports the body at its point x, where the ray is at t, within predicate_error / 2
  };
  Kind kind = Kind::open;
  // Set for a hit: own axes, n points outward and has length 1. Not set for another kind.
  double t;
  Triple n, x;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
