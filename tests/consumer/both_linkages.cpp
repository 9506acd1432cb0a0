// One program holds graze compiled and header-only, with assertions and without, and gets the same bits from
// all.
#include <cmath>
#include <cstdio>
#include <vector>

std::vector<double> answers_header_only(int scenes);
std::vector<double> answers_compiled(int scenes);
std::vector<double> answers_otherwise(int scenes);

int main() {
  constexpr int kScenes = 200;
  const std::vector<double> here = answers_header_only(kScenes);
  std::size_t differ = 0;
  for (const std::vector<double>& there : {answers_compiled(kScenes), answers_otherwise(kScenes)}) {
    if (here.size() != there.size()) return 1;
    for (std::size_t i = 0; i < here.size(); ++i)
      differ += here[i] != there[i] && !(std::isnan(here[i]) && std::isnan(there[i]));
  }
  std::printf("%zu numbers from %d scenes, %zu differ\n", here.size(), kScenes, differ);
  return differ == 0 && here.size() > 10000 ? 0 : 1;
}
