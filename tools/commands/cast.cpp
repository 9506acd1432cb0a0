// graze cast: the answer of a method to each case of the files.
#include <fmt/format.h>

#include <memory>
#include <set>
#include <stdexcept>

#include "corpus/format/names.hpp"
#include "properties/edit/case.hpp"
#include "reports/text/answer_text.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

struct CastSettings {
  std::vector<std::string> files;
  std::string method, scalar = "double", tier = "standard", proofs;
  double tolerance = 0;
  bool json = false, plan = false;
  EngineArguments engines;

  // True if our methods are asked. They are not if third-party engines are given and no method is named.
  [[nodiscard]] bool asks_ours() const { return engines.commands.empty() || !method.empty(); }
};

void check(const CastSettings& settings) {
  if (settings.tier != "standard" && settings.tier != "certified" && settings.tier != "exact") {
    throw std::runtime_error(
        fmt::format("--tier: {} is no tier; it is standard, certified or exact", settings.tier));
  }
  if (settings.tier != "standard" && !settings.method.empty() && settings.method != settings.tier) {
    throw std::runtime_error(fmt::format("--tier: {} has one method, not {}; leave out --method or --tier",
                                         settings.tier, settings.method));
  }
  if (settings.scalar != "double" && settings.scalar != "float") {
    throw std::runtime_error(
        fmt::format("--scalar: {} is no scalar; it is double or float", settings.scalar));
  }
  if (settings.plan && !(settings.method.empty() && settings.proofs.empty())) {
    throw std::runtime_error(
        fmt::format("--plan: nothing is cast, so {} has no meaning beside it; leave one of them out",
                    settings.method.empty() ? "--proof" : "--method"));
  }
  if (settings.plan && !settings.engines.commands.empty())
    throw std::runtime_error("--plan: third-party engines have no plan; leave --engine out");
  if (settings.tier != "standard" && !settings.engines.commands.empty())
    throw std::runtime_error(fmt::format(
        "--tier: applies to our methods only; with --engine name one: --method {}", settings.tier));
}

// Does --method select this one? A name with its scalar ("mpr/float") leaves --scalar aside. Without a name,
// the default is.
bool selected(const CastSettings& settings, const engine::Method& method, const char* by_default) {
  if (settings.method.empty()) return method.scalar == settings.scalar && method.name == by_default;
  if (settings.method == method.full_name()) return true;
  return method.scalar == settings.scalar && (settings.method == "all" || settings.method == method.name);
}

// The methods that a case's query can be answered by.
std::vector<const engine::Method*> methods_for(corpus::Query query) {
  std::vector<const engine::Method*> out;
  for (const engine::Method& method : engine::methods(engine::Kind::query)) {
    if (method.query == query) out.push_back(&method);
  }
  return out;
}

class CastRun {
 public:
  explicit CastRun(const CastSettings& given) : settings_(given) {
    check(given);
    will_read(given.files);
    if (given.tier != "standard") settings_.method = given.tier;
    std::set<std::string> names = {"all"};
    const auto take = [&](const auto& all, auto& chosen, const char* by_default) {
      for (const auto& method : all) {
        names.insert({method.name, method.full_name()});
        if (selected(settings_, method, by_default)) chosen.push_back(&method);
      }
    };
    take(engine::methods(engine::Kind::linear), linear_, "gjk");
    take(engine::methods(engine::Kind::rotating), rotating_, "plan");
    for (const engine::Method& method : engine::methods(engine::Kind::query)) {
      names.insert({method.name, method.full_name()});
    }
    if (!settings_.method.empty() && !names.contains(settings_.method)) {
      throw std::runtime_error(fmt::format("--method: {} is no method; it is one of {}", settings_.method,
                                           fmt::join(names, ", ")));
    }
    // Tier exact answers no cast with a visible rotation. It may answer the cast that the plan makes of other
    // rotations.
    if (given.tier == "exact") {
      rotating_.assign(1, engine::find_method(engine::Kind::rotating, "plan/" + given.scalar));
      ask_.tier = Tier::exact;
    }
    engines_ = std::make_unique<Engines>(given.engines);
    if (!settings_.proofs.empty()) proofs_ = std::make_unique<OutputFile>(settings_.proofs);
    const Request request =
        Request::normal | Request::witnesses | (proofs_ ? Request::proof : Request::verdict);
    ask_.request = request;
    ask_.tolerance = given.tolerance;
  }

  int operator()() {
    const CaseFiles inputs = read_case_files(settings_.files);
    bad_ = inputs.bad;
    for (const CaseFile& file : inputs.files) {
      for (const corpus::Case& problem : file.cases) {
        if (settings_.plan) {
          plan(file.name, problem);
        } else if (!settings_.asks_ours()) {
        } else if (problem.query == corpus::Query::cast) {
          cast(file.name, problem);
        } else {
          ask(file.name, problem);
        }
        ask_engines(file.name, problem);
      }
    }
    if (proofs_) bad_ ? proofs_->close_what_is_written() : proofs_->close();
    for (const std::string& line : engines_->finish()) {
      complain(line);
      ++failed_;
    }
    if (failed_ > 0) complain(fmt::format("{} without an answer, by a fault of the engine", failed_));
    if (not_asked_ > 0)
      complain(fmt::format("{} not asked: the engine does not take them (docs/reference/protocol.md)",
                           not_asked_));
    if (bad_) return 2;
    return failed_ > 0 ? 1 : 0;
  }

 private:
  // Standard output has one document. If proofs go there, the answers go to stderr.
  [[nodiscard]] std::FILE* screen() const { return settings_.proofs == "-" ? stderr : stdout; }
  void refuse(const std::string& file, const corpus::Case& problem, const std::string& why) {
    complain(fmt::format("{}: case {}: {}", file, problem.id, why));
    bad_ = true;
  }
  void show(const std::string& file, const corpus::Case& problem, const engine::Method& method,
            const engine::Answer& answer) {
    fmt::print(screen(), "{}\n",
               settings_.json ? answer_json(problem, method, answer) : answer_block(problem, method, answer));
    if (answer.outcome == Outcome::invalid_input) {
      refuse(file, problem,
             fmt::format("is invalid_input for {}: {}", method.full_name(), invalid_text(answer)));
    }
  }

  // With `--method all`, methods of tier exact are left out for cases that the tier does not take.
  [[nodiscard]] bool is_left_out(Invalid invalid) const {
    return settings_.method == "all" && invalid == Invalid::not_exact;
  }

  // A rotating case needs a rotating method. A linear cast may use either kind, and the linear methods come first.
  void cast(const std::string& file, const corpus::Case& problem) {
    const bool turns = engine::turns(problem);
    if (!turns && !linear_.empty()) {
      for (const engine::Method* method : linear_) cast_by(*method, file, problem);
    } else if (!rotating_.empty()) {
      for (const engine::Method* method : rotating_) cast_by(*method, file, problem);
    } else if (turns) {
      refuse(file, problem,
             fmt::format("has a rotating motion, which --method {} does not cast; {} do", settings_.method,
                         rotating_names()));
    } else {
      refuse(file, problem,
             fmt::format("--method {} does not cast; {} and {} do", settings_.method, linear_names(),
                         rotating_names()));
    }
  }

  void cast_by(const engine::Method& method, const std::string& file, const corpus::Case& problem) {
    const engine::Answer answer = method.ask(problem, ask_);
    if (is_left_out(answer.invalid)) return;
    show(file, problem, method, answer);
    save_proof(method, problem, answer);
  }

  void save_proof(const engine::Method& method, const corpus::Case& problem, const engine::Answer& answer) {
    if (!proofs_ || !(answer.proof || answer.rotating_proof)) return;
    corpus::ProofRecord record;
    record.problem = method.seen(problem);
    record.method = method.name;
    record.scalar = method.scalar;
    record.tier = method.tier == "certified" ? Tier::certified
                  : method.tier == "exact"   ? Tier::exact
                                             : Tier::standard;
    record.outcome = answer.outcome;
    if (answer.outcome != Outcome::miss && answer.outcome != Outcome::invalid_input) {
      record.toi = {answer.toi_lower, answer.toi_upper};
    }
    if (method.kind == engine::Kind::rotating && ask_.tier) record.tier = ask_.tier;
    record.rotating = answer.rotating_proof;
    if (answer.proof) record.proof = *answer.proof;
    proofs_->write_line(corpus::write_proof(record));
  }

  // Asks each third-party engine the questions of this case that it supports. If no method of an engine takes the case,
  // the output says so. For a rotating case only a rotating cast counts.
  void ask_engines(const std::string& file, const corpus::Case& problem) {
    for (const auto& engine : engines_->all()) {
      std::string why = fmt::format("answers no {}", corpus::name_of(problem.query));
      bool is_asked = false;
      for (const engine::Method& method : engine->methods()) {
        if (method.query != problem.query) continue;
        const std::string refused = law::why_invalid(problem).empty()
                                        ? method.refuses(problem)
                                        : "invalid_input: " + law::why_invalid(problem);
        if (!refused.empty()) {
          why = refused;
          continue;
        }
        // A rotating cast also answers linear cases if no linear cast is offered.
        if (is_asked && method.kind == engine::Kind::rotating) continue;
        const engine::Answer answer = method.ask(problem, ask_);
        if (answer.declined) {
          why = answer.message.empty() ? "it says that it does not support the case" : answer.message;
          continue;
        }
        is_asked = true;
        fmt::print(
            screen(), "{}\n",
            settings_.json ? answer_json(problem, method, answer) : answer_block(problem, method, answer));
        if (answer.failure != engine::Failure::none) ++failed_;
        save_proof(method, problem, answer);
      }
      if (is_asked) continue;
      ++not_asked_;
      complain(fmt::format("{}: case {}: is not asked of {}: {}", file, problem.id,
                           engine->declaration().name, why));
    }
  }

  // Prints the plan of the simulation, for the requested tier.
  void plan(const std::string& file, const corpus::Case& problem) {
    if (const std::string why = engine::unsupported(engine::Kind::rotating, problem); !why.empty()) {
      return refuse(file, problem, fmt::format("has {}, which has no plan; give a cast", why));
    }
    const engine::Method& method = *rotating_.front();
    if (const std::string why = law::why_invalid(method.seen(problem)); !why.empty()) {
      return refuse(file, problem, fmt::format("is invalid_input: {}", why));
    }
    const Plan plan = method.plan(problem, ask_);
    fmt::print(screen(), "{}\n", settings_.json ? plan_json(problem, plan) : plan_block(problem, plan));
  }

  void ask(const std::string& file, const corpus::Case& problem) {
    if (const std::string why = engine::unsupported(engine::Kind::query, problem); !why.empty()) {
      return refuse(file, problem, fmt::format("has {}, which this version does not answer", why));
    }
    const std::vector<const engine::Method*> methods = methods_for(problem.query);
    bool answered = false;
    for (const engine::Method* method : methods) {
      // Without --method the first of the query.
      if (settings_.method.empty() ? answered || method->scalar != settings_.scalar
                                   : !selected(settings_, *method, "")) {
        continue;
      }
      answered = true;
      const engine::Answer answer = method->answer(problem, settings_.tolerance);
      if (!is_left_out(answer.invalid)) show(file, problem, *method, answer);
    }
    if (answered) return;
    std::set<std::string> names;
    for (const engine::Method* method : methods) names.insert(method->name);
    refuse(file, problem,
           fmt::format("--method {} does not answer the query {}; {} does", settings_.method,
                       corpus::name_of(problem.query), fmt::join(names, " or ")));
  }

  CastSettings settings_;
  std::vector<const engine::Method*> linear_;
  std::vector<const engine::Method*> rotating_;
  engine::Ask ask_;
  std::unique_ptr<OutputFile> proofs_;
  bool bad_ = false;
  std::unique_ptr<Engines> engines_;
  std::size_t failed_ = 0, not_asked_ = 0;
};

}  // namespace

void add_cast_command(CLI::App& app, int& exit_code) {
  const auto settings = std::make_shared<CastSettings>();
  CLI::App* command =
      app.add_subcommand("cast", "When do the bodies of a case first touch? Answers each case of the files.");
  command
      ->add_option("files", settings->files,
                   "Case files: .json holds one case, .jsonl one a line; - is standard input")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--method", settings->method,
                   "For a linear cast: gjk (GJK ray cast, the default), mpr (MPR sweep), ca (conservative "
                   "advancement), exact (the tier's); for a rotating one and for another query see below; or "
                   "all")
      ->type_name("NAME");
  command
      ->add_option("--scalar", settings->scalar,
                   "double (the default) or float: rounds the case, then casts it")
      ->type_name("NAME");
  command
      ->add_option("--tier", settings->tier,
                   "standard (the default); certified: a proved bracket; or exact: to the last bit. "
                   "The same as --method certified, --method exact")
      ->type_name("NAME");
  command
      ->add_option(
          "--tolerance", settings->tolerance,
          "The search may stop once the bracket is this narrow: a length relative to the scale of the "
          "bodies. With 0 (the default) rounding ends the search. The exact tier and overlap queries need "
          "no tolerance")
      ->check(number_from(0))
      ->type_name("X");
  command->add_flag("--json", settings->json,
                    "One JSON object per line with everything that the text says. Numbers read back to the "
                    "same bits");
  command->add_flag("--plan", settings->plan,
                    "Only say what must be simulated, nothing, static, linear or rotating, and why");
  command
      ->add_option("--proof,--proofs", settings->proofs,
                   "Also write the proofs to this file, for `graze check`")
      ->type_name("OUT.jsonl");
  add_engine_options(*command, settings->engines);
  command->footer(
      "The time runs from 0 to the case's t_max (1 by default). A bracket [lower, upper] holds the time of "
      "impact.\n"
      "Use lower in a simulator: it is never late. The normal points from A to B. point_a and point_b are "
      "the contact\n"
      "on each body at lower, in world coordinates. The exact tier takes all shapes except ellipsoids, "
      "cylinders, cones\n"
      "and hulls of shapes. Its lower and upper are the two doubles next to the time, or both are the "
      "time.\n\n"
      "Methods for a case with rotating bodies:\n"
      "  plan (default)       simulates only the motion that can matter, and names it (--plan says why)\n"
      "  bilateral            bilateral advancement: never passes the first contact\n"
      "  ca                   conservative advancement: the same, slower where the bodies graze\n"
      "  certified            the method of the certified tier: a proved bracket\n"
      "  steps, spheres       overlap at equal steps, and from where bounding spheres meet: either may "
      "miss\n"
      "                       contacts by motions smaller than it says\n"
      "  bilateral_published  as published: may pass a contact between the ends of a step\n\n"
      "A case may ask another query:\n"
      "  overlap            gjk (default), mpr,      do the bodies touch at t = 0?\n"
      "                     exact\n"
      "  distance           gjk                      how far apart are they, closest points\n"
      "  penetration        epa                      how deep, and the shortest way out\n"
      "  penetration_along  mpr                      how deep along the case's direction\n"
      "  line               mpr (default), exact     [t_in, t_out] over all times, negative ones too\n"
      "  swept_overlap      gjk (default), mpr,      do they touch at any t in [0, t_max]? only whether\n"
      "                     before_after, exact\n\n"
      "  graze cast pair.json\n"
      "  graze cast --plan --json cases.jsonl\n"
      "  graze cast cases.jsonl --json --method all --proof proofs.jsonl && graze check proofs.jsonl\n"
      "  graze cast cases.jsonl --engine ./mine --method gjk    another engine's answers "
      "(docs/reference/protocol.md), beside ours\n\n"
      "Exit code: 0. 2 if a file or a case could not be read or answered, or an output could not be "
      "written. The other\n"
      "cases are still answered. 1 if a third-party engine crashed, hung or wrote no valid answer. Cases "
      "that the engine\n"
      "does not support are listed and counted.");
  command->callback([settings, command, &exit_code] {
    require_engine(*command);
    exit_code = CastRun(*settings)();
  });
}

}  // namespace graze::tool
