// Families of generated cases, each with a hardness that can be turned until methods break.
//
// A case is a pure function of (family, hardness, seed): the same bits on every platform (own generator,
// integers and correctly rounded operations only, in a fixed order; no fused multiply-add). Of a body that
// turns, that is said of its rotation vector; where the vector takes it involves a sine.
//
// What every family mixes, by seed: the shapes; identity and rotated poses (integer quaternions, so that
// posed vertices are rationals); which body moves; |v| by powers of two; t_max; and coordinates of three
// kinds: floats, full doubles and small integers.
#pragma once

#include <span>
#include <string_view>

#include "corpus/case.hpp"

namespace graze::corpus {

class Draw;

struct Family {
  std::string_view name;
  std::string_view sentence;          // what is hard about it
  std::string_view hardness_meaning;  // the exact quantity that hardness is tied to
  std::span<const double> levels;     // from easy to hard; any integer between the extremes is one too
  void (*fill)(Draw&, double, Case&);
  bool rotating = false;  // a body of each case turns, but for one in sixteen or so
  // Of a workload (workloads.hpp): so many seeds in a row are the questions of one run of a simulation, which is
  // drawn once; draw.question says which is wanted.
  std::uint64_t of_run = 1;
  struct {
    double hardness = 0;
    std::uint64_t seed = 1;
  } picture{};  // the case that the family's page shows, chosen by eye

  // The case `name/h<hardness>/s<seed>`. A hardness is rounded to an integer and brought between the
  // extremes.
  [[nodiscard]] Case generate(double hardness, std::uint64_t seed) const;
};

// The linear families, which every method for linear casts is judged by; and those in which bodies turn.
[[nodiscard]] std::span<const Family> families();
[[nodiscard]] std::span<const Family> rotating_families();
// Of either kind, or a workload; nullptr if there is none.
[[nodiscard]] const Family* find_family(std::string_view name);

}  // namespace graze::corpus
