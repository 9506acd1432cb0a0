// Prints a hash of the exact tier's verdicts, bounds, normals and contact points, one line for each kind of
// case. The lines are the same with every compiler and every flag. usage: exact_bits [flush]   (flush:
// subnormals are flushed)
//
// The cases must not depend on the flags either: every number of them is an integer times a power of two, and
// every sum stays within 53 bits, before it is rounded once.
#include <cstdio>
#include <cstring>
#include <graze/cast.hpp>
#include <graze/detail/queries/exact_queries.hpp>
#include <graze/line.hpp>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace {

using graze::Body;
using graze::Box;
using graze::CastOptions;
using graze::Hull;
using graze::Outcome;
using graze::Quaternion;
using graze::Scalar;
using graze::Segment;
using graze::Shape;
using graze::Triangle;
using graze::Vec3;

// splitmix64 (Steele, Lea, Flood 2014).
struct Bits {
  std::uint64_t state;
  std::uint64_t operator()() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  int below(int n) { return static_cast<int>((*this)() % static_cast<unsigned>(n)); }
};

// 2^e, by its bits.
double power(int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52); }

struct Kind {
  const char* name;
  int reach;     // coordinates are integers up to this
  int exponent;  // times 2^exponent
  bool turned;
  int scatter;          // the exponents of a case's lengths and speed vary by so many
  bool summed = false;  // combinators
};
constexpr Kind kKinds[] = {
    {"lattice", 2, 0, false, 0},        {"lattice_turned", 2, 0, true, 0},
    {"floats", 1 << 23, -21, false, 0}, {"floats_turned", 1 << 23, -21, true, 0},
    {"summed", 3, 0, false, 0, true},   {"summed_turned", 1 << 23, -21, true, 0, true},
    {"magnitudes", 100, 0, false, 90},  {"magnitudes_turned", 1 << 20, -18, true, 90},
};

template <Scalar S>
struct Draw {
  Bits bits;
  const Kind& kind;
  double unit = 1;

  S number(int reach) {
    return static_cast<S>(static_cast<double>(bits.below(2 * reach + 1) - reach) * unit);
  }
  Vec3<S> vector(int reach) {
    const S x = number(reach), y = number(reach), z = number(reach);
    return {x, y, z};
  }
  Shape<S> shape() {
    if (!kind.summed) return leaf();
    const Vec3<S> by = vector(kind.reach);
    const Quaternion<S> inner = kind.turned ? turn() : Quaternion<S>{};
    Shape<S> first = leaf();
    Shape<S> second = graze::posed<S>(leaf(), by, inner);
    return graze::sum<S>(std::move(first), std::move(second));
  }
  Shape<S> leaf() {
    const int reach = kind.reach;
    switch (bits.below(6)) {
      case 0: {
        const Vec3<S> a = vector(reach), b = vector(reach);
        return Segment<S>{a, b};
      }
      case 1: {
        const Vec3<S> a = vector(reach), b = vector(reach), c = vector(reach);
        return Triangle<S>{a, b, c};
      }
      case 2:
      case 3:
        return Box<S>{vector(reach).cwiseAbs()};
      default:
        break;
    }
    std::vector<Vec3<S>> vertices(static_cast<std::size_t>(4 + bits.below(20)));
    for (Vec3<S>& v : vertices) v = vector(reach);
    return Hull<S>(std::span<const Vec3<S>>(vertices));
  }
  Quaternion<S> turn() {
    const auto small = [&] { return static_cast<S>(bits.below(9) - 4); };
    const S w = small(), x = small(), y = small(), z = small();
    return w == 0 && x == 0 && y == 0 && z == 0 ? Quaternion<S>{} : Quaternion<S>{w, x, y, z};
  }
  static Vec3<double> widened(const Vec3<S>& x) { return x.template cast<double>(); }
  static Vec3<double> vertex_of(const Body<S>& body) {
    const auto* hull = std::get_if<Hull<S>>(&body.shape);
    return hull == nullptr ? Vec3<double>(Vec3<double>::Zero()) : widened(hull->vertex(0));
  }
  std::pair<Body<S>, Body<S>> pair(double length, double speed) {
    Body<S> a, b;
    unit = length;
    a.shape = shape();
    b.shape = shape();
    if (kind.turned) {
      a.orientation = turn();
      b.orientation = turn();
    }
    const bool aimed = bits.below(2) == 0;
    const int way = 2 + bits.below(3);
    unit = speed;
    const Vec3<S> v = vector(kind.reach);
    b.displacement = v;
    if (bits.below(3) == 0) b.displacement[bits.below(3)] = 0;
    unit = length;
    b.position = vector(3 * kind.reach);
    // Unturned, and where float holds the place, a vertex of B then meets one of A at t = `way`, exactly.
    if (aimed && speed == length) {
      b.position =
          Vec3<double>(vertex_of(a) - vertex_of(b) - way * widened(b.displacement)).template cast<S>();
    }
    return {a, b};
  }
};

class Hash {
 public:
  void add(std::uint64_t x) {
    for (int i = 0; i < 8; ++i) value_ = (value_ ^ (x >> (8 * i) & 0xff)) * 0x100000001b3u;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(float x) { add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(x))); }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

struct Count {
  int outcomes[5] = {};
};

template <Scalar S>
void cast_pair(const Body<S>& a, const Body<S>& b, S t_max, Hash& hash, Count& count) {
  CastOptions<S> options;
  options.tier = graze::Tier::exact;
  options.t_max = t_max;
  options.request = graze::Request::normal | graze::Request::witnesses;
  for (const graze::StartPolicy policy : {graze::StartPolicy::report, graze::StartPolicy::pass_over}) {
    options.start_policy = policy;
    const auto result = graze::cast_exact(a, b, options);
    hash.add(static_cast<std::uint64_t>(result.outcome));
    hash.add(static_cast<std::uint64_t>(result.invalid));
    if (result.outcome == Outcome::invalid_input) continue;  // a NaN has many bits
    hash.add(result.toi_lower);
    hash.add(result.toi_upper);
    for (const Vec3<S>* const x : {&result.normal, &result.point_a, &result.point_b}) {
      if (result.outcome != Outcome::hit) break;
      for (int i = 0; i < 3; ++i) hash.add((*x)[i]);
    }
    if (policy == graze::StartPolicy::report) ++count.outcomes[static_cast<int>(result.outcome)];
  }
  const auto line = graze::line_exact(a, b);
  hash.add(static_cast<std::uint64_t>(line.outcome));
  for (const S end : {line.in_lower, line.in_upper, line.out_lower, line.out_upper}) hash.add(end);
}

void print(const char* name, const char* scalar, const Hash& hash, const Count& count) {
  std::printf("%s %s %016llx hits %d misses %d starts %d\n", name, scalar,
              static_cast<unsigned long long>(hash.value()), count.outcomes[int(Outcome::hit)],
              count.outcomes[int(Outcome::miss)], count.outcomes[int(Outcome::initially_overlapping)]);
}

template <Scalar S>
void run(const Kind& kind, int cases, const char* scalar) {
  Draw<S> draw{Bits{20260501}, kind};
  Hash hash;
  Count count;
  const int scatter = std::same_as<S, float> ? kind.scatter / 3 : kind.scatter;
  for (int i = 0; i < cases; ++i) {
    const int up = scatter > 0 ? draw.bits.below(2 * scatter + 1) - scatter : 0;
    const int faster = scatter > 0 ? draw.bits.below(2 * scatter + 1) - scatter : 0;
    const auto [a, b] = draw.pair(power(kind.exponent + up), power(kind.exponent + up + (i % 2) * faster));
    cast_pair(a, b, i % 3 == 0 ? S(2) : graze::kInfinity<S>, hash, count);
  }
  print(kind.name, scalar, hash, count);
}

// Turning twice by an angle against turning once by nearly twice that angle: bodies about 16 z^4 x apart, and
// the time is a subnormal double, or below them all.
void run_subnormal_times() {
  Hash hash;
  Count count;
  for (int e = -190; e <= -150; ++e) {
    const double z = power(e), x = power(-199), speed = power(199);
    const Shape<double> arm = Segment<double>{{x, 0, 0}, {x, 0, 0}};
    const Vec3<double> origin = Vec3<double>::Zero();
    const Quaternion<double> once{1, 0, 0, z}, at_once{1, 0, 0, 2 * z};
    Body<double> a, b;
    a.shape = graze::sum<double>(graze::posed<double>(graze::posed<double>(arm, origin, once), origin, once),
                                 Box<double>{{0, 1, 1}});
    b.shape = graze::posed<double>(arm, origin, at_once);
    for (const double v : {speed, -speed}) {
      b.displacement = {v, 0, 0};
      cast_pair(a, b, graze::kInfinity<double>, hash, count);
    }
  }
  print("subnormal_times", "double", hash, count);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "flush") == 0) {
#if defined(__SSE2__)
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#else
    std::puts("no flush");
    return 77;
#endif
  }
  constexpr int kCases = 4000;
  for (const Kind& kind : kKinds) {
    run<double>(kind, kCases, "double");
    run<float>(kind, kCases, "float");
  }
  run_subnormal_times();
  return 0;
}
