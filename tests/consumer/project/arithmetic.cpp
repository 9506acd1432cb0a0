// Compiled with flags of every kind: does a query's validation accept two balls? Prints "kept" or "refused".
#include <graze/validate.hpp>

#include <cstdio>

int main() {
  const graze::Body<double> a{.shape = graze::Sphere<double>{1}}, b = a;
  switch (graze::validate(a, b, graze::CastOptions<double>{})) {
    case graze::Invalid::none:
      std::puts("kept");
      return 0;
    case graze::Invalid::unsafe_math:
      std::puts("refused");
      return 0;
    default:
      std::puts("neither");
      return 1;
  }
}
