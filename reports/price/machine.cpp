// Describes the machine of a run.
#include <fmt/format.h>

#include <thread>

#include "engines/system/system.hpp"
#include "reports/price/document.hpp"

namespace graze::price {

Machine this_machine() {
  Machine machine{.processor = system::processor_model(), .compiler = "unknown", .build = "unknown"};
  machine.cores = std::thread::hardware_concurrency();
#if defined(__clang__)
  machine.compiler = fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  machine.compiler = fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
  machine.build = GRAZE_PRICE_BUILD;
  machine.load = system::load().value_or(machine.load);
  return machine;
}

}  // namespace graze::price
