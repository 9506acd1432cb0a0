// Decides exactly when two moving rounded polytopes are first in contact: spheres, capsules, roundings of polytopes,
// and polytopes at a target distance.
//
//   K the hull of the differences c = a - b of the cores' posed vertices;   v = v_B - v_A;   R = r_A + r_B + m, exact
//   p(t) the point of K nearest to t v;   w(t) = t v - p(t);   f = w.w, which is convex, f' = 2 w.v
// Contact at t is f(t) <= R^2. Every decision is the sign of a rational number at a double t (exact_nearest.hpp):
//   start    f(0) against R^2
//   verdict  w*.w* against R^2, w* the shortest vector from K to the path: the nearest point of K swept by -v
//   time     if w*.w* < R^2, t <= TOI iff f(t) >= R^2 and w(t).v < 0. Before TOI f falls strictly, as it gets below R^2
//            later. After TOI f is at R^2 only while it grows. TOI is the largest such double iff f is R^2 there.
//   graze    w*.w* = R^2: contacts are the t with t v - w* in K. If w*.v != 0, contact is at the path's end. Otherwise
//            it is on a line in the plane of K's face towards w*, which is cut in two dimensions. TOI is rational then.
//   leaving  (pass_over, r = r_A + r_B > 0) iff the ray from the start keeps w*.w* >= r^2. At rest, iff f(0) >= r^2.
// A path without end is cut at a t with v.(t v - c) >= 0 for every c: f does not fall from there on.
//
// Search: Newton steps for the root of |w| - R, which is convex, so that steps from below pass it only by rounding.
// Then doubling steps and bisection over the doubles. An estimate changes the cost and never the answer.
// Frame: world axes, the caller's units.
#pragma once

#include <graze/detail/search/exact/exact_answer.hpp>
#include <graze/detail/search/exact/exact_body.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// The contact of the path with C: the normal, and the contact's weights in up to three pairs of vertices.
struct RoundContact {
  TimeBracket toi;
  Dyadic3 normal;  // from A to B, of any length
  int size = 0;
  std::array<Vertex, 3> corner{};
  std::array<double, 3> share{};
};

// Approximate time and place, by a search in doubles. Time 0: unknown.
struct RoundGuess {
  double time = 0;
  int size = 0;
  std::array<Vertex, 3> corner{};
};

template <Scalar S>
class RoundSearch {
 public:
  RoundSearch(const Body<S>& a, const Body<S>& b, double target_distance) : a_(a), b_(b) {
    balls_ = exact_ball<S>(a.shape, valid_) + exact_ball<S>(b.shape, valid_);
    radius_ = balls_ + Dyadic(target_distance);
    for (std::size_t i = 0; i < 3; ++i) {
      const int k = static_cast<int>(i);
      v_[i] = Dyadic(double(b.displacement[k])) - Dyadic(double(a.displacement[k]));
    }
  }

  // False: a number outgrew its room.
  [[nodiscard]] bool valid() const { return valid_; }
  [[nodiscard]] int supports() const { return supports_; }
  [[nodiscard]] bool is_rounded() const { return radius_.sign() > 0; }
  [[nodiscard]] bool has_balls() const { return balls_.sign() > 0; }
  [[nodiscard]] bool moves() const { return !is_zero(v_); }

  // The sign of f(0) - R^2.
  [[nodiscard]] int start() {
    settle(Dyadic(), Dyadic(), radius_);
    return near_->sign_of_f();
  }
  // At rest or on the ray from the start: the sign of w*.w* - r^2.
  [[nodiscard]] int ray_without_target() {
    settle(Dyadic(), moves() ? end(kInfinity<double>) : Dyadic(), balls_);
    return near_->sign_of_f();
  }
  // The vector from A to B, of any length, of the last query. Zero if the cores overlap.
  [[nodiscard]] Dyadic3 separating() const { return minus(near_->p()); }
  // After it, for cores that are apart: |w| - R within 2^-48 of itself, times 2^k, and the sign of |w| - R - x for x >= 0.
  [[nodiscard]] double gap(int k = 0) const {
    const Dyadic reach = radius_ * near_->weight(),
                 below = near_->below() * near_->weight() * near_->weight();
    const auto in_unit = [&](const Dyadic& square) { return ratio(square.times_power_of_two(2 * k), below); };
    return in_unit(near_->above() - reach * reach * near_->below()) /
           (square_root(in_unit(near_->above())) + ratio(radius_.times_power_of_two(k), Dyadic(1)));
  }
  [[nodiscard]] int sign_of_gap_minus(double x) {
    const Dyadic reach = (radius_ + Dyadic(x)) * near_->weight();
    return check(near_->above() - reach * reach * near_->below());
  }
  // The point of K that was found.
  [[nodiscard]] RoundContact nearest_point() const {
    RoundContact out;
    out.normal = separating();
    take_corners(out);
    return out;
  }

  // No f falls beyond it: the earlier of it and t_max is a path's end.
  [[nodiscard]] Dyadic end(double t_max) {
    const Dyadic cut = power_beyond(v_, false);
    return t_max < kInfinity<double> && (Dyadic(t_max) - cut).sign() < 0 ? Dyadic(t_max) : cut;
  }
  // Before it a line has no contact, and f does not grow.
  [[nodiscard]] Dyadic begin() { return -power_beyond(minus(v_), true); }

  enum class Path : std::uint8_t { misses, grazes, enters };
  // The path for t in [from, to], not in contact at `from`.
  [[nodiscard]] Path path(const Dyadic& from, const Dyadic& to) {
    from_ = from;
    to_ = to;
    settle(from, to, radius_);
    const int sign = near_->sign_of_f();
    return sign > 0 ? Path::misses : sign < 0 ? Path::enters : Path::grazes;
  }
  // The next search begins with these corners.
  void begin_at(const RoundGuess& guess) {
    seeds_.clear();
    for (std::size_t i = 0; i < std::size_t(guess.size); ++i)
      seeds_.push_back({guess.corner[i].a, guess.corner[i].b, false});
    if (seeds_.empty()) seeds_ = {Id{}};
  }
  // The first contact, if it is near the guess: f falls from R^2 or above at one double, and is not above R^2 at the
  // next. Neither the start nor the verdict needs a check then. No contact at `after` or before is returned.
  [[nodiscard]] std::optional<RoundContact> contact_near(const RoundGuess& guess, double after = 0) {
    begin_at(guess);
    double t = guess.time, lower = -kInfinity<double>, upper = kInfinity<double>;
    for (int step = 0; step < kSteps && valid_; ++step) {
      const bool falls = is_falling_at(t);
      const int sign = near_->sign_of_f();
      // At a graze the double itself may be the time.
      if (!valid_ || (sign >= 0 && !falls)) return {};
      if (sign == 0 && falls) return contact_in({t, t});
      (sign > 0 ? lower : upper) = t;
      if (next_up(lower) == upper) return contact_in({lower, upper});
      const double root = falls ? t + newton() : t, beside = next(t, sign > 0);
      t = std::abs(root - t) > std::abs(beside - t) && root > lower && root < upper ? root : beside;
      if (!(t > after && t < kInfinity<double>)) return {};
    }
    return {};
  }
  // The first contact of a path that does not miss. `guess`: a time near it.
  [[nodiscard]] RoundContact first_contact(Path path, double guess) {
    return path == Path::grazes ? graze() : enter(guess);
  }

  // ---- what proves an answer (round_claims.hpp) ----

  // A vertex of K - t v, at the later of two times if `late`.
  struct Id {
    std::uint32_t a = 0, b = 0;
    bool late = false;
  };
  // The vertices whose hull holds the point of K - t v, from <= t <= to, that is nearest to the origin.
  [[nodiscard]] std::span<const Id> nearest(const Dyadic& from, const Dyadic& to) {
    settle(from, to, radius_);
    return near_->corners();
  }
  // The sign of f - R^2 at that point, and the sign of w.v.
  [[nodiscard]] int sign_of_f() const { return near_->sign_of_f(); }
  [[nodiscard]] int sign_of_rate() const { return -dot(near_->p(), v_).sign(); }
  // Is the step between two vertices of K along v, or 0?
  [[nodiscard]] bool is_along_motion(const Id& from, const Id& to) {
    return is_zero(across_motion(from, to));
  }
  // After nearest(t, t) at a contact with w.v = 0: the edge that the path meets first (first_edge()).
  [[nodiscard]] std::array<Vertex, 2> edge_of_graze() {
    const FaceEdge edge = first_edge(axis_of_graze());
    return {edge.low.name, edge.high.name};
  }

 private:
  // K - t v for the t between two times.
  struct Points {
    using Id = RoundSearch::Id;
    RoundSearch& own;
    Dyadic from, to;
    [[nodiscard]] Exact at(const Id& id) const {
      Exact c = own.difference(id);
      const Dyadic t = (id.late ? to : from) * c.weight;
      for (std::size_t i = 0; i < 3; ++i) c.x[i] = c.x[i] - t * own.v_[i];
      return c;
    }
    [[nodiscard]] std::optional<Id> lowest(const Dyadic3& p) const {
      ++own.supports_;
      Id out{own.farthest(own.a_, minus(p)), own.farthest(own.b_, p), false};
      out.late = dot(p, own.v_).sign() > 0 && (to - from).sign() > 0;
      return own.valid_ ? std::optional<Id>(out) : std::nullopt;
    }
  };
  using Nearest = ExactNearest<Points>;

  static bool is_zero(const Dyadic3& x) { return x[0].sign() == 0 && x[1].sign() == 0 && x[2].sign() == 0; }
  int check(const Dyadic& x) {
    valid_ = valid_ && x.valid();
    return x.sign();
  }
  // A power of two above max c.n / n.n, n = v or -v, or 0: a double. `apart`: above that and R / |n|.
  [[nodiscard]] Dyadic power_beyond(const Dyadic3& n, bool apart) {
    const Exact c = difference({farthest(a_, n), farthest(b_, detail::minus(n)), false});
    const Dyadic far = dot(c.x, n), speed = dot(n, n);
    check(far);
    std::optional<int> order;
    if (far.sign() > 0) order = far.order() - (speed * c.weight).order() + 1;
    // |n| >= 2^(half the order of n.n, rounded down). The sum of both is below twice the larger.
    if (apart) order = 1 + std::max(order.value_or(-100000), radius_.order() + 1 - (speed.order() >> 1));
    return order ? Dyadic(1).times_power_of_two(std::max(*order, -1074)) : Dyadic();
  }
  [[nodiscard]] std::uint32_t farthest(const Body<S>& body, const Dyadic3& n) {
    return exact_farthest(body, n, false, valid_).front();
  }
  [[nodiscard]] Exact posed(const Body<S>& body, std::uint32_t k) const {
    Feature feature;
    feature.vertex = k;
    return exact_point(body, feature);
  }
  [[nodiscard]] Exact difference(const Id& id) const {
    Exact c = posed(a_, id.a);
    c.add(posed(b_, id.b), true);
    return c;
  }
  // The nearest point of K swept by -v over these times, from the last one's corners.
  void settle(const Dyadic& from, const Dyadic& to, const Dyadic& radius) {
    if (near_) {
      seeds_.assign(near_->corners().begin(), near_->corners().end());
      for (Id& id : seeds_) id.late = false;
    }
    points_.emplace(Points{*this, from, to});
    near_.emplace(*points_, radius);
    valid_ = near_->settle(seeds_) && valid_;
  }
  [[nodiscard]] bool is_falling_at(double t) {
    settle(Dyadic(t), Dyadic(t), radius_);
    return dot(near_->p(), v_).sign() > 0;
  }
  [[nodiscard]] bool is_before(double t) { return is_falling_at(t) && near_->sign_of_f() >= 0; }
  // After is_falling_at(t): Newton's step from there, as rounded. Lengths in a unit of about |v|, so no scale counts.
  [[nodiscard]] double newton() const {
    const int k = -(dot(v_, v_).order() >> 1);
    const Dyadic along = dot(near_->p(), v_).times_power_of_two(k);
    return gap(k) / square_root(ratio(along * along, dot(near_->p(), near_->p())));
  }

  // Doubles in their order, and back. There are up to 2^64 of them between two: more than a signed number holds.
  static constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  static std::uint64_t key_of(double t) {
    const auto bits = detail::bit_cast<std::uint64_t>(t);
    return bits < kSign ? bits : kSign - bits;
  }
  static std::uint64_t steps_between(double lower, double upper) { return key_of(upper) - key_of(lower); }
  static double after_steps(double t, std::uint64_t steps) {
    const std::uint64_t key = key_of(t) + steps;
    return detail::bit_cast<double>(key < kSign ? key : kSign - key);
  }
  // Exactly: the path's ends are doubles.
  static double as_double(const Dyadic& t) { return near_quotient(t, Dyadic(1)); }

  RoundContact enter(double guess) {
    const double first = as_double(from_), last = as_double(to_);
    double lower = first, upper = last;
    double t = guess > first && guess < last ? guess : first;
    bool has_lower = false;
    for (int step = 0; step < kNewton && valid_; ++step) {
      const bool falls = is_falling_at(t), before = falls && near_->sign_of_f() >= 0;
      (before ? lower : upper) = t;
      has_lower = has_lower || before;
      if (!before && has_lower) break;
      // Where f falls, a step from beyond the root lands below it.
      const double next = std::clamp(falls ? t + newton() : first, first, last);
      if (!(before ? next > t : next < t)) break;
      t = next;
    }
    // Doubling steps away from the end nearest to the estimate. The other end is the path's.
    const bool up = lower > first;
    for (std::uint64_t step = 1; valid_ && step <= steps_between(lower, upper) / 2; step *= 2) {
      t = up ? after_steps(lower, step) : after_steps(upper, 0 - step);
      const bool before = is_before(t);
      (before ? lower : upper) = t;
      if (before != up) break;
    }
    while (valid_ && steps_between(lower, upper) > 1) {
      t = after_steps(lower, steps_between(lower, upper) / 2);
      (is_before(t) ? lower : upper) = t;
    }
    return contact_in({lower, upper});
  }
  [[nodiscard]] RoundContact contact_in(const TimeBracket& toi) {
    RoundContact out;
    settle(Dyadic(toi.upper), Dyadic(toi.upper), radius_);
    const std::vector<Id> after(near_->corners().begin(), near_->corners().end());
    settle(Dyadic(toi.lower), Dyadic(toi.lower), radius_);
    out.toi = {toi.lower, near_->sign_of_f() == 0 ? toi.lower : toi.upper};
    if (!are_corners(after)) close_in(toi.lower);
    out.normal = normal_at_contact();
    take_corners(out);
    return out;
  }
  [[nodiscard]] bool are_corners(const std::vector<Id>& ids) const {
    const auto corners = near_->corners();
    return corners.size() == ids.size() && std::all_of(corners.begin(), corners.end(), [&](const Id& c) {
             return std::any_of(ids.begin(), ids.end(),
                                [&](const Id& id) { return id.a == c.a && id.b == c.b; });
           });
  }
  // The nearest feature changes between two doubles, which may be far apart beside R: Newton's steps over finer times.
  void close_in(double lower) {
    const double speed = square_root(ratio(dot(v_, v_), Dyadic(1))), radius = ratio(radius_, Dyadic(1));
    Dyadic t(lower);
    for (int step = 0; step < kNewton && valid_; ++step) {
      const double way = newton() * (1 - 0x1p-40);
      if (!(way * speed > kUnitRoundoff<double> / 4 * radius)) break;
      t = t + Dyadic(way);
      settle(t, t, radius_);
    }
  }
  void take_corners(RoundContact& out) const {
    const auto corners = near_->corners();
    out.size = static_cast<int>(std::min<std::size_t>(corners.size(), 3));
    for (std::size_t i = 0; i < std::size_t(out.size); ++i) {
      out.corner[i] = {corners[i].a, corners[i].b};
      out.share[i] = near_->share(i);
    }
  }
  // Computes w at TOI from the nearest feature before it. A radius far below |v| times the spacing of doubles
  // would cancel completely in w at a double's time. The feature's w moves by V = v across the feature, so that |w +
  // delta V| = R, or delta = c / (-b + root D) with c = w.w - R^2, b = w.V and D = b^2 - c V.V. In a face w keeps its
  // direction. In units of W and `below`, with an edge e and V = below v - (v.e) e:
  //   vertex   c = above - (R W)^2          D = (R W)^2 v.v - |w x v|^2
  //   edge     c = above - (R W)^2 below    D = ((R W)^2 |v x e|^2 - det(w, v, e)^2) below
  // In these forms of D the time cancels, and with it half of the bits.
  Dyadic3 normal_at_contact() {
    const Dyadic3 w = minus(near_->p());
    if (near_->corners().size() > 2) return w;
    const Dyadic reach = radius_ * near_->weight(), square = reach * reach, &below = near_->below();
    Dyadic3 across = v_;
    Dyadic under;
    if (near_->corners().size() == 2) {
      const Dyadic3 e = detail::difference(near_->corner(1), near_->corner(0)), level = cross(v_, e);
      const Dyadic beside = dot(near_->corner(0), level);
      across = detail::difference(detail::times(below, v_), detail::times(dot(v_, e), e));
      under = (square * dot(level, level) - beside * beside) * below;
    } else {
      const Dyadic3 beside = cross(w, v_);
      under = square * dot(v_, v_) - dot(beside, beside);
    }
    const Dyadic root = root_up(under), c = near_->above() - square * below;
    const Dyadic3 kept = detail::times(root - dot(w, v_), w), moved = detail::times(c, across);
    Dyadic3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      out[i] = kept[i] + moved[i];
      check(out[i]);
    }
    return out;
  }

  // ---- a graze ----

  // A vertex of one body in the plane of v and u: x = (c.v, c.u).
  struct Flat {
    std::uint32_t vertex;
    Exact x;
  };
  [[nodiscard]] std::vector<Flat> face_of(const Body<S>& body, const Dyadic3& n, const Dyadic3& u) {
    std::vector<Flat> out;
    for (const std::uint32_t k : exact_farthest(body, n, true, valid_)) {
      Exact x = posed(body, k);
      x.x = {dot(x.x, v_), dot(x.x, u), Dyadic()};
      out.push_back({k, x});
    }
    return out;
  }
  // The farthest along d, and of these along d_2.
  [[nodiscard]] const Flat& extreme(const std::vector<Flat>& face, const Dyadic3& d, const Dyadic3& d_2) {
    const Flat* best = &face.front();
    for (const Flat& one : face) {
      Exact step = one.x;
      step.add(best->x, true);
      const int sign = check(dot(step.x, d));
      if (sign > 0 || (sign == 0 && check(dot(step.x, d_2)) > 0)) best = &one;
    }
    return *best;
  }
  RoundContact graze() {
    RoundContact out;
    if (sign_of_rate() != 0) {
      const double end = as_double(to_);
      out.toi = {end, end};
      out.normal = separating();
      take_corners(out);
      return out;
    }
    out.normal = axis_of_graze();
    const auto [low, high] = first_edge(out.normal);
    const int side_of_low = low.x.x[1].sign(), side_of_high = high.x.x[1].sign();
    if (side_of_low == 0 || side_of_high == 0) {
      const GrazeCorner& at = side_of_low == 0 ? low : high;
      out.corner[0] = at.name;
      out.size = 1;
      out.share = {1, 0, 0};
      out.toi = bracket_of({at.x.x[0], dot(v_, v_) * at.x.weight});
      return out;
    }
    out.corner = {low.name, high.name};
    const Dyadic before = -low.x.x[1] * high.x.weight, after = high.x.x[1] * low.x.weight;
    const Dyadic all = before + after;
    out.size = 2;
    out.share = {ratio(after, all), ratio(before, all), 0};
    const ExactTime time{(low.x.x[0] * high.x.x[1]) - (high.x.x[0] * low.x.x[1]), all * dot(v_, v_)};
    check(time.numerator);
    check(time.denominator);
    if (valid_) out.toi = bracket_of(time);
    return out;
  }
  // The step between two vertices of K, times v.
  [[nodiscard]] Dyadic3 across_motion(const Id& from, const Id& to) {
    Exact step = difference(to);
    step.add(difference(from), true);
    const Dyadic3 out = cross(step.x, v_);
    for (const Dyadic& one : out) check(one);
    return out;
  }
  // A positive multiple of w, which is across v and the feature's edges. It is shorter than p.
  [[nodiscard]] Dyadic3 axis_of_graze() {
    const auto corners = near_->corners();
    for (const Id& id : corners.subspan(1)) {
      const Dyadic3 across = across_motion(corners[0], id);
      if (!is_zero(across)) return dot(across, near_->p()).sign() < 0 ? across : minus(across);
    }
    const Dyadic3 c = difference(corners[0]).x;
    return detail::difference(detail::times(dot(c, v_), v_), detail::times(dot(v_, v_), c));
  }
  // K's face towards w, in its plane: c.v is a time times v.v, and c.u is 0 on the path. The edge that the path meets
  // first, from c.u <= 0 to c.u >= 0: no point of the face is before its line. An end on the path is the first contact.
  // Both ends are one vertex if the whole face is on the path.
  struct GrazeCorner {
    Vertex name;
    Exact x;
  };
  struct FaceEdge {
    GrazeCorner low, high;
  };
  [[nodiscard]] FaceEdge first_edge(const Dyadic3& w) {
    const Dyadic3 u = cross(w, v_);
    const std::vector<Flat> of_a = face_of(a_, w, u), of_b = face_of(b_, minus(w), u);
    const auto corner = [&](const Dyadic3& d, const Dyadic3& d_2) {
      const Flat& a = extreme(of_a, d, d_2);
      const Flat& b = extreme(of_b, minus(d), minus(d_2));
      GrazeCorner c{{a.vertex, b.vertex}, a.x};
      c.x.add(b.x, true);
      return c;
    };
    const Dyadic one(1), none(0);
    const Dyadic3 early = {-one, none, none};
    GrazeCorner low = corner({none, -one, none}, early), high = corner({none, one, none}, early);
    while (valid_ && low.x.x[1].sign() != high.x.x[1].sign()) {
      // Across the line from low to high, towards earlier.
      Exact e = high.x;
      e.add(low.x, true);
      const Dyadic3 d = {-e.x[1], e.x[0], none};
      const GrazeCorner next = corner(d, early);
      Exact step = next.x;
      step.add(low.x, true);
      if (check(dot(step.x, d)) <= 0) return {low, high};
      (next.x.x[1].sign() > 0 ? high : low) = next;
    }
    return {low, low};
  }

  // A few are needed, and 54 at a graze, at which each step halves the remainder.
  static constexpr int kNewton = 64;
  // From a time that is right to a float: two of Newton's steps, and the neighbours.
  static constexpr int kSteps = 8;

  const Body<S>&a_, &b_;
  Dyadic radius_, balls_, from_, to_;
  Dyadic3 v_;
  std::optional<Points> points_;
  std::optional<Nearest> near_;
  std::vector<Id> seeds_ = {Id{}};
  int supports_ = 0;  // of K, in exact numbers
  bool valid_ = true;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
