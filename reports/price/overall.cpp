#include "reports/price/overall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/price/price_statistics.hpp"

namespace graze::price {

Tables families_of(const Document& document, bool turning) {
  Tables found;
  for (const PriceTable& table : document.tables) {
    if (table.part == Part::family && (table.kind == "rotating") == turning) found.push_back(&table);
  }
  return found;
}

bool is_for_exact(const PriceTable& table) {
  const Row* exact = table.find("exact/double");
  return exact != nullptr && exact->asked == table.cases;
}

std::vector<Overall> overall(const Tables& tables) {
  std::vector<Overall> found;
  if (tables.empty()) return found;
  for (const Row& first : tables.front()->rows) {
    Overall sum{.row = &first};
    std::vector<double> costs;
    for (const PriceTable* table : tables) {
      const Row* row = table->find(first.label);
      if (row == nullptr || row->asked < table->cases || !row->ratio || !row->ours) break;
      costs.push_back(row->ratio->median);
      sum.least = std::fmin(sum.least, row->ratio->median);
      sum.most = std::fmax(sum.most, row->ratio->median);
      sum.wrong += row->wrong;
      sum.late += row->late;
      sum.asked += row->asked;
      sum.open += row->failures.not_converged;
      sum.unsettled += row->failures.no_time + row->failures.refused;
      sum.worst = std::fmax(sum.worst, std::fmax(row->backward.worst, row->denied));
      sum.late_by = std::fmax(sum.late_by, row->late_by);
      sum.denied = std::fmax(sum.denied, row->denied);
    }
    if (costs.size() < tables.size()) continue;
    sum.cost = geometric_mean(costs);
    found.push_back(sum);
  }
  std::sort(found.begin(), found.end(), [](const Overall& l, const Overall& r) { return l.cost < r.cost; });
  return found;
}

std::string times_text(double ratio) {
  return ratio >= 9.995 ? fmt::format("{:.0f}", ratio)
                        : fmt::format("{:.{}f}", ratio, ratio < 0.0995 ? 3 : 2);
}
std::string error_text(double error) { return error == 0 ? "0" : fmt::format("{:.0e}", error); }

}  // namespace graze::price
