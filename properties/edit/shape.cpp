#include "properties/edit/shape.hpp"

#include <algorithm>
#include <cmath>

namespace graze::law {

namespace {

constexpr int kMostNested = 16;
constexpr std::uint64_t kMostVertices = 0xffffffffu;  // of a shape that is not refused
constexpr std::uint64_t kSaturated = std::uint64_t{1} << 63;

template <class T>
concept Combining = requires(T s) {
  s.shapes;
};
template <class T>
concept Wrapping = requires(T s) {
  s.shape;
};  // posed, rounded
template <class T>
concept Round = requires(T s) {
  s.half_height;
};  // capsule, cylinder, cone

std::uint64_t saturating_product(std::uint64_t l, std::uint64_t r) {
  return l != 0 && r > kSaturated / l ? kSaturated : l * r;
}

template <class Test>
bool every_leaf(const Shape<double>& shape, const Test& test) {
  if (!test(shape)) return false;
  const auto parts = parts_of(shape);
  return std::all_of(parts.begin(), parts.end(),
                     [&](const SharedShape<double>& part) { return part && every_leaf(part->shape, test); });
}

bool is_malformed_at(const Shape<double>& shape, int nested) {
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) return hull->size() == 0;
  if (const auto* posed = std::get_if<Posed<double>>(&shape)) {
    if (posed->orientation.w == 0 && posed->orientation.is_identity()) return true;
  }
  const bool combines =
      std::holds_alternative<Sum<double>>(shape) || std::holds_alternative<HullOf<double>>(shape) ||
      std::holds_alternative<Posed<double>>(shape) || std::holds_alternative<Rounded<double>>(shape);
  if (!combines) return false;
  const auto parts = parts_of(shape);
  return parts.empty() || nested >= kMostNested ||
         std::any_of(parts.begin(), parts.end(), [&](const SharedShape<double>& part) {
           return !part || is_malformed_at(part->shape, nested + 1);
         });
}

using Vertices = std::vector<Vec3<double>>;

Vertices corners(const Box<double>& box) {
  Vertices all;
  for (unsigned k = 0; k < 8; ++k) {
    Vec3<double> corner = box.half_extents;
    for (unsigned i = 0; i < 3; ++i) {
      if (!(k >> i & 1)) corner[i] = -corner[i];
    }
    all.push_back(corner);
  }
  return all;
}

std::optional<Vertices> sums(const Vertices& left, const Vertices& right, std::size_t most) {
  if (left.size() * right.size() > most) return std::nullopt;
  Vertices all;
  for (const Vec3<double>& l : left) {
    for (const Vec3<double>& r : right) {
      const auto sum = exact_sum(l, r);
      if (!sum) return std::nullopt;
      all.push_back(*sum);
    }
  }
  return all;
}

struct ExactVertices {
  std::size_t most;

  [[nodiscard]] std::optional<Vertices> part(const SharedShape<double>& given) const {
    return given ? exact_vertices(given->shape, most) : std::nullopt;
  }

  std::optional<Vertices> operator()(const Point<double>&) const { return Vertices{Vec3<double>::Zero()}; }
  std::optional<Vertices> operator()(const Segment<double>& s) const { return Vertices{s.a, s.b}; }
  std::optional<Vertices> operator()(const Triangle<double>& t) const { return Vertices{t.a, t.b, t.c}; }
  std::optional<Vertices> operator()(const Box<double>& b) const { return corners(b); }
  std::optional<Vertices> operator()(const Hull<double>& h) const {
    return Vertices(h.vertices().begin(), h.vertices().end());
  }
  std::optional<Vertices> operator()(const Posed<double>& p) const {
    const auto signs = signs_of(p.orientation);
    auto all = part(p.shape);
    if (!signs || !all) return std::nullopt;
    for (Vec3<double>& x : *all) x = signs->cwiseProduct(x);
    return sums({p.position}, *all, most);
  }
  std::optional<Vertices> operator()(const Sum<double>& s) const {
    std::optional<Vertices> all = Vertices{Vec3<double>::Zero()};
    for (const SharedShape<double>& one : s.shapes) {
      const auto more = part(one);
      if (!more) return std::nullopt;
      all = sums(*all, *more, most);
      if (!all) return std::nullopt;
    }
    return all;
  }
  std::optional<Vertices> operator()(const HullOf<double>& h) const {
    Vertices all;
    for (const SharedShape<double>& one : h.shapes) {
      const auto more = part(one);
      if (!more || all.size() + more->size() > most) return std::nullopt;
      all.insert(all.end(), more->begin(), more->end());
    }
    return all;
  }
  // Curved, or with a ball.
  template <class Other>
  std::optional<Vertices> operator()(const Other&) const {
    return std::nullopt;
  }
};

struct Growth {
  std::uint64_t pick;

  // By one unit in the last place, by a sixteenth, or twofold. The law holds for a superset of any size.
  [[nodiscard]] double larger(double x) const {
    const unsigned how = pick >> 1 & 3;
    if (x == 0) return how == 0 ? 0x1p-20 : 1.0;
    return how == 0 ? std::nextafter(x, 2 * x) : how == 1 ? x * 1.0625 : 2 * x;
  }
  [[nodiscard]] double direction(int i) const {
    return static_cast<double>(static_cast<int>(mix(pick + 17U * static_cast<std::uint64_t>(i)) % 9) - 4);
  }
  // Away from the origin of the body, or moved by the size of a coordinate. Any new vertex will do.
  [[nodiscard]] Vec3<double> beyond(Vec3<double> x) const {
    const double size = x.cwiseAbs().maxCoeff();
    for (int i = 0; i < 3; ++i) {
      x[i] = direction(i) < 0 ? larger(x[i]) : x[i] + direction(i) * (size == 0 ? 1 : size / 4);
    }
    return x;
  }
  [[nodiscard]] Vec3<double> larger_axes(Vec3<double> extents) const {
    const std::uint64_t axes = 1 + (pick >> 8) % 7;
    for (unsigned i = 0; i < 3; ++i) {
      if (axes >> i & 1) extents[i] = larger(extents[i]);
    }
    return extents;
  }

  Shape<double> operator()(const Point<double>&) const {
    if (pick >> 8 & 1) return Sphere<double>{larger(0)};
    return Hull<double>{Vec3<double>::Zero(), {direction(0), direction(1), direction(2)}};
  }
  Shape<double> operator()(const Segment<double>& s) const { return Triangle<double>{s.a, s.b, beyond(s.a)}; }
  Shape<double> operator()(const Triangle<double>& t) const {
    return Hull<double>{t.a, t.b, t.c, beyond(t.b)};
  }
  Shape<double> operator()(const Sphere<double>& s) const { return Sphere<double>{larger(s.radius)}; }
  Shape<double> operator()(const Box<double>& b) const { return Box<double>{larger_axes(b.half_extents)}; }
  Shape<double> operator()(const Ellipsoid<double>& e) const {
    return Ellipsoid<double>{larger_axes(e.radii)};
  }
  Shape<double> operator()(const Hull<double>& h) const {
    Vertices vertices(h.vertices().begin(), h.vertices().end());
    if (!vertices.empty()) vertices.push_back(beyond(vertices[(pick >> 8) % vertices.size()]));
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  }
  // A taller cone does not hold the lower one: its side is steeper.
  Shape<double> operator()(const Cone<double>& c) const {
    return Cone<double>{larger(c.radius), c.half_height};
  }
  template <Round T>
  Shape<double> operator()(const T& s) const {
    return pick >> 8 & 1 ? T{larger(s.radius), s.half_height} : T{s.radius, larger(s.half_height)};
  }
  Shape<double> operator()(const Posed<double>& p) const { return grow_a_part(p); }
  Shape<double> operator()(const Rounded<double>& r) const {
    if (pick >> 8 & 1) return Rounded<double>{r.shape, larger(r.radius)};
    return grow_a_part(r);
  }
  template <Combining T>
  Shape<double> operator()(const T& s) const {
    if (pick >> 8 & 3) return grow_a_part(s);
    return Rounded<double>{share<double>(s), larger(0)};
  }

 private:
  [[nodiscard]] Shape<double> grow_a_part(const Shape<double>& shape) const {
    auto parts = parts_of(shape);
    if (parts.empty()) return shape;
    SharedShape<double>& one = parts[(pick >> 16) % parts.size()];
    if (one) one = share(grown(one->shape, mix(pick)));
    return with_parts(shape, std::move(parts));
  }
};

}  // namespace

std::vector<SharedShape<double>> parts_of(const Shape<double>& shape) {
  return std::visit(
      []<class T>(const T& s) -> std::vector<SharedShape<double>> {
        if constexpr (Combining<T>) {
          return s.shapes;
        } else if constexpr (Wrapping<T>) {
          return {s.shape};
        } else {
          return {};
        }
      },
      shape);
}

Shape<double> with_parts(const Shape<double>& shape, std::vector<SharedShape<double>> parts) {
  return std::visit(
      [&]<class T>(T s) -> Shape<double> {
        if constexpr (Combining<T>) {
          s.shapes = std::move(parts);
        } else if constexpr (Wrapping<T>) {
          s.shape = std::move(parts.at(0));
        }
        return s;
      },
      shape);
}

std::vector<std::uint32_t> outline(const Shape<double>& shape) {
  constexpr std::uint32_t kMissing = 0xffffffffu;
  std::vector<std::uint32_t> all{static_cast<std::uint32_t>(shape.index())};
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    all.push_back(static_cast<std::uint32_t>(hull->size()));
  }
  const auto parts = parts_of(shape);
  all.push_back(static_cast<std::uint32_t>(parts.size()));
  for (const SharedShape<double>& part : parts) {
    const std::vector<std::uint32_t> more = part ? outline(part->shape) : std::vector{kMissing};
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

int node_count(const Shape<double>& shape) {
  int count = 1;
  for (const SharedShape<double>& part : parts_of(shape)) count += part ? node_count(part->shape) : 1;
  return count;
}

std::uint64_t vertex_count(const Shape<double>& shape) {
  const auto of_part = [](const SharedShape<double>& part) {
    return part ? vertex_count(part->shape) : std::uint64_t{0};
  };
  const auto parts = parts_of(shape);
  if (std::holds_alternative<HullOf<double>>(shape)) {
    std::uint64_t sum = 0;
    for (const auto& part : parts) sum = std::min(sum + of_part(part), kSaturated);
    return sum;
  }
  if (!parts.empty()) {  // sum, posed, rounded
    std::uint64_t product = 1;
    for (const auto& part : parts) product = saturating_product(product, of_part(part));
    return product;
  }
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) return hull->size();
  if (std::holds_alternative<Box<double>>(shape)) return 8;
  if (std::holds_alternative<Triangle<double>>(shape)) return 3;
  if (std::holds_alternative<Segment<double>>(shape) || std::holds_alternative<Capsule<double>>(shape)) {
    return 2;
  }
  return 1;
}

bool is_malformed(const Shape<double>& shape) {
  return is_malformed_at(shape, 0) || vertex_count(shape) > kMostVertices;
}

bool is_uncurved(const Shape<double>& shape) {
  return every_leaf(shape, [](const Shape<double>& one) {
    return !std::holds_alternative<Ellipsoid<double>>(one) &&
           !std::holds_alternative<Cylinder<double>>(one) && !std::holds_alternative<Cone<double>>(one);
  });
}

bool is_polytope(const Shape<double>& shape) {
  return is_uncurved(shape) && every_leaf(shape, [](const Shape<double>& one) {
           return !std::holds_alternative<Sphere<double>>(one) &&
                  !std::holds_alternative<Capsule<double>>(one) &&
                  !std::holds_alternative<Rounded<double>>(one);
         });
}

std::optional<std::vector<Vec3<double>>> exact_vertices(const Shape<double>& shape, std::size_t most) {
  auto all = std::visit(ExactVertices{most}, shape);
  if (!all || all->empty() || all->size() > most) return std::nullopt;
  return all;
}

Shape<double> grown(const Shape<double>& shape, std::uint64_t salt) {
  return std::visit(Growth{salt}, shape);
}

std::optional<Vec3<double>> signs_of(const Quaternion<double>& q) {
  const int nonzero = (q.w != 0) + (q.x != 0) + (q.y != 0) + (q.z != 0);
  if (nonzero != 1) return std::nullopt;
  if (q.w != 0) return Vec3<double>(1, 1, 1);
  if (q.x != 0) return Vec3<double>(1, -1, -1);
  if (q.y != 0) return Vec3<double>(-1, 1, -1);
  return Vec3<double>(-1, -1, 1);
}

// Knuth's TwoSum: the error of the rounded sum, itself exact.
std::optional<double> exact_sum(double a, double b) {
  const double s = a + b, bb = s - a, error = (a - (s - bb)) + (b - bb);
  if (!std::isfinite(s) || error != 0) return std::nullopt;
  return s;
}

std::optional<Vec3<double>> exact_sum(const Vec3<double>& a, const Vec3<double>& b) {
  Vec3<double> sum;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> s = exact_sum(a[i], b[i]);
    if (!s) return std::nullopt;
    sum[i] = *s;
  }
  return sum;
}

}  // namespace graze::law
