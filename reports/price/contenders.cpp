#include "reports/price/contenders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/format/names.hpp"

namespace graze::price {

using corpus::Case;
using engine::Kind;
using engine::Method;

namespace {

// "mpr", "swept_overlap mpr", "rotating ca".
std::string name_without_scalar(const Method& method) {
  std::string name = method.question_name();
  return name.substr(0, name.rfind('/'));
}

bool is_meant(const Topic& topic, const Method& method) {
  if (topic.methods.empty()) return method.kind == topic.kind;
  return std::find(topic.methods.begin(), topic.methods.end(), name_without_scalar(method)) !=
         topic.methods.end();
}

std::string question_of(const Method& method) {
  if (method.kind == Kind::rotating) return "rotating cast";
  return std::string(corpus::name_of(method.query));
}

// Methods whose measure of accuracy is the number of their steps, not a tolerance.
bool steps(const Method& method) {
  return method.kind == Kind::rotating && (method.name == "steps" || method.name == "spheres");
}

std::string label_of(const Topic& topic, const Method& method, const engine::Ask& ask) {
  std::string label = (method.kind == Kind::query ? std::string(corpus::name_of(method.query)) + " " : "") +
                      method.full_name();
  if (ask.tolerance > 0) label += fmt::format(" {:.0e}", ask.tolerance);
  if (ask.time_steps > 0) label += fmt::format(" {} steps", ask.time_steps);
  if (topic.requests.size() > 1) {
    label +=
        fmt::format(" {}", ask.request == Request::verdict ? (method.kind == Kind::query ? "verdict" : "time")
                                                           : to_text(ask.request));
  }
  return label;
}

}  // namespace

std::vector<double> tolerances_of(const Method& method, bool thorough) {
  if (method.tier != "standard") return {0};
  // A float's rounding is 6e-8, a double's 1e-16: below some ten of them nothing is left to ask for.
  const int finest = method.in_float() ? 6 : 15;
  std::vector<double> out;
  for (int k = 1; k <= finest; ++k) {
    if (thorough || k <= 4 || k % 2 == 0) out.push_back(std::pow(10.0, -k));
  }
  out.push_back(0);
  return out;
}

std::vector<Contender> contenders_of(const Topic& topic, const std::vector<const Method*>& others,
                                     bool thorough) {
  std::vector<const Method*> methods;
  for (const Method& method : engine::methods()) {
    if (is_meant(topic, method) && (topic.in_float || !method.in_float())) methods.push_back(&method);
  }
  if (topic.methods.empty()) {
    for (const Method* method : others) {
      if (method->kind == topic.kind) methods.push_back(method);
    }
  }
  std::vector<Contender> out;
  const auto add = [&](const Method& method, const engine::Ask& ask) {
    Row head{.label = label_of(topic, method, ask),
             .question = question_of(method),
             .method = method.name,
             .scalar = method.scalar,
             .tier = method.tier,
             .request = std::string(to_text(ask.request)),
             .tolerance = ask.tolerance,
             .ours = method.is_ours()};
    out.push_back({&method, ask, std::move(head)});
  };
  for (const Method* method : methods) {
    if (topic.requests.size() > 1) {
      for (const Request request : topic.requests) {
        if (request == Request::verdict || method->kind != Kind::query) add(*method, {.request = request});
      }
    } else if (!topic.sweeps || !method->is_ours()) {
      add(*method, {.request = topic.requests.front()});
    } else if (steps(*method)) {
      for (const int count : {16, 64, 256, 1024}) {
        add(*method, {.request = topic.requests.front(), .time_steps = count});
      }
    } else {
      for (const double tolerance : tolerances_of(*method, thorough))
        add(*method, {.request = topic.requests.front(), .tolerance = tolerance});
    }
  }
  return out;
}

bool takes(const Method& method, const Case& problem) {
  if (!method.is_ours()) return method.refuses(problem).empty();
  return !method.is_exact() || engine::is_exact_question(problem);
}

}  // namespace graze::price
