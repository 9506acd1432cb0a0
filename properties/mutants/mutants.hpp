// Selects the live mutant of core. A copy of core that mutate.py makes holds all mutants of a sample at once, each
// behind a test of `active`: compiled once, run once a mutant.
//
// None of this is constexpr: an initializer that the compiler could evaluate would silently hold no mutant. A place
// that the compiler must evaluate fails to compile, and mutate.py takes another one.
#pragma once

#include <type_traits>
#include <utility>

namespace graze_mutants {

inline constexpr int kMost = 1024;
extern int active;               // the mutant that is alive, or -1
extern bool comparing;           // evaluate both expressions of every site, and count where they differ
extern unsigned char reached[];  // 1 where a mutant's place was executed
extern long differed[];          // executions in which its value differs from the original's, while comparing

template <int kId>
bool on() {
  static_assert(kId < kMost);
  reached[kId] = 1;
  return active == kId;
}

// A value of its own: no expression template that refers to an expired temporary.
template <class T>
auto value(T&& x) {
  if constexpr (requires { x.eval(); }) {
    return x.eval();
  } else {
    return std::forward<T>(x);
  }
}

template <int kId, class Original, class Mutated>
auto pick(const Original& original, const Mutated& mutated) {
  using Value = std::decay_t<decltype(original())>;
  const bool here = on<kId>();
  if (comparing && active == kId) {
    const Value left = original(), right = Value(mutated());
    if (!(left == right)) ++differed[kId];
    return left;
  }
  return here ? Value(mutated()) : Value(original());
}

}  // namespace graze_mutants
