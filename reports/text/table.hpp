// A table of text: columns as wide as their widest cell, words to the left, numbers to the right.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace graze::tool {

enum class Align { left, right };

struct Column {
  std::string header;  // a newline in it makes a second line of headers
  Align align = Align::right;
};

class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  void add_row(std::vector<std::string> cells);  // as many cells as columns
  void add_gap();                                // an empty line between groups of rows
  [[nodiscard]] std::string text() const;        // ends in a newline

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;  // an empty row is a gap
};

// A short number: 3.2e-16, "0" for an exact 0, "inf", and "-" for NaN, which means absent.
[[nodiscard]] std::string short_number(double x);
// The digits of a count, "-" for 0.
[[nodiscard]] std::string count_text(std::size_t count);

}  // namespace graze::tool
