// Price lists with planted figures.
#pragma once

#include "reports/price/document.hpp"

namespace graze::price {

// A row in double of tier standard: its time over the baseline's in all rounds within 2 %, its median and
// worst error.
inline Row planted_row(const std::string& method, double tolerance, double ratio, double error) {
  Row row;
  row.label = method + "/double" + (tolerance > 0 ? " 1e-03" : "");
  row.question = "cast";
  row.method = method;
  row.scalar = "double";
  row.tier = method == "certified" || method == "exact" ? method : "standard";
  row.tolerance = tolerance;
  row.request = "verdict";
  row.asked = 10;
  row.time = Times{.median = 1000 * ratio,
                   .mean = 1000 * ratio,
                   .p95 = 2000 * ratio,
                   .p99 = 2000 * ratio,
                   .worst = 2000 * ratio};
  row.ratio = Spread{.median = ratio, .low = 0.98 * ratio, .high = 1.02 * ratio};
  row.backward = {.median = error, .p99 = error, .worst = 2 * error};
  row.forward = row.width = row.backward;
  row.iterations = {.mean = 4, .worst = 9};
  row.supports = {.mean = 8, .worst = 20};
  row.worst_case = row.slowest_case = "price/round/3";
  return row;
}

// gjk is the baseline. ca is dearer, mpr cheaper and coarse, and certified and exact are dearer and right.
inline Document planted_document() {
  PriceTable table{.part = Part::family, .name = "round", .group = "smooth", .kind = "linear"};
  table.title = "Round things";
  table.cases = 10;
  table.truth.exact = 10;
  table.baseline = "gjk/double";
  table.rows = {planted_row("gjk", 0, 1, 1e-15),       planted_row("gjk", 1e-3, 0.5, 1e-5),
                planted_row("ca", 0, 3, 1e-15),        planted_row("mpr", 0, 0.25, 1e-3),
                planted_row("certified", 0, 4, 1e-15), planted_row("exact", 0, 5, 0)};
  for (Row& row : table.rows) {
    if (row.tier != "standard") continue;
    row.late = 2;
    row.late_by = 1e-16;
  }
  // The coarse one gives verdicts away.
  table.rows[3].wrong = 1;
  table.rows[3].denied = 1e-4;
  table.shown.push_back({.id = "price/round/3", .outcome = "hit", .toi = std::pair(0.25, 0.5)});
  Document document{.version = "0", .effort = "quick", .rounds = 5};
  document.machine = {.processor = "made up", .compiler = "none", .build = "none", .cores = 2, .load = 0.5};
  document.tables.push_back(std::move(table));
  return document;
}

}  // namespace graze::price
