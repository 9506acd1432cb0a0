// The cases that the laws see when a defect is planted: generated, the same in every run, and none of them
// curated, so that a law has to find the defect by itself.
#pragma once

#include <vector>

#include "corpus/case.hpp"
#include "properties/laws/law.hpp"

namespace graze::law {

struct Sample {
  std::vector<corpus::Case> all;   // for every law
  std::vector<corpus::Case> ties;  // for laws that judge by proof, in microseconds (several times as many)
};

// Linear and query: half drawn, half from the easier half of the families' levels, a few balls on near ties and a few
// large hulls. The near-ties of linear laws are casts, some of them on the flanks of round bodies. Those of queries are
// hulls face to face that hardly touch, and smooth bodies in each other. Rotating: drawn, every eighth from the
// rotating families, and a few large hulls, without near-ties.
[[nodiscard]] Sample sample_for(Kind kind, int count);

}  // namespace graze::law
