// Decides exactly: nothing.
// Brackets only: support values and points, to the working precision, and bounds of derivatives, from above.
// Costs: a pose 5 microseconds at 128 bits, a support of a placed box 5 more.
// Cannot be trusted: it can.
//
// Bounds, n fixed in the world. A followed point is x(t) = c + t v + R(t) r + (terms without derivatives
// except those of t v), with r fixed. Then (n.x)'' = n . (w x (w x R r)), and w x (w x R r) = -|w|^2 times
// the part of R r across w, whose length is r's distance d from the axis of rotation. So
//   |(n.(x - t v))'| <= |n x w| d,   |(n.x)''| <= |w| |n x w| d.
//
// A shape of revolution, with a its unit axis and o its centre from the pivot, in world axes of t = 0.
// Turning the shape about a by any angle first moves no point out of it. So x(t) = c + t v + R(t) (o + Q(t)
// y), Q(t) the turn about a by -(w.a) t, covers the same set. u(t) = R(t) Q(t) y turns with the angular
// velocity
//   e(t) = w - (w.a) R(t) a,   |e| = |w x a|,   |e'| = |w.a| |w x a|
// (w fixed, R a rotation about w), and u'' = e' x u + e x (e x u). With s = w.a, e = |w x a|, and u = (u1,
// u2, u3) along e/|e|, R a and their cross product, that is e (s u2, -s u1 - e u2, -e u3). This is e times a
// symmetric matrix of u, up to signs, whose greatest eigenvalue is k = (e + sqrt(e^2 + 4 s^2))/2 >= e. Hence
//   |(n.(x - t v))'| <= |n x w| d_o + |n| e |y|,
//   |(n.x)''| <= |w| |n x w| d_o + |n| e k |y|,
// d_o the distance of o from the axis of rotation. The lesser of the two bounds holds.
//
// An axis that turns with X. With m = R_X n, D = c_Y + t v_Y - c_X - t v_X, d = w_Y - w_X and u = R_Y r, the
// point is R_X^-1 (u + D) in X's axes. Differentiating R_X^-1 gives -R_X^-1 w_X x:
//   f'' = m . (d x (w_Y x u) - w_X x (d x u) - 2 w_X x (v_Y - v_X) + w_X x (w_X x D)).
// |m . (w_X x z)| <= |n x w_X| |z|, as |m x w_X| does not change; |d x u| <= |d| |u|, |w_Y x u| = |w_Y| d_u,
// and |w_X x D| is convex in t, so it is largest at an end.
#include "oracles/curved/ball_motion.hpp"

#include <stdexcept>

#include "oracles/checker/tree_point.hpp"

namespace graze::oracle {
namespace {

BallVec exact_difference(const Vec3<double>& l, const Vec3<double>& r) {
  const WorkingPrecision exact(ARF_PREC_EXACT);
  return BallVec(l) - BallVec(r);
}

const Vec3<double>& checked(const Vec3<double>& x, const char* what) {
  if (!(x.cwiseAbs().maxCoeff() < kInfinity<double> && x == x)) {
    throw std::invalid_argument(std::string(what) + ": not a finite number");
  }
  return x;
}

// center + ball(radius) + the sum of the ellipsoids {M x : |x| <= 1}, M by columns at right angles, some of
// which may be 0. The points that are followed lie in the hull of some of these.
struct Blob {
  BallVec center;
  Ball radius;
  std::vector<std::array<BallVec, 3>> ellipsoids;
};

constexpr std::size_t kMostBlobs = 4096;

// The greatest |M x|, |x| <= 1, for M of rank 2: the root of the greater root of l^2 - tr(G) l + e, with G =
// M^T M and e the sum of its principal minors, as det G = 0.
Ball stretch_across(const std::array<BallVec, 3>& m) {
  std::array<std::array<Ball, 3>, 3> g;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) g[i][j] = dot(m[i], m[j]);
  }
  const Ball trace = g[0][0] + g[1][1] + g[2][2];
  const Ball minors = (g[0][0] * g[1][1] - g[0][1] * g[0][1]) + (g[1][1] * g[2][2] - g[1][2] * g[1][2]) +
                      (g[0][0] * g[2][2] - g[0][2] * g[0][2]);
  return sqrt(Ball(0.5) * (trace + sqrt(not_below_zero(trace * trace - Ball(4) * minors))));
}

// The greatest |c + M x| over |x| <= 1, from above, by the greatest |M x|:
//   |c + M x|^2 <= |c|^2 + 2 |M^T c| + stretch^2, never more than (|c| + stretch)^2.
Ball farthest(const BallVec& c, const std::array<BallVec, 3>& m, const Ball& stretch) {
  const BallVec along{dot(m[0], c), dot(m[1], c), dot(m[2], c)};
  return sqrt(dot(c, c) + Ball(2) * norm(along) + stretch * stretch);
}

// A shape's core as blobs, and the radius of the ball that is left out of it: the shape lies in the core and
// that ball about its points. For each kind of shape, only this code decides which part belongs to the core
// and which to the ball.
struct Blobs {
  std::vector<Blob> list;
  Ball ball;

  static Blobs of(const Shape<double>& shape) {
    Blobs all;
    std::visit([&](const auto& s) { all.add(s); }, shape);
    return all;
  }

  void vertex(const BallVec& x) { list.push_back({x, 0, {}}); }
  void disk(double height, double radius) {
    vertex({0, 0, height});
    list.back().ellipsoids.push_back({BallVec{radius, 0, 0}, BallVec{0, radius, 0}, BallVec{}});
  }

  void add(const Point<double>&) { vertex({}); }
  void add(const Sphere<double>& s) {
    vertex({});
    ball = s.radius;
  }
  void add(const Segment<double>& s) {
    for (const Vec3<double>& x : {s.a, s.b}) vertex(BallVec(x));
  }
  void add(const Triangle<double>& s) {
    for (const Vec3<double>& x : {s.a, s.b, s.c}) vertex(BallVec(x));
  }
  void add(const Capsule<double>& s) {
    for (const double z : {-s.half_height, s.half_height}) vertex({0, 0, z});
    ball = s.radius;
  }
  void add(const Box<double>& s) {
    const Vec3<double>& e = s.half_extents;
    for (unsigned k = 0; k < 8; ++k) {
      vertex({k & 1u ? e[0] : -e[0], k & 2u ? e[1] : -e[1], k & 4u ? e[2] : -e[2]});
    }
  }
  void add(const Hull<double>& s) {
    for (const Vec3<double>& x : s.vertices()) vertex(BallVec(x));
  }
  void add(const Ellipsoid<double>& s) {
    const Vec3<double>& r = s.radii;
    vertex({});
    if (r[0] == r[1] && r[1] == r[2]) {
      ball = r[0];
      return;
    }
    list.back().ellipsoids.push_back({BallVec{r[0], 0, 0}, BallVec{0, r[1], 0}, BallVec{0, 0, r[2]}});
  }
  void add(const Cylinder<double>& s) {
    disk(-s.half_height, s.radius);
    disk(s.half_height, s.radius);
  }
  void add(const Cone<double>& s) {
    vertex({0, 0, s.half_height});
    disk(-s.half_height, s.radius);
  }
  void add(const Posed<double>& s) {
    *this = of(s.shape->shape);
    turn(BallRotation(s.orientation));
    move(BallVec(s.position));
  }
  void add(const Rounded<double>& s) {
    *this = of(s.shape->shape);
    ball += s.radius;
  }
  void add(const HullOf<double>& s) {
    for (const SharedShape<double>& part : s.shapes) {
      Blobs more = of(part->shape);
      ball = max(ball, more.ball);
      for (Blob& blob : more.list) list.push_back(std::move(blob));
    }
  }
  void add(const Sum<double>& s) {
    vertex({});
    for (const SharedShape<double>& part : s.shapes) {
      Blobs more = of(part->shape);
      ball += more.ball;
      if (list.size() * more.list.size() > kMostBlobs) {
        coarsen();
        more.coarsen();
      }
      std::vector<Blob> sums;
      for (const Blob& l : list) {
        for (const Blob& r : more.list) {
          Blob blob{l.center + r.center, l.radius + r.radius, l.ellipsoids};
          blob.ellipsoids.insert(blob.ellipsoids.end(), r.ellipsoids.begin(), r.ellipsoids.end());
          sums.push_back(std::move(blob));
        }
      }
      list = std::move(sums);
    }
  }

  // One ball around all.
  void coarsen() {
    const BallVec center = list[0].center;
    move(-center);
    const Ball radius = reach();
    list = {{center, radius, {}}};
  }
  void turn(const BallRotation& rotation) {
    for (Blob& blob : list) {
      blob.center = rotation.apply(blob.center);
      for (auto& m : blob.ellipsoids) {
        for (BallVec& column : m) column = rotation.apply(column);
      }
    }
  }
  void move(const BallVec& by) {
    for (Blob& blob : list) blob.center = blob.center + by;
  }

  // The greatest n.x of the core.
  [[nodiscard]] Ball height(const BallVec& n) const {
    std::optional<Ball> most;
    for (const Blob& blob : list) {
      Ball height = dot(n, blob.center) + blob.radius;
      for (const auto& m : blob.ellipsoids) height += norm(BallVec{dot(m[0], n), dot(m[1], n), dot(m[2], n)});
      most = most ? max(*most, height).high() : height.high();
    }
    return *most;
  }
  // The middle of the core's bounds along the axes, or the origin if the middle is not finite in double.
  [[nodiscard]] Vec3<double> middle() const {
    Vec3<double> low = Vec3<double>::Constant(kInfinity<double>), high = -low;
    for (const Blob& blob : list) {
      const Vec3<double> center = blob.center.mid_double();
      Vec3<double> reach = Vec3<double>::Constant(blob.radius.mid_double());
      for (const auto& m : blob.ellipsoids) {
        Vec3<double> squares = Vec3<double>::Zero();
        for (const BallVec& column : m) squares += column.mid_double().cwiseAbs2();
        reach += squares.cwiseSqrt();
      }
      low = low.cwiseMin(center - reach);
      high = high.cwiseMax(center + reach);
    }
    const Vec3<double> x = low / 2 + high / 2;
    return x.allFinite() ? x : Vec3<double>(Vec3<double>::Zero());
  }
  // The largest distance of all points from the origin. Columns at right angles stretch by the longest.
  [[nodiscard]] Ball reach() const {
    return reach([](const BallVec& x) { return x; },
                 [](const auto& m) { return max(max(norm(m[0]), norm(m[1])), norm(m[2])); });
  }
  // The largest distance of all points from the line through the origin along w, w != 0.
  [[nodiscard]] Ball reach_across(const BallVec& w) const {
    const Ball over_rate = Ball(1) / norm(w);
    return reach([&](const BallVec& x) { return over_rate * cross(w, x); }, stretch_across);
  }

 private:
  // The same after `map`, a linear map that lengthens nothing. `stretch` gives the stretch of an ellipsoid's
  // mapped columns.
  template <class Map, class Stretch>
  [[nodiscard]] Ball reach(const Map& map, const Stretch& stretch) const {
    Ball most;
    for (const Blob& blob : list) {
      const BallVec center = map(blob.center);
      Ball reach = blob.radius;
      if (blob.ellipsoids.empty()) reach += norm(center);
      for (std::size_t i = 0; i < blob.ellipsoids.size(); ++i) {
        const auto& m = blob.ellipsoids[i];
        const std::array<BallVec, 3> mapped = {map(m[0]), map(m[1]), map(m[2])};
        reach += i == 0 ? farthest(center, mapped, stretch(mapped)) : stretch(mapped);
      }
      most = max(most, reach).high();
    }
    return most;
  }
};

// The axis of a shape of revolution through its centre, in the frame that its poses place it in.
struct Revolution {
  BallVec center, axis;  // axis: of length 1
  Ball around;           // from the centre
  std::vector<RevolvedPart> parts;
};

std::optional<Revolution> revolution(const Shape<double>& shape) {
  const auto along = [](int axis, const Ball& around, std::vector<RevolvedPart> parts) {
    Vec3<double> a = Vec3<double>::Zero();
    a[axis] = 1;
    return Revolution{{}, BallVec(a), around, std::move(parts)};
  };
  if (const auto* s = std::get_if<Cylinder<double>>(&shape)) {
    return along(2, sqrt(Ball(s->radius) * s->radius + Ball(s->half_height) * s->half_height),
                 {{s->half_height, s->radius, 0}, {-s->half_height, s->radius, 0}});
  }
  if (const auto* s = std::get_if<Cone<double>>(&shape)) {
    return along(2, sqrt(Ball(s->radius) * s->radius + Ball(s->half_height) * s->half_height),
                 {{s->half_height, 0, 0}, {-s->half_height, s->radius, 0}});
  }
  if (const auto* s = std::get_if<Ellipsoid<double>>(&shape)) {
    for (int axis = 0; axis < 3; ++axis) {
      const double across = s->radii[(axis + 1) % 3];
      if (across == s->radii[(axis + 2) % 3])
        return along(axis, s->radii.maxCoeff(), {{0, across, s->radii[axis]}});
    }
    return {};
  }
  if (const auto* s = std::get_if<Rounded<double>>(&shape)) return revolution(s->shape->shape);
  if (const auto* s = std::get_if<Posed<double>>(&shape)) {
    std::optional<Revolution> inner = revolution(s->shape->shape);
    if (!inner) return {};
    const BallRotation turn(s->orientation);
    return Revolution{turn.apply(inner->center) + BallVec(s->position), turn.apply(inner->axis),
                      inner->around, inner->parts};
  }
  return {};
}

}  // namespace

// The tree that features are read from.
struct BallMotion::Naming {
  Body<double> body;  // the tree points into it
  Door door;
  PartTree tree;
  explicit Naming(const Body<double>& given) : body(given), tree(body, door) {}
};

BallMotion::BallMotion(const Body<double>& body, const corpus::Spin& spin, const Vec3<double>& reference)
    : body_(body),
      naming_(std::make_unique<Naming>(body)),
      spin_{checked(spin.rotation, "rotation"), Vec3<double>::Zero()},
      velocity_(body_.displacement()),
      rotation_(spin_.rotation),
      rate_(norm(rotation_)) {
  const BallRotation orientation(body.orientation);
  orientation_ = orientation.mid_double();
  Blobs blobs = Blobs::of(body.shape);
  spin_.pivot = checked(spin.pivot, "pivot");
  if (!turns()) spin_.pivot = blobs.middle();
  arm_ = orientation.apply(BallVec(spin_.pivot));
  pivot_ = exact_difference(body.position, checked(reference, "reference")) + arm_;
  magnitude_ = body_.magnitude() + 2 * spin_.pivot.cwiseAbs().maxCoeff();

  ball_ = blobs.ball.high();
  blobs.turn(orientation);
  blobs.move(-arm_);
  pivot_reach_ = blobs.reach();
  if (!turns()) return;
  axis_reach_ = blobs.reach_across(rotation_);
  const BallVec along = (Ball(1) / rate_) * rotation_;
  axis_high_ = blobs.height(along);
  axis_low_ = -blobs.height(-along);
  middle_ = blobs.middle();
  Blobs amid = blobs;
  amid.move(-BallVec(middle_));
  middle_reach_ = amid.reach();
  if (const auto own = revolution(body.shape)) {
    const BallVec axis = orientation.apply(own->axis);
    const BallVec center = orientation.apply(own->center) - arm_;
    own_ = {true,
            abs(dot(rotation_, axis)),
            norm(cross(rotation_, axis)),
            norm(cross(rotation_, center)) / rate_,
            own->around,
            axis,
            dot(center, axis),
            norm(cross(center, axis)),
            own->parts};
  }
}

BallMotion::~BallMotion() = default;
BallMotion::BallMotion(BallMotion&&) noexcept = default;
BallMotion& BallMotion::operator=(BallMotion&&) noexcept = default;

BallMotion::Pose BallMotion::at(const Ball& t) const {
  Pose pose;
  pose.body_ = this;
  if (turns()) pose.rotation_ = BallRotation(t * rotation_);
  pose.pivot_ = pivot_ + t * velocity_;
  return pose;
}

BallSupport BallMotion::Pose::support(const BallVec& n) const {
  const BallVec m = turn_back(n);
  BallSupport s = body_->body_.support(m);
  s.reach += dot(n, pivot_) - dot(m, body_->arm_);
  s.point = turn(s.point - body_->arm_) + pivot_;
  return s;
}

std::uint64_t BallMotion::vertex_count() const { return naming_->tree.vertex_count(); }

NamedPoint BallMotion::named(const Feature& feature) const {
  if (!naming_->door.well_formed()) throw std::invalid_argument(naming_->door.entry().reason);
  if (feature.vertex >= vertex_count()) throw std::invalid_argument("a vertex that the shape does not have");
  const Way way(naming_->tree, feature);
  NamedPoint point;
  point.curved_parts = way.curved_count();
  for (const double radius : way.radii()) point.radius += radius;
  if (way.curved_count() > kCurvedParts) return point;
  for (std::size_t k = 0; k < way.curved_count(); ++k) {
    point.inside = both(point.inside, inside_curved<Ball>(way.curved(k), feature.curved[k]));
  }
  const Way::Place<Ball> place = way.place<Ball>();
  const Ball over_weight = Ball(1) / place.weight;
  point.from_pivot = over_weight * BallVec{place.at.x, place.at.y, place.at.z} - arm_;
  return point;
}

Ball BallMotion::first_bound(const BallVec& n) const {
  if (!turns()) return 0;
  const Ball across = norm(cross(n, rotation_));
  const Ball followed = across * axis_reach_;
  if (!own_.exists) return followed;
  return min(followed, across * own_.center + norm(n) * own_.tilt * own_.around);
}

Ball BallMotion::second_bound(const BallVec& n) const {
  if (!turns()) return 0;
  const Ball across = rate_ * norm(cross(n, rotation_));
  const Ball followed = across * axis_reach_;
  if (!own_.exists) return followed;
  const Ball most = Ball(0.5) * (own_.tilt + sqrt(own_.tilt * own_.tilt + Ball(4) * own_.spin * own_.spin));
  const Ball tilting = own_.tilt * most * own_.around;
  return min(followed, across * own_.center + norm(n) * tilting);
}

// c = n.a is between its chord's ends, give or take |n x w| |w x a| (end - begin)^2 / 8, and between those of a
// whole turn. A part that is wider than long is concave in c. It has its greatest value, of all c, where it has a
// slope of 0.
std::optional<Ball> BallMotion::own_reach(const BallVec& n, double begin, double end) const {
  if (!own_.exists) return {};
  const Ball h = Ball(end) - Ball(begin), turning = norm(cross(n, rotation_)) * own_.tilt,
             bulge = Ball(0.125) * turning * h * h, rate_sq = rate_ * rate_;
  const Ball first = dot(n, at(begin).turn(own_.axis)), last = dot(n, at(end).turn(own_.axis)),
             middle = dot(n, rotation_) * dot(own_.axis, rotation_) / rate_sq, half = turning / rate_sq;
  const Ball least = max(min(first, last) - bulge, middle - half).low(),
             most = min(max(first, last) + bulge, middle + half).high(), square = dot(n, n);
  std::optional<Ball> reach;
  for (const RevolvedPart& part : own_.parts) {
    const Ball z = Ball(part.height) + own_.along, r_sq = Ball(part.radius) * part.radius,
               l_sq = Ball(part.length) * part.length, k = r_sq - l_sq;
    const auto value = [&](const Ball& c) {
      return z * c + sqrt(max(r_sq * (square - c * c), Ball(0)) + l_sq * (c * c));
    };
    Ball greatest = max(value(least), value(most));
    if (part.radius > part.length) {
      const Ball vertex = z * Ball(part.radius) * norm(n) / sqrt(k * (k + z * z));
      if (!certainly_less(vertex, least) && !certainly_less(most, vertex))
        greatest = max(greatest, Ball(part.radius) * norm(n) * sqrt(Ball(1) + z * z / k));
    }
    reach = reach ? max(*reach, greatest) : greatest;
  }
  return *reach + own_.across * norm(n);
}

std::optional<CommonTurn> CommonTurn::of(const BallMotion& a, const BallMotion& b) {
  if (!a.turns() || a.spin().rotation != b.spin().rotation) return {};
  const BallVec& w = a.rotation();
  const Ball rate = norm(w), arms = norm(cross(w, BallVec(b.middle()) - BallVec(a.middle()))) / rate;
  return CommonTurn{w, rate, arms + a.middle_reach() + b.middle_reach()};
}

Ball second_bound_turning(const BallMotion& x, const BallMotion& y, const BallVec& n, const Ball& begin,
                          const Ball& end) {
  const BallVec &w = x.rotation(), relative = y.rotation() - x.rotation();
  const Ball across = norm(cross(n, w)), rate = norm(relative);
  const BallVec between = y.pivot() - x.pivot(), velocity = y.velocity() - x.velocity();
  const Ball swing =
      max(norm(cross(w, between + begin * velocity)), norm(cross(w, between + end * velocity)));
  return norm(n) * rate * norm(y.rotation()) * y.axis_reach() +
         across * (rate * y.pivot_reach() + Ball(2) * norm(velocity) + swing);
}

bool chord_stays_positive(const Ball& s0, const Ball& s1, const Ball& bound, const Ball& d) {
  if (!s0.is_positive() || !s1.is_positive()) return false;
  return certainly_less(d * sqrt(Ball(0.5) * bound), sqrt(s0) + sqrt(s1));
}

bool slopes_stay_positive(const Ball& s0, const Ball& s1, const Ball& f, const Ball& r, const Ball& d) {
  if (!s0.is_positive() || !s1.is_positive()) return false;
  if (certainly_at_most(f, Ball(0)) || certainly_at_most(r, Ball(0))) return true;
  const Ball falls = f.high(), rises = r.high();
  return certainly_less(d * falls * rises, s0 * rises + s1 * falls);
}

Ball chord_minimum(const Ball& s0, const Ball& s1, const Ball& bound, const Ball& d) {
  const Ball curvature = bound * d * d, rise = s1 - s0;
  if (certainly_at_most(curvature, Ball(2) * abs(rise))) return min(s0, s1).low();
  return (Ball(0.5) * (s0 + s1) - Ball(0.125) * curvature - rise * rise / (Ball(2) * curvature)).low();
}

}  // namespace graze::oracle
