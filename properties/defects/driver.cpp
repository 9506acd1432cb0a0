// Finds the laws that notice a planted defect. Runs laws over generated cases, and prints for each where it broke
// first.
//
//   driver --laws               one line a law: its name, its kind (linear, query, rotating), and what it
//                               needs (metamorphic, proof, oracle)
//   driver KIND CASES [LAW...]  all laws of a kind, or those named, cheap ones first. One line a law, as soon
//                               as it is known: "LAW broken CASE", "LAW crashed CASE", "LAW hangs CASE", and
//                               at the end "LAW holds CASES". Exit 1 if one is broken; 2: no such law or
//                               kind. With laws named, a reason and the case go to the standard error.
//
// The methods come from the translation units that it is linked with: catalogue.py compiles one of them
// against patched headers of core, or a file of an oracle, and leaves everything else as it is.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "properties/defects/sample.hpp"
#include "properties/defects/trial.hpp"

namespace {

using namespace graze::law;  // the room whose laws are tried

constexpr std::array kKinds = {Kind::linear, Kind::query, Kind::rotating};

int usage(const char* what) {
  std::fprintf(stderr, "%s\nusage: driver --laws, or driver linear|query|rotating CASES [LAW...]\n", what);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words == std::vector<std::string>{"--laws"}) {
    for (const Law& law : laws()) {
      std::printf("%s %s %s\n", law.name.c_str(), std::string(to_text(law.kind)).c_str(),
                  std::string(to_text(law.needs)).c_str());
    }
    return 0;
  }
  if (words.size() < 2) return usage("too few words");
  const auto kind =
      std::find_if(kKinds.begin(), kKinds.end(), [&](Kind one) { return to_text(one) == words[0]; });
  if (kind == kKinds.end()) return usage("no such kind of laws");
  int count = 0;
  if (std::sscanf(words[1].c_str(), "%d", &count) != 1 || count < 1) return usage("CASES is 1 or more");
  std::vector<Law> laws = laws_of(*kind);
  if (words.size() > 2) {
    std::vector<Law> named;
    for (std::size_t i = 2; i < words.size(); ++i) {
      const std::size_t before = named.size();
      for (const Law& law : laws) {
        if (law.name == words[i]) named.push_back(law);
      }
      if (named.size() == before) return usage(("no law " + words[i] + " of this kind").c_str());
    }
    laws = named;
  }
  return try_laws(laws, sample_for(*kind, count), words.size() > 2) ? 1 : 0;
}
