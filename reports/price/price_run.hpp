// One run: every table, its errors first, on as many threads as there are, then its times, on one.
//
// Times are interleaved. In every round every case is put to every contender, in an order that is drawn anew, so that
// other load on the machine affects all contenders alike. A ratio divides two times of one round. It is the geometric
// mean over the cases that both answer, and its spread is that of the rounds. The measured time is the processor time
// of one call, repeated for at least 50 microseconds. Caches are warm and branches are predicted.
#pragma once

#include <functional>

#include "reports/price/contenders.hpp"

namespace graze::price {

struct RunSettings {
  bool thorough = false;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  int rounds = 5;
  std::vector<const engine::Method*> others = {};  // third-party engines
  std::vector<std::string> only = {};              // groups, series or names of tables, empty for all
  std::function<bool()> stop = [] { return false; };
  std::function<void(const Document&)> keep = [](const Document&) {};  // after every table
};

// Continues with `begun`: its tables are not measured again.
[[nodiscard]] Document run(const RunSettings& settings, Document begun = {});

// True for the name, the group or the series of a table.
[[nodiscard]] bool is_known(const std::string& name, bool thorough);

// One table, for tests as well.
[[nodiscard]] PriceTable measure_table(const Topic& topic, const std::vector<Contender>& contenders,
                                       const RunSettings& settings);

}  // namespace graze::price
