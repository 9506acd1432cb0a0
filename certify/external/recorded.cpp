#include "certify/external/recorded.hpp"

#include "certify/external/read_answer.hpp"
#include "certify/external/terms.hpp"
#include "corpus/format/json_value.hpp"

namespace graze::external {

using corpus::Case;
using corpus::JsonValue;
using corpus::Query;

namespace {

void hold(const JsonValue& answer, Offer& offer) {
  const auto has = [&](std::string_view key) { return answer.find(key) != nullptr; };
  offer.holds.time |= has("time");
  offer.holds.normal |= has("normal");
  offer.holds.witnesses |= has("point_a") || has("point_b");
  offer.holds_distance |= has("distance");
  offer.holds_depth |= has("depth");
  offer.holds_proof |= has("proof");
}

}  // namespace

std::optional<Question> question_of(const Case& problem) {
  switch (problem.query) {
    case Query::cast:
      return engine::turns(problem) ? Question::rotating_cast : Question::cast;
    case Query::overlap:
      return Question::overlap;
    case Query::distance:
      return Question::distance;
    case Query::penetration:
      return Question::penetration;
    default:
      return {};
  }
}

Declaration declaration_of(const RecordedLines& lines, std::span<const Case> problems) {
  Declaration out;
  out.name = "answers";
  out.scalar = "double";
  out.shapes = {"point", "segment",  "triangle", "sphere", "capsule", "box", "ellipsoid",
                "hull",  "cylinder", "cone",     "posed",  "rounded", "sum", "hull_of"};
  out.infinite_t_max = true;
  std::map<Question, Offer> offers;
  for (const Case& problem : problems) {
    const std::optional<Question> question = question_of(problem);
    const auto line = lines.find(problem.id);
    if (!question || line == lines.end()) continue;
    Offer& offer = offers[*question];
    offer.question = *question;
    offer.takes_target_distance = offer.takes_pass_over = true;
    const corpus::ParsedJson parsed = corpus::parse_json(line->second);
    if (!parsed.error && parsed.value.kind == JsonValue::Kind::object) hold(parsed.value, offer);
  }
  for (const auto& [question, offer] : offers) out.offers.push_back(offer);
  return out;
}

Recorded::Recorded(Declaration declaration, RecordedLines lines, const Held& held)
    : declaration_(std::move(declaration)), lines_(std::move(lines)) {
  declaration_.lengths.reset();
  guarantees_.reserve(declaration_.offers.size());
  methods_.reserve(declaration_.offers.size());
  for (const Offer& offer : declaration_.offers) {
    if (offer.question == Question::ray) continue;
    const engine::Guarantee& row = guarantees_.emplace_back(guarantee_of(declaration_, offer, held));
    methods_.push_back(method_of(declaration_, offer, row, true,
                                 [this](const Offer& asked, const Terms& terms, const Case& problem) {
                                   return answer(asked, terms, problem);
                                 }));
  }
}

engine::Answer Recorded::answer(const Offer& offer, const Terms& terms, const Case& problem) const {
  const auto line = lines_.find(problem.id);
  return line == lines_.end() ? declined(terms) : read_answer(line->second, problem.id, offer, terms);
}

}  // namespace graze::external
