// Decides exactly whether two bodies are in contact at t = 0. Used for bodies at rest whose start is too close for
// rounded arithmetic.
//
// Spheres, capsules, polytopes and their roundings, and an ellipsoid with a polytope are always decided, by the
// nearest point of the difference of their cores (exact_nearest.hpp). The ellipsoid is a ball after it is scaled.
// Cylinders, cones, and every other body with one curved leaf are decided by candidates.
//
//   contact   a point of one core whose distance from the other is at most R. It is rational if bodies stand, lie or
//             roll on a plane, and otherwise a point within 2^-250 of the deepest one.
//   apart     a direction n with h(n) + R |n| < 0: the normal of a face, an axis of a leaf, an edge times an axis, or
//             the vector between a vertex and the leaf's point nearest to it.
//
// Each candidate is verified in exact arithmetic, so a wrong one costs time and never an answer. If no candidate
// decides, the start remains undecided. Notation: exact_body.hpp.
#pragma once

#include <graze/detail/numeric/sine_cosine.hpp>
#include <graze/detail/search/exact/exact_body.hpp>
#include <graze/detail/search/robust/gjk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
class StartDecision {
  using Dyadic = exact::Dyadic;
  using Dyadic3 = exact::Dyadic3;
  using Exact = exact::Exact;
  using Kind = typename ExactLeaf<S>::Kind;

 public:
  // cso: of the same bodies and target distance.
  StartDecision(const Body<S>& a, const Body<S>& b, const Cso<double>& cso, double target_distance,
                int budget, Counters& counters)
      : cso_(cso),
        counters_(counters),
        budget_(budget),
        a_(a, cso.side_a(), rounding(cso)),
        b_(b, cso.side_b(), rounding(cso)),
        radius_(a_.ball() + b_.ball() + Dyadic(target_distance)) {}

  [[nodiscard]] ExactStart operator()() {
    if (!a_.valid() || !b_.valid()) return {};
    ++counters_.exact_decisions;
    ExactStart out;
    if (a_.is_polytope() && b_.is_polytope()) {
      out = of_polytopes();
    } else if (!find_direction()) {
      return {};
    } else if (a_.is_polytope() || b_.is_polytope()) {
      of_a_ = a_.is_polytope();
      const bool scaled = leaf().is_full_ellipsoid() && radius_.sign() == 0;
      scaled ? with_ellipsoid() : with_leaf();
      out = found_;
    } else {
      of_leaves();
      out = found_;
    }
    return valid_ ? out : ExactStart{};
  }

 private:
  // Rounding of two heights along a direction that is itself rounded: more than twice the CSO's bound for one.
  static double rounding(const Cso<double>& cso) { return 4 * (cso.reach_error() + 0x1p-46 * cso.extent()); }

  // ---- both cores are polytopes ----

  struct Differences {
    const StartDecision& own;
    struct Id {
      std::uint32_t a = 0, b = 0;
    };
    [[nodiscard]] Exact at(const Id& id) const {
      Exact c = own.a_.vertex(id.a);
      c.add(own.b_.vertex(id.b), true);
      return c;
    }
    [[nodiscard]] std::optional<Id> lowest(const Dyadic3& p) const {
      bool valid = true;
      const Id out{own.a_.farthest(minus(p), valid), own.b_.farthest(p, valid)};
      return valid ? std::optional<Id>(out) : std::nullopt;
    }
  };
  [[nodiscard]] ExactStart of_polytopes() {
    Simplex<double> simplex;
    gjk_distance(cso_, Vec3<double>(Vec3<double>::Zero()), simplex, 0.0, 0.0, budget_, counters_);
    std::vector<typename Differences::Id> first;
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::min(simplex.size, 3)); ++i)
      first.push_back({simplex.point[i].vertex_a, simplex.point[i].vertex_b});
    const Differences points{*this};
    return ExactNearest<Differences>(points, radius_)(std::span<const typename Differences::Id>(first));
  }

  // ---- a polytope and an ellipsoid without a ball: scaled, so that it is one ----

  // x in the ellipsoid's axes, x_i times r_j r_k: the ellipsoid is the ball of r_1 r_2 r_3.
  struct Scaled {
    const StartDecision& own;
    using Id = std::uint32_t;
    [[nodiscard]] Dyadic3 scale() const {
      const Vec3<double>& r = own.leaf().radii();
      return {Dyadic(r[1]) * Dyadic(r[2]), Dyadic(r[2]) * Dyadic(r[0]), Dyadic(r[0]) * Dyadic(r[1])};
    }
    [[nodiscard]] Dyadic3 world(const Dyadic3& p) const {
      const Dyadic3 s = scale();
      return own.leaf().turn_to_world({s[0] * p[0], s[1] * p[1], s[2] * p[2]});
    }
    [[nodiscard]] Exact at(Id k) const {
      Exact x = own.leaf().to_own(own.polytope().vertex(k));
      const Dyadic3 s = scale();
      for (std::size_t i = 0; i < 3; ++i) x.x[i] = s[i] * x.x[i];
      return x;
    }
    [[nodiscard]] std::optional<Id> lowest(const Dyadic3& p) const {
      bool valid = true;
      const Id out = own.polytope().farthest(minus(world(p)), valid);
      return valid ? std::optional<Id>(out) : std::nullopt;
    }
  };
  void with_ellipsoid() {
    const Vec3<double>& r = leaf().radii();
    const Scaled points{*this};
    const std::uint32_t first[] = {polytope().farthest(towards_, 0).front()};
    found_ = ExactNearest<Scaled>(points, Dyadic(r[0]) * Dyadic(r[1]) * Dyadic(r[2]))(first);
    // -p leads from the polytope to the ellipsoid.
    if (found_.kind == StartKind::apart || found_.kind == StartKind::touching) {
      const Dyadic3 n = points.world(found_.n);
      found_.n = of_a_ ? n : minus(n);
    }
  }

  // ---- a polytope and a leaf ----

  [[nodiscard]] const ExactBody<S>& polytope() const { return of_a_ ? a_ : b_; }
  [[nodiscard]] const ExactLeaf<S>& leaf() const { return of_a_ ? b_.leaf() : a_.leaf(); }
  // A contact still needs the check whether it is touching.
  [[nodiscard]] bool done() const {
    return !valid_ || (found_.kind != StartKind::open && found_.kind != StartKind::contact);
  }

  // The direction from A to B at their nearest points. In contact it is noise, so A is moved off a little.
  [[nodiscard]] bool find_direction() {
    const auto seen_from = [&](const Vec3<double>& x) {
      Simplex<double> simplex;
      return gjk_distance(cso_, x, simplex, 0.0, 0.0, budget_, counters_);
    };
    const Vec3<double> outward = cso_.middle() == Vec3<double>::Zero() ? Vec3<double>(Vec3<double>::UnitZ())
                                                                       : Vec3<double>(-unit(cso_.middle()));
    const Vec3<double> first = seen_from(Vec3<double>::Zero()).n;
    double best = 0;
    for (const Vec3<double>& n : {first, outward}) {
      if (n == Vec3<double>::Zero()) continue;
      const Distance<double> d = seen_from(kAway * n);
      if (!(d.lower > best)) continue;
      best = d.lower;
      direction_ = d.n;
    }
    if (best > 0) {
      const Distance<double> d = seen_from(kAway * direction_);
      if (d.lower > best) direction_ = d.n;
    }
    towards_ = direction_;
    return best > 0;
  }
  // t: from the polytope (or from A of two leaves) to the leaf. The sign of h(n) + R |n|.
  int try_normal(const Dyadic3& t) {
    const Dyadic3 n = of_a_ ? t : minus(t);
    bool valid = true;
    const int sign = sign_of_reach(a_, b_, n, radius_, valid);
    if (!valid) return 1;
    normal_ = n;
    if (sign < 0) found_ = {StartKind::apart, n, false};
    if (sign == 0) {
      border_ = n;
      if (found_.kind == StartKind::contact) found_ = {StartKind::touching, n, found_.only_normal};
    }
    return sign;
  }
  static bool is_zero(const Dyadic3& x) { return x[0].sign() == 0 && x[1].sign() == 0 && x[2].sign() == 0; }
  // In contact. `t`: if it is known, the one direction that can be a normal from the polytope to the leaf.
  void found_contact(const std::optional<Dyadic3>& t) {
    found_ = {StartKind::contact, {}, false};
    if (t) {
      const int sign = try_normal(*t);
      if (sign > 0) found_ = {StartKind::deep, {}, false};
      if (sign == 0) found_.only_normal = true;
    } else if (border_) {
      found_ = {StartKind::touching, *border_, false};
    }
  }
  // A point of the polytope (or of the other leaf), in the leaf's own frame.
  void try_point(const Exact& own) {
    if (done()) return;
    bool smooth = false, valid = true;
    const int side = leaf().side_of(own, smooth, valid);
    if (!valid) return;
    if (side < 0 || (side == 0 && radius_.sign() > 0)) {
      found_ = {StartKind::deep, {}, false};
    } else if (side == 0 && found_.kind == StartKind::open) {
      found_contact(smooth ? std::optional(leaf().turn_to_world(minus(leaf().normal_at(own))))
                           : std::nullopt);
    } else if (radius_.sign() > 0) {
      const Dyadic3 t = of_a_ ? normal_ : minus(normal_);
      try_distance(own, leaf().kind() == Kind::ellipsoid ? leaf().along(leaf().turn_to_own(minus(t)).x, 0)
                                                         : leaf().nearest(own));
    }
  }
  // Two points, one of each core.
  void try_distance(const Exact& own, const Exact& of_leaf) {
    Exact between = of_leaf;
    between.add(own, true);
    const Dyadic reach = radius_ * between.weight, rest = exact::dot(between.x, between.x) - reach * reach;
    if (!rest.valid() || rest.sign() > 0) return;
    if (rest.sign() < 0) {
      found_ = {StartKind::deep, {}, false};
    } else if (found_.kind == StartKind::open) {
      found_contact(leaf().turn_to_world(between.x));
    }
  }
  // A vertex, or an edge's point nearest to the axis, and the vector between it and the leaf.
  void try_point_and_normal(const Exact& own) {
    if (done()) return;
    Dyadic3 t;
    if (leaf().kind() == Kind::ellipsoid) {
      if (leaf().is_full_ellipsoid()) t = minus(leaf().normal_at(own));
    } else {
      Exact between = leaf().nearest(own);
      between.add(own, true);
      t = between.x;
    }
    if (!is_zero(t)) try_normal(leaf().turn_to_world(t));
    try_point(own);
  }

  struct Corner {
    Exact world, own;
  };
  void with_leaf() {
    towards_ = of_a_ ? direction_ : Vec3<double>(-direction_);
    std::vector<std::uint32_t> near = polytope().farthest(towards_, kNear * cso_.extent());
    thin_out(near);
    std::vector<Corner> corner;
    for (const std::uint32_t k : near) {
      const Exact x = polytope().vertex(k);
      corner.push_back({x, leaf().to_own(x)});
    }
    for (int i = 0; i < 3 && !done(); ++i) try_axis(i);
    for (std::size_t i = 0; i < corner.size() && !done(); ++i) {
      for (std::size_t j = i + 1; j < corner.size() && !done(); ++j) {
        for (std::size_t k = j + 1; k < corner.size() && !done(); ++k)
          try_face(corner[i], corner[j], corner[k], corner);
      }
    }
    for (std::size_t i = 0; i < corner.size() && !done(); ++i) {
      for (std::size_t j = i + 1; j < corner.size() && !done(); ++j) try_edge(corner[i], corner[j]);
    }
    for (std::size_t i = 0; i < corner.size() && !done(); ++i) try_point_and_normal(corner[i].own);
  }
  // Keeps six of many corners of one face: the farthest along six directions of the plane, from the leaf's middle.
  void thin_out(std::vector<std::uint32_t>& near) const {
    if (near.size() <= kCorners) return;
    const Frame<double> frame(unit(towards_));
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < kCorners; ++i) {
      const SineCosine<double> at = rounded_sine_cosine(double(i) * (6.283185307179586 / double(kCorners)));
      const Vec3<double> d = at.cosine * frame.e1 + at.sine * frame.e2;
      std::uint32_t best = near.front();
      for (const std::uint32_t k : near) {
        if (dot(d, polytope().rounded_vertex(k)) > dot(d, polytope().rounded_vertex(best))) best = k;
      }
      if (std::find(out.begin(), out.end(), best) == out.end()) out.push_back(best);
    }
    near = out;
  }
  // An axis of the leaf that is nearly the direction: a flat end, the tip of an ellipsoid.
  void try_axis(int i) {
    if (leaf().kind() != Kind::ellipsoid && i < 2) return;
    Dyadic3 axis = leaf().axis(i);
    const double along = dot(unit(direction_of(axis)), towards_);
    if (!(std::abs(along) > 1 - kAligned)) return;
    if (along < 0) axis = minus(axis);
    try_normal(axis);
    if (done()) return;
    // The polytope's farthest vertex, which an end may stand on.
    bool valid = true;
    const Exact x = polytope().vertex(polytope().farthest(axis, valid));
    if (valid) try_point(leaf().to_own(x));
  }

  // The plane of three corners X, X + e, X + g, all with the weight w.
  struct Plane {
    Dyadic3 x, e, g, n;
    Dyadic w, nn;
  };
  // A point of the plane, and its barycentric coordinates, of one positive weight.
  struct OnPlane {
    Exact world;
    std::array<Dyadic, 3> share;
    [[nodiscard]] bool inside() const {
      return share[0].sign() >= 0 && share[1].sign() >= 0 && share[2].sign() >= 0 && share[0].valid();
    }
  };
  // The foot of y on the plane.
  [[nodiscard]] static OnPlane foot(const Plane& plane, const Exact& y) {
    OnPlane out;
    const Dyadic3 d = difference(times(plane.w, y.x), times(y.weight, plane.x));
    const Dyadic height = exact::dot(d, plane.n);
    const Dyadic3 z = difference(times(plane.nn, d), times(height, plane.n));
    const Dyadic weight = y.weight * plane.w * plane.nn;
    out.share[1] = exact::dot(plane.n, exact::cross(z, plane.g)) * plane.w;
    out.share[2] = exact::dot(plane.n, exact::cross(plane.e, z)) * plane.w;
    out.share[0] = weight * plane.nn - out.share[1] - out.share[2];
    out.world.x = z;
    out.world.weight = weight;
    out.world.weighted = true;
    Exact origin;
    origin.x = plane.x;
    origin.weight = plane.w;
    origin.weighted = true;
    out.world.add(origin, false);
    return out;
  }

  // Is a point of the plane inside of the hull of the corners in it? On a side of the triangle, if another lies beyond.
  static bool is_inside(const Plane& plane, const OnPlane& at, const std::vector<Corner>& corners) {
    int borders = 0;
    bool beyond = false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (at.share[i].sign() > 0) continue;
      ++borders;
      for (const Corner& one : corners) {
        const Dyadic3 d = difference(times(plane.w, one.world.x), times(one.world.weight, plane.x));
        beyond = beyond || (exact::dot(d, plane.n).sign() == 0 && foot(plane, one.world).share[i].sign() < 0);
      }
    }
    return borders == 0 || (borders == 1 && beyond);
  }

  void try_face(const Corner& p, const Corner& q, const Corner& r, const std::vector<Corner>& corners) {
    Plane plane;
    const bool same =
        (p.world.weight - q.world.weight).sign() == 0 && (p.world.weight - r.world.weight).sign() == 0;
    plane.w = same ? p.world.weight : p.world.weight * q.world.weight * r.world.weight;
    const auto placed = [&](const Exact& x, const Exact& y, const Exact& z) {
      return same ? x.x : times(y.weight * z.weight, x.x);
    };
    plane.x = placed(p.world, q.world, r.world);
    plane.e = difference(placed(q.world, p.world, r.world), plane.x);
    plane.g = difference(placed(r.world, p.world, q.world), plane.x);
    plane.n = exact::cross(plane.e, plane.g);
    plane.nn = exact::dot(plane.n, plane.n);
    if (plane.nn.sign() == 0 || !plane.nn.valid()) return;
    const double along = dot(unit(direction_of(plane.n)), towards_);
    if (!(std::abs(along) > 1 - kAligned)) return;
    const Dyadic3 t = along < 0 ? minus(plane.n) : plane.n;
    const int sign = try_normal(t);
    if (done()) return;
    const auto try_foot = [&](const OnPlane& at) {
      if (done() || !at.inside()) return;
      try_point(leaf().to_own(at.world));
      // Inside of a face of C's border there is one normal.
      if (sign == 0 && found_.kind == StartKind::touching && !found_.only_normal)
        found_.only_normal = is_inside(plane, at, corners);
    };
    const Dyadic3 down = leaf().turn_to_own(minus(t)).x;
    const OnPlane one = foot(plane, leaf().to_world(leaf().along(down, 0)));
    if (leaf().kind() == Kind::ellipsoid) return try_foot(one);
    const OnPlane other = foot(plane, leaf().to_world(leaf().along(down, 1)));
    // The middle of the part over the face, between the two and of a flat end. After that, their ends.
    double from = 0, to = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double at = ratio(one.share[i], one.world.weight),
                   way = ratio(other.share[i], other.world.weight) - at;
      if (way > 0) from = std::max(from, -at / way);
      if (way < 0) to = std::min(to, -at / way);
    }
    if (from <= to) try_foot(foot(plane, leaf().to_world(leaf().along(down, from / 2 + to / 2))));
    Exact middle;
    const bool lower = leaf().kind() == Kind::cone || direction_of(down)[2] < 0;
    middle.x[2] = Dyadic(lower ? -leaf().half_height() : leaf().half_height());
    try_foot(foot(plane, leaf().to_world(middle)));
    try_foot(one);
    try_foot(other);
    for (const Corner* corner : {&p, &q, &r}) try_point(corner->own);
  }

  // Points of an edge: the nearest to the axis, the least of a cone's equation, and the crossings of the ends.
  void try_edge(const Corner& p, const Corner& q) {
    if (leaf().kind() == Kind::ellipsoid) return;
    Dyadic3 x = p.own.x;
    const Dyadic w = p.own.weight * q.own.weight;
    x = times(q.own.weight, x);
    const Dyadic3 e = difference(times(p.own.weight, q.own.x), x);
    // The normal of the edge and the axis.
    const Dyadic3 across = {e[1], -e[0], Dyadic()};
    if (!is_zero(across)) {
      const Dyadic3 n = leaf().turn_to_world(across);
      try_normal(dot(direction_of(n), towards_) < 0 ? minus(n) : n);
    }
    const Dyadic h = Dyadic(leaf().half_height()) * w;
    const auto at = [&](Dyadic over, Dyadic under) {
      if (under.sign() < 0) {
        over = -over;
        under = -under;
      }
      if (done() || under.sign() == 0 || over.sign() < 0 || (over - under).sign() > 0) return;
      Exact own;
      for (std::size_t i = 0; i < 3; ++i) own.x[i] = under * x[i] + over * e[i];
      own.weight = under * w;
      own.weighted = true;
      try_point(own);
      try_point_and_normal(own);
    };
    // For an edge along the axis, the middle between the ends.
    const double way = ratio(e[2], w), low = ratio(x[2], w);
    if (way != 0) {
      const double one = (leaf().half_height() - low) / way, other = (-leaf().half_height() - low) / way;
      at(Dyadic((std::clamp(one, 0.0, 1.0) + std::clamp(other, 0.0, 1.0)) / 2), Dyadic(1));
    }
    at(-(x[0] * e[0] + x[1] * e[1]), e[0] * e[0] + e[1] * e[1]);
    if (leaf().kind() == Kind::cone) {
      const Dyadic r(leaf().radius()), twice(2 * leaf().half_height());
      const Dyadic a = twice * twice, b = r * r, top = h - x[2];
      at(-(a * (x[0] * e[0] + x[1] * e[1]) + b * top * e[2]),
         a * (e[0] * e[0] + e[1] * e[1]) - b * e[2] * e[2]);
    }
    at(h - x[2], e[2]);
    at(-h - x[2], e[2]);
  }

  // ---- two leaves ----

  void of_leaves() {
    for (const bool of_a : {true, false}) {
      of_a_ = of_a;
      towards_ = of_a_ ? direction_ : Vec3<double>(-direction_);
      const ExactLeaf<S>& first = of_a_ ? a_.leaf() : b_.leaf();
      std::vector<Dyadic3> normals;
      for (const ExactLeaf<S>* one : {&a_.leaf(), &b_.leaf()}) {
        for (int i = 0; i < 3; ++i) normals.push_back(one->axis(i));
      }
      normals.push_back(exact::cross(a_.leaf().axis(2), b_.leaf().axis(2)));
      // Across both axes where these are parallel.
      const Dyadic3 z = a_.leaf().axis(2);
      Exact between = a_.leaf().to_world({});
      between.add(b_.leaf().to_world({}), true);
      normals.push_back(difference(times(exact::dot(z, z), between.x), times(exact::dot(z, between.x), z)));
      normals.push_back(between.x);
      for (const Dyadic3& n : normals) {
        const Vec3<double> rounded = direction_of(n);
        if (done()) return;
        if (rounded == Vec3<double>::Zero()) continue;
        const double along = dot(unit(rounded), towards_);
        if (std::abs(along) > 1 - kAligned) try_leaves(first, along < 0 ? minus(n) : n);
      }
    }
  }
  // Points of the one that reach farthest towards the other.
  void try_leaves(const ExactLeaf<S>& first, const Dyadic3& t) {
    try_normal(t);
    const Dyadic3 up = first.turn_to_own(t).x;
    const auto try_own = [&](const Exact& x) {
      if (!done()) try_point(leaf().to_own(first.to_world(x)));
    };
    const bool round = first.kind() == Kind::ellipsoid;
    try_own(first.along(up, 0));
    if (round) return;
    try_own(first.along(up, 1));
    // Over the middle of the common part along the axis, and of two ends that overlap.
    const Exact origin = first.to_own(leaf().to_world({}));
    const double h = first.half_height(), r = first.radius();
    const double z = ratio(origin.x[2], origin.weight),
                 more = std::max(leaf().half_height(), leaf().radius());
    const double low = std::max(-h, z - more), high = std::min(h, z + more);
    if (h > 0) try_own(first.along(up, std::clamp(0.5 - (low + high) / (4 * h), 0.0, 1.0)));
    Exact end;
    end.x[2] = Dyadic(first.kind() == Kind::cone || direction_of(up)[2] < 0 ? -h : h);
    try_own(end);
    const double x = ratio(origin.x[0], origin.weight), y = ratio(origin.x[1], origin.weight);
    const double far = hypotenuse(x, y);
    if (!(far > 0) || !(r > 0)) return;
    const double least = std::max(far - leaf().radius(), -r), most = std::min(r, far);
    const double at = std::clamp((least + most) / 2 / far, -r / far, r / far) * (1 - 0x1p-40);
    end.x[0] = Dyadic(at * x);
    end.x[1] = Dyadic(at * y);
    try_own(end);
  }

  static constexpr double kAway = 0x1p-20;  // internal length
  // Corners within this of the farthest, over the extent of C, may belong to one face. A face or an axis within this
  // of the direction (1 - cos) may be its normal. Only candidates depend on these values.
  static constexpr double kNear = 0x1p-14, kAligned = 0x1p-12;
  static constexpr std::size_t kCorners = 6;

  const Cso<double>& cso_;
  Counters& counters_;
  int budget_;  // of the searches for a direction
  ExactBody<S> a_, b_;
  Dyadic radius_;
  bool of_a_ = true;  // the polytope is A
  bool valid_ = true;
  Vec3<double> direction_ = Vec3<double>::Zero(), towards_ = Vec3<double>::Zero();
  Dyadic3 normal_;                 // the last that was tried, from A to B
  std::optional<Dyadic3> border_;  // one with h(n) + R |n| = 0
  ExactStart found_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
