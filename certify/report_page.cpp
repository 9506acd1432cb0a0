#include "certify/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "certify/report.hpp"
#include "corpus/families.hpp"
#include "corpus/format/names.hpp"
#include "engines/guarantees.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_scene.hpp"
#include "reports/text/statistics.hpp"

namespace graze::tool {
namespace {

using engine::Method;
using show::Json;

Json finite_or_null(double x) {
  if (std::isinf(x) && x > 0) return "inf";
  return std::isfinite(x) ? Json(x) : Json();
}

// The terms of a guarantee in words, with errors in units of the case's scale.
std::string promise_of(const Method& method) {
  const engine::Guarantee* row = method.guarantee;
  if (row == nullptr) return "promises nothing";
  if (row->is_open) return "declares nothing: only failures are faults";
  if (method.is_exact()) return "every bit: the exact time, correctly rounded";
  std::string text;
  if (row->kappa_polytope == 0 && row->kappa_rounded == 0 && method.is_certified()) {
    text = "a proved bracket";
    if (row->width) text += fmt::format(", no wider than {:g} of scale", *row->width);
  } else if (row->kappa_polytope > 0 || row->kappa_rounded > 0) {
    const double u = method.unit_roundoff;
    text = fmt::format("true to {:.1g} of scale", std::max(row->kappa_polytope, row->kappa_rounded) * u);
  }
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (row->relative_tolerance > 0) add(fmt::format("true to {:g} of scale", row->relative_tolerance));
  if (row->tolerance > 0) add(fmt::format("true to {:g}", row->tolerance));
  if (row->may_miss != engine::Unseen::nothing) add("may miss contacts by unseen motion");
  if (row->may_be_late != engine::Unseen::nothing && row->may_miss == engine::Unseen::nothing)
    add("may be late by unseen motion");
  if (row->stall_cap > 0) add(fmt::format("gives up on {:g} % at most", 100 * row->stall_cap));
  return text;
}

class Report {
 public:
  explicit Report(const ReportInput& input) : in_(input) {}

  std::string operator()() {
    for (const Method* method : in_.settings.methods) {
      if (in_.certification.total(*method).cases > 0) methods_.push_back(method);
    }
    const std::string title =
        fmt::format("graze certify: {}",
                    in_.certification.breaches.empty() ? "every guarantee is kept" : "a guarantee is broken");
    Json data = {{"schema", "graze.page/1"},
                 {"kind", "certify"},
                 {"title", title},
                 {"command", in_.command},
                 {"held", in_.certification.breaches.empty()},
                 {"verdict", verdict_line(in_.certification, in_.seconds)},
                 {"seconds", in_.seconds},
                 {"answers", in_.certification.answers},
                 {"cases", in_.certification.questions},
                 {"breaches", in_.certification.breaches},
                 {"unfinished", in_.certification.unfinished}};
    data["methods"] = methods();
    data["cells"] = cells();
    data["families"] = families();
    data["named"] = named();
    data["findings"] = findings();
    data["scenes"] = scenes();
    return show::page_html(title, data, in_.plain);
  }

 private:
  Json faults(const std::array<std::size_t, law::kFaults>& counts) const {
    Json out = Json::object();
    for (std::size_t k = 0; k < law::kFaults; ++k) {
      if (counts[k] > 0) out[law::kFaultKinds[k].name] = counts[k];
    }
    return out;
  }

  Json methods() const {
    Json out = Json::array();
    for (const Method* method : methods_) {
      const Tally total = in_.certification.total(*method);
      Json one = {{"name", method->question_name()},
                  {"kind", engine::to_text(method->kind)},
                  {"query", corpus::name_of(method->query)},
                  {"scalar", method->scalar},
                  {"tier", method->tier},
                  {"ours", method->is_ours()},
                  {"promise", promise_of(*method)},
                  {"held", in_.certification.has_kept(*method)},
                  {"cases", total.cases},
                  {"not_asked", total.skipped},
                  {"faults", faults(total.faults)},
                  {"stalled", total.stalled},
                  {"excused", total.within_tolerance},
                  {"proofs", total.accepted},
                  {"measured", total.by_oracle},
                  {"over_limit", finite_or_null(total.over_limit.value)},
                  {"backward",
                   {{"median", finite_or_null(median(total.backward))},
                    {"worst", finite_or_null(tool::worst(total.backward))}}},
                  {"true_backward", finite_or_null(tool::worst(total.true_backward))},
                  {"least", finite_or_null(total.least_relative.value)},
                  {"least_by", total.least_relative.id},
                  {"open", total.left_open},
                  {"supports", finite_or_null(total.most_supports.value)},
                  {"ns", finite_or_null(median(total.ns))}};
      Json failures = Json::object();
      for (std::size_t k = 1; k < total.failures.size(); ++k) {
        if (total.failures[k].count > 0)
          failures[std::string(engine::to_text(static_cast<engine::Failure>(k)))] = total.failures[k].count;
      }
      one["failures"] = failures;
      out.push_back(std::move(one));
    }
    return out;
  }

  std::size_t place_of(const Method* method) const {
    return static_cast<std::size_t>(std::find(methods_.begin(), methods_.end(), method) - methods_.begin());
  }
  std::size_t place_of(const std::string& family) {
    const auto found = std::find(families_.begin(), families_.end(), family);
    if (found != families_.end()) return static_cast<std::size_t>(found - families_.begin());
    families_.push_back(family);
    return families_.size() - 1;
  }

  // A cell for each method and family that it was asked about, with the notable cases.
  Json cells() {
    Json out = Json::array();
    for (const Tally& tally : in_.certification.tallies) {
      if (tally.cases == 0) continue;
      const WorstCases::Cell* kept = in_.worst.find(*tally.method, tally.family);
      const std::size_t method = place_of(tally.method), family = place_of(tally.family);
      Json one = {{"method", method},
                  {"family", family},
                  {"cases", tally.cases},
                  {"faults", faults(tally.faults)},
                  {"stalled", tally.stalled},
                  {"over_limit", finite_or_null(tally.over_limit.value)},
                  {"backward", finite_or_null(tool::worst(tally.backward))},
                  {"ns", finite_or_null(median(tally.ns))}};
      if (kept != nullptr && kept->worst) {
        one["worst"] = kept->worst->id;
        note(*tally.method, tally.family, "worst", *kept->worst);
      }
      if (kept != nullptr) {
        for (std::size_t k = 0; k < law::kFaults; ++k) {
          if (kept->faults[k]) note(*tally.method, tally.family, law::kFaultKinds[k].name, *kept->faults[k]);
        }
        if (kept->stalled) note(*tally.method, tally.family, "stalled", *kept->stalled);
      }
      out.push_back(std::move(one));
    }
    for (const Method* method : methods_) note_costliest(*method);
    return out;
  }

  // Notes the method's answer that took the most support evaluations.
  void note_costliest(const Method& method) {
    const Tally* most = nullptr;
    for (const Tally& tally : in_.certification.tallies) {
      if (tally.method == &method && tally.most_supports.value > (most ? most->most_supports.value : 0.0))
        most = &tally;
    }
    const WorstCases::Cell* kept = most == nullptr ? nullptr : in_.worst.find(method, most->family);
    if (kept != nullptr && kept->costliest) note(method, most->family, kCostliest, *kept->costliest);
  }

  static constexpr const char* kCostliest = "most supports";

  struct Noted {
    const Method* method;
    std::string family, what;
    const WorstCases::Named* named;
    [[nodiscard]] bool is_fault() const { return what != "worst" && what != "stalled" && what != kCostliest; }
  };
  void note(const Method& method, const std::string& family, const std::string& what,
            const WorstCases::Named& named) {
    noted_.push_back({&method, family, what, &named});
  }

  Json families() const {
    Json out = Json::array();
    for (const std::string& name : families_) {
      const corpus::Family* family = corpus::find_family(name);
      out.push_back({{"name", name},
                     {"sentence", family == nullptr ? "" : family->sentence},
                     {"hardness", family == nullptr ? "" : family->hardness_meaning},
                     {"turns", family != nullptr && family->rotating}});
    }
    return out;
  }

  // Faults first, a method's worst before others' second worst, then by the part of the limit.
  Json named() {
    std::stable_sort(noted_.begin(), noted_.end(), [](const Noted& l, const Noted& r) {
      const auto size = [](const Noted& one) {
        return std::isnan(one.named->over_limit) ? -1.0 : one.named->over_limit;
      };
      if (l.is_fault() != r.is_fault()) return l.is_fault();
      return size(l) > size(r);
    });
    std::set<std::pair<const Method*, std::string>> seen;
    std::stable_partition(noted_.begin(), noted_.end(), [&](const Noted& one) {
      return seen.insert({one.method, one.what}).second;
    });
    Json out = Json::array();
    for (const Noted& one : noted_) {
      out.push_back({{"method", place_of(one.method)},
                     {"family", one.family},
                     {"what", one.what},
                     {"why", one.named->why},
                     {"id", one.named->id},
                     {"over_limit", finite_or_null(one.named->over_limit)}});
    }
    return out;
  }

  Json findings() const {
    Json out = Json::array();
    for (const EngineFinding& finding : in_.findings) {
      out.push_back({{"method", finding.method->question_name()},
                     {"fault", finding.fault},
                     {"reason", finding.reason},
                     {"family", finding.family},
                     {"times", finding.times},
                     {"id", finding.problem.id}});
    }
    return out;
  }

  // The scenes that can be viewed, by id, each with the answers of the methods that it is named for.
  Json scenes() const {
    std::vector<std::string> order;
    std::map<std::string, std::pair<corpus::Case, std::vector<const Method*>>> chosen;
    const auto take = [&](const Method& method, const auto& make, const std::string& id) {
      auto found = chosen.find(id);
      if (found == chosen.end()) {
        if (order.size() >= in_.most_scenes) return;
        found = chosen.emplace(id, std::pair(make(), std::vector<const Method*>{})).first;
        order.push_back(id);
      }
      auto& methods = found->second.second;
      if (std::find(methods.begin(), methods.end(), &method) == methods.end()) methods.push_back(&method);
    };
    for (const EngineFinding& finding : in_.findings)
      take(
          *finding.method, [&] { return finding.problem; }, finding.problem.id);
    for (const Noted& one : noted_)
      take(
          *one.method, [&] { return one.named->place.problem(*one.method); }, one.named->id);
    Json out = Json::object();
    for (const std::string& id : order) {
      const auto& [problem, methods] = chosen.at(id);
      out[id] = show::scene_of(problem, methods,
                               {.command = command_of(problem, methods), .has_still = !show::has_viewer()});
    }
    return out;
  }

  static std::string command_of(const corpus::Case& problem, const std::vector<const Method*>& methods) {
    const std::string generated = show::generating_command(problem);
    std::string text = generated.empty() ? "graze show case.json" : generated + " | graze show -";
    for (const Method* method : methods) {
      if (method->is_ours()) text += fmt::format(" --method '{}'", method->question_name());
    }
    return text + " --out case.html";
  }

  const ReportInput& in_;
  std::vector<const Method*> methods_;
  std::vector<std::string> families_;
  std::vector<Noted> noted_;
};

}  // namespace

std::string report_page(const ReportInput& input) { return Report(input)(); }

}  // namespace graze::tool
