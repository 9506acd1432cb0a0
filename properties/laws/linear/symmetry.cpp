// Laws of symmetry: the whole problem rotated or mirrored, and the same bodies given by other numbers. If two answers
// differ, the oracle arbitrates (judge.hpp).
#include "properties/edit/integer_turn.hpp"
#include "properties/edit/same_body.hpp"
#include "properties/laws/ask_twice.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Method;

LawResult permuting_the_axes(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  for (std::uint64_t salt = mix(hash_of(seen) ^ 0x61786573u), tries = 0; tries < 4; ++tries, ++salt) {
    const bool mirror = (salt >> 32 & 1) != 0;
    const std::optional<Case> other =
        turned_by(mirror ? mirrored(seen) : seen, axis_permutation(salt), (salt >> 33 & 1) != 0);
    if (!other || !is_sound_edit(*other, method)) continue;
    LawResult result = same_contact(method, seen, *other, mirror ? "the mirrored" : "the turned",
                                    "permuting the axes changes the answer");
    if (result.holding == Holding::holds) result.labels.push_back(mirror ? "mirrored" : "turned");
    return result;
  }
  return not_applicable("a permutation of the axes takes rounding");
}

LawResult turning(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  for (std::uint64_t salt = mix(hash_of(seen) ^ 0x7475726eu), tries = 0; tries < 4; ++tries, ++salt) {
    const bool in_place = (salt >> 32 & 1) != 0;
    const std::optional<Case> other = turned_by(seen, pythagorean(salt), in_place);
    if (!other || !is_sound_edit(*other, method)) continue;
    LawResult result = same_contact(method, seen, *other, "the turned", "turning changes the answer");
    if (result.holding == Holding::holds)
      result.labels.push_back(in_place ? "vertices turned" : "poses turned");
    return result;
  }
  return not_applicable("every rotation tried takes rounding");
}

using Edit = std::optional<Shape<double>> (*)(const Shape<double>&, std::uint64_t);

namespace {

// A, B or both given by other numbers.
LawResult redescribed(const Case& problem, const Method& method, Edit edit, std::string_view name,
                      std::string_view disagreement) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  for (std::uint64_t salt = mix(hash_of(seen) ^ 0x73616d65u), tries = 0; tries < 4; ++tries, ++salt) {
    Case other = seen;
    other.expect.reset();
    const std::uint64_t which = 1 + (salt >> 32) % 3;
    bool changed = false;
    for (Body<double>* body : {&other.a, &other.b}) {
      if (((body == &other.a ? 1U : 2U) & which) == 0) continue;
      if (auto shape = edit(body->shape, mix(salt))) {
        body->shape = *std::move(shape);
        changed = true;
      }
    }
    if (!changed || !is_sound_edit(other, method)) continue;
    return same_contact(method, seen, other, name, disagreement);
  }
  return not_applicable("no other exact description of the bodies");
}

LawResult reordering(const Case& problem, const Method& method) {
  return redescribed(problem, method, &reordered, "the reordered",
                     "another order of vertices or parts changes the answer");
}

LawResult redundant_points(const Case& problem, const Method& method) {
  return redescribed(problem, method, &with_redundant_points, "with redundant points",
                     "points of a hull besides its vertices change the answer");
}

LawResult describing_otherwise(const Case& problem, const Method& method) {
  return redescribed(problem, method, &described_otherwise, "the other description",
                     "another description of a body changes the answer");
}

}  // namespace

std::vector<Law> linear_symmetry_laws() {
  return {
      {"permuting_the_axes", "The 48 signed permutations of the axes change no contact.", Needs::metamorphic,
       &permuting_the_axes},
      {"turning",
       "A Pythagorean rotation of both bodies, with every length times its denominator, changes no contact.",
       Needs::metamorphic, &turning},
      {"reordering", "The order of vertices and of parts, and doubling some, change no contact.",
       Needs::metamorphic, &reordering},
      {"redundant_points", "Points of a hull added to its vertices change no contact.", Needs::metamorphic,
       &redundant_points},
      {"describing_otherwise", "Another description of the same set answers the same contact.",
       Needs::metamorphic, &describing_otherwise},
  };
}

}  // namespace graze::law
