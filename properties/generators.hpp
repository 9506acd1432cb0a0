// The laws' generator as RapidCheck sees it. Only tests include this.
#pragma once

#include <rapidcheck.h>

#include "corpus/case_io.hpp"
#include "properties/draw_case.hpp"
#include "properties/shrink.hpp"

namespace graze::law {

// A case as RapidCheck prints it: one line of JSON, ready for `graze cast`.
struct Drawn {
  corpus::Case problem;
};

inline void showValue(const Drawn& drawn, std::ostream& out) { out << corpus::write_case(drawn.problem); }

[[nodiscard]] inline rc::Gen<Drawn> cases() {
  return [](const rc::Random& random, int size) {
    rc::Random source = random;
    corpus::Random own(source.next());
    Drawn drawn{draw_case(own, size)};
    drawn.problem.id = "drawn/one";
    return rc::shrinkable::shrinkRecur(std::move(drawn), [](const Drawn& one) {
      std::vector<Drawn> all;
      for (corpus::Case& c : simpler(one.problem)) all.push_back({std::move(c)});
      return rc::seq::fromContainer(std::move(all));
    });
  };
}

}  // namespace graze::law
