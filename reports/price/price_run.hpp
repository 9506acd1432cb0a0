// One run: every table, its errors first, on as many threads as there are, then its times, on one.
//
// Times are interleaved. In every round every case is put to every contender, in an order that is drawn anew,
// so that what else the machine does falls on all alike; a ratio is of two times of one round, the geometric
// mean over the cases that both answer, and its spread is that of the rounds. What is timed is the
// processor time of one call, repeated over and over for 50 microseconds at least: caches are warm, and branches are learnt.
#pragma once

#include <functional>

#include "reports/price/contenders.hpp"

namespace graze::price {

struct RunSettings {
  bool thorough = false;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  int rounds = 5;
  std::vector<const engine::Method*> others = {};  // engines of others
  std::vector<std::string> only = {};              // groups, series or names of tables; empty: all
  std::function<bool()> stop = [] { return false; };
  std::function<void(const Document&)> keep = [](const Document&) {};  // after every table
};

// Goes on with what `begun` has: tables that are there are not measured again.
[[nodiscard]] Document run(const RunSettings& settings, Document begun = {});

// Whether it is the name, the group or the series of a table.
[[nodiscard]] bool is_known(const std::string& name, bool thorough);

// One table, for tests as well.
[[nodiscard]] PriceTable measure_table(const Topic& topic, const std::vector<Contender>& contenders,
                                       const RunSettings& settings);

}  // namespace graze::price
