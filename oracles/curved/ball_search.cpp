// Decides exactly: nothing.
// Brackets only: distance, depth and first point on a line, each from outside by half-spaces (support values)
//   and from inside by hulls of points of K.
// Costs: a step takes one support and 10 to 30 microseconds more at 330 bits. A smooth boundary takes three
//   or four steps a decimal digit. A polytope ends in as many steps as it has features near.
// Cannot be trusted: it can, but at the end of a budget the bracket is wide.
#include "oracles/curved/ball_search.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_set>

namespace graze::oracle {
namespace {

// Below this, relative to its operands, a midpoint is rounding and nothing else.
Ball noise() { return power_of_two(24 - WorkingPrecision::bits()); }

Ball exact_weight(const Ball& w) { return w.mid_sign() > 0 ? w.mid() : Ball(0); }

}  // namespace

BallVec Combination::of(const BallVec CsoPoint::*what) const {
  BallVec sum;
  Ball total;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum = sum + weights[i] * (points[i].*what);
    total += weights[i];
  }
  return {sum.x / total, sum.y / total, sum.z / total};
}

// --- Nearest point: Wolfe's algorithm ("Finding the nearest point in a polytope", Math. Programming 11,
// 1976), with K's support as its oracle. A corral is an affinely independent set whose affine hull is nearest
// to the origin inside the corral's hull.
namespace {

struct Corral {
  std::vector<CsoPoint> points;
  std::vector<BallVec> y;  // midpoints, relative to the shift
  std::vector<Ball> weights;

  void drop(std::size_t i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    points.erase(points.begin() + at);
    y.erase(y.begin() + at);
    weights.erase(weights.begin() + at);
  }
  [[nodiscard]] BallVec nearest() const {
    BallVec x;
    for (std::size_t i = 0; i < y.size(); ++i) x = x + weights[i] * y[i];
    return x.mid();
  }
};

struct AffineStep {
  std::vector<Ball> weights;  // for the affine hull's nearest point, or a dependence with sum 0
  bool dependent = false;
};

// Normal equations on differences from the first point: G z = -D y_0, by elimination with the largest pivot.
AffineStep affine_nearest(const std::vector<BallVec>& y) {
  const std::size_t k = y.size() - 1;
  std::array<std::array<Ball, 4>, 3> m;
  std::array<BallVec, 3> d;
  for (std::size_t i = 0; i < k; ++i) d[i] = y[i + 1] - y[0];
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) m[i][j] = j < i ? m[j][i] : dot(d[i], d[j]).mid();
    m[i][3] = -dot(d[i], y[0]).mid();
  }
  std::array<Ball, 3> diagonal;
  std::array<std::size_t, 3> order = {0, 1, 2};
  for (std::size_t i = 0; i < k; ++i) diagonal[i] = m[i][i];
  AffineStep step;
  std::size_t rank = k;
  for (std::size_t s = 0; s < k; ++s) {
    std::size_t best = s;
    for (std::size_t i = s + 1; i < k; ++i) {
      if (mid_less(m[order[best]][order[best]] * diagonal[order[i]],
                   m[order[i]][order[i]] * diagonal[order[best]])) {
        best = i;
      }
    }
    std::swap(order[s], order[best]);
    const std::size_t p = order[s];
    if (!mid_less(noise() * diagonal[p], m[p][p])) {
      rank = s;
      break;
    }
    for (std::size_t i = s + 1; i < k; ++i) {
      const std::size_t r = order[i];
      const Ball factor = (m[r][p] / m[p][p]).mid();
      for (std::size_t j = s; j < k; ++j) m[r][order[j]] = (m[r][order[j]] - factor * m[p][order[j]]).mid();
      m[r][3] = (m[r][3] - factor * m[p][3]).mid();
    }
  }
  std::array<Ball, 3> z;
  step.dependent = rank < k;
  std::size_t solved = k;
  if (step.dependent) {  // one free unknown set to 1, those beyond it to 0, no right-hand side
    z[order[rank]] = 1;
    solved = rank;
  }
  for (std::size_t s = solved; s-- > 0;) {
    const std::size_t p = order[s];
    Ball sum = step.dependent ? Ball(0) : m[p][3];
    for (std::size_t j = s + 1; j < k; ++j) sum.subtract_product(m[p][order[j]], z[order[j]]);
    z[p] = (sum / m[p][p]).mid();
  }
  Ball first = step.dependent ? 0 : 1;
  for (std::size_t i = 0; i < k; ++i) first -= z[i];
  step.weights.push_back(first.mid());
  for (std::size_t i = 0; i < k; ++i) step.weights.push_back(z[i]);
  return step;
}

// Makes the set with its newest point, of weight 0, a corral again.
void settle(Corral& corral) {
  for (int round = 0; round < 12; ++round) {
    AffineStep step = affine_nearest(corral.y);
    const std::size_t n = corral.y.size();
    if (step.dependent) {  // move along the dependence, the newest point gaining, until a weight is gone
      if (step.weights[n - 1].mid_sign() < 0) {
        for (Ball& w : step.weights) w = -w;
      }
      for (std::size_t i = 0; i < n; ++i) step.weights[i] += corral.weights[i];
    }
    std::size_t blocking = n;
    Ball theta;
    for (std::size_t i = 0; i < n; ++i) {
      if (step.weights[i].mid_sign() > 0) continue;
      const Ball way = corral.weights[i] - step.weights[i];
      const Ball t = way.mid_sign() > 0 ? (corral.weights[i] / way).mid() : Ball(0);
      if (blocking == n || mid_less(t, theta)) {
        blocking = i;
        theta = t;
      }
    }
    if (blocking == n) {
      corral.weights = std::move(step.weights);
      if (!step.dependent) return;
      continue;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Ball w = corral.weights[i] + theta * (step.weights[i] - corral.weights[i]);
      corral.weights[i] = exact_weight(w);
    }
    corral.drop(blocking);
    if (corral.y.size() == 1) {
      corral.weights[0] = 1;
      return;
    }
  }
}

BallVec across(const BallVec& d, int axis) {
  Vec3<double> e = Vec3<double>::Zero();
  e[axis] = 1;
  return cross(d, BallVec(e)).mid();
}

// Directions across the affine hull of y, enough of them to leave it unless the set is as flat.
std::vector<BallVec> directions_out_of(const std::vector<BallVec>& y) {
  std::vector<BallVec> out;
  const BallVec one(Vec3<double>(1, 0, 0)), two(Vec3<double>(0, 1, 0)), three(Vec3<double>(0, 0, 1));
  if (y.size() == 1) out = {one, two, three};
  if (y.size() == 2) {
    for (int axis = 0; axis < 3; ++axis) out.push_back(across(y[1] - y[0], axis));
  }
  if (y.size() == 3) out = {cross(y[1] - y[0], y[2] - y[0]).mid()};
  return out;
}

// Four affinely independent points, from fewer that hold the shift already. False if the set is flat.
bool complete(const ConvexSet& set, const BallVec& shift, Corral& corral, int& supports) {
  while (corral.y.size() < 4) {
    std::optional<CsoPoint> best;
    Ball furthest;
    for (const BallVec& n : directions_out_of(corral.y)) {
      const Ball length = norm(n);
      if (!length.is_positive()) continue;
      for (const BallVec& side : {n, -n}) {
        CsoPoint found = set(side);
        ++supports;
        const Ball height = (dot(side, (found.point - shift).mid() - corral.y[0]) / length).mid();
        const Ball rounding = power_of_two(-3 * WorkingPrecision::bits() / 4) * norm(found.point);
        if (mid_less(rounding, height) && (!best || mid_less(furthest, height))) {
          furthest = height;
          best = std::move(found);
        }
      }
    }
    if (!best) return false;
    corral.y.push_back((best->point - shift).mid());
    corral.points.push_back(std::move(*best));
    corral.weights.emplace_back(0.0);
  }
  return true;
}

}  // namespace

Nearest3 nearest(const ConvexSet& set, const BallVec& shift, const NearestGoal& goal) {
  Nearest3 result;
  Corral corral;
  const auto add = [&](CsoPoint point) {
    corral.y.push_back((point.point - shift).mid());
    corral.points.push_back(std::move(point));
    corral.weights.emplace_back(0.0);
  };
  add(set(BallVec(Vec3<double>(1, 0, 0))));
  corral.weights[0] = 1;
  result.supports = 1;
  const Ball shift_sq = dot(shift, shift);
  BallVec x;
  while (result.supports < goal.max_supports) {
    x = corral.nearest();
    const Ball x_sq = dot(x, x);
    // A corral of four spans all of space: it holds the shift, and x is rounding.
    if (corral.y.size() == 4 || x_sq.mid_sign() == 0 || mid_less(x_sq, power_of_two(-40) * shift_sq)) {
      result.around = complete(set, shift, corral, result.supports);
      break;
    }
    const BallVec n = -x;
    CsoPoint found = set(n);
    ++result.supports;
    const Ball length = norm(n);
    const Ball bound = not_below_zero((-found.reach / length).low());
    const Ball reach = not_below_zero((found.reach / length).high());
    if (result.supports == 2 || mid_less(reach, result.least_reach)) result.least_reach = reach;
    if (mid_less(result.lower, bound)) {
      result.lower = bound;
      result.axis = n;
    }
    if (goal.until_separated && result.lower.is_positive()) break;
    const Ball upper = length + norm(shift), gap = upper - result.lower;
    if (mid_less(gap, goal.absolute) || mid_less(gap, goal.relative * upper)) break;
    // Compares the gain of the new point with the possible rounding error.
    const BallVec y = (found.point - shift).mid();
    const Ball gain = x_sq - dot(x, y);
    if (!mid_less(noise() * x_sq, gain)) break;
    // About as far from the shift's point as the shift is long: whether K holds the origin stays open.
    if (mid_less(x_sq, Ball(4) * shift_sq) && mid_less(gain, power_of_two(-20) * x_sq)) break;
    add(std::move(found));
    settle(corral);
  }
  result.inner.points = std::move(corral.points);
  for (const Ball& w : corral.weights) result.inner.weights.push_back(exact_weight(w));
  result.upper = norm(result.inner.of(&CsoPoint::point)).high();
  return result;
}

// --- Least depth: a polytope of points of K around the origin, grown at its nearest facet (the expanding
// polytope of van den Bergen, "Proximity queries and penetration depth computation on 3D game objects",
// 2001). Proof of the lower bound: the facets close up (each edge is met once in each direction), and every
// facet has the origin strictly on its inner side. Then the surface, seen from the origin, covers every
// direction, so the ball that touches the nearest facet's plane is in the hull.
namespace {

struct Facet {
  std::array<int, 3> corner;
  BallVec normal;         // midpoints, outward, not normalised
  Ball offset, distance;  // normal.x on the plane, and the same over |normal|
  Ball length;
  bool alive = true, final = false;
};

class InnerPolytope {
 public:
  InnerPolytope(const ConvexSet& set, const std::vector<CsoPoint>& start) : set_(set) {
    for (const CsoPoint& p : start) points_.push_back(p.point);
    for (const BallVec& p : points_) size_ = max(size_, norm(p).high());
    tie_ = size_ * power_of_two(-3 * WorkingPrecision::bits() / 4);
    const std::array<std::array<int, 4>, 4> faces = {
        {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
    for (const auto& f : faces) {
      std::array<int, 3> corner = {f[0], f[1], f[2]};
      const BallVec& a = at(f[0]);
      if (dot(cross(at(f[1]) - a, at(f[2]) - a), at(f[3]) - a).mid_sign() > 0)
        std::swap(corner[1], corner[2]);
      add_facet(corner);
    }
  }

  Depth3 run(const DepthGoal& goal) {
    bool any = false;
    while (supports_ < goal.max_supports) {
      Facet* best = nearest_facet();
      if (best == nullptr) break;
      if (any && best->distance.mid_sign() > 0) {
        const Ball gap = result_.upper - best->distance;
        if (mid_less(gap, goal.absolute) || mid_less(gap, goal.relative * result_.upper)) break;
      }
      if (any && mid_less(result_.upper, goal.absolute)) break;
      const BallVec n = best->normal;
      const CsoPoint found = set_(n);
      ++supports_;
      const Ball bound = (found.reach / norm(n)).high();
      if (!any || mid_less(bound, result_.upper)) {
        result_.upper = bound;
        result_.axis = n;
        any = true;
      }
      const BallVec p = found.point.mid();
      if (!mid_less(best->offset + tie_ * best->length, dot(n, p))) break;  // the nearest facet is K's own
      expand(found.point, p);
    }
    result_.lower = proved_lower();
    result_.supports = supports_;
    return result_;
  }

 private:
  [[nodiscard]] BallVec at(int i) const { return points_[static_cast<std::size_t>(i)].mid(); }

  void add_facet(const std::array<int, 3>& corner) {
    Facet f;
    f.corner = corner;
    const BallVec a = at(corner[0]);
    f.normal = cross(at(corner[1]) - a, at(corner[2]) - a).mid();
    f.length = norm(f.normal).mid();
    f.offset = dot(f.normal, a).mid();
    if (f.length.mid_sign() > 0) f.distance = (f.offset / f.length).mid();
    facets_.push_back(std::move(f));
  }

  Facet* nearest_facet() {
    Facet* best = nullptr;
    for (Facet& f : facets_) {
      if (f.length.mid_sign() > 0 && (best == nullptr || mid_less(f.distance, best->distance))) best = &f;
    }
    return best;
  }

  static std::uint64_t edge(int from, int to) {
    return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint64_t>(to);
  }

  void expand(const BallVec& enclosed, const BallVec& p) {
    std::unordered_set<std::uint64_t> seen_edges;
    std::vector<Facet> kept, seen;
    for (Facet& f : facets_) {
      const bool visible = mid_less(f.offset - tie_ * f.length, dot(f.normal, p));
      (visible ? seen : kept).push_back(std::move(f));
    }
    for (const Facet& f : seen) {
      for (std::size_t i = 0; i < 3; ++i) seen_edges.insert(edge(f.corner[i], f.corner[(i + 1) % 3]));
    }
    const int index = static_cast<int>(points_.size());
    points_.push_back(enclosed);
    facets_ = std::move(kept);
    for (const Facet& f : seen) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int from = f.corner[i], to = f.corner[(i + 1) % 3];
        if (!seen_edges.contains(edge(to, from))) add_facet({from, to, index});
      }
    }
  }

  [[nodiscard]] Ball proved_lower() const {
    std::unordered_set<std::uint64_t> edges;
    for (const Facet& f : facets_) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!edges.insert(edge(f.corner[i], f.corner[(i + 1) % 3])).second) return 0;
      }
    }
    Ball least;
    bool any = false;
    for (const Facet& f : facets_) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!edges.contains(edge(f.corner[(i + 1) % 3], f.corner[i]))) return 0;
      }
      const BallVec& a = points_[static_cast<std::size_t>(f.corner[0])];
      const BallVec& b = points_[static_cast<std::size_t>(f.corner[1])];
      const BallVec& c = points_[static_cast<std::size_t>(f.corner[2])];
      const BallVec n = cross(b - a, c - a);
      const Ball side = dot(n, a);
      if (!side.is_positive()) return 0;
      const Ball distance = (side / norm(n)).low();
      if (!any || mid_less(distance, least)) least = distance;
      any = true;
    }
    return not_below_zero(least);
  }

  const ConvexSet& set_;
  std::vector<BallVec> points_;
  std::vector<Facet> facets_;
  Ball size_, tie_;
  Depth3 result_;
  int supports_ = 0;
};

}  // namespace

Depth3 least_depth(const ConvexSet& set, const std::vector<CsoPoint>& start, const DepthGoal& goal) {
  return InnerPolytope(set, start).run(goal);
}

// --- First point on a line: column generation (Dantzig and Wolfe, "Decomposition principle for linear
// programs", 1960) on  min height  over combinations that lie on the line. Three columns are a portal, and
// the support in the portal's normal is the pricing. All columns found stay in the pool: the portal is a face
// of their hull, as in a Delaunay triangulation, and does not grow long.
namespace {

struct Column {
  CsoPoint from;
  Ball x, y, height;  // midpoints, in a frame across the line, and along it in units of v
};

struct Weights {
  std::array<Ball, 3> w;
  bool valid = false;
};

// Barycentric coordinates of (x, y) in three columns, seen along the line.
Weights barycentric(const std::array<const Column*, 3>& c, const Ball& x, const Ball& y) {
  const Ball ax = c[1]->x - c[0]->x, ay = c[1]->y - c[0]->y, bx = c[2]->x - c[0]->x, by = c[2]->y - c[0]->y;
  const Ball px = x - c[0]->x, py = y - c[0]->y;
  const Ball det = (ax * by - ay * bx).mid();
  Weights result;
  if (det.mid_sign() == 0) return result;
  result.w[1] = ((px * by - py * bx) / det).mid();
  result.w[2] = ((ax * py - ay * px) / det).mid();
  result.w[0] = (Ball(1) - result.w[1] - result.w[2]).mid();
  result.valid = true;
  return result;
}

class LineProgram {
 public:
  LineProgram(const ConvexSet& set, const BallVec& v, const BallVec& shift) : set_(set), v_(v) {
    v_sq_ = dot(v_, v_).mid();
    // A frame across v, orthogonal up to rounding: all that is proved comes from points and axes later.
    const Vec3<double> rough = v.mid_double().cwiseAbs();
    int least = 0;
    for (int i = 1; i < 3; ++i) least = rough[i] < rough[least] ? i : least;
    Vec3<double> unit = Vec3<double>::Zero();
    unit[least] = 1;
    const BallVec u = cross(v_, BallVec(unit)).mid(), w = cross(v_, u).mid();
    e1_ = ((Ball(1) / norm(u)) * u).mid();
    e2_ = ((Ball(1) / norm(w)) * w).mid();
    x0_ = dot(e1_, shift).mid();
    y0_ = dot(e2_, shift).mid();
  }

  // The portal that holds the shift best: a weight may fall short of 0 by rounding.
  bool start(const std::vector<CsoPoint>& points) {
    for (const CsoPoint& p : points) add(p);
    bool any = false;
    Ball best;
    for (std::size_t i = 0; i < pool_.size(); ++i) {
      for (std::size_t j = i + 1; j < pool_.size(); ++j) {
        for (std::size_t k = j + 1; k < pool_.size(); ++k) {
          const std::array<std::size_t, 3> portal = {i, j, k};
          Weights weights = barycentric(columns(portal), x0_, y0_);
          if (!weights.valid) continue;
          const Ball least = min(min(weights.w[0], weights.w[1]), weights.w[2]);
          if (any && !mid_less(best, least)) continue;
          any = true;
          best = least;
          portal_ = portal;
          weights_ = std::move(weights);
        }
      }
    }
    return any && mid_less(Ball(-0x1p-20), best);
  }

  FirstOnLine run(const LineGoal& goal) {
    FirstOnLine result;
    const Ball speed = sqrt(v_sq_);
    bool any = false;
    while (true) {
      solve_pool();
      const BallVec n = portal_normal();
      const CsoPoint found = set_(n);
      ++result.supports;
      const Ball rate = dot(n, v_);
      if (rate.is_negative()) {
        const Ball bound = (found.reach / rate).low();
        if (bound.is_finite() && (!any || mid_less(result.lower, bound))) {
          result.lower = bound;
          result.axis = n;
          any = true;
        }
      }
      if (any && mid_less((level_ - result.lower) * speed, goal.absolute)) break;
      if (mid_less(level_, goal.far_behind)) break;
      if (result.supports >= goal.max_supports) break;
      const std::size_t entering = add(found);
      const Ball gain = -reduced_cost(pool_[entering]);
      const Ball magnitude = abs(level_) + abs(pool_[entering].height);
      if (!mid_less(noise() * magnitude, gain)) break;
      pivot(entering);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      result.inner.points.push_back(pool_[portal_[i]].from);
      result.inner.weights.push_back(exact_weight(weights_.w[i]));
    }
    const BallVec q = result.inner.of(&CsoPoint::point);
    result.height = (dot(q, v_) / dot(v_, v_)).high();
    result.off = norm(q - result.height * v_).high();
    return result;
  }

 private:
  [[nodiscard]] std::array<const Column*, 3> columns(const std::array<std::size_t, 3>& i) const {
    return {&pool_[i[0]], &pool_[i[1]], &pool_[i[2]]};
  }

  std::size_t add(const CsoPoint& p) {
    pool_.push_back({p, dot(e1_, p.point).mid(), dot(e2_, p.point).mid(), (dot(v_, p.point) / v_sq_).mid()});
    return pool_.size() - 1;
  }

  // height = level + slope_x (x - x0) + slope_y (y - y0) on the portal's plane.
  void plane() {
    const auto c = columns(portal_);
    const Ball ax = c[1]->x - c[0]->x, ay = c[1]->y - c[0]->y, az = c[1]->height - c[0]->height;
    const Ball bx = c[2]->x - c[0]->x, by = c[2]->y - c[0]->y, bz = c[2]->height - c[0]->height;
    const Ball det = (ax * by - ay * bx).mid();
    slope_x_ = ((az * by - ay * bz) / det).mid();
    slope_y_ = ((ax * bz - az * bx) / det).mid();
    level_ = (c[0]->height + slope_x_ * (x0_ - c[0]->x) + slope_y_ * (y0_ - c[0]->y)).mid();
  }

  [[nodiscard]] Ball reduced_cost(const Column& c) const {
    return (c.height - level_ - slope_x_ * (c.x - x0_) - slope_y_ * (c.y - y0_)).mid();
  }

  // n.v = -1, n.c = -(height - slopes): its support is the column of least reduced cost.
  [[nodiscard]] BallVec portal_normal() const {
    return (slope_x_ * e1_ + slope_y_ * e2_ - (Ball(1) / v_sq_) * v_).mid();
  }

  void pivot(std::size_t entering) {
    const Weights along = barycentric(columns(portal_), pool_[entering].x, pool_[entering].y);
    if (!along.valid) return;
    std::size_t leaving = 3;
    Ball least;
    for (std::size_t i = 0; i < 3; ++i) {
      if (along.w[i].mid_sign() <= 0) continue;
      const Ball ratio = (weights_.w[i] / along.w[i]).mid();
      if (leaving == 3 || mid_less(ratio, least)) {
        leaving = i;
        least = ratio;
      }
    }
    if (leaving == 3) return;
    std::array<std::size_t, 3> portal = portal_;
    portal[leaving] = entering;
    Weights weights = barycentric(columns(portal), x0_, y0_);
    if (!weights.valid) return;
    portal_ = portal;
    weights_ = std::move(weights);
  }

  // The portal of least height among the columns at hand.
  void solve_pool() {
    constexpr int kPivots = 64;
    for (int round = 0; round < kPivots; ++round) {
      plane();
      std::size_t best = pool_.size();
      Ball least = -noise() * (abs(level_) + Ball(1) / Ball(4));
      for (std::size_t i = 0; i < pool_.size(); ++i) {
        if (i == portal_[0] || i == portal_[1] || i == portal_[2]) continue;
        const Ball cost = reduced_cost(pool_[i]);
        if (mid_less(cost, least)) {
          least = cost;
          best = i;
        }
      }
      if (best == pool_.size()) return;
      pivot(best);
    }
    plane();
  }

  const ConvexSet& set_;
  BallVec v_, e1_, e2_;
  Ball v_sq_, x0_, y0_;
  std::vector<Column> pool_;
  std::array<std::size_t, 3> portal_ = {0, 0, 0};
  Weights weights_;
  Ball slope_x_, slope_y_, level_;
};

}  // namespace

std::optional<FirstOnLine> first_on_line(const ConvexSet& set, const BallVec& v,
                                         const std::vector<CsoPoint>& start, const BallVec& shift,
                                         const LineGoal& goal) {
  LineProgram program(set, v, shift);
  if (!program.start(start)) return {};
  return program.run(goal);
}

}  // namespace graze::oracle
