// Selects the methods and cases of `graze certify`.
#include "tools/commands/certify_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "corpus/format/case_json.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {

using engine::Kind;

Selection::Selection(const JudgedArguments& arguments) : engines_(arguments.engines) {
  if (!arguments.guarantees.empty()) read_table(arguments.guarantees);
  if (const std::vector<std::string> names = arguments.our_methods(); !names.empty()) {
    for (const engine::Method* method : select_methods(names)) {
      methods_.push_back(*method);
      if (!arguments.guarantees.empty()) {
        methods_.back().guarantee = engine::find_guarantee(table_, *method);
      }
    }
  }
  for (const engine::Method* method : engines_.methods()) methods_.push_back(*method);
}

std::vector<const engine::Method*> Selection::all() const {
  std::vector<const engine::Method*> out;
  for (const engine::Method& method : methods_) out.push_back(&method);
  return out;
}

bool Selection::has_ours() const {
  return std::any_of(methods_.begin(), methods_.end(),
                     [](const engine::Method& method) { return method.is_ours(); });
}

bool Selection::has(Kind kind) const {
  return std::any_of(methods_.begin(), methods_.end(),
                     [&](const engine::Method& method) { return method.kind == kind; });
}

bool Selection::takes(const corpus::Case& problem) const {
  return std::any_of(methods_.begin(), methods_.end(), [&](const engine::Method& method) {
    return (engine::turns(problem) ? method.kind == Kind::rotating : method.kind != Kind::rotating) &&
           method.refuses(problem).empty();
  });
}

std::string Selection::why_not(const corpus::Case& problem) const {
  for (const engine::Method& method : methods_) {
    if (engine::turns(problem) != (method.kind == Kind::rotating)) continue;
    if (std::string why = method.refuses(problem); !why.empty())
      return fmt::format("{}: {}", method.question_name(), why);
  }
  return fmt::format("no method supports {}",
                     engine::turns(problem) ? "rotating bodies" : "bodies that do not rotate");
}

void Selection::read_table(const std::string& name) {
  will_read({name});
  const corpus::FileText file = corpus::read_whole_file(name);
  if (!file.error.empty()) throw std::runtime_error(name + ": " + file.error);
  try {
    table_ = engine::parse_guarantees(file.text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

namespace {

// "; the first other is ..., and why it is not asked". Searches this number of seeds from the first on, and is empty if
// there is no such case.
std::string first_refused(const corpus::Family& family, std::size_t count, std::uint64_t seed,
                          const Selection& selection) {
  for (std::size_t i = 0; i < count; ++i) {
    const corpus::Case problem = family.generate(family.levels[i % family.levels.size()], seed + i);
    if (!selection.takes(problem))
      return fmt::format("; the first other is {}: {}", problem.id, selection.why_not(problem));
  }
  return {};
}

}  // namespace

bool take_all(Intake& intake, const CertifyArguments& arguments, const Selection& selection) {
  bool bad = false;
  if (arguments.takes_curated()) {
    const corpus::ReadResult curated = corpus::read_directory(arguments.curated_directory());
    for (const corpus::ReadError& error : curated.errors) complain(error.text());
    bad = !curated.ok();
    intake.take("curated", curated.cases, true);
  }
  const CaseFiles files = read_case_files(arguments.files);
  for (const CaseFile& file : files.files) intake.take(file.name, file.cases, false);
  const Counts counts = arguments.counts();
  const std::vector<const corpus::Family*> families =
      wanted_families(arguments.families, !arguments.files.empty());
  if (selection.has_ours()) {
    take_families(intake, families, counts, arguments.seed, arguments.oracle_every);
  } else {
    for (const corpus::Family* family : families) {
      const std::size_t count = family->rotating ? counts.rotating : counts.linear;
      if (count == 0) continue;
      Suite suite = sought_suite(*family, family->levels, count, arguments.seed,
                                 [&](const corpus::Case& problem) { return selection.takes(problem); });
      suite.oracle_every = arguments.oracle_every;
      if (suite.size() == 0) {
        const corpus::Case first = family->generate(family->levels.front(), arguments.seed);
        intake.why.push_back(fmt::format("{}: none of its cases is asked; the first, {}: {}", family->name,
                                         first.id, selection.why_not(first)));
      } else if (suite.size() < count) {
        intake.why.push_back(fmt::format("{}: {} of {} cases {} that an engine takes{}", family->name,
                                         suite.size(), count, suite.size() == 1 ? "is one" : "are ones",
                                         first_refused(*family, count, arguments.seed, selection)));
      }
      intake.suites.push_back(std::move(suite));
    }
  }
  if (selection.has(Kind::query)) take_queries(intake, counts);
  return bad || files.bad;
}

}  // namespace graze::tool
