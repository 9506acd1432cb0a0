#include "fuzz/codec.hpp"

#include <array>
#include <bit>
#include <cmath>

namespace graze::fuzz {

using corpus::Case;

namespace {

constexpr unsigned kMostVertices = 64;
constexpr std::uint8_t kTurnedA = 0x10, kTurnedB = 0x20, kHorizon = 0x40, kTarget = 0x80;

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

  Body<double> body(unsigned kind, bool turned) {
    Body<double> body;
    if (kind == 1) body.shape = Sphere<double>{scalar()};
    if (kind == 2) body.shape = Box<double>{vector()};
    if (kind == 3) {
      std::vector<Vec3<double>> vertices(byte() % (kMostVertices + 1));
      for (Vec3<double>& v : vertices) v = vector();
      body.shape = Hull<double>(std::span<const Vec3<double>>(vertices));
    }
    body.position = vector();
    if (turned) {
      Quaternion<double>& q = body.orientation;
      for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = scalar();
    }
    body.displacement = vector();
    return body;
  }

 private:
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

  void body(const Body<double>& body, bool turned) {
    if (const auto* sphere = std::get_if<Sphere<double>>(&body.shape)) scalar(sphere->radius);
    if (const auto* box = std::get_if<Box<double>>(&body.shape)) vector(box->half_extents);
    if (const auto* hull = std::get_if<Hull<double>>(&body.shape)) {
      bytes.push_back(static_cast<std::uint8_t>(hull->size()));
      for (const Vec3<double>& v : hull->vertices()) vector(v);
    }
    vector(body.position);
    if (turned) {
      const Quaternion<double>& q = body.orientation;
      for (const double x : {q.w, q.x, q.y, q.z}) scalar(x);
    }
    vector(body.displacement);
  }
};

bool turned(const Quaternion<double>& q) {
  return !(q.is_identity() && q.w == 1) || std::signbit(q.x) || std::signbit(q.y) || std::signbit(q.z);
}

bool too_large(const Shape<double>& shape) {
  const auto* hull = std::get_if<Hull<double>>(&shape);
  return hull && hull->size() > kMostVertices;
}

}  // namespace

Case decode(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  const std::uint8_t head = reader.byte();
  Case problem;
  problem.id = "fuzz/one";
  problem.family = "fuzz";
  problem.a = reader.body(head & 3u, (head & kTurnedA) != 0);
  problem.b = reader.body(head >> 2 & 3u, (head & kTurnedB) != 0);
  if (head & kHorizon) problem.t_max = reader.scalar();
  if (head & kTarget) problem.target_distance = reader.scalar();
  return problem;
}

std::optional<std::vector<std::uint8_t>> encode(const Case& problem) {
  if (too_large(problem.a.shape) || too_large(problem.b.shape)) return std::nullopt;
  if (!problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0)) return std::nullopt;
  if (problem.start_policy != corpus::StartPolicy::report || problem.query != corpus::Query::cast) {
    return std::nullopt;
  }
  const bool a_turned = turned(problem.a.orientation), b_turned = turned(problem.b.orientation);
  const bool horizon = problem.t_max != 1;
  const bool target = problem.target_distance != 0 || std::signbit(problem.target_distance);
  Writer writer;
  writer.bytes.push_back(static_cast<std::uint8_t>(problem.a.shape.index() | problem.b.shape.index() << 2 |
                                                   (a_turned ? kTurnedA : 0u) | (b_turned ? kTurnedB : 0u) |
                                                   (horizon ? kHorizon : 0u) | (target ? kTarget : 0u)));
  writer.body(problem.a, a_turned);
  writer.body(problem.b, b_turned);
  if (horizon) writer.scalar(problem.t_max);
  if (target) writer.scalar(problem.target_distance);
  return writer.bytes;
}

}  // namespace graze::fuzz
