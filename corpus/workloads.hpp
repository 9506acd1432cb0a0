// Workloads: steps of small simulations, 1/60 s each, and the casts that a simulator, a planner or a game
// asks for in them.
//
// A workload is a Family whose cases are the steps of runs, in order: seeds kQuestionsOfRun r .. kQuestionsOfRun r +
// kQuestionsOfRun - 1 are the questions of run r. A run is a simulation of our own (workloads/simulation.hpp), drawn by
// the run's number, and a question is a pair of bodies whose bounds meet within the step. Hardness is the
// place: 0 at the origin, 1 a kilometre away from it. A third of the runs compute in floats.
#pragma once

#include "corpus/families.hpp"

namespace graze::corpus {

inline constexpr std::uint64_t kQuestionsOfRun = 128;

[[nodiscard]] std::span<const Family> workloads();

}  // namespace graze::corpus
