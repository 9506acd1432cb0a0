#include "properties/laws/any_law.hpp"

#include "corpus/format/names.hpp"

namespace graze::law {

AnyLaw any(const Law& law) {
  AnyLaw one{Kind::linear, std::string(law.name), std::string(law.sentence), law.needs, {}, {}};
  for (const engine::EngineMethod& method : engine::methods()) one.methods.push_back(method.full_name());
  one.check = [check = law.check](const corpus::Case& problem, std::size_t method) {
    return check(problem, engine::methods()[method]);
  };
  return one;
}

AnyLaw any(const QueryLaw& law) {
  AnyLaw one{Kind::query, std::string(law.name), std::string(law.sentence), law.needs, {}, {}};
  for (const engine::QueryMethod& method : engine::query_methods()) {
    one.methods.push_back(std::string(corpus::name_of(method.query)) + " " + method.full_name());
  }
  one.check = [check = law.check](const corpus::Case& problem, std::size_t method) {
    return check(problem, engine::query_methods()[method]);
  };
  return one;
}

AnyLaw any(const RotatingLaw& law) {
  AnyLaw one{Kind::rotating, std::string(law.name), std::string(law.sentence), law.needs, {}, {}};
  for (const engine::RotatingEngineMethod& method : engine::rotating_methods()) {
    one.methods.push_back(method.full_name());
  }
  one.check = [check = law.check](const corpus::Case& problem, std::size_t method) {
    return check(problem, engine::rotating_methods()[method]);
  };
  return one;
}

std::vector<AnyLaw> all_laws() {
  std::vector<AnyLaw> all;
  for (const Law& law : laws()) all.push_back(any(law));
  for (const QueryLaw& law : query_laws()) all.push_back(any(law));
  for (const RotatingLaw& law : rotating_laws()) all.push_back(any(law));
  return all;
}

std::string_view name_of(Kind kind) {
  switch (kind) {
    case Kind::linear:
      return "linear";
    case Kind::query:
      return "query";
    case Kind::rotating:
      return "rotating";
  }
  return "";
}

std::string_view name_of(Needs needs) {
  switch (needs) {
    case Needs::metamorphic:
      return "metamorphic";
    case Needs::proof:
      return "proof";
    case Needs::oracle:
      return "oracle";
  }
  return "";
}

}  // namespace graze::law
