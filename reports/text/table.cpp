#include "reports/text/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace graze::tool {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

}  // namespace

void Table::add_row(std::vector<std::string> cells) {
  assert(cells.size() == columns_.size());
  rows_.push_back(std::move(cells));
}

void Table::add_gap() { rows_.emplace_back(); }

std::string Table::text() const {
  std::size_t header_lines = 1;
  std::vector<std::vector<std::string>> headers;
  for (const Column& column : columns_) {
    headers.push_back(lines_of(column.header));
    header_lines = std::max(header_lines, headers.back().size());
  }
  std::vector<std::size_t> widths(columns_.size(), 0);
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    headers[c].insert(headers[c].begin(), header_lines - headers[c].size(), "");  // headers stand on the rows
    for (const std::string& line : headers[c]) widths[c] = std::max(widths[c], line.size());
    for (const auto& row : rows_) {
      if (!row.empty()) widths[c] = std::max(widths[c], row[c].size());
    }
  }
  std::string text;
  const auto add_line = [&](const auto& cell_of) {
    std::string line;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (c > 0) line += "  ";
      line += columns_[c].align == Align::left ? fmt::format("{:<{}}", cell_of(c), widths[c])
                                               : fmt::format("{:>{}}", cell_of(c), widths[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  };
  for (std::size_t l = 0; l < header_lines; ++l) {
    add_line([&](std::size_t c) { return headers[c][l]; });
  }
  add_line([&](std::size_t c) { return std::string(widths[c], '-'); });
  for (const auto& row : rows_) {
    if (row.empty()) {
      text += '\n';
    } else {
      add_line([&](std::size_t c) { return row[c]; });
    }
  }
  return text;
}

std::string short_number(double x) {
  if (std::isnan(x)) return "-";
  if (x == 0) return "0";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return fmt::format("{:.1e}", x);
}

std::string count_text(std::size_t count) { return count > 0 ? fmt::to_string(count) : "-"; }

}  // namespace graze::tool
