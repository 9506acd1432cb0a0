// The exact arithmetics that core could have used, side by side. Each computes the sign of a determinant of three
// points of C, which the exact tier needs when pairs of doubles leave it open.
//
//   dyadic      graze/detail/numeric/dyadic.hpp, the choice: one mantissa of as many limbs as it takes, inline
//   expansion   graze/detail/numeric/expansion.hpp: Shewchuk's sums of doubles
//   boost       Boost.Multiprecision's cpp_int, 1,024 bits inline, then the heap, with numbers m 2^e as above
//
// Each point is the sum of four given numbers per coordinate (a vertex and a position of either body), so nothing has
// to be rotated, which expansions cannot do in the range of the input. Kinds of numbers: 24 bits of like size, 53 bits
// of like size, 53 bits with exponents spread over 2^-30 .. 2^0 and over 2^-200 .. 2^200 (out of the expansions'
// range).
#include <benchmark/benchmark.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <graze/detail/numeric/dyadic.hpp>
#include <graze/detail/numeric/expansion.hpp>
#include <vector>

#include "corpus/random.hpp"

namespace graze::bench {
namespace {

using Sum = std::array<double, 4>;
using Point3 = std::array<Sum, 3>;
using Triangle3 = std::array<Point3, 3>;

struct BoostDyadic {
  using Mantissa = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
      1024, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked>>;
  Mantissa m = 0;
  int e = 0;

  BoostDyadic() = default;
  explicit BoostDyadic(double x) {
    if (x == 0) return;
    const double scaled = std::frexp(x, &e) * 0x1p53;
    e -= 53;
    m = static_cast<long long>(scaled);
  }
  friend BoostDyadic operator+(const BoostDyadic& a, const BoostDyadic& b) {
    if (a.m == 0) return b;
    if (b.m == 0) return a;
    if (a.e < b.e) return b + a;
    BoostDyadic out;
    out.m = (a.m << (a.e - b.e)) + b.m;
    out.e = b.e;
    return out;
  }
  friend BoostDyadic operator-(const BoostDyadic& a, const BoostDyadic& b) {
    BoostDyadic negative = b;
    negative.m = -b.m;
    return a + negative;
  }
  friend BoostDyadic operator*(const BoostDyadic& a, const BoostDyadic& b) {
    BoostDyadic out;
    out.m = a.m * b.m;
    out.e = a.e + b.e;
    return out;
  }
  [[nodiscard]] int sign() const { return m.sign(); }
};

template <class N>
N sum(const Sum& terms) {
  N out(terms[0]);
  for (std::size_t i = 1; i < terms.size(); ++i) out = out + N(terms[i]);
  return out;
}
template <class N>
int sign_of(const Triangle3& t) {
  std::array<std::array<N, 3>, 3> c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) c[i][k] = sum<N>(t[i][k]);
  }
  N value = c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]);
  value = value + c[0][1] * (c[1][2] * c[2][0] - c[1][0] * c[2][2]);
  value = value + c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0]);
  return value.sign();
}
template <>
int sign_of<detail::exact::Expansion>(const Triangle3& t) {
  std::array<detail::exact::Expansion3, 3> c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double x : t[i][k]) c[i][k].grow(x);
    }
  }
  return detail::exact::determinant(c[0], c[1], c[2]).sign();
}

// bits: the length of each number. spread: the range of the exponents.
std::vector<Triangle3> draw(int bits, int spread) {
  corpus::Random random(7);
  std::vector<Triangle3> out(256);
  for (Triangle3& t : out) {
    for (Point3& p : t) {
      for (Sum& s : p) {
        for (double& x : s) {
          const double m = static_cast<double>(random.below(std::uint64_t{1} << bits) | 1);
          const int e = spread == 0 ? 0 : random.integer(-spread, spread > 100 ? spread : 0);
          x = std::ldexp(random.once_in(2) ? m : -m, e - bits);
        }
      }
    }
    // A third point in the plane of the origin and the first two, to the last bit: the sums of theirs.
    if (bits < 50) {
      for (std::size_t k = 0; k < 3; ++k)
        t[2][k] = {t[0][k][0] + t[1][k][0], t[0][k][1] + t[1][k][1], t[0][k][2] + t[1][k][2],
                   t[0][k][3] + t[1][k][3]};
    }
  }
  return out;
}

template <class N>
void determinant(benchmark::State& state) {
  const std::vector<Triangle3> triangles =
      draw(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sign_of<N>(triangles[i]));
    i = (i + 1) % triangles.size();
  }
}

void kinds(benchmark::internal::Benchmark* b) {
  b->ArgNames({"bits", "spread"})->Args({24, 0})->Args({53, 0})->Args({53, 30})->Args({53, 200});
}
void kinds_in_range(benchmark::internal::Benchmark* b) {
  b->ArgNames({"bits", "spread"})->Args({24, 0})->Args({53, 0})->Args({53, 30});
}
BENCHMARK(determinant<detail::exact::Dyadic>)->Name("dyadic")->Apply(kinds);
BENCHMARK(determinant<detail::exact::Expansion>)->Name("expansion")->Apply(kinds_in_range);
BENCHMARK(determinant<BoostDyadic>)->Name("boost")->Apply(kinds);

}  // namespace
}  // namespace graze::bench

BENCHMARK_MAIN();
