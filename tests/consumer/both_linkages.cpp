// One program holds graze header-only and compiled, and gets the same bits from both.
#include <cmath>
#include <cstdio>
#include <vector>

std::vector<double> answers_header_only(int scenes);
std::vector<double> answers_compiled(int scenes);

int main() {
  constexpr int kScenes = 200;
  const std::vector<double> here = answers_header_only(kScenes), there = answers_compiled(kScenes);
  std::size_t differ = here.size() == there.size() ? 0 : here.size();
  for (std::size_t i = 0; differ == 0 && i < here.size(); ++i) {
    if (here[i] != there[i] && !(std::isnan(here[i]) && std::isnan(there[i]))) ++differ;
  }
  std::printf("%zu numbers from %d scenes, %zu differ\n", here.size(), kScenes, differ);
  return differ == 0 && here.size() > 10000 ? 0 : 1;
}
