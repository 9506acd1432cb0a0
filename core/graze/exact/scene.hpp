// Two posed polytopes as exact vectors, each to be had in two arithmetics beyond plain doubles.
//
// A vertex of C is named by a vertex of A and one of B (shape.hpp has the indices). What the cast decides is
// the sign of a determinant of three terms: points of C, their differences, v, triples of doubles.
//
//   fine    pairs of doubles (pair.hpp):  each coordinate within 2^-92 size, size >= |x_i|;
//   exact   dyadic numbers;
// both times a positive weight, the |q|^2 of the rotations in it, so that nothing is divided.
//
// Lengths are in the pair's internal unit, 2^k of the caller's, and v in its own, 2^j (cso.hpp).   Frame:
// world axes.   Range: magnitudes 1e-60 to 1e60.
//
// Rounding of `fine`. A difference of two coordinates of a leaf is exact (two_sum); a rotation adds 2^-97 of
// `size`, what was added before anything cancelled, a sum or a weight 2^-99: a way out has at most 17 of the
// one and a few of the other for each leaf, below 2^-92 for up to 16 leaves (more are refused).
//
// A grid: every coordinate of an unrotated term is a multiple of 2^grid. A determinant is one of 2^(sum of
// the three), so what is below that is 0: that decides the ties of numbers of few bits.
#pragma once

#include <graze/body.hpp>
#include <graze/combinator.hpp>
#include <graze/exact/dyadic.hpp>
#include <graze/exact/pair.hpp>
#include <vector>

namespace graze::exact {

// Of C.
struct Vertex {
  std::uint32_t a, b;
  friend bool operator==(const Vertex&, const Vertex&) = default;
};

// Is the shape one that the exact tier knows?
template <Scalar S>
bool is_exact(const Shape<S>& shape) {
  const auto all = [](std::span<const SharedShape<S>> parts) {
    return std::all_of(parts.begin(), parts.end(),
                       [](const SharedShape<S>& part) { return is_exact<S>(part->shape); });
  };
  return std::visit(
      detail::Overloaded{[](const Point<S>&) { return true; }, [](const Segment<S>&) { return true; },
                         [](const Triangle<S>&) { return true; }, [](const Box<S>&) { return true; },
                         [](const Hull<S>&) { return true; },
                         [&](const Posed<S>& s) { return all(std::span(&s.shape, 1)); },
                         [&](const Sum<S>& s) { return all(s.shapes); }, [](const auto&) { return false; }},
      shape);
}

// One summand of C: sign R x for the vertices x of a shape that is no combinator. R is a product of
// rotations, outermost first; what they are moved by is in the scene's shifts.
template <Scalar S>
struct Leaf {
  enum class Kind : std::uint8_t { point, few, list, box };
  Kind kind = Kind::point;
  bool of_b = false;
  bool turned = false;
  std::uint32_t stride = 1, count = 1;  // its vertex is (body's vertex / stride) % count
  const Shape<S>* shape = nullptr;
  const Vec3<S>* list = nullptr;  // a hull's vertices
  std::array<Vec3<S>, 3> few;     // a segment's or a triangle's; of a box the half extents first
  Quaternion<double> outer = {};  // the body's
  std::vector<Quaternion<double>> inner = {};

  void init(const Shape<S>& given, bool is_of_b, const Quaternion<double>& outer_turn) {
    of_b = is_of_b;
    shape = &given;
    outer = outer_turn;
    turned = !outer.is_identity();
    if (const auto* hull = std::get_if<Hull<S>>(shape)) {
      kind = Kind::list;
      list = hull->vertices().data();
      count = static_cast<std::uint32_t>(hull->size());
    } else if (const auto* box = std::get_if<Box<S>>(shape)) {
      kind = Kind::box;
      few[0] = box->half_extents;
      count = 8;
    } else if (const auto* segment = std::get_if<Segment<S>>(shape)) {
      kind = Kind::few;
      few = {segment->a, segment->b, segment->b};
      count = 2;
    } else if (const auto* triangle = std::get_if<Triangle<S>>(shape)) {
      kind = Kind::few;
      few = {triangle->a, triangle->b, triangle->c};
      count = 3;
    }
  }

  // As given; caller's units, the leaf's own frame.
  [[nodiscard]] Vec3<double> point(std::uint32_t k) const {
    switch (kind) {
      case Kind::list:
        return list[k].template cast<double>();
      case Kind::box:
        return detail::box_vertex(Vec3<double>(few[0].template cast<double>()), k);
      case Kind::few:
        return few[k].template cast<double>();
      case Kind::point:
        break;
    }
    return Vec3<double>::Zero();
  }
  [[nodiscard]] std::uint32_t vertex(const Vertex& v) const {
    const std::uint32_t whole = of_b ? v.b : v.a;
    return stride == 1 && whole < count ? whole : whole / stride % count;
  }
  // v with another vertex of this leaf.
  [[nodiscard]] Vertex with(Vertex v, std::uint32_t k) const {
    std::uint32_t& whole = of_b ? v.b : v.a;
    whole += (k - vertex(v)) * stride;  // modulo 2^32, which cancels
    return v;
  }
};

// The same rotation, its largest component in [1, 2).
inline Quaternion<double> scaled_to_one(const Quaternion<double>& q) {
  const double largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  const int shift = -exponent_of(largest);
  const double scale = power_of_two(shift);  // exact: the range is that of valid input
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

// An exact vector.
struct Term {
  enum class Kind : std::uint8_t {
    motion,      // v
    given,       // a triple of doubles
    point,       // of C: to
    difference,  // to - from, both of C
    step,        // of a leaf, as part of C: from its vertex k to its vertex l
    inside,      // around[0] + around[1] + around[2] - 3 from
  };
  Kind kind;
  // What the kind needs of these; the rest is not set.
  Vertex from, to;
  std::uint32_t leaf, k, l;
  std::array<Vertex, 3> around;
  std::array<double, 3> triple;

  static Term of(Kind kind) {
    Term out;
    out.kind = kind;
    return out;
  }
  static Term motion() { return of(Kind::motion); }
  static Term given(const Vec3<double>& x) {
    Term out = of(Kind::given);
    out.triple = {x[0], x[1], x[2]};
    return out;
  }
  static Term point(const Vertex& v) {
    Term out = of(Kind::point);
    out.to = v;
    return out;
  }
  static Term difference(const Vertex& from, const Vertex& to) {
    Term out = of(Kind::difference);
    out.from = from;
    out.to = to;
    return out;
  }
  static Term step(std::uint32_t leaf, std::uint32_t k, std::uint32_t l) {
    Term out = of(Kind::step);
    out.leaf = leaf;
    out.k = k;
    out.l = l;
    return out;
  }
  static Term inside(const std::array<Vertex, 3>& around, const Vertex& from) {
    Term out = of(Kind::inside);
    out.around = around;
    out.from = from;
    return out;
  }
  [[nodiscard]] Vec3<double> given_triple() const { return {triple[0], triple[1], triple[2]}; }
};

// A vector in pairs of doubles.
struct Fine {
  Pair3 x = {Pair{0, 0}, Pair{0, 0}, Pair{0, 0}};
  double size = 0;
  Pair weight{1, 0};  // > 0
  bool weighted = false;

  // x - y, exact
  static Fine of(const Vec3<double>& x, const Vec3<double>& y) {
    Fine out;
    for (int i = 0; i < 3; ++i) {
      out.x[static_cast<std::size_t>(i)] = difference(x[i], y[i]);
      out.size = std::max(out.size, std::abs(x[i]) + std::abs(y[i]));
    }
    return out;
  }
  static Fine of(const Vec3<double>& x) {
    Fine out;
    for (int i = 0; i < 3; ++i) out.x[static_cast<std::size_t>(i)].hi = x[i];
    out.size = x.cwiseAbs().maxCoeff();
    return out;
  }
  void add(const Fine& part, bool negative) {
    if (part.weighted || weighted) return add_weighted(part, negative);
    for (std::size_t i = 0; i < 3; ++i) x[i] = x[i] + (negative ? -part.x[i] : part.x[i]);
    size += part.size;
  }

 private:
  void add_weighted(const Fine& part, bool negative) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Pair own = part.weighted ? x[i] * part.weight : x[i];
      const Pair more = weighted ? part.x[i] * weight : part.x[i];
      x[i] = own + (negative ? -more : more);
    }
    size = size * part.weight.hi + part.size * weight.hi;
    if (part.weighted) weight = weighted ? weight * part.weight : part.weight;
    weighted = true;
  }
};

// |q|^2 R(q) and |q|^2, for a q whose largest component is in [1, 2): entries within 2^-99 |q|^2.
struct FineTurn {
  std::array<Pair3, 3> row;  // not set by the default constructor
  Pair weight;

  FineTurn() = default;
  explicit FineTurn(const Quaternion<double>& q) {
    const Pair ww = product(q.w, q.w), xx = product(q.x, q.x), yy = product(q.y, q.y), zz = product(q.z, q.z);
    const auto twice = [](double a, double b, double c, double d) {
      const Pair sum = product(a, b) + product(c, d);
      return Pair{2 * sum.hi, 2 * sum.lo};
    };
    row[0] = {(ww + xx) - (yy + zz), twice(q.x, q.y, -q.w, q.z), twice(q.x, q.z, q.w, q.y)};
    row[1] = {twice(q.x, q.y, q.w, q.z), (ww + yy) - (xx + zz), twice(q.y, q.z, -q.w, q.x)};
    row[2] = {twice(q.x, q.z, -q.w, q.y), twice(q.y, q.z, q.w, q.x), (ww + zz) - (xx + yy)};
    weight = (ww + xx) + (yy + zz);
  }
  void operator()(Fine& v) const {
    v.x = {dot(row[0], v.x), dot(row[1], v.x), dot(row[2], v.x)};
    v.size *= 2 * weight.hi;  // |R x|_i <= |x|_2 < 2 |x|_inf
    v.weight = v.weighted ? v.weight * weight : weight;
    v.weighted = true;
  }
};

// A vector in dyadic numbers.
struct Exact {
  Dyadic3 x;
  Dyadic weight = Dyadic(1);  // > 0
  bool weighted = false;      // the weight is not 1

  static Exact of(const Vec3<double>& x, const Vec3<double>& y) {
    Exact out;
    for (int i = 0; i < 3; ++i) out.x[static_cast<std::size_t>(i)] = Dyadic(x[i]) - Dyadic(y[i]);
    return out;
  }
  static Exact of(const Vec3<double>& x) {
    Exact out;
    for (int i = 0; i < 3; ++i) out.x[static_cast<std::size_t>(i)] = Dyadic(x[i]);
    return out;
  }
  void add(const Exact& part, bool negative) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Dyadic more = weighted ? part.x[i] * weight : part.x[i];
      x[i] = (part.weighted ? x[i] * part.weight : x[i]) + (negative ? -more : more);
    }
    if (part.weighted) weight = weighted ? weight * part.weight : part.weight;
    weighted = weighted || part.weighted;
  }
};

struct ExactTurn {
  Quaternion<double> q;
  void operator()(Exact& e) const {
    const Dyadic w(q.w);
    const Dyadic3 u = {Dyadic(q.x), Dyadic(q.y), Dyadic(q.z)};
    const Dyadic ww = w * w, uu = dot(u, u), along = dot(u, e.x).times_power_of_two(1);
    const Dyadic straight = ww - uu, twist = w.times_power_of_two(1);
    const Dyadic3 around = cross(u, e.x);
    for (std::size_t i = 0; i < 3; ++i) e.x[i] = straight * e.x[i] + along * u[i] + twist * around[i];
    e.weight = e.weighted ? e.weight * (ww + uu) : ww + uu;
    e.weighted = true;
  }
};

// The exponent of the last bit of x that is set; kAnyGrid for 0.
inline constexpr int kAnyGrid = 100000;
inline int trailing_exponent(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t magnitude = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  return magnitude == 0 ? kAnyGrid : std::max(biased, 1) - 1075 + std::countr_zero(magnitude);
}
inline int trailing_exponent(const Vec3<double>& x) {
  return std::min({trailing_exponent(x[0]), trailing_exponent(x[1]), trailing_exponent(x[2])});
}

// Valid while the bodies live. They have passed validate(), and is_exact.
template <Scalar S>
class Scene {
 public:
  // length_exponent k, speed_exponent j.
  Scene(const Body<S>& a, const Body<S>& b, int length_exponent, int speed_exponent)
      : a_(a), b_(b), k_(length_exponent), j_(speed_exponent), unit_(power_of_two(-length_exponent)) {
    const Quaternion<double> turn_a = turn_of(a.orientation), turn_b = turn_of(b.orientation);
    if (is_leaf(a.shape) && is_leaf(b.shape)) {
      own_[0].init(a.shape, false, turn_a);
      own_[1].init(b.shape, true, turn_b);
      leaves_ = own_;
      unturned_ = !own_[0].turned && !own_[1].turned;
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

  [[nodiscard]] Fine fine(const Term& term) const {
    return unturned_ ? fine_unturned(term) : evaluate<Fine>(term);
  }
  [[nodiscard]] Exact exact(const Term& term) const {
    Exact out = evaluate<Exact>(term);
    for (const Dyadic& x : out.x) valid_ = valid_ && x.valid();
    return out;
  }

  // sign a.(b x c). |error of the fine determinant| <= 2^-87 of the product of the sizes: six products of
  // three, each of whose factors is within 2^-92, and what pairs round. The product of the sizes must leave
  // room for low parts above the least normal number.
  [[nodiscard]] int determinant_sign(const Term& a, const Term& b, const Term& c) const {
    if (has_fine()) {
      const Fine x = fine(a), y = fine(b), z = fine(c);
      const double size = x.size * y.size * z.size;
      if (size > kLeastSize && size < kMostSize) {
        const double value = rounded(dot(x.x, cross(y.x, z.x))), error = kFineError * size;
        if (value > error) return 1;
        if (value < -error) return -1;
        if (!(x.weighted || y.weighted || z.weighted)) {
          const int grid = grid_of(a) + grid_of(b) + grid_of(c);
          if (grid > -900 && std::abs(value) + error < power_of_two(std::min(grid, 0))) return 0;
        }
      }
    }
    ++exact_decisions_;
    const Exact p = exact(a), q = exact(b), r = exact(c);
    const Dyadic value = dot(p.x, cross(q.x, r.x));
    valid_ = valid_ && value.valid();
    return value.sign();
  }

  static constexpr double kLeastSize = 0x1p-700, kMostSize = 0x1p700, kFineError = 0x1p-87;
  static constexpr std::size_t kFineLeaves = 16;
  [[nodiscard]] bool has_fine() const { return leaves_.size() <= kFineLeaves; }

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
  static Quaternion<double> turn_of(const Quaternion<S>& q) {
    if (q.is_identity()) return {};
    return scaled_to_one({double(q.w), double(q.x), double(q.y), double(q.z)});
  }
  void add_body(const Body<S>& body, bool of_b, const Quaternion<double>& outer) {
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
  // The same, straight: two leaves that do not turn.
  [[nodiscard]] Fine fine_unturned(const Term& term) const {
    const Leaf<S>&a = own_[0], &b = own_[1];
    Fine out;
    const auto add = [&](const Vec3<double>& x, const Vec3<double>& y, bool negative) {
      for (int i = 0; i < 3; ++i) {
        const Pair d = negative ? difference(y[i], x[i]) : difference(x[i], y[i]);
        Pair& sum = out.x[static_cast<std::size_t>(i)];
        sum = sum + d;
      }
      out.size += std::max({std::abs(x[0]) + std::abs(y[0]), std::abs(x[1]) + std::abs(y[1]),
                            std::abs(x[2]) + std::abs(y[2])});
    };
    switch (term.kind) {
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
  [[nodiscard]] Vec3<double> at(const Leaf<S>& leaf, std::uint32_t k) const { return unit_ * leaf.point(k); }
  // Zero, exactly and of size 0, where it does not move.
  template <class V>
  [[nodiscard]] V step_of(const Leaf<S>& leaf, std::uint32_t k, std::uint32_t l) const {
    return k == l ? V() : V::of(at(leaf, l), at(leaf, k));
  }

  // out += the leaves of A, - those of B, each body's turned once; and their shifts. A point's weight must
  // not depend on which vertex it is, so nothing is left out of it; a difference has its own weight.
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
    if (q.is_identity()) return;
    if (!has_turn_[of_b]) {
      turn_[of_b] = FineTurn(q);
      has_turn_[of_b] = true;
    }
    turn_[of_b](v);
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
        [[fallthrough]];
      case Term::Kind::difference:
        take_vertex(term.from);
        take_vertex(term.to);
        break;
    }
    return grid == kAnyGrid ? 0 : grid;
  }

  const Body<S>&a_, &b_;
  int k_, j_;
  double unit_;  // 2^-k
  bool unturned_ = false;
  std::array<Leaf<S>, 2> own_;
  std::vector<Leaf<S>> more_;
  std::vector<Shift> shifts_;
  std::span<const Leaf<S>> leaves_;
  mutable std::array<FineTurn, 2> turn_;  // where has_turn_
  mutable std::array<bool, 2> has_turn_ = {false, false};
  mutable bool valid_ = true;
  mutable int exact_decisions_ = 0;
};

}  // namespace graze::exact
