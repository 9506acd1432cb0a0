// Families of generated cases, each with a hardness that can be turned until methods break.
//
// A case is a pure function of (family, hardness, seed) and has the same bits on every platform. The
// generator is our own and uses only integers and correctly rounded operations, in a fixed order, without
// fused multiply-add. For a rotating body this holds for its rotation vector. The pose that the vector leads
// to involves a sine.
//
// Every family varies these by seed:
//   - the shapes,
//   - identity and rotated poses (integer quaternions, so that posed vertices are rationals),
//   - which body moves,
//   - |v| by powers of two,
//   - t_max,
//   - coordinates of three kinds: floats, full doubles and small integers.
#pragma once

#include <span>
#include <string_view>

#include "corpus/case.hpp"

namespace graze::corpus {

class Draw;

struct Family {
  std::string_view name;
  std::string_view sentence;          // why the cases are hard
  std::string_view hardness_meaning;  // the exact quantity that hardness is tied to
  std::span<const double> levels;     // from easy to hard (any integer between the extremes is a level too)
  void (*fill)(Draw&, double, Case&);
  bool rotating = false;  // a body of each case rotates, except in about one case in sixteen
  // For a workload (workloads.hpp), this many seeds in a row are the questions of one simulation run. The run
  // is drawn once, and draw.question selects the question.
  std::uint64_t of_run = 1;
  struct {
    double hardness = 0;
    std::uint64_t seed = 1;
  } picture{};  // the case that the family's page shows, chosen by eye

  // The case `name/h<hardness>/s<seed>`. A hardness is rounded to an integer and brought between the
  // extremes.
  [[nodiscard]] Case generate(double hardness, std::uint64_t seed) const;
};

// The linear families, used to test every method for linear casts, and the families with rotating bodies.
[[nodiscard]] std::span<const Family> families();
[[nodiscard]] std::span<const Family> rotating_families();
// Finds a linear family, a rotating family or a workload. Returns nullptr if no family has this name.
[[nodiscard]] const Family* find_family(std::string_view name);

}  // namespace graze::corpus
