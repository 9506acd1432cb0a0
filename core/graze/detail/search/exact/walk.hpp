// The exact portal cast: computes where the line {t v} enters C = A - B and where it leaves.
//
// Seen along v, C is a polygon and the line is the origin o. Every decision is the sign of a determinant of
// exact terms: in doubles with an error bound, else by `exact_scene.hpp`. Notation
//   side(c, d) = det(c, d, v):  > 0 where o is to the left of the edge c -> d;
//   portal     = three vertices of C, o inside their triangle, all sides > 0;
//   n          = -+ (c_1 - c_0) x (c_2 - c_0), the portal's normal against v (entry) or along it (exit).
//
//   1 start    three vertices that are a triangle, seen along v.
//   2 around   while o is outside an edge: the vertex farthest beyond it takes the triangle there. If no vertex
//              is beyond it, the line misses.
//   3 towards  while a vertex w is beyond the portal's plane: w replaces one corner, so that o stays inside.
// [portal refinement: Snethen 2008; the lecture's MPR; here with exact decisions, as a simplex method]
//
// Ties. o is moved, infinitesimally, towards the barycentre m of the first triangle, then along two of its edges:
//   o + e m + e^2 (d_1 - d_0) + e^3 (d_2 - d_0).
// As m is interior to the polygon, the moved o is inside iff o is. The entry of a polytope is continuous along the
// way, so verdict and time are o's own. No side of two vertices that are seen apart is then zero, as no edge is
// parallel to both edges of a triangle.
//
// Flat. If C is seen as a segment, it lies in a plane parallel to v. Let x be an axis that is not parallel to this
// plane. If the plane holds the line, the portal is two vertices c, d with side(c, x) < 0 < side(d, x), and x is the
// third corner, infinitely far away. So the portal's plane is that of d - c and x, and the walk is the same one
// dimension lower. It moves o towards the middle of the first two vertices, then along the segment. If C is seen as a
// point, it lies on a line along v, and the portal is one vertex.
//
// Termination. In 2, every vertex is strictly beyond an edge of the hull of those before it, so it is a new one. In
// 3, w is strictly beyond the plane, and the moved o strictly inside. The portal's height over it strictly falls, so
// no portal occurs twice, and there are finitely many. Both results of a search beyond a plane are proved
// (beyond.hpp): that a vertex is beyond, and that no vertex is. The rounded direction of the search does not matter.
// (If a number outgrows its room, dyadic.hpp, no sign can be trusted. The walk stops, and the cast is refused.)
//
// Frame: world axes, lengths in units of 2^k, v of 2^j. The plane that is seen: with z the axis of v's
// largest component, q = (c_x - (v_x/v_z) c_z, c_y - (v_y/v_z) c_z), and side(c, d) = v_z (q_c x q_d).
#pragma once

#include <graze/detail/search/exact/beyond.hpp>
#include <graze/detail/search/exact/facet.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// u in double.
inline constexpr double kU = kUnitRoundoff<double>;

struct Corner {
  Triple a, b, w;  // of A and B about the bodies' centres, world axes, and a - b - offset
  double qx, qy;
  Vertex id;
};

// The line {t v}, or, for bodies at rest relative to each other, any line through the origin.
struct Line {
  Term v;
  Triple r;  // v rounded, within u per component
  int x = 0, y = 1, z = 2;
  Triple across_x, across_y;  // q_x = across_x.c = c_x - (v_x/v_z) c_z, the slopes within 3.1 u. The same for
                              // q_y
  int sign = 1;               // sign of v_z

  Line(const Term& v_term, const Triple& rounded) : v(v_term), r(rounded) {
    z = largest_axis(magnitude(rounded));
    x = z == 2 ? 0 : z + 1;
    y = 3 - z - x;
    // Selects by arithmetic, because a branch on the axis cannot be predicted.
    const std::array<double, 3> at = {rounded.x, rounded.y, rounded.z};
    const auto axis = [](int i) { return static_cast<std::size_t>(i); };
    const double along = at[axis(z)];
    std::array<double, 3> of_x = {0, 0, 0}, of_y = {0, 0, 0};
    of_x[axis(x)] = 1;
    of_x[axis(z)] = -(at[axis(x)] / along);
    of_y[axis(y)] = 1;
    of_y[axis(z)] = -(at[axis(y)] / along);
    across_x = {of_x[0], of_x[1], of_x[2]};
    across_y = {of_y[0], of_y[1], of_y[2]};
    sign = along > 0 ? 1 : -1;
  }
};

// Error bounds, lengths in internal units, per component:
//   body   of a vertex of A or B about its centre, both added (prepared_pair.hpp).
//   edge   of the difference of two vertices of C, formed from those of A and of B. It includes the error of a
//          determinant of three such (8 u of the product of three, each below 6 reach: 16 u reach each).
//   seen   of q: twice that of w, 3.1 u + u of the slope's product, 2 u of the sum.
//   far    of the extent of C along a rounded direction n, over |n|_1: the error of the guess (|n| is
//          at most 1.5 |n|_1 in space) and n's own rounding.
struct Bounds {
  double body = 0, edge = 0, seen = 0, far = 0;

  template <Scalar S>
  explicit Bounds(const PreparedPair<S>& pair) {
    const double reach = pair.a().reach() + pair.b().reach(), extent = pair.extent();
    body = pair.a().error() + pair.b().error();
    const double place = body + pair.offset_error() + 2 * kU * extent;  // of w
    edge = 2 * body + fl(20 * kU * reach) + kUnderflow;
    seen = 2 * place + 8 * kU * extent + kUnderflow;
    far = seen + 2 * (pair.a().support_error() + pair.b().support_error()) + 16 * kU * reach;
  }
};

// A number in doubles and its error bound.
struct Measured {
  double value = 0, error = 0;

  [[nodiscard]] int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
};
// det(d - c, x, v) / v_z with x = the sum of three vertices less 3 c, the sum as seen, q within `seen`. The error of
// d - c is 2.5 of that (twice, and u of its length, below 2.9 extent). The error of x is 9 of it (6, and 12 u of a
// length below twice the extent each). The product adds 3 u, |x| below 12 extent: 5 of it, over d - c.
inline Measured side_of_middle(const Corner& c, const Corner& d, double sum_x, double sum_y, double seen) {
  const double ex = d.qx - c.qx, ey = d.qy - c.qy, x = sum_x - fl(3.0 * c.qx), y = sum_y - fl(3.0 * c.qy);
  return {fl(ex * y) - fl(ey * x), fl(15 * seen * (std::abs(ex) + std::abs(ey))) +
                                       fl(3 * seen * (std::abs(x) + std::abs(y))) + fl(50 * seen * seen)};
}

// Vertices of C that a walk may begin with.
struct Seeds {
  std::array<Vertex, 3> vertex;
  bool known = false;
  bool last = false;  // a portal that no vertex is likely to be beyond
};

// The proof that a line misses C: n = sign (f1 x f2) has n.v = 0 and h(n) < 0. For a path: h(n) < min(0, t_max n.v).
struct Miss {
  Term f1, f2;
  int sign = 1;
};

template <Scalar S>
class PortalWalk {
 public:
  PortalWalk(const PreparedPair<S>& pair, const Scene<S>& scene, const Line& line, Counters& counters)
      : scene_(scene), pair_(pair), line_(line), bounds_(pair), beyond_(scene, pair), counters_(counters) {
    turned_ = bounds_.body > 0;
  }

  // Steps 1 and 2: a portal, or a miss. `outward`: o is moved away from m instead, so that a line along C's border
  // misses. `seeds`: any three vertices to begin with, from any source. Every triangle of them is a valid start.
  bool find(bool outward = false, const Seeds& seeds = {}) {
    outward_ = outward;
    if (seeds.known && plant(seeds)) {
      last_ = seeds.last;
    } else {
      if (!start()) return false;
      if (!make_triangle()) return find_flat();
    }
    around_ = {at(0).id, at(1).id, at(2).id};
    around_x_ = at(0).qx + at(1).qx + at(2).qx;
    around_y_ = at(0).qy + at(1).qy + at(2).qy;
    return walk_around();
  }
  [[nodiscard]] const Miss& miss() const { return miss_; }

  // Step 3: along v for `toward` = -1 (entry), against it for +1 (exit). Stops early, and returns true, once stop()
  // returns true for a new portal.
  template <class Stop>
  bool refine(int toward, const Stop& stop) {
    toward_ = toward;
    while (goes_on()) {
      if (!above_portal()) return false;
      replace();
      if (stop()) return true;
    }
    return false;
  }

  // The portal's facet: its plane, n.v > 0.
  [[nodiscard]] Facet facet() const {
    const Vertex &a = at(0).id, &b = at(1).id, &c = at(2).id;
    if (size_ == 1) return {a, axis(0), axis(1), {a}, 1};
    return {a, Term::difference(a, b), size_ == 2 ? axis(0) : Term::difference(a, c), {a, b, c}, size_};
  }
  // The sign of the time at which the line is at the portal.
  [[nodiscard]] int height_sign() const {
    if (size_ < 3) return height_sign_exactly();
    const Triple e = edge(at(0), at(1)), f = edge(at(0), at(2));
    const double height = dot(at(0).w, cross(e, f));
    const double e_1 = sum(magnitude(e)), f_1 = sum(magnitude(f));
    const double error =
        fl(1.2 * (fl(bounds_.seen * e_1 * f_1) + fl(sum(magnitude(at(0).w)) * bounds_.edge * (e_1 + f_1)))) +
        kUnderflow;
    if (height > error) return 1;
    if (height < -error) return -1;
    return height_sign_exactly();
  }
  // The portal before the last step, and the vertex that came in. Their hull holds both portals.
  [[nodiscard]] int hull_before(std::array<Vertex, 4>& out) const {
    out = {previous_[0], previous_[1], previous_[2]};
    out[static_cast<std::size_t>(size_)] = newest_;
    return size_ + 1;
  }

 private:
  // Counts a step. The walk terminates by itself (see above). If a defect prevents that, the cast is refused.
  [[nodiscard]] bool goes_on() {
    constexpr int kMostSteps = 1 << 20;
    if (++counters_.portal_steps > kMostSteps) scene_.invalidate();
    return scene_.valid();
  }
  // Corners live in four slots, three of the portal and the next, and change places by their index. A copy of a value
  // just written would wait for that write.
  [[nodiscard]] const Corner& at(std::size_t i) const { return slot_[order_[i]]; }
  [[nodiscard]] Corner& next() { return slot_[order_[3]]; }
  void put_next(std::size_t i) { std::swap(order_[i], order_[3]); }

  void place(Corner& out, const Triple& a, const Triple& b) const {
    out.a = a;
    out.b = b;
    const Triple w = a - (b + pair_.offset());
    out.w = w;
    out.qx = dot(line_.across_x, w);
    out.qy = dot(line_.across_y, w);
  }
  void find_corner(const Vertex& id, Corner& out) const {
    out.id = id;
    place(out, pair_.a().at(id.a), pair_.b().at(id.b));
  }
  [[gnu::noinline]] void support(const Triple& n, Corner& out) const {
    ++counters_.supports;
    // Scaled to near 1, so that no significant component leaves the range of floats.
    const double size = largest(n);
    const Triple scaled_near_one = size > 0 ? power_of_two(-exponent_of(size)) * n : n;
    const Triple a = pair_.a().support(scaled_near_one, out.id.a),
                 b = pair_.b().support(-scaled_near_one, out.id.b);
    place(out, a, b);
  }

  // The support along n2. Returns whether it proves in doubles that the line misses: n = v x (n_y, -n_x, 0).
  bool support_across(double nx, double ny, Corner& out) {
    // Perpendicular to v up to its rounding.
    support(nx * line_.across_x + ny * line_.across_y, out);
    const double height = fl(nx * out.qx) + fl(ny * out.qy);
    if (!(height < -(fl(bounds_.far * 2 * (std::abs(nx) + std::abs(ny))) + kUnderflow))) return true;
    Vec3<double> x = Vec3<double>::Zero();
    x[line_.x] = ny;
    x[line_.y] = -nx;
    return misses(line_.v, Term::given(x), line_.sign);
  }
  bool misses(const Term& f1, const Term& f2, int sign) {
    miss_ = {f1, f2, sign};
    return false;
  }

  // ---- signs ----

  [[nodiscard, gnu::noinline]] int height_sign_exactly() const {
    const Facet at = facet();
    return scene_.determinant_sign(Term::point(at.c0), at.f1, at.f2);
  }
  // The sign of v_z (u_x w_y - u_y w_x), each within e. Returns 0 if the value is within its error bound.
  [[nodiscard]] int sign_in_doubles(double ux, double uy, double wx, double wy, double e) const {
    const double value = fl(ux * wy) - fl(uy * wx);
    const double error =
        fl(2 * e * (std::abs(ux) + std::abs(uy) + std::abs(wx) + std::abs(wy))) + fl(4 * e * e);
    return value > error ? line_.sign : value < -error ? -line_.sign : 0;
  }
  // The sign of det(c, d, v), o moved. It is 0 only for vertices that are seen at one point.
  [[nodiscard]] int side(const Corner& c, const Corner& d) const {
    const int sign = sign_in_doubles(c.qx, c.qy, d.qx, d.qy, bounds_.seen);
    return sign != 0 ? sign : side_exactly(c, d);
  }
  [[nodiscard, gnu::noinline]] int side_exactly(const Corner& c, const Corner& d) const {
    if (!is_level(c.id, d.id)) {
      if (const int s = scene_.determinant_sign(Term::point(c.id), Term::point(d.id), line_.v); s != 0)
        return s;
    }
    if (c.id == d.id) return 0;
    // d/de det(c - e x, d - e x, v) = det(d - c, x, v)
    const Measured middle = side_of_middle(c, d, around_x_, around_y_, bounds_.seen);
    if (const int s = middle.sign(); s != 0) return outward_ ? -s * line_.sign : s * line_.sign;
    const Term e = Term::difference(c.id, d.id);
    if (const int s = scene_.determinant_sign(e, Term::inside(around_, c.id), line_.v); s != 0)
      return outward_ ? -s : s;
    for (const std::size_t i : {1u, 2u}) {
      const Term along = Term::difference(around_[0], around_[i]);
      if (const int s = scene_.determinant_sign(e, along, line_.v); s != 0) return s;
    }
    return 0;
  }
  // Are c, d and v in one plane across an axis, as with faces that slide along each other?
  [[nodiscard]] bool is_level(const Vertex& c, const Vertex& d) const {
    for (int axis = 0; axis < 3; ++axis) {
      // r is 0 only if v is.
      if (line_.r[axis] == 0 && scene_.is_zero_along(axis, c) && scene_.is_zero_along(axis, d)) return true;
    }
    return false;
  }
  // The sign of det(d - c, e - c, v): do the three turn left?
  [[nodiscard]] int turn(const Corner& c, const Corner& d, const Corner& e) const {
    // Error of a difference: twice that of q, and u of its length, below 2.9 extent.
    const double error = 2.5 * bounds_.seen;
    const int sign = sign_in_doubles(d.qx - c.qx, d.qy - c.qy, e.qx - c.qx, e.qy - c.qy, error);
    return sign != 0 ? sign : turn_exactly(c, d, e);
  }
  [[nodiscard, gnu::noinline]] int turn_exactly(const Corner& c, const Corner& d, const Corner& e) const {
    if (e.id == c.id || e.id == d.id || c.id == d.id) return 0;
    return scene_.determinant_sign(Term::difference(c.id, d.id), Term::difference(c.id, e.id), line_.v);
  }

  // ---- 1 ----

  // Takes the seeds as a triangle that turns left, if they form one.
  bool plant(const Seeds& seeds) {
    for (std::size_t i = 0; i < 3; ++i) find_corner(seeds.vertex[i], slot_[i]);
    const int s = turn(slot_[0], slot_[1], slot_[2]);
    if (s < 0) std::swap(order_[1], order_[2]);
    return s != 0;
  }

  // Proposes three vertices that are likely a triangle around o, or close to it.
  [[gnu::noinline]] bool start() {
    Corner &first = slot_[0], &second = slot_[1], &third = slot_[2];
    support(-line_.r, first);
    double nx = -first.qx, ny = -first.qy;
    if (!(std::abs(nx) + std::abs(ny) > 4 * bounds_.seen)) nx = 1;
    if (!support_across(nx, ny, second)) return false;
    double ex = second.qx - first.qx, ey = second.qy - first.qy;
    if (!(std::abs(ex) + std::abs(ey) > 4 * bounds_.seen)) {
      // No vertex lies beyond the foremost one: tries another direction, across.
      if (!support_across(ny, -nx, second)) return false;
      ex = second.qx - first.qx;
      ey = second.qy - first.qy;
    }
    // Towards the side of o.
    const bool left = fl(first.qx * second.qy) >= fl(first.qy * second.qx);
    return support_across(left ? -ey : ey, left ? ex : -ex, third);
  }

  // Takes the first three as a triangle that turns left. False: seen along v, C has no area, and size_ is set
  // accordingly.
  [[gnu::noinline]] bool make_triangle() {
    int s = turn(at(0), at(1), at(2));
    if (s == 0) s = find_triangle();
    if (s < 0) std::swap(order_[1], order_[2]);
    return s != 0;
  }
  [[gnu::noinline]] int find_triangle() {
    // A vertex that is seen apart from the first.
    const Vertex first = slot_[0].id;
    Vertex second = first;
    for (const int i : {line_.x, line_.y}) {
      for (const int sign : {1, -1}) {
        if (second == first) find_beyond(line_.v, unit(i), sign, first, second);
      }
    }
    find_corner(second, slot_[1]);
    size_ = second == first ? 1 : 2;
    if (size_ == 1) return 0;
    const Term edge = Term::difference(first, second);
    for (const int sign : {1, -1}) {
      Vertex third;
      if (!find_beyond(line_.v, edge, sign, first, third)) continue;
      find_corner(third, slot_[2]);
      size_ = 3;
      return turn(slot_[0], slot_[1], slot_[2]);
    }
    return 0;
  }
  bool find_beyond(const Term& f1, const Term& f2, int sign, const Vertex& from, Vertex& out) const {
    return beyond_.find(direction_of(scene_, f1, f2, sign), from, {}, out);
  }

  // ---- flat ----

  static Term unit(int i) { return Term::given(Vec3<double>(Vec3<double>::Unit(i))); }
  // x and, for a point, y: (x x y).v > 0.
  [[nodiscard]] Term axis(std::size_t i) const { return unit(axis_[i]); }
  // A vertex beyond an exact plane through the corner as the next.
  [[gnu::noinline]] bool look_beyond(const Term& f1, const Term& f2, int sign, const Corner& from) {
    ++counters_.supports;
    Vertex w;
    if (!find_beyond(f1, f2, sign, from.id, w)) return false;
    find_corner(w, next());
    return true;
  }
  [[gnu::noinline]] bool find_flat() {
    axis_ = {line_.x, line_.y};
    if (line_.sign < 0) std::swap(axis_[0], axis_[1]);
    const Term& v = line_.v;
    const auto beside = [&](const Term& f) { return scene_.determinant_sign(Term::point(at(0).id), v, f); };
    if (size_ == 1) {
      for (const std::size_t i : {0u, 1u}) {
        // n = v x axis, the same for all of C
        if (const int s = beside(axis(i)); s != 0) return misses(v, axis(i), -s);
      }
      return !outward_ || misses(v, axis(0), 1);  // C is its own border
    }
    const Term e = Term::difference(at(0).id, at(1).id);
    if (const int s = beside(e); s != 0 || outward_) return misses(v, e, s != 0 ? -s : 1);
    // So that side(c, x) rises from the first to the second.
    int along = scene_.determinant_sign(e, axis(0), v);
    if (along == 0) {
      std::swap(axis_[0], axis_[1]);
      along = scene_.determinant_sign(e, axis(0), v);
    }
    if (along < 0) std::swap(order_[0], order_[1]);
    around_ = {at(0).id, at(1).id, at(1).id};
    // Both ends are on one side of o. The segment grows towards o, while there is more of C.
    for (const std::size_t i : {0u, 1u}) {
      const int wanted = i == 0 ? -1 : 1;
      while (side_of_axis(at(i)) != wanted && goes_on()) {
        // It grows along x x v, falls along v x x.
        if (!look_beyond(axis(0), v, wanted, at(i))) return misses(axis(0), v, wanted);
        put_next(i);
      }
    }
    return true;
  }
  // The sign of side(c, x), o moved. Never 0.
  [[nodiscard]] int side_of_axis(const Corner& c) const {
    if (const int s = scene_.determinant_sign(Term::point(c.id), axis(0), line_.v); s != 0) return s;
    const Term middle = Term::inside({around_[0], around_[1], c.id}, c.id);
    if (const int s = scene_.determinant_sign(middle, axis(0), line_.v); s != 0) return -s;
    return -1;  // o moves along the segment, in the direction of rising s
  }

  // ---- 2 ----

  bool walk_around() {
    const int edge = outside_edge();
    return edge < 0 || walk_beyond(edge);
  }
  [[gnu::noinline]] bool walk_beyond(int edge) {
    last_ = false;
    while (edge >= 0 && goes_on()) {
      // The edge first.
      if (edge == 1) order_ = {order_[1], order_[2], order_[0], order_[3]};
      if (edge == 2) order_ = {order_[2], order_[0], order_[1], order_[3]};
      const Corner &c = at(0), &d = at(1);
      Corner& w = next();
      // To the right of c -> d.
      const double ex = d.qx - c.qx, ey = d.qy - c.qy;
      if (!support_across(line_.sign * ey, -line_.sign * ex, w)) return false;
      if (!(turn(c, d, w) < 0)) {
        // The rounded direction does not show a vertex beyond. The exact direction decides.
        const Direction n = direction_of(scene_, Term::difference(c.id, d.id), line_.v, 1);
        Vertex id;
        if (!beyond_.find(n, c.id, std::array{d.id}, id)) {
          return misses(Term::difference(c.id, d.id), line_.v, 1);
        }
        find_corner(id, w);
      }
      // The triangle beyond the edge turns left as c, w, d. o is left of d -> c.
      order_ = {order_[0], order_[3], order_[1], order_[2]};
      edge = side(at(0), at(1)) < 0 ? 0 : side(at(1), at(2)) < 0 ? 1 : -1;
    }
    return true;
  }
  // The first edge that has o on its right, or -1.
  [[nodiscard]] int outside_edge() const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (side(at(i), at((i + 1) % 3)) < 0) return static_cast<int>(i);
    }
    return -1;
  }

  // ---- 3 ----

  [[nodiscard]] static Triple edge(const Corner& from, const Corner& to) { return steps(from, to).edge(); }
  [[nodiscard]] static Steps steps(const Corner& from, const Corner& to) {
    return {to.a - from.a, to.b - from.b};
  }
  // A vertex strictly beyond the portal's plane as the next, or a proof that there is no such vertex.
  bool above_portal() {
    if (size_ < 3) {
      const Facet plane = facet();
      return look_beyond(plane.f1, plane.f2, toward_, at(0));
    }
    const Corner &c0 = at(0), &c1 = at(1), &c2 = at(2);
    const Triple e = edge(c0, c1), f = edge(c0, c2);
    const Triple n = double(toward_) * cross(e, f);
    Corner& w = next();
    if (last_) {
      last_ = false;
      return surely_above(n, e, f, w);
    }
    return look_above(n, e, f, w);
  }
  [[gnu::noinline]] bool look_above(const Triple& n, const Triple& e, const Triple& f, Corner& w) {
    const Corner& c0 = at(0);
    const double e_1 = sum(magnitude(e)), f_1 = sum(magnitude(f));
    support(n, w);
    if (!is_corner(w.id)) {
      const Triple g = edge(c0, w);
      const double g_1 = sum(magnitude(g));
      const double area = fl(e_1 * f_1) + fl((e_1 + f_1) * g_1);
      const double error = fl(1.1 * bounds_.edge * area) + kUnderflow;
      if (dot(n, g) > error) return true;
    }
    return surely_above(n, e, f, w);
  }
  // The normal in the axes of the one body whose vertices alone make the portal's edges, or of both, if their
  // rotations are equal. Only for leaves: their vertices are known without rounding in their own axes.
  void find_own_normal(Direction& out) const {
    if (!scene_.is_of_two_leaves()) return;
    const Vertex &v0 = at(0).id, &v1 = at(1).id, &v2 = at(2).id;
    // All conditions are evaluated: one branch that cannot be predicted is enough.
    const bool alike = scene_.turned_alike(), of_a = ((v0.b ^ v1.b) | (v0.b ^ v2.b)) == 0,
               of_b = ((v0.a ^ v1.a) | (v0.a ^ v2.a)) == 0;
    if (!(unsigned(alike) | unsigned(of_a) | unsigned(of_b))) return;
    out.of_body = {alike || of_a, alike || of_b};
    Steps e{{0, 0, 0}, {0, 0, 0}}, f = e;
    if (alike) {
      e = {pair_.a().own(v1.a) - pair_.a().own(v0.a), pair_.b().own(v1.b) - pair_.b().own(v0.b)};
      f = {pair_.a().own(v2.a) - pair_.a().own(v0.a), pair_.b().own(v2.b) - pair_.b().own(v0.b)};
    } else {
      // As steps of A, whichever body it is: two negated steps have the same product.
      const PreparedCore<S>& body = of_b ? pair_.b() : pair_.a();
      const Triple first = body.own(of_b ? v0.b : v0.a);
      e.a = body.own(of_b ? v1.b : v1.a) - first;
      f.a = body.own(of_b ? v2.b : v2.a) - first;
    }
    out.own = (double(toward_) * cross(e.edge(), f.edge())).vector();
    out.own_error = normal_error(e, f);
  }
  // The same, decided for the exact plane. n = +-(e x f), the edges from the portal's first corner.
  bool surely_above(const Triple& n, const Triple& e, const Triple& f, Corner& w) {
    const Corner &c0 = at(0), &c1 = at(1), &c2 = at(2);
    const double e_1 = sum(magnitude(e)), f_1 = sum(magnitude(f));
    Direction direction{Term::difference(c0.id, c1.id), Term::difference(c0.id, c2.id), toward_, n.vector()};
    if (turned_) {
      direction.error.setConstant(1.2 * bounds_.edge * (e_1 + f_1));
      find_own_normal(direction);
    } else {
      direction.error = normal_error(steps(c0, c1), steps(c0, c2));
    }
    Vertex id;
    if (!beyond_.find(direction, c0.id, std::array{c1.id, c2.id}, id)) return false;
    find_corner(id, w);
    return true;
  }
  [[nodiscard]] bool is_corner(const Vertex& id) const {
    return id == at(0).id || id == at(1).id || id == at(2).id;
  }
  // The next vertex replaces the corner whose opposite edge makes with it the triangle that holds o.
  [[gnu::noinline]] void replace() {
    const Corner& w = next();
    previous_ = {at(0).id, at(1).id, at(2).id};
    newest_ = w.id;
    if (size_ < 3) return put_next(size_ == 2 && side_of_axis(w) > 0 ? 1 : 0);
    int s[3];
    for (std::size_t i = 0; i < 3; ++i) {
      s[i] = side(at(i), w);
      if (s[i] == 0) return put_next(i);  // seen at one point, w before it
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (s[i] < 0 && s[(i + 1) % 3] > 0) return put_next((i + 2) % 3);
    }
    scene_.invalidate();  // only numbers beyond their range get here
  }

  const Scene<S>& scene_;
  const PreparedPair<S>& pair_;
  const Line& line_;
  Bounds bounds_;
  BeyondSearch<S> beyond_;
  Counters& counters_;
  std::array<Corner, 4> slot_;
  std::array<std::uint8_t, 4> order_ = {0, 1, 2, 3};
  std::array<Vertex, 3> around_, previous_;
  double around_x_ = 0, around_y_ = 0;  // their sum
  Vertex newest_;
  bool outward_ = false, turned_ = false;
  bool last_ = false;  // the portal came as the last one of another walk
  int toward_ = -1, size_ = 3;
  std::array<int, 2> axis_{};
  Miss miss_;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
