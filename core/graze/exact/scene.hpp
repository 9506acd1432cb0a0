// Two posed polytopes as exact vectors, each to be had in two arithmetics beyond plain doubles.
//
// A vertex of C is named by a vertex of A and one of B (shape.hpp has the indices). What the cast decides is
// the sign of a determinant of three terms: points of C, their differences, v, triples of doubles.
//
//   fine    pairs of doubles (offset.hpp):  each coordinate within 2^-92 size, size >= |x_i|;
//   exact   dyadic numbers, times a positive weight (the |q|^2 of the rotations in it).
//
// Lengths are in the pair's internal unit, 2^k of the caller's, and v in its own, 2^j (cso.hpp).   Frame:
// world axes.   Range: magnitudes 1e-60 to 1e60.
//
// Rounding of `fine`. A difference of two coordinates of a leaf is exact (two_sum); each rotation on the way
// out, at most kMaxNesting + 1, and each sum is within 2^-98 relatively to `size`, what was added before
// anything cancelled: 18 of them make less than 2^-93.
//
// A grid: every coordinate of an unrotated term is a multiple of 2^grid. A determinant is one of 2^(sum of
// the three), so what is below that is 0: that decides the ties of numbers of few bits.
#pragma once

#include <graze/body.hpp>
#include <graze/combinator.hpp>
#include <graze/exact/dyadic.hpp>
#include <graze/exact/expansion.hpp>
#include <graze/offset.hpp>
#include <vector>

namespace graze::exact {

// Of C.
struct Vertex {
  std::uint32_t a = 0, b = 0;
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
  const Shape<S>* shape = nullptr;
  bool of_b = false;
  std::uint32_t stride = 1, count = 1;  // its vertex is (body's vertex / stride) % count
  Quaternion<double> outer = {};        // the body's
  std::vector<Quaternion<double>> inner = {};

  [[nodiscard]] std::uint32_t vertex(const Vertex& v) const { return (of_b ? v.b : v.a) / stride % count; }
  // v with another vertex of this leaf.
  [[nodiscard]] Vertex with(Vertex v, std::uint32_t k) const {
    std::uint32_t& whole = of_b ? v.b : v.a;
    whole += (k - vertex(v)) * stride;  // modulo 2^32, which cancels
    return v;
  }
  [[nodiscard]] bool turned() const { return !outer.is_identity() || !inner.empty(); }
};

// The same rotation, its largest component in [1, 2).
inline Quaternion<double> scaled_to_one(const Quaternion<double>& q) {
  const double largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  const int shift = -std::ilogb(largest);
  return {std::ldexp(q.w, shift), std::ldexp(q.x, shift), std::ldexp(q.y, shift), std::ldexp(q.z, shift)};
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
  Kind kind = Kind::motion;
  Vec3<double> triple = Vec3<double>::Zero();
  Vertex from = {}, to = {};
  std::uint32_t leaf = 0, k = 0, l = 0;
  std::array<Vertex, 3> around = {};

  static Term motion() { return {}; }
  static Term given(const Vec3<double>& x) { return {.kind = Kind::given, .triple = x}; }
  static Term point(const Vertex& v) { return {.kind = Kind::point, .to = v}; }
  static Term difference(const Vertex& from, const Vertex& to) {
    return {.kind = Kind::difference, .from = from, .to = to};
  }
  static Term step(std::uint32_t leaf, std::uint32_t k, std::uint32_t l) {
    return {.kind = Kind::step, .leaf = leaf, .k = k, .l = l};
  }
  static Term inside(const std::array<Vertex, 3>& around, const Vertex& from) {
    return {.kind = Kind::inside, .from = from, .around = around};
  }
};

inline constexpr int kNoGrid = -100000, kAnyGrid = 100000;

struct Fine {
  detail::TwoDoubles3 x = {};
  double size = 0;
  int grid = kAnyGrid;  // kNoGrid: none is known

  [[nodiscard]] Vec3<double> rounded() const { return {x[0].hi, x[1].hi, x[2].hi}; }
};

struct Exact {
  Dyadic3 x;
  Dyadic weight = Dyadic(1);  // > 0
  bool weighted = false;      // the weight is not 1
};

// R(q) c, each coordinate within 2^-98 |c|: rotate_accurately of pairs.
inline detail::TwoDoubles3 rotate_pairs(const Quaternion<double>& q, const detail::TwoDoubles3& c) {
  const detail::TwoDoubles w{q.w, 0}, u[3] = {{q.x, 0}, {q.y, 0}, {q.z, 0}};
  const detail::TwoDoubles norm = (detail::two_product(q.w, q.w) + detail::two_product(q.x, q.x)) +
                                  (detail::two_product(q.y, q.y) + detail::two_product(q.z, q.z));
  const auto cross = [&](const detail::TwoDoubles3& x) {
    detail::TwoDoubles3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      out[i] = u[j] * x[k] + -(u[k] * x[j]);
    }
    return out;
  };
  const detail::TwoDoubles3 once = cross(c), twice = cross(once);
  detail::TwoDoubles3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    const detail::TwoDoubles turned = (w * once[i] + twice[i]) / norm;
    out[i] = c[i] + (turned + turned);
  }
  return out;
}

// |q|^2 R(q) x
inline void rotate_exactly(const Quaternion<double>& q, Exact& e) {
  const Dyadic w(q.w);
  const Dyadic3 u = {Dyadic(q.x), Dyadic(q.y), Dyadic(q.z)};
  const Dyadic ww = w * w, uu = dot(u, u), along = dot(u, e.x).times_power_of_two(1);
  const Dyadic straight = ww - uu, twist = w.times_power_of_two(1);
  const Dyadic3 around = cross(u, e.x);
  for (std::size_t i = 0; i < 3; ++i) e.x[i] = straight * e.x[i] + along * u[i] + twist * around[i];
  e.weight = e.weighted ? e.weight * (ww + uu) : ww + uu;
  e.weighted = true;
}

// The exponent of the last bit of x that is set.
inline int trailing_exponent(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t magnitude = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  return magnitude == 0 ? kAnyGrid : std::max(biased, 1) - 1075 + std::countr_zero(magnitude);
}

template <Scalar S>
std::uint32_t leaf_count(const Shape<S>& shape) {
  return std::visit(detail::Overloaded{[](const Segment<S>&) -> std::uint32_t { return 2; },
                                       [](const Triangle<S>&) -> std::uint32_t { return 3; },
                                       [](const Box<S>&) -> std::uint32_t { return 8; },
                                       [](const Hull<S>& h) { return static_cast<std::uint32_t>(h.size()); },
                                       [](const auto&) -> std::uint32_t { return 1; }},
                    shape);
}

// As given; caller's units.
template <Scalar S>
Vec3<double> leaf_vertex(const Shape<S>& shape, std::uint32_t k) {
  const auto wide = [](const Vec3<S>& x) -> Vec3<double> { return x.template cast<double>(); };
  return std::visit(
      detail::Overloaded{[&](const Segment<S>& s) { return wide(k == 0 ? s.a : s.b); },
                         [&](const Triangle<S>& s) {
                           return wide(k == 0 ? s.a : k == 1 ? s.b : s.c);
                         },
                         [&](const Box<S>& s) { return detail::box_vertex(wide(s.half_extents), k); },
                         [&](const Hull<S>& s) { return wide(s.vertex(k)); },
                         [](const auto&) -> Vec3<double> { return Vec3<double>::Zero(); }},
      shape);
}

// Valid while the bodies live. They have passed validate(), and is_exact.
template <Scalar S>
class Scene {
 public:
  // length_exponent k, speed_exponent j.
  Scene(const Body<S>& a, const Body<S>& b, int length_exponent, int speed_exponent)
      : a_(a), b_(b), k_(length_exponent), j_(speed_exponent) {
    if (is_leaf(a.shape) && is_leaf(b.shape)) {
      own_[0] = leaf_of(a, false);
      own_[1] = leaf_of(b, true);
      leaves_ = own_;
      return;
    }
    add_body(a, false);
    add_body(b, true);
    leaves_ = more_;
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] std::span<const Leaf<S>> leaves() const { return leaves_; }
  [[nodiscard]] int length_exponent() const { return k_; }
  [[nodiscard]] int speed_exponent() const { return j_; }

  [[nodiscard]] Fine fine(const Term& term) const {
    Fine out;
    switch (term.kind) {
      case Term::Kind::motion:
        add_shift(out, b_.displacement, a_.displacement, j_);
        break;
      case Term::Kind::given:
        for (int i = 0; i < 3; ++i) {
          out.x[static_cast<std::size_t>(i)] = {term.triple[i], 0};
          out.size = std::max(out.size, std::abs(term.triple[i]));
          out.grid = std::min(out.grid, trailing_exponent(term.triple[i]));
        }
        break;
      case Term::Kind::point:
        add_point(out, term.to, 1);
        break;
      case Term::Kind::difference:
        add_difference(out, term.from, term.to);
        break;
      case Term::Kind::step:
        add_step(out, leaves_[term.leaf], term.k, term.l);
        break;
      case Term::Kind::inside:
        for (const Vertex& v : term.around) add_difference(out, term.from, v);
        break;
    }
    return out;
  }

  [[nodiscard]] Exact exact(const Term& term) const {
    Exact out;
    switch (term.kind) {
      case Term::Kind::motion:
        add_exactly(out, difference_of(b_.displacement, a_.displacement), -j_);
        break;
      case Term::Kind::given:
        for (std::size_t i = 0; i < 3; ++i) out.x[i] = Dyadic(term.triple[static_cast<int>(i)]);
        break;
      case Term::Kind::point:
        add_exactly(out, difference_of(a_.position, b_.position), -k_);
        for (const Shift& s : shifts_) {
          Exact part;
          for (std::size_t i = 0; i < 3; ++i) part.x[i] = Dyadic(s.by[static_cast<int>(i)]);
          turn_exactly(part, s.outer, s.inner);
          add_exactly(out, part, -k_, s.of_b);
        }
        for (const Leaf<S>& leaf : leaves_) {
          Exact part;
          const Vec3<double> x = leaf_vertex(*leaf.shape, leaf.vertex(term.to));
          for (std::size_t i = 0; i < 3; ++i) part.x[i] = Dyadic(x[static_cast<int>(i)]);
          turn_exactly(part, leaf.outer, leaf.inner);
          add_exactly(out, part, -k_, leaf.of_b);
        }
        break;
      case Term::Kind::difference:
        for (const Leaf<S>& leaf : leaves_) {
          add_step_exactly(out, leaf, leaf.vertex(term.from), leaf.vertex(term.to));
        }
        break;
      case Term::Kind::step:
        add_step_exactly(out, leaves_[term.leaf], term.k, term.l);
        break;
      case Term::Kind::inside:
        // All of one weight: the same leaves, whether they step or not.
        for (const Leaf<S>& leaf : leaves_) {
          Exact part;
          for (const Vertex& v : term.around) {
            const Dyadic3 d = step_of(leaf, leaf.vertex(term.from), leaf.vertex(v));
            for (std::size_t i = 0; i < 3; ++i) part.x[i] = part.x[i] + d[i];
          }
          turn_exactly(part, leaf.outer, leaf.inner);
          add_exactly(out, part, -k_, leaf.of_b);
        }
        break;
    }
    for (const Dyadic& x : out.x) valid_ = valid_ && x.valid();
    return out;
  }

  // sign a.(b x c). |error of the fine determinant| <= 2^-87 of the product of the sizes: six products of
  // three, each of whose factors is within 2^-92, and what pairs round. The product of the sizes must leave
  // room for low parts above the least normal number.
  [[nodiscard]] int determinant_sign(const Term& a, const Term& b, const Term& c) const {
    const Fine x = fine(a), y = fine(b), z = fine(c);
    const double size = x.size * y.size * z.size;
    if (size > kLeastSize && size < kMostSize) {
      detail::TwoDoubles sum;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        sum = sum + x.x[i] * (y.x[j] * z.x[k] + -(y.x[k] * z.x[j]));
      }
      const double error = kFineError * size;
      if (sum.hi > error) return 1;
      if (sum.hi < -error) return -1;
      const int grid = x.grid + y.grid + z.grid;
      if (std::min({x.grid, y.grid, z.grid}) > kNoGrid && grid > -900 &&
          std::abs(sum.hi) + error < std::ldexp(1.0, std::min(grid, 0))) {
        return 0;
      }
    }
    ++exact_decisions_;
    const Exact p = exact(a), q = exact(b), r = exact(c);
    const Dyadic value = dot(p.x, cross(q.x, r.x));
    valid_ = valid_ && value.valid();
    return value.sign();
  }

  static constexpr double kLeastSize = 0x1p-700, kMostSize = 0x1p700, kFineError = 0x1p-87;

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
    Quaternion<double> outer;
    std::vector<Quaternion<double>> inner;
  };

  static bool is_leaf(const Shape<S>& shape) {
    return !std::holds_alternative<Posed<S>>(shape) && !std::holds_alternative<Sum<S>>(shape);
  }
  static Quaternion<double> turn_of(const Quaternion<S>& q) {
    if (q.is_identity()) return {};
    return scaled_to_one({double(q.w), double(q.x), double(q.y), double(q.z)});
  }
  static Leaf<S> leaf_of(const Body<S>& body, bool of_b) {
    return {.shape = &body.shape,
            .of_b = of_b,
            .count = leaf_count(body.shape),
            .outer = turn_of(body.orientation)};
  }
  void add_body(const Body<S>& body, bool of_b) {
    const std::size_t first = more_.size();
    std::vector<Quaternion<double>> inner;
    add_parts(body.shape, of_b, turn_of(body.orientation), inner);
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
      if (by != Vec3<double>::Zero()) shifts_.push_back({by, of_b, outer, inner});
      const bool turns = !posed->orientation.is_identity();
      if (turns) inner.push_back(turn_of(posed->orientation));
      add_parts(posed->shape->shape, of_b, outer, inner);
      if (turns) inner.pop_back();
    } else if (const auto* sum = std::get_if<Sum<S>>(&shape)) {
      for (const SharedShape<S>& part : sum->shapes) add_parts(part->shape, of_b, outer, inner);
    } else {
      more_.push_back(
          {.shape = &shape, .of_b = of_b, .count = leaf_count(shape), .outer = outer, .inner = inner});
    }
  }

  // fine: out += scale (x - y), three roundings at most.
  static void add_shift(Fine& out, const Vec3<S>& x, const Vec3<S>& y, int exponent) {
    const double unit = std::ldexp(1.0, -exponent);
    for (int i = 0; i < 3; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      const double p = unit * double(x[i]), q = unit * double(y[i]);
      out.x[k] = out.x[k] + detail::two_sum(p, -q);
      out.size += std::abs(p) + std::abs(q);
      out.grid = std::min({out.grid, trailing_exponent(p), trailing_exponent(q)});
    }
  }
  // fine: out += sign R x, x exact pairs
  static void add_turned(Fine& out, detail::TwoDoubles3 x, double size, int grid, bool negative,
                         const Quaternion<double>& outer, const std::vector<Quaternion<double>>& inner) {
    for (auto q = inner.rbegin(); q != inner.rend(); ++q) x = rotate_pairs(*q, x);
    if (!outer.is_identity()) x = rotate_pairs(outer, x);
    const bool turned = !outer.is_identity() || !inner.empty();
    for (std::size_t i = 0; i < 3; ++i) out.x[i] = out.x[i] + (negative ? -x[i] : x[i]);
    out.size += (turned ? 2 : 1) * size;  // |R x|_i <= |x|_2 < 2 |x|_inf
    out.grid = turned ? kNoGrid : std::min(out.grid, grid);
  }
  void add_point(Fine& out, const Vertex& v, int) const {
    add_shift(out, a_.position, b_.position, k_);
    const auto add = [&](const Vec3<double>& given, bool of_b, const auto& outer, const auto& inner) {
      const Vec3<double> x = std::ldexp(1.0, -k_) * given;
      detail::TwoDoubles3 pairs;
      int grid = kAnyGrid;
      for (std::size_t i = 0; i < 3; ++i) {
        pairs[i] = {x[static_cast<int>(i)], 0};
        grid = std::min(grid, trailing_exponent(x[static_cast<int>(i)]));
      }
      add_turned(out, pairs, x.cwiseAbs().maxCoeff(), grid, of_b, outer, inner);
    };
    for (const Shift& s : shifts_) add(s.by, s.of_b, s.outer, s.inner);
    for (const Leaf<S>& leaf : leaves_) {
      add(leaf_vertex(*leaf.shape, leaf.vertex(v)), leaf.of_b, leaf.outer, leaf.inner);
    }
  }
  void add_difference(Fine& out, const Vertex& from, const Vertex& to) const {
    for (const Leaf<S>& leaf : leaves_) add_step(out, leaf, leaf.vertex(from), leaf.vertex(to));
  }
  void add_step(Fine& out, const Leaf<S>& leaf, std::uint32_t k, std::uint32_t l) const {
    if (k == l) return;
    const double unit = std::ldexp(1.0, -k_);
    const Vec3<double> x = unit * leaf_vertex(*leaf.shape, k), y = unit * leaf_vertex(*leaf.shape, l);
    detail::TwoDoubles3 pairs;
    double size = 0;
    int grid = kAnyGrid;
    for (std::size_t i = 0; i < 3; ++i) {
      const int m = static_cast<int>(i);
      pairs[i] = detail::two_sum(y[m], -x[m]);
      size = std::max(size, std::abs(pairs[i].hi));
      grid = std::min({grid, trailing_exponent(x[m]), trailing_exponent(y[m])});
    }
    add_turned(out, pairs, size, grid, leaf.of_b, leaf.outer, leaf.inner);
  }

  static Exact difference_of(const Vec3<S>& x, const Vec3<S>& y) {
    Exact out;
    for (int i = 0; i < 3; ++i)
      out.x[static_cast<std::size_t>(i)] = Dyadic(double(x[i])) - Dyadic(double(y[i]));
    return out;
  }
  static Dyadic3 step_of(const Leaf<S>& leaf, std::uint32_t k, std::uint32_t l) {
    if (k == l) return {};
    const Vec3<double> x = leaf_vertex(*leaf.shape, k), y = leaf_vertex(*leaf.shape, l);
    Dyadic3 out;
    for (int i = 0; i < 3; ++i) out[static_cast<std::size_t>(i)] = Dyadic(y[i]) - Dyadic(x[i]);
    return out;
  }
  static void turn_exactly(Exact& e, const Quaternion<double>& outer,
                           const std::vector<Quaternion<double>>& inner) {
    for (auto q = inner.rbegin(); q != inner.rend(); ++q) rotate_exactly(*q, e);
    if (!outer.is_identity()) rotate_exactly(outer, e);
  }
  // out += 2^exponent (part), as fractions.
  static void add_exactly(Exact& out, const Exact& part, int exponent, bool negative = false) {
    for (std::size_t i = 0; i < 3; ++i) {
      Dyadic x = part.x[i].times_power_of_two(exponent);
      if (negative) x = -x;
      if (out.weighted) x = x * out.weight;
      out.x[i] = (part.weighted ? out.x[i] * part.weight : out.x[i]) + x;
    }
    if (part.weighted) out.weight = out.weighted ? out.weight * part.weight : part.weight;
    out.weighted = out.weighted || part.weighted;
  }
  void add_step_exactly(Exact& out, const Leaf<S>& leaf, std::uint32_t k, std::uint32_t l) const {
    if (k == l) return;
    Exact part;
    part.x = step_of(leaf, k, l);
    turn_exactly(part, leaf.outer, leaf.inner);
    add_exactly(out, part, -k_, leaf.of_b);
  }

  const Body<S>&a_, &b_;
  int k_, j_;
  std::array<Leaf<S>, 2> own_;
  std::vector<Leaf<S>> more_;
  std::vector<Shift> shifts_;
  std::span<const Leaf<S>> leaves_;
  mutable bool valid_ = true;
  mutable int exact_decisions_ = 0;
};

}  // namespace graze::exact
