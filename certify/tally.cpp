#include "certify/tally.hpp"

#include <fmt/format.h>

#include "report/statistics.hpp"
#include "report/table.hpp"

namespace graze::tool {

void Tally::add(const std::string& id, const Judgement& judgement) {
  const auto count = [&](const std::string& fault, std::size_t& counter, Example& first) {
    if (!fault.empty() && counter++ == 0) first = {id, fault};
  };
  if (judgement.not_asked && judgement.wrong.empty()) {
    ++not_asked;
    return;
  }
  ++cases;
  count(judgement.wrong, wrong, first_wrong);
  count(judgement.late, late, first_late);
  count(judgement.off, off, first_off);
  count(judgement.bad_contact, bad_contact, first_bad_contact);
  count(judgement.false_proof, refused, first_refused);
  if (judgement.stalled && stalled++ == 0) first_stalled = {id, ""};
  excused += judgement.excused ? 1 : 0;
  accepted += judgement.proof == ProofState::accepted ? 1 : 0;
  unproved += judgement.proof == ProofState::none ? 1 : 0;
  if (!judgement.by_oracle) return;
  ++by_oracle;
  forward.push_back(judgement.errors.forward);
  backward.push_back(judgement.errors.backward);
  normal.push_back(judgement.errors.normal);
  witness.push_back(judgement.errors.witness);
}

std::vector<std::string> breaches(const Tally& tally, const engine::Guarantee* row) {
  std::vector<std::string> lines;
  if (row == nullptr) return lines;
  const auto line = [&](std::size_t count, const char* what, const Tally::Example& first) {
    if (count == 0) return;
    lines.push_back(fmt::format("{}, {}: {} {} of {}; the first is {}{}{}", row->name(), tally.family, count,
                                what, tally.cases, first.id, first.reason.empty() ? "" : ": ", first.reason));
  };
  line(tally.wrong, "wrong", tally.first_wrong);
  line(tally.late, "late", tally.first_late);
  line(tally.off, "with a bracket off by more than kappa u scale", tally.first_off);
  line(tally.bad_contact, "with a normal or a witness off by more than kappa u scale",
       tally.first_bad_contact);
  line(tally.refused, "with a false proof", tally.first_refused);
  if (static_cast<double>(tally.stalled) > row->stall_cap * static_cast<double>(tally.cases)) {
    line(tally.stalled, fmt::format("not converged, above the cap of {},", row->stall_cap).c_str(),
         tally.first_stalled);
  }
  return lines;
}

std::string tally_table(const std::vector<Tally>& tallies) {
  Table table({{"method", Align::left},
               {"family", Align::left},
               {"cases"},
               {"not\nasked"},
               {"wrong"},
               {"late"},
               {"off"},
               {"contact\noff"},
               {"not con-\nverged"},
               {"excused"},
               {"proofs\naccepted"},
               {"\nrefused"},
               {"\nnone"},
               {"by\noracle"},
               {"forward\nmedian"},
               {"error\nworst"},
               {"backward\nmedian"},
               {"error\nworst"},
               {"true in.\nworst"},
               {"normal\nworst"},
               {"witness\nworst"},
               {"median\nns"}});
  const Tally* last = nullptr;
  for (const Tally& t : tallies) {
    if (last != nullptr && (last->method != t.method || last->scalar != t.scalar)) table.add_gap();
    last = &t;
    const double ns = median(t.ns);
    table.add_row({t.method + "/" + t.scalar,
                   t.family,
                   fmt::to_string(t.cases),
                   t.not_asked > 0 ? fmt::to_string(t.not_asked) : "-",
                   fmt::to_string(t.wrong),
                   fmt::to_string(t.late),
                   fmt::to_string(t.off),
                   fmt::to_string(t.bad_contact),
                   fmt::to_string(t.stalled),
                   fmt::to_string(t.excused),
                   fmt::to_string(t.accepted),
                   fmt::to_string(t.refused),
                   fmt::to_string(t.unproved),
                   fmt::to_string(t.by_oracle),
                   short_number(median(t.forward)),
                   short_number(worst(t.forward)),
                   short_number(median(t.backward)),
                   short_number(worst(t.backward)),
                   short_number(worst(t.true_backward)),
                   short_number(worst(t.normal)),
                   short_number(worst(t.witness)),
                   std::isnan(ns) ? "-" : fmt::format("{:.0f}", ns)});
  }
  return table.text();
}

}  // namespace graze::tool
