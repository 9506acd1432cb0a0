// graze serve: our own methods as an engine is asked, by the protocol of docs/reference/protocol.md.
#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "certify/external/declaration.hpp"
#include "corpus/format/case_json.hpp"
#include "corpus/format/names.hpp"
#include "corpus/format/proof_io.hpp"
#include "corpus/format/shape_json.hpp"
#include "engines/guarantees.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"

namespace graze::tool {
namespace {

using corpus::JsonValue;
using corpus::Malformed;
using engine::Answer;
using engine::Kind;
using engine::Method;
using external::Question;

struct ServeArguments {
  std::string method = "mpr", scalar = "double";
};

// The method that answers a question: the one with the given name, or the default for the question.
const Method* method_for(Question question, const ServeArguments& arguments) {
  const std::string name = arguments.method + "/" + arguments.scalar;
  switch (question) {
    case Question::cast:
    case Question::ray:
      return engine::find_method(Kind::linear, name);
    case Question::rotating_cast:
      return engine::find_method(Kind::rotating, name);
    case Question::overlap:
      return engine::find_method(corpus::Query::overlap, name);
    case Question::distance:
      return engine::find_method(corpus::Query::distance, name);
    case Question::penetration:
      return engine::find_method(corpus::Query::penetration, name);
  }
  return nullptr;
}

constexpr Question kQuestions[] = {Question::cast,    Question::rotating_cast, Question::ray,
                                   Question::overlap, Question::distance,      Question::penetration};

std::string answers_of(Question question) {
  switch (question) {
    case Question::cast:
      return R"("time", "normal", "witnesses", "proof")";
    case Question::ray:
    case Question::rotating_cast:
      return R"("time", "normal", "witnesses")";
    case Question::distance:
      return R"("distance", "normal", "witnesses")";
    case Question::penetration:
      return R"("depth", "normal", "witnesses")";
    case Question::overlap:
      break;
  }
  return "";
}

// The guarantee of a method, as a promise in the protocol. A guarantee of the proved tiers is stronger than the
// protocol can express. For linear questions, a kappa of 1 in double is far above their widths.
std::string promise_of(const Method& method) {
  const engine::Guarantee& row = *method.guarantee;
  const double kappa = std::max({row.kappa_polytope, row.kappa_rounded, row.kappa_contact.value_or(0)});
  const double own_frames = method.is_certified() ? engine::kOwnFramesOfCertified : 0;
  return fmt::format(R"("kappa": {}, "relative_tolerance": {}, "own_frames": {}, "stalls": {})",
                     corpus::json_number(kappa), corpus::json_number(row.width.value_or(0)),
                     corpus::json_number(own_frames), corpus::json_number(row.stall_cap));
}

// graze.engine/1
std::string declaration(const ServeArguments& arguments) {
  std::string queries;
  for (const Question question : kQuestions) {
    const Method* method = method_for(question, arguments);
    if (method == nullptr) continue;
    const bool takes_more = question == Question::cast;
    queries += fmt::format(R"({}"{}": {{"answers": [{}], {}{}}})", queries.empty() ? "" : ", ",
                           to_text(question), answers_of(question), promise_of(*method),
                           takes_more ? R"(, "target_distance": true, "pass_over": true)"
                           : question == Question::rotating_cast ? R"(, "target_distance": true)"
                                                                 : "");
  }
  if (queries.empty()) {
    throw std::runtime_error(fmt::format("--method: {}/{} is no method; graze cast --help lists them",
                                         arguments.method, arguments.scalar));
  }
  return fmt::format(
      R"({{"schema": "graze.engine/1", "name": "graze-{}-{}", "version": "{}", "about": "graze itself", )"
      R"("scalar": "{}", "shapes": ["point", "segment", "triangle", "sphere", "capsule", "box", "ellipsoid", )"
      R"("cylinder", "cone", "hull", "posed", "rounded", "sum", "hull_of"], "infinite_t_max": true, "timed": true, )"
      R"("queries": {{{}}}}})",
      arguments.method, arguments.scalar, GRAZE_VERSION, arguments.scalar, queries);
}

struct Asked {
  std::string id;
  Question question = Question::cast;
  corpus::Case problem;
  std::size_t repeat = 0;
};

Asked read_question(const JsonValue& value) {
  using namespace corpus;
  const Fields fields(value, "",
                      {"schema", "id", "query", "a", "b", "origin", "direction", "t_max", "target_distance",
                       "start_policy", "repeat"});
  const std::string schema =
      read_string(fields.required("schema", "the schema is \"graze.question/1\""), "schema");
  if (schema != "graze.question/1")
    throw Malformed{"schema", json_quote_short(schema) + "; it is \"graze.question/1\""};
  Asked asked;
  asked.id = read_string(fields.required("id", "a question has an id"), "id");
  std::vector<std::string_view> names;
  for (const Question question : kQuestions) names.push_back(to_text(question));
  asked.question =
      static_cast<Question>(read_choice(fields.required("query", "what is asked"), "query", names));
  Case& problem = asked.problem;
  problem.id = asked.id;
  const auto take = [&](std::string_view key, Body<double>& body, Spin& spin) {
    MovingBody moving = read_body(fields.required(key, "a body"), fields.path(key));
    body = std::move(moving.body);
    spin = moving.spin;
  };
  take("a", problem.a, problem.spin_a);
  if (asked.question == Question::ray) {
    constexpr std::string_view kForm = "three numbers";
    problem.b.shape = Point<double>{};
    problem.b.position = read_vec3(fields.required("origin", kForm), "origin", kForm);
    problem.b.displacement = read_vec3(fields.required("direction", kForm), "direction", kForm);
  } else {
    take("b", problem.b, problem.spin_b);
  }
  if (const JsonValue* t = fields.optional("t_max")) problem.t_max = read_extended(*t, "t_max");
  if (const JsonValue* m = fields.optional("target_distance"))
    problem.target_distance = read_not_negative(*m, "target_distance");
  if (const JsonValue* policy = fields.optional("start_policy"))
    problem.start_policy = static_cast<StartPolicy>(read_choice(*policy, "start_policy", kStartPolicyNames));
  if (const JsonValue* repeat = fields.optional("repeat")) asked.repeat = read_index(*repeat, "repeat");
  switch (asked.question) {
    case Question::overlap:
      problem.query = Query::overlap;
      break;
    case Question::distance:
      problem.query = Query::distance;
      break;
    case Question::penetration:
      problem.query = Query::penetration;
      break;
    default:
      break;
  }
  return asked;
}

std::string bracket(const engine::Interval& both) {
  return fmt::format(R"({{"lower": {}, "upper": {}}})", corpus::json_number(both.lower),
                     corpus::json_number(both.upper));
}

// graze.answer/1
std::string answer_line(const Asked& asked, const Method& method) {
  std::string out = fmt::format(R"({{"schema": "graze.answer/1", "id": {})", corpus::json_quote(asked.id));
  const Request request =
      asked.question == Question::cast ? Request::everything : Request::normal | Request::witnesses;
  const Answer answer = method.ask(asked.problem, {.request = request});
  if (answer.outcome == Outcome::invalid_input) return out + R"(, "outcome": "unsupported"})";
  out += fmt::format(R"(, "outcome": "{}")", corpus::name_of(answer.outcome));
  const bool casts = is_cast(asked.question);
  if (casts && (answer.outcome == Outcome::hit || answer.outcome == Outcome::not_converged))
    out += R"(, "time": )" + bracket({answer.toi_lower, answer.toi_upper});
  if (answer.separation && answer.outcome == Outcome::miss)
    out += R"(, "distance": )" + bracket(*answer.separation);
  if (answer.depth) out += R"(, "depth": )" + bracket(*answer.depth);
  if (answer.has_normal()) out += R"(, "normal": )" + corpus::write_vec3(answer.normal);
  if (answer.has_points || (casts && answer.outcome == Outcome::hit)) {
    out += R"(, "point_a": )" + corpus::write_vec3(answer.point_a) + R"(, "point_b": )" +
           corpus::write_vec3(answer.point_b);
  }
  if (answer.proof) out += R"(, "proof": )" + corpus::write_proof(*answer.proof);
  if (asked.repeat > 0 && method.time_ns != nullptr) {
    out += fmt::format(R"(, "ns": {}, "native": true)",
                       corpus::json_number(method.time_ns(asked.problem, {.request = engine::kPlain},
                                                          static_cast<int>(asked.repeat))));
  }
  return out + "}";
}

int run_serve_command(const ServeArguments& arguments) {
  std::cout << declaration(arguments) << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    const corpus::ParsedJson parsed = corpus::parse_json(line);
    try {
      if (parsed.error) throw Malformed(*parsed.error);
      const Asked asked = read_question(parsed.value);
      const Method* method = method_for(asked.question, arguments);
      if (method == nullptr) {
        std::cout << fmt::format(R"({{"schema": "graze.answer/1", "id": {}, "outcome": "unsupported"}})",
                                 corpus::json_quote(asked.id))
                  << std::endl;
      } else {
        std::cout << answer_line(asked, *method) << std::endl;
      }
    } catch (const Malformed& bad) {
      throw std::runtime_error(bad.path.empty() ? bad.what : bad.path + ": " + bad.what);
    }
  }
  return 0;
}

}  // namespace

void add_serve_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<ServeArguments>();
  CLI::App* command = app.add_subcommand(
      "serve", "Answers questions as an engine does, by a method of ours: a line in, a line out.");
  command->add_option("--method", arguments->method, "A method by its name (mpr)")->type_name("NAME");
  command->add_option("--scalar", arguments->scalar, "double (the default) or float")->type_name("NAME");
  command->footer(
      "docs/reference/protocol.md is the protocol. Our methods are judged as any engine is:\n\n"
      "  graze certify --engine \"graze serve --method gjk\"\n\n"
      "Exit code: 0 at the end of its input, or 2 for a line that is no question.");
  command->callback([arguments, &exit_code] { exit_code = run_serve_command(*arguments); });
}

}  // namespace graze::tool
