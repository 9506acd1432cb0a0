// The laws' generator as RapidCheck sees it. Only tests include this.
#pragma once

#include <rapidcheck.h>

#include "corpus/format/case_io.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/rotating.hpp"
#include "properties/generate/shrink.hpp"

namespace graze::law {

// A case as RapidCheck prints it: one line of JSON, ready for `graze cast`.
struct Drawn {
  corpus::Case problem;
};

inline void showValue(const Drawn& drawn, std::ostream& out) { out << corpus::write_case(drawn.problem); }

// draw: a case from (corpus::Random&, size).
template <class Draw>
[[nodiscard]] rc::Gen<Drawn> cases_by(Draw draw) {
  return [draw](const rc::Random& random, int size) {
    rc::Random source = random;
    corpus::Random own(source.next());
    Drawn drawn{draw(own, size)};
    drawn.problem.id = "drawn/one";
    return rc::shrinkable::shrinkRecur(std::move(drawn), [](const Drawn& one) {
      std::vector<Drawn> all;
      for (corpus::Case& c : simpler(one.problem)) all.push_back({std::move(c)});
      return rc::seq::fromContainer(std::move(all));
    });
  };
}

[[nodiscard]] inline rc::Gen<Drawn> cases() { return cases_by(&draw_case); }
[[nodiscard]] inline rc::Gen<Drawn> rotating_cases() { return cases_by(&draw_rotating); }

}  // namespace graze::law
