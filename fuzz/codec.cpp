#include "fuzz/codec.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <graze/detail/shapes/hull_graph.hpp>

namespace graze::fuzz {

using corpus::Case;

namespace {

constexpr unsigned kMostVertices = 128;
constexpr unsigned kMostParts = 3, kMostNested = 3;
constexpr unsigned kTurnedA = 1, kTurnedB = 2, kHorizon = 4, kTarget = 8, kMore = 16;
constexpr unsigned kRotationA = 1, kPivotA = 2, kRotationB = 4, kPivotB = 8, kPassOver = 16, kAsked = 32,
                   kDirected = 64;
constexpr unsigned kQueries = 7;
constexpr std::uint8_t kAdjacency = 0x80, kInvalid = 0xf0, kAsItIs = 0xff;

// A kind of shape is its index in graze::Shape. The combinators are the last.
constexpr unsigned kKinds = std::variant_size_v<Shape<double>::Kinds>, kMissing = 15;
constexpr unsigned kFirstCombinator = 10;
static_assert(kKinds == 14);

// The exponents of tags c, d and e, as the fields of the formats.
constexpr std::uint32_t kFloatExponent = 0xffu << 23;
constexpr std::uint64_t kExponent = 0x7ffull << 52;
constexpr std::uint64_t kWideFrom = 1023 - 192, kWide = 384, kNearFrom = 1023 - 16, kNear = 32;
static_assert(
    std::is_same_v<std::variant_alternative_t<kFirstCombinator, Shape<double>::Kinds>, Posed<double>>);

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
  Reader(std::span<const std::uint8_t> bytes, Adjacency adjacency) : bytes_(bytes), adjacency_(adjacency) {}

  std::uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{0}; }

  double scalar() { return kept(fresh()); }
  double extent() {
    const double x = fresh();
    return kept(as_it_is_ ? x : std::abs(x));
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

  Shape<double> shape(unsigned nested) {
    const std::uint8_t head = byte();
    return shape(head, nested);
  }

  Body<double> body(bool turned) {
    Body<double> body;
    body.shape = shape(0);
    body.position = vector();
    if (turned) body.orientation = quaternion();
    body.displacement = vector();
    return body;
  }

  [[nodiscard]] std::span<const std::uint8_t> rest() const { return bytes_.subspan(at_); }
  [[nodiscard]] bool asks_adjacency() const { return asks_adjacency_; }

 private:
  double kept(double x) {
    earlier_[count_++ % earlier_.size()] = x;
    return x;
  }

  Shape<double> shape(std::uint8_t head, unsigned nested) {
    unsigned kind = head & 15u;
    if (kind >= kKinds) kind = kind == kKinds ? 0 : 3;
    if (kind >= kFirstCombinator && nested >= kMostNested) kind -= kFirstCombinator;
    Shape<double> shape = blank(kind);
    if ((head & kInvalid) == kInvalid && can_be_empty(shape)) return shape;
    std::visit([&](auto& one) { fill(one, nested); }, shape);
    return shape;
  }
  static bool can_be_empty(const Shape<double>& shape) {
    return std::visit([]<class T>(const T&) { return std::same_as<T, Hull<double>> || Combining<T>; }, shape);
  }
  // nullptr for a missing part.
  SharedShape<double> part(unsigned nested) {
    const std::uint8_t head = byte();
    if (head == (kInvalid | kMissing)) return nullptr;
    return share(shape(head, nested));
  }

  void fill(Point<double>&, unsigned) {}
  void fill(Segment<double>& s, unsigned) {
    for (Vec3<double>* x : {&s.a, &s.b}) *x = vector();
  }
  void fill(Triangle<double>& t, unsigned) {
    for (Vec3<double>* x : {&t.a, &t.b, &t.c}) *x = vector();
  }
  void fill(Sphere<double>& s, unsigned) { s.radius = extent(); }
  void fill(Box<double>& b, unsigned) { b.half_extents = extents(); }
  void fill(Ellipsoid<double>& e, unsigned) { e.radii = extents(); }
  template <Round T>
  void fill(T& s, unsigned) {
    s.radius = extent();
    s.half_height = extent();
  }
  void fill(Hull<double>& hull, unsigned) {
    const std::uint8_t head = byte();
    std::vector<Vec3<double>> vertices(1u + head % kMostVertices);
    for (Vec3<double>& v : vertices) v = vector();
    const bool finite =
        std::all_of(vertices.begin(), vertices.end(), [](const Vec3<double>& v) { return v.allFinite(); });
    const bool asks = (head & kAdjacency) && finite;
    asks_adjacency_ = asks_adjacency_ || asks;
    hull = asks && adjacency_ == Adjacency::derived ? with_adjacency<double>(vertices)
                                                    : Hull<double>(std::span<const Vec3<double>>(vertices));
  }
  Vec3<double> extents() {
    const double x = extent(), y = extent(), z = extent();
    return {x, y, z};
  }
  void fill(Posed<double>& p, unsigned nested) {
    p.shape = part(nested + 1);
    p.position = vector();
    p.orientation = quaternion();
  }
  void fill(Rounded<double>& r, unsigned nested) {
    r.shape = part(nested + 1);
    r.radius = extent();
  }
  template <Combining T>
  void fill(T& s, unsigned nested) {
    s.shapes.resize(1u + byte() % kMostParts);
    for (SharedShape<double>& one : s.shapes) one = part(nested + 1);
  }

  std::uint64_t word(int bytes) {
    std::uint64_t bits = 0;
    for (int i = 0; i < bytes; ++i) bits |= static_cast<std::uint64_t>(byte()) << (8 * i);
    return bits;
  }

  // A step from 0 ends at the least magnitude that is answered, not at the least subnormal.
  static double step(double x, double towards) {
    const double next = std::nextafter(x, towards);
    return next != 0 && std::abs(next) < 0x1p-192 ? std::copysign(0x1p-192, next) : next;
  }

  double fresh() {
    as_it_is_ = false;
    const std::uint8_t tag = byte();
    if (tag < 0x80) return static_cast<double>(tag) - 64;
    const unsigned low = tag & 15u;
    // Before the first scalar there are zeros.
    const double before = earlier_[(count_ + earlier_.size() - 1 - low) % earlier_.size()];
    switch (tag >> 4) {
      case 0x8:
        return before;
      case 0x9:
        return step(before, kInfinity<double>);
      case 0xa:
        return step(before, -kInfinity<double>);
      case 0xb:
        return std::scalbn(static_cast<double>(static_cast<std::int8_t>(byte())), -static_cast<int>(low));
      case 0xc: {
        std::uint32_t bits = static_cast<std::uint32_t>(word(4));
        if ((bits & kFloatExponent) == kFloatExponent) bits &= ~(1u << 23);
        return std::bit_cast<float>(bits);
      }
      case 0xd:
        if (tag == 0xdf && byte() == kAsItIs) {
          as_it_is_ = true;
          return std::bit_cast<double>(word(8));
        }
        return with_exponent(word(8), kWideFrom, kWide);
      default:
        return with_exponent(word(8), kNearFrom, kNear);
    }
  }
  static double with_exponent(std::uint64_t bits, std::uint64_t from, std::uint64_t count) {
    const std::uint64_t exponent = from + (bits >> 52 & 0x7ff) % count;
    return std::bit_cast<double>((bits & ~kExponent) | exponent << 52);
  }

  std::span<const std::uint8_t> bytes_;
  Adjacency adjacency_;
  bool asks_adjacency_ = false;
  std::size_t at_ = 0;
  std::array<double, 16> earlier_{};
  std::size_t count_ = 0;
  bool as_it_is_ = false;  // the last scalar was a double as it is
};

class Writer {
 public:
  explicit Writer(bool ask_adjacency) : ask_adjacency_(ask_adjacency) {}

  Bytes bytes;

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
    if (std::abs(x) <= std::numeric_limits<float>::max()) {
      if (const auto narrow = static_cast<float>(x); narrow == x) {
        bytes.push_back(0xc0);
        word(std::bit_cast<std::uint32_t>(narrow), 4);
        return;
      }
    }
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x), exponent = bits >> 52 & 0x7ff;
    if (exponent - kNearFrom < kNear) {
      bytes.push_back(0xe0);
      word((bits & ~kExponent) | (exponent - kNearFrom) << 52, 8);
    } else if (exponent - kWideFrom < kWide) {
      bytes.push_back(0xd0);
      word((bits & ~kExponent) | (exponent - kWideFrom) << 52, 8);
    } else {
      as_it_is(x);
    }
  }

  // Only by its bits does an extent keep its sign.
  void extent(double x) {
    if (std::signbit(x)) {
      as_it_is(x);
    } else {
      scalar(x);
    }
  }

  void vector(const Vec3<double>& v) {
    for (int i = 0; i < 3; ++i) scalar(v[i]);
  }

  void quaternion(const Quaternion<double>& q) {
    for (const double x : {q.w, q.x, q.y, q.z}) scalar(x);
  }

  void shape(const Shape<double>& given) {
    const bool empty = std::visit(
        []<class T>(const T& s) {
          if constexpr (std::same_as<T, Hull<double>>) {
            return s.size() == 0;
          } else if constexpr (Combining<T>) {
            return s.shapes.empty();
          } else {
            return false;
          }
        },
        given);
    bytes.push_back(static_cast<std::uint8_t>(given.index() | (empty ? kInvalid : 0u)));
    if (!empty) std::visit([&](const auto& one) { numbers(one); }, given);
  }

  void body(const Body<double>& body, bool turned) {
    shape(body.shape);
    vector(body.position);
    if (turned) quaternion(body.orientation);
    vector(body.displacement);
  }

 private:
  void as_it_is(double x) {
    bytes.push_back(0xdf);
    bytes.push_back(kAsItIs);
    word(std::bit_cast<std::uint64_t>(x), 8);
  }

  void part(const SharedShape<double>& given) {
    if (given) {
      shape(given->shape);
    } else {
      bytes.push_back(kInvalid | kMissing);
    }
  }

  void numbers(const Point<double>&) {}
  void numbers(const Segment<double>& s) {
    for (const Vec3<double>* x : {&s.a, &s.b}) vector(*x);
  }
  void numbers(const Triangle<double>& t) {
    for (const Vec3<double>* x : {&t.a, &t.b, &t.c}) vector(*x);
  }
  void numbers(const Sphere<double>& s) { extent(s.radius); }
  void numbers(const Box<double>& b) { extents(b.half_extents); }
  void numbers(const Ellipsoid<double>& e) { extents(e.radii); }
  void extents(const Vec3<double>& v) {
    for (int i = 0; i < 3; ++i) extent(v[i]);
  }
  template <Round T>
  void numbers(const T& s) {
    extent(s.radius);
    extent(s.half_height);
  }
  void numbers(const Hull<double>& hull) {
    const bool asks = ask_adjacency_ || hull.has_adjacency();
    bytes.push_back(static_cast<std::uint8_t>((hull.size() - 1) | (asks ? kAdjacency : 0u)));
    for (const Vec3<double>& v : hull.vertices()) vector(v);
  }
  void numbers(const Posed<double>& p) {
    part(p.shape);
    vector(p.position);
    quaternion(p.orientation);
  }
  void numbers(const Rounded<double>& r) {
    part(r.shape);
    extent(r.radius);
  }
  template <Combining T>
  void numbers(const T& s) {
    bytes.push_back(static_cast<std::uint8_t>(s.shapes.size() - 1));
    for (const SharedShape<double>& one : s.shapes) part(one);
  }

  bool ask_adjacency_;
};

bool turned(const Quaternion<double>& q) {
  return !(q.is_identity() && q.w == 1) || std::signbit(q.x) || std::signbit(q.y) || std::signbit(q.z);
}

// Not +0, bit for bit.
bool given(double x) { return x != 0 || std::signbit(x); }
bool given(const Vec3<double>& v) { return given(v[0]) || given(v[1]) || given(v[2]); }

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

Decoded decode_with_tail(std::span<const std::uint8_t> bytes, Adjacency adjacency) {
  Reader reader(bytes, adjacency);
  const unsigned head = reader.byte();
  const unsigned more = head & kMore ? reader.byte() : 0u;
  Case problem;
  problem.id = "fuzz/one";
  problem.family = "fuzz";
  problem.a = reader.body((head & kTurnedA) != 0);
  problem.b = reader.body((head & kTurnedB) != 0);
  if (head & kHorizon) problem.t_max = reader.extent();
  if (head & kTarget) problem.target_distance = reader.extent();
  if (more & kRotationA) problem.spin_a.rotation = reader.vector();
  if (more & kPivotA) problem.spin_a.pivot = reader.vector();
  if (more & kRotationB) problem.spin_b.rotation = reader.vector();
  if (more & kPivotB) problem.spin_b.pivot = reader.vector();
  if (more & kPassOver) problem.start_policy = corpus::StartPolicy::pass_over;
  if (more & kAsked) problem.query = static_cast<corpus::Query>(reader.byte() % kQueries);
  if (more & kDirected) problem.direction = reader.vector();
  return {std::move(problem), reader.rest(), reader.asks_adjacency()};
}

Case decode(std::span<const std::uint8_t> bytes) { return decode_with_tail(bytes).problem; }

std::optional<Bytes> encode(const Case& problem, bool ask_adjacency) {
  if (too_large(problem.a.shape, 0) || too_large(problem.b.shape, 0)) return std::nullopt;
  const bool a_turned = turned(problem.a.orientation), b_turned = turned(problem.b.orientation);
  const bool horizon = problem.t_max != 1;
  const bool target = given(problem.target_distance);
  const auto flag = [](bool is, unsigned bit) { return is ? bit : 0u; };
  const unsigned more =
      flag(given(problem.spin_a.rotation), kRotationA) | flag(given(problem.spin_a.pivot), kPivotA) |
      flag(given(problem.spin_b.rotation), kRotationB) | flag(given(problem.spin_b.pivot), kPivotB) |
      flag(problem.start_policy == corpus::StartPolicy::pass_over, kPassOver) |
      flag(problem.query != corpus::Query::cast, kAsked) | flag(given(problem.direction), kDirected);
  Writer writer(ask_adjacency);
  const unsigned head = flag(a_turned, kTurnedA) | flag(b_turned, kTurnedB) | flag(horizon, kHorizon) |
                        flag(target, kTarget) | flag(more != 0, kMore);
  writer.bytes.push_back(static_cast<std::uint8_t>(head));
  if (more != 0) writer.bytes.push_back(static_cast<std::uint8_t>(more));
  writer.body(problem.a, a_turned);
  writer.body(problem.b, b_turned);
  if (horizon) writer.extent(problem.t_max);
  if (target) writer.extent(problem.target_distance);
  for (const corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    if (given(spin->rotation)) writer.vector(spin->rotation);
    if (given(spin->pivot)) writer.vector(spin->pivot);
  }
  if (more & kAsked) writer.bytes.push_back(static_cast<std::uint8_t>(problem.query));
  if (more & kDirected) writer.vector(problem.direction);
  return std::move(writer.bytes);
}

}  // namespace graze::fuzz
