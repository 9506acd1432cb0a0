#include "certify/external/engine_methods.hpp"

#include <fmt/format.h>

#include <memory>

namespace graze::external {

using engine::Kind;

namespace {

engine::Kind kind_of(Question question) {
  switch (question) {
    case Question::cast:
    case Question::ray:
      return Kind::linear;
    case Question::rotating_cast:
      return Kind::rotating;
    default:
      return Kind::query;
  }
}

corpus::Query query_of(Question question) {
  switch (question) {
    case Question::overlap:
      return corpus::Query::overlap;
    case Question::distance:
      return corpus::Query::distance;
    case Question::penetration:
      return corpus::Query::penetration;
    default:
      return corpus::Query::cast;
  }
}

}  // namespace

engine::Guarantee guarantee_of(const Declaration& engine, const Offer& offer, const Held& held) {
  const bool is_held = held.tolerance || held.relative_tolerance || held.kappa;
  const bool is_assumed = !held.measure && !is_held && !offer.promises_errors();
  const std::optional<double>& tolerance = is_held ? held.tolerance : offer.tolerance;
  const std::optional<double>& relative = is_held ? held.relative_tolerance : offer.relative_tolerance;
  const std::optional<double>& kappa = is_held ? held.kappa : offer.kappa;
  // A ray has its own name if the engine also has a cast.
  const std::string name =
      engine.name + (offer.question == Question::ray ? fmt::format("-{}", to_text(offer.question)) : "");
  const Kind kind = kind_of(offer.question);
  engine::Guarantee row;
  row.query = kind == Kind::rotating ? "rotating"
              : kind == Kind::query  ? std::string(to_text(offer.question))
                                     : "cast";
  row.method = name;
  row.scalar = engine.scalar;
  row.tier = "declared";
  row.kappa_polytope = row.kappa_rounded = kappa.value_or(0);
  row.tolerance = tolerance.value_or(0);
  row.relative_tolerance = is_assumed ? kAssumedRelativeTolerance : relative.value_or(0);
  row.early = offer.early;
  row.own_frames = offer.own_frames;
  row.is_open = held.measure;
  row.is_assumed = is_assumed;
  row.most_supports = held.measure ? std::nullopt : offer.most_supports;
  row.stall_cap = row.is_open ? 1 : offer.stalls;
  row.touching = offer.touching;
  row.start_normal = offer.start_normal;
  return row;
}

engine::Method method_of(const Declaration& engine, const Offer& offer, const engine::Guarantee& row,
                         bool beyond, Answering answering) {
  engine::Method method;
  method.kind = kind_of(offer.question);
  method.query = query_of(offer.question);
  method.name = row.method;
  method.scalar = engine.scalar;
  method.tier = row.tier;
  method.unit_roundoff = engine.unit_roundoff();
  method.holds = offer.holds;
  method.asks_starts = offer.starts;
  method.guarantee = &row;
  method.seen = [&engine, &offer](const corpus::Case& problem) {
    return in_terms_of(engine, offer, problem, true).seen;
  };
  method.refuses = [&engine, &offer, beyond](const corpus::Case& problem) {
    return in_terms_of(engine, offer, problem, beyond).refused;
  };
  method.ask = [&engine, &offer, answering](const corpus::Case& problem, const engine::Ask&) {
    const Terms terms = in_terms_of(engine, offer, problem, true);
    return terms.refused.empty() ? answering(offer, terms, problem) : declined(terms);
  };
  method.engine_view = [&engine, &offer, beyond,
                        answering = std::move(answering)](const corpus::Case& problem) {
    const auto terms = std::make_shared<const Terms>(in_terms_of(engine, offer, problem, beyond));
    engine::EngineView own{.refused = terms->refused, .beyond_limits = terms->beyond_limits};
    if (!own.refused.empty()) return own;
    own.seen = terms->seen;
    own.ask = [&offer, terms, answering, problem](const engine::Ask&) {
      return answering(offer, *terms, problem);
    };
    return own;
  };
  return method;
}

engine::Answer declined(const Terms& terms) {
  engine::Answer none = engine::not_taken();
  none.declined = true;
  none.message = terms.refused;
  return none;
}

}  // namespace graze::external
