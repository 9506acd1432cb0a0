#include "fuzz/codec.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace graze::fuzz {

using corpus::Case;

namespace {

constexpr unsigned kMostVertices = 64;
constexpr unsigned kMostParts = 3, kMostNested = 3;
constexpr std::uint8_t kTurnedA = 1, kTurnedB = 2, kHorizon = 4, kTarget = 8;

// A kind of shape is its index in graze::Shape; combinators are the last.
constexpr unsigned kKinds = std::variant_size_v<Shape<double>>, kMissing = kKinds;
constexpr unsigned kFirstCombinator = 10;
static_assert(kMissing <= 15);
static_assert(std::is_same_v<std::variant_alternative_t<kFirstCombinator, Shape<double>>, Posed<double>>);

template <class T>
concept Combining = requires(T s) {
  s.shapes;
};
template <class T>
concept Round = requires(T s) {
  s.half_height;
};  // capsule, cylinder, cone

// A default shape of each kind.
template <std::size_t... kIndices>
Shape<double> blank(unsigned kind, std::index_sequence<kIndices...>) {
  Shape<double> shape;
  (void)((kIndices == kind && (shape.emplace<kIndices>(), true)) || ...);
  return shape;
}
Shape<double> blank(unsigned kind) { return blank(kind, std::make_index_sequence<kKinds>()); }

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{0}; }

  double scalar() {
    const double x = fresh();
    earlier_[count_++ % earlier_.size()] = x;
    return x;
  }

  Vec3<double> vector() {
    const double x = scalar(), y = scalar(), z = scalar();
    return {x, y, z};
  }

  Quaternion<double> quaternion() {
    Quaternion<double> q;
    for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = scalar();
    return q;
  }

  // nullptr for a missing part.
  SharedShape<double> part(unsigned nested) {
    unsigned kind = byte() & 15u;
    if (kind >= kMissing) return nullptr;
    if (kind >= kFirstCombinator && nested >= kMostNested) kind -= kFirstCombinator;
    Shape<double> shape = blank(kind);
    std::visit([&](auto& one) { fill(one, nested); }, shape);
    return share(std::move(shape));
  }

  Body<double> body(bool turned) {
    Body<double> body;
    if (const SharedShape<double> shape = part(0)) body.shape = shape->shape;
    body.position = vector();
    if (turned) body.orientation = quaternion();
    body.displacement = vector();
    return body;
  }

 private:
  void fill(Point<double>&, unsigned) {}
  void fill(Segment<double>& s, unsigned) {
    for (Vec3<double>* x : {&s.a, &s.b}) *x = vector();
  }
  void fill(Triangle<double>& t, unsigned) {
    for (Vec3<double>* x : {&t.a, &t.b, &t.c}) *x = vector();
  }
  void fill(Sphere<double>& s, unsigned) { s.radius = scalar(); }
  void fill(Box<double>& b, unsigned) { b.half_extents = vector(); }
  void fill(Ellipsoid<double>& e, unsigned) { e.radii = vector(); }
  template <Round T>
  void fill(T& s, unsigned) {
    s.radius = scalar();
    s.half_height = scalar();
  }
  void fill(Hull<double>& hull, unsigned) {
    std::vector<Vec3<double>> vertices(byte() % (kMostVertices + 1));
    for (Vec3<double>& v : vertices) v = vector();
    hull = Hull<double>(std::span<const Vec3<double>>(vertices));
  }
  void fill(Posed<double>& p, unsigned nested) {
    p.shape = part(nested + 1);
    p.position = vector();
    p.orientation = quaternion();
  }
  void fill(Rounded<double>& r, unsigned nested) {
    r.shape = part(nested + 1);
    r.radius = scalar();
  }
  template <Combining T>
  void fill(T& s, unsigned nested) {
    s.shapes.resize(byte() & kMostParts);
    for (SharedShape<double>& one : s.shapes) one = part(nested + 1);
  }

  std::uint64_t word(int bytes) {
    std::uint64_t bits = 0;
    for (int i = 0; i < bytes; ++i) bits |= static_cast<std::uint64_t>(byte()) << (8 * i);
    return bits;
  }

  double fresh() {
    const std::uint8_t tag = byte();
    if (tag < 0x80) return static_cast<double>(tag) - 64;
    const unsigned low = tag & 15u;
    // Before the first scalar there are zeros.
    const double before = earlier_[(count_ + earlier_.size() - 1 - low) % earlier_.size()];
    switch (tag >> 4) {
      case 0x8:
        return before;
      case 0x9:
        return std::nextafter(before, kInfinity<double>);
      case 0xa:
        return std::nextafter(before, -kInfinity<double>);
      case 0xb:
        return std::scalbn(static_cast<double>(static_cast<std::int8_t>(byte())), -static_cast<int>(low));
      case 0xc:
        return std::bit_cast<float>(static_cast<std::uint32_t>(word(4)));
      case 0xd:
        return std::bit_cast<double>(word(8));
      default:
        break;
    }
    constexpr std::uint64_t kExponent = 0x7ffull << 52;
    const std::uint64_t bits = word(8), exponent = 1023 - 16 + (bits >> 52 & 31);
    return std::bit_cast<double>((bits & ~kExponent) | exponent << 52);
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::array<double, 16> earlier_{};
  std::size_t count_ = 0;
};

class Writer {
 public:
  std::vector<std::uint8_t> bytes;

  void word(std::uint64_t bits, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
  }

  void scalar(double x) {
    const bool negative_zero = x == 0 && std::signbit(x);
    if (!negative_zero && x >= -64 && x <= 63 && x == std::floor(x)) {
      bytes.push_back(static_cast<std::uint8_t>(x + 64));
      return;
    }
    for (int k = 1; k < 16 && !negative_zero; ++k) {
      const double y = std::scalbn(x, k);
      if (y >= -128 && y <= 127 && y == std::floor(y)) {
        bytes.push_back(static_cast<std::uint8_t>(0xb0 + k));
        bytes.push_back(static_cast<std::uint8_t>(static_cast<std::int8_t>(y)));
        return;
      }
    }
    // A NaN keeps its bits as a double only.
    if (std::abs(x) <= std::numeric_limits<float>::max() || std::isinf(x)) {
      if (const auto narrow = static_cast<float>(x); narrow == x) {
        bytes.push_back(0xc0);
        word(std::bit_cast<std::uint32_t>(narrow), 4);
        return;
      }
    }
    bytes.push_back(0xd0);
    word(std::bit_cast<std::uint64_t>(x), 8);
  }

  void vector(const Vec3<double>& v) {
    for (int i = 0; i < 3; ++i) scalar(v[i]);
  }

  void quaternion(const Quaternion<double>& q) {
    for (const double x : {q.w, q.x, q.y, q.z}) scalar(x);
  }

  void shape(const Shape<double>& given) {
    bytes.push_back(static_cast<std::uint8_t>(given.index()));
    std::visit([&](const auto& one) { numbers(one); }, given);
  }

  void body(const Body<double>& body, bool turned) {
    shape(body.shape);
    vector(body.position);
    if (turned) quaternion(body.orientation);
    vector(body.displacement);
  }

 private:
  void part(const SharedShape<double>& given) {
    if (given) {
      shape(given->shape);
    } else {
      bytes.push_back(kMissing);
    }
  }

  void numbers(const Point<double>&) {}
  void numbers(const Segment<double>& s) {
    for (const Vec3<double>* x : {&s.a, &s.b}) vector(*x);
  }
  void numbers(const Triangle<double>& t) {
    for (const Vec3<double>* x : {&t.a, &t.b, &t.c}) vector(*x);
  }
  void numbers(const Sphere<double>& s) { scalar(s.radius); }
  void numbers(const Box<double>& b) { vector(b.half_extents); }
  void numbers(const Ellipsoid<double>& e) { vector(e.radii); }
  template <Round T>
  void numbers(const T& s) {
    scalar(s.radius);
    scalar(s.half_height);
  }
  void numbers(const Hull<double>& hull) {
    bytes.push_back(static_cast<std::uint8_t>(hull.size()));
    for (const Vec3<double>& v : hull.vertices()) vector(v);
  }
  void numbers(const Posed<double>& p) {
    part(p.shape);
    vector(p.position);
    quaternion(p.orientation);
  }
  void numbers(const Rounded<double>& r) {
    part(r.shape);
    scalar(r.radius);
  }
  template <Combining T>
  void numbers(const T& s) {
    bytes.push_back(static_cast<std::uint8_t>(s.shapes.size()));
    for (const SharedShape<double>& one : s.shapes) part(one);
  }
};

bool turned(const Quaternion<double>& q) {
  return !(q.is_identity() && q.w == 1) || std::signbit(q.x) || std::signbit(q.y) || std::signbit(q.z);
}

bool too_large(const SharedShape<double>& part, unsigned nested);

bool too_large(const Shape<double>& shape, unsigned nested) {
  return std::visit(
      [&]<class T>(const T& s) {
        if constexpr (std::same_as<T, Hull<double>>) {
          return s.size() > kMostVertices;
        } else if constexpr (Combining<T>) {
          return nested >= kMostNested || s.shapes.size() > kMostParts ||
                 std::any_of(s.shapes.begin(), s.shapes.end(),
                             [&](const SharedShape<double>& one) { return too_large(one, nested + 1); });
        } else if constexpr (requires { s.shape; }) {
          return nested >= kMostNested || too_large(s.shape, nested + 1);
        } else {
          return false;
        }
      },
      shape);
}

bool too_large(const SharedShape<double>& part, unsigned nested) {
  return part && too_large(part->shape, nested);
}

}  // namespace

Case decode(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  const std::uint8_t head = reader.byte();
  Case problem;
  problem.id = "fuzz/one";
  problem.family = "fuzz";
  problem.a = reader.body((head & kTurnedA) != 0);
  problem.b = reader.body((head & kTurnedB) != 0);
  if (head & kHorizon) problem.t_max = reader.scalar();
  if (head & kTarget) problem.target_distance = reader.scalar();
  return problem;
}

std::optional<std::vector<std::uint8_t>> encode(const Case& problem) {
  if (too_large(problem.a.shape, 0) || too_large(problem.b.shape, 0)) return std::nullopt;
  if (!problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0)) return std::nullopt;
  if (problem.start_policy != corpus::StartPolicy::report || problem.query != corpus::Query::cast) {
    return std::nullopt;
  }
  const bool a_turned = turned(problem.a.orientation), b_turned = turned(problem.b.orientation);
  const bool horizon = problem.t_max != 1;
  const bool target = problem.target_distance != 0 || std::signbit(problem.target_distance);
  Writer writer;
  writer.bytes.push_back(static_cast<std::uint8_t>((a_turned ? kTurnedA : 0u) | (b_turned ? kTurnedB : 0u) |
                                                   (horizon ? kHorizon : 0u) | (target ? kTarget : 0u)));
  writer.body(problem.a, a_turned);
  writer.body(problem.b, b_turned);
  if (horizon) writer.scalar(problem.t_max);
  if (target) writer.scalar(problem.target_distance);
  return writer.bytes;
}

}  // namespace graze::fuzz
