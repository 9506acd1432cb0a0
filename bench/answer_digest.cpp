// A digest of the answers of tiers exact and certified on the families of the corpus. Two builds with equal lines gave
// the same bits. Use it for a change of the search that must not change any answer:
//
//   answer_digest --count N > before
//   (make the change, rebuild)
//   answer_digest --count N > after
//   diff before after
//
// Each family gets one line: its name, the number of casts, and three FNV-1a hashes. They cover the outcomes and
// brackets of tier exact in double, the same in float, and the outcomes of tier certified. With --each, every answer of
// tier exact is printed instead, to find the case that differs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <graze/cast.hpp>

#include "corpus/families.hpp"
#include "engines/convert.hpp"

namespace graze::bench {
namespace {

class Digest {
 public:
  void add(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ (word >> (8 * byte) & 0xff)) * 0x100000001b3u;
  }
  template <Scalar S>
  void add(const CastResult<S>& r) {
    add(static_cast<std::uint64_t>(r.outcome) | static_cast<std::uint64_t>(r.invalid) << 8 |
        static_cast<std::uint64_t>(r.passed_over) << 16);
    add(std::bit_cast<std::uint64_t>(static_cast<double>(r.toi_lower)));
    add(std::bit_cast<std::uint64_t>(static_cast<double>(r.toi_upper)));
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

template <Scalar S>
CastResult<S> answer(const corpus::Case& c, Tier tier, Request request) {
  const auto body = [](const Body<double>& given) {
    return Body<S>{.shape = engine::round_to<S>(given.shape),
                   .position = engine::round_to<S>(given.position),
                   .orientation = engine::round_to<S>(given.orientation),
                   .displacement = engine::round_to<S>(given.displacement)};
  };
  CastOptions<S> options{.tier = tier, .request = request};
  options.t_max = static_cast<S>(c.t_max);
  options.target_distance = static_cast<S>(c.target_distance);
  options.start_policy = c.start_policy;
  return cast(body(c.a), body(c.b), options);
}

int run(int argc, char** argv) {
  CLI::App app("A digest of what tiers exact and certified answer, by family.");
  std::uint64_t count = 1000;
  std::string part;
  bool each = false;
  app.add_option("--count", count, "cases of each family, over all its levels of hardness");
  app.add_option("--family", part, "only families whose name contains this");
  app.add_flag("--each", each, "every answer of tier exact");
  CLI11_PARSE(app, argc, argv);
  for (const corpus::Family& family : corpus::families()) {
    if (family.name.find(part) == std::string_view::npos) continue;
    Digest exact, single, certified;
    for (std::uint64_t k = 0; k < count; ++k) {
      const double level = family.levels[k % family.levels.size()];
      const corpus::Case c = family.generate(level, 1 + k / family.levels.size());
      const CastResult<double> r =
          answer<double>(c, Tier::exact, k % 2 == 0 ? Request::everything : Request::verdict);
      exact.add(r);
      single.add(answer<float>(c, Tier::exact, Request::verdict));
      certified.add(static_cast<std::uint64_t>(answer<double>(c, Tier::certified, Request::verdict).outcome));
      if (each) fmt::print("{} {} {:a} {:a}\n", c.id, to_text(r.outcome), r.toi_lower, r.toi_upper);
    }
    if (!each)
      fmt::print("{:24} {:8} {:016x} {:016x} {:016x}\n", family.name, count, exact.value(), single.value(),
                 certified.value());
  }
  return 0;
}

}  // namespace
}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
