#include "certify/suites.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace graze::tool {

std::vector<const corpus::Family*> wanted_families(const std::vector<std::string>& names,
                                                   bool files_are_given) {
  std::vector<const corpus::Family*> wanted;
  if (names.empty() && !files_are_given) {
    for (const auto list : {corpus::families(), corpus::rotating_families()}) {
      for (const corpus::Family& family : list) wanted.push_back(&family);
    }
  }
  for (const std::string& name : names) {
    const corpus::Family* family = corpus::find_family(name);
    if (family == nullptr) {
      throw std::runtime_error(
          fmt::format("--family: {} is no family; `graze generate --help` lists them", name));
    }
    wanted.push_back(family);
  }
  return wanted;
}

Suite drawn_suite(const corpus::Family& family, std::span<const double> levels, std::size_t count,
                  std::uint64_t seed) {
  return {.family = std::string(family.name), .drawn = count, .draw = [=, &family](std::size_t i) {
            const std::size_t number = levels.size();
            std::size_t level = 0, share = 0;
            for (; i >= (share = (count + number - 1 - level) / number); ++level) i -= share;
            return family.generate(levels[level], seed + level + i * number);
          }};
}

}  // namespace graze::tool
