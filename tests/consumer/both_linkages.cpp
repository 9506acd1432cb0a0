// One program holds graze compiled and header-only, with assertions and without, and gets the same bits from all.
#include <cmath>
#include <cstdio>
#include <vector>

std::vector<double> answers_headers(int scenes);
std::vector<double> answers_headers_otherwise(int scenes);
std::vector<double> answers_library_float(int scenes);
std::vector<double> answers_library_double(int scenes);

namespace {

constexpr int kScenes = 200;

bool same(const char* scalar, const std::vector<double>& one, const std::vector<double>& other) {
  if (one.size() != other.size()) return false;
  std::size_t differ = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    differ += one[i] != other[i] && !(std::isnan(one[i]) && std::isnan(other[i]));
  std::printf("%s: %zu numbers from %d scenes, %zu differ\n", scalar, one.size(), kScenes, differ);
  return differ == 0 && one.size() > 5000;
}

}  // namespace

int main() {
  const bool floats = same("float", answers_headers(kScenes), answers_library_float(kScenes));
  const bool doubles = same("double", answers_headers_otherwise(kScenes), answers_library_double(kScenes));
  return floats && doubles ? 0 : 1;
}
