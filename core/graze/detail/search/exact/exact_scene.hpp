// Represents two posed polytopes as exact vectors. Each is available in two arithmetics beyond plain doubles.
//
// The cast decides the sign of a determinant of three terms (term.hpp): points of C, their differences, v, triples of
// doubles. Each has a Fine and an Exact form (vectors.hpp).
//
// Lengths are in the pair's internal unit, 2^k of the caller's, and v in its own, 2^j (prepared_pair.hpp).   Frame:
// world axes.   Range: magnitudes 1e-60 to 1e60. A difference of two coordinates of a leaf is exact (two_sum).
//
// A grid: every coordinate of an unrotated term is a multiple of 2^grid. A determinant is a multiple of 2^(sum of the
// three), so a smaller value is 0. This decides the ties of numbers of few bits.
#pragma once

#include <graze/detail/numeric/vectors.hpp>
#include <graze/detail/search/exact/term.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// Valid while the bodies live. They have passed validate(), and is_exact.
template <Scalar S>
class Scene {
 public:
  // length_exponent k, speed_exponent j.
  Scene(const Body<S>& a, const Body<S>& b, int length_exponent, int speed_exponent)
      : a_(a), b_(b), k_(length_exponent), j_(speed_exponent), unit_(power_of_two(-length_exponent)) {
    const Quaternion<double> turn_a = turn_of(a), turn_b = turn_of(b);
    if (is_leaf(a.shape) && is_leaf(b.shape)) {
      own_[0].init(a.shape, false, turn_a);
      own_[1].init(b.shape, true, turn_b);
      leaves_ = own_;
      unturned_ = !own_[0].turned && !own_[1].turned;
      const Quaternion<double>&p = own_[0].outer, &q = own_[1].outer;
      // q and -q are one rotation.
      const auto is = [&](double sign) {
        return p.w == sign * q.w && p.x == sign * q.x && p.y == sign * q.y && p.z == sign * q.z;
      };
      alike_ = is(1) || is(-1);
      return;
    }
    add_body(a, false, turn_a);
    add_body(b, true, turn_b);
    leaves_ = more_;
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] std::span<const Leaf<S>> leaves() const { return leaves_; }
  [[nodiscard]] int length_exponent() const { return k_; }
  [[nodiscard]] int speed_exponent() const { return j_; }
  [[nodiscard]] double unit() const { return unit_; }  // 2^-k

  // `straight`: in the bodies' own axes, without their rotation. Only for terms for which is_straight() is true.
  [[nodiscard]] Fine fine(const Term& term, bool straight = false) const {
    return straight || unturned_ ? fine_unturned(term) : evaluate<Fine>(term);
  }
  [[nodiscard]] Exact exact(const Term& term, bool straight = false) const {
    Exact out = straight ? exact_unturned(term) : evaluate<Exact>(term);
    for (const Dyadic& x : out.x) valid_ = valid_ && x.valid();
    return out;
  }

  // No combinators: a body is a leaf.
  [[nodiscard]] bool is_of_two_leaves() const { return leaves_.data() == own_.data(); }
  // Are there two leaves without rotation?
  [[nodiscard]] bool is_unturned() const { return unturned_; }
  // Two leaves by the same rotation.
  [[nodiscard]] bool turned_alike() const { return alike_; }

  // sign a.(b x c). For steps and differences within one body, or within two with equal rotations, the rotation
  // cancels: det(R x, R y, R z) = det(x, y, z).
  //
  // |error of the fine determinant| <= 2^-87 of the product of the sizes: six products of three, each of whose
  // factors is within 2^-92, and the rounding of pairs. The product of the sizes must leave room for low parts above
  // the least normal number.
  [[nodiscard, gnu::noinline]] int determinant_sign(const Term& a, const Term& b, const Term& c) const {
    const bool straight = unturned_ || is_straight(a, b, c);
    if (has_fine()) {
      const Fine x = fine(a, straight), y = fine(b, straight), z = fine(c, straight);
      const double size = x.size * y.size * z.size;
      if (size > kLeastSize && size < kMostSize) {
        const double value = fuses() ? determinant<true>(x, y, z) : determinant<false>(x, y, z),
                     error = kFineError * size;
        if (value > error) return 1;
        if (value < -error) return -1;
        if (!(x.weighted || y.weighted || z.weighted)) {
          if (is_level(x, y, z)) return 0;
          const int grid = grid_of(a) + grid_of(b) + grid_of(c);
          if (grid > -900 && std::abs(value) + error < power_of_two(std::min(grid, 0))) return 0;
        }
      }
    }
    ++exact_decisions_;
    const bool own = straight && !unturned_;
    const Exact p = exact(a, own), q = exact(b, own), r = exact(c, own);
    const Dyadic value = dot(p.x, cross(q.x, r.x));
    valid_ = valid_ && value.valid();
    return value.sign();
  }

  // Is a vertex of C exactly 0 along an axis? Only decided for two leaves without rotation.
  [[nodiscard]] bool is_zero_along(int axis, const Vertex& v) const {
    if (!unturned_) return false;
    const Pair c = difference(at(own_[0], v.a)[axis], at(own_[1], v.b)[axis]),
               apart = difference(unit_ * double(b_.position[axis]), unit_ * double(a_.position[axis]));
    // Rounded sums and their remainders: equal sums have equal parts.
    return c.hi == apart.hi && c.lo == apart.lo;
  }

  // ---- of two leaves: the numbers themselves, for meeting.hpp ----

  // Internal length, own axes.
  [[nodiscard]] Vec3<double> at(const Leaf<S>& leaf, std::uint32_t k) const { return unit_ * leaf.point(k); }
  // p_A - p_B and v, exactly.
  [[nodiscard]] Pair3 apart() const { return scaled_difference(unit_, a_.position, b_.position); }
  [[nodiscard]] Pair3 motion() const {
    return scaled_difference(power_of_two(-j_), b_.displacement, a_.displacement);
  }
  // The rotation of a rotated body.
  [[nodiscard]] const FineTurn& turn(bool of_b) const { return turn(of_b, own_[of_b].outer); }
  // det(a, b, c) - s det(a, b, d) is a multiple of 2^grid. The grid is far below the range of doubles if it is
  // unknown.
  [[nodiscard]] int grid_of_rest(const Term& a, const Term& b, const Term& c, const Term& d, double s) const {
    if (!unturned_) return -kAnyGrid;
    return grid_of(a) + grid_of(b) + std::min(grid_of(c), grid_of(d) + trailing_exponent(s));
  }

  // Is each term a step or a difference of bodies with one rotation only?
  [[nodiscard]] bool is_straight(const Term& a, const Term& b, const Term& c) const {
    if (!is_of_two_leaves()) return false;
    std::array<bool, 2> takes_part = {false, false};
    for (const Term* const term : {&a, &b, &c}) {
      if (term->kind == Term::Kind::step) {
        takes_part[leaves_[term->leaf].of_b] = true;
      } else if (term->kind == Term::Kind::difference) {
        takes_part[0] = takes_part[0] || term->from.a != term->to.a;
        takes_part[1] = takes_part[1] || term->from.b != term->to.b;
      } else {
        return false;
      }
    }
    return alike_ || !(takes_part[0] && takes_part[1]);
  }
  // The rotation of a body with that orientation.
  const FineTurn& turn(bool of_b, const Quaternion<double>& q) const {
    if (!has_turn_[of_b]) {
      turn_[of_b] = FineTurn(q);
      has_turn_[of_b] = true;
    }
    return turn_[of_b];
  }

  // Every coordinate of an unturned term is a multiple of 2^grid.
  [[nodiscard]] int grid_of(const Term& term) const {
    int grid = kAnyGrid;
    const auto take = [&](const Vec3<double>& x) { grid = std::min(grid, trailing_exponent(x)); };
    const auto take_vertex = [&](const Vertex& v) {
      for (const Leaf<S>& leaf : leaves_) take(at(leaf, leaf.vertex(v)));
    };
    switch (term.kind) {
      case Term::Kind::motion:
        take(Vec3<double>(power_of_two(-j_) * a_.displacement.template cast<double>()));
        take(Vec3<double>(power_of_two(-j_) * b_.displacement.template cast<double>()));
        break;
      case Term::Kind::given:
        take(term.given_triple());
        break;
      case Term::Kind::step:
        take(at(leaves_[term.leaf], term.k));
        take(at(leaves_[term.leaf], term.l));
        break;
      case Term::Kind::point:
        take(Vec3<double>(unit_ * a_.position.template cast<double>()));
        take(Vec3<double>(unit_ * b_.position.template cast<double>()));
        for (const Shift& s : shifts_) take(Vec3<double>(unit_ * s.by));
        take_vertex(term.to);
        break;
      case Term::Kind::inside:
        for (const Vertex& v : term.around) take_vertex(v);
        take_vertex(term.from);
        break;
      case Term::Kind::difference:
        take_vertex(term.from);
        take_vertex(term.to);
        break;
    }
    return grid == kAnyGrid ? 0 : grid;
  }

  static constexpr double kLeastSize = 0x1p-700, kMostSize = 0x1p700, kFineError = 0x1p-87;
  // Number of summands of a point: a part of each leaf, each shift, and the bodies' positions.
  static constexpr std::size_t kFineParts = 16;
  [[nodiscard]] bool has_fine() const { return leaves_.size() + shifts_.size() + 1 <= kFineParts; }

  // False once a number outgrew Dyadic: no sign may be trusted then.
  [[nodiscard]] bool valid() const { return valid_; }
  void invalidate() const { valid_ = false; }
  // How often pairs of doubles did not decide.
  [[nodiscard]] int exact_decisions() const { return exact_decisions_; }
  void count_exact_decision() const { ++exact_decisions_; }

 private:
  struct Shift {
    Vec3<double> by;
    bool of_b;
    std::vector<Quaternion<double>> inner;
  };

  static bool is_leaf(const Shape<S>& shape) {
    return !std::holds_alternative<Posed<S>>(shape) && !std::holds_alternative<Sum<S>>(shape);
  }
  // A rotation of a point about itself has no effect.
  static Quaternion<double> turn_of(const Body<S>& body) {
    const Shape<S>& core = without_ball(body.shape);
    const bool is_point = std::holds_alternative<Point<S>>(core) || std::holds_alternative<Sphere<S>>(core);
    return is_point ? Quaternion<double>{} : turn_of(body.orientation);
  }
  static Quaternion<double> turn_of(const Quaternion<S>& q) {
    if (q.is_identity()) return {};
    return scaled_to_one({double(q.w), double(q.x), double(q.y), double(q.z)});
  }
  [[gnu::noinline]] void add_body(const Body<S>& body, bool of_b, const Quaternion<double>& outer) {
    const std::size_t first = more_.size();
    std::vector<Quaternion<double>> inner;
    add_parts(body.shape, of_b, outer, inner);
    // The last part's index counts fastest.
    std::uint32_t stride = 1;
    for (std::size_t i = more_.size(); i-- > first;) {
      more_[i].stride = stride;
      stride *= more_[i].count;
    }
  }
  void add_parts(const Shape<S>& shape, bool of_b, const Quaternion<double>& outer,
                 std::vector<Quaternion<double>>& inner) {
    if (const auto* posed = std::get_if<Posed<S>>(&shape)) {
      const Vec3<double> by = posed->position.template cast<double>();
      if (by != Vec3<double>::Zero()) shifts_.push_back({by, of_b, inner});
      const bool turns = !posed->orientation.is_identity();
      if (turns) inner.push_back(turn_of(posed->orientation));
      add_parts(posed->shape->shape, of_b, outer, inner);
      if (turns) inner.pop_back();
    } else if (const auto* sum = std::get_if<Sum<S>>(&shape)) {
      for (const SharedShape<S>& part : sum->shapes) add_parts(part->shape, of_b, outer, inner);
    } else {
      more_.emplace_back();
      more_.back().init(shape, of_b, outer);
      more_.back().inner = inner;
      more_.back().turned = more_.back().turned || !inner.empty();
    }
  }

  // ---- terms, in either arithmetic ----

  template <class V>
  [[nodiscard]] V evaluate(const Term& term) const {
    switch (term.kind) {
      case Term::Kind::motion: {
        const double unit = power_of_two(-j_);
        return V::of(Vec3<double>(unit * b_.displacement.template cast<double>()),
                     Vec3<double>(unit * a_.displacement.template cast<double>()));
      }
      case Term::Kind::given:
        return V::of(term.given_triple());
      case Term::Kind::step: {
        const Leaf<S>& leaf = leaves_[term.leaf];
        V out;
        V part = turned_inside<V>(step_of<V>(leaf, term.k, term.l), leaf.inner);
        turn_outside(part, leaf.outer, leaf.of_b);
        out.add(part, leaf.of_b);
        return out;
      }
      case Term::Kind::point: {
        V out = V::of(Vec3<double>(unit_ * a_.position.template cast<double>()),
                      Vec3<double>(unit_ * b_.position.template cast<double>()));
        add_bodies(
            out, [&](const Leaf<S>& leaf) { return V::of(at(leaf, leaf.vertex(term.to))); }, true);
        return out;
      }
      case Term::Kind::difference: {
        V out;
        add_bodies(
            out,
            [&](const Leaf<S>& leaf) {
              return step_of<V>(leaf, leaf.vertex(term.from), leaf.vertex(term.to));
            },
            false);
        return out;
      }
      case Term::Kind::inside:
        break;
    }
    V out;
    add_bodies(
        out,
        [&](const Leaf<S>& leaf) {
          V sum;
          for (const Vertex& v : term.around)
            sum.add(step_of<V>(leaf, leaf.vertex(term.from), leaf.vertex(v)), false);
          return sum;
        },
        false);
    return out;
  }
  template <bool kFused>
  [[nodiscard, gnu::flatten, gnu::noinline]] static double determinant(const Fine& x, const Fine& y,
                                                                       const Fine& z) {
    return rounded(dot(pairs_as<kFused>(x.x), cross(pairs_as<kFused>(y.x), pairs_as<kFused>(z.x))));
  }
  // All three in one plane across an axis: a row of the determinant is 0.
  [[nodiscard]] static bool is_level(const Fine& x, const Fine& y, const Fine& z) {
    const auto is_zero = [](const Pair& p) { return p.hi == 0 && p.lo == 0; };
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_zero(x.x[i]) && is_zero(y.x[i]) && is_zero(z.x[i])) return true;
    }
    return false;
  }
  // A step or a difference of two leaves, in their own axes.
  [[nodiscard]] Exact exact_unturned(const Term& term) const {
    Exact out;
    const auto add = [&](const Leaf<S>& leaf, std::uint32_t from, std::uint32_t to) {
      if (from != to) out.add(step_of<Exact>(leaf, from, to), leaf.of_b);
    };
    if (term.kind == Term::Kind::step) {
      add(leaves_[term.leaf], term.k, term.l);
    } else {
      add(own_[0], term.from.a, term.to.a);
      add(own_[1], term.from.b, term.to.b);
    }
    return out;
  }
  // The same, straight: two leaves without rotation.
  [[nodiscard]] Fine fine_unturned(const Term& term) const {
    const Leaf<S>&a = own_[0], &b = own_[1];
    Fine out;
    const auto add = [&](const Vec3<double>& x, const Vec3<double>& y, bool negative) {
      double size = 0;
      for (int i = 0; i < 3; ++i) {
        const Pair d = negative ? difference(y[i], x[i]) : difference(x[i], y[i]);
        size = std::max(size, Fine::size_of(d));
        Pair& sum = out.x[static_cast<std::size_t>(i)];
        sum = sum + d;
      }
      out.size += size;
    };
    switch (term.kind) {
      case Term::Kind::step: {
        const Leaf<S>& leaf = leaves_[term.leaf];
        if (term.k != term.l) add(at(leaf, term.l), at(leaf, term.k), leaf.of_b);
        return out;
      }
      case Term::Kind::difference:
        if (term.from.a != term.to.a) add(at(a, term.to.a), at(a, term.from.a), false);
        if (term.from.b != term.to.b) add(at(b, term.to.b), at(b, term.from.b), true);
        return out;
      case Term::Kind::point:
        add(at(a, term.to.a), at(b, term.to.b), false);
        add(unit_ * triple_of(a_.position), unit_ * triple_of(b_.position), false);
        return out;
      default:
        return evaluate<Fine>(term);
    }
  }
  [[nodiscard]] static Vec3<double> triple_of(const Vec3<S>& x) { return x.template cast<double>(); }
  [[nodiscard]] static Pair3 scaled_difference(double unit, const Vec3<S>& x, const Vec3<S>& y) {
    const auto at = [&](int i) { return difference(unit * double(x[i]), unit * double(y[i])); };
    return {at(0), at(1), at(2)};
  }
  // Zero, exactly and of size 0, if it does not move.
  template <class V>
  [[nodiscard]] V step_of(const Leaf<S>& leaf, std::uint32_t k, std::uint32_t l) const {
    return k == l ? V() : V::of(at(leaf, l), at(leaf, k));
  }

  // out += the leaves of A, - those of B, each body's rotated once, and their shifts. A point's weight must not
  // depend on the choice of the vertex, so every factor stays in it. A difference has its own weight.
  template <class V, class Part>
  void add_bodies(V& out, const Part& part_of, bool shifted) const {
    for (const bool of_b : {false, true}) {
      V sum;
      const Leaf<S>* any = nullptr;
      for (const Leaf<S>& leaf : leaves_) {
        if (leaf.of_b != of_b) continue;
        any = &leaf;
        V part = part_of(leaf);
        if (shifted || !is_zero(part)) sum.add(turned_inside<V>(std::move(part), leaf.inner), false);
      }
      if (shifted) {
        for (const Shift& s : shifts_) {
          if (s.of_b == of_b) sum.add(turned_inside<V>(V::of(Vec3<double>(unit_ * s.by)), s.inner), false);
        }
      }
      if (!shifted && is_zero(sum)) continue;
      turn_outside(sum, any->outer, of_b);
      out.add(sum, of_b);
    }
  }
  [[nodiscard]] static bool is_zero(const Fine& v) { return v.size == 0; }
  [[nodiscard]] static bool is_zero(const Exact& v) {
    return v.x[0].sign() == 0 && v.x[1].sign() == 0 && v.x[2].sign() == 0;
  }
  template <class V>
  [[nodiscard]] static V turned_inside(V v, const std::vector<Quaternion<double>>& inner) {
    for (auto q = inner.rbegin(); q != inner.rend(); ++q) {
      if constexpr (std::same_as<V, Fine>) {
        FineTurn{*q}(v);
      } else {
        ExactTurn{*q}(v);
      }
    }
    return v;
  }
  void turn_outside(Exact& v, const Quaternion<double>& q, bool) const {
    if (!q.is_identity()) ExactTurn{q}(v);
  }
  void turn_outside(Fine& v, const Quaternion<double>& q, bool of_b) const {
    if (!q.is_identity()) turn(of_b, q)(v);
  }

  const Body<S>&a_, &b_;
  int k_, j_;
  double unit_;                            // 2^-k
  bool unturned_ = false, alike_ = false;  // two leaves: neither is rotated, both have one rotation
  std::array<Leaf<S>, 2> own_;
  std::vector<Leaf<S>> more_;
  std::vector<Shift> shifts_;
  std::span<const Leaf<S>> leaves_;
  mutable std::array<FineTurn, 2> turn_;  // where has_turn_
  mutable std::array<bool, 2> has_turn_ = {false, false};
  mutable bool valid_ = true;
  mutable int exact_decisions_ = 0;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
